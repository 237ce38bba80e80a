// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "protocol/session/motionshaper.h"
#include "protocol/session/motorgate.h"
#include "protocol/session/openoptions.h"
#include "protocol/session/transaction.h"
#include "protocol/session/waitinglist.h"

#include <QTimer>

#include <memory>

namespace trex {

class LinkSampler;
class LinkThread;
struct RecordedState;
class StatusLatch;
class TelemetryStore;

/// One controller, as the panels and the command line see it. Main thread; the only object that
/// talks to the link thread. Every motor command passes its gate (driveMotor, driveBoth, stop).
class Controller : public QObject {
    Q_OBJECT
    Q_DISABLE_COPY_MOVE(Controller)
public:
    using ReplyHandler = WaitingList::Handler;
    /// `store` and `latch` may be null; they are filled before batchArrived(). With a latch, mode,
    /// control, learned channels and both latched bytes are polled all the time.
    Controller(TelemetryStore* store, StatusLatch* latch, QObject* parent = nullptr);
    ~Controller() override;
    void open(const OpenOptions& options);
    void close(); ///< stops the motors (stopOnClose) before; closed() follows in bounded time
    void closeQuietly(); ///< close(), but a line that does not answer is told nothing
    [[nodiscard]] LinkState state() const { return m_state; }
    [[nodiscard]] std::optional<Error> lastError() const { return m_lastError; }
    [[nodiscard]] const OpenOptions& options() const { return m_options; }
    [[nodiscard]] const LinkStats& stats() const { return m_stats; }
    [[nodiscard]] const LinkHealth& health() const { return m_health; } ///< four times a second
    void resetHealth(); ///< its figures count from now
    [[nodiscard]] const DeviceInfo& device() const { return m_device; }
    [[nodiscard]] Model model() const; ///< TReX Jr until a signature says otherwise
    /// Asks. The handler runs on the main thread, once, unless `context` dies before. Motor
    /// commands are refused here (BadCommand): they go through the gate below.
    void request(const Command& command, QObject* context, ReplyHandler handler);
    /// Bytes as given; waits for `replyBytes` (CRC byte not counted). Refused with Disarmed when
    /// the bytes hold a motor command and the gate is closed.
    void requestRaw(const QByteArray& bytes, int replyBytes, QObject* context, ReplyHandler then);
    /// What a panel wants polled, in Hz (0: nothing). Panels' wishes add up to the highest.
    void want(const QObject* who, PollId poll, double hertz);
    void wantNothing(const QObject* who);
    // The motor gate: nothing passes it but by driveMotor(), driveBoth(), requestRaw() and stop().
    [[nodiscard]] bool isArmed() const { return m_gate.isArmed(); }
    [[nodiscard]] const MotorGate& gate() const { return m_gate; } ///< why it is closed
    [[nodiscard]] Result<void> arm(); ///< errors: NotConnected, LockedOut (just after a stop)
    void disarm(); ///< stops, then closes the gate
    void disarm(DisarmReason reason, const QString& detail = {}); ///< when armed; kept and told
    /// Within the motion limits. Errors: Disarmed, OutOfRange, NotConnected, LockedOut. The
    /// handler, if any, is told when the packet has left (payload empty).
    Result<void> driveMotor(MotorId motor, const MotorOrder& order, QObject* context = {},
                            ReplyHandler handler = {});
    Result<void> driveBoth(const MotorOrder& motor1, const MotorOrder& motor2,
                           QObject* context = {}, ReplyHandler handler = {});
    enum class StopKind : std::uint8_t { Coast, Brake };
    /// Always allowed. Throws queued motor orders away, sends neutral (or full brake) to all three
    /// before anything else, disarms, and refuses motor orders for kStopLockout.
    void stop(StopKind kind = StopKind::Coast, QObject* context = {}, ReplyHandler handler = {});
    static constexpr std::chrono::milliseconds kStopLockout = MotorGate::kLockout;
    /// What was last ordered, within the limits, and what was last sent on the way to it.
    [[nodiscard]] MotorOrder lastOrder(MotorId motor) const { return m_gate.order(motor); }
    [[nodiscard]] MotorOrder sentOrder(MotorId motor) const { return m_shaper.sent(motor); }
    void setDisarmRules(const DisarmRules& rules) { m_gate.setRules(rules); }
    void setMotionLimits(const MotionLimits& limits);
    [[nodiscard]] const MotionShaper& shaper() const { return m_shaper; } ///< limits and ramps
    /// Nothing but stop is sent for so long; its timeout does not disarm. For the watchdog proof.
    void beSilentFor(std::chrono::milliseconds duration);
    void endSilence(); ///< the timeout disarms again
    [[nodiscard]] bool isSilent() const { return m_expectsTimeout; }
    [[nodiscard]] double stopLatencyMsMax() const { return m_gate.stopLatencyMsMax(); }
    void becomeRecording(); ///< for good: shows what was known then, reaches no line
    [[nodiscard]] bool isRecording() const { return m_isRecording; }
    void show(const RecordedState& state);
    void showRecords(const std::vector<TransactionRecord>& records, bool isAnew);
    void powerCycleSimulator(); ///< of `sim:`; nothing on any other port
    void noteRestart(const QString& evidence); ///< it was off, as this clause says: disarms
signals:
    void stateChanged(trex::LinkState state);
    void closed();
    void deviceChanged(); ///< signature, mode, control or learned channels
    void armedChanged(bool armed); ///< why: gate().lastDisarming()
    void lockedOut(); ///< a stop was asked: motor orders are refused for kStopLockout
    void stopped(); ///< the records say that all stop packets have been handed to the line
    void stopFailed(const QString& why); ///< they do not: what the motors do is not known
    void ordersChanged(); ///< lastOrder() or sentOrder() of some motor
    void batchArrived(); ///< store and latch hold new values; at most 60 times a second
    void recordsArrived(const std::vector<trex::TransactionRecord>& records);
    void recordsForgotten(); ///< those told before are no longer the past (a playhead jumped)
    void eventLogged(int severity, const QString& text); ///< 0 information, 1 warning, 2 error
    void restarted(); ///< it has been off, or may have: what waited for that is in force now
    void reconnected(); ///< connected again after a loss: whatever was read before may be old
private:
    void onBatch(const LinkBatch& batch);
    void onEvent(const LinkEvent& event);
    void onOutcome(const Outcome& outcome);
    void onSample(const PollSample& sample);
    void learnFrom(const Reply& reply);
    void setState(LinkState state, const std::optional<Error>& error);
    [[nodiscard]] std::vector<Transaction> stopPackets(StopKind kind);
    [[nodiscard]] std::vector<Transaction> closingPackets();
    void followMode(Mode mode);
    void drive(const ShapedOrders& orders, QObject* context, ReplyHandler then);
    void closeGate(DisarmReason reason, const QString& detail = {});
    void stopFor(const Disarming& why, StopKind kind, QObject* context, ReplyHandler handler);
    void stopEnded(const Result<Reply>& lastPacket);
    void guard(const PollSample& sample); ///< faults and stalls close the gate
    void rampDownFor(MotorId motor, double amperes);
    void watchMotion();
    [[nodiscard]] Result<void> mayDrive() const;
    void refuse(quint64 id, const Error& error); ///< from the event loop
    void sendWishes();
    void showOrders(const std::array<MotorOrder, 3>& orders);
    TelemetryStore* m_store;
    StatusLatch* m_latch;
    std::unique_ptr<LinkSampler> m_sampler; ///< none without a store
    std::unique_ptr<LinkThread> m_link;
    OpenOptions m_options;
    LinkState m_state = LinkState::Disconnected;
    std::optional<Error> m_lastError;
    LinkStats m_stats;
    LinkHealth m_health;
    DeviceInfo m_device;
    WaitingList m_waiting;
    QHash<const QObject*, std::array<double, kPollCount>> m_wishes;
    quint32 m_generation = 0;
    bool m_wasConnected = false;
    bool m_wasSilent = false; ///< the last loss was the controller's silence, not the port's end
    bool m_isClosing = false;
    bool m_expectsTimeout = false; ///< of a silence on purpose
    bool m_isRecording = false;
    std::optional<Mode> m_lastMode; ///< of this connection, kept over losses
    std::optional<OpenOptions> m_openNext; ///< asked for while closing
    MotorGate m_gate;
    MotionShaper m_shaper;
    QTimer m_motion; ///< runs while a ramp does
    QTimer m_alive; ///< tells the link thread that this one still works; looks for idleness
    QTimer m_stopPatience;
};

} // namespace trex
