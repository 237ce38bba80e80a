// SPDX-License-Identifier: GPL-3.0-or-later
#include "protocol/transport/serialtransport.h"

#include "protocol/transport/laststop.h"

#include <QDir>
#include <QFileInfo>

#ifdef Q_OS_LINUX
#include <linux/serial.h>
#include <sys/ioctl.h>
#endif
#ifdef Q_OS_UNIX
#include <poll.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#endif

namespace trex {

namespace {

using namespace Qt::Literals::StringLiterals;

/// QSerialPort takes a bare name for one under /dev; a link in the working folder is meant as such.
QString systemName(const QString& port)
{
    const QFileInfo info(port);
    return info.exists() ? info.absoluteFilePath() : port;
}

#ifdef Q_OS_UNIX
/// What can be said before opening: QSerialPort reports a denied, a busy and a foreign file alike.
std::optional<Error> lookAt(const QString& port)
{
    const QString path = port.startsWith(u'/') ? port : "/dev/"_L1 + port;
    struct stat information { };
    if (::stat(path.toLocal8Bit().constData(), &information) != 0) {
        // A folder on the way that we may not look into hides what is in it.
        return Error{errno == EACCES ? ErrorCode::PortDenied : ErrorCode::PortMissing, port};
    }
    if (!S_ISCHR(information.st_mode)) {
        return Error{ErrorCode::PortNotSerial, port};
    }
    if (::access(path.toLocal8Bit().constData(), R_OK | W_OK) != 0) {
        return Error{ErrorCode::PortDenied, port};
    }
    return std::nullopt;
}
#endif

/// False when the system says that the other side has hung up or the device is gone.
bool isThere([[maybe_unused]] const QSerialPort& port)
{
#ifdef Q_OS_UNIX
    pollfd descriptor{port.handle(), POLLIN, 0};
    return ::poll(&descriptor, 1, 0) >= 0
        && (descriptor.revents & (POLLERR | POLLHUP | POLLNVAL)) == 0;
#else
    return false;
#endif
}

/// "/dev/ttyUSB0 (minicom, process 1234)", where the system tells.
QString withHolder(const QString& port)
{
    const QString holder = portHolder(systemName(port));
    return holder.isEmpty() ? port : u"%1 (%2)"_s.arg(port, holder);
}

ErrorCode codeOf(QSerialPort::SerialPortError error)
{
    switch (error) {
    case QSerialPort::DeviceNotFoundError:
        return ErrorCode::PortMissing;
    case QSerialPort::PermissionError:
    case QSerialPort::OpenError:
        return ErrorCode::PortBusy; // a denied one was found by lookAt()
    case QSerialPort::UnsupportedOperationError:
        return ErrorCode::PortNotSerial;
    default:
        return ErrorCode::PortFailed;
    }
}

} // namespace

SerialTransport::SerialTransport(const QString& port, QObject* parent)
    : Transport(parent), m_name(port), m_port(this)
{
    connect(&m_port, &QSerialPort::readyRead, this, &SerialTransport::onReadyRead);
    connect(&m_port, &QSerialPort::errorOccurred, this, &SerialTransport::onError);
}

void SerialTransport::open(const LineSettings& settings)
{
    const QString name = systemName(m_name);
#ifdef Q_OS_UNIX
    if (const auto problem = lookAt(name)) {
        emit failed({problem->code, m_name});
        return;
    }
#endif
    m_port.setPortName(name);
    setLine(settings);
    m_port.setDataBits(QSerialPort::Data8);
    m_port.setFlowControl(QSerialPort::NoFlowControl);
    if (!m_port.open(QIODevice::ReadWrite)) {
        const QSerialPort::SerialPortError error = m_port.error();
        const bool notSerial =
            error == QSerialPort::UnknownError || error == QSerialPort::UnsupportedOperationError;
        const ErrorCode code = notSerial ? ErrorCode::PortNotSerial : codeOf(error);
        emit failed({code, code == ErrorCode::PortBusy ? withHolder(m_name) : m_name});
        return;
    }
    if (isTaken()) {
        m_port.close();
        emit failed({ErrorCode::PortBusy, withHolder(m_name)});
        return;
    }
    m_isOpen = true;
    noteAdapter(name);
    m_port.clear(); // what came before we were here is nobody's reply
    emit opened();
}

bool SerialTransport::setLine(const LineSettings& settings)
{
    if (!m_port.setBaudRate(settings.baud)) {
        return false; // this adapter has no such speed: whatever follows must not go out
    }
    // A pseudo-terminal refuses parity, and works all the same.
    m_port.setParity(settings.errorDetection == ErrorDetection::Even      ? QSerialPort::EvenParity
                         : settings.errorDetection == ErrorDetection::Odd ? QSerialPort::OddParity
                                                                          : QSerialPort::NoParity);
    m_port.setStopBits(settings.stopBits == 2 ? QSerialPort::TwoStop : QSerialPort::OneStop);
    return true;
}

/// FTDI adapters hold bytes back for 16 ms otherwise. A port that knows nothing of it refuses, and
/// works all the same; some drivers take the flag and forget it, so that it is read back.
AdapterFacts::LowLatency SerialTransport::askForLowLatency() const
{
    using enum AdapterFacts::LowLatency;
#ifdef Q_OS_LINUX
    serial_struct serial{};
    if (::ioctl(m_port.handle(), TIOCGSERIAL, &serial) != 0) {
        return Unknown;
    }
    serial.flags |= ASYNC_LOW_LATENCY;
    if (::ioctl(m_port.handle(), TIOCSSERIAL, &serial) != 0) {
        return errno == EPERM || errno == EACCES ? Refused : Unknown;
    }
    serial = {};
    const bool isRead = ::ioctl(m_port.handle(), TIOCGSERIAL, &serial) == 0;
    const auto flags = static_cast<unsigned>(serial.flags);
    return isRead && (flags & ASYNC_LOW_LATENCY) != 0 ? Granted : Unknown;
#else
    return NotAsked;
#endif
}

void SerialTransport::noteAdapter(const QString& path)
{
    const AdapterFacts::LowLatency lowLatency = askForLowLatency(); // sets the timer read next
    m_adapter = readAdapterFacts(path);
    const bool isPty = m_adapter.kind == AdapterFacts::Kind::PseudoTerminal;
    m_adapter.lowLatency = isPty ? AdapterFacts::LowLatency::NotAsked : lowLatency;
}

/// By a program that locks with flock(2), as many do that do not set TIOCEXCL; and the superuser
/// passes TIOCEXCL. The lock is ours until the port is closed.
bool SerialTransport::isTaken() const
{
#ifdef Q_OS_UNIX
    return ::flock(static_cast<int>(m_port.handle()), LOCK_EX | LOCK_NB) != 0
        && errno == EWOULDBLOCK;
#else
    return false;
#endif
}

void SerialTransport::close()
{
    m_isOpen = false;
    if (m_port.isOpen()) {
        m_port.close();
    }
}

void SerialTransport::write(const QByteArray& bytes)
{
    if (!m_isOpen || laststop::isCrashing()) {
        return;
    }
    m_port.write(bytes);
    m_port.flush(); // now, not when the event loop comes round
}

int SerialTransport::descriptor() const
{
#ifdef Q_OS_UNIX
    return m_isOpen ? static_cast<int>(m_port.handle()) : -1;
#else
    return -1;
#endif
}

bool SerialTransport::waitForBytes(Duration longest)
{
    const quint64 before = m_reads;
    const auto milliseconds = std::chrono::ceil<std::chrono::milliseconds>(longest).count();
    m_port.waitForReadyRead(static_cast<int>(milliseconds));
    return m_reads != before;
}

void SerialTransport::onReadyRead()
{
    const QByteArray bytes = m_port.readAll();
    if (!bytes.isEmpty()) {
        ++m_reads;
        emit received(bytes, std::chrono::steady_clock::now());
    }
}

void SerialTransport::onError(QSerialPort::SerialPortError error)
{
    if (!m_isOpen || error == QSerialPort::NoError || error == QSerialPort::TimeoutError
        || error == QSerialPort::UnsupportedOperationError) {
        return; // a pseudo-terminal refuses parity and modem lines, and works all the same
    }
    if ((error == QSerialPort::ResourceError || error == QSerialPort::ReadError)
        && isThere(m_port)) {
        // The event loop told of bytes that waitForBytes() had read by then; QSerialPort takes that
        // for a lost device and listens no more until something is read.
        QMetaObject::invokeMethod(this, &SerialTransport::onReadyRead, Qt::QueuedConnection);
        return;
    }
    m_isOpen = false;
    // Not from inside the port's own signal: closing there would pull the port away from under it.
    QMetaObject::invokeMethod(
        this,
        [this] {
            if (!m_isOpen) { // else opened again meanwhile
                m_port.close();
            }
        },
        Qt::QueuedConnection);
    emit failed({ErrorCode::LineLost, m_name});
}

} // namespace trex
