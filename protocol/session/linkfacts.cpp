// SPDX-License-Identifier: GPL-3.0-or-later
#include "protocol/session/linkfacts.h"

#include <QCoreApplication>

namespace trex {

using namespace Qt::Literals::StringLiterals;

QString adapterText(const AdapterFacts& adapter)
{
    const auto text = [](const char* words) {
        return QCoreApplication::translate("LinkAdvice", words);
    };
    const QString driver = adapter.driver.isEmpty()
        ? text(QT_TRANSLATE_NOOP("LinkAdvice", "its driver"))
        : adapter.driver;
    QString sentence;
    switch (adapter.lowLatency) {
    case AdapterFacts::LowLatency::NotAsked:
        return {};
    case AdapterFacts::LowLatency::Granted:
        sentence = text(QT_TRANSLATE_NOOP(
            "LinkAdvice",
            "The adapter was asked to hand bytes on at once (low latency); %1 does so."));
        break;
    case AdapterFacts::LowLatency::Refused:
        sentence = text(QT_TRANSLATE_NOOP(
            "LinkAdvice",
            "The adapter was asked to hand bytes on at once (low latency); %1 did not permit it."));
        break;
    case AdapterFacts::LowLatency::Unknown:
        sentence = text(QT_TRANSLATE_NOOP("LinkAdvice",
                                          "The adapter was asked to hand bytes on at once (low "
                                          "latency); %1 does not know of it."));
        break;
    }
    sentence = sentence.arg(driver);
    if (adapter.latencyTimerMs) {
        sentence += u' '
            + text(QT_TRANSLATE_NOOP("LinkAdvice", "Its latency timer stands at %1 ms."))
                  .arg(*adapter.latencyTimerMs);
    }
    return sentence;
}

namespace linkfacts {

const HealthCounts& recent(const LinkFacts& f)
{
    return f.health.recent;
}

QString number(quint64 count)
{
    return QString::number(count);
}

QString percent(double share)
{
    const double hundred = share * 100.0;
    return QString::number(hundred, 'f', hundred < 10.0 ? 1 : 0);
}

QString milliseconds(Duration duration)
{
    const double ms = std::chrono::duration<double, std::milli>(duration).count();
    return QString::number(ms, 'f', ms < 100.0 ? 1 : 0);
}

Duration medianOf(const LatencyHistogram& histogram)
{
    return histogram.quantile(0.5).value_or(Duration(0));
}

double shareOf(quint64 count, const LinkFacts& f)
{
    const auto due = static_cast<double>(recent(f).answersDue());
    return due > 0.0 ? static_cast<double>(count) / due : 0.0;
}

quint64 uartCount(const LinkFacts& f, std::uint8_t mask)
{
    quint64 sum = 0;
    for (std::size_t bit = 0; bit < recent(f).uart.size(); ++bit) {
        sum += (mask >> bit & 1U) != 0 ? recent(f).uart.at(bit) : 0;
    }
    return sum;
}

bool isDamaged(const LinkFacts& f)
{
    const quint64 damaged = recent(f).damaged();
    return damaged >= kFewest && shareOf(damaged, f) >= kDamagedShare;
}

QStringList damagedWords(const LinkFacts& f)
{
    const quint64 damaged = recent(f).damaged();
    return {number(damaged), number(recent(f).answersDue()), percent(shareOf(damaged, f))};
}

bool hasSlowTimer(const LinkFacts& f)
{
    return f.health.adapter.latencyTimerMs.value_or(0) > 1;
}

bool isTooSlow(const LinkFacts& f)
{
    const bool isMeasured = f.health.now.covered > Duration(0);
    return isMeasured && f.stats.pollScale < kAskedShare;
}

QStringList answerWords(const LinkFacts& f)
{
    return {milliseconds(medianOf(recent(f).trips)), milliseconds(medianOf(recent(f).ideal)),
            milliseconds(medianOf(recent(f).extra))};
}

std::optional<int> sufficientBaud(const LinkFacts& f)
{
    const double wire = f.health.now.wireShare();
    if (wire < kBusy || f.line.baud >= kBaudRates.back()) {
        return std::nullopt;
    }
    const double load = 1.0 / std::max(f.stats.pollScale, 0.001);
    for (const int baud : kBaudRates) {
        const double faster = static_cast<double>(f.line.baud) / baud;
        if (baud > f.line.baud && load * (wire * faster + 1.0 - wire) <= 1.0) {
            return baud;
        }
    }
    return kBaudRates.back();
}

} // namespace linkfacts
} // namespace trex
