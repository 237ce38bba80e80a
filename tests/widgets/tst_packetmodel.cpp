// SPDX-License-Identifier: GPL-3.0-or-later
#include "protocol/codec/packet.h"
#include "widgets/packets/packetmodel.h"

#include <QAbstractItemModelTester>
#include <QSignalSpy>
#include <QTest>

using namespace Qt::Literals::StringLiterals;
using namespace trex;

namespace {

const Instant kOpened{std::chrono::hours(1)};

TransactionRecord recordOf(const Command& command, const QByteArray& received, int afterMs = 1500,
                           Priority priority = Priority::User)
{
    TransactionRecord record;
    record.command = command;
    record.priority = priority;
    record.sentBytes = encode(command, LineSettings{});
    record.receivedBytes = received;
    record.sent = kOpened + std::chrono::milliseconds(afterMs);
    record.ended = record.sent + std::chrono::microseconds(3140);
    return record;
}

TransactionRecord rawRecord(const QByteArray& sent, const QByteArray& received)
{
    TransactionRecord record = recordOf(query("get-mode"), received);
    record.command = {};
    record.sentBytes = sent;
    record.isRaw = true;
    return record;
}

QString cell(const PacketModel& model, int row, PacketModel::Column column)
{
    return model.index(row, column).data().toString();
}

struct Mixed {
    PacketModel model;
    QAbstractItemModelTester tester{&model, QAbstractItemModelTester::FailureReportingMode::QtTest};
    Mixed()
    {
        model.startConnection({}, kOpened);
        TransactionRecord lost = recordOf(query("get-status"), {}, 1700, Priority::Poll);
        lost.error = ErrorCode::NoReply;
        lost.attempt = 2;
        model.add(
            {recordOf(channelsQuery("get-raw-channels", 0x13), QByteArray::fromHex("350EFFFF9B0A")),
             recordOf(query("get-mode"), "r", 1600, Priority::Poll), lost,
             recordOf(*driveMotor(MotorId::Motor1, {MotorOrder::Action::Set, 64}), {}, 1800),
             recordOf(writeParameter(7, 5), QByteArray(1, '\0'), 1900)});
        model.flush();
    }
};

} // namespace

class TestPacketModel : public QObject {
    Q_OBJECT

private slots:
    void query_isShownWithBytesMeaningAndTimes()
    {
        const Mixed mixed;
        QCOMPARE(mixed.model.rowCount(), 5);
        QCOMPARE(cell(mixed.model, 0, PacketModel::TimeColumn), u"1.500"_s);
        QCOMPARE(cell(mixed.model, 0, PacketModel::SentColumn), u"86 13"_s);
        QCOMPARE(cell(mixed.model, 0, PacketModel::ReceivedColumn), u"35 0E FF FF 9B 0A"_s);
        QVERIFY(cell(mixed.model, 0, PacketModel::MeaningColumn)
                    .contains(u"1: 3637, 2: invalid, 5: 2715"_s)); // C-25
        QCOMPARE(cell(mixed.model, 0, PacketModel::RoundTripColumn), u"3.1"_s);
        QCOMPARE(cell(mixed.model, 0, PacketModel::NoteColumn), QString());
    }

    void failedAttempt_saysWhat_notOnlyByColour()
    {
        const Mixed mixed;
        const QString note = cell(mixed.model, 2, PacketModel::NoteColumn);
        QVERIFY2(note.startsWith(u"No reply"_s) && note.contains(u"attempt 2"_s), qPrintable(note));
        QVERIFY(mixed.model.index(2, PacketModel::NoteColumn).data(Qt::DecorationRole).isValid());
        QCOMPARE(cell(mixed.model, 2, PacketModel::RoundTripColumn), u"–"_s);
        QVERIFY(!cell(mixed.model, 2, PacketModel::MeaningColumn).contains(u'→'));
    }

    void crcLine_leavesItsByteOutOfTheMeaning()
    {
        PacketModel model;
        LineSettings line;
        line.errorDetection = ErrorDetection::Crc7;
        model.startConnection(line, kOpened);
        model.add({recordOf(query("get-motor1-current"), QByteArray::fromHex("3712"))});
        model.flush();
        QVERIFY(cell(model, 0, PacketModel::MeaningColumn).endsWith(u"→ 55"_s));
    }

    void rawBytes_areDecodedWhereTheyAreAPacket()
    {
        PacketModel model;
        model.startConnection({}, kOpened);
        model.add({rawRecord(QByteArray::fromHex("800702"), "r"),
                   rawRecord(QByteArray::fromHex("FF"), {})});
        model.flush();
        const QString known = cell(model, 0, PacketModel::MeaningColumn);
        QVERIFY2(known.startsWith(u"Raw: "_s) && known.contains(u"serial mode"_s),
                 qPrintable(known));
        QCOMPARE(cell(model, 1, PacketModel::MeaningColumn), u"Raw bytes"_s);
    }

    void filter_text_data()
    {
        QTest::addColumn<QString>("text");
        QTest::addColumn<int>("rows");
        QTest::newRow("all") << QString() << 5;
        QTest::newRow("meaning") << u"MOTOR 1 FORWARD"_s << 1;
        QTest::newRow("reply") << u"3637"_s << 1;
        QTest::newRow("key") << u"set-parameter"_s << 1;
        QTest::newRow("hex") << u"8613"_s << 1;
        QTest::newRow("spaced hex") << u"ff ff 9b"_s << 1;
        QTest::newRow("none") << u"banana"_s << 0;
    }

    void filter_text()
    {
        QFETCH(QString, text);
        QFETCH(int, rows);
        Mixed mixed;
        mixed.model.setFilter(text, PacketClass::All);
        QCOMPARE(mixed.model.rowCount(), rows);
    }

    void filter_class_data()
    {
        QTest::addColumn<int>("kind");
        QTest::addColumn<QString>("sent"); ///< of the first row
        QTest::addColumn<int>("rows");
        QTest::newRow("motors") << static_cast<int>(PacketClass::Motors) << u"C2 40"_s << 1;
        QTest::newRow("settings") << static_cast<int>(PacketClass::Settings) << u"AF 07 05 55 2A"_s
                                  << 1;
        QTest::newRow("queries") << static_cast<int>(PacketClass::Queries) << u"86 13"_s << 1;
        QTest::newRow("polls") << static_cast<int>(PacketClass::Polls) << u"82"_s << 2;
        QTest::newRow("errors") << static_cast<int>(PacketClass::Errors) << u"84"_s << 1;
    }

    void filter_class()
    {
        QFETCH(int, kind);
        QFETCH(QString, sent);
        QFETCH(int, rows);
        Mixed mixed;
        mixed.model.setFilter({}, static_cast<PacketClass>(kind));
        QCOMPARE(mixed.model.rowCount(), rows);
        QCOMPARE(cell(mixed.model, 0, PacketModel::SentColumn), sent);
    }

    void filter_appliesToWhatArrivesLater()
    {
        Mixed mixed;
        mixed.model.setFilter({}, PacketClass::Motors);
        mixed.model.add({recordOf(query("get-mode"), "r"),
                         recordOf(*driveMotor(MotorId::Aux, {MotorOrder::Action::Set, 9}), {})});
        mixed.model.flush();
        QCOMPARE(mixed.model.rowCount(), 2);
        QCOMPARE(cell(mixed.model, 1, PacketModel::SentColumn), u"F0 09"_s);
        QCOMPARE(mixed.model.recordCount(), 7);
    }

    void paused_rowsStandStill_recordingGoesOn()
    {
        Mixed mixed;
        mixed.model.setPaused(true);
        mixed.model.add({recordOf(query("get-mode"), "a")});
        mixed.model.flush();
        QCOMPARE(mixed.model.rowCount(), 5);
        QCOMPARE(mixed.model.waitingCount(), 1);
        mixed.model.setPaused(false);
        QCOMPARE(mixed.model.rowCount(), 6);
        QCOMPARE(cell(mixed.model, 5, PacketModel::ReceivedColumn), u"61"_s);
    }

    void batch_isOneInsertion()
    {
        Mixed mixed;
        const QSignalSpy inserted(&mixed.model, &QAbstractItemModel::rowsInserted);
        for (int i = 0; i < 20; ++i) {
            mixed.model.add({recordOf(query("get-mode"), "r")});
        }
        QCOMPARE(inserted.count(), 0);
        mixed.model.flush();
        QCOMPARE(inserted.count(), 1);
        QCOMPARE(mixed.model.rowCount(), 25);
    }

    void ring_dropsTheOldest_andCountsThem()
    {
        PacketModel model;
        model.startConnection({}, kOpened);
        model.setFilter({}, PacketClass::Motors); // every tenth, so that few rows are checked
        const QAbstractItemModelTester tester(
            &model, QAbstractItemModelTester::FailureReportingMode::QtTest);
        const int total = PacketModel::kMostRecords + 2'500;
        for (int i = 0; i < total; ++i) {
            const bool isMotor = i % 10 == 0;
            model.add({isMotor ? recordOf(*driveMotor(MotorId::Aux, {}), {}, i)
                               : recordOf(query("get-mode"), "r", i)});
            if (i % 500 == 499) {
                model.flush();
            }
        }
        model.flush();
        QVERIFY(model.recordCount() <= PacketModel::kMostRecords);
        QVERIFY(model.recordCount() > PacketModel::kMostRecords - PacketModel::kRemovedAtOnce);
        QCOMPARE(static_cast<int>(model.droppedCount()) + model.recordCount(), total);
        // The first row is the first motor command that is kept; the last is the newest.
        const int firstKept = static_cast<int>(model.droppedCount());
        QCOMPARE(cell(model, 0, PacketModel::TimeColumn),
                 QString::number((firstKept + 9) / 10 * 10 / 1000.0, 'f', 3));
        QCOMPARE(cell(model, model.rowCount() - 1, PacketModel::TimeColumn),
                 QString::number((total - 10) / 1000.0, 'f', 3));
    }

    void ring_isBoundedWhilePaused()
    {
        PacketModel model;
        model.startConnection({}, kOpened);
        model.setPaused(true);
        const std::vector<TransactionRecord> thousand(1000, recordOf(query("get-mode"), "r"));
        for (int i = 0; i < 60; ++i) {
            model.add(thousand);
        }
        QCOMPARE(model.waitingCount(), PacketModel::kMostRecords);
        QCOMPARE(model.droppedCount(), 10'000U);
        model.setPaused(false);
        QCOMPARE(model.rowCount(), PacketModel::kMostRecords);
    }
};

QTEST_MAIN(TestPacketModel)
#include "tst_packetmodel.moc"
