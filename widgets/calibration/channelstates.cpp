// SPDX-License-Identifier: GPL-3.0-or-later
// What the wizard says of each channel, page by page.
#include "protocol/procedures/calibrationtext.h"
#include "widgets/calibration/calibrationpages.h"

namespace trex::calibrationpages {
namespace {

using namespace std::chrono_literals;
using namespace Qt::Literals::StringLiterals;
using Step = ChannelCalibration::Step;
using WriteState = ChannelCalibration::WriteState;

constexpr auto kMovementShown = 1500ms; // as long as a person needs to read who moved

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
                Texts::tr("by %1: the countdown starts again")
                    .arg(spanText(std::abs(learner.movedBy()), calibration.input())),
                {}};
    }
    const auto left = std::max(Duration::zero(), learner.stillTime() - learner.stillFor());
    return {StateShape::Off,
            Texts::tr("waiting"),
            Texts::tr("%1 s more").arg(std::chrono::duration<double>(left).count(), 0, 'f', 1),
            {}};
}

ChannelState returnsState(const ChannelCalibration& calibration, int channel)
{
    const CalibrationLearner& learner = *calibration.learner();
    const int seen = learner.returnsSeen(channel);
    const bool isDone = seen >= CalibrationLearner::kReturnsNeeded;
    QString detail;
    if (seen > 0) {
        detail = Texts::tr("comes back within %1")
                     .arg(spanText(learner.result(channel).repeatability, calibration.input()));
    } else if (mayRestAtEnd(channel)) {
        detail = Texts::tr("levers and switches need not");
    }
    switch (learner.returnState(channel)) {
    case ReturnState::Away:
        return {StateShape::Off, Texts::tr("let it go"), detail, {}};
    case ReturnState::Settling:
        return {StateShape::Off, Texts::tr("coming back"), detail, {}};
    case ReturnState::Rest:
        break;
    }
    return {isDone ? StateShape::Ok : StateShape::Off,
            Texts::tr("%1 of %2").arg(seen).arg(CalibrationLearner::kReturnsNeeded),
            detail,
            {}};
}

QString sideText(int travel, int needed, InputKind input)
{
    return needed > 0
        ? Texts::tr("%1, need %2").arg(spanText(travel, input), spanText(travel + needed, input))
        : spanText(travel, input);
}

ChannelState extremesState(const ChannelCalibration& calibration, const ChannelLearner& learner)
{
    const InputKind input = calibration.input();
    const QString detail = Texts::tr("down %1\nup %2")
                               .arg(sideText(learner.lowTravel(), learner.lowNeeded(), input),
                                    sideText(learner.highTravel(), learner.highNeeded(), input));
    if (learner.areEndsSettled()) {
        return {StateShape::Ok, Texts::tr("done"), detail, {}};
    }
    const bool isReached = learner.lowNeeded() == 0 && learner.highNeeded() == 0;
    const int least = calibrationRules(input).neededTravel / 10; // less is noise
    const bool hasMoved = std::max(learner.lowTravel(), learner.highTravel()) >= least;
    return {StateShape::Off,
            learner.areEndsVague() ? Texts::tr("hold longer")
                : isReached        ? Texts::tr("hold on")
                : hasMoved         ? Texts::tr("moving")
                                   : Texts::tr("waiting"),
            detail,
            {}};
}

ChannelState switchState(const ChannelCalibration& calibration, int channel, int raw)
{
    const LearnedChannel& learned = *calibration.learned(channel);
    const auto curve = calibration.curveAfter(channel);
    if (!curve || !learned.switchThreshold) {
        return {StateShape::Off, Texts::tr("no threshold"), {}, {}};
    }
    const QString guess = Texts::tr("≈: how these channels switch is not published; this is a "
                                    "guess.");
    const QString on = channel == 5 ? Texts::tr("≈ serial override on") : Texts::tr("≈ flip on");
    const QString where = Texts::tr("≈ on at %1 and below")
                              .arg(readingText(*learned.switchThreshold, calibration.input()));
    const bool isOn = curve->isSwitchedOn(raw);
    if (learned.has(Finding::SwitchOnAtNeutral)) {
        return {StateShape::Warning, isOn ? on : Texts::tr("≈ off"),
                findingText(Finding::SwitchOnAtNeutral, learned, calibration.input()), guess};
    }
    return {StateShape::Ok, isOn ? on : Texts::tr("≈ off"), where, guess};
}

ChannelState directionState(const ChannelCalibration& calibration, int channel, int raw)
{
    const LearnedChannel* learned = calibration.learned(channel);
    if (learned == nullptr || learned->verdict == Verdict::DoAgain) {
        return {StateShape::Fault,
                Texts::tr("do again"),
                learned != nullptr ? reasonText(*learned, calibration.input()) : QString(),
                {}};
    }
    if (!ChannelCalibration::hasDirection(channel)) {
        return switchState(calibration, channel, raw);
    }
    if (channel == calibration.directionChannel()) {
        return calibration.learner()->isDirectionReady()
            ? ChannelState{StateShape::Off, Texts::tr("push forward"), {}, {}}
            : ChannelState{StateShape::Off, Texts::tr("let it go"), {}, {}};
    }
    const auto result = calibration.direction(channel);
    if (!result) {
        return {StateShape::Off, Texts::tr("waiting"), {}, {}};
    }
    if (result->isSwapped()) {
        return {StateShape::Warning,
                Texts::tr("channel %1 moved").arg(result->movedChannel),
                Texts::tr("Channels %1 and %2 are swapped: exchange their plugs, or choose the "
                          "other stick in the transmitter.")
                    .arg(std::min(channel, result->movedChannel))
                    .arg(std::max(channel, result->movedChannel)),
                {}};
    }
    // What parameter 0x03 has to say is seen in the box beside.
    return result->isReversed()
        ? ChannelState{StateShape::Warning,
                       Texts::tr("runs backwards"),
                       Texts::tr("Its readings fall when it is pushed forward."),
                       {}}
        : ChannelState{StateShape::Ok,
                       Texts::tr("runs forward"),
                       Texts::tr("Its readings rise when it is pushed forward."),
                       {}};
}

ChannelState verifyState(const ChannelCalibration& calibration, int channel, int raw)
{
    const ChannelVerifier* verifier = calibration.learner()->verified(channel);
    if (verifier == nullptr) {
        return {StateShape::Fault, Texts::tr("do again"), {}, {}};
    }
    const QString about = verifier->curve().parabolic ? u"≈ "_s : QString();
    const auto& before = verifier->curveBefore();
    QString detail = Texts::tr("%1 → %2 new")
                         .arg(readingText(raw, calibration.input()),
                              about + remappedText(verifier->curve().remap(raw)));
    QString reached =
        Texts::tr("ends %1 / %2")
            .arg(remappedText(verifier->now().lowest), remappedText(verifier->now().highest));
    if (before) {
        detail += Texts::tr(", %1 before").arg(about + remappedText(before->remap(raw)));
        reached += Texts::tr(", before %1 / %2")
                       .arg(remappedText(verifier->before().lowest),
                            remappedText(verifier->before().highest));
    }
    if (verifier->isConfirmed()) {
        return {StateShape::Ok, Texts::tr("confirmed"), detail + u'\n' + reached, {}};
    }
    const bool areEndsDone = verifier->isLowFull() && verifier->isHighFull();
    return {StateShape::Off,
            areEndsDone ? Texts::tr("let it go") : Texts::tr("move it"),
            detail + u'\n' + reached,
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
    const QString reason = reasonText(*learned, calibration.input());
    const QString figures = confidence(calibration, channel);
    if (learned->verdict == Verdict::DoAgain) {
        return {shape, verdictText(learned->verdict), reason, figures};
    }
    const QString summary = Texts::tr("%1 samples, %2 % missed, σ %3, symmetry %4 %")
                                .arg(learned->samples)
                                .arg(learned->missedShare() * 100.0, 0, 'f', 1)
                                .arg(spanText(learned->sigma, calibration.input()))
                                .arg(learned->symmetry() * 100.0, 0, 'f', 0);
    return {shape, verdictText(learned->verdict), reason + u'\n' + summary, figures};
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
                Texts::tr("The nearest values that this controller can take, read back; the "
                          "deadband covers the difference at neutral."),
                {}};
    case WriteState::Refused:
        return {StateShape::Fault, Texts::tr("refused"), Texts::tr("Keeps its old values."), {}};
    case WriteState::Failed:
        return {StateShape::Fault,
                Texts::tr("failed"),
                Texts::tr("Old or new values: it is read when the controller is there again."),
                {}};
    case WriteState::HoldsNew:
        return {StateShape::Ok, Texts::tr("new values"), Texts::tr("Read back."), {}};
    case WriteState::HoldsOld:
        return {StateShape::Ok, Texts::tr("old values"), Texts::tr("Read back."), {}};
    case WriteState::HoldsOther:
        return {StateShape::Fault,
                Texts::tr("other values"),
                Texts::tr("Neither the old nor the new ones."),
                {}};
    case WriteState::Restored:
        return {StateShape::Ok, Texts::tr("as before"), Texts::tr("Put back, and read back."), {}};
    case WriteState::NearestRestored:
        return {StateShape::Warning,
                Texts::tr("nearest"),
                Texts::tr("The nearest to its former values that this controller can take."),
                {}};
    }
    const bool isWaiting = calibration.step() == Step::Writing && calibration.isChosen(channel);
    return isWaiting ? ChannelState{StateShape::Off, Texts::tr("waiting"), {}, {}}
                     : ChannelState{StateShape::Off, Texts::tr("as before"), {}, {}};
}

ChannelState collectingState(const ChannelCalibration& calibration, int channel,
                             std::optional<int> raw)
{
    if (!calibration.isChosen(channel)) {
        return leftOut();
    }
    const ChannelLearner& own = calibration.learner()->channel(channel);
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
    switch (calibration.step()) {
    case Step::Neutral:
        return neutralState(calibration, own);
    case Step::Returns:
        return returnsState(calibration, channel);
    case Step::Extremes:
        return extremesState(calibration, own);
    case Step::Direction:
        return directionState(calibration, channel, raw.value_or(own.raw()));
    default:
        return verifyState(calibration, channel, raw.value_or(own.raw()));
    }
}

} // namespace

QString remappedText(int remapped)
{
    return remapped > 0 ? u"+%1"_s.arg(remapped) : remapped < 0 ? u"−%1"_s.arg(-remapped) : u"0"_s;
}

QString confidence(const ChannelCalibration& calibration, int channel)
{
    const LearnedChannel* learned = calibration.learned(channel);
    return learned != nullptr ? figuresText(*learned, calibration.input()) : QString();
}

ChannelState channelState(const ChannelCalibration& calibration, int channel,
                          std::optional<int> raw)
{
    switch (calibration.step()) {
    case Step::Choose:
        return calibration.isChosen(channel)
            ? ChannelState{StateShape::Ok, Texts::tr("chosen"), {}, {}}
            : leftOut();
    case Step::Review:
        return reviewState(calibration, channel);
    case Step::Writing:
    case Step::Done:
    case Step::Stopped:
        return writtenState(calibration, channel);
    default:
        return collectingState(calibration, channel, raw);
    }
}

} // namespace trex::calibrationpages
