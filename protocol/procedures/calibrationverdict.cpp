// SPDX-License-Identifier: GPL-3.0-or-later
#include "protocol/procedures/calibrationverdict.h"

#include <cmath>

namespace trex {
namespace {

// Pulse widths in 0.4 µs: 6 µs, 50 µs, 250 µs, 16 µs. Analog counts of 4.9 mV: 20 mV, 0.12 V,
// 0.61 V, 39 mV.
constexpr CalibrationRules kRcRules{1250, 6250, 15.0, 125.0, 625, 40};
constexpr CalibrationRules kAnalogRules{0, 1023, 4.0, 25.0, 125, 8};

constexpr double kLeastMarginShare = 0.005; // of the side's travel
constexpr double kMostMarginShare = 0.0075;
constexpr double kMarginSigmas = 2.0;
constexpr double kSaturationShare = 0.002; // of the range of a reading

/// Pulled in by what noise takes from a full stick, but within a half and three quarters of a
/// percent.
int marginOf(double travel, double sigma)
{
    const double share =
        std::clamp(kMarginSigmas * sigma, kLeastMarginShare * travel, kMostMarginShare * travel);
    return static_cast<int>(std::ceil(share));
}

void findFaults(LearnedChannel& learned, const ChannelMeasurement& measured,
                const CalibrationRules& rules)
{
    const auto found = [&learned](Finding finding, bool is) {
        if (is) {
            learned.findings.push_back(finding);
        }
    };
    const double low = learned.lowTravel();
    const double high = learned.highTravel();
    const bool isLow = low >= rules.neededTravel;
    const bool isHigh = high >= rules.neededTravel;
    // Less than a quarter of what is needed is no travel, only play.
    const bool isOneWay = isLow != isHigh && std::min(low, high) < rules.neededTravel / 4.0;
    const bool isEnough = (isLow && isHigh) || (isOneWay && mayRestAtEnd(measured.channel));
    const bool hasMoved = std::max(low, high) >= rules.neededTravel / 4.0;
    const double noise = learned.sigma / std::max(1.0, low + high);
    const double missed = learned.missedShare();

    found(Finding::NoReadings, measured.samples == 0);
    found(Finding::NotStill, measured.samples > 0 && !measured.hasNeutral);
    found(Finding::MissingPulses, measured.samples > 0 && missed > kMostMissedShare);
    if (measured.hasNeutral) {
        found(Finding::NotMoved, !hasMoved);
        found(Finding::TravelTooSmall, hasMoved && !isEnough && !isOneWay);
        found(Finding::OneDirection, isOneWay && !isEnough);
        found(Finding::Noisy, isEnough && noise > kMostNoiseShare);
    }
    learned.verdict = learned.findings.empty() ? Verdict::Good : Verdict::DoAgain;
    if (learned.verdict == Verdict::DoAgain) {
        return;
    }
    const double edge = kSaturationShare * (rules.largest - rules.smallest);
    found(Finding::RestsAtEnd, isOneWay);
    found(Finding::SomeMissing, missed > kGoodMissedShare);
    found(Finding::SomeNoise, noise > kGoodNoiseShare);
    found(Finding::Asymmetric, !isOneWay && learned.symmetry() < kGoodSymmetry);
    found(Finding::Saturated,
          learned.lowEnd < rules.smallest + edge || learned.highEnd > rules.largest - edge);
    if (!learned.findings.empty()) {
        learned.verdict = Verdict::Usable;
    }
}

/// A lever that rests at one end gets the other end as far away as the used one: noise at rest
/// must not read as full reverse, which an end right at neutral would make of it.
void mirrorUnusedEnd(LearnedChannel& learned, const CalibrationRules& rules)
{
    auto& calibration = learned.calibration;
    if (learned.lowTravel() < learned.highTravel()) {
        const int mirrored = 2 * calibration.neutral - calibration.maximum;
        calibration.minimum = std::min(calibration.neutral, std::max(rules.smallest, mirrored));
        learned.lowMargin = 0;
    } else {
        const int mirrored = 2 * calibration.neutral - calibration.minimum;
        calibration.maximum = std::max(calibration.neutral, std::min(rules.largest, mirrored));
        learned.highMargin = 0;
    }
}

} // namespace

const CalibrationRules& calibrationRules(InputKind input)
{
    return input == InputKind::Rc ? kRcRules : kAnalogRules;
}

double LearnedChannel::symmetry() const
{
    const double larger = std::max(lowTravel(), highTravel());
    return larger <= 0.0 ? 0.0 : std::max(0.0, std::min(lowTravel(), highTravel())) / larger;
}

double LearnedChannel::missedShare() const
{
    return samples + missed == 0 ? 0.0 : double(missed) / (samples + missed);
}

bool LearnedChannel::has(Finding finding) const
{
    return std::ranges::find(findings, finding) != findings.end();
}

LearnedChannel judge(const ChannelMeasurement& measured, InputKind input)
{
    const auto& rules = calibrationRules(input);
    LearnedChannel learned;
    learned.samples = measured.samples;
    learned.missed = measured.missed;
    learned.neutral = measured.neutral;
    learned.sigma = measured.sigma;
    learned.lowEnd = std::min(measured.lowEnd, measured.neutral);
    learned.highEnd = std::max(measured.highEnd, measured.neutral);
    findFaults(learned, measured, rules);
    if (learned.verdict == Verdict::DoAgain) {
        return learned;
    }
    learned.lowMargin = marginOf(learned.lowTravel(), learned.sigma);
    learned.highMargin = marginOf(learned.highTravel(), learned.sigma);
    auto& calibration = learned.calibration;
    calibration.neutral = static_cast<int>(std::lround(learned.neutral));
    calibration.minimum = static_cast<int>(std::lround(learned.lowEnd)) + learned.lowMargin;
    calibration.maximum = static_cast<int>(std::lround(learned.highEnd)) - learned.highMargin;
    if (learned.has(Finding::RestsAtEnd)) {
        mirrorUnusedEnd(learned, rules);
    }
    // Never more than a quarter of the travel: beyond that there would be no stick left.
    const double most = std::max(learned.lowTravel(), learned.highTravel()) / 4.0;
    const double asked = std::max(double(rules.deadbandFloor), kDeadbandSigmas * learned.sigma);
    calibration.deadband = static_cast<int>(std::ceil(std::min(asked, most)));
    return learned;
}

} // namespace trex
