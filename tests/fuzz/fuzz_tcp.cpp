// SPDX-License-Identifier: GPL-3.0-or-later
// A peer on TCP that sends what it likes to the whole of it: façade, link thread, socket. It begins
// to talk before it is asked, answers with whatever bytes come next, and goes when it likes.
#include "protocol/codec/packet.h"
#include "protocol/session/controller.h"
#include "protocol/telemetry/statuslatch.h"
#include "protocol/telemetry/telemetrystore.h"
#include "tests/fuzz/peer.h"

#include <QCoreApplication>
#include <QElapsedTimer>
#include <QTcpServer>
#include <QTcpSocket>
#include <QTimer>

using namespace trex;
using namespace std::chrono_literals;
using fuzz::holds;

namespace {

constexpr int kPlayMs = 40;
constexpr int kLongestCloseMs = 5000;

class Peer {
public:
    Peer(fuzz::Input& input, const LineSettings& line) : m_input(input), m_line(line)
    {
        holds(m_server.listen(QHostAddress::LocalHost), "there is a port to listen on");
        QObject::connect(&m_server, &QTcpServer::newConnection, &m_server, [this] {
            m_socket = m_server.nextPendingConnection();
            talk({});
            QObject::connect(m_socket, &QTcpSocket::readyRead, m_socket, [this] {
                const QByteArray bytes = m_socket->readAll();
                heard += bytes;
                talk(bytes);
            });
        });
    }
    [[nodiscard]] quint16 port() const { return m_server.serverPort(); }
    QByteArray heard;

private:
    void talk(const QByteArray& asked)
    {
        const int choice = m_input.byte();
        if (choice < 0xA0) {
            const auto packet = decodePacket(asked, m_line);
            m_socket->write(packet ? fuzz::honestReply(packet->command, m_line) : QByteArray());
        } else if (choice < 0xE0) {
            m_socket->write(m_input.bytes(choice & 0x1F));
        } else if (choice < 0xFC) {
            m_socket->write(m_input.bytes(8).repeated(1000));
        } else {
            m_socket->abort();
            return;
        }
        m_socket->flush();
    }
    fuzz::Input& m_input;
    LineSettings m_line;
    QTcpServer m_server;
    QTcpSocket* m_socket = nullptr; ///< the server's
};

template <class Condition>
bool waitFor(int longestMs, Condition isDone)
{
    QElapsedTimer clock;
    clock.start();
    while (!isDone()) {
        if (clock.elapsed() >= longestMs) {
            return false;
        }
        QTimer::singleShot(2, qApp, [] {}); // wakes the wait below
        QCoreApplication::processEvents(QEventLoop::WaitForMoreEvents);
    }
    return true;
}

/// Whether a whole packet that drives a motor stands somewhere in what was sent.
bool drives(const QByteArray& bytes)
{
    for (qsizetype i = 0; i < bytes.size(); ++i) {
        const auto opcode = static_cast<std::uint8_t>(bytes[i]);
        const bool isMotor = opcode >= 0xC0 && opcode <= 0xF1;
        if (isMotor && i + 1 < bytes.size() && bytes[i + 1] != 0
            && static_cast<std::uint8_t>(bytes[i + 1]) < 0x80) {
            return true;
        }
    }
    return false;
}

} // namespace

extern "C" int LLVMFuzzerInitialize(int* argc, char*** argv)
{
    static QCoreApplication application(*argc, *argv);
    return 0;
}

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
    fuzz::Input input(data, size);
    const int bits = input.byte();
    LineSettings line;
    line.errorDetection = (bits & 1) != 0 ? ErrorDetection::Crc7 : ErrorDetection::None;
    line.timeout = 10ms;
    Peer peer(input, line);
    TelemetryStore store;
    StatusLatch latch;
    Controller controller(&store, &latch);
    controller.want(&controller, PollId::Currents, 80.0);
    OpenOptions options;
    options.port = QStringLiteral("tcp://127.0.0.1:%1").arg(peer.port());
    options.line = line;
    bool mayDrive = false;
    QObject::connect(&controller, &Controller::stateChanged, &controller, [&](LinkState state) {
        if (state == LinkState::Connected && (bits & 2) != 0 && controller.arm()) {
            mayDrive = true;
            (void)controller.driveMotor(MotorId::Motor1, {MotorOrder::Action::Set, 5});
        }
    });
    controller.open(options);
    (void)waitFor(kPlayMs, [] { return false; });
    bool isClosed = false;
    QObject::connect(&controller, &Controller::closed, &controller, [&] { isClosed = true; });
    controller.close();
    holds(waitFor(kLongestCloseMs, [&] { return isClosed; }), "a close ends");
    holds(!controller.isArmed(), "a closed line is not armed");
    (void)waitFor(3, [] { return false; });
    holds(mayDrive || !drives(peer.heard), "no motor is driven that nobody armed");
    return 0;
}
