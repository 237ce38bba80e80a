// SPDX-License-Identifier: GPL-3.0-or-later
#include "protocol/procedures/calibrationtext.h"

#include <QCoreApplication>
#include <QStringList>

#include <cmath>

namespace trex {
namespace {

using namespace Qt::Literals::StringLiterals;

QString translated(const char* text)
{
    return QCoreApplication::translate("Calibration", text);
}

struct FindingRow {
    Finding finding;
    /// %1 how far it moved at most, %2 how far it must, %3 noise, %4 missing in percent, %5 by what
    /// RC and analog seem mixed up, %6 spikes in percent, %7 farthest rest, %8 the other channel.
    const char* text;
};

// clang-format off
constexpr auto kFindings = std::to_array<FindingRow>({
    {Finding::NoReadings, QT_TRANSLATE_NOOP("Calibration", "No valid reading came. Check the plug, the receiver and its power, or leave this channel out.")},
    {Finding::InputConfused, QT_TRANSLATE_NOOP("Calibration", "RC and analog seem to be mixed up. %5")},
    {Finding::NotStill, QT_TRANSLATE_NOOP("Calibration", "It was never still. Let go of it; if it jitters by itself, look at its potentiometer or cable.")},
    {Finding::MissingPulses, QT_TRANSLATE_NOOP("Calibration", "%4 % of the pulses were missing. Check the receiver, its antenna and the plug.")},
    {Finding::Jitter, QT_TRANSLATE_NOOP("Calibration", "%6 % of its readings jump far beyond its noise, as a failing potentiometer or a loose cable does. Repair that first.")},
    {Finding::NotMoved, QT_TRANSLATE_NOOP("Calibration", "It did not move. Move it to both ends, or leave this channel out.")},
    {Finding::TravelTooSmall, QT_TRANSLATE_NOOP("Calibration", "It moved %1 at most, and %2 to each side are needed. Move it further, or widen the travel in the transmitter.")},
    {Finding::OneDirection, QT_TRANSLATE_NOOP("Calibration", "It was moved one way only. Move it to both ends.")},
    {Finding::Noisy, QT_TRANSLATE_NOOP("Calibration", "It is too noisy (%3). Look at its potentiometer, cable or receiver.")},
    {Finding::NotHeld, QT_TRANSLATE_NOOP("Calibration", "It was not held at its ends for long enough to know them. Hold it at each end for a second.")},
    {Finding::CentreLost, QT_TRANSLATE_NOOP("Calibration", "It comes to rest up to %7 away from its neutral, too far for a deadband to cover. Look at its spring and its mechanics.")},
    {Finding::SwappedWith, QT_TRANSLATE_NOOP("Calibration", "Channel %8 moved when this one was asked for: they seem to be swapped. Exchange their plugs, or their axes in the transmitter.")},
    {Finding::SwitchOnAtNeutral, QT_TRANSLATE_NOOP("Calibration", "It rests on its low side, where it is thought to be on (below half-way; a guess, the threshold is not published). Learn it with the switch in the other position, or reverse it in the transmitter.")},
    {Finding::RestsAtEnd, QT_TRANSLATE_NOOP("Calibration", "It rests at one end, as levers and switches do; the other end is set equally far away.")},
    {Finding::SomeMissing, QT_TRANSLATE_NOOP("Calibration", "%4 % of the pulses were missing.")},
    {Finding::SomeNoise, QT_TRANSLATE_NOOP("Calibration", "It is somewhat noisy (%3); the deadband is wider for it.")},
    {Finding::SomeJitter, QT_TRANSLATE_NOOP("Calibration", "%6 % of its readings jump beyond its noise; they were left out. Its potentiometer or cable may be wearing out.")},
    {Finding::SloppyCentre, QT_TRANSLATE_NOOP("Calibration", "It comes to rest up to %7 away from its neutral; the deadband covers that.")},
    {Finding::CoarseTravel, QT_TRANSLATE_NOOP("Calibration", "Its travel has fewer counts than the 127 steps to each side, so that some speeds cannot be chosen.")},
    {Finding::Asymmetric, QT_TRANSLATE_NOOP("Calibration", "One side moves much less than the other, so that its control is coarser.")},
    {Finding::Saturated, QT_TRANSLATE_NOOP("Calibration", "An end lies at the limit of what can be read; part of the travel may be cut off. Shorten the travel in the transmitter.")},
});
// clang-format on

static_assert([] {
    for (std::size_t i = 0; i < kFindings.size(); ++i) {
        if (static_cast<std::size_t>(kFindings[i].finding) != i) {
            return false;
        }
    }
    return kFindings.size() == static_cast<std::size_t>(Finding::Saturated) + 1;
}());

QString confusionText(Confusion confusion, InputKind input)
{
    switch (confusion) {
    case Confusion::OtherKindsReadings:
        return input == InputKind::Rc
            ? translated(QT_TRANSLATE_NOOP("Calibration",
                                           "It was to be read as RC pulses, but most readings are "
                                           "such as only a voltage gives."))
            : translated(QT_TRANSLATE_NOOP("Calibration",
                                           "It was to be read as a voltage, but most readings are "
                                           "such as only RC pulses give."));
    case Confusion::PulsesOnAnalog:
        return translated(QT_TRANSLATE_NOOP("Calibration",
                                            "At rest it reads 0 V most of the time, with short "
                                            "bursts, as an RC receiver on an analog input would "
                                            "(a guess)."));
    case Confusion::Floating:
        return translated(QT_TRANSLATE_NOOP("Calibration",
                                            "It wandered for seconds without ever resting, as an "
                                            "analog input with nothing, or an RC receiver, on it "
                                            "would (a guess)."));
    case Confusion::None:
        break;
    }
    return {};
}

} // namespace

QString readingText(double raw, InputKind input)
{
    const int rounded = static_cast<int>(std::lround(raw));
    return input == InputKind::Rc ? translated(QT_TRANSLATE_NOOP("Calibration", "%1 ms"))
                                        .arg(millisecondsFromRaw(rounded), 0, 'f', 3)
                                  : translated(QT_TRANSLATE_NOOP("Calibration", "%1 V"))
                                        .arg(voltsFromRaw(rounded), 0, 'f', 2);
}

QString spanText(double raw, InputKind input)
{
    const int rounded = static_cast<int>(std::lround(raw));
    return input == InputKind::Rc ? translated(QT_TRANSLATE_NOOP("Calibration", "%1 µs"))
                                        .arg(microsecondsFromRaw(rounded), 0, 'f', 0)
                                  : translated(QT_TRANSLATE_NOOP("Calibration", "%1 V"))
                                        .arg(voltsFromRaw(rounded), 0, 'f', 2);
}

QString verdictText(Verdict verdict)
{
    switch (verdict) {
    case Verdict::Good:
        return translated(QT_TRANSLATE_NOOP("Calibration", "good"));
    case Verdict::Usable:
        return translated(QT_TRANSLATE_NOOP("Calibration", "usable"));
    case Verdict::DoAgain:
        break;
    }
    return translated(QT_TRANSLATE_NOOP("Calibration", "do again"));
}

QString findingText(Finding finding, const LearnedChannel& learned, InputKind input)
{
    QString text = translated(kFindings[static_cast<std::size_t>(finding)].text);
    text.replace("%1"_L1, spanText(std::min(learned.lowTravel(), learned.highTravel()), input));
    text.replace("%2"_L1, spanText(calibrationRules(input).neededTravel, input));
    text.replace("%3"_L1, u"σ "_s + spanText(learned.sigma, input));
    text.replace("%4"_L1, QString::number(learned.missedShare() * 100.0, 'f', 0));
    text.replace("%5"_L1, confusionText(learned.confusion, input));
    text.replace("%6"_L1, QString::number(learned.spikeShare() * 100.0, 'f', 1));
    text.replace("%7"_L1, spanText(learned.farthestRest, input));
    text.replace("%8"_L1, QString::number(learned.swappedWith));
    return text;
}

QString reasonText(const LearnedChannel& learned, InputKind input)
{
    if (!learned.findings.empty()) {
        return findingText(learned.findings.front(), learned, input);
    }
    return learned.returns > 0
        ? translated(QT_TRANSLATE_NOOP(
            "Calibration", "Quiet at rest, full travel both ways, comes back to its neutral."))
        : translated(QT_TRANSLATE_NOOP("Calibration", "Quiet at rest, full travel both ways."));
}

QString deadbandText(const LearnedChannel& learned, InputKind input)
{
    const auto deadband = spanText(learned.calibration.deadband, input);
    switch (learned.deadbandBasis) {
    case DeadbandBasis::Noise:
        return translated(QT_TRANSLATE_NOOP("Calibration", "Deadband: ±%1 (%2 σ of its noise)"))
            .arg(deadband)
            .arg(kDeadbandSigmas, 0, 'f', 0);
    case DeadbandBasis::Rests:
        return translated(QT_TRANSLATE_NOOP(
                              "Calibration",
                              "Deadband: ±%1 (%2 × its farthest rest and %3 σ of its noise)"))
            .arg(deadband)
            .arg(kDeadbandRests)
            .arg(kDeadbandRestSigmas, 0, 'f', 0);
    case DeadbandBasis::Floor:
        break;
    }
    return translated(QT_TRANSLATE_NOOP("Calibration",
                                        "Deadband: ±%1 (the least; %2 σ of its noise are ±%3)"))
        .arg(deadband)
        .arg(kDeadbandSigmas, 0, 'f', 0)
        .arg(spanText(kDeadbandSigmas * learned.sigma, input));
}

QString centringText(const LearnedChannel& learned, InputKind input)
{
    if (learned.returns == 0) {
        return translated(QT_TRANSLATE_NOOP("Calibration", "Centring: not tried"));
    }
    const auto rests =
        translated(QT_TRANSLATE_NOOP("Calibration",
                                     "Centring: %1 returns, rests within %2, up to "
                                     "%3 off neutral"))
            .arg(learned.returns)
            .arg(spanText(learned.repeatability, input), spanText(learned.farthestRest, input));
    return learned.hysteresis
        ? translated(QT_TRANSLATE_NOOP("Calibration", "%1; from above and below %2 apart"))
              .arg(rests, spanText(std::abs(*learned.hysteresis), input))
        : rests;
}

QString endsText(const LearnedChannel& learned, InputKind input)
{
    const auto text = [&](double uncertainty, const EndWindow& window) {
        const double rounded = std::max(1.0, std::ceil(uncertainty));
        return window.samples == 0
            ? translated(QT_TRANSLATE_NOOP("Calibration", "not reached"))
            : translated(QT_TRANSLATE_NOOP("Calibration", "±%1 (%2 samples)"))
                  .arg(spanText(rounded, input))
                  .arg(window.samples);
    };
    return translated(QT_TRANSLATE_NOOP("Calibration", "Ends known within: low %1, high %2"))
        .arg(text(learned.lowUncertainty, learned.lowWindow),
             text(learned.highUncertainty, learned.highWindow));
}

QString figuresText(const LearnedChannel& learned, InputKind input)
{
    QStringList lines;
    lines << translated(QT_TRANSLATE_NOOP("Calibration", "Samples: %1, missed: %2 (%3 %)"))
                 .arg(learned.samples)
                 .arg(learned.missed)
                 .arg(learned.missedShare() * 100.0, 0, 'f', 1);
    const double travel = learned.lowTravel() + learned.highTravel();
    lines << translated(QT_TRANSLATE_NOOP("Calibration",
                                          "Noise at rest: σ %1 (%2 % of the travel); jumps: %3"))
                 .arg(spanText(learned.sigma, input))
                 .arg(travel > 0.0 ? learned.sigma / travel * 100.0 : 0.0, 0, 'f', 2)
                 .arg(learned.spikes);
    lines << translated(QT_TRANSLATE_NOOP("Calibration", "Travel: %1 down, %2 up; symmetry %3 %"))
                 .arg(spanText(learned.lowTravel(), input), spanText(learned.highTravel(), input))
                 .arg(learned.symmetry() * 100.0, 0, 'f', 0);
    lines << centringText(learned, input);
    if (learned.verdict == Verdict::DoAgain) {
        return lines.join(u'\n');
    }
    lines << deadbandText(learned, input);
    lines << endsText(learned, input);
    lines << translated(QT_TRANSLATE_NOOP("Calibration",
                                          "Ends pulled in by %1 and %2, so that the full stick "
                                          "gives 127"))
                 .arg(spanText(learned.lowMargin, input), spanText(learned.highMargin, input));
    if (learned.switchThreshold) {
        lines << translated(QT_TRANSLATE_NOOP("Calibration",
                                              "Switches on at and below about %1 (a guess: the "
                                              "threshold is not published)"))
                     .arg(readingText(*learned.switchThreshold, input));
    }
    return lines.join(u'\n');
}

QString channelListText(std::uint8_t mask)
{
    QStringList numbers;
    for (int channel = 1; channel <= kChannelCount; ++channel) {
        if ((mask >> (channel - 1) & 1) != 0) {
            numbers << QString::number(channel);
        }
    }
    if (numbers.size() < 2) {
        return numbers.join(QString());
    }
    const QString last = numbers.takeLast();
    return translated(QT_TRANSLATE_NOOP("Calibration", "%1 and %2"))
        .arg(numbers.join(", "_L1), last);
}

} // namespace trex
