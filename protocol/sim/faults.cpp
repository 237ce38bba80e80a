// SPDX-License-Identifier: GPL-3.0-or-later
#include "protocol/sim/faults.h"

#include <QStringList>

#include <array>

namespace trex::sim {

using namespace Qt::Literals::StringLiterals;

namespace {

constexpr int kGarbageOneIn = 8;

/// THE fault table: name, largest value, where it goes. What it does is in the header's table.
struct FaultRow {
    QLatin1StringView name;
    double largest;
    void (*store)(Faults&, double);
};
constexpr double kLongestDelayMs = 60'000;
constexpr double kMostGarbage = 4096;
constexpr double kLongestTime = 1e9;
constexpr double kLastByte = 1e12;
constexpr double kAllBits = 255;
constexpr double kMostControllers = 128;

constexpr std::array kFaults{
    FaultRow{"corrupt"_L1, 1.0, [](Faults& f, double v) { f.corrupt = v; }},
    FaultRow{"corrupt-at"_L1, kLastByte, [](Faults& f, double v) { f.corruptAt = qint64(v); }},
    FaultRow{"corrupt-mask"_L1, kAllBits,
             [](Faults& f, double v) { f.corruptMask = static_cast<std::uint8_t>(v); }},
    FaultRow{"corrupt-sent"_L1, 1.0, [](Faults& f, double v) { f.corruptSent = v; }},
    FaultRow{"delay"_L1, kLongestDelayMs, [](Faults& f, double v) { f.delayMs = v; }},
    FaultRow{"drop"_L1, 1.0, [](Faults& f, double v) { f.drop = v; }},
    FaultRow{"drop-at"_L1, kLastByte, [](Faults& f, double v) { f.dropAt = qint64(v); }},
    FaultRow{"drop-sent"_L1, 1.0, [](Faults& f, double v) { f.dropSent = v; }},
    FaultRow{"duplicate"_L1, 1.0, [](Faults& f, double v) { f.duplicate = v; }},
    FaultRow{"garbage"_L1, kMostGarbage, [](Faults& f, double v) { f.garbage = int(v); }},
    FaultRow{"hangup-after"_L1, kLongestTime, [](Faults& f, double v) { f.hangupAfter = v; }},
    FaultRow{"hangup-at"_L1, kLastByte, [](Faults& f, double v) { f.hangupAt = qint64(v); }},
    FaultRow{"hangup-for"_L1, kLongestTime, [](Faults& f, double v) { f.hangupFor = v; }},
    FaultRow{"repeat-sent"_L1, 1.0, [](Faults& f, double v) { f.repeatSent = v; }},
    FaultRow{"reset-after"_L1, kLongestTime, [](Faults& f, double v) { f.resetAfter = v; }},
    FaultRow{"reset-at"_L1, kLastByte, [](Faults& f, double v) { f.resetAt = qint64(v); }},
    FaultRow{"silent-after"_L1, kLongestTime, [](Faults& f, double v) { f.silentAfter = v; }},
    FaultRow{"silent-for"_L1, kLongestTime, [](Faults& f, double v) { f.silentFor = v; }},
    FaultRow{"unplugged"_L1, kMostControllers, [](Faults& f, double v) { f.unplugged = int(v); }},
};

FaultWindow window(const std::optional<double>& after, const std::optional<double>& length,
                   double origin)
{
    if (!after && !length) {
        return {};
    }
    const double from = origin + after.value_or(0.0);
    return {from, from + length.value_or(Faults::kNever)};
}

} // namespace

Random::Random(quint64 seed) : m_state((seed + 1) * 0x9E3779B97F4A7C15ULL | 1U) { }

quint64 Random::next()
{
    m_state ^= m_state >> 12U;
    m_state ^= m_state << 25U;
    m_state ^= m_state >> 27U;
    return m_state * 0x2545F4914F6CDD1DULL;
}

double Random::unit()
{
    return static_cast<double>(next() >> 11U) * 0x1.0p-53;
}

double Random::symmetric()
{
    return 2.0 * unit() - 1.0;
}

bool Random::chance(double probability)
{
    return probability > 0.0 && unit() < probability;
}

Result<void> Faults::apply(const QString& name, double value)
{
    QStringList names;
    for (const auto& row : kFaults) {
        if (name != row.name) {
            names.append(row.name);
            continue;
        }
        if (!(value >= 0.0 && value <= row.largest)) {
            return fail(
                ErrorCode::OutOfRange,
                u"fault %1: %2 is not within 0 to %3"_s.arg(name).arg(value).arg(row.largest));
        }
        row.store(*this, value);
        return {};
    }
    return fail(ErrorCode::OutOfRange,
                u"unknown fault \"%1\"; there are %2"_s.arg(name, names.join(u", "_s)));
}

FaultWindow silence(const Faults& faults, double origin)
{
    return window(faults.silentAfter, faults.silentFor, origin);
}

FaultWindow hangUp(const Faults& faults, double origin)
{
    if (faults.hangupAt && !faults.hangupAfter) {
        return {}; // its time is not known yet
    }
    return window(faults.hangupAfter, faults.hangupFor, origin);
}

ByteFate fateOf(const Faults& faults, qint64 number, std::uint8_t& value)
{
    if (faults.corruptAt == number) {
        value = static_cast<std::uint8_t>(value ^ faults.corruptMask);
    }
    if (faults.dropAt == number) {
        return ByteFate::Dropped;
    }
    if (faults.hangupAt == number) {
        return ByteFate::HangsUp;
    }
    return faults.resetAt == number ? ByteFate::Resets : ByteFate::Passes;
}

bool damages(const Faults& faults)
{
    return faults.drop > 0.0 || faults.corrupt > 0.0 || faults.duplicate > 0.0
        || faults.garbage > 0;
}

QByteArray damaged(QByteArrayView reply, const Faults& faults, Random& random)
{
    QByteArray result;
    if (faults.garbage > 0 && random.chance(1.0 / kGarbageOneIn)) {
        for (int i = 0; i < faults.garbage; ++i) {
            result.append(static_cast<char>(random.next() >> 56U));
        }
    }
    for (char byte : reply) {
        if (random.chance(faults.drop)) {
            continue;
        }
        if (random.chance(faults.corrupt)) {
            byte = static_cast<char>(byte ^ (1 << (random.next() >> 61U)));
        }
        result.append(byte);
        if (random.chance(faults.duplicate)) {
            result.append(byte);
        }
    }
    return result;
}

int arrivals(std::uint8_t& value, const Faults& faults, Random& random)
{
    if (random.chance(faults.dropSent)) {
        return 0;
    }
    if (random.chance(faults.corruptSent)) {
        value = static_cast<std::uint8_t>(value ^ (1U << (random.next() >> 61U)));
    }
    return random.chance(faults.repeatSent) ? 2 : 1;
}

} // namespace trex::sim
