// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/common/eventlog.h"

#include <QAbstractItemModelTester>
#include <QSignalSpy>
#include <QTest>

using namespace trex;
using namespace Qt::Literals::StringLiterals;

class TestEventLog : public QObject {
    Q_OBJECT

private slots:
    void add_appendsARow();
    void add_keepsTheNewestOfTooMany();
    void severity_isAWordAndANumber();
    void toText_hasOneLineAnEvent();
};

void TestEventLog::add_appendsARow()
{
    EventLog log;
    const QAbstractItemModelTester tester(&log,
                                          QAbstractItemModelTester::FailureReportingMode::QtTest);
    QSignalSpy inserted(&log, &EventLog::rowsInserted);
    log.add(EventLog::Information, u"Connected."_s);
    log.add(EventLog::Failure, u"The link is lost."_s);
    QCOMPARE(inserted.count(), 2);
    QCOMPARE(log.rowCount(), 2);
    QCOMPARE(log.index(1, EventLog::TextColumn).data().toString(), u"The link is lost."_s);
    QVERIFY(log.at(0).time <= log.at(1).time);
    QVERIFY(!log.headerData(EventLog::TextColumn, Qt::Horizontal, Qt::DisplayRole)
                 .toString()
                 .isEmpty());
}

void TestEventLog::add_keepsTheNewestOfTooMany()
{
    EventLog log;
    for (int i = 0; i < EventLog::kMostEntries + 5; ++i) {
        log.add(EventLog::Information, QString::number(i));
    }
    const QAbstractItemModelTester tester(&log,
                                          QAbstractItemModelTester::FailureReportingMode::QtTest);
    log.add(EventLog::Information, u"last"_s);
    QCOMPARE(log.rowCount(), EventLog::kMostEntries);
    QCOMPARE(log.at(0).text, u"6"_s);
    QCOMPARE(log.at(EventLog::kMostEntries - 1).text, u"last"_s);
}

void TestEventLog::severity_isAWordAndANumber()
{
    EventLog log;
    log.add(EventLog::Information, u"a"_s);
    log.add(EventLog::Warning, u"b"_s);
    log.add(EventLog::Failure, u"c"_s);
    log.add(99, u"d"_s); // whatever is handed in stays within the three
    const QStringList words{u"Information"_s, u"Warning"_s, u"Error"_s, u"Error"_s};
    for (int row = 0; row < log.rowCount(); ++row) {
        const QModelIndex index = log.index(row, EventLog::SeverityColumn);
        QCOMPARE(index.data().toString(), words.at(row));
        QCOMPARE(index.data(Qt::UserRole).toInt(), std::min(row, 2));
    }
}

void TestEventLog::toText_hasOneLineAnEvent()
{
    EventLog log;
    log.add(EventLog::Information, u"Connected."_s);
    log.add(EventLog::Warning, u"Slow."_s);
    const QStringList lines = log.toText().split(u'\n', Qt::SkipEmptyParts);
    QCOMPARE(lines.size(), 2);
    QVERIFY(lines.at(1).endsWith(u"Warning\tSlow."_s));
    QVERIFY(lines.at(0).contains(QString::number(QDate::currentDate().year())));
}

QTEST_MAIN(TestEventLog)
#include "tst_eventlog.moc"
