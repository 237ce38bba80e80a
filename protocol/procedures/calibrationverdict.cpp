// SPDX-License-Identifier: GPL-3.0-or-later
#include "protocol/procedures/calibrationverdict.h"

#include "protocol/procedures/endestimate.h"
#include "protocol/procedures/responsecurve.h"

#include <algorithm>
#include <cmath>

namespace trex {
namespace {

// Pulse widths in 0.4 µs: 6 µs, 50 µs, 250 µs, 16 µs. Analog counts of 4.9 mV: 20 mV, 0.12 V,
// 0.61 V, 39 mV.
constexpr CalibrationRules kRcRules{1250, 6250, 15.0, 125.0, 625, 40};
constexpr CalibrationRules kAnalogRules{0, 1023, 4.0, 25.0, 125, 8};

constexpr double kSaturationShare = 0.002; // of the range of a reading
constexpr double kBeyondShare = 0.15; // of that range: an end this near, not held, lies beyond it
constexpr double kJumpyShare = 0.02; // spikes that look like a rush when they come in groups

/// Pulled in by half a percent of the side, but one count at least: the full stick reaches beyond
/// it, and no more is lost than one step of the 127 has.
double marginOf(double side)
{
    return std::max(1.0, kEndMarginShare * side);
}

struct Reached {
    bool isLow = false; ///< far enough
    bool isHigh = false;
    bool isOneWay = false; ///< one side only; the other has play at most
    bool isEnough = false;
    bool hasMoved = false;
};

Reached reachedOf(const LearnedChannel& learned, const CalibrationRules& rules)
{
    const double low = learned.lowTravel();
    const double high = learned.highTravel();
    // Less than a quarter of what is needed is no travel, only play.
    const double play = rules.neededTravel / 4.0;
    Reached reached;
    reached.isLow = low >= rules.neededTravel;
    reached.isHigh = high >= rules.neededTravel;
    reached.isOneWay = reached.isLow != reached.isHigh && std::min(low, high) < play;
    reached.isEnough =
        (reached.isLow && reached.isHigh) || (reached.isOneWay && mayRestAtEnd(learned.channel));
    reached.hasMoved = std::max(low, high) >= play;
    return reached;
}

double askedDeadband(const LearnedChannel& learned, const CalibrationRules& rules,
                     DeadbandBasis& basis)
{
    const double noise = kDeadbandSigmas * learned.sigma;
    const double rests = learned.returns == 0
        ? 0.0
        : kDeadbandRests * learned.farthestRest + kDeadbandRestSigmas * learned.sigma;
    const double asked = std::max({double(rules.deadbandFloor), noise, rests});
    basis = asked <= rules.deadbandFloor ? DeadbandBasis::Floor
        : asked > noise                  ? DeadbandBasis::Rests
                                         : DeadbandBasis::Noise;
    return asked;
}

/// A deadband never takes more than a quarter of the travel: beyond that there is no stick left.
double mostDeadband(const LearnedChannel& learned)
{
    return std::max(learned.lowTravel(), learned.highTravel()) / 4.0;
}

/// An end lies within that share of the range from the limits of what can be read.
bool isNearLimit(const LearnedChannel& learned, const CalibrationRules& rules, double share)
{
    const double edge = share * (rules.largest - rules.smallest);
    return learned.lowEnd < rules.smallest + edge || learned.highEnd > rules.largest - edge;
}

int minimumOf(const LearnedChannel& learned)
{
    return static_cast<int>(std::lround(learned.lowEnd + marginOf(learned.lowTravel())));
}

int maximumOf(const LearnedChannel& learned)
{
    return static_cast<int>(std::lround(learned.highEnd - marginOf(learned.highTravel())));
}

/// Whether what is written for an end, so far from the end itself, is right within kMostEndError
/// wherever in its uncertainty the end lies.
bool isKnown(double uncertainty, double pulledIn, double travel)
{
    return uncertainty + std::abs(pulledIn) <= kMostEndError * travel;
}

/// For an end that is not known well enough: held as a person is asked to hold it, it still would
/// not be known for its noise; or it was held, and the noise is most of what is left open.
bool isNoiseAtFault(const LearnedChannel& learned, bool isHeld, const EndWindow& window,
                    double uncertainty)
{
    const double travel = learned.lowTravel() + learned.highTravel();
    const auto samples = static_cast<std::size_t>(window.samples);
    const bool isHeldLong = isHeld && samples >= kHoldSamples
        && noiseUncertainty(learned.sigma, samples) > uncertainty / 2.0;
    const double held = noiseUncertainty(learned.sigma, kHoldSamples);
    return isHeldLong || !isKnown(held, marginOf(travel / 2.0), travel);
}

/// Faults for which the channel is to be done again.
void findFaults(LearnedChannel& learned, const ChannelMeasurement& measured,
                const CalibrationRules& rules)
{
    const auto found = [&learned](Finding finding, bool is) {
        if (is) {
            learned.findings.push_back(finding);
        }
    };
    const auto reached = reachedOf(learned, rules);
    const bool isOthers = learned.confusion == Confusion::OtherKindsReadings;
    const bool hasReadings = measured.samples > 0;
    const double travel = learned.lowTravel() + learned.highTravel();
    DeadbandBasis basis{};
    const double deadband = askedDeadband(learned, rules, basis);

    found(Finding::NoReadings, !hasReadings && !isOthers);
    // Bursts on a still input are only suspicious while nothing moves it.
    found(Finding::InputConfused,
          isOthers
              || (learned.confusion == Confusion::PulsesOnAnalog
                  && !(measured.hasNeutral && reached.isEnough)));
    found(Finding::NotStill, hasReadings && !measured.hasNeutral);
    found(Finding::InputConfused, learned.confusion == Confusion::Floating);
    const bool isLowVague = reached.isLow
        && !(measured.isLowHeld
             && isKnown(learned.lowUncertainty, minimumOf(learned) - learned.lowEnd, travel));
    const bool isHighVague = reached.isHigh
        && !(measured.isHighHeld
             && isKnown(learned.highUncertainty, maximumOf(learned) - learned.highEnd, travel));
    const bool isNotHeld = reached.isEnough && (isLowVague || isHighVague);
    found(Finding::Jitter,
          measured.hasNeutral
              && learned.spikeShare() > (isNotHeld ? kJumpyShare : kMostSpikeShare));
    // Beyond its limits a pulse is none, so that the stick seems never to rest at its end.
    const bool isBeyond = isNotHeld && learned.missedShare() > kGoodMissedShare
        && isNearLimit(learned, rules, kBeyondShare);
    const double noise = learned.sigma / std::max(1.0, travel);
    const bool isHidden = isNotHeld
        && ((isLowVague
             && isNoiseAtFault(learned, measured.isLowHeld, learned.lowWindow,
                               learned.lowUncertainty))
            || (isHighVague
                && isNoiseAtFault(learned, measured.isHighHeld, learned.highWindow,
                                  learned.highUncertainty)));
    const bool isNoisy = reached.isEnough && (isHidden || noise > kMostNoiseShare);
    found(Finding::Saturated, isBeyond);
    found(Finding::MissingPulses, hasReadings && learned.missedShare() > kMostMissedShare);
    if (measured.hasNeutral) {
        found(Finding::NotMoved, !reached.hasMoved);
        found(Finding::TravelTooSmall, reached.hasMoved && !reached.isEnough && !reached.isOneWay);
        found(Finding::OneDirection, reached.isOneWay && !reached.isEnough);
        found(Finding::Noisy, isNoisy);
        found(Finding::NotHeld, isNotHeld && !isBeyond);
        found(Finding::CentreLost,
              reached.isEnough && basis == DeadbandBasis::Rests && !mayRestAtEnd(learned.channel)
                  && deadband > mostDeadband(learned));
    }
    learned.verdict = learned.findings.empty() ? Verdict::Good : Verdict::DoAgain;
}

/// The rest position of a switch lies on the low side of its travel.
bool isRestingLow(const LearnedChannel& learned)
{
    return isSwitchChannel(learned.channel)
        && learned.lowTravel() < learned.highTravel() * kGoodSymmetry;
}

bool isCoarse(const LearnedChannel& learned, bool isOneWay)
{
    const auto& [minimum, neutral, maximum, deadband] = learned.calibration;
    const int low = neutral - deadband - minimum;
    const int high = maximum - neutral - deadband;
    return (isOneWay ? std::max(low, high) : std::min(low, high)) < kFullSpeed;
}

/// What is worth knowing of a channel that can be used.
void findRemarks(LearnedChannel& learned, const CalibrationRules& rules, bool isOneWay)
{
    const auto found = [&learned](Finding finding, bool is) {
        if (is) {
            learned.findings.push_back(finding);
        }
    };
    const double travel = learned.lowTravel() + learned.highTravel();
    found(Finding::SwappedWith, learned.swappedWith != 0);
    found(Finding::SwitchOnAtNeutral, isRestingLow(learned));
    found(Finding::RestsAtEnd, isOneWay);
    found(Finding::SomeMissing, learned.missedShare() > kGoodMissedShare);
    found(Finding::SomeNoise, learned.sigma > kGoodNoiseShare * std::max(1.0, travel));
    found(Finding::SomeJitter, learned.spikeShare() > kGoodSpikeShare);
    found(Finding::SloppyCentre,
          learned.returns > 0 && learned.farthestRest > kGoodRestShare * travel);
    found(Finding::CoarseTravel, isCoarse(learned, isOneWay));
    found(Finding::Asymmetric, !isOneWay && learned.symmetry() < kGoodSymmetry);
    found(Finding::Saturated, isNearLimit(learned, rules, kSaturationShare));
    learned.verdict = learned.findings.empty() ? Verdict::Good : Verdict::Usable;
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

/// The calibration to be written.
void propose(LearnedChannel& learned, const CalibrationRules& rules)
{
    const bool isOneWay = reachedOf(learned, rules).isOneWay;
    learned.lowMargin = static_cast<int>(std::lround(marginOf(learned.lowTravel())));
    learned.highMargin = static_cast<int>(std::lround(marginOf(learned.highTravel())));
    auto& calibration = learned.calibration;
    calibration.neutral = static_cast<int>(std::lround(learned.neutral));
    calibration.minimum = minimumOf(learned);
    calibration.maximum = maximumOf(learned);
    if (isOneWay) {
        mirrorUnusedEnd(learned, rules);
    }
    const double asked = askedDeadband(learned, rules, learned.deadbandBasis);
    calibration.deadband = static_cast<int>(std::ceil(std::min(asked, mostDeadband(learned))));
    if (isSwitchChannel(learned.channel)) {
        learned.switchThreshold = static_cast<int>(
            std::floor(ResponseCurve{calibration, false, false}.switchThreshold()));
    }
    findRemarks(learned, rules, isOneWay);
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

double LearnedChannel::spikeShare() const
{
    return checked == 0 ? 0.0 : double(spikes) / checked;
}

bool LearnedChannel::has(Finding finding) const
{
    return std::ranges::find(findings, finding) != findings.end();
}

LearnedChannel judge(const ChannelMeasurement& measured, InputKind input)
{
    const auto& rules = calibrationRules(input);
    LearnedChannel learned;
    learned.channel = measured.channel;
    learned.samples = measured.samples;
    learned.missed = measured.missed;
    learned.neutral = measured.neutral;
    learned.sigma = measured.sigma;
    learned.lowEnd = std::min(measured.lowEnd, measured.neutral);
    learned.highEnd = std::max(measured.highEnd, measured.neutral);
    learned.lowUncertainty = measured.lowUncertainty;
    learned.highUncertainty = measured.highUncertainty;
    learned.lowWindow = measured.lowWindow;
    learned.highWindow = measured.highWindow;
    learned.returns = measured.returns;
    learned.repeatability = measured.repeatability;
    learned.farthestRest = measured.farthestRest;
    learned.hysteresis = measured.hysteresis;
    learned.checked = measured.checked;
    learned.spikes = measured.spikes;
    learned.confusion = measured.confusion;
    learned.swappedWith = measured.swappedWith;
    learned.forwardSign = measured.forwardSign;
    findFaults(learned, measured, rules);
    if (learned.verdict != Verdict::DoAgain) {
        propose(learned, rules);
    }
    return learned;
}

} // namespace trex
