// SPDX-License-Identifier: GPL-3.0-or-later
// calibration learn, the real program against the simulated controller and its EEPROM.
#include "protocol/codec/parametertable.h"
#include "protocol/procedures/responsecurve.h"
#include "protocol/sim/eeprom.h"
#include "tests/app/commandrunner.h"

#include <QFile>
#include <QTest>

using namespace Qt::Literals::StringLiterals;
using namespace trex;

class tst_trexctl_learn : public QObject {
    Q_OBJECT

private slots:
    void singleChannel_leavesAllOtherBytes();
    void bothReadingsOfTheBytes_endVerified_data();
    void bothReadingsOfTheBytes_endVerified(); // C-35
    void usableChannel_isSaidWhy();
    void deadChannel_writesNothing();

private:
    static QStringList learn(const Simulator& simulator, const QString& channels)
    {
        return QStringList{u"--port"_s, simulator.port(), u"--json"_s}
        + words(u"calibration learn --yes --neutral-seconds 1 --sweep-seconds 4 --channels "_s
                + channels);
    }
    /// A stick that rests and goes from end to end; `more`: rows of channels of their own.
    QString scenario(const QByteArray& more = {}) const
    {
        QFile file(m_folder.filePath(u"scenario.json"_s));
        if (file.open(QIODevice::WriteOnly)) {
            file.write(R"({"stick":{"neutralSeconds":2,"sweepSeconds":4},"channels":[)" + more
                       + "]}");
        }
        return file.fileName();
    }
    QTemporaryDir m_folder;
};

void tst_trexctl_learn::singleChannel_leavesAllOtherBytes()
{
    const QString state = m_folder.filePath(u"eeprom.json"_s);
    const QStringList options{u"--scenario"_s, scenario(), u"--state"_s, state};
    const auto contents = [&state] { return sim::loadEeproms(state)->front(); };
    {
        Simulator simulator(options); // so that no channel is as the factory made it
        QCOMPARE(run(learn(simulator, u"1,2,4,5"_s), 60'000).code, 0);
        (void)simulator.stop();
    }
    const sim::Eeprom before = contents();
    Simulator simulator(options);
    const Finished done = run(learn(simulator, u"3"_s), 60'000);
    QVERIFY2(done.code == 0, done.err);
    QCOMPARE(done.array().size(), 1);
    (void)simulator.stop();
    const sim::Eeprom after = contents();
    const int own = sim::Eeprom::calibrationAddress(InputKind::Rc, 3);
    for (int address = 0; address < sim::Eeprom::kSize; ++address) {
        if (address < own || address >= own + 8) {
            QCOMPARE(after.at(address), before.at(address));
            QCOMPARE(after.writeCount(address), before.writeCount(address));
        }
    }
    QVERIFY(after.calibration(InputKind::Rc, 3) != before.calibration(InputKind::Rc, 3));
}

void tst_trexctl_learn::bothReadingsOfTheBytes_endVerified_data()
{
    QTest::addColumn<QStringList>("quirk");
    QTest::newRow("7 bits, as documented") << QStringList();
    QTest::newRow("8 bits") << QStringList{u"--quirk"_s, u"calibration-bytes=8"_s};
}

void tst_trexctl_learn::bothReadingsOfTheBytes_endVerified()
{
    QFETCH(QStringList, quirk);
    Simulator simulator(QStringList{u"--scenario"_s, scenario()} + quirk);
    const Finished done = run(learn(simulator, u"1,2"_s), 60'000);
    QVERIFY2(done.code == 0, done.err);
    const QJsonArray held =
        run({u"--port"_s, simulator.port(), u"--json"_s, u"calibration"_s, u"get"_s}).array();
    const QJsonArray told = done.array();
    QCOMPARE(told.size(), 2);
    for (int i = 0; i < 2; ++i) { // what is told is what it holds
        QCOMPARE(told.at(i), held.at(i));
        const Calibration calibration{told[i]["minimum"_L1].toInt(), told[i]["neutral"_L1].toInt(),
                                      told[i]["maximum"_L1].toInt(),
                                      told[i]["deadband"_L1].toInt()};
        const ResponseCurve curve{calibration, false, false};
        const int rest = i == 0 ? 3762 : 3738; // of the simulated sticks
        QCOMPARE(curve.remap(rest), 0); // no motor creeps
        QVERIFY(qAbs(calibration.minimum - (i == 0 ? 2618 : 2586)) <= (quirk.isEmpty() ? 23 : 88));
        QVERIFY(qAbs(calibration.maximum - (i == 0 ? 4894 : 4871)) <= (quirk.isEmpty() ? 23 : 88));
    }
    if (quirk.isEmpty()) {
        QVERIFY2(done.err.isEmpty(), done.err);
    } else {
        QCOMPARE(done.errLines().size(), 1);
        QVERIFY2(done.err.contains("channels 1 and 2 hold the nearest values"), done.err);
    }
}

void tst_trexctl_learn::usableChannel_isSaidWhy()
{
    Simulator simulator(
        {u"--scenario"_s, scenario(R"({"channel":2,"wave":"stick","value":3300})")});
    const Finished done = run(learn(simulator, u"2"_s), 60'000);
    QVERIFY2(done.code == 0, done.err);
    QCOMPARE(done.errLines().size(), 1);
    QVERIFY2(done.err.contains("Channel 2: One side moves much less"), done.err);
}

void tst_trexctl_learn::deadChannel_writesNothing()
{
    const QString state = m_folder.filePath(u"dead.json"_s);
    Simulator simulator(
        {u"--scenario"_s, scenario(R"({"channel":2,"wave":"hold"})"), u"--state"_s, state});
    const Finished done = run(learn(simulator, u"1,2"_s), 90'000);
    QVERIFY(done.code != 0);
    QVERIFY(done.out.isEmpty());
    QCOMPARE(done.errLines().size(), 1);
    QVERIFY2(done.err.contains("Channel 2: It did not move"), done.err);
    QCOMPARE(done.err.count("Nothing was written"), 1);
    QVERIFY(simulator.packets(u"setting"_s).isEmpty());
}

QTEST_GUILESS_MAIN(tst_trexctl_learn)
#include "tst_trexctl_learn.moc"
