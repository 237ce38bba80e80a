// SPDX-License-Identifier: GPL-3.0-or-later
// Over real sockets to a peer in the test; the last ones with the whole link above.
#include "protocol/session/controller.h"
#include "protocol/transport/tcptransport.h"

#include <QElapsedTimer>
#include <QSignalSpy>
#include <QTcpServer>
#include <QTcpSocket>
#include <QTest>
#include <QTimer>

#ifdef Q_OS_LINUX
#include <netinet/in.h>
#include <netinet/tcp.h>
#include <sys/socket.h>
#endif

using namespace trex;
using namespace std::chrono_literals;
using namespace Qt::Literals::StringLiterals;

namespace {

struct Bench {
    explicit Bench(quint16 port) : transport(u"127.0.0.1"_s, port)
    {
        QObject::connect(&transport, &Transport::opened, &transport, [this] { ++opened; });
        QObject::connect(&transport, &Transport::received, &transport,
                         [this](const QByteArray& bytes, Instant) { received += bytes; });
        QObject::connect(&transport, &Transport::failed, &transport,
                         [this](const Error& error) { errors.push_back(error); });
    }
    TcpTransport transport;
    int opened = 0;
    QByteArray received;
    std::vector<Error> errors;
};

} // namespace

class TestTcpTransport : public QObject {
    Q_OBJECT

private slots:
    void peer_getsAndGivesBytes()
    {
        QTcpServer server;
        QVERIFY(server.listen(QHostAddress::LocalHost));
        Bench bench(server.serverPort());
        bench.transport.open({});
        QTRY_COMPARE(bench.opened, 1);
        QTRY_VERIFY(server.hasPendingConnections());
        QTcpSocket* peer = server.nextPendingConnection();
        bench.transport.write(QByteArray::fromHex("861f00ff0a0d"));
        QTRY_COMPARE(peer->bytesAvailable(), 6);
        QCOMPARE(peer->readAll(), QByteArray::fromHex("861f00ff0a0d"));
        QVERIFY(!bench.transport.waitForBytes(5ms));
        peer->write("TReX");
        peer->flush();
        QVERIFY(bench.transport.waitForBytes(1s));
        QCOMPARE(bench.received, QByteArray("TReX"));
        QVERIFY(bench.errors.empty());
    }

    void refusedConnection_isAMissingPort()
    {
        quint16 port = 0;
        {
            QTcpServer server;
            QVERIFY(server.listen(QHostAddress::LocalHost));
            port = server.serverPort();
        }
        Bench bench(port);
        bench.transport.open({});
        QTRY_COMPARE(bench.errors.size(), std::size_t{1});
        QCOMPARE(bench.errors.front().code, ErrorCode::PortMissing);
        QCOMPARE(bench.errors.front().context, u"tcp://127.0.0.1:%1"_s.arg(port));
        // Somebody listens now: the same transport gets through.
        QTcpServer server;
        QVERIFY(server.listen(QHostAddress::LocalHost, port));
        bench.transport.open({});
        QTRY_COMPARE(bench.opened, 1);
        QTest::qWait(20);
        QCOMPARE(bench.errors.size(), std::size_t{1});
    }

    void closingPeer_isALostLine()
    {
        QTcpServer server;
        QVERIFY(server.listen(QHostAddress::LocalHost));
        Bench bench(server.serverPort());
        bench.transport.open({});
        QTRY_VERIFY(server.hasPendingConnections());
        QTRY_COMPARE(bench.opened, 1);
        QTcpSocket* peer = server.nextPendingConnection();
        peer->write("last words");
        peer->disconnectFromHost();
        QTRY_COMPARE(bench.errors.size(), std::size_t{1});
        QCOMPARE(bench.errors.front().code, ErrorCode::LineLost);
        QCOMPARE(bench.received, QByteArray("last words"));
        bench.transport.open({}); // at once
        QTRY_COMPARE(bench.opened, 2);
        QTest::qWait(20);
        bench.transport.write("\x81");
        QTRY_VERIFY(server.hasPendingConnections());
        peer = server.nextPendingConnection();
        QTRY_COMPARE(peer->bytesAvailable(), 1);
    }

    void unheardPeer_isGivenUpBySystem()
    {
        QTcpServer server;
        QVERIFY(server.listen(QHostAddress::LocalHost));
        Bench bench(server.serverPort());
        bench.transport.open({});
        QTRY_COMPARE(bench.opened, 1);
#ifdef Q_OS_LINUX
        unsigned milliseconds = 0;
        socklen_t size = sizeof milliseconds;
        QCOMPARE(::getsockopt(bench.transport.descriptor(), IPPROTO_TCP, TCP_USER_TIMEOUT,
                              &milliseconds, &size),
                 0);
        QCOMPARE(milliseconds, 2000U);
#endif
        QCOMPARE(bench.transport.adapter().kind, AdapterFacts::Kind::Network);
    }

    void close_isSilent()
    {
        QTcpServer server;
        QVERIFY(server.listen(QHostAddress::LocalHost));
        Bench bench(server.serverPort());
        bench.transport.open({});
        QTRY_COMPARE(bench.opened, 1);
        bench.transport.close();
        QTest::qWait(20);
        QVERIFY(bench.errors.empty());
    }

    void rubbishAtFullRate_isNoControllerAndClosesInTime()
    {
        QTcpServer server;
        QVERIFY(server.listen(QHostAddress::LocalHost));
        const QByteArray rubbish(64 * 1024, '\xA5');
        quint64 given = 0;
        connect(&server, &QTcpServer::newConnection, &server, [&] {
            QTcpSocket* peer = server.nextPendingConnection();
            const auto pour = [peer, &rubbish, &given] {
                while (peer->state() == QAbstractSocket::ConnectedState
                       && peer->bytesToWrite() < rubbish.size()) {
                    given += static_cast<quint64>(peer->write(rubbish));
                }
            };
            connect(peer, &QTcpSocket::bytesWritten, peer, pour);
            pour();
        });
        Controller controller(nullptr, nullptr);
        OpenOptions options;
        options.port = u"tcp://127.0.0.1:%1"_s.arg(server.serverPort());
        controller.open(options);
        QTRY_VERIFY_WITH_TIMEOUT(controller.lastError().has_value(), 10'000);
        QVERIFY(controller.state() != LinkState::Connected);
        QCOMPARE(controller.lastError()->code, ErrorCode::Garbage);
        QVERIFY(given > 128 * 1024);
        QSignalSpy closed(&controller, &Controller::closed);
        QElapsedTimer clock;
        clock.start();
        controller.close();
        QTRY_COMPARE_WITH_TIMEOUT(closed.count(), 1, 10'000);
        QVERIFY(clock.elapsed() < 5000);
    }
};

QTEST_GUILESS_MAIN(TestTcpTransport)
#include "tst_tcptransport.moc"
