// SPDX-License-Identifier: GPL-3.0-or-later
#include "protocol/sim/simserver.h"

#include <QSocketNotifier>
#include <QTcpServer>
#include <QTcpSocket>
#include <QTimer>

namespace trex::sim {

using namespace std::chrono_literals;
using namespace Qt::Literals::StringLiterals;

namespace {

// The plants run on, hang-ups come and the log is written, also while nothing is on the wire.
constexpr auto kIdleStep = 20ms;
constexpr auto kSecondChance = 50ms;

Duration scaled(Duration duration, double factor)
{
    return Duration(static_cast<Duration::rep>(static_cast<double>(duration.count()) * factor));
}

/// A socket that listens is for this computer, unless somebody has said otherwise.
QHostAddress hostOf(const QString& address)
{
    return address.isEmpty() ? QHostAddress(QHostAddress::LocalHost) : QHostAddress(address);
}

} // namespace

SimServer::SimServer(const SimOptions& options, QObject* parent)
    : QObject(parent)
    , m_options(options)
    , m_start(std::chrono::steady_clock::now())
    , m_line(options, m_start)
    , m_log(m_start, options.speed)
    , m_timer(this)
{
    connect(&m_timer, &PreciseTimer::timedOut, this, &SimServer::pump);
    pump();
}

SimServer::~SimServer()
{
    m_line.advance(virtualNow());
    m_log.collect(m_line);
}

Result<void> SimServer::setLogFile(const QString& path)
{
    auto opened = m_log.open(path);
    if (opened) {
        m_log.note(m_start, "started");
    }
    return opened;
}

Result<void> SimServer::listenPty(const QString& link)
{
    if (auto opened = m_pty.open(link); !opened) {
        return opened;
    }
    m_hasPty = true;
    m_link = link;
    watchPty();
    QTimer::singleShot(0, this, [this, name = m_pty.name()] { emit ready(name); });
    return {};
}

Result<void> SimServer::listenTcp(quint16 port, const QString& address)
{
    if (!address.isEmpty() && !isAddress(address)) {
        return fail(ErrorCode::OutOfRange, address);
    }
    m_tcpAddress = address;
    m_tcp = new QTcpServer(this);
    connect(m_tcp, &QTcpServer::newConnection, this, &SimServer::acceptTcp);
    if (!m_tcp->listen(hostOf(m_tcpAddress), port)) {
        return fail(ErrorCode::PortFailed,
                    u"TCP port %1: %2"_s.arg(port).arg(m_tcp->errorString()));
    }
    m_tcpPort = m_tcp->serverPort();
    const QHostAddress host = hostOf(m_tcpAddress);
    const bool isVersion6 = host.protocol() == QAbstractSocket::IPv6Protocol;
    const QString name =
        (isVersion6 ? u"tcp://[%1]:%2"_s : u"tcp://%1:%2"_s).arg(host.toString()).arg(m_tcpPort);
    QTimer::singleShot(0, this, [this, name] { emit ready(name); });
    return {};
}

bool SimServer::isAddress(const QString& text)
{
    return !QHostAddress(text).isNull();
}

bool SimServer::servesOthers() const
{
    return m_tcp != nullptr && !hostOf(m_tcpAddress).isLoopback();
}

Instant SimServer::virtualNow() const
{
    return m_start + scaled(std::chrono::steady_clock::now() - m_start, m_options.speed);
}

Instant SimServer::realTime(Instant virtualTime) const
{
    return m_start + scaled(virtualTime - m_start, 1.0 / m_options.speed);
}

void SimServer::powerCycle()
{
    const Instant now = virtualNow();
    m_line.powerCycle(now);
    m_log.note(now, "powerCycle");
    m_host.reset(); // the controllers may listen at another speed now
    pump();
}

void SimServer::pump()
{
    const Instant now = virtualNow();
    send(m_line.read(now));
    followHangUp(now);
    m_log.collect(m_line);
    save();
    Instant next = std::chrono::steady_clock::now() + kIdleStep;
    if (const auto due = m_line.nextByteAt()) {
        next = std::min(next, realTime(*due));
    }
    m_timer.startAt(next);
}

void SimServer::receivePty()
{
    const QByteArray bytes = m_pty.read();
    if (!bytes.isEmpty()) {
        hear(bytes, ptyLine());
    }
}

void SimServer::receiveTcp()
{
    hear(m_client->readAll(), std::nullopt);
}

void SimServer::hear(QByteArrayView bytes, std::optional<HostLine> host)
{
    if (host != m_host) {
        m_line.setHostLine(host);
        m_host = host;
    }
    m_line.write(bytes, virtualNow());
    pump();
}

// A pseudo-terminal tells the speed but not the parity, which is taken to be right.
std::optional<HostLine> SimServer::ptyLine() const
{
    const auto speed = m_pty.speed();
    if (!speed) {
        return std::nullopt;
    }
    return HostLine{speed->baud, m_line.device().uart().detection, speed->stopBits};
}

void SimServer::acceptTcp()
{
    while (QTcpSocket* socket = m_tcp->nextPendingConnection()) {
        connect(socket, &QTcpSocket::disconnected, this, [this, socket] {
            if (m_client == socket) {
                m_client = nullptr;
            }
            socket->deleteLater();
        });
        if (m_client == nullptr) {
            adopt(socket);
            continue;
        }
        // The first may just have closed, and we not have heard of it yet.
        QTimer::singleShot(kSecondChance, socket, [this, socket] {
            if (m_client == nullptr) {
                adopt(socket);
            } else {
                socket->abort();
            }
        });
    }
}

void SimServer::adopt(QTcpSocket* socket)
{
    m_client = socket;
    socket->setSocketOption(QAbstractSocket::LowDelayOption, 1);
    connect(socket, &QTcpSocket::readyRead, this, &SimServer::receiveTcp);
    if (socket->bytesAvailable() > 0) {
        receiveTcp();
    }
}

void SimServer::send(const QByteArray& bytes)
{
    if (bytes.isEmpty()) {
        return;
    }
    m_pty.write(bytes);
    if (m_client != nullptr) {
        m_client->write(bytes);
        m_client->flush();
    }
}

void SimServer::followHangUp(Instant now)
{
    const bool isGone = m_line.isHungUp(now);
    if (isGone == m_isHungUp) {
        return;
    }
    m_isHungUp = isGone;
    m_log.note(now, isGone ? "hungUp" : "returned");
    if (isGone) {
        m_ptyNotifier.reset();
        m_pty.close();
        if (m_tcp != nullptr) {
            m_tcp->close();
        }
        if (m_client != nullptr) {
            m_client->abort();
        }
        return;
    }
    if (m_hasPty) {
        if (const auto opened = m_pty.open(m_link); !opened) {
            emit problem(opened.error());
        }
        watchPty();
    }
    if (m_tcp != nullptr && !m_tcp->listen(hostOf(m_tcpAddress), m_tcpPort)) {
        emit problem({ErrorCode::PortFailed, m_tcp->errorString()});
    }
}

void SimServer::watchPty()
{
    if (m_pty.isOpen()) {
        m_ptyNotifier =
            std::make_unique<QSocketNotifier>(m_pty.descriptor(), QSocketNotifier::Read);
        connect(m_ptyNotifier.get(), &QSocketNotifier::activated, this, &SimServer::receivePty);
    }
}

void SimServer::save()
{
    if (const auto saved = m_line.saveState(); !saved && !m_saveFailed) {
        m_saveFailed = true; // once is enough
        emit problem(saved.error());
    }
}

} // namespace trex::sim
