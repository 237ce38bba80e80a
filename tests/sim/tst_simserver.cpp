// SPDX-License-Identifier: GPL-3.0-or-later
// The server as other programs meet it: a real pseudo-terminal, a real socket.
#include "protocol/sim/simserver.h"

#include <QFile>
#include <QFileInfo>
#include <QJsonDocument>
#include <QJsonObject>
#include <QSignalSpy>
#include <QTcpServer>
#include <QTcpSocket>
#include <QTemporaryDir>
#include <QTest>

#include <fcntl.h>
#include <poll.h>
#include <termios.h>
#include <unistd.h>

using namespace trex;
using namespace trex::sim;

namespace {

/// A program that opens the far end.
class Client {
public:
    explicit Client(const QString& path, speed_t speed = B0)
        : m_descriptor(::open(QFile::encodeName(path).constData(), O_RDWR | O_NOCTTY | O_NONBLOCK))
    {
        if (speed != B0) {
            termios settings{};
            ::tcgetattr(m_descriptor, &settings);
            ::cfmakeraw(&settings);
            ::cfsetspeed(&settings, speed);
            ::tcsetattr(m_descriptor, TCSANOW, &settings);
        }
    }
    ~Client() { ::close(m_descriptor); }
    Client(const Client&) = delete;
    Client& operator=(const Client&) = delete;
    [[nodiscard]] bool isOpen() const { return m_descriptor >= 0; }
    void tell(const char* hex) const
    {
        const QByteArray bytes = QByteArray::fromHex(hex);
        QCOMPARE(::write(m_descriptor, bytes.data(), static_cast<std::size_t>(bytes.size())),
                 bytes.size());
    }
    QByteArray hear()
    {
        std::array<char, 256> chunk{};
        const auto count = ::read(m_descriptor, chunk.data(), chunk.size());
        if (count > 0) {
            m_heard.append(chunk.data(), count);
        }
        return m_heard;
    }
    [[nodiscard]] bool isHungUp() const
    {
        pollfd watched{m_descriptor, POLLIN, 0};
        ::poll(&watched, 1, 0);
        return (watched.revents & POLLHUP) != 0;
    }

private:
    int m_descriptor;
    QByteArray m_heard;
};

} // namespace

class TstSimServer : public QObject {
    Q_OBJECT
private slots:
    void pty_answersWhoeverOpensTheLink();
    void pty_linkReplacesALinkButNoFile();
    void pty_listensAtTheClientsSpeed();
    void pty_survivesClientsThatComeAndGo();
    void pty_hangsUpAndReturns();
    void powerCycle_forgetsTheMotors();
    void tcp_servesOneClientAtATime();
    void tcp_portInUseIsSaid();
    void log_tellsPacketsAndOutputs();
    void state_isWrittenAtOnce();
    void speed_makesTimeRunFaster();

private:
    QTemporaryDir m_folder;
    QString m_link = m_folder.filePath(QStringLiteral("port"));
};

// C-17
void TstSimServer::pty_answersWhoeverOpensTheLink()
{
    {
        SimServer server{SimOptions{}};
        const QSignalSpy ready(&server, &SimServer::ready);
        QVERIFY(server.listenPty(m_link));
        QTRY_COMPARE(ready.size(), 1);
        QCOMPARE(ready.at(0).at(0).toString(), m_link);
        Client client(m_link);
        QVERIFY(client.isOpen());
        client.tell("800701");
        QTRY_COMPARE(client.hear(), QByteArray("TReXJr1.2"));
    }
    QVERIFY(!QFileInfo(m_link).isSymLink());
}

void TstSimServer::pty_linkReplacesALinkButNoFile()
{
    QVERIFY(QFile::link(QStringLiteral("/nowhere"), m_link));
    {
        SimServer server{SimOptions{}};
        QVERIFY(server.listenPty(m_link));
        QVERIFY(Client(m_link).isOpen());
    }
    const QString file = m_folder.filePath(QStringLiteral("file"));
    QVERIFY(QFile(file).open(QIODevice::WriteOnly));
    SimServer server{SimOptions{}};
    const auto opened = server.listenPty(file);
    QVERIFY(!opened);
    QVERIFY(opened.error().context.contains(file));
    QVERIFY(QFileInfo::exists(file));
}

// C-53
void TstSimServer::pty_listensAtTheClientsSpeed()
{
    SimOptions options;
    options.baud = 115200;
    options.pace = true;
    SimServer server(options);
    QVERIFY(server.listenPty(m_link));
    {
        Client right(m_link, B115200);
        right.tell("81");
        QTRY_COMPARE(right.hear(), QByteArray("TReXJr1.2"));
    }
    {
        Client wrong(m_link, B19200);
        wrong.tell("818181");
        QTRY_VERIFY(server.line().device().firmware().uartErrorByte() != 0);
        QVERIFY(!wrong.hear().contains("TReX"));
    }
    Client again(m_link, B115200);
    again.tell("018282"); // what is left of the garbage ends here
    QTRY_VERIFY(again.hear().endsWith("r"));
}

void TstSimServer::pty_survivesClientsThatComeAndGo()
{
    SimServer server{SimOptions{}};
    QVERIFY(server.listenPty(m_link));
    for (int i = 0; i < 5; ++i) {
        Client client(m_link);
        client.tell("82");
        QTRY_COMPARE(client.hear(), QByteArray("r"));
    }
}

void TstSimServer::pty_hangsUpAndReturns()
{
    SimOptions options;
    QVERIFY(options.applyFault(QStringLiteral("hangup-after=0.3")));
    QVERIFY(options.applyFault(QStringLiteral("hangup-for=0.3")));
    SimServer server(options);
    QVERIFY(server.listenPty(m_link));
    Client client(m_link);
    QVERIFY(!client.isHungUp());
    QTRY_VERIFY(client.isHungUp());
    QVERIFY(!QFileInfo(m_link).isSymLink());
    QTRY_VERIFY(QFileInfo(m_link).isSymLink());
    Client again(m_link);
    again.tell("82");
    QTRY_COMPARE(again.hear(), QByteArray("r"));
}

// C-39
void TstSimServer::powerCycle_forgetsTheMotors()
{
    SimServer server{SimOptions{}};
    QVERIFY(server.listenPty(m_link));
    Client client(m_link);
    client.tell("C240 AF7C01552A 82");
    QTRY_COMPARE(client.hear(), QByteArray("\0r", 2));
    QCOMPARE(server.line().device().output(MotorId::Motor1).speed, 0x40);
    server.powerCycle();
    QCOMPARE(server.line().device().output(MotorId::Motor1).speed, 0);
    client.tell("82");
    QTRY_COMPARE(client.hear(), QByteArray("\0ra", 3));
}

void TstSimServer::tcp_servesOneClientAtATime()
{
    SimServer server{SimOptions{}};
    const QSignalSpy ready(&server, &SimServer::ready);
    QVERIFY(server.listenTcp(0));
    QTRY_COMPARE(ready.size(), 1);
    const QString address = ready.at(0).at(0).toString();
    QVERIFY(address.startsWith(QLatin1String("tcp://127.0.0.1:")));
    const quint16 port = address.section(QLatin1Char(':'), -1).toUShort();

    QTcpSocket first;
    first.connectToHost(QHostAddress::LocalHost, port);
    first.write(QByteArray::fromHex("81"));
    QTRY_COMPARE(first.bytesAvailable(), 9);
    QTcpSocket second;
    const QSignalSpy refused(&second, &QTcpSocket::disconnected);
    second.connectToHost(QHostAddress::LocalHost, port);
    QTRY_COMPARE(refused.size(), 1);
    first.write(QByteArray::fromHex("82"));
    QTRY_COMPARE(first.bytesAvailable(), 10);
    QVERIFY(first.readAll().endsWith("r"));
    first.disconnectFromHost();
    QTRY_COMPARE(first.state(), QAbstractSocket::UnconnectedState);

    QTcpSocket third;
    third.connectToHost(QHostAddress::LocalHost, port);
    third.write(QByteArray::fromHex("82"));
    QTRY_COMPARE(third.bytesAvailable(), 1);
}

void TstSimServer::tcp_portInUseIsSaid()
{
    QTcpServer other;
    QVERIFY(other.listen(QHostAddress::LocalHost, 0));
    SimServer server{SimOptions{}};
    const auto listening = server.listenTcp(other.serverPort());
    QVERIFY(!listening);
    QVERIFY(listening.error().context.contains(QString::number(other.serverPort())));
}

void TstSimServer::log_tellsPacketsAndOutputs()
{
    const QString path = m_folder.filePath(QStringLiteral("log.jsonl"));
    SimServer server{SimOptions{}};
    QVERIFY(server.setLogFile(path));
    QVERIFY(server.listenPty(m_link));
    Client client(m_link);
    client.tell("8007427F");
    QTRY_COMPARE(server.line().device().output(MotorId::Motor1).speed, 127);
    client.tell("82");
    QTRY_COMPARE(client.hear(), QByteArray("r"));
    server.powerCycle();
    QFile file(path);
    QVERIFY(file.open(QIODevice::ReadOnly));
    QStringList lines;
    while (!file.atEnd()) {
        const QJsonObject entry = QJsonDocument::fromJson(file.readLine()).object();
        QVERIFY(entry.value(QLatin1String("ms")).isDouble());
        QVERIFY(entry.value(QLatin1String("epochMs")).toDouble() > 1.6e12);
        lines.append(QStringLiteral("%1 %2 %3 %4")
                         .arg(entry.value(QLatin1String("event")).toString(),
                              entry.value(QLatin1String("kind")).toString(),
                              entry.value(QLatin1String("bytes")).toString())
                         .arg(entry.value(QLatin1String("speed")).toInt(-1)));
    }
    QCOMPARE(
        lines,
        (QStringList{QStringLiteral("started   -1"), QStringLiteral("packet motor 8007427F -1"),
                     QStringLiteral("output   127"), QStringLiteral("packet query 82 -1"),
                     QStringLiteral("powerCycle   -1"), QStringLiteral("output   0")}));
}

// C-40
void TstSimServer::state_isWrittenAtOnce()
{
    SimOptions options;
    options.stateFile = m_folder.filePath(QStringLiteral("state.json"));
    SimServer server(options);
    QVERIFY(server.listenPty(m_link));
    Client client(m_link);
    client.tell("AF0705552A");
    QTRY_COMPARE(client.hear().size(), 1);
    const auto eeproms = loadEeproms(options.stateFile); // as after a kill
    QVERIFY(eeproms);
    QCOMPARE(int(eeproms->at(0).at(0x07)), 5);
}

void TstSimServer::speed_makesTimeRunFaster()
{
    SimOptions options;
    options.speed = 1000.0;
    SimServer server(options);
    const Instant before = server.virtualNow();
    QTRY_VERIFY(server.virtualNow() - before > std::chrono::seconds(100));
    QVERIFY(server.line().device().firmware().uartErrorByte() == 0);
}

QTEST_GUILESS_MAIN(TstSimServer)
#include "tst_simserver.moc"
