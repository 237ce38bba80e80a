// SPDX-License-Identifier: GPL-3.0-or-later
// health
#include "app/common/numbers.h"
#include "app/trexctl/controllertext.h"
#include "app/trexctl/verbs.h"
#include "protocol/session/linkadvice.h"
#include "protocol/session/linkfigures.h"

#include <CLI/CLI.hpp>

using namespace Qt::Literals::StringLiterals;

namespace trex {
namespace {

constexpr double kUsualSeconds = 5.0;
constexpr double kLongestSeconds = 3600.0;

/// What the panels ask for, but for the status byte: its latched bits stay for whoever wants them.
/// The UART error byte has to be read, and is cleared by that (command documentation, 0x85).
constexpr std::array kAsked{PollId::Currents,   PollId::RawChannels,   PollId::RemappedChannels,
                            PollId::UartErrors, PollId::SerialControl, PollId::Mode};

QJsonValue milliseconds(const std::optional<Duration>& duration)
{
    return duration
        ? QJsonValue(rounded(std::chrono::duration<double, std::milli>(*duration).count(), 3))
        : QJsonValue();
}

QJsonObject latencyJson(const HealthCounts& counts)
{
    const bool isAny = counts.trips.total() > 0;
    return {
        {u"median"_s, milliseconds(counts.trips.quantile(0.5))},
        {u"p99"_s, milliseconds(counts.trips.quantile(0.99))},
        {u"longest"_s, milliseconds(isAny ? std::optional(counts.trips.longest()) : std::nullopt)},
        {u"wireMedian"_s, milliseconds(counts.ideal.quantile(0.5))},
        {u"extraMedian"_s, milliseconds(counts.extra.quantile(0.5))}};
}

QJsonArray histogramJson(const HealthCounts& counts)
{
    QJsonArray bins;
    for (int bin = 0; bin < LatencyHistogram::kBins; ++bin) {
        if (counts.trips.count(bin) + counts.ideal.count(bin) > 0) {
            bins.append(QJsonObject{{u"fromMs"_s, milliseconds(LatencyHistogram::edge(bin))},
                                    {u"toMs"_s, milliseconds(LatencyHistogram::edge(bin + 1))},
                                    {u"answers"_s, static_cast<qint64>(counts.trips.count(bin))},
                                    {u"wire"_s, static_cast<qint64>(counts.ideal.count(bin))}});
        }
    }
    return bins;
}

QJsonObject countsJson(const HealthCounts& counts)
{
    const auto number = [](quint64 count) { return static_cast<qint64>(count); };
    constexpr std::array<const char*, 8> kBits{"sendBufferOverrun",
                                               "readBufferOverrun",
                                               "parity",
                                               "overrun",
                                               "frame",
                                               "crc",
                                               "format",
                                               "timeout"};
    QJsonObject uart;
    for (std::size_t bit = 0; bit < kBits.size(); ++bit) {
        uart.insert(QLatin1StringView(kBits.at(bit)), static_cast<qint64>(counts.uart.at(bit)));
    }
    return {{u"seconds"_s, rounded(std::chrono::duration<double>(counts.covered).count(), 3)},
            {u"transactions"_s, number(counts.transactions)},
            {u"answers"_s, number(counts.replies)},
            {u"retries"_s, number(counts.retries)},
            {u"timeouts"_s, number(counts.timeouts)},
            {u"shortReplies"_s, number(counts.shortReplies)},
            {u"crcErrors"_s, number(counts.crcErrors)},
            {u"badReplies"_s, number(counts.badReplies)},
            {u"lateReplies"_s, number(counts.lateReplies)},
            {u"lateBytes"_s, number(counts.lateBytes)},
            {u"unaskedBytes"_s, number(counts.unaskedBytes)},
            {u"resyncs"_s, number(counts.resyncs)},
            {u"losses"_s, number(counts.losses)},
            {u"uartErrors"_s, uart}};
}

QJsonObject adapterJson(const AdapterFacts& adapter)
{
    constexpr std::array<const char*, 5> kKinds{"unknown", "serial", "pty", "network", "simulator"};
    constexpr std::array<const char*, 4> kLowLatency{"notAsked", "granted", "refused", "unknown"};
    return {{u"kind"_s, QLatin1StringView(kKinds.at(static_cast<std::size_t>(adapter.kind)))},
            {u"driver"_s, adapter.driver},
            {u"lowLatency"_s,
             QLatin1StringView(kLowLatency.at(static_cast<std::size_t>(adapter.lowLatency)))},
            {u"latencyTimerMs"_s,
             adapter.latencyTimerMs ? QJsonValue(*adapter.latencyTimerMs) : QJsonValue()}};
}

QJsonArray ratesJson(const LinkStats& stats)
{
    QJsonArray rates;
    for (const PollRow& row : kPolls) {
        const auto i = static_cast<std::size_t>(row.id);
        if (stats.askedHertz.at(i) > 0.0) {
            rates.append(QJsonObject{{u"stream"_s, latin(row.key)},
                                     {u"askedHz"_s, rounded(stats.askedHertz.at(i), 1)},
                                     {u"gotHz"_s, rounded(stats.achievedHertz.at(i), 1)}});
        }
    }
    return rates;
}

QJsonArray adviceJson(const LinkFacts& facts)
{
    constexpr std::array<const char*, 5> kSeverities{"none", "ok", "note", "warning", "fault"};
    QJsonArray advice;
    for (const LinkAdvice& one : linkAdvice(facts)) {
        QJsonObject object{
            {u"key"_s, QString(keyOf(one.kind))},
            {u"severity"_s, QLatin1StringView(kSeverities.at(static_cast<std::size_t>(one.look)))},
            {u"inferred"_s, one.isGuess},
            {u"text"_s, one.sentence}};
        if (!one.command.isEmpty()) {
            object.insert(u"command"_s, one.command);
        }
        advice.append(object);
    }
    return advice;
}

class HealthVerb : public Verb {
public:
    void declare(CLI::App& app) override
    {
        app.add_option_function<std::string>(
               "--duration",
               [this](const std::string& text) { m_durationText = QString::fromStdString(text); },
               Cli::tr("seconds to look at the line, default 5").toStdString())
            ->type_name("S");
    }

    Checked check(const OpenOptions&) override
    {
        if (m_durationText.isNull()) {
            return {};
        }
        const auto duration = positiveNumber("--duration", m_durationText, kLongestSeconds);
        if (duration) {
            m_seconds = *duration;
        }
        return checked(duration);
    }

    [[nodiscard]] bool ridesOverLoss() const override { return true; }

    Task run(Session& session) override
    {
        Controller& controller = session.controller();
        for (const PollId poll : kAsked) {
            controller.want(&session, poll, pollRow(poll).hertz);
        }
        controller.resetHealth(); // looking for the controller is not part of it
        co_await session.sleepUntil(
            std::chrono::steady_clock::now()
            + std::chrono::duration_cast<Duration>(std::chrono::duration<double>(m_seconds)));
        const LinkFacts facts{controller.state(), session.options().line, controller.stats(),
                              controller.health()};
        if (facts.state != LinkState::Connected) {
            session.fail(controller.lastError().value_or(Error{ErrorCode::NoReply, {}}));
            co_return;
        }
        session.output().answer(json(facts), linkReport(facts).trimmed());
        session.end();
    }

private:
    static QJsonObject json(const LinkFacts& facts)
    {
        const HealthCounts& total = facts.health.total;
        QJsonObject object = countsJson(total);
        const QJsonObject more{
            {u"transactionsPerSecond"_s, rounded(facts.stats.transactionsPerSecond, 1)},
            {u"bytesPerSecond"_s, rounded(total.bytesPerSecond(), 1)},
            {u"wireShare"_s, rounded(total.wireShare(), 4)},
            {u"latencyMs"_s, latencyJson(total)},
            {u"histogram"_s, histogramJson(total)},
            {u"rates"_s, ratesJson(facts.stats)},
            {u"baud"_s, facts.line.baud},
            {u"errorDetection"_s, latin(keyOf(facts.line.errorDetection))},
            {u"echo"_s, facts.stats.echo},
            {u"adapter"_s, adapterJson(facts.health.adapter)},
            {u"advice"_s, adviceJson(facts)}};
        for (auto field = more.begin(); field != more.end(); ++field) {
            object.insert(field.key(), field.value());
        }
        return object;
    }

    QString m_durationText;
    double m_seconds = kUsualSeconds;
};

} // namespace

std::unique_ptr<Verb> makeHealth()
{
    return std::make_unique<HealthVerb>();
}

} // namespace trex
