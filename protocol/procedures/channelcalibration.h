// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "protocol/procedures/calibrationlearner.h"
#include "protocol/procedures/calibrationwriter.h"
#include "protocol/procedures/interruptionwatch.h"
#include "protocol/procedures/procedure.h"
#include "protocol/procedures/responsecurve.h"

namespace trex {

/// Guided calibration: the steps below, of which returns, direction and verify may be skipped. Main
/// thread. Fed with samples (StoreFeed, RequestFeed, a test), it moves no motor: it disarms at its
/// start, and arming ends it. Nothing is written before the review is left; each write is read
/// back, and what an interruption leaves in doubt is read when the controller is there again.
class ChannelCalibration : public Procedure {
    Q_OBJECT

public:
    // clang-format off
    enum class Step : std::uint8_t { Choose, Neutral, Returns, Extremes, Direction, Verify, Review, Writing, Done, Stopped };
    // clang-format on
    using WriteState = CalibrationWriter::State;

    ChannelCalibration(Controller& controller, DeviceSettings& settings, QObject* parent = nullptr);

    /// Bit n is channel n + 1. While choosing: what to calibrate; at the review: what to write, of
    /// those that were learned. Ignored in other steps.
    void setChannels(std::uint8_t mask);
    void setStillTime(Duration time) { m_stillTime = time; } ///< from the next start on
    void setOptionalSteps(bool offered) { m_hasOptional = offered; } ///< true unless told otherwise
    /// The person says that the motors have no power: in RC and analog mode the sticks move them.
    void setMotorPowerOff(bool off);
    /// Whether a channel's bit of 0x03 is to be set; from the direction step to the review.
    void setReversed(int channel, bool reversed);
    void selectDirection(int channel); ///< the channel to be pushed forward now, again if need be
    [[nodiscard]] InterruptionWatch& watch() { return m_watch; }

    void start() override; ///< leaves Choose: disarms, reads mode and present settings
    void cancel() override; ///< to Choose; while writing: stops behind the channel being written
    void next();
    void back();
    /// Leaves the extremes whatever was reached; the review then says what is missing.
    void finishExtremes();
    void feed(const PollSample& sample); ///< fresh samples of the raw channels
    void interrupt(const QString& sentence); ///< something outside makes it impossible to go on
    void undo(); ///< when canUndo(): puts the former values back, and reads them back

    [[nodiscard]] Step step() const { return m_step; }
    [[nodiscard]] QLatin1StringView stepKey() const; ///< "choose" …, never translated
    [[nodiscard]] std::uint8_t channels() const { return m_channels; }
    [[nodiscard]] bool isChosen(int channel) const { return isIn(m_channels, channel); }
    [[nodiscard]] bool isPreparing() const { return m_isPreparing; }
    [[nodiscard]] bool isCollecting() const; ///< wants samples
    [[nodiscard]] bool isStarved() const; ///< collecting, but no sample came for a second
    [[nodiscard]] bool canContinue() const { return whyNot().isEmpty(); }
    [[nodiscard]] QString whyNot() const; ///< why next() does nothing, as a sentence
    [[nodiscard]] bool isOptional() const; ///< this step may be skipped
    [[nodiscard]] bool isStepDone() const; ///< its work is done; an optional one is skipped else
    [[nodiscard]] bool canWrite() const; ///< serial mode, as far as is known
    [[nodiscard]] bool doSticksDrive() const; ///< RC or analog mode
    [[nodiscard]] bool isMotorPowerOff() const { return m_isMotorPowerOff; }
    [[nodiscard]] std::optional<Mode> mode() const { return m_controller.device().mode; }

    /// Of the run, or of the mode while choosing; RC when nothing is known.
    [[nodiscard]] InputKind input() const;
    [[nodiscard]] const CalibrationLearner* learner() const; ///< null while choosing
    [[nodiscard]] std::optional<Calibration> before(int channel) const;
    /// From the direction on, of the channels that were chosen.
    [[nodiscard]] const LearnedChannel* learned(int channel) const;
    /// What will be written: as learned, or the nearest that this controller is known to take.
    [[nodiscard]] std::optional<Calibration> planned(int channel) const;
    [[nodiscard]] bool isNearest(int channel) const;
    [[nodiscard]] WriteState writeState(int item) const { return m_writer.state(item); }
    [[nodiscard]] std::optional<Calibration> readBack(int channel) const; ///< after its write

    [[nodiscard]] static bool hasDirection(int channel) { return !isSwitchChannel(channel); }
    [[nodiscard]] int directionChannel() const { return m_directionChannel; } ///< 0: none left
    [[nodiscard]] std::optional<DirectionResult> direction(int channel) const;
    [[nodiscard]] bool isReversed(int channel) const { return isIn(m_reversed, channel); }
    [[nodiscard]] bool wasReversed(int channel) const;
    /// As the controller reads this channel; none while its settings are not known.
    [[nodiscard]] std::optional<ResponseCurve> curveBefore(int channel) const;
    [[nodiscard]] std::optional<ResponseCurve> curveAfter(int channel) const;
    [[nodiscard]] bool canUndo() const;
    [[nodiscard]] bool isReadingBack() const; ///< after an interruption
    [[nodiscard]] std::vector<Step> skipped() const; ///< optional steps whose work is not done
    [[nodiscard]] QString outcomeText() const { return m_outcome; } ///< of the last run

signals:
    void stepChanged();
    void updated(); ///< figures, countdown or reasons changed
    void noted(const QString& sentence); ///< after the end: what was read back, what was undone

private:
    void setStep(Step step);
    void readNumber(const ParameterRow& row, int run, const std::function<void(int)>& then);
    void readBefore(int channel, int run);
    void learn();
    void beginDirections();
    void followDirection();
    void beginVerify();
    void enter(Step step);
    [[nodiscard]] Step following(Step step) const;
    void write();
    void onWritten(const Result<void>& result);
    void onChecked();
    void onUndone(const Result<void>& result);
    void onState(LinkState state);
    void onDevice();
    void checkWhenThere();
    void forget();
    void stop(const Error& error, const QString& sentence);
    void end(Step step, const Result<void>& result);
    [[nodiscard]] QString neutralReason() const;
    [[nodiscard]] QString extremesReason() const;
    [[nodiscard]] QString reviewReason() const;
    [[nodiscard]] QString endReason() const;
    [[nodiscard]] static QString sticksDriveText();
    [[nodiscard]] std::uint8_t acceptable() const;
    [[nodiscard]] std::uint8_t changedDirections() const;
    [[nodiscard]] static bool isIn(int mask, int channel)
    {
        return (mask >> (channel - 1) & 1) != 0;
    }

    Controller& m_controller;
    DeviceSettings& m_settings;
    CalibrationWriter m_writer;
    InterruptionWatch m_watch;
    Step m_step = Step::Choose;
    std::uint8_t m_channels = kAllChannelsMask;
    std::uint8_t m_chosenBefore = kAllChannelsMask; ///< the choice, kept over the review's
    Duration m_stillTime = CalibrationLearner::kDefaultStillTime;
    std::optional<CalibrationLearner> m_learner;
    std::array<std::optional<LearnedChannel>, kChannelCount> m_learned;
    std::array<std::optional<DirectionResult>, kChannelCount> m_directions;
    int m_directionChannel = 0;
    std::uint8_t m_reversed = 0; ///< wanted
    std::uint8_t m_parabolic = 0; ///< as read
    bool m_hasOptional = true;
    bool m_isMotorPowerOff = false;
    bool m_isPreparing = false;
    bool m_isUndoing = false;
    int m_run = 0; ///< answers to an earlier run are ignored
    QString m_outcome;
    QString m_stopReason; ///< first part of the outcome, when it was stopped
};

} // namespace trex
