// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "protocol/session/floodguard.h"
#include "protocol/session/linkengine.h"
#include "protocol/transport/transport.h"

#include <QObject>
#include <QTimer>

#include <memory>

namespace trex {

struct OpenOptions;

/// Drives one LinkEngine over one Transport. Lives on the link thread; the façade posts calls to
/// it, and batchReady() is the only thing that comes back.
class LinkWorker : public QObject {
    Q_OBJECT
    Q_DISABLE_COPY_MOVE(LinkWorker)

public:
    LinkWorker();
    ~LinkWorker() override;

    void open(const OpenOptions& options, quint32 generation);
    void submit(const Transaction& transaction);
    void stop(const std::vector<Transaction>& packets);
    void setWishes(const PollWishes& wishes);
    /// Sends `packets`, waits until they have left (bounded), closes the port.
    void close(const std::vector<Transaction>& packets);
    void powerCycle(); ///< the simulator only
    void resetHealth();
    /// The façade's gate is open. While it is, a main thread that does not send heartbeats for
    /// kLongestFreeze is taken for frozen: the motors are stopped and frozen() is told.
    void setArmed(bool armed);
    void heartbeat() { m_lastHeartbeat = std::chrono::steady_clock::now(); }
    /// Sends nothing but stop packets for so long; zero ends it.
    void beSilentFor(std::chrono::milliseconds duration);
    static constexpr std::chrono::milliseconds kHeartbeat{200};
    static constexpr std::chrono::milliseconds kLongestFreeze{2000};

signals:
    void frozen(quint32 generation);
    void batchReady(const trex::LinkBatch& batch);
    void closed(quint32 generation);

private:
    void pump();
    void schedulePump();
    bool step(); ///< one action of the engine; false: nothing to do now
    void waitForReply();
    void sendRest();
    void send(const LinkEngine::Action& action);
    void openTransport();
    void closeTransport();
    void onReceived(const QByteArray& bytes, Instant at);
    void onFailed(const Error& error);
    void publish(bool always);
    [[nodiscard]] Instant clockNow() const; ///< the transport's
    void lookForFreeze();
    void refuse(const Transaction& transaction);
    void followState();
    void withdrawLastStop();
    [[nodiscard]] QByteArray stopBytes() const;
    void cutOff();

    std::unique_ptr<Transport> m_transport;
    QString m_address;
    std::unique_ptr<LinkEngine> m_engine;
    FloodGuard m_flood;
    LineSettings m_line;
    PollWishes m_wishes{};
    quint32 m_generation = 0;
    bool m_reconnect = true;
    bool m_isOpen = false;
    bool m_isPumping = false;
    bool m_isPumpPosted = false;
    QTimer m_wake;
    QTimer m_reopen;
    QTimer m_publish;
    QTimer m_freeze; ///< runs while armed
    Instant m_lastPublished;
    Instant m_lastHeartbeat;
    Instant m_silentUntil;
    bool m_isArmed = false;
    bool m_stopOnClose = true;
    bool m_hasLastStop = false;
};

} // namespace trex
