// SPDX-License-Identifier: GPL-3.0-or-later
// Connect, ask, drive, disconnect, over and over, with the real worker thread: nothing is left
// behind by any of it. 1,000 times with TREX_EXHAUSTIVE=1, else 30.
#include "protocol/session/controller.h"
#include "tests/support/simwitness.h"

#include <QDir>
#include <QTemporaryDir>
#include <QTest>

#include <cstdio>
#include <malloc.h>

using namespace trex;
using namespace Qt::Literals::StringLiterals;

namespace {

constexpr int kWarmUp = 10;
constexpr int kPatienceMs = 20'000;

int cycles()
{
    return qEnvironmentVariableIsSet("TREX_EXHAUSTIVE") ? 1000 : 30;
}

/// What this process holds.
struct Held {
    qint64 threads = 0;
    qint64 files = 0;
    qint64 heap = 0; ///< bytes in use; 0 under sanitizers, which have their own
    qint64 resident = 0; ///< bytes
    qint64 objects = 0; ///< that belong to the controller

    static Held now(const Controller& controller)
    {
        Held held;
        QFile status(u"/proc/self/status"_s);
        if (status.open(QIODevice::ReadOnly)) {
            for (const QByteArray& line : status.readAll().split('\n')) {
                const qint64 number = line.simplified().split(' ').value(1).toLongLong();
                held.threads = line.startsWith("Threads:") ? number : held.threads;
                held.resident = line.startsWith("VmRSS:") ? number * 1024 : held.resident;
            }
        }
        held.files = QDir(u"/proc/self/fd"_s).entryList(QDir::AllEntries | QDir::System).size();
        held.heap = static_cast<qint64>(mallinfo2().uordblks);
        held.objects = controller.findChildren<QObject*>().size();
        return held;
    }
};

} // namespace

class TestConnectCycles : public QObject {
    Q_OBJECT

public:
    static void initMain() { qputenv("QTEST_FUNCTION_TIMEOUT", "3600000"); }

private slots:
    void cycles_leaveNothingBehind_data()
    {
        QTest::addColumn<bool>("overPty");
        QTest::newRow("sim") << false;
        QTest::newRow("pty") << true;
    }
    void cycles_leaveNothingBehind();

private:
    static void cycle(Controller& controller, const OpenOptions& options);
};

void TestConnectCycles::cycle(Controller& controller, const OpenOptions& options)
{
    QObject panel;
    controller.want(&panel, PollId::Currents, 80.0);
    controller.open(options);
    QTRY_COMPARE_WITH_TIMEOUT(controller.state(), LinkState::Connected, kPatienceMs);
    bool isAnswered = false;
    controller.request(query("get-mode"), &panel, [&](const Result<Reply>&) { isAnswered = true; });
    QTRY_VERIFY_WITH_TIMEOUT(isAnswered, kPatienceMs);
    QVERIFY(controller.arm().has_value());
    QVERIFY(controller.driveMotor(MotorId::Motor1, {MotorOrder::Action::Set, 30}).has_value());
    bool isClosed = false;
    connect(&controller, &Controller::closed, &panel, [&] { isClosed = true; });
    controller.close();
    QTRY_VERIFY_WITH_TIMEOUT(isClosed, kPatienceMs);
    controller.wantNothing(&panel);
}

void TestConnectCycles::cycles_leaveNothingBehind()
{
    QFETCH(bool, overPty);
    QTemporaryDir folder;
    OpenOptions options;
    options.port = u"sim:?baud=115200"_s;
    options.line.baud = 115200;
    std::unique_ptr<test::SimWitness> server;
    if (overPty) {
        options.port = folder.filePath(u"port"_s);
        sim::SimOptions simulated;
        simulated.baud = 115200;
        server = std::make_unique<test::SimWitness>(simulated, options.port,
                                                    folder.filePath(u"log.jsonl"_s));
        QVERIFY(server->isOk());
    }
    auto controller = std::make_unique<Controller>(nullptr, nullptr);
    Held before;
    for (int i = -kWarmUp; i < cycles(); ++i) {
        if (i % 10 == 0) { // thread, worker and all
            controller = std::make_unique<Controller>(nullptr, nullptr);
        }
        cycle(*controller, options);
        if (QTest::currentTestFailed()) {
            return;
        }
        if (i == -1) {
            before = Held::now(*controller);
        }
    }
    const Held after = Held::now(*controller);
    std::printf("%s, %d cycles: threads %+lld, files %+lld, objects %+lld, heap %+lld bytes, "
                "resident %+lld KiB\n",
                QTest::currentDataTag(), cycles(),
                static_cast<long long>(after.threads - before.threads),
                static_cast<long long>(after.files - before.files),
                static_cast<long long>(after.objects - before.objects),
                static_cast<long long>(after.heap - before.heap),
                static_cast<long long>((after.resident - before.resident) / 1024));
    QCOMPARE(after.threads, before.threads);
    QCOMPARE(after.files, before.files);
    QCOMPARE(after.objects, before.objects);
    // The simulated controller's own record over the pty grows to its bound meanwhile.
    constexpr qint64 kMostHeap = 256 << 10;
    QVERIFY2(after.heap - before.heap < kMostHeap, "the heap has grown");
#if !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)
    QVERIFY2(after.resident - before.resident < 4 << 20, "the process has grown");
#endif
}

QTEST_GUILESS_MAIN(TestConnectCycles)
#include "tst_connectcycles.moc"
