// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "protocol/procedures/calibrationlearner.h"
#include "protocol/procedures/procedure.h"
#include "protocol/session/devicesettings.h"

#include <QElapsedTimer>
#include <QTimer>

namespace trex {

/// Guided calibration: choose → neutral → extremes → review → writing → done, or stopped with a
/// sentence. Main thread. It is fed with samples (StoreFeed, RequestFeed, a test) and moves no
/// motor: it disarms at its start, and arming ends it. Nothing is written before the review is
/// left; each write is read back.
class ChannelCalibration : public Procedure {
    Q_OBJECT

public:
    enum class Step : std::uint8_t { Choose, Neutral, Extremes, Review, Writing, Done, Stopped };
    enum class WriteState : std::uint8_t {
        Untouched,
        Unchanged, ///< the controller held these values already
        Writing,
        Written, ///< and read back as asked
        NearestWritten, ///< the controller cannot hold them; the nearest it can (C-35)
        Failed,
    };

    ChannelCalibration(Controller& controller, DeviceSettings& settings, QObject* parent = nullptr);

    /// Bit n is channel n + 1. While choosing: what to calibrate; at the review: what to write, of
    /// those that were learned. Ignored in other steps.
    void setChannels(std::uint8_t mask);
    void setStillTime(Duration time) { m_stillTime = time; } ///< from the next start on
    [[nodiscard]] std::uint8_t channels() const { return m_channels; }
    [[nodiscard]] bool isChosen(int channel) const
    {
        return (m_channels >> (channel - 1) & 1) != 0;
    }

    void start() override; ///< leaves Choose: disarms, reads mode and present calibrations
    void cancel() override; ///< to Choose; while writing: stops behind the channel being written
    void next();
    void back();
    /// Leaves the extremes whatever was reached; the review then says what is missing.
    void finishExtremes();
    void feed(const PollSample& sample); ///< fresh samples of the raw channels

    [[nodiscard]] Step step() const { return m_step; }
    [[nodiscard]] QLatin1StringView stepKey() const; ///< "choose" …, never translated
    [[nodiscard]] bool isPreparing() const { return m_isPreparing; }
    [[nodiscard]] bool isCollecting() const; ///< wants samples
    [[nodiscard]] bool isStarved() const; ///< collecting, but no sample came for a second
    [[nodiscard]] bool canContinue() const { return whyNot().isEmpty(); }
    [[nodiscard]] QString whyNot() const; ///< why next() does nothing, as a sentence
    [[nodiscard]] bool canWrite() const; ///< serial mode, as far as is known
    [[nodiscard]] std::optional<Mode> mode() const { return m_controller.device().mode; }

    /// Of the run, or of the mode while choosing; RC when nothing is known.
    [[nodiscard]] InputKind input() const;
    [[nodiscard]] const CalibrationLearner* learner() const; ///< null while choosing
    [[nodiscard]] std::optional<Calibration> before(int channel) const;
    /// From the review on, of the channels that were chosen.
    [[nodiscard]] const LearnedChannel* learned(int channel) const;
    [[nodiscard]] WriteState writeState(int channel) const;
    [[nodiscard]] std::optional<Calibration> readBack(int channel) const; ///< after its write
    [[nodiscard]] QString outcomeText() const { return m_outcome; } ///< of the last run

signals:
    void stepChanged();
    void updated(); ///< figures, countdown or reasons changed

private:
    struct Channel {
        std::optional<Calibration> before;
        std::optional<LearnedChannel> learned;
        WriteState state = WriteState::Untouched;
        std::optional<Calibration> readBack;
    };
    void setStep(Step step);
    void readBefore(int channel, int run);
    void beginNeutral();
    void review();
    void write();
    void writeNext(int channel, int run);
    void onWritten(int channel, int run, const Result<DeviceSettings::CalibrationWrite>& result);
    void onState(LinkState state);
    void onDevice();
    void stop(const Error& error, const QString& sentence);
    void end(Step step, const Result<void>& result);
    [[nodiscard]] QString neutralReason() const;
    [[nodiscard]] QString extremesReason() const;
    [[nodiscard]] QString reviewReason() const;
    [[nodiscard]] QString writtenText(const Error& error) const;
    [[nodiscard]] std::uint8_t maskOf(WriteState state) const;
    [[nodiscard]] std::uint8_t acceptable() const;
    [[nodiscard]] Channel& at(int channel)
    {
        return m_data.at(static_cast<std::size_t>(channel - 1));
    }
    [[nodiscard]] const Channel& at(int channel) const
    {
        return m_data.at(static_cast<std::size_t>(channel - 1));
    }

    Controller& m_controller;
    DeviceSettings& m_settings;
    Step m_step = Step::Choose;
    std::uint8_t m_channels = kAllChannelsMask;
    std::uint8_t m_chosenBefore = kAllChannelsMask; ///< the choice, kept over the review's
    Duration m_stillTime = CalibrationLearner::kDefaultStillTime;
    std::optional<CalibrationLearner> m_learner;
    std::array<Channel, kChannelCount> m_data;
    bool m_isPreparing = false;
    bool m_isCancelAsked = false;
    int m_run = 0; ///< answers to an earlier run are ignored
    QString m_outcome;
    QTimer m_watch;
    QElapsedTimer m_sinceSample;
};

} // namespace trex
