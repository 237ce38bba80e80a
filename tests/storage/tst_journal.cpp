// SPDX-License-Identifier: GPL-3.0-or-later
// The journal's file: what it keeps, what survives a killed program, and what happens to a file
// that is damaged, newer, not writable, or shared. This program is also the one that is killed.
#include "protocol/errortext.h"
#include "protocol/storage/datafolder.h"
#include "protocol/storage/journal.h"

#include <QDir>
#include <QFile>
#include <QFileInfo>
#include <QProcess>
#include <QSqlDatabase>
#include <QSqlQuery>
#include <QTemporaryDir>
#include <QTest>

#include <csignal>
#include <poll.h>
#include <sys/resource.h>
#include <unistd.h>

using namespace trex;
using namespace Qt::Literals::StringLiterals;

namespace {

const SettingId kTimeout{.row = &parameterRow("serial-timeout")};
const SettingId kNumber{.row = &parameterRow("device-number")};
const SettingId kReset{.row = &parameterRow("factory-reset")};
const SettingId kChannel1{.row = nullptr, .input = InputKind::Rc, .channel = 1};
constexpr int kManyEntries = 60;
const Calibration kUsual{2500, 3750, 5000, 100};
const Calibration kLearned{2400, 3700, 5100, 60};

ControllerIdentity controller(int device = 7, const QString& port = u"/dev/ttyUSB0"_s)
{
    return {port, u"TReXJr1.2"_s, device};
}

/// Runs this program as another user of the journal.
std::unique_ptr<QProcess> another(const QString& task, const QString& path)
{
    auto process = std::make_unique<QProcess>();
    process->setProcessChannelMode(QProcess::ForwardedErrorChannel);
    process->start(QCoreApplication::applicationFilePath(), {u"--as"_s, task, path});
    return process;
}

/// What the other program does. Returns its exit code; the killed one does not return.
int actAs(const QString& task, const QString& path)
{
    Journal journal(path);
    if (task == "writer"_L1) {
        for (int i = 0; i < kManyEntries; ++i) {
            const auto number = journal.intend(controller(), {kTimeout, i, i + 1, {}});
            const auto done = number.and_then([&](qint64 added) {
                return journal.conclude(added, {WriteResult::New, i + 1, {}});
            });
            ::poll(nullptr, 0, 2); // a controller takes longer between two writes
            if (!done) {
                qWarning("%d: %s", i, qPrintable(errorText(done.error())));
                return 1;
            }
        }
        return 0;
    }
    if (!journal.intend(controller(), {kTimeout, 0, 5, QByteArray::fromHex("AF0705552A")})) {
        return 1;
    }
    ::kill(::getpid(), SIGKILL);
    return 2;
}

} // namespace

class TestJournal : public QObject {
    Q_OBJECT

    QTemporaryDir m_folder;
    QString m_path;

    qint64 add(Journal& journal, const SettingId& setting, std::optional<SettingValue> before,
               std::optional<SettingValue> after, WriteResult result = WriteResult::New,
               const ControllerIdentity& who = controller())
    {
        const auto number = journal.intend(who, {setting, before, after, {}});
        [&] { QVERIFY2(number, number ? "" : qPrintable(errorText(number.error()))); }();
        [&] { QVERIFY(journal.conclude(*number, {result, {}, {}})); }();
        return number.value_or(0);
    }
    static std::vector<JournalEntry> all(Journal& journal)
    {
        return journal.entries({}).value_or(std::vector<JournalEntry>());
    }

private slots:
    void init()
    {
        m_path = m_folder.filePath(u"%1/journal.sqlite"_s.arg(
            QLatin1StringView(QTest::currentDataTag() != nullptr ? QTest::currentDataTag()
                                                                 : QTest::currentTestFunction())));
    }
    void reading_makesNoFile();
    void entry_comesBackAsItWasGiven();
    void intent_isThereWithoutAConclusion();
    void resolution_closesAnEntryAndNamesItsTime();
    void killedProgram_leavesItsIntent();
    void twoPrograms_writeAtTheSameTime();
    void twoPrograms_mayBeginTheFileTogether();
    void damagedFile_isKeptAsideAndANewOneBegun_data();
    void damagedFile_isKeptAsideAndANewOneBegun();
    void newerVersion_isLeftAsItIs();
    void unusablePath_isOneSentence_data();
    void unusablePath_isOneSentence();
    void fullDisk_isToldAndNothingIsLost();
    void filter_givesOneControllersEntriesAcrossItsNumbers();
    void filter_keepsControllersApartThatHadTheSameNumber();
    void calibrationHistory_isOfOneChannelNewestFirst();
    void checkpoint_keepsTheConfiguration();
    void checkpoint_nameIsTakenOnce();
    void sameConfiguration_isStoredOnce();
    void stateBefore_isTheCheckpointWithWhatCameAfter();
    void stateBefore_undoesWhatIsNotInACheckpoint();
    void stateBefore_looksNotThroughAFactoryReset();
    void stateBefore_takesNoUnknownValue();
    void keys_areThoseOfTheConfigurationFile();
    void dataFolder_isBesideTheGivenSettings();
};

void TestJournal::reading_makesNoFile()
{
    Journal journal(m_path);
    QVERIFY(all(journal).empty());
    QVERIFY(journal.checkpoints(std::nullopt)->empty());
    QVERIFY(!QFileInfo::exists(m_path));
}

void TestJournal::entry_comesBackAsItWasGiven()
{
    const WriteIntent intent{kChannel1, kUsual, kLearned, QByteArray::fromHex("A00102")};
    const QDateTime before = QDateTime::currentDateTimeUtc();
    {
        Journal journal(m_path);
        const auto number = journal.intend(controller(), intent);
        QVERIFY(number);
        QVERIFY(journal.conclude(*number, {WriteResult::Other, kUsual, u"a sentence"_s}));
    }
    Journal journal(m_path);
    QCOMPARE(all(journal).size(), std::size_t{1});
    const JournalEntry entry = all(journal).front();
    QCOMPARE(entry.controller, controller());
    QCOMPARE(entry.intent.setting, kChannel1);
    QVERIFY(entry.intent.before == SettingValue(kUsual));
    QVERIFY(entry.intent.after == SettingValue(kLearned));
    QCOMPARE(entry.intent.packet, intent.packet);
    QVERIFY(entry.isConcluded);
    QCOMPARE(entry.conclusion.result, WriteResult::Other);
    QVERIFY(entry.conclusion.found == SettingValue(kUsual));
    QCOMPARE(entry.conclusion.detail, u"a sentence"_s);
    QCOMPARE(entry.program, QCoreApplication::applicationName());
    QVERIFY(entry.time >= before.addMSecs(-1) && entry.time <= QDateTime::currentDateTimeUtc());
    QVERIFY(!entry.isOpen());
    QVERIFY(entry.valueAfter() == SettingValue(kUsual));
}

void TestJournal::intent_isThereWithoutAConclusion()
{
    Journal journal(m_path);
    QVERIFY(journal.intend(controller(), {kTimeout, 0, 5, {}}));
    const JournalEntry entry = all(journal).front();
    QVERIFY(!entry.isConcluded);
    QVERIFY(entry.isOpen());
    QVERIFY(!entry.valueAfter());
}

void TestJournal::resolution_closesAnEntryAndNamesItsTime()
{
    Journal journal(m_path);
    add(journal, kTimeout, 0, 5, WriteResult::Unknown);
    const auto open =
        journal.entries({.controller = controller(), .setting = {}, .onlyOpen = true});
    QCOMPARE(open->size(), std::size_t{1});
    QVERIFY(journal.resolve(open->front().number, {WriteResult::New, 5, {}}));
    QVERIFY(journal.entries({.controller = {}, .setting = {}, .onlyOpen = true})->empty());
    QVERIFY(all(journal).front().resolved.isValid());
    QVERIFY(all(journal).front().valueAfter() == SettingValue(5));
}

void TestJournal::killedProgram_leavesItsIntent()
{
    const auto process = another(u"killed"_s, m_path);
    QVERIFY(process->waitForFinished());
    QCOMPARE(process->exitStatus(), QProcess::CrashExit);
    Journal journal(m_path);
    QCOMPARE(all(journal).size(), std::size_t{1});
    QVERIFY(all(journal).front().isOpen());
    QVERIFY(all(journal).front().intent.after == SettingValue(5));
    add(journal, kTimeout, 5, 6); // and it can be written on
    QCOMPARE(all(journal).size(), std::size_t{2});
}

void TestJournal::twoPrograms_writeAtTheSameTime()
{
    Journal journal(m_path);
    const auto process = another(u"writer"_s, m_path);
    int mine = 0;
    while (mine < kManyEntries || process->state() != QProcess::NotRunning) {
        add(journal, kChannel1, kUsual, kLearned);
        ++mine;
        process->waitForFinished(2);
    }
    QCOMPARE(process->exitCode(), 0);
    QCOMPARE(all(journal).size(), static_cast<std::size_t>(mine + kManyEntries));
}

void TestJournal::twoPrograms_mayBeginTheFileTogether()
{
    const auto first = another(u"writer"_s, m_path);
    const auto second = another(u"writer"_s, m_path);
    QVERIFY(first->waitForFinished() && second->waitForFinished());
    QCOMPARE(first->exitCode(), 0);
    QCOMPARE(second->exitCode(), 0);
    Journal journal(m_path);
    QCOMPARE(all(journal).size(), std::size_t{2 * kManyEntries});
}

void TestJournal::damagedFile_isKeptAsideAndANewOneBegun_data()
{
    QTest::addColumn<QByteArray>("contents");
    QTest::addColumn<int>("at"); // −1: the whole file
    QTest::newRow("text") << QByteArray("no database at all\n").repeated(100) << -1;
    QTest::newRow("header") << QByteArray(100, 'x') << 0;
    QTest::newRow("pages") << QByteArray(8192, '\x5A') << 4096;
}

void TestJournal::damagedFile_isKeptAsideAndANewOneBegun()
{
    QFETCH(QByteArray, contents);
    QFETCH(int, at);
    {
        Journal journal(m_path);
        for (int i = 0; i < 50; ++i) {
            add(journal, kTimeout, i, i + 1);
        }
    }
    QFile file(m_path);
    QVERIFY(file.open(at < 0 ? QIODevice::WriteOnly : QIODevice::ReadWrite));
    QVERIFY(file.seek(std::max(at, 0)));
    QCOMPARE(file.write(contents), contents.size());
    file.close();

    Journal journal(m_path);
    QVERIFY(journal.ready());
    const QString remark = journal.takeRemark();
    QVERIFY2(remark.contains(m_path + u".damaged"_s), qPrintable(remark));
    QVERIFY(journal.takeRemark().isEmpty()); // told once
    QVERIFY(QFileInfo::exists(m_path + u".damaged"_s));
    QVERIFY(all(journal).empty());
    add(journal, kTimeout, 0, 5);
    QCOMPARE(all(journal).size(), std::size_t{1});
}

void TestJournal::newerVersion_isLeftAsItIs()
{
    {
        Journal journal(m_path);
        add(journal, kTimeout, 0, 5);
    }
    {
        auto database = QSqlDatabase::addDatabase(u"QSQLITE"_s, u"newer"_s);
        database.setDatabaseName(m_path);
        QVERIFY(database.open());
        QVERIFY(QSqlQuery(database).exec(u"PRAGMA user_version = %1"_s.arg(Journal::kVersion + 1)));
    }
    QSqlDatabase::removeDatabase(u"newer"_s);
    Journal journal(m_path);
    const auto written = journal.intend(controller(), {kTimeout, 5, 6, {}});
    QVERIFY(!written);
    QCOMPARE(written.error().code, ErrorCode::FileUnreadable);
    QVERIFY(errorText(written.error()).contains(u"newer version"_s));
    QVERIFY(!QFileInfo::exists(m_path + u".damaged"_s));
    QVERIFY(journal.takeRemark().isEmpty());
}

void TestJournal::unusablePath_isOneSentence_data()
{
    QTest::addColumn<bool>("isFolder");
    QTest::newRow("its folder is a file") << false;
    QTest::newRow("it is a folder") << true;
}

void TestJournal::unusablePath_isOneSentence()
{
    QFETCH(bool, isFolder);
    if (isFolder) {
        QVERIFY(QDir().mkpath(m_path));
    } else {
        QFile inTheWay(QFileInfo(m_path).absolutePath());
        QVERIFY(inTheWay.open(QIODevice::WriteOnly));
    }
    Journal journal(m_path);
    const auto written = journal.intend(controller(), {kTimeout, 5, 6, {}});
    QVERIFY(!written);
    const QString text = errorText(written.error());
    QVERIFY2(text.contains(m_path) && !text.contains(u'\n'), qPrintable(text));
    QVERIFY(!journal.ready()); // and again, without a crash
}

void TestJournal::fullDisk_isToldAndNothingIsLost()
{
    Journal journal(m_path);
    add(journal, kTimeout, 0, 5);
    rlimit before{};
    QCOMPARE(::getrlimit(RLIMIT_FSIZE, &before), 0);
    rlimit full = before;
    full.rlim_cur = static_cast<rlim_t>(QFileInfo(m_path + u"-wal"_s).size());
    const auto handler = std::signal(SIGXFSZ, SIG_IGN);
    QCOMPARE(::setrlimit(RLIMIT_FSIZE, &full), 0);
    const auto written = journal.intend(controller(), {kTimeout, 5, 6, {}});
    ::setrlimit(RLIMIT_FSIZE, &before);
    std::signal(SIGXFSZ, handler);
    QVERIFY(!written);
    QCOMPARE(written.error().code, ErrorCode::FileUnwritable);
    QVERIFY(errorText(written.error()).contains(m_path));
    QCOMPARE(all(journal).size(), std::size_t{1});
    add(journal, kTimeout, 5, 6); // there is room again
    QCOMPARE(all(journal).size(), std::size_t{2});
}

void TestJournal::filter_givesOneControllersEntriesAcrossItsNumbers()
{
    Journal journal(m_path);
    add(journal, kTimeout, 0, 5);
    add(journal, kNumber, 7, 9);
    add(journal, kTimeout, 5, 6, WriteResult::New, controller(9));
    add(journal, kTimeout, 0, 1, WriteResult::New, controller(8));
    add(journal, kTimeout, 0, 1, WriteResult::New, controller(9, u"/dev/ttyUSB1"_s));
    add(journal, kTimeout, 0, 1, WriteResult::Answered, {u"/dev/ttyUSB0"_s, {}, -1}); // raw bytes
    const auto mine = journal.entries({.controller = controller(9), .setting = {}});
    QCOMPARE(mine->size(), std::size_t{4});
    QCOMPARE(mine->front().controller.device, -1);
    QCOMPARE(mine->back().controller.device, 7);
}

void TestJournal::filter_keepsControllersApartThatHadTheSameNumber()
{
    Journal journal(m_path);
    add(journal, kTimeout, 0, 1); // the first one leaves the factory's number …
    add(journal, kNumber, 7, 1);
    add(journal, kTimeout, 0, 2); // … which the second one has, too
    QCOMPARE(journal.entries({.controller = controller(7), .setting = {}})->size(), std::size_t{1});
    QCOMPARE(journal.entries({.controller = controller(1), .setting = {}})->size(), std::size_t{2});
}

void TestJournal::calibrationHistory_isOfOneChannelNewestFirst()
{
    Journal journal(m_path);
    add(journal, kChannel1, kUsual, kLearned);
    add(journal, {.row = nullptr, .input = InputKind::Rc, .channel = 2}, kUsual, kLearned);
    add(journal, {.row = nullptr, .input = InputKind::Analog, .channel = 1}, kUsual, kLearned);
    add(journal, kChannel1, kLearned, kUsual, WriteResult::Refused);
    const auto history = journal.calibrationHistory(controller(), InputKind::Rc, 1);
    QCOMPARE(history->size(), std::size_t{2});
    QCOMPARE(history->front().conclusion.result, WriteResult::Refused);
    QVERIFY(history->back().intent.before == SettingValue(kUsual));
}

void TestJournal::checkpoint_keepsTheConfiguration()
{
    Configuration configuration;
    configuration.signature = u"TReXJr1.2"_s;
    configuration.deviceNumber = 7;
    configuration.parameters[kTimeout.row->number] = 5;
    configuration.calibrations[InputKind::Rc][1] = kLearned;
    Journal journal(m_path);
    QVERIFY(journal.saveCheckpoint(controller(), u"before the race"_s, configuration));
    auto kept = journal.checkpoint(controller(), u"before the race"_s);
    QVERIFY(kept);
    QVERIFY(kept->configuration.saved.isValid());
    QCOMPARE(kept->configuration.parameters, configuration.parameters);
    QVERIFY(kept->configuration.calibrations == configuration.calibrations);
    QVERIFY(!journal.checkpoint(controller(8), u"before the race"_s));
    QVERIFY(journal.removeCheckpoint(kept->number));
    QVERIFY(!journal.checkpoint(controller(), u"before the race"_s));
}

void TestJournal::checkpoint_nameIsTakenOnce()
{
    Journal journal(m_path);
    QVERIFY(journal.saveCheckpoint(controller(), u"a"_s, {}));
    QCOMPARE(journal.saveCheckpoint(controller(), u"a"_s, {}).error().code, ErrorCode::OutOfRange);
    QVERIFY(journal.saveCheckpoint(controller(8), u"a"_s, {}));
    QVERIFY(journal.saveCheckpoint(controller(), {}, {}));
    QVERIFY(journal.saveCheckpoint(controller(), {}, {})); // automatic ones have no name
    QCOMPARE(journal.checkpoints(controller())->size(), std::size_t{3});
}

void TestJournal::sameConfiguration_isStoredOnce()
{
    Configuration configuration;
    configuration.parameters[kTimeout.row->number] = 5;
    Journal journal(m_path);
    for (int i = 0; i < 3; ++i) {
        configuration.saved = QDateTime::currentDateTimeUtc().addDays(i);
        QVERIFY(journal.saveCheckpoint(controller(), {}, configuration));
    }
    {
        auto database = QSqlDatabase::addDatabase(u"QSQLITE"_s, u"look"_s);
        database.setDatabaseName(m_path);
        QVERIFY(database.open());
        QSqlQuery query(u"SELECT COUNT(*) FROM configuration"_s, database);
        QVERIFY(query.next());
        QCOMPARE(query.value(0).toInt(), 1);
    }
    QSqlDatabase::removeDatabase(u"look"_s);
}

void TestJournal::stateBefore_isTheCheckpointWithWhatCameAfter()
{
    Journal journal(m_path);
    Configuration start;
    start.parameters = {{kTimeout.row->number, 0}, {1, 3}, {2, 4}};
    start.calibrations[InputKind::Rc][1] = kUsual;
    QVERIFY(journal.saveCheckpoint(controller(), {}, start));
    const auto first = add(journal, kTimeout, 0, 5);
    add(journal, kChannel1, kUsual, kLearned, WriteResult::Refused);
    const auto third = add(journal, {.row = findParameter(1)}, 3, 8);
    const auto last = add(journal, kChannel1, kUsual, kLearned);

    const auto atFirst = journal.stateBefore(*journal.entry(first));
    QCOMPARE(atFirst->parameters, start.parameters);
    QVERIFY(atFirst->calibrations == start.calibrations);

    const auto atThird = journal.stateBefore(*journal.entry(third));
    QCOMPARE(atThird->parameters.at(kTimeout.row->number), 5);
    QCOMPARE(atThird->parameters.at(1), 3);

    const auto atLast = journal.stateBefore(*journal.entry(last));
    QCOMPARE(atLast->parameters.at(1), 8);
    QVERIFY(atLast->calibrations.at(InputKind::Rc).at(1) == kUsual);
}

void TestJournal::stateBefore_undoesWhatIsNotInACheckpoint()
{
    Journal journal(m_path);
    const auto first = add(journal, kTimeout, 0, 5);
    add(journal, kTimeout, 5, 6);
    add(journal, {.row = findParameter(1)}, 3, 8);
    const auto state = journal.stateBefore(*journal.entry(first));
    QCOMPARE(state->parameters.at(kTimeout.row->number), 0);
    QCOMPARE(state->parameters.at(1), 3);
}

void TestJournal::stateBefore_looksNotThroughAFactoryReset()
{
    Journal journal(m_path);
    const auto first = add(journal, kTimeout, 0, 5);
    add(journal, kReset, {}, {}, WriteResult::Answered);
    add(journal, {.row = findParameter(1)}, 0, 8); // 0: the factory's, not what was before
    const auto state = journal.stateBefore(*journal.entry(first));
    QCOMPARE(state->parameters.at(kTimeout.row->number), 0);
    QVERIFY(!state->parameters.contains(1));
    const auto later = add(journal, {.row = findParameter(2)}, 1, 2);
    const auto after = journal.stateBefore(*journal.entry(later));
    QVERIFY(!after->parameters.contains(kTimeout.row->number)); // 5 no more
    QCOMPARE(after->parameters.at(1), 8);
}

void TestJournal::stateBefore_takesNoUnknownValue()
{
    Journal journal(m_path);
    Configuration start;
    start.parameters = {{kTimeout.row->number, 0}};
    QVERIFY(journal.saveCheckpoint(controller(), {}, start));
    add(journal, kTimeout, 0, 5, WriteResult::Unknown);
    const auto later = add(journal, {.row = findParameter(1)}, 3, 8);
    QVERIFY(!journal.stateBefore(*journal.entry(later))->parameters.contains(kTimeout.row->number));
}

void TestJournal::keys_areThoseOfTheConfigurationFile()
{
    QCOMPARE(keyOf(kTimeout), u"serial-timeout"_s);
    QCOMPARE(keyOf(kChannel1), u"calibration.rc.1"_s);
    QCOMPARE(settingFromKey(u"calibration.analog.5"_s),
             (SettingId{.row = nullptr, .input = InputKind::Analog, .channel = 5}));
    QCOMPARE(settingFromKey(u"factory-reset"_s), kReset);
    for (const auto& wrong : {u"calibration.rc.6"_s, u"calibration.rc"_s, u"no-such"_s}) {
        QVERIFY(!settingFromKey(wrong));
    }
}

void TestJournal::dataFolder_isBesideTheGivenSettings()
{
    QCOMPARE(journalPath(u"/some/where/settings.ini"_s), u"/some/where/journal.sqlite"_s);
    const QString own = QString::fromLocal8Bit(qgetenv("XDG_CONFIG_HOME"));
    if (!own.isEmpty()) { // both programs find the same file
        QCOMPARE(journalPath(own + u"/trexpanel/trexpanel.ini"_s),
                 QString::fromLocal8Bit(qgetenv("XDG_DATA_HOME")) + u"/trexpanel/journal.sqlite"_s);
    }
}

int main(int argc, char* argv[])
{
    QCoreApplication app(argc, argv);
    const QStringList arguments = QCoreApplication::arguments();
    if (arguments.size() == 4 && arguments.at(1) == "--as"_L1) {
        return actAs(arguments.at(2), arguments.at(3));
    }
    TestJournal test;
    return QTest::qExec(&test, argc, argv);
}

#include "tst_journal.moc"
