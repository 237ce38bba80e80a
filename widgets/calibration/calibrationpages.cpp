// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/calibration/calibrationpages.h"

#include "protocol/procedures/calibrationtext.h"

namespace trex::calibrationpages {
namespace {

using Step = ChannelCalibration::Step;

QString directionInstruction(const ChannelCalibration& calibration)
{
    const int channel = calibration.directionChannel();
    if (channel == 0) {
        return Texts::tr("Look at the directions and switches. Go on.");
    }
    return calibration.learner()->isDirectionReady()
        ? Texts::tr("Push channel %1 forward, and hold it.").arg(channel)
        : Texts::tr("Channel %1 is next: let go of all sticks first.").arg(channel);
}

/// The set that is calibrated, and the one that is left alone.
QString setText(InputKind input)
{
    return input == InputKind::Rc ? Texts::tr("The RC calibration is set; the analog one stays.")
                                  : Texts::tr("The analog calibration is set; the RC one stays.");
}

Notice chooseNotice(const ChannelCalibration& calibration, Mode mode)
{
    if (!isSerial(mode)) {
        const QString name = mode == Mode::Rc ? Texts::tr("RC") : Texts::tr("analog");
        return {StateShape::Warning,
                Texts::tr("%1 mode: the sticks move the motors, and nothing can be written. Better "
                          "use serial mode: power off, mode jumper off, power on.")
                    .arg(name)};
    }
    return {StateShape::Ok,
            Texts::tr("Serial mode: the sticks do not move the motors.") + u' '
                + setText(calibration.input())};
}

Notice reviewNotice(const ChannelCalibration& calibration)
{
    QStringList sentences;
    QStringList skipped;
    for (const Step step : calibration.skipped()) {
        skipped << (step == Step::Returns         ? Texts::tr("how the sticks come back")
                        : step == Step::Direction ? Texts::tr("which way is forward")
                                                  : Texts::tr("trying the new numbers"));
    }
    bool hasNearest = false;
    for (int channel = 1; channel <= kChannelCount; ++channel) {
        hasNearest =
            hasNearest || (calibration.isChosen(channel) && calibration.isNearest(channel));
    }
    if (hasNearest) {
        sentences << Texts::tr("This controller reads the bytes of a calibration as 8 bits each "
                               "and cannot hold the learned numbers: shown are the nearest that "
                               "it can.");
    }
    if (!skipped.isEmpty()) {
        sentences << Texts::tr("Skipped, so less certain: %1.").arg(skipped.join(u", "));
    }
    return {hasNearest ? StateShape::Warning : StateShape::Off, sentences.join(u' ')};
}

} // namespace

QStringList stepTitles()
{
    return {Texts::tr("Choose"),    Texts::tr("Neutral"), Texts::tr("Returns"), Texts::tr("Ends"),
            Texts::tr("Direction"), Texts::tr("Try"),     Texts::tr("Review"),  Texts::tr("Write")};
}

int stepIndex(const ChannelCalibration& calibration)
{
    const Step step = calibration.step();
    if (step == Step::Stopped) {
        return -1;
    }
    return static_cast<int>(step == Step::Done ? Step::Writing : step);
}

QString instruction(const ChannelCalibration& calibration)
{
    switch (calibration.step()) {
    case Step::Choose: {
        const QString begin = Texts::tr("Choose the channels to calibrate, switch the transmitter "
                                        "on, then start.");
        return calibration.outcomeText().isEmpty() ? begin
                                                   : calibration.outcomeText() + u' ' + begin;
    }
    case Step::Neutral:
        return calibration.canContinue()
            ? Texts::tr("The neutrals are found. Go on.")
            : Texts::tr("Let go of all sticks and levers, and hold still.");
    case Step::Returns:
        return calibration.isStepDone()
            ? Texts::tr("It is known how the sticks come back. Go on.")
            : Texts::tr("Move every stick and let it go, twice, best to both sides.");
    case Step::Extremes:
        return calibration.canContinue()
            ? Texts::tr("All ends are found. Go on, or move further.")
            : Texts::tr("Move every stick, lever and switch slowly to both ends, and hold it "
                        "there for a moment.");
    case Step::Direction:
        return directionInstruction(calibration);
    case Step::Verify:
        return calibration.isStepDone()
            ? Texts::tr("The new numbers do what they should. Go on.")
            : Texts::tr("Try the new numbers: move every stick to both ends, then let it go. "
                        "Nothing has been written yet.");
    case Step::Review:
        return Texts::tr("Compare the new numbers with those of before. Nothing has been written "
                         "yet.");
    case Step::Writing:
        return Texts::tr("Writing, and reading back what was written…");
    case Step::Done:
    case Step::Stopped:
        break;
    }
    return calibration.outcomeText();
}

QString nextText(const ChannelCalibration& calibration)
{
    switch (calibration.step()) {
    case Step::Choose:
        return Texts::tr("Start");
    case Step::Returns:
    case Step::Direction:
    case Step::Verify:
        return calibration.isStepDone() ? Texts::tr("Next") : Texts::tr("Skip");
    case Step::Neutral:
    case Step::Extremes:
        return Texts::tr("Next");
    case Step::Review:
    case Step::Writing:
        return Texts::tr("Write");
    case Step::Done:
        return Texts::tr("Finish");
    case Step::Stopped:
        break;
    }
    return Texts::tr("Start again");
}

Notice notice(const ChannelCalibration& calibration)
{
    const auto mode = calibration.mode();
    const Step step = calibration.step();
    if (!mode || step == Step::Done || step == Step::Stopped) {
        return {};
    }
    if (step == Step::Choose || !isSerial(*mode)) {
        return chooseNotice(calibration, *mode);
    }
    if (step == Step::Review) {
        return reviewNotice(calibration);
    }
    return {};
}

} // namespace trex::calibrationpages
