// SPDX-License-Identifier: GPL-3.0-or-later
#include "protocol/codec/packet.h"
#include "protocol/procedures/scan.h"

#include <QSignalSpy>
#include <QTcpServer>
#include <QTcpSocket>
#include <QTest>

using namespace std::chrono_literals;
using namespace Qt::Literals::StringLiterals;
using namespace trex;

namespace {

constexpr int kLongMs = 60'000;

Result<void> run(Scan& scan)
{
    QSignalSpy finished(&scan, &Procedure::finished);
    scan.start();
    if (finished.isEmpty() && !finished.wait(kLongMs)) {
        return fail(ErrorCode::NoReply, u"the scan does not end"_s);
    }
    return finished.front().front().value<Result<void>>();
}

/// A port that keeps what it hears and answers nothing, or always the same bytes.
class Listener : public QObject {
public:
    explicit Listener(const QByteArray& answer = {}) : m_answer(answer)
    {
        m_server.listen(QHostAddress::LocalHost);
        connect(&m_server, &QTcpServer::newConnection, this, [this] {
            QTcpSocket* socket = m_server.nextPendingConnection();
            connect(socket, &QTcpSocket::readyRead, this, [this, socket] {
                heard << socket->readAll();
                socket->write(m_answer);
            });
            connect(socket, &QTcpSocket::disconnected, socket, &QObject::deleteLater);
        });
    }
    [[nodiscard]] QString port() const
    {
        return u"tcp://127.0.0.1:%1"_s.arg(m_server.serverPort());
    }
    QList<QByteArray> heard;

private:
    QByteArray m_answer;
    QTcpServer m_server;
};

} // namespace

class TestScan : public QObject {
    Q_OBJECT

private slots:
    void controller_isFound_data();
    void controller_isFound();
    void all_findsEveryDeviceNumber();
    void shorterSignature_isFound(); // C-70
    void silentPort_endsWithNoReply();
    void probes_areNothingElse();
    void garbage_isNoController();
    void missingPort_endsWithItsError();
    void cancel_ends();
    void progress_counts();
    void rememberedLine_isTriedFirst();
};

void TestScan::controller_isFound_data()
{
    QTest::addColumn<QString>("query");
    QTest::addColumn<int>("baud");
    QTest::addColumn<int>("detection");
    QTest::addColumn<int>("device");
    QTest::addColumn<bool>("echo");
    QTest::addColumn<int>("stopBits");
    const int none = int(ErrorDetection::None);
    QTest::newRow("default") << u""_s << 19200 << none << 7 << false << 1;
    QTest::newRow("115200") << u"baud=115200"_s << 115200 << none << 7 << false << 1;
    QTest::newRow("1200") << u"baud=1200"_s << 1200 << none << 7 << false << 1;
    QTest::newRow("crc7") << u"baud=9600&error-detection=crc7"_s << 9600
                          << int(ErrorDetection::Crc7) << 7 << false << 1;
    QTest::newRow("even") << u"baud=38400&error-detection=even"_s << 38400
                          << int(ErrorDetection::Even) << 7 << false << 1;
    QTest::newRow("odd") << u"error-detection=odd"_s << 19200 << int(ErrorDetection::Odd) << 7
                         << false << 1;
    QTest::newRow("device 12") << u"device=12"_s << 19200 << none << 12 << false << 1;
    QTest::newRow("echo") << u"echo=1"_s << 19200 << none << 7 << true << 1;
    QTest::newRow("two stop bits") << u"stop-bits=2&baud=9600"_s << 9600 << none << 7 << false << 2;
    QTest::newRow("echo and crc7")
        << u"echo=1&error-detection=crc7"_s << 19200 << int(ErrorDetection::Crc7) << 7 << true << 1;
}

void TestScan::controller_isFound()
{
    QFETCH(QString, query);
    QFETCH(int, baud);
    QFETCH(int, detection);
    QFETCH(int, device);
    QFETCH(bool, echo);
    QFETCH(int, stopBits);
    Scan scan({.port = u"sim:?"_s + query, .line = {}});
    QSignalSpy found(&scan, &Scan::found);
    const auto result = run(scan);
    QVERIFY2(result.has_value(), result ? "" : qPrintable(result.error().context));
    QCOMPARE(scan.hits().size(), std::size_t(1));
    QCOMPARE(found.size(), 1);
    const ScanHit& hit = scan.hits().front();
    QCOMPARE(hit.baud, baud);
    QCOMPARE(int(hit.errorDetection), detection);
    QCOMPARE(int(hit.device), device);
    QCOMPARE(hit.echo, echo);
    QCOMPARE(hit.signature.text(), u"TReXJr1.2"_s);
    QCOMPARE(hit.stopBits, stopBits);
}

void TestScan::all_findsEveryDeviceNumber()
{
    Scan scan({.port = u"sim:?device=3&device=9"_s, .line = {}, .all = true});
    QVERIFY(run(scan));
    std::vector<int> devices;
    for (const ScanHit& hit : scan.hits()) {
        QCOMPARE(hit.baud, 19200);
        devices.push_back(hit.device);
    }
    QCOMPARE(devices, (std::vector<int>{3, 9}));
}

void TestScan::shorterSignature_isFound()
{
    for (const auto& detection : {u"none"_s, u"crc7"_s}) {
        Scan scan({.port = u"sim:?model=trex&error-detection="_s + detection, .line = {}});
        QVERIFY(run(scan));
        QCOMPARE(scan.hits().front().signature.model, Model::Trex);
    }
}

void TestScan::silentPort_endsWithNoReply()
{
    const Listener listener;
    Scan scan({.port = listener.port(), .line = {}});
    const auto result = run(scan);
    QVERIFY(!result);
    QCOMPARE(result.error().code, ErrorCode::NoReply);
    QVERIFY(scan.hits().empty());
    QVERIFY(!scan.isRunning());
}

void TestScan::probes_areNothingElse()
{
    const Listener listener;
    LineSettings line;
    line.polynomial = 0xA1;
    Scan scan({.port = listener.port(), .line = line});
    QVERIFY(!run(scan));
    LineSettings crc = line;
    crc.errorDetection = ErrorDetection::Crc7;
    LineSettings factory = crc;
    factory.polynomial = kDefaultPolynomial;
    // A serial server has its own speed: only CRC-7 can differ.
    QByteArrayList questions;
    for (const LineSettings& asked : {line, crc, factory}) {
        questions << lineProbe(asked).pieces.front().bytes;
    }
    QCOMPARE(listener.heard, questions);
}

void TestScan::garbage_isNoController()
{
    const Listener listener("\xF0\x00TRe\x81\x81zzzzzzzzz"_ba);
    Scan scan({.port = listener.port(), .line = {}});
    QVERIFY(!run(scan));
    QCOMPARE(scan.heard(), LineAnswer::Garbage);
    for (const QByteArray& heard : listener.heard) {
        QVERIFY2(heard.startsWith('\x82') && heard.size() <= 2, heard.toHex().constData());
    }
}

void TestScan::missingPort_endsWithItsError()
{
    Scan scan({.port = u"/dev/no-such-port"_s, .line = {}});
    const auto result = run(scan);
    QVERIFY(!result);
    QCOMPARE(result.error().code, ErrorCode::PortMissing);
}

void TestScan::cancel_ends()
{
    Scan scan({.port = u"sim:?fault=drop=1"_s, .line = {}});
    QSignalSpy finished(&scan, &Procedure::finished);
    int tries = 0;
    connect(&scan, &Procedure::progressed, &scan, [&scan, &tries](int done) {
        ++tries;
        if (done == 3) {
            scan.cancel();
        }
    });
    scan.start();
    QVERIFY(finished.wait(kLongMs));
    QCOMPARE(finished.front().front().value<Result<void>>().error().code, ErrorCode::Cancelled);
    QCOMPARE(tries, 4);
    QVERIFY(!scan.isRunning());
    scan.cancel(); // nothing to cancel
    QCOMPARE(finished.size(), 1);
}

void TestScan::progress_counts()
{
    Scan scan({.port = u"sim:?error-detection=crc7"_s, .line = {}});
    QSignalSpy progressed(&scan, &Procedure::progressed);
    QCOMPARE(scan.estimatedRemaining(), Duration::zero());
    QVERIFY(run(scan));
    QCOMPARE(progressed.size(), 12); // 11 rates without, then CRC-7 at 19200
    for (qsizetype i = 0; i < progressed.size(); ++i) {
        QCOMPARE(progressed.at(i).at(0).toInt(), int(i));
        QCOMPARE(progressed.at(i).at(1).toInt(), 33);
        QVERIFY(progressed.at(i).at(2).toString().contains(u"baud"_s));
    }
}

void TestScan::rememberedLine_isTriedFirst()
{
    LineSettings line;
    line.baud = 57600;
    line.errorDetection = ErrorDetection::Crc7;
    line.polynomial = 0x91;
    Scan scan({.port = u"sim:?baud=57600&error-detection=crc7&crc-polynomial=145"_s,
               .line = {},
               .remembered = {line}});
    QSignalSpy progressed(&scan, &Procedure::progressed);
    QVERIFY(run(scan));
    QCOMPARE(progressed.size(), 1);
    const LineSettings found = scan.hits().front().line({});
    QCOMPARE(found.baud, 57600);
    QCOMPARE(int(found.polynomial), 0x91);
}

QTEST_GUILESS_MAIN(TestScan)
#include "tst_scan.moc"
