// SPDX-License-Identifier: GPL-3.0-or-later
// The window's recording over every way out: what a quit, a signal, a kill and a full disk leave.
#include "protocol/errortext.h"
#include "protocol/storage/recordingreader.h"

#include <QDir>
#include <QFile>
#include <QProcess>
#include <QTemporaryDir>
#include <QTest>

#include <csignal>
#include <random>

using namespace Qt::Literals::StringLiterals;
using namespace trex;

namespace {

constexpr auto kRecordAndWait =
    R"({"steps":[{"waitFor":{"object":"connection.state","property":"state","equals":"connected"},"timeoutMs":20000},
        {"click":"action.record.packets"},{"click":"action.record"},{"sleepMs":60000}]})";
constexpr auto kRecordAndQuit =
    R"({"steps":[{"waitFor":{"object":"connection.state","property":"state","equals":"connected"},"timeoutMs":20000},
        {"click":"action.record"},{"click":"motors.arm"},{"sleepMs":1500},{"quit":true}]})";
constexpr auto kRecordUntilFull =
    R"({"steps":[{"waitFor":{"object":"connection.state","property":"state","equals":"connected"},"timeoutMs":20000},
        {"click":"action.record.packets"},{"click":"action.record"},
        {"waitFor":{"object":"mainWindow.recording","property":"text","matches":"could not be written"},"timeoutMs":60000},
        {"expect":{"object":"action.record","property":"checked","equals":false}},
        {"expect":{"object":"connection.state","property":"state","equals":"connected"}}]})";

} // namespace

class tst_panelrecording : public QObject {
    Q_OBJECT

private slots:
    void init() { m_folder = std::make_unique<QTemporaryDir>(); }
    void quit_endsRecording();
    void termination_endsRecording();
    void kill_losesASecondAtMost();
    void fullDisk_isToldAndKeeps();
    void argument_mustBeARecording();

private:
    QString path(const QString& name) const { return m_folder->filePath(name); }
    QStringList arguments(const char* script) const
    {
        QFile file(path(u"script.json"_s));
        if (file.open(QIODevice::WriteOnly)) {
            file.write(script);
        }
        return {u"--offscreen"_s, u"--simulate"_s, u"--settings"_s, path(u"settings.ini"_s),
                u"--script"_s,    file.fileName(), u"--language"_s, u"en"_s};
    }
    /// The one recording that there is; empty: none yet.
    QString recording() const
    {
        const QDir folder(path(u"recordings"_s));
        const QStringList files = folder.entryList({u"*.trexrec"_s}, QDir::Files);
        return files.isEmpty() ? QString() : folder.filePath(files.first());
    }
    std::unique_ptr<QTemporaryDir> m_folder;
};

void tst_panelrecording::quit_endsRecording()
{
    QProcess panel;
    panel.start(QStringLiteral(TREXPANEL), arguments(kRecordAndQuit));
    QVERIFY(panel.waitForFinished(60'000));
    QCOMPARE(panel.exitCode(), 0);
    const auto reader = RecordingReader::open(recording());
    QVERIFY2(reader, reader ? "" : qPrintable(errorText(reader.error())));
    QVERIFY((*reader)->isFinished());
    QVERIFY(!QFile::exists(recording() + u"-wal"_s));
    QVERIFY((*reader)->samples(PollId::Currents) > 20);
    QVERIFY((*reader)->samples(PollId::RawChannels) > 10);
    QVERIFY(!(*reader)->configurations().empty());
    // The quit's own stop is in it, and the flight recorder kept it as well.
    bool hasStop = false;
    for (const RecordedEvent& event : (*reader)->events()) {
        hasStop = hasStop || event.kind == u"order"_s;
    }
    QVERIFY(hasStop);
    QCOMPARE((*reader)->fact("program"), u"trexpanel"_s);
    QVERIFY(!(*reader)->fact("program-version").isEmpty());
}

void tst_panelrecording::termination_endsRecording()
{
    QProcess panel;
    panel.start(QStringLiteral(TREXPANEL), arguments(kRecordAndWait));
    QTRY_VERIFY_WITH_TIMEOUT(!recording().isEmpty(), 30'000);
    QTest::qWait(1500);
    panel.terminate();
    QVERIFY(panel.waitForFinished(30'000));
    QCOMPARE(panel.exitStatus(), QProcess::NormalExit);
    const auto reader = RecordingReader::open(recording());
    QVERIFY2(reader, reader ? "" : qPrintable(errorText(reader.error())));
    QVERIFY((*reader)->isFinished());
    QVERIFY((*reader)->packetCount() > 50);
}

void tst_panelrecording::kill_losesASecondAtMost()
{
    const int rounds = qEnvironmentVariableIsSet("TREX_EXHAUSTIVE") ? 20 : 2;
    std::minstd_rand random(23);
    for (int round = 0; round < rounds; ++round) {
        init();
        QProcess panel;
        panel.start(QStringLiteral(TREXPANEL), arguments(kRecordAndWait));
        QTRY_VERIFY_WITH_TIMEOUT(!recording().isEmpty(), 30'000);
        QTest::qWait(1200 + static_cast<int>(random() % 1500));
        const QDateTime killed = QDateTime::currentDateTimeUtc();
        panel.kill();
        QVERIFY(panel.waitForFinished(30'000));
        auto opened = RecordingReader::open(recording());
        QVERIFY2(opened, opened ? "" : qPrintable(errorText(opened.error())));
        RecordingReader& reader = **opened;
        QVERIFY(!reader.isFinished());
        TelemetryStore store;
        reader.loadAll(store, Instant());
        QVERIFY2(!reader.remark().contains(u"damaged"_s), qPrintable(reader.remark()));
        QVERIFY(reader.range());
        const QDateTime last = reader.started().addMSecs(reader.range()->second / 100);
        QVERIFY2(last.msecsTo(killed) <= 1000, qPrintable(QString::number(last.msecsTo(killed))));
    }
}

void tst_panelrecording::fullDisk_isToldAndKeeps()
{
#ifdef Q_OS_UNIX
    QProcess panel;
    // No file may grow beyond this; the signal of it is ignored, so that the write fails, as it
    // does on a full disk.
    panel.start(u"/bin/sh"_s,
                QStringList{u"-c"_s, u"trap '' XFSZ; ulimit -f 700; exec \"$0\" \"$@\""_s,
                            QStringLiteral(TREXPANEL)}
                    + arguments(kRecordUntilFull));
    QVERIFY(panel.waitForFinished(100'000));
    QVERIFY2(panel.exitCode() == 0, panel.readAllStandardError());
    auto reader = RecordingReader::open(recording());
    QVERIFY2(reader, reader ? "" : qPrintable(errorText(reader.error())));
    TelemetryStore store;
    (*reader)->loadAll(store, Instant());
    QVERIFY2(!(*reader)->remark().contains(u"damaged"_s), qPrintable((*reader)->remark()));
    QVERIFY(store.series("motor1-current").size() > 10);
#else
    QSKIP("there is no limit of a file's size to set");
#endif
}

void tst_panelrecording::argument_mustBeARecording()
{
    QFile stranger(path(u"notes.txt"_s));
    QVERIFY(stranger.open(QIODevice::WriteOnly) && stranger.write("no recording") > 0);
    stranger.close();
    for (const QString& file : {stranger.fileName(), path(u"missing.trexrec"_s)}) {
        QProcess panel;
        panel.start(QStringLiteral(TREXPANEL),
                    {u"--offscreen"_s, u"--settings"_s, path(u"settings.ini"_s), file});
        QVERIFY(panel.waitForFinished(30'000));
        QCOMPARE(panel.exitCode(), 2);
        const QByteArray err = panel.readAllStandardError();
        QVERIFY2(err.contains(file.toUtf8()) && err.trimmed().count('\n') == 0, err);
    }
}

QTEST_GUILESS_MAIN(tst_panelrecording)
#include "tst_panelrecording.moc"
