// SPDX-License-Identifier: GPL-3.0-or-later
// The journal as trexctl keeps it: what is recorded of each write, the way back, and what is found
// out after a program was killed in the midst of a write. This program is also the one that is
// killed.
#include "protocol/procedures/writeaudit.h"
#include "tests/app/commandrunner.h"

#include <QDir>
#include <QFile>
#include <QTest>

#include <csignal>
#include <unistd.h>

using namespace Qt::Literals::StringLiterals;
using namespace trex;

namespace {

QString journalPath()
{
    return qEnvironmentVariable("XDG_DATA_HOME") + u"/trexpanel/journal.sqlite"_s;
}

/// Writes a serial timeout of 900 ms to the controller on the port and is killed: "before" the
/// packet is sent, or "after" it was answered and before that is known.
int writeAndBeKilled(const QString& when, const QString& port)
{
    Controller controller(nullptr, nullptr);
    DeviceSettings settings(controller);
    Journal journal(journalPath());
    WriteAudit audit(controller, settings, journal, WriteAudit::WhenUnsaved::RefuseOnce);
    QObject::connect(&audit, &WriteAudit::recorded, [&] {
        if (when == "before"_L1 && !journal.entries({.controller = {}, .setting = {}})->empty()) {
            ::kill(::getpid(), SIGKILL);
        }
    });
    QObject::connect(&controller, &Controller::recordsArrived,
                     [&](const std::vector<TransactionRecord>& records) {
                         for (const auto& record : records) {
                             if (record.command.row().kind == CommandKind::Setting) {
                                 ::kill(::getpid(), SIGKILL);
                             }
                         }
                     });
    QObject::connect(&controller, &Controller::stateChanged, [&](LinkState state) {
        if (state == LinkState::Connected) {
            settings.writeParameter(parameterRow("serial-timeout"), 9, true, &controller,
                                    [](const auto& /*result*/) { QCoreApplication::exit(2); });
        }
    });
    OpenOptions options;
    options.port = port;
    controller.open(options);
    return QCoreApplication::exec();
}

} // namespace

class tst_trexctl_journal : public QObject {
    Q_OBJECT

    static QStringList ask(const Simulator& simulator, const QString& command)
    {
        return QStringList{u"--port"_s, simulator.port(), u"--json"_s} + words(command);
    }

private slots:
    void init() { QDir(QFileInfo(journalPath()).absolutePath()).removeRecursively(); }

    void write_isInTheJournal();
    void unchangedValue_leavesNoTraceAndAsksLittle();
    void configLoad_isInTheJournal();
    void raw_isInTheJournal();
    void journal_isOfThisPortUnlessAll();
    void revert_bringsBackWhatWasThere();
    void revert_dryRunWritesNothing();
    void revert_ofAnotherControllersEntryIsRefused();
    void checkpoint_isKeptListedRestoredAndDeleted();
    void killedInTheMidst_isNamedByTheNext_data();
    void killedInTheMidst_isNamedByTheNext();
    void unusableJournal_isToldAndTheValueWritten();
};

void tst_trexctl_journal::write_isInTheJournal()
{
    Simulator simulator;
    QCOMPARE(run(ask(simulator, u"param set serial-timeout 500ms"_s)).code, 0);
    QCOMPARE(run(ask(simulator, u"calibration set 2 2600 3700 4900 80"_s)).code, 0);
    const Finished shown = run(ask(simulator, u"journal"_s));
    QCOMPARE(shown.code, 0);
    QVERIFY2(shown.err.isEmpty(), shown.err);
    const QJsonArray entries = shown.array();
    QCOMPARE(entries.size(), 2);
    const QJsonObject first = entries.first().toObject();
    QCOMPARE(first["key"_L1].toString(), u"serial-timeout"_s);
    QCOMPARE(first["from"_L1].toInt(-1), 0);
    QCOMPARE(first["to"_L1].toInt(-1), 5);
    QCOMPARE(first["result"_L1].toString(), u"new"_s);
    QCOMPARE(first["packet"_L1].toString(), u"AF0705552A"_s);
    QCOMPARE(first["port"_L1].toString(), simulator.port());
    QCOMPARE(first["signature"_L1].toString(), u"TReXJr1.2"_s);
    QCOMPARE(first["device"_L1].toInt(), 7);
    QCOMPARE(first["program"_L1].toString(), u"trexctl"_s);
    const QJsonObject second = entries.last().toObject();
    QCOMPARE(second["key"_L1].toString(), u"calibration.rc.2"_s);
    QCOMPARE(second["to"_L1].toObject()["minimum"_L1].toInt(), 2600);
    const QJsonArray kept = run(ask(simulator, u"checkpoint list"_s)).array();
    QCOMPARE(kept.size(), 2); // one a connection
    QVERIFY(kept.first()["automatic"_L1].toBool());
}

void tst_trexctl_journal::unchangedValue_leavesNoTraceAndAsksLittle()
{
    Simulator simulator;
    QCOMPARE(run(ask(simulator, u"param set serial-timeout 0"_s)).code, 0);
    QVERIFY(run(ask(simulator, u"journal"_s)).array().isEmpty());
    QVERIFY(!QFile::exists(journalPath()));
    QVERIFY(simulator.packets().size() < 10);
}

void tst_trexctl_journal::configLoad_isInTheJournal()
{
    QTemporaryDir folder;
    Simulator simulator;
    const QString file = folder.filePath(u"start.json"_s);
    QCOMPARE(run(ask(simulator, u"config save "_s + file)).code, 0);
    QCOMPARE(run(ask(simulator, u"param set serial-timeout 5"_s)).code, 0);
    QCOMPARE(run(ask(simulator, u"config load "_s + file)).code, 0);
    const QJsonArray entries = run(ask(simulator, u"journal"_s)).array();
    QCOMPARE(entries.size(), 2);
    QCOMPARE(entries.last()["to"_L1].toInt(-1), 0);
}

void tst_trexctl_journal::raw_isInTheJournal()
{
    Simulator simulator;
    QCOMPARE(run(ask(simulator, u"raw AF0705552A --reply 1"_s)).code, 0);
    const QJsonArray entries = run(ask(simulator, u"journal"_s)).array();
    QCOMPARE(entries.size(), 1);
    QCOMPARE(entries.first()["result"_L1].toString(), u"answered"_s);
}

void tst_trexctl_journal::journal_isOfThisPortUnlessAll()
{
    Simulator one;
    Simulator other;
    QCOMPARE(run(ask(one, u"param set serial-timeout 5"_s)).code, 0);
    QCOMPARE(run(ask(other, u"param set serial-timeout 6"_s)).code, 0);
    QCOMPARE(run(ask(one, u"journal"_s)).array().size(), 1);
    QCOMPARE(run(ask(one, u"journal --all"_s)).array().size(), 2);
}

void tst_trexctl_journal::revert_bringsBackWhatWasThere()
{
    QTemporaryDir folder;
    Simulator simulator;
    QCOMPARE(run(ask(simulator, u"config save "_s + folder.filePath(u"start.json"_s))).code, 0);
    QCOMPARE(run(ask(simulator, u"param set serial-timeout 5"_s)).code, 0);
    QCOMPARE(run(ask(simulator, u"calibration set 2 2600 3700 4900 80"_s)).code, 0);
    QCOMPARE(run(ask(simulator, u"param set serial-timeout 6"_s)).code, 0);
    const Finished reverted = run(ask(simulator, u"journal revert 1"_s));
    QVERIFY2(reverted.code == 0, reverted.err);
    QCOMPARE(reverted.object()["changed"_L1].toArray().size(), 1 + 4);
    const Finished diff = run(ask(simulator, u"config diff "_s + folder.filePath(u"start.json"_s)));
    QVERIFY2(diff.object()["changed"_L1].toArray().isEmpty(), diff.out);
    QVERIFY(run(ask(simulator, u"journal revert 1"_s)).object()["changed"_L1].toArray().isEmpty());
}

void tst_trexctl_journal::revert_dryRunWritesNothing()
{
    Simulator simulator;
    QCOMPARE(run(ask(simulator, u"param set serial-timeout 5"_s)).code, 0);
    const Finished shown = run(ask(simulator, u"journal revert 1 --dry-run"_s));
    QCOMPARE(shown.object()["packets"_L1].toArray().first().toString(), u"AF0700552A"_s);
    QCOMPARE(run(ask(simulator, u"journal"_s)).array().size(), 1);
}

void tst_trexctl_journal::revert_ofAnotherControllersEntryIsRefused()
{
    Simulator simulator;
    Simulator other({u"--device"_s, u"9"_s});
    QCOMPARE(run(ask(other, u"param set serial-timeout 5"_s)).code, 0);
    QCOMPARE(run(ask(simulator, u"param set serial-timeout 6"_s)).code, 0);
    const Finished refused = run(ask(simulator, u"journal revert 1"_s));
    QCOMPARE(refused.code, 2);
    QVERIFY(refused.out.isEmpty());
    QCOMPARE(refused.errLines().size(), 1);
    QCOMPARE(run(ask(simulator, u"journal revert 99"_s)).code, 2);
    QCOMPARE(run(ask(simulator, u"journal revert x"_s)).code, 2);
}

void tst_trexctl_journal::checkpoint_isKeptListedRestoredAndDeleted()
{
    Simulator simulator;
    QCOMPARE(run(ask(simulator, u"checkpoint save start"_s)).code, 0);
    QCOMPARE(run(ask(simulator, u"checkpoint save start"_s)).code, 2); // taken
    QCOMPARE(run(ask(simulator, u"param set serial-timeout 5"_s)).code, 0);
    const QJsonArray kept = run(ask(simulator, u"checkpoint list"_s)).array();
    QCOMPARE(kept.size(), 2);
    QCOMPARE(kept.last()["name"_L1].toString(), u"start"_s);
    const Finished restored = run(ask(simulator, u"checkpoint restore start"_s));
    QVERIFY2(restored.code == 0, restored.err);
    QCOMPARE(run(ask(simulator, u"param get serial-timeout"_s)).object()["value"_L1].toInt(-1), 0);
    QCOMPARE(run(ask(simulator, u"checkpoint restore nope"_s)).code, 2);
    QCOMPARE(run(ask(simulator, u"checkpoint delete start"_s)).code, 0);
    QCOMPARE(run(ask(simulator, u"checkpoint delete start"_s)).code, 2);
}

void tst_trexctl_journal::killedInTheMidst_isNamedByTheNext_data()
{
    QTest::addColumn<QString>("when");
    QTest::addColumn<QString>("result");
    QTest::addColumn<int>("value");
    QTest::newRow("before the packet") << u"before"_s << u"old"_s << 0;
    QTest::newRow("after the packet") << u"after"_s << u"new"_s << 9;
}

void tst_trexctl_journal::killedInTheMidst_isNamedByTheNext()
{
    QFETCH(QString, when);
    QFETCH(QString, result);
    QFETCH(int, value);
    Simulator simulator;
    QProcess killed;
    killed.setProcessChannelMode(QProcess::ForwardedChannels);
    killed.start(QCoreApplication::applicationFilePath(), {u"--killed"_s, when, simulator.port()});
    QVERIFY(killed.waitForFinished());
    QCOMPARE(killed.exitStatus(), QProcess::CrashExit);
    QCOMPARE(run(ask(simulator, u"journal"_s)).array().first()["result"_L1].toString(),
             u"unknown"_s);

    const Finished next = run(ask(simulator, u"param get motor-mode"_s)); // asks for another one
    QCOMPARE(next.code, 0);
    QCOMPARE(next.object()["key"_L1].toString(), u"motor-mode"_s);
    QCOMPARE(next.errLines().size(), 1);
    QVERIFY2(next.err.contains("Serial timeout") && next.err.contains(result.toUtf8() + " value"),
             next.err);
    QCOMPARE(run(ask(simulator, u"journal"_s)).array().first()["result"_L1].toString(), result);
    const Finished again = run(ask(simulator, u"param get serial-timeout"_s));
    QCOMPARE(again.object()["value"_L1].toInt(-1), value);
    QVERIFY2(again.err.isEmpty(), again.err); // told once
}

void tst_trexctl_journal::unusableJournal_isToldAndTheValueWritten()
{
    QVERIFY(QDir().mkpath(journalPath())); // a folder where the file should be
    Simulator simulator;
    const Finished written = run(ask(simulator, u"param set serial-timeout 5"_s));
    QCOMPARE(written.code, 0);
    QVERIFY(written.object()["verified"_L1].toBool());
    QCOMPARE(written.errLines().size(), 1);
    QVERIFY2(written.err.contains(journalPath().toUtf8()), written.err);
    QVERIFY(run(ask(simulator, u"journal"_s)).code != 0);
}

int main(int argc, char* argv[])
{
    QCoreApplication app(argc, argv);
    const QStringList arguments = QCoreApplication::arguments();
    if (arguments.size() == 4 && arguments.at(1) == "--killed"_L1) {
        return writeAndBeKilled(arguments.at(2), arguments.at(3));
    }
    tst_trexctl_journal test;
    return QTest::qExec(&test, argc, argv);
}

#include "tst_trexctl_journal.moc"
