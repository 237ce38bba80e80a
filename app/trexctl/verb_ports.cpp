// SPDX-License-Identifier: GPL-3.0-or-later
// ports, scan
#include "app/trexctl/controllertext.h"
#include "app/trexctl/verbs.h"
#include "protocol/procedures/linetext.h"
#include "protocol/procedures/scan.h"
#include "protocol/storage/linesettingsstore.h"
#include "protocol/transport/transportregistry.h"

#include <CLI/CLI.hpp>

using namespace Qt::Literals::StringLiterals;

namespace trex {
namespace {

class PortsVerb : public Verb {
public:
    [[nodiscard]] Line line() const override { return Line::None; }
    [[nodiscard]] bool usesPort() const override { return false; }

    Task run(Session& session) override
    {
        QJsonArray array;
        TextTable table({Cli::tr("Port"), Cli::tr("Description"), Cli::tr("Manufacturer"),
                         Cli::tr("Serial number"), Cli::tr("USB")});
        const auto ports = availablePorts();
        for (const PortInfo& port : ports) {
            array.append(QJsonObject{{u"port"_s, port.port},
                                     {u"description"_s, port.description},
                                     {u"manufacturer"_s, port.manufacturer},
                                     {u"serialNumber"_s, port.serialNumber},
                                     {u"vid"_s, port.vendorId},
                                     {u"pid"_s, port.productId}});
            const bool isUsb = port.vendorId != 0;
            table.add({port.port, port.description, port.manufacturer, port.serialNumber,
                       isUsb ? u"%1:%2"_s.arg(port.vendorId, 4, 16, QLatin1Char('0'))
                                   .arg(port.productId, 4, 16, QLatin1Char('0'))
                             : u"–"_s});
        }
        if (session.output().isJson() || !ports.isEmpty()) {
            session.output().answer(array, table.text());
        } else {
            session.warn(Cli::tr("There is no serial port. Plug in the adapter, or use --port sim: "
                                 "for the built-in simulator."));
        }
        session.end();
        co_return;
    }
};

class ScanVerb : public Verb {
public:
    void declare(CLI::App& app) override
    {
        app.add_flag(
            "--all", m_isAll,
            Cli::tr("go on after the first, and ask all 128 device numbers").toStdString());
    }

    [[nodiscard]] Line line() const override { return Line::None; } // a connection of its own

    Task run(Session& session) override
    {
        const OpenOptions& options = session.options();
        ScanOptions how{options.port, options.line, m_isAll};
        SettingsFile file;
        if (const auto line = LineSettingsStore(file).lastGood(options.port)) {
            how.remembered.push_back(*line);
        }
        m_scan = std::make_unique<Scan>(how);
        const Result<void> result = co_await session.attempt<void>(
            [this, &session](const Awaiting<void>::Handler& handler) {
                QObject::connect(m_scan.get(), &Scan::finished, &session, handler);
                m_scan->start();
            });
        if (m_isAll && result) { // for the advice on a new device number
            std::set<int> numbers;
            for (const ScanHit& hit : m_scan->hits()) {
                numbers.insert(hit.device);
            }
            LineSettingsStore(file).rememberNumbers(options.port, numbers);
        }
        const bool isWhole = m_isAll || m_scan->hits().empty(); // else it ended at the first
        if (const QString text = leftOutText(m_scan->leftOut()); isWhole && !text.isEmpty()) {
            session.tell(text); // now: warnings are not printed beside an error
        }
        if (m_scan->hits().empty()) {
            const Error error = result ? Error{ErrorCode::NoReply, options.port} : result.error();
            if (exitCodeOf(error.code) == exitcode::kNoReply && session.output().isJson()) {
                session.output().json(QJsonArray());
            }
            session.fail(error);
            co_return;
        }
        print(session.output());
        session.end();
    }

    void interrupted(Session& session) override
    {
        if (m_scan) {
            m_scan->disconnect(&session);
            m_scan->cancel();
        }
        Verb::interrupted(session);
    }

private:
    void print(Output& output) const
    {
        QJsonArray array;
        TextTable table({Cli::tr("Baud"), Cli::tr("Error detection"), Cli::tr("Stop bits"),
                         Cli::tr("Device"), Cli::tr("Controller"), Cli::tr("Echo")});
        for (const ScanHit& hit : m_scan->hits()) {
            const QString detection = latin(keyOf(hit.errorDetection));
            QJsonObject entry{{u"baud"_s, hit.baud},
                              {u"errorDetection"_s, detection},
                              {u"stopBits"_s, hit.stopBits},
                              {u"device"_s, hit.device},
                              {u"signature"_s, hit.signature.text()},
                              {u"echo"_s, hit.echo}};
            if (hit.errorDetection == ErrorDetection::Crc7) {
                entry.insert(u"crcPolynomial"_s, hit.polynomial);
            }
            array.append(entry);
            table.add({QString::number(hit.baud), detection, QString::number(hit.stopBits),
                       QString::number(hit.device), hit.signature.text(), yesNo(hit.echo)});
        }
        output.answer(array, table.text());
    }

    bool m_isAll = false;
    std::unique_ptr<Scan> m_scan;
};

} // namespace

std::unique_ptr<Verb> makePorts()
{
    return std::make_unique<PortsVerb>();
}

std::unique_ptr<Verb> makeScan()
{
    return std::make_unique<ScanVerb>();
}

} // namespace trex
