// SPDX-License-Identifier: GPL-3.0-or-later
// Serves a simulated line to other programs, on a pseudo-terminal, on TCP or on both, in real time.
#pragma once

#include "protocol/sim/precisetimer.h"
#include "protocol/sim/ptyport.h"
#include "protocol/sim/simlog.h"
#include "protocol/sim/simulatedline.h"

#include <QObject>

#include <memory>

class QSocketNotifier;
class QTcpServer;
class QTcpSocket;

namespace trex::sim {

/// Lives on a thread with an event loop; never blocks. Its end removes the link, closes the ports
/// and writes the state file.
class SimServer : public QObject {
    Q_OBJECT
    Q_DISABLE_COPY_MOVE(SimServer)
public:
    /// Virtual time begins now and runs options.speed times as fast as the clock on the wall.
    explicit SimServer(const SimOptions& options, QObject* parent = nullptr);
    ~SimServer() override;

    /// A log of packets and motor outputs (simlog.h). Before start(). FileUnwritable.
    [[nodiscard]] Result<void> setLogFile(const QString& path);
    /// Opens a pseudo-terminal with a link of this name; without a name there is no link and
    /// ready() names the device. PortFailed with a sentence.
    [[nodiscard]] Result<void> listenPty(const QString& link);
    /// On this computer only unless `address` says otherwise; 0 takes a free port. One client at a
    /// time, a second is closed at once. OutOfRange: no such address; PortFailed with a sentence.
    [[nodiscard]] Result<void> listenTcp(quint16 port, const QString& address = {});
    [[nodiscard]] static bool isAddress(const QString& text); ///< "0.0.0.0", "::1"
    [[nodiscard]] quint16 tcpPort() const { return m_tcpPort; }
    [[nodiscard]] bool servesOthers() const; ///< other computers can reach it
    /// The state file that was to be read makes no sense (or cannot be read): say so and give up.
    [[nodiscard]] const std::optional<Error>& stateError() const { return m_line.stateError(); }

    void powerCycle(); ///< all controllers
    [[nodiscard]] SimulatedLine& line() { return m_line; }
    [[nodiscard]] Instant virtualNow() const;

signals:
    /// What to open: the link, or "tcp://ADDRESS:PORT". Once a port, from the event loop.
    void ready(const QString& address);
    /// Something to tell the person: the state file could not be written.
    void problem(const trex::Error& error);

private:
    void pump();
    void receivePty();
    void receiveTcp();
    void acceptTcp();
    void adopt(QTcpSocket* socket);
    void hear(QByteArrayView bytes, std::optional<HostLine> host);
    void send(const QByteArray& bytes);
    void followHangUp(Instant now);
    void watchPty();
    void save();
    [[nodiscard]] std::optional<HostLine> ptyLine() const;
    [[nodiscard]] Instant realTime(Instant virtualTime) const;

    SimOptions m_options;
    Instant m_start;
    SimulatedLine m_line;
    SimLog m_log;
    std::optional<HostLine> m_host; ///< as told to the line
    PreciseTimer m_timer;
    bool m_hasPty = false;
    QString m_link;
    PtyPort m_pty;
    std::unique_ptr<QSocketNotifier> m_ptyNotifier;
    QTcpServer* m_tcp = nullptr;
    QTcpSocket* m_client = nullptr;
    QString m_tcpAddress; ///< empty: this computer only
    quint16 m_tcpPort = 0;
    bool m_isHungUp = false;
    bool m_saveFailed = false;
};

} // namespace trex::sim
