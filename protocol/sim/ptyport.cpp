// SPDX-License-Identifier: GPL-3.0-or-later
#include "protocol/sim/ptyport.h"

#include <QFile>
#include <QFileInfo>

#ifdef Q_OS_LINUX
#include <asm/termbits.h> // termios2: speeds as numbers; excludes <termios.h>
#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <fcntl.h>
#include <sys/ioctl.h>
#include <unistd.h>
#endif

namespace trex::sim {

using namespace Qt::Literals::StringLiterals;

PtyPort::~PtyPort()
{
    close();
}

QString PtyPort::name() const
{
    return m_link.isEmpty() ? m_device : m_link;
}

#ifdef Q_OS_LINUX

namespace {

constexpr std::size_t kChunk = 4096;
constexpr std::size_t kLongestName = 128;

tl::unexpected<Error> systemError(const QString& what)
{
    return fail(ErrorCode::PortFailed,
                u"%1: %2"_s.arg(what, QString::fromLocal8Bit(std::strerror(errno))));
}

// Raw, and speed 0: the mark of "nobody has set one".
bool makeRaw(int descriptor)
{
    termios2 settings{};
    if (::ioctl(descriptor, TCGETS2, &settings) != 0) {
        return false;
    }
    settings.c_iflag = 0;
    settings.c_oflag = 0;
    settings.c_lflag = 0;
    settings.c_cflag = CS8 | CREAD | CLOCAL | B0;
    settings.c_cc[VMIN] = 1;
    settings.c_cc[VTIME] = 0;
    settings.c_ispeed = 0;
    settings.c_ospeed = 0;
    return ::ioctl(descriptor, TCSETS2, &settings) == 0;
}

} // namespace

Result<void> PtyPort::open(const QString& link)
{
    close();
    const QFileInfo existing(link);
    if (!link.isEmpty() && existing.exists() && !existing.isSymLink()) {
        return fail(ErrorCode::PortFailed, u"%1 exists and is not a link"_s.arg(link));
    }
    m_master = ::posix_openpt(O_RDWR | O_NOCTTY | O_CLOEXEC | O_NONBLOCK);
    std::array<char, kLongestName> device{};
    if (m_master < 0 || ::grantpt(m_master) != 0 || ::unlockpt(m_master) != 0
        || ::ptsname_r(m_master, device.data(), device.size()) != 0) {
        const auto error = systemError(u"pseudo-terminal"_s);
        close();
        return error;
    }
    m_device = QString::fromLocal8Bit(device.data());
    m_slave = ::open(device.data(), O_RDWR | O_NOCTTY | O_CLOEXEC);
    if (m_slave < 0 || !makeRaw(m_slave)) {
        const auto error = systemError(m_device);
        close();
        return error;
    }
    if (link.isEmpty()) {
        return {};
    }
    // A fresh link under another name, moved over the old one: at no moment is there none.
    const QByteArray target = QFile::encodeName(link);
    const QByteArray fresh = target + ".new" + QByteArray::number(::getpid());
    ::unlink(fresh.constData());
    if (::symlink(device.data(), fresh.constData()) != 0
        || std::rename(fresh.constData(), target.constData()) != 0) {
        const auto error = systemError(link);
        ::unlink(fresh.constData());
        close();
        return error;
    }
    m_link = link;
    return {};
}

void PtyPort::close()
{
    if (!m_link.isEmpty() && QFile::symLinkTarget(m_link) == m_device) {
        QFile::remove(m_link);
    }
    m_link.clear();
    if (m_slave >= 0) {
        ::close(m_slave);
    }
    if (m_master >= 0) {
        ::close(m_master);
    }
    m_slave = m_master = -1;
}

QByteArray PtyPort::read()
{
    std::array<char, kChunk> chunk{};
    const auto count = m_master < 0 ? 0 : ::read(m_master, chunk.data(), chunk.size());
    return count > 0 ? QByteArray(chunk.data(), count) : QByteArray();
}

void PtyPort::write(QByteArrayView bytes)
{
    if (m_master >= 0) {
        std::ignore = ::write(m_master, bytes.data(), static_cast<std::size_t>(bytes.size()));
    }
}

std::optional<PtyPort::Speed> PtyPort::speed() const
{
    termios2 settings{};
    if (m_slave < 0 || ::ioctl(m_slave, TCGETS2, &settings) != 0 || settings.c_ospeed == 0) {
        return std::nullopt;
    }
    return Speed{static_cast<int>(settings.c_ospeed), (settings.c_cflag & CSTOPB) != 0 ? 2 : 1};
}

#else

Result<void> PtyPort::open(const QString&)
{
    return fail(ErrorCode::PortFailed, u"pseudo-terminals exist on Linux only; use TCP"_s);
}
void PtyPort::close() { }
QByteArray PtyPort::read()
{
    return {};
}
void PtyPort::write(QByteArrayView) { }
std::optional<PtyPort::Speed> PtyPort::speed() const
{
    return std::nullopt;
}

#endif

} // namespace trex::sim
