// SPDX-License-Identifier: GPL-3.0-or-later
// simulate
#include "app/common/lineoptions.h"
#include "app/common/numbers.h"
#include "app/trexctl/replay.h"
#include "app/trexctl/verbs.h"
#include "protocol/sim/simserver.h"

#include <CLI/CLI.hpp>

namespace trex {
namespace {

using sim::SimOptions;
using sim::SimServer;

constexpr int kLargestTcpPort = 65535;
constexpr double kLargestSpeed = 1000.0;

class SimulateVerb;

/// One option with a value, in the order of the help.
struct SimOptionRow {
    const char* name;
    const char* placeholder;
    const char* help; ///< QT_TRANSLATE_NOOP("Cli", …)
    bool mayRepeat;
    Result<void> (*apply)(SimulateVerb&, const QString&);
};

template <class T, class Take>
Result<void> taken(const Result<T>& result, Take take)
{
    return result.map([&take](const T& value) { take(value); });
}

class SimulateVerb : public Verb {
public:
    void declare(CLI::App& app) override;
    Checked check(const OpenOptions& options) override;
    [[nodiscard]] Line line() const override { return Line::None; }
    [[nodiscard]] bool usesPort() const override { return false; }

    Task run(Session& session) override
    {
        m_server = std::make_unique<SimServer>(m_options);
        QObject::connect(m_server.get(), &SimServer::ready, &session,
                         [&session](const QString& address) {
                             session.output().text(QStringLiteral("ready ") + address);
                         });
        QObject::connect(m_server.get(), &SimServer::problem, &session,
                         [&session](const Error& error) { session.tell(toFailure(error).text); });
        if (const auto listening = listen(); !listening) {
            m_server.reset();
            session.fail(listening.error());
        } else if (m_server->servesOthers()) {
            session.tell(Cli::tr("Listening on %1: whoever reaches this computer can drive this "
                                 "simulated controller. --tcp PORT alone serves this computer "
                                 "only.")
                             .arg(m_tcpAddress));
        }
        co_return; // serves until a signal
    }

    void interrupted(Session& session) override
    {
        m_server.reset(); // removes the link, writes the state
        session.end(exitcode::kDone);
    }

    void powerCycle() override
    {
        if (m_server) {
            m_server->powerCycle();
        }
    }

    SimOptions& options() { return m_options; }
    void setPty(const QString& link) { m_pty = link; }
    /// "PORT", or "ADDRESS:PORT" with a number as address ("[::]:PORT").
    Result<void> setTcp(const QString& text)
    {
        const qsizetype colon = text.lastIndexOf(QLatin1Char(':'));
        QString address = text.left(std::max<qsizetype>(colon, 0));
        if (address.startsWith(QLatin1Char('[')) && address.endsWith(QLatin1Char(']'))) {
            address = address.mid(1, address.size() - 2);
        }
        if (colon >= 0 && !SimServer::isAddress(address)) {
            return trex::fail(
                ErrorCode::OutOfRange,
                Cli::tr("--tcp %1 (PORT, or ADDRESS:PORT such as 0.0.0.0:4000)").arg(text));
        }
        return taken(numberInRange("--tcp", text.mid(colon + 1), 0, kLargestTcpPort),
                     [&](int port) {
                         m_tcpAddress = address;
                         m_tcpPort = port;
                     });
    }
    void setLogFile(const QString& path) { m_logFile = path; }
    void addDevice(int number)
    {
        if (!std::exchange(m_hasOwnDevices, true)) {
            m_options.devices.clear();
        }
        m_options.devices.push_back(number);
    }

private:
    Result<void> listen()
    {
        if (m_server->stateError()) {
            return tl::make_unexpected(*m_server->stateError());
        }
        const auto log = m_logFile ? m_server->setLogFile(*m_logFile) : Result<void>();
        return log
            .and_then([this] {
                const bool isWanted = m_pty || !m_tcpPort; // something has to be opened
                return isWanted ? m_server->listenPty(m_pty.value_or(QString())) : Result<void>();
            })
            .and_then([this] {
                return m_tcpPort
                    ? m_server->listenTcp(static_cast<quint16>(*m_tcpPort), m_tcpAddress)
                    : Result<void>();
            });
    }

    SimOptions m_options;
    std::vector<std::pair<const SimOptionRow*, QString>> m_given;
    bool m_hasOwnDevices = false;
    std::optional<QString> m_pty;
    std::optional<int> m_tcpPort;
    QString m_tcpAddress; ///< empty: this computer only
    std::optional<QString> m_logFile;
    std::unique_ptr<SimServer> m_server;
};

/// One line option, as the global ones are read.
Result<void> applyLine(SimulateVerb& verb, std::optional<QString> LineOptionValues::*option,
                       const QString& text, void (*take)(SimOptions&, const LineSettings&))
{
    LineOptionValues values;
    values.*option = text;
    return taken(toLineSettings(values),
                 [&](const LineSettings& line) { take(verb.options(), line); });
}

// clang-format off
constexpr auto kOptions = std::to_array<SimOptionRow>({
    {"--pty", "LINK", QT_TRANSLATE_NOOP("Cli", "serve on a pseudo-terminal with this link to it (the default, without a link)"), false,
     [](SimulateVerb& v, const QString& t) { v.setPty(t); return Result<void>(); }},
    {"--tcp", "PORT", QT_TRANSLATE_NOOP("Cli", "serve on 127.0.0.1:PORT; 0 takes a free one; ADDRESS:PORT: for other computers, too"), false,
     [](SimulateVerb& v, const QString& t) { return v.setTcp(t); }},
    {"--model", "NAME", QT_TRANSLATE_NOOP("Cli", "jr (default) or trex"), false,
     [](SimulateVerb& v, const QString& t) { return v.options().applyModel(t); }},
    {"--firmware", "X.Y", QT_TRANSLATE_NOOP("Cli", "1.0 to 1.3, default 1.2"), false,
     [](SimulateVerb& v, const QString& t) { return v.options().applyFirmware(t); }},
    {"--mode", "NAME", QT_TRANSLATE_NOOP("Cli", "mode jumper: rc, analog or serial (default)"), false,
     [](SimulateVerb& v, const QString& t) { return v.options().applyMode(t); }},
    {"--baud", "N", QT_TRANSLATE_NOOP("Cli", "as stored in the controller, default 19200"), false,
     [](SimulateVerb& v, const QString& t) { return applyLine(v, &LineOptionValues::baud, t, [](SimOptions& o, const LineSettings& l) { o.baud = l.baud; }); }},
    {"--error-detection", "KIND", QT_TRANSLATE_NOOP("Cli", "none (default), even, odd or crc7"), false,
     [](SimulateVerb& v, const QString& t) { return applyLine(v, &LineOptionValues::errorDetection, t, [](SimOptions& o, const LineSettings& l) { o.errorDetection = l.errorDetection; }); }},
    {"--crc-polynomial", "N", QT_TRANSLATE_NOOP("Cli", "8 bits, top bit set; default 0x89"), false,
     [](SimulateVerb& v, const QString& t) { return applyLine(v, &LineOptionValues::polynomial, t, [](SimOptions& o, const LineSettings& l) { o.polynomial = l.polynomial; }); }},
    {"--stop-bits", "N", QT_TRANSLATE_NOOP("Cli", "1 (default) or 2"), false,
     [](SimulateVerb& v, const QString& t) { return applyLine(v, &LineOptionValues::stopBits, t, [](SimOptions& o, const LineSettings& l) { o.stopBits = l.stopBits; }); }},
    {"--device", "N", QT_TRANSLATE_NOOP("Cli", "device number, default 7; several are several controllers on one line"), true,
     [](SimulateVerb& v, const QString& t) { return taken(numberInRange("--device", t, 0, 127), [&](int n) { v.addDevice(n); }); }},
    {"--state", "FILE", QT_TRANSLATE_NOOP("Cli", "keeps the EEPROM; starting again with it is a power cycle"), false,
     [](SimulateVerb& v, const QString& t) { v.options().stateFile = t; return Result<void>(); }},
    {"--seed", "N", QT_TRANSLATE_NOOP("Cli", "of faults, jitter and noise; default 1"), false,
     [](SimulateVerb& v, const QString& t) { return taken(numberInRange("--seed", t, 0, std::numeric_limits<int>::max()), [&](int n) { v.options().seed = static_cast<quint64>(n); }); }},
    {"--param", "KEY=VALUE", QT_TRANSLATE_NOOP("Cli", "a parameter of a fresh EEPROM, raw"), true,
     [](SimulateVerb& v, const QString& t) { return v.options().applyParameter(t); }},
    {"--quirk", "NAME=VALUE", QT_TRANSLATE_NOOP("Cli", "calibration-bytes=8, null-command=error, unknown-parameter=ff, serial-timeout=off, safe-start=on, motor-reply=ff, invalid-after=150"), true,
     [](SimulateVerb& v, const QString& t) { return v.options().applyQuirk(t); }},
    {"--fault", "NAME=VALUE", QT_TRANSLATE_NOOP("Cli", "drop, corrupt, duplicate (chance a byte), delay (ms), garbage (bytes), silent-after, silent-for, hangup-after, hangup-for, reset-after (s); drop-sent, corrupt-sent, repeat-sent (chance a byte of the host), unplugged (controllers)"), true,
     [](SimulateVerb& v, const QString& t) { return v.options().applyFault(t); }},
    {"--scenario", "FILE", QT_TRANSLATE_NOOP("Cli", "channel signals and events (JSON)"), false,
     [](SimulateVerb& v, const QString& t) { return v.options().loadScenario(t); }},
    {"--replay", "FILE", QT_TRANSLATE_NOOP("Cli", "a recording's channels, currents and parameters, from its beginning"), false,
     [](SimulateVerb& v, const QString& t) { return replayRecording(t, v.options()); }},
    {"--speed", "X", QT_TRANSLATE_NOOP("Cli", "virtual seconds a real second, default 1"), false,
     [](SimulateVerb& v, const QString& t) { return taken(positiveNumber("--speed", t, kLargestSpeed), [&](double x) { v.options().speed = x; }); }},
    {"--log", "FILE", QT_TRANSLATE_NOOP("Cli", "packets heard and motor outputs, as JSON Lines"), false,
     [](SimulateVerb& v, const QString& t) { v.setLogFile(t); return Result<void>(); }},
});
// clang-format on

void SimulateVerb::declare(CLI::App& app)
{
    for (const auto& row : kOptions) {
        auto* const option = app.add_option_function<std::vector<std::string>>(
            row.name,
            [this, &row](const std::vector<std::string>& texts) {
                for (const std::string& text : texts) {
                    m_given.emplace_back(&row, QString::fromStdString(text));
                }
            },
            Cli::tr(row.help).toStdString());
        option->type_name(row.placeholder)->allow_extra_args(false);
        if (!row.mayRepeat) {
            option->expected(1);
        }
    }
    const auto addFlag = [&app](const char* name, bool& target, const QString& help) {
        app.add_flag(name, target, help.toStdString());
    };
    addFlag("--pace", m_options.pace, Cli::tr("bytes take their time on the wire"));
    addFlag("--echo", m_options.echo, Cli::tr("RS-232 wiring: the host hears itself"));
    addFlag("--mix", m_options.mix, Cli::tr("mix jumper"));
}

Checked SimulateVerb::check(const OpenOptions& global)
{
    // Line options before the command hold for the simulator, too, unless it has its own.
    m_options.baud = global.line.baud;
    m_options.errorDetection = global.line.errorDetection;
    m_options.polynomial = global.line.polynomial;
    m_options.stopBits = global.line.stopBits;
    m_options.devices = {global.line.device};
    for (const auto& [row, text] : m_given) {
        if (const auto applied = row->apply(*this, text); !applied) {
            return checked(applied);
        }
    }
    return checked(m_options.validate());
}

} // namespace

std::unique_ptr<Verb> makeSimulate()
{
    return std::make_unique<SimulateVerb>();
}

} // namespace trex
