// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "protocol/procedures/procedure.h"
#include "protocol/session/controller.h"

#include <QTimer>

namespace trex {

class DeviceSettings;

/// What the watchdog proof found. Times are silences on the line, from the last byte sent before to
/// the first one after.
struct WatchdogVerdict {
    bool isPassed = false;
    std::chrono::milliseconds configured{0}; ///< the serial timeout as read; 0: off
    double survivedMs = 0.0; ///< the longest silence that the motor ran through
    double stoppedMs = 0.0; ///< the shortest that stopped it; 0: none did
    double amperes = 0.0; ///< while it ran
    bool isLatched = true; ///< each stop has latched the timeout bit
    bool isCurrentSeen = false; ///< the current was high enough to see it collapse
    QString sentence; ///< all of it, for the log
};

/// Proves on purpose that the controller stops a motor when it hears nothing any more: turns one
/// motor slowly, falls silent, and looks afterwards whether the current is gone and the timeout bit
/// latched. While it is silent nobody can look, so the moment is narrowed down by silences of
/// several lengths. The gate has to be open; whatever happens, it ends in a stop.
class WatchdogProof : public Procedure {
    Q_OBJECT

public:
    struct Options {
        MotorId motor = MotorId::Motor1;
        int speed = 25; ///< low, yet some counts of current
    };
    WatchdogProof(Controller& controller, DeviceSettings& settings, const Options& options,
                  QObject* parent = nullptr);

    void start() override; ///< ends at once with Disarmed when the gate is closed
    void cancel() override;
    [[nodiscard]] const WatchdogVerdict& verdict() const { return m_verdict; }
    /// Longest time that a proof of this timeout takes, for the person who waits.
    [[nodiscard]] static std::chrono::milliseconds duration(std::chrono::milliseconds timeout);

private:
    void onTimeoutRead(const Result<int>& raw);
    void spin(); ///< turns the motor and waits until its current has settled
    void measureRunning();
    void beSilent();
    void look();
    void judge(const Reply& currents, bool isLatched);
    void next();
    void conclude(bool isPassed, const QString& why);
    void end(const Result<void>& result);
    void onRecords(const std::vector<TransactionRecord>& records);
    [[nodiscard]] bool hasOnlyOurOrders() const;
    [[nodiscard]] double countsOf(const Reply& currents) const;
    void ask(std::string_view query, const std::function<void(const Reply&)>& then);

    Controller& m_controller;
    DeviceSettings& m_settings;
    Options m_options;
    WatchdogVerdict m_verdict;
    QTimer m_wait;
    double m_silenceMs = 0.0; ///< of the trial under way
    double m_measuredMs = 0.0; ///< as the records say
    double m_running = 0.0; ///< counts of current before the silence
    bool m_sawTimeout = false; ///< some poll has read (and so cleared) the bit
    bool m_isWatching = false; ///< the records of a trial count
    bool m_hasSpun = false; ///< other orders than ours are somebody else's
    bool m_isEnding = false;
    std::optional<Instant> m_lastByte; ///< sent before the silence
    int m_trial = 0;
};

} // namespace trex
