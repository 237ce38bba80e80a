// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "protocol/session/openoptions.h"
#include "protocol/session/transaction.h"

#include <QHash>
#include <QObject>
#include <QPointer>
#include <QTimer>

#include <functional>
#include <memory>

namespace trex {

class LinkSampler;
class LinkThread;
class StatusLatch;
class TelemetryStore;

/// One controller, as the panels and the command line see it. Lives on the main thread; the only
/// object that talks to the link thread. Every motor command of every panel and verb passes its
/// gate (driveMotor, driveBoth, stop).
class Controller : public QObject {
    Q_OBJECT
    Q_DISABLE_COPY_MOVE(Controller)

public:
    using ReplyHandler = std::function<void(Result<Reply>)>;

    /// `store` and `latch` may be null; they are filled before batchArrived(). With a latch, mode,
    /// control, learned channels and both latched bytes are polled all the time.
    Controller(TelemetryStore* store, StatusLatch* latch, QObject* parent = nullptr);
    ~Controller() override;

    void open(const OpenOptions& options);
    /// Stops the motors (stopOnClose), then closes; closed() follows within a bounded time.
    void close();
    void closeQuietly(); ///< close(), but a line that does not answer is told nothing

    [[nodiscard]] LinkState state() const { return m_state; }
    [[nodiscard]] std::optional<Error> lastError() const { return m_lastError; }
    [[nodiscard]] const OpenOptions& options() const { return m_options; }
    [[nodiscard]] const LinkStats& stats() const { return m_stats; }
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

    // The motor gate.
    [[nodiscard]] bool isArmed() const { return m_armed; }
    /// Errors: NotConnected, LockedOut (just after a stop).
    [[nodiscard]] Result<void> arm();
    void disarm(); ///< stops, then closes the gate
    /// Errors: Disarmed, OutOfRange, NotConnected, LockedOut. The handler, if any, is told when the
    /// packet has left (payload empty).
    Result<void> driveMotor(MotorId motor, const MotorOrder& order, QObject* context = {},
                            ReplyHandler handler = {});
    Result<void> driveBoth(const MotorOrder& motor1, const MotorOrder& motor2,
                           QObject* context = {}, ReplyHandler handler = {});
    enum class StopKind : std::uint8_t { Coast, Brake };
    /// Always allowed. Throws queued motor orders away, sends neutral (or full brake) to all three
    /// before anything else, disarms, and refuses motor orders for kStopLockout.
    void stop(StopKind kind = StopKind::Coast, QObject* context = {}, ReplyHandler handler = {});
    static constexpr std::chrono::milliseconds kStopLockout{500};
    /// What was last sent to the motors (signed speeds, aux 0 to 127), for display beside sliders.
    [[nodiscard]] MotorOrder lastOrder(MotorId motor) const;
    /// Longest from a stop request to its last byte on the line, this connection.
    [[nodiscard]] double stopLatencyMsMax() const { return m_stopLatencyMsMax; }

    void powerCycleSimulator(); ///< of `sim:`; nothing on any other port
    /// It has been off, as the evidence (a clause for the log) says: disarms, then restarted().
    void noteRestart(const QString& evidence);

signals:
    void stateChanged(trex::LinkState state);
    void closed();
    void deviceChanged(); ///< signature, mode, control or learned channels
    void armedChanged(bool armed);
    void lockedOut(); ///< a stop was asked: motor orders are refused for kStopLockout
    void stopped(); ///< stop packets have been handed to the line
    void ordersChanged(); ///< lastOrder() of some motor
    void batchArrived(); ///< store and latch hold new values; at most 60 times a second
    void recordsArrived(const std::vector<trex::TransactionRecord>& records);
    /// A plain sentence for the log. `severity`: 0 information, 1 warning, 2 error.
    void eventLogged(int severity, const QString& text);
    void restarted(); ///< it has been off, or may have: what waited for that is in force now
    void reconnected(); ///< connected again after a loss: whatever was read before may be old

private:
    void onBatch(const LinkBatch& batch);
    void onEvent(const LinkEvent& event);
    void onOutcome(const Outcome& outcome);
    void onSample(const PollSample& sample);
    void learnFrom(const Reply& reply);
    void setState(LinkState state, const std::optional<Error>& error);
    [[nodiscard]] QString stateSentence(LinkState state, const std::optional<Error>& error) const;
    [[nodiscard]] std::vector<Transaction> stopPackets(StopKind kind);
    [[nodiscard]] std::vector<Transaction> closingPackets();
    void followMode(Mode mode);
    Result<void> order(const Result<Command>& command, QObject* context, ReplyHandler handler);
    void setArmed(bool armed);
    [[nodiscard]] Result<void> gate() const;
    quint64 enlist(QObject* context, ReplyHandler handler);
    void answer(quint64 id, const Result<Reply>& reply);
    void failPending(const Error& error);
    void sendWishes();

    struct Waiting {
        QPointer<QObject> context;
        bool hasContext = false;
        ReplyHandler handler;
    };
    TelemetryStore* m_store;
    StatusLatch* m_latch;
    std::unique_ptr<LinkSampler> m_sampler; ///< none without a store
    std::unique_ptr<LinkThread> m_link;
    OpenOptions m_options;
    LinkState m_state = LinkState::Disconnected;
    std::optional<Error> m_lastError;
    LinkStats m_stats;
    DeviceInfo m_device;
    QHash<quint64, Waiting> m_waiting;
    QHash<const QObject*, std::array<double, kPollCount>> m_wishes;
    quint64 m_nextId = 1;
    quint32 m_generation = 0;
    bool m_armed = false;
    bool m_wasConnected = false;
    bool m_wasSilent = false; ///< the last loss was the controller's silence, not the port's end
    bool m_isClosing = false;
    std::optional<Mode> m_lastMode; ///< of this connection, kept over losses
    std::optional<OpenOptions> m_openNext; ///< asked for while closing
    quint64 m_stopId = 0; ///< last packet of the latest stop
    Instant m_stopAsked;
    std::array<MotorOrder, 3> m_orders{};
    std::optional<Instant> m_lockedUntil;
    double m_stopLatencyMsMax = 0.0;
};

} // namespace trex
