// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/calibration/calibrationpages.h"

#include "protocol/procedures/calibrationtext.h"

#include <QCoreApplication>

namespace trex::calibrationpages {
namespace {

using namespace std::chrono_literals;
using Step = ChannelCalibration::Step;
using WriteState = ChannelCalibration::WriteState;

constexpr auto kMovementShown = 1500ms; // as long as a person needs to read who moved

struct Texts {
    Q_DECLARE_TR_FUNCTIONS(Calibration)
};

ChannelState leftOut()
{
    return {StateShape::Off, Texts::tr("left as it is"), {}, {}};
}

ChannelState neutralState(const ChannelCalibration& calibration, const ChannelLearner& learner)
{
    if (learner.hasStillWindow()) {
        return {StateShape::Ok,
                Texts::tr("still"),
                readingText(learner.raw(), calibration.input()),
                {}};
    }
    const bool isMoving =
        learner.restarts() > 0 && learner.stillFor() < kMovementShown && learner.movedBy() != 0;
    if (isMoving) {
        return {StateShape::Warning,
                Texts::tr("moved"),
                Texts::tr("by %1").arg(spanText(std::abs(learner.movedBy()), calibration.input())),
                {}};
    }
    const auto left = std::max(Duration::zero(), learner.stillTime() - learner.stillFor());
    return {StateShape::Off,
            Texts::tr("waiting"),
            Texts::tr("%1 s more").arg(std::chrono::duration<double>(left).count(), 0, 'f', 1),
            {}};
}

QString sideText(int travel, int needed, InputKind input)
{
    return needed > 0
        ? Texts::tr("%1 of %2").arg(spanText(travel, input), spanText(travel + needed, input))
        : spanText(travel, input);
}

ChannelState extremesState(const ChannelCalibration& calibration, const ChannelLearner& learner)
{
    const InputKind input = calibration.input();
    const QString detail = Texts::tr("down %1 · up %2")
                               .arg(sideText(learner.lowTravel(), learner.lowNeeded(), input),
                                    sideText(learner.highTravel(), learner.highNeeded(), input));
    if (learner.areEndsSettled()) {
        return {StateShape::Ok, Texts::tr("done"), detail, {}};
    }
    const bool isReached = learner.lowNeeded() == 0 && learner.highNeeded() == 0;
    const bool hasMoved = learner.lowTravel() > 0 || learner.highTravel() > 0;
    return {StateShape::Off,
            isReached      ? Texts::tr("hold on")
                : hasMoved ? Texts::tr("moving")
                           : Texts::tr("waiting"),
            detail,
            {}};
}

ChannelState reviewState(const ChannelCalibration& calibration, int channel)
{
    const LearnedChannel* learned = calibration.learned(channel);
    if (learned == nullptr) {
        return leftOut();
    }
    const StateShape shape = learned->verdict == Verdict::Good ? StateShape::Ok
        : learned->verdict == Verdict::Usable                  ? StateShape::Warning
                                                               : StateShape::Fault;
    return {shape, verdictText(learned->verdict), reasonText(*learned, calibration.input()),
            figuresText(*learned, calibration.input())};
}

ChannelState writtenState(const ChannelCalibration& calibration, int channel)
{
    switch (calibration.writeState(channel)) {
    case WriteState::Untouched:
        break;
    case WriteState::Unchanged:
        return {StateShape::Ok, Texts::tr("already so"), {}, {}};
    case WriteState::Writing:
        return {StateShape::Off, Texts::tr("writing…"), {}, {}};
    case WriteState::Written:
        return {StateShape::Ok, Texts::tr("written"), Texts::tr("Read back as written."), {}};
    case WriteState::NearestWritten:
        return {StateShape::Warning,
                Texts::tr("nearest"),
                Texts::tr("The nearest values that this controller can take."),
                {}};
    case WriteState::Failed:
        return {StateShape::Fault, Texts::tr("failed"), {}, {}};
    }
    const bool isWaiting = calibration.step() == Step::Writing && calibration.isChosen(channel);
    return isWaiting ? ChannelState{StateShape::Off, Texts::tr("waiting"), {}, {}}
                     : ChannelState{StateShape::Off, Texts::tr("as before"), {}, {}};
}

} // namespace

QStringList stepTitles()
{
    return {Texts::tr("Choose"), Texts::tr("Neutral"), Texts::tr("Ends"), Texts::tr("Review"),
            Texts::tr("Write")};
}

int stepIndex(const ChannelCalibration& calibration)
{
    switch (calibration.step()) {
    case Step::Choose:
        return 0;
    case Step::Neutral:
        return 1;
    case Step::Extremes:
        return 2;
    case Step::Review:
        return 3;
    case Step::Writing:
    case Step::Done:
        return 4;
    case Step::Stopped:
        break;
    }
    return -1;
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
    case Step::Extremes:
        return calibration.canContinue()
            ? Texts::tr("All ends are found. Go on, or move further.")
            : Texts::tr("Move every stick, lever and switch slowly to both ends, and hold it "
                        "there for a moment.");
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
    const bool isOver = calibration.step() == Step::Done || calibration.step() == Step::Stopped;
    if (!mode || isOver) {
        return {};
    }
    if (!isSerial(*mode)) {
        const QString name = *mode == Mode::Rc ? Texts::tr("RC") : Texts::tr("analog");
        return {StateShape::Warning,
                Texts::tr("%1 mode: the sticks move the motors, and nothing can be written. Better "
                          "use serial mode: power off, mode jumper off, power on.")
                    .arg(name)};
    }
    if (calibration.step() != Step::Choose) {
        return {};
    }
    return {StateShape::Ok,
            *mode == Mode::SerialRc
                ? Texts::tr("Serial mode: the sticks do not move the motors. The RC calibration is "
                            "set; the analog one stays.")
                : Texts::tr("Serial mode: the sticks do not move the motors. The analog "
                            "calibration is set; the RC one stays.")};
}

ChannelState channelState(const ChannelCalibration& calibration, int channel)
{
    const CalibrationLearner* learner = calibration.learner();
    switch (calibration.step()) {
    case Step::Choose:
        return calibration.isChosen(channel)
            ? ChannelState{StateShape::Ok, Texts::tr("chosen"), {}, {}}
            : leftOut();
    case Step::Neutral:
    case Step::Extremes: {
        if (!calibration.isChosen(channel)) {
            return leftOut();
        }
        const ChannelLearner& own = learner->channel(channel);
        if (calibration.isStarved()) {
            return {StateShape::Stale, Texts::tr("no readings"), {}, {}};
        }
        if (!own.isValid()) {
            return {StateShape::Warning,
                    calibration.input() == InputKind::Rc ? Texts::tr("no pulse")
                                                         : Texts::tr("no reading"),
                    {},
                    {}};
        }
        return calibration.step() == Step::Neutral ? neutralState(calibration, own)
                                                   : extremesState(calibration, own);
    }
    case Step::Review:
        return reviewState(calibration, channel);
    case Step::Writing:
    case Step::Done:
    case Step::Stopped:
        break;
    }
    return writtenState(calibration, channel);
}

} // namespace trex::calibrationpages
