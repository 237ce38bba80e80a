// SPDX-License-Identifier: GPL-3.0-or-later
#include "protocol/codec/packet.h"
#include "tests/support/panelbench.h"
#include "widgets/packets/composedpacket.h"
#include "widgets/packets/packetmodel.h"
#include "widgets/packets/packetspanel.h"

#include <QComboBox>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QSignalSpy>
#include <QSpinBox>
#include <QTableView>
#include <QToolButton>

using namespace Qt::Literals::StringLiterals;
using namespace trex;

namespace {

using Bench = test::PanelBench<PacketsPanel>;

void choose(Bench& bench, const QString& key)
{
    auto* command = bench.part<QComboBox>(u"packets.command"_s);
    const int index = command->findData(key);
    QVERIFY2(index >= 0, qPrintable(key));
    command->setCurrentIndex(index);
}

QString send(Bench& bench)
{
    auto* result = bench.part<QLabel>(u"packets.result"_s);
    result->clear();
    bench.part<QPushButton>(u"packets.send"_s)->click();
    (void)QTest::qWaitFor([&] { return !result->text().isEmpty(); }, 5000);
    return result->text();
}

QString preview(const Bench& bench)
{
    return bench.part<QLabel>(u"packets.preview"_s)->text();
}

const QAbstractItemModel* model(const Bench& bench)
{
    return bench.part<QTableView>(u"packets.view"_s)->model();
}

/// Narrows the view and waits until all that it shows passes; the bytes sent of its first row.
QStringList sentOf(Bench& bench, const QString& filter)
{
    auto* command = bench.part<QComboBox>(u"packets.class"_s);
    command->setCurrentIndex(command->findData(u"all"_s));
    QSignalSpy narrowed(model(bench), &QAbstractItemModel::modelReset);
    bench.part<QLineEdit>(u"packets.filter"_s)->setText(filter);
    (void)QTest::qWaitFor([&] { return !narrowed.isEmpty() && model(bench)->rowCount() > 0; });
    QStringList sent;
    for (int row = 0; row < model(bench)->rowCount(); ++row) {
        sent << model(bench)->index(row, PacketModel::SentColumn).data().toString();
    }
    return sent;
}

} // namespace

class TestPacketsPanel : public QObject {
    Q_OBJECT

private slots:
    void polls_appearAsTheyGo()
    {
        Bench bench;
        QVERIFY(bench.connectTo(u"sim:"_s));
        QTRY_VERIFY(model(bench)->rowCount() > 20);
        // The signature is asked for first (again, where a busy machine was late with the reply).
        const QModelIndexList found =
            model(bench)->match(model(bench)->index(0, PacketModel::MeaningColumn), Qt::DisplayRole,
                                u"Get signature → TReXJr1.2"_s, 1, Qt::MatchStartsWith);
        QVERIFY(!found.isEmpty());
    }

    void pause_standsStill_andCatchesUp()
    {
        Bench bench;
        QVERIFY(bench.connectTo(u"sim:"_s));
        QTRY_VERIFY(model(bench)->rowCount() > 5);
        bench.part<QToolButton>(u"packets.pause"_s)->click();
        const int rows = model(bench)->rowCount();
        auto* counts = bench.part<QLabel>(u"packets.counts"_s);
        QTRY_VERIFY2(counts->text().contains(u"more recorded"_s)
                         && !counts->text().contains(u" 0 more"_s),
                     qPrintable(counts->text()));
        QCOMPARE(model(bench)->rowCount(), rows);
        bench.part<QToolButton>(u"packets.pause"_s)->click();
        QVERIFY(model(bench)->rowCount() > rows);
    }

    void hidden_recordsAllTheSame()
    {
        Bench bench;
        bench.panel.hide();
        QVERIFY(bench.connectTo(u"sim:"_s));
        QCOMPARE(model(bench)->rowCount(), 0);
        bench.panel.show();
        QVERIFY(model(bench)->rowCount() > 0);
    }

    void query_isSentByName_andItsReplyTold()
    {
        Bench bench;
        QVERIFY(bench.connectTo(u"sim:"_s));
        choose(bench, u"get-parameter"_s);
        bench.part<QSpinBox>(u"packets.argument1"_s)->setValue(0);
        QVERIFY2(preview(bench).contains(u"9F 00"_s), qPrintable(preview(bench)));
        const QString result = send(bench);
        QVERIFY2(result.startsWith(u"Received 07 "_s), qPrintable(result));
        QVERIFY(sentOf(bench, u"get-parameter"_s).contains(u"9F 00"_s));
    }

    void preview_followsThePacketFormOfTheLine()
    {
        Bench bench;
        LineSettings line;
        line.form = PacketForm::Pololu;
        bench.controller.open({.port = u"sim:"_s, .line = line});
        QTRY_COMPARE(bench.controller.state(), LinkState::Connected);
        choose(bench, u"get-raw-channels"_s);
        QVERIFY2(preview(bench).contains(u"80 07 06 1F"_s), qPrintable(preview(bench))); // C-03
    }

    void calibration_usesSevenBitPairs() // C-35
    {
        Bench bench;
        choose(bench, u"set-calibration"_s);
        bench.part<QSpinBox>(u"packets.channel"_s)->setValue(2);
        bench.part<QSpinBox>(u"packets.argument1"_s)->setValue(2500);
        bench.part<QSpinBox>(u"packets.argument2"_s)->setValue(3750);
        bench.part<QSpinBox>(u"packets.argument3"_s)->setValue(5000);
        bench.part<QSpinBox>(u"packets.argument4"_s)->setValue(100);
        const QString expected = QString::fromLatin1(
            encode(writeCalibration(2, {2500, 3750, 5000, 100}), {}).toHex(' ').toUpper());
        QVERIFY2(preview(bench).contains(expected), qPrintable(preview(bench)));
    }

    void setting_actsOnTheController()
    {
        Bench bench;
        QVERIFY(bench.connectTo(u"sim:"_s));
        choose(bench, u"set-parameter"_s);
        bench.part<QSpinBox>(u"packets.argument1"_s)->setValue(0x0E);
        bench.part<QSpinBox>(u"packets.argument2"_s)->setValue(33);
        const QString result = send(bench);
        QVERIFY2(result.contains(u"Received 00"_s), qPrintable(result));
        choose(bench, u"get-parameter"_s);
        bench.part<QSpinBox>(u"packets.argument1"_s)->setValue(0x0E);
        QVERIFY(send(bench).contains(u"Received 21"_s));
    }

    void motorCommand_isRefusedWhileDisarmed_data()
    {
        QTest::addColumn<QString>("key");
        QTest::addColumn<QString>("direction");
        for (const auto& key : {"set-motor1", "accelerate-motor2", "set-motors",
                                "accelerate-motors", "set-aux", "accelerate-aux"}) {
            for (const auto& direction : {"Forward", "Reverse", "Brake"}) {
                QTest::addRow("%s %s", key, direction)
                    << QString::fromLatin1(key) << QString::fromLatin1(direction);
            }
        }
    }

    void motorCommand_isRefusedWhileDisarmed()
    {
        QFETCH(QString, key);
        QFETCH(QString, direction);
        Bench bench;
        QVERIFY(bench.connectTo(u"sim:"_s));
        choose(bench, key);
        bench.part<QComboBox>(u"packets.direction"_s)->setCurrentText(direction);
        const QString result = send(bench);
        QVERIFY2(result.contains(u"not armed"_s), qPrintable(result));
        bench.part<QComboBox>(u"packets.class"_s)->setCurrentIndex(1);
        QCOMPARE(model(bench)->rowCount(), 0);
    }

    void motorCommand_armed_passesTheGate_data()
    {
        QTest::addColumn<QString>("key");
        QTest::addColumn<QString>("direction");
        QTest::addColumn<int>("amount");
        QTest::addColumn<QString>("bytes");
        QTest::addColumn<int>("order");
        QTest::newRow("reverse") << u"set-motor1"_s << u"Reverse"_s << 40 << u"C1 28"_s << -40;
        QTest::newRow("accelerate")
            << u"accelerate-motor1"_s << u"Forward"_s << 41 << u"C6 29"_s << 41;
        QTest::newRow("brake") << u"set-motor1"_s << u"Brake"_s << 100 << u"C0 64"_s << 100;
        // Bytes that the gate itself would write differently go out as composed.
        QTest::newRow("reverse zero") << u"set-motor1"_s << u"Reverse"_s << 0 << u"C1 00"_s << 0;
    }

    void motorCommand_armed_passesTheGate()
    {
        QFETCH(QString, key);
        QFETCH(QString, direction);
        QFETCH(int, amount);
        QFETCH(QString, bytes);
        QFETCH(int, order);
        Bench bench;
        QVERIFY(bench.connectTo(u"sim:"_s));
        QVERIFY(bench.controller.arm());
        choose(bench, key);
        bench.part<QComboBox>(u"packets.direction"_s)->setCurrentText(direction);
        bench.part<QSpinBox>(u"packets.argument1"_s)->setValue(amount);
        QVERIFY2(preview(bench).contains(bytes), qPrintable(preview(bench)));
        const QString result = send(bench);
        QVERIFY2(result.contains(u"Sent %1"_s.arg(bytes)), qPrintable(result));
        QCOMPARE(bench.controller.lastOrder(MotorId::Motor1).amount, order);
        bench.part<QComboBox>(u"packets.class"_s)->setCurrentIndex(1);
        QTRY_COMPARE(model(bench)->index(0, PacketModel::SentColumn).data().toString(), bytes);
    }

    void raw_bytesGoAsGiven()
    {
        Bench bench;
        QVERIFY(bench.connectTo(u"sim:"_s));
        choose(bench, u"raw"_s);
        bench.part<QLineEdit>(u"packets.raw"_s)->setText(u"0x80, 07 02"_s);
        bench.part<QSpinBox>(u"packets.replyBytes"_s)->setValue(1);
        const QString result = send(bench);
        QVERIFY2(result.startsWith(u"Received 72 "_s), qPrintable(result)); // 'r'
        QVERIFY(sentOf(bench, u"raw"_s).contains(u"80 07 02"_s));
    }

    void raw_motorCommand_isRefusedWhileDisarmed()
    {
        Bench bench;
        QVERIFY(bench.connectTo(u"sim:"_s));
        choose(bench, u"raw"_s);
        bench.part<QLineEdit>(u"packets.raw"_s)->setText(u"C240"_s);
        QVERIFY(send(bench).contains(u"not armed"_s));
    }

    void raw_badHex_getsOneSentence_data()
    {
        QTest::addColumn<QString>("text");
        QTest::newRow("nothing") << QString();
        QTest::newRow("letters") << u"86 G1"_s;
        QTest::newRow("odd") << u"861"_s;
        QTest::newRow("prefix only") << u"0x"_s;
        QTest::newRow("other digits") << u"８６"_s;
    }

    void raw_badHex_getsOneSentence()
    {
        QFETCH(QString, text);
        Bench bench;
        choose(bench, u"raw"_s);
        bench.part<QLineEdit>(u"packets.raw"_s)->setText(text);
        const QString result = send(bench);
        QVERIFY2(result.startsWith(u"Nothing was sent"_s), qPrintable(result));
        QCOMPARE(result.count(u'.'), 1);
    }

    void disconnected_saysSo()
    {
        Bench bench;
        choose(bench, u"get-mode"_s);
        QVERIFY(send(bench).contains(u"no connection"_s));
    }

    void gateOrder_isTheCommandAgain()
    {
        // Every motor opcode that the gate can write is recognised with the very same bytes.
        int recognised = 0;
        for (int opcode = 0xC0; opcode <= 0xF1; ++opcode) {
            const auto* row = findCommand(static_cast<std::uint8_t>(opcode));
            QVERIFY(row != nullptr);
            const Command command{static_cast<std::uint8_t>(opcode),
                                  QByteArray(argumentBytes(*row), '\x20')};
            if (const auto order = gateOrderOf(command)) {
                const auto again = order->isBoth ? driveBoth(order->first, order->second)
                                                 : driveMotor(order->motor, order->first);
                QVERIFY(again);
                QCOMPARE(*again, command);
                ++recognised;
            }
        }
        QVERIFY2(recognised >= 3 + 3 + 2 + 2 + 9 + 4 + 2, qPrintable(QString::number(recognised)));
        QVERIFY(!gateOrderOf(query("get-mode")));
    }
};

QTEST_MAIN(TestPacketsPanel)
#include "tst_packetspanel.moc"
