// SPDX-License-Identifier: GPL-3.0-or-later
#include "protocol/session/linkfigures.h"

#include "protocol/session/linkadvice.h"

#include <QCoreApplication>

namespace trex {

namespace {

using namespace Qt::Literals::StringLiterals;
using namespace linkfacts;

QString absent()
{
    return u"–"_s;
}

QString words(const char* text)
{
    return QCoreApplication::translate("LinkFigures", text);
}

QString duration(const std::optional<Duration>& value)
{
    return value ? words(QT_TRANSLATE_NOOP("LinkFigures", "%1 ms")).arg(milliseconds(*value))
                 : absent();
}

QString perSecond(const HealthCounts& counts)
{
    const double seconds = std::chrono::duration<double>(counts.covered).count();
    return QString::number(
        seconds > 0.0 ? qRound(static_cast<double>(counts.transactions) / seconds) : 0);
}

template <quint64 HealthCounts::*member>
QString counted(const HealthCounts& counts)
{
    return number(counts.*member);
}

/// Names of the UART error byte's bits, from bit 0 (command documentation, 0x85).
constexpr std::array<const char*, 8> kUartBits{
    QT_TRANSLATE_NOOP("LinkFigures", "send buffer"),
    QT_TRANSLATE_NOOP("LinkFigures", "read buffer"),
    QT_TRANSLATE_NOOP("LinkFigures", "parity"),
    QT_TRANSLATE_NOOP("LinkFigures", "overrun"),
    QT_TRANSLATE_NOOP("LinkFigures", "frame"),
    QT_TRANSLATE_NOOP("LinkFigures", "CRC"),
    QT_TRANSLATE_NOOP("LinkFigures", "format"),
    QT_TRANSLATE_NOOP("LinkFigures", "timeout"),
};

QString uartText(const HealthCounts& counts)
{
    QStringList parts;
    for (std::size_t bit = 0; bit < kUartBits.size(); ++bit) {
        if (counts.uart.at(bit) > 0) {
            parts << u"%1 %2"_s.arg(words(kUartBits.at(bit))).arg(counts.uart.at(bit));
        }
    }
    return parts.isEmpty() ? u"0"_s : parts.join(u", "_s);
}

struct CountRow {
    QLatin1StringView key;
    const char* title; ///< QT_TRANSLATE_NOOP("LinkFigures", …)
    QString (*text)(const HealthCounts&);
    bool isTrouble = false;
};

using Counts = const HealthCounts&;
// clang-format off
constexpr std::array kCounts{
    CountRow{QLatin1StringView("median"), QT_TRANSLATE_NOOP("LinkFigures", "Answer, half within"), [](Counts c) { return duration(c.trips.quantile(0.5)); }},
    CountRow{QLatin1StringView("p99"), QT_TRANSLATE_NOOP("LinkFigures", "Answer, 99 % within"), [](Counts c) { return duration(c.trips.quantile(0.99)); }},
    CountRow{QLatin1StringView("longest"), QT_TRANSLATE_NOOP("LinkFigures", "Answer, longest"), [](Counts c) { return duration(c.trips.total() > 0 ? std::optional(c.trips.longest()) : std::nullopt); }},
    CountRow{QLatin1StringView("wire"), QT_TRANSLATE_NOOP("LinkFigures", "Wire alone, half within"), [](Counts c) { return duration(c.ideal.quantile(0.5)); }},
    CountRow{QLatin1StringView("transactions"), QT_TRANSLATE_NOOP("LinkFigures", "Transactions"), counted<&HealthCounts::transactions>},
    CountRow{QLatin1StringView("rate"), QT_TRANSLATE_NOOP("LinkFigures", "Transactions a second"), perSecond},
    CountRow{QLatin1StringView("retries"), QT_TRANSLATE_NOOP("LinkFigures", "Asked again"), counted<&HealthCounts::retries>, true},
    CountRow{QLatin1StringView("timeouts"), QT_TRANSLATE_NOOP("LinkFigures", "No answer"), counted<&HealthCounts::timeouts>, true},
    CountRow{QLatin1StringView("shortReplies"), QT_TRANSLATE_NOOP("LinkFigures", "Answer broke off"), counted<&HealthCounts::shortReplies>, true},
    CountRow{QLatin1StringView("crcErrors"), QT_TRANSLATE_NOOP("LinkFigures", "CRC wrong"), counted<&HealthCounts::crcErrors>, true},
    CountRow{QLatin1StringView("badReplies"), QT_TRANSLATE_NOOP("LinkFigures", "Implausible answer"), counted<&HealthCounts::badReplies>, true},
    CountRow{QLatin1StringView("lateReplies"), QT_TRANSLATE_NOOP("LinkFigures", "Answer too late"), counted<&HealthCounts::lateReplies>, true},
    CountRow{QLatin1StringView("lateBytes"), QT_TRANSLATE_NOOP("LinkFigures", "Late bytes dropped"), counted<&HealthCounts::lateBytes>, true},
    CountRow{QLatin1StringView("unaskedBytes"), QT_TRANSLATE_NOOP("LinkFigures", "Unasked bytes dropped"), counted<&HealthCounts::unaskedBytes>, true},
    CountRow{QLatin1StringView("resyncs"), QT_TRANSLATE_NOOP("LinkFigures", "Synchronised anew"), counted<&HealthCounts::resyncs>, true},
    CountRow{QLatin1StringView("losses"), QT_TRANSLATE_NOOP("LinkFigures", "Line lost"), counted<&HealthCounts::losses>, true},
    CountRow{QLatin1StringView("uart"), QT_TRANSLATE_NOOP("LinkFigures", "Controller's UART errors"), uartText, true},
};
// clang-format on

QString adapterWords(const AdapterFacts& adapter)
{
    switch (adapter.kind) {
    case AdapterFacts::Kind::Network:
        return words(QT_TRANSLATE_NOOP("LinkFigures", "network; the line is the serial server's"));
    case AdapterFacts::Kind::Simulator:
        return words(QT_TRANSLATE_NOOP("LinkFigures", "simulator in this program"));
    case AdapterFacts::Kind::PseudoTerminal:
        return words(QT_TRANSLATE_NOOP("LinkFigures", "pseudo-terminal"));
    case AdapterFacts::Kind::Unknown:
        return absent();
    case AdapterFacts::Kind::Serial:
        break;
    }
    return adapter.driver.isEmpty() ? adapter.port : u"%1 (%2)"_s.arg(adapter.port, adapter.driver);
}

QString lowLatencyWords(const AdapterFacts& adapter)
{
    const QString timer = adapter.latencyTimerMs
        ? words(QT_TRANSLATE_NOOP("LinkFigures", ", latency timer %1 ms"))
              .arg(*adapter.latencyTimerMs)
        : QString();
    switch (adapter.lowLatency) {
    case AdapterFacts::LowLatency::Granted:
        return words(QT_TRANSLATE_NOOP("LinkFigures", "asked for and granted")) + timer;
    case AdapterFacts::LowLatency::Refused:
        return words(QT_TRANSLATE_NOOP("LinkFigures", "asked for and refused")) + timer;
    case AdapterFacts::LowLatency::Unknown:
        return words(QT_TRANSLATE_NOOP("LinkFigures", "asked for; the driver does not know it"))
            + timer;
    case AdapterFacts::LowLatency::NotAsked:
        break;
    }
    return words(QT_TRANSLATE_NOOP("LinkFigures", "nothing to ask here"));
}

QString detectionWords(const LineSettings& line)
{
    switch (line.errorDetection) {
    case ErrorDetection::Crc7:
        return words(QT_TRANSLATE_NOOP("LinkFigures", "CRC-7"));
    case ErrorDetection::Even:
        return words(QT_TRANSLATE_NOOP("LinkFigures", "even parity"));
    case ErrorDetection::Odd:
        return words(QT_TRANSLATE_NOOP("LinkFigures", "odd parity"));
    case ErrorDetection::None:
        break;
    }
    return words(QT_TRANSLATE_NOOP("LinkFigures", "none"));
}

constexpr std::array<const char*, kPollCount> kPollNames{
    QT_TRANSLATE_NOOP("Polls", "currents"),          QT_TRANSLATE_NOOP("Polls", "channels"),
    QT_TRANSLATE_NOOP("Polls", "remapped channels"), QT_TRANSLATE_NOOP("Polls", "status"),
    QT_TRANSLATE_NOOP("Polls", "UART errors"),       QT_TRANSLATE_NOOP("Polls", "mode"),
    QT_TRANSLATE_NOOP("Polls", "control"),           QT_TRANSLATE_NOOP("Polls", "learned channels"),
};

QString waitWords(const LinkFacts& facts)
{
    const auto own = static_cast<qint64>(facts.line.timeout.count());
    return facts.health.patience <= Duration(0)
        ? words(QT_TRANSLATE_NOOP("LinkFigures", "%1 ms")).arg(own)
        : words(QT_TRANSLATE_NOOP("LinkFigures", "%1 ms, %2 ms longer since answers came late"))
              .arg(own)
              .arg(milliseconds(facts.health.patience));
}

} // namespace

std::vector<CountedFigure> countedFigures(const LinkFacts& facts)
{
    std::vector<CountedFigure> figures;
    for (const CountRow& row : kCounts) {
        const QString recently = row.text(facts.health.recent);
        figures.push_back({row.key, words(row.title), recently, row.text(facts.health.total),
                           row.isTrouble && recently != u"0"_s});
    }
    return figures;
}

std::vector<LineFigure> lineFigures(const LinkFacts& facts)
{
    const HealthCounts& now = facts.health.now;
    const bool isOn = facts.state == LinkState::Connected;
    const auto live = [isOn](const QString& text) { return isOn ? text : absent(); };
    const bool isMeasured = isOn && now.covered > Duration(0); // a second has passed
    const auto measured = [isMeasured](const QString& text) {
        return isMeasured ? text : absent();
    };
    std::vector<LineFigure> figures{
        {"bytes"_L1, words(QT_TRANSLATE_NOOP("LinkFigures", "Bytes a second")),
         measured(QString::number(qRound(now.bytesPerSecond())))},
        {"wireBusy"_L1, words(QT_TRANSLATE_NOOP("LinkFigures", "Wire busy")),
         measured(words(QT_TRANSLATE_NOOP("LinkFigures", "%1 %")).arg(percent(now.wireShare())))},
        {"speed"_L1, words(QT_TRANSLATE_NOOP("LinkFigures", "Speed")),
         words(QT_TRANSLATE_NOOP("LinkFigures", "%1 baud")).arg(facts.line.baud)},
        {"errorDetection"_L1, words(QT_TRANSLATE_NOOP("LinkFigures", "Error detection")),
         detectionWords(facts.line)},
        {"wait"_L1, words(QT_TRANSLATE_NOOP("LinkFigures", "Waits for an answer")),
         waitWords(facts)},
        {"echo"_L1, words(QT_TRANSLATE_NOOP("LinkFigures", "Echo")),
         live(facts.stats.echo ? words(QT_TRANSLATE_NOOP("LinkFigures", "yes, dropped"))
                               : words(QT_TRANSLATE_NOOP("LinkFigures", "no")))},
        {"adapter"_L1, words(QT_TRANSLATE_NOOP("LinkFigures", "Adapter")),
         adapterWords(facts.health.adapter)},
        {"lowLatency"_L1, words(QT_TRANSLATE_NOOP("LinkFigures", "Low latency")),
         lowLatencyWords(facts.health.adapter)},
    };
    for (const PollRow& row : kPolls) {
        const auto i = static_cast<std::size_t>(row.id);
        const double asked = facts.stats.askedHertz.at(i);
        const double got = facts.stats.achievedHertz.at(i);
        if (asked > 0.0) {
            figures.push_back(
                {QLatin1StringView(row.key.data(), static_cast<qsizetype>(row.key.size())),
                 words(QT_TRANSLATE_NOOP("LinkFigures", "Rate of %1")).arg(pollText(row.id)),
                 measured(words(QT_TRANSLATE_NOOP("LinkFigures", "%1 of %2 Hz"))
                              .arg(qRound(got))
                              .arg(qRound(asked))),
                 isMeasured && got < asked * 0.9});
        }
    }
    return figures;
}

QString pollText(PollId poll)
{
    return QCoreApplication::translate("Polls", kPollNames.at(static_cast<std::size_t>(poll)));
}

QString linkReport(const LinkFacts& facts)
{
    QStringList lines;
    for (const LinkAdvice& advice : linkAdvice(facts)) {
        lines << advice.sentence;
        if (!advice.command.isEmpty()) {
            lines << u"    "_s + advice.command;
        }
    }
    lines << QString();
    for (const LineFigure& figure : lineFigures(facts)) {
        lines << u"%1: %2"_s.arg(figure.title, figure.text);
    }
    lines << QString()
          << words(QT_TRANSLATE_NOOP("LinkFigures",
                                     "Of the last minute, and since the counting began (%1 s):"))
                 .arg(std::chrono::duration_cast<std::chrono::seconds>(facts.health.total.covered)
                          .count());
    for (const CountedFigure& figure : countedFigures(facts)) {
        lines << u"%1: %2, %3"_s.arg(figure.title, figure.recent, figure.total);
    }
    return lines.join(u'\n') + u'\n';
}

} // namespace trex
