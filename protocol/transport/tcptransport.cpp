// SPDX-License-Identifier: GPL-3.0-or-later
#include "protocol/transport/tcptransport.h"

#include "protocol/transport/laststop.h"

#ifdef Q_OS_LINUX
#include <netinet/in.h>
#include <netinet/tcp.h>
#include <sys/socket.h>
#endif

namespace trex {

namespace {

using namespace Qt::Literals::StringLiterals;

constexpr qint64 kMostBuffered = 16'384; ///< what a peer sends at full rate waits at the peer

/// A peer that takes nothing any more (its computer is off, the cable is out) is given up after
/// kLongestUnheard; the system would hope for a quarter of an hour.
void limitSilence([[maybe_unused]] int descriptor)
{
#ifdef Q_OS_LINUX
    const auto longest = static_cast<unsigned>(TcpTransport::kLongestUnheard.count());
    ::setsockopt(descriptor, IPPROTO_TCP, TCP_USER_TIMEOUT, &longest, sizeof longest);
#endif
}

} // namespace

TcpTransport::TcpTransport(const QString& host, quint16 port, QObject* parent)
    : Transport(parent), m_host(host), m_port(port), m_socket(this), m_connectTimer(this)
{
    m_connectTimer.setSingleShot(true);
    m_socket.setReadBufferSize(kMostBuffered);
    connect(&m_connectTimer, &QTimer::timeout, this, [this] { onGone(ErrorCode::PortMissing); });
    connect(&m_socket, &QTcpSocket::connected, this, [this] {
        m_connectTimer.stop();
        m_socket.setSocketOption(QAbstractSocket::LowDelayOption, 1);
        limitSilence(static_cast<int>(m_socket.socketDescriptor()));
        m_isOpening = false;
        m_isOpen = true;
        emit opened();
    });
    connect(&m_socket, &QTcpSocket::readyRead, this, &TcpTransport::onReadyRead);
    connect(&m_socket, &QTcpSocket::errorOccurred, this, [this](QTcpSocket::SocketError error) {
        if (error != QTcpSocket::SocketTimeoutError) { // waitForBytes(): no byte in time, no more
            onGone(m_isOpen ? ErrorCode::LineLost : ErrorCode::PortMissing);
        }
    });
    connect(&m_socket, &QTcpSocket::disconnected, this, [this] { onGone(ErrorCode::LineLost); });
}

TcpTransport::~TcpTransport()
{
    m_socket.disconnect(this); // its own end tells of a lost connection
}

void TcpTransport::open(const LineSettings& settings)
{
    Q_UNUSED(settings) // set at the serial server
    m_isOpening = true;
    m_connectTimer.start(kConnectTimeout);
    m_socket.connectToHost(m_host, m_port);
}

void TcpTransport::close()
{
    m_isOpening = false;
    m_isOpen = false;
    m_connectTimer.stop();
    if (m_socket.state() == QAbstractSocket::ConnectedState) {
        m_socket.flush();
    }
    m_socket.abort();
}

int TcpTransport::descriptor() const
{
    return m_isOpen ? static_cast<int>(m_socket.socketDescriptor()) : -1;
}

void TcpTransport::write(const QByteArray& bytes)
{
    if (m_isOpen && !laststop::isCrashing()) {
        m_socket.write(bytes);
        m_socket.flush();
    }
}

bool TcpTransport::waitForBytes(Duration longest)
{
    const quint64 before = m_reads;
    const auto milliseconds = std::chrono::ceil<std::chrono::milliseconds>(longest).count();
    m_socket.waitForReadyRead(static_cast<int>(milliseconds));
    return m_reads != before;
}

void TcpTransport::onReadyRead()
{
    const QByteArray bytes = m_socket.readAll();
    if (m_isOpen && !bytes.isEmpty()) {
        ++m_reads;
        emit received(bytes, std::chrono::steady_clock::now());
    }
}

void TcpTransport::onGone(ErrorCode code)
{
    if (!m_isOpening && !m_isOpen) {
        return;
    }
    m_isOpening = false;
    m_isOpen = false;
    m_connectTimer.stop();
    QMetaObject::invokeMethod(
        this,
        [this] {
            if (!m_isOpening && !m_isOpen) { // else opened again meanwhile
                m_socket.abort();
            }
        },
        Qt::QueuedConnection);
    emit failed({code, "tcp://%1:%2"_L1.arg(m_host).arg(m_port)});
}

} // namespace trex
