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
    /// %1 how far it moved at most, %2 how far it must, %3 noise, %4 missing in percent.
    const char* text;
};

// clang-format off
constexpr auto kFindings = std::to_array<FindingRow>({
    {Finding::NoReadings, QT_TRANSLATE_NOOP("Calibration", "No valid reading came. Check the plug, the receiver and its power, or leave this channel out.")},
    {Finding::NotStill, QT_TRANSLATE_NOOP("Calibration", "It was never still. Let go of it; if it jitters by itself, look at its potentiometer or cable.")},
    {Finding::MissingPulses, QT_TRANSLATE_NOOP("Calibration", "%4 % of the pulses were missing. Check the receiver, its antenna and the plug.")},
    {Finding::NotMoved, QT_TRANSLATE_NOOP("Calibration", "It did not move. Move it to both ends, or leave this channel out.")},
    {Finding::TravelTooSmall, QT_TRANSLATE_NOOP("Calibration", "It moved %1 at most, and %2 to each side are needed. Move it further, or widen the travel in the transmitter.")},
    {Finding::OneDirection, QT_TRANSLATE_NOOP("Calibration", "It was moved one way only. Move it to both ends.")},
    {Finding::Noisy, QT_TRANSLATE_NOOP("Calibration", "It is too noisy (%3). Look at its potentiometer, cable or receiver.")},
    {Finding::RestsAtEnd, QT_TRANSLATE_NOOP("Calibration", "It rests at one end, as levers and switches do; the other end is set equally far away.")},
    {Finding::SomeMissing, QT_TRANSLATE_NOOP("Calibration", "%4 % of the pulses were missing.")},
    {Finding::SomeNoise, QT_TRANSLATE_NOOP("Calibration", "It is somewhat noisy (%3); the deadband is wider for it.")},
    {Finding::Asymmetric, QT_TRANSLATE_NOOP("Calibration", "One side moves much less than the other, so that its control is coarser.")},
    {Finding::Saturated, QT_TRANSLATE_NOOP("Calibration", "An end lies at the limit of what can be read; part of the travel may be cut off.")},
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
    return text;
}

QString reasonText(const LearnedChannel& learned, InputKind input)
{
    return learned.findings.empty()
        ? translated(QT_TRANSLATE_NOOP("Calibration", "Quiet at rest, full travel both ways."))
        : findingText(learned.findings.front(), learned, input);
}

QString figuresText(const LearnedChannel& learned, InputKind input)
{
    QStringList lines;
    lines << translated(QT_TRANSLATE_NOOP("Calibration", "Samples: %1, missed: %2 (%3 %)"))
                 .arg(learned.samples)
                 .arg(learned.missed)
                 .arg(learned.missedShare() * 100.0, 0, 'f', 1);
    lines << translated(QT_TRANSLATE_NOOP("Calibration", "Noise at rest: σ %1"))
                 .arg(spanText(learned.sigma, input));
    lines << translated(QT_TRANSLATE_NOOP("Calibration", "Travel: %1 down, %2 up; symmetry %3 %"))
                 .arg(spanText(learned.lowTravel(), input), spanText(learned.highTravel(), input))
                 .arg(learned.symmetry() * 100.0, 0, 'f', 0);
    if (learned.verdict != Verdict::DoAgain) {
        lines << translated(QT_TRANSLATE_NOOP("Calibration", "Deadband: ±%1 (%2 σ, at least %3)"))
                     .arg(spanText(learned.calibration.deadband, input))
                     .arg(kDeadbandSigmas, 0, 'f', 0)
                     .arg(spanText(calibrationRules(input).deadbandFloor, input));
        lines << translated(QT_TRANSLATE_NOOP(
                                "Calibration",
                                "Ends pulled in by %1 and %2, so that the full stick gives 127"))
                     .arg(spanText(learned.lowMargin, input), spanText(learned.highMargin, input));
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
