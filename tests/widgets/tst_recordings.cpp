// SPDX-License-Identifier: GPL-3.0-or-later
// The window's recordings on the simulated controller: one click, the settings in the file, and
// every trouble told.
#include "protocol/storage/recordingreader.h"
#include "tests/support/panelbench.h"
#include "widgets/recording/recordinglamp.h"
#include "widgets/recording/recordingmenu.h"
#include "widgets/recording/recordings.h"

#include <QAction>
#include <QDir>
#include <QLabel>
#include <QMenu>
#include <QSignalSpy>

using namespace Qt::Literals::StringLiterals;
using namespace trex;

namespace {

constexpr int kPatience = 20'000; // ms

/// Holds what the main window holds.
class Host : public Panel {
public:
    explicit Host(PanelContext& context)
        : Panel(context)
        , recordings(context, {{u"program"_s, u"test"_s}, {u"program-version"_s, u"9.9"_s}})
        , actions(context, recordings, this)
        , lamp(recordings, context.ticker, this)
    {
        actions.addTo(menu);
    }
    Recordings recordings;
    RecordingActions actions;
    RecordingLamp lamp;
    QMenu menu;
};
using Bench = test::PanelBench<Host>;

QString newest(const EventLog& log)
{
    return log.rowCount() == 0 ? QString() : log.at(log.rowCount() - 1).text;
}

bool hasEntry(const EventLog& log, int severity, const QString& part)
{
    for (int row = 0; row < log.rowCount(); ++row) {
        if (log.at(row).severity == severity && log.at(row).text.contains(part)) {
            return true;
        }
    }
    return false;
}

QAction* action(Bench& bench, const QString& name)
{
    return bench.panel.findChild<QAction*>(u"action."_s + name);
}

} // namespace

class tst_recordings : public QObject {
    Q_OBJECT

private slots:
    void oneClick_recordsEverything();
    void settings_areInTheFileAndFollow();
    void twoRecordings_haveTwoNames();
    void badFolder_isToldAtOnce();
    void lastMinutes_areKeptByHand();
    void flightRecorder_canBeSwitchedOff();
    void chosenFolders_areUsed();
    void lengthOfTheLastMinutes_isChosenInTheMenu();
};

void tst_recordings::oneClick_recordsEverything()
{
    Bench bench;
    QVERIFY(bench.connectTo(u"sim:"_s));
    Recordings& recordings = bench.panel.recordings;
    QVERIFY(!bench.panel.lamp.isVisible());
    action(bench, u"record"_s)->trigger();
    QVERIFY(recordings.isRecording());
    QVERIFY(action(bench, u"record"_s)->isChecked());
    const auto* text = bench.part<QLabel>(u"mainWindow.recording"_s);
    QVERIFY(bench.panel.lamp.isVisible());
    // No panel asked for anything: the recording does.
    QTRY_VERIFY_WITH_TIMEOUT(bench.store.series("channel1-remapped").size() > 20, kPatience);
    QTRY_VERIFY_WITH_TIMEOUT(bench.store.series("motor1-current").size() > 20, kPatience);
    QTRY_VERIFY_WITH_TIMEOUT(recordings.bytes() > 20'000, kPatience);
    QTRY_VERIFY2(text->text().startsWith(u"recording 00:00:"_s), qPrintable(text->text()));
    QSignalSpy kept(&recordings, &Recordings::kept);
    action(bench, u"record"_s)->trigger();
    QTRY_COMPARE_WITH_TIMEOUT(kept.size(), 1, kPatience);
    QVERIFY(!bench.panel.lamp.isVisible() && recordings.problem().isEmpty());
    const QString path = kept[0][0].toString();
    QCOMPARE(path, recordings.path());
    QVERIFY(path.startsWith(bench.folder.filePath(u"recordings/trex-"_s)));
    QVERIFY(newest(bench.log).contains(path));
    auto reader = RecordingReader::open(path);
    QVERIFY(reader && (*reader)->isFinished());
    QVERIFY((*reader)->samples(PollId::Currents) > 20);
    QVERIFY((*reader)->samples(PollId::RemappedChannels) > 20);
    QCOMPARE((*reader)->fact("program-version"), u"9.9"_s);
    QCOMPARE((*reader)->packetCount(), std::size_t(0)); // on request only
}

void tst_recordings::settings_areInTheFileAndFollow()
{
    Bench bench;
    QVERIFY(bench.connectTo(u"sim:"_s));
    action(bench, u"record.packets"_s)->trigger();
    bench.panel.recordings.start();
    const ParameterRow& row = parameterRow("serial-timeout");
    QTRY_VERIFY_WITH_TIMEOUT(bench.settings.calibration(InputKind::Rc, kChannelCount), kPatience);
    bool isWritten = false;
    bench.settings.writeParameter(row, 42, true, this,
                                  [&](const auto& written) { isWritten = bool(written); });
    QTRY_VERIFY_WITH_TIMEOUT(isWritten, kPatience);
    QTest::qWait(600); // what settles is noted
    QSignalSpy kept(&bench.panel.recordings, &Recordings::kept);
    bench.panel.recordings.stop();
    QTRY_COMPARE_WITH_TIMEOUT(kept.size(), 1, kPatience);
    auto reader = RecordingReader::open(kept[0][0].toString());
    QVERIFY(reader);
    const auto configurations = (*reader)->configurations();
    QVERIFY(configurations.size() >= 2);
    QCOMPARE(configurations.back().configuration.parameters.at(row.number), 42);
    QVERIFY(configurations.front().configuration.parameters.count(row.number) == 0
            || configurations.front().configuration.parameters.at(row.number) != 42);
    QVERIFY((*reader)->packetCount() > 20);
}

void tst_recordings::twoRecordings_haveTwoNames()
{
    Bench bench;
    QSignalSpy kept(&bench.panel.recordings, &Recordings::kept);
    for (int i = 1; i <= 3; ++i) { // within one second, not even connected
        bench.panel.recordings.start();
        bench.panel.recordings.stop();
        QTRY_COMPARE_WITH_TIMEOUT(kept.size(), i, kPatience);
    }
    QCOMPARE(QDir(bench.folder.filePath(u"recordings"_s)).entryList(QDir::Files).size(), 3);
}

void tst_recordings::badFolder_isToldAtOnce()
{
    Bench bench;
    QFile inTheWay(bench.folder.filePath(u"recordings"_s));
    QVERIFY(inTheWay.open(QIODevice::WriteOnly));
    inTheWay.close();
    bench.panel.recordings.start();
    QTRY_VERIFY_WITH_TIMEOUT(!bench.panel.recordings.problem().isEmpty(), kPatience);
    QVERIFY(!bench.panel.recordings.isRecording());
    QVERIFY(!action(bench, u"record"_s)->isChecked());
    QVERIFY(hasEntry(bench.log, EventLog::Failure, u"recordings"_s));
    QVERIFY(bench.panel.lamp.isVisible());
    QVERIFY(bench.part<QLabel>(u"mainWindow.recording"_s)->text().contains(u"could not"_s));
    QVERIFY(inTheWay.remove());
    bench.panel.recordings.start(); // the next one forgets it
    QVERIFY(bench.panel.recordings.problem().isEmpty());
}

void tst_recordings::lastMinutes_areKeptByHand()
{
    Bench bench;
    QVERIFY(bench.connectTo(u"sim:"_s));
    QTRY_VERIFY_WITH_TIMEOUT(bench.store.series("status").size() > 3, kPatience);
    QSignalSpy kept(&bench.panel.recordings, &Recordings::kept);
    action(bench, u"keepLast"_s)->trigger();
    action(bench, u"keepLast"_s)->trigger(); // not too soon for a hand
    QTRY_COMPARE_WITH_TIMEOUT(kept.size(), 2, kPatience);
    const QString path = kept[0][0].toString();
    QVERIFY(path.endsWith(u"-kept.trexrec"_s) && newest(bench.log).contains(u"flight"_s));
    auto reader = RecordingReader::open(path);
    QVERIFY(reader);
    QVERIFY((*reader)->samples(PollId::Status) > 3);
    QStringList links;
    for (const RecordedEvent& event : (*reader)->events()) {
        if (event.kind == u"link"_s) {
            links << event.text;
        }
    }
    QCOMPARE(links.last(), u"connected"_s);
}

void tst_recordings::flightRecorder_canBeSwitchedOff()
{
    Bench bench;
    QVERIFY(bench.connectTo(u"sim:"_s));
    action(bench, u"flightRecorder"_s)->trigger();
    QCOMPARE(bench.uiSettings.value(settings::kFlightEnabled), false);
    QVERIFY(bench.controller.arm());
    bench.controller.stop();
    QTest::qWait(2600); // it would have been frozen two seconds after
    QVERIFY(!QDir(bench.folder.filePath(u"flight"_s)).exists());
    action(bench, u"flightRecorder"_s)->trigger();
    QSignalSpy kept(&bench.panel.recordings, &Recordings::kept);
    QTRY_VERIFY_WITH_TIMEOUT(bench.controller.arm(), kPatience);
    bench.controller.stop();
    QTRY_COMPARE_WITH_TIMEOUT(kept.size(), 1, kPatience);
    QVERIFY(hasEntry(bench.log, EventLog::Information, u"stopped while armed"_s));
}

void tst_recordings::chosenFolders_areUsed()
{
    Bench bench;
    const QString folder = bench.folder.filePath(u"mine"_s);
    bench.dialogs.answerNext(folder);
    action(bench, u"recordingFolder"_s)->trigger();
    QTRY_COMPARE(bench.panel.recordings.folder(), folder);
    bench.dialogs.answerNext(bench.folder.filePath(u"black box"_s));
    action(bench, u"flightFolder"_s)->trigger();
    QTRY_COMPARE(bench.panel.recordings.flightFolder(), bench.folder.filePath(u"black box"_s));
    QSignalSpy kept(&bench.panel.recordings, &Recordings::kept);
    action(bench, u"keepLast"_s)->trigger();
    QTRY_COMPARE_WITH_TIMEOUT(kept.size(), 1, kPatience);
    QVERIFY(kept[0][0].toString().contains(u"black box"_s));
}

void tst_recordings::lengthOfTheLastMinutes_isChosenInTheMenu()
{
    Bench bench;
    QAction* five = action(bench, u"flightMinutes.5"_s);
    QAction* two = action(bench, u"flightMinutes.2"_s);
    QVERIFY(five != nullptr && five->isChecked() && two != nullptr);
    two->trigger();
    QVERIFY(two->isChecked() && !five->isChecked());
    QCOMPARE(bench.panel.recordings.flightMinutes(), 2);
    QCOMPARE(bench.uiSettings.value(settings::kFlightMinutes), 2);
}

QTEST_MAIN(tst_recordings)
#include "tst_recordings.moc"
