// SPDX-License-Identifier: GPL-3.0-or-later
// The line's own settings change: with the simulator in process and over a pseudo-terminal, whose
// speed counts.
#include "protocol/procedures/linechange.h"
#include "protocol/procedures/linetext.h"
#include "protocol/sim/simserver.h"
#include "protocol/telemetry/statuslatch.h"
#include "protocol/telemetry/telemetrystore.h"

#include <QSignalSpy>
#include <QTemporaryDir>
#include <QTest>

using namespace std::chrono_literals;
using namespace Qt::Literals::StringLiterals;
using namespace trex;

namespace {

constexpr int kLongMs = 30'000;

int rawOf(int baud, ErrorDetection detection = ErrorDetection::None, int stopBits = 1)
{
    return UartSettings{baudIndex(baud), detection, stopBits}.toRaw();
}

/// The façade with polls, the settings and the procedure, as the window has them.
struct Bench {
    Bench() { change.setTimes({.pause = 50ms, .patience = 4s, .simulator = 4s}); }

    bool open(const QString& port, const LineSettings& line = {})
    {
        controller.open({.port = port, .line = line});
        return QTest::qWaitFor([this] { return controller.state() == LinkState::Connected; },
                               kLongMs);
    }
    Result<DeviceSettings::ParameterWrite> write(std::string_view key, int raw)
    {
        std::optional<Result<DeviceSettings::ParameterWrite>> result;
        settings.writeParameter(
            *findParameter(QString::fromLatin1(key.data(), qsizetype(key.size()))), raw, true,
            &controller, [&result](const auto& written) { result = written; });
        return QTest::qWaitFor([&result] { return result.has_value(); }, kLongMs)
            ? *result
            : Result<DeviceSettings::ParameterWrite>(fail(ErrorCode::NoReply));
    }
    [[nodiscard]] bool reaches(LineChange::Phase phase)
    {
        return QTest::qWaitFor([this, phase] { return change.phase() == phase; }, kLongMs);
    }

    TelemetryStore store;
    StatusLatch latch;
    Controller controller{&store, &latch};
    DeviceSettings settings{controller};
    LineChange change{controller, settings};
};

/// A controller behind a pseudo-terminal.
struct Remote {
    explicit Remote(const sim::SimOptions& options = {}) : server(options)
    {
        link = folder.filePath(u"port"_s);
        isListening = server.listenPty(link).has_value();
    }
    [[nodiscard]] qsizetype motorOrders() const
    {
        const auto& heard = server.line().device().heard();
        return std::ranges::count(heard, sim::PacketKind::Motor, &sim::HeardPacket::kind);
    }
    QTemporaryDir folder;
    QString link;
    mutable sim::SimServer server;
    bool isListening = false;
};

} // namespace

class TestLineChange : public QObject {
    Q_OBJECT

private slots:
    void simulator_isFollowedOverThePowerCycle();
    void port_isFollowedOverThePowerCycle(); // C-39
    void takenBack_endsTheWaiting();
    void reading_isNoChange();
    void silenceWithoutPowerCycle_waitsOn();
    void otherLineThanAsked_isFoundBySearching();
    void nothingAnswers_endsWithAdvice();
    void factoryReset_isFollowed(); // C-60
    void armed_isDisarmed();
    void somebodyElseConnects_endsIt();
    void cancel_ends();
    void deviceNumber_isFollowedAtOnce(); // C-06
    void restart_isProvedByTheMode();
    void silence_isAGuess();
    void neverAnswered_closesWithoutAStop();
    void texts_nameWhatCameBack();
};

void TestLineChange::simulator_isFollowedOverThePowerCycle()
{
    Bench bench;
    QVERIFY(bench.open(u"sim:?pace=1"_s));
    QCOMPARE(bench.change.phase(), LineChange::Phase::None);
    QVERIFY(bench.write("uart-settings", rawOf(115200, ErrorDetection::Crc7)));
    QVERIFY(bench.reaches(LineChange::Phase::Waiting));
    QVERIFY(bench.change.text().contains(u"115200 baud, CRC-7"_s));
    QCOMPARE(bench.controller.state(), LinkState::Connected);
    QSignalSpy restarted(&bench.controller, &Controller::restarted);
    bench.controller.powerCycleSimulator();
    restarted.clear();
    QVERIFY(bench.reaches(LineChange::Phase::Reconnecting));
    QVERIFY(bench.reaches(LineChange::Phase::None));
    QCOMPARE(bench.controller.state(), LinkState::Connected);
    QCOMPARE(bench.controller.options().line.baud, 115200);
    QCOMPARE(bench.change.text(), u"The controller answers with 115200 baud, CRC-7."_s);
    QCOMPARE(restarted.size(), 1);
    QVERIFY(!bench.controller.isArmed());
}

void TestLineChange::port_isFollowedOverThePowerCycle()
{
    Remote remote;
    QVERIFY(remote.isListening);
    Bench bench;
    QVERIFY(bench.open(remote.link));
    QVERIFY(bench.write("crc7-polynomial", 0x11));
    QVERIFY(bench.write("uart-settings", rawOf(57600, ErrorDetection::Crc7, 2)));
    QVERIFY(bench.reaches(LineChange::Phase::Waiting));
    QSignalSpy said(&bench.change, &LineChange::said);
    remote.server.powerCycle();
    QVERIFY(bench.reaches(LineChange::Phase::Reconnecting));
    QVERIFY(bench.reaches(LineChange::Phase::None));
    QCOMPARE(bench.controller.state(), LinkState::Connected);
    const LineSettings& line = bench.controller.options().line;
    QCOMPARE(line.baud, 57600);
    QVERIFY(line.hasCrc());
    QCOMPARE(int(line.polynomial), 0x91);
    QCOMPARE(line.stopBits, 2);
    QVERIFY2(bench.change.text().startsWith(u"The controller answers with 57600 baud, CRC-7"_s),
             qPrintable(bench.change.text()));
    QVERIFY(!said.isEmpty());
    QCOMPARE(remote.motorOrders(), 0);
}

void TestLineChange::takenBack_endsTheWaiting()
{
    Bench bench;
    QVERIFY(bench.open(u"sim:"_s));
    QVERIFY(bench.write("uart-settings", rawOf(9600)));
    QVERIFY(bench.reaches(LineChange::Phase::Waiting));
    QVERIFY(bench.write("uart-settings", rawOf(38400)));
    QTRY_VERIFY(bench.change.text().contains(u"38400"_s));
    QVERIFY(bench.write("uart-settings", rawOf(19200)));
    QVERIFY(bench.reaches(LineChange::Phase::None));
    QVERIFY(bench.change.text().isEmpty());
}

void TestLineChange::reading_isNoChange()
{
    Bench bench;
    // Stored by somebody else, or read by a rule that this controller does not follow.
    QVERIFY(bench.open(u"sim:"_s));
    bool isRead = false;
    bench.settings.readAll(&bench.controller, {}, [&isRead](const auto&) { isRead = true; });
    QTRY_VERIFY_WITH_TIMEOUT(isRead, kLongMs);
    QVERIFY(bench.write("serial-timeout", 3));
    QCOMPARE(bench.change.phase(), LineChange::Phase::None);
}

void TestLineChange::silenceWithoutPowerCycle_waitsOn()
{
    Remote remote;
    QVERIFY(remote.isListening);
    Bench bench;
    QVERIFY(bench.open(remote.link));
    QVERIFY(bench.write("uart-settings", rawOf(57600)));
    QVERIFY(bench.reaches(LineChange::Phase::Waiting));
    sim::Faults silent;
    silent.silentFor = 1.5;
    remote.server.line().setFaults(silent, remote.server.virtualNow());
    QVERIFY(bench.reaches(LineChange::Phase::Reconnecting));
    bool wasSearched = false;
    QObject::connect(&bench.change, &LineChange::changed, &bench.change, [&] {
        wasSearched = wasSearched || bench.change.phase() == LineChange::Phase::Recovering;
    });
    QVERIFY(bench.reaches(LineChange::Phase::Waiting));
    QVERIFY(!wasSearched); // the old settings are asked too
    QVERIFY(bench.change.text().contains(u"still answers with the old settings"_s));
    QCOMPARE(bench.controller.options().line.baud, 19200);
    QCOMPARE(remote.motorOrders(), 0);
}

void TestLineChange::otherLineThanAsked_isFoundBySearching()
{
    Remote remote;
    QVERIFY(remote.isListening);
    Bench bench;
    bench.change.setTimes({.pause = 50ms, .patience = 500ms, .simulator = 4s});
    QVERIFY(bench.open(remote.link));
    QVERIFY(bench.write("uart-settings", rawOf(57600)));
    QVERIFY(bench.reaches(LineChange::Phase::Waiting));
    remote.server.line().device().setParameter(0x7E, rawOf(38400));
    remote.server.powerCycle();
    QVERIFY(bench.reaches(LineChange::Phase::Recovering));
    QVERIFY(bench.reaches(LineChange::Phase::None));
    QCOMPARE(bench.controller.state(), LinkState::Connected);
    QCOMPARE(bench.controller.options().line.baud, 38400);
    QVERIFY(bench.change.text().contains(u"asked to use 57600 baud"_s));
    QCOMPARE(remote.motorOrders(), 0);
}

void TestLineChange::nothingAnswers_endsWithAdvice()
{
    Remote remote;
    QVERIFY(remote.isListening);
    Bench bench;
    bench.change.setTimes({.pause = 50ms, .patience = 300ms, .simulator = 4s});
    QVERIFY(bench.open(remote.link));
    QVERIFY(bench.write("uart-settings", rawOf(57600)));
    QVERIFY(bench.reaches(LineChange::Phase::Waiting));
    sim::Faults silent;
    silent.silentAfter = 0.0;
    remote.server.line().setFaults(silent, remote.server.virtualNow());
    QVERIFY(bench.reaches(LineChange::Phase::Recovering));
    QVERIFY(bench.reaches(LineChange::Phase::None));
    QVERIFY(bench.controller.state() == LinkState::Disconnected);
    QVERIFY(bench.change.text().contains(wiringAdvice(LineAnswer::Silence)));
    QVERIFY(bench.change.text().contains(u"inferred"_s));
    QCOMPARE(remote.motorOrders(), 0);
}

void TestLineChange::factoryReset_isFollowed()
{
    sim::SimOptions options;
    options.baud = 57600;
    options.errorDetection = ErrorDetection::Crc7;
    Remote remote(options);
    QVERIFY(remote.isListening);
    Bench bench;
    LineSettings line;
    line.baud = 57600;
    line.errorDetection = ErrorDetection::Crc7;
    QVERIFY(bench.open(remote.link, line));
    const auto readAll = [&bench] {
        bool isRead = false;
        bench.settings.readAll(&bench.controller, {}, [&isRead](const auto&) { isRead = true; });
        return QTest::qWaitFor([&isRead] { return isRead; }, kLongMs);
    };
    QVERIFY(readAll());
    QCOMPARE(bench.change.phase(), LineChange::Phase::None);
    bool isReset = false;
    bench.settings.factoryReset(&bench.controller, [&isReset](const auto& r) { isReset = !!r; });
    QTRY_VERIFY_WITH_TIMEOUT(isReset, kLongMs);
    QVERIFY(readAll());
    QVERIFY(bench.reaches(LineChange::Phase::Waiting));
    remote.server.powerCycle();
    QVERIFY(bench.reaches(LineChange::Phase::Reconnecting));
    QVERIFY(bench.reaches(LineChange::Phase::None));
    QCOMPARE(bench.change.text(), u"The controller answers with 19200 baud, no error detection."_s);
}

void TestLineChange::armed_isDisarmed()
{
    Bench bench;
    QVERIFY(bench.open(u"sim:"_s));
    QVERIFY(bench.controller.arm());
    QVERIFY(bench.controller.driveMotor(MotorId::Motor1, {MotorOrder::Action::Set, 40}));
    QVERIFY(bench.write("uart-settings", rawOf(9600)));
    QVERIFY(bench.reaches(LineChange::Phase::Waiting));
    QVERIFY(!bench.controller.isArmed());
    QCOMPARE(bench.controller.lastOrder(MotorId::Motor1).amount, 0);
}

void TestLineChange::somebodyElseConnects_endsIt()
{
    Bench bench;
    QVERIFY(bench.open(u"sim:"_s));
    QVERIFY(bench.write("uart-settings", rawOf(9600)));
    QVERIFY(bench.reaches(LineChange::Phase::Waiting));
    bench.controller.open({.port = u"sim:?seed=2"_s, .line = {}});
    QVERIFY(bench.reaches(LineChange::Phase::None));
    QTRY_COMPARE_WITH_TIMEOUT(bench.controller.state(), LinkState::Connected, kLongMs);
}

void TestLineChange::cancel_ends()
{
    Remote remote;
    QVERIFY(remote.isListening);
    Bench bench;
    QVERIFY(bench.open(remote.link));
    QVERIFY(bench.write("uart-settings", rawOf(57600)));
    QVERIFY(bench.reaches(LineChange::Phase::Waiting));
    sim::Faults silent;
    silent.silentAfter = 0.0;
    remote.server.line().setFaults(silent, remote.server.virtualNow());
    bench.change.reconnectNow();
    QVERIFY(bench.reaches(LineChange::Phase::Reconnecting));
    bench.change.cancel();
    QCOMPARE(bench.change.phase(), LineChange::Phase::None);
    QVERIFY(bench.change.text().isEmpty());
    QTRY_COMPARE_WITH_TIMEOUT(bench.controller.state(), LinkState::Disconnected, kLongMs);
}

void TestLineChange::deviceNumber_isFollowedAtOnce()
{
    Bench bench;
    LineSettings line;
    line.form = PacketForm::Pololu;
    QVERIFY(bench.open(u"sim:?pace=1"_s, line));
    QSignalSpy states(&bench.controller, &Controller::stateChanged);
    const auto written = bench.write("device-number", 9);
    QVERIFY2(written.has_value(), written ? "" : qPrintable(written.error().context));
    QVERIFY(written->verified);
    QCOMPARE(int(bench.controller.options().line.device), 9);
    const auto before = bench.controller.stats().transactions;
    QTRY_VERIFY(bench.controller.stats().transactions > before + 20); // polls go on
    QVERIFY(states.isEmpty());
    QCOMPARE(bench.change.phase(), LineChange::Phase::None);
}

void TestLineChange::restart_isProvedByTheMode()
{
    Bench bench;
    QVERIFY(bench.open(u"sim:"_s));
    QTRY_VERIFY(bench.controller.device().mode);
    QVERIFY(bench.write("channel-input-source", 1));
    QVERIFY(bench.settings.isPending(0x7C));
    QVERIFY(bench.controller.arm());
    QVERIFY(bench.controller.driveMotor(MotorId::Motor2, {MotorOrder::Action::Set, 30}));
    QSignalSpy log(&bench.controller, &Controller::eventLogged);
    QSignalSpy restarted(&bench.controller, &Controller::restarted);
    // A brown-out: the link is not even lost.
    const QSignalSpy states(&bench.controller, &Controller::stateChanged);
    bench.controller.powerCycleSimulator();
    restarted.clear();
    QTRY_COMPARE_WITH_TIMEOUT(restarted.size(), 1, kLongMs);
    QVERIFY(states.isEmpty());
    QVERIFY(!bench.controller.isArmed());
    QCOMPARE(bench.controller.lastOrder(MotorId::Motor2).amount, 0);
    QVERIFY(!bench.settings.isPending(0x7C));
    QVERIFY(std::ranges::any_of(log, [](const QList<QVariant>& entry) {
        return entry.at(1).toString().startsWith(u"The controller was restarted: "_s);
    }));
}

void TestLineChange::silence_isAGuess()
{
    Bench bench;
    QVERIFY(bench.open(u"sim:?fault=silent-after=1&fault=silent-for=1.5"_s));
    QSignalSpy log(&bench.controller, &Controller::eventLogged);
    QSignalSpy restarted(&bench.controller, &Controller::restarted);
    QTRY_COMPARE_WITH_TIMEOUT(restarted.size(), 1, kLongMs);
    QVERIFY(std::ranges::any_of(log, [](const QList<QVariant>& entry) {
        return entry.at(1).toString().contains(u"may have been restarted"_s);
    }));
    QVERIFY(std::ranges::none_of(log, [](const QList<QVariant>& entry) {
        return entry.at(1).toString().contains(u"was restarted"_s);
    }));
}

/// At another speed a stop could be heard as something else (tst_linebits.cpp).
void TestLineChange::neverAnswered_closesWithoutAStop()
{
    Bench bench;
    QStringList sent;
    QObject::connect(&bench.controller, &Controller::recordsArrived, &bench.controller,
                     [&sent](const std::vector<TransactionRecord>& records) {
                         for (const auto& record : records) {
                             sent << QString::fromLatin1(record.sentBytes.toHex());
                         }
                     });
    bench.controller.open({.port = u"sim:?baud=9600"_s, .line = {}});
    QTRY_VERIFY_WITH_TIMEOUT(bench.controller.state() == LinkState::Retrying, kLongMs);
    const QSignalSpy closed(&bench.controller, &Controller::closed);
    bench.controller.close();
    QTRY_COMPARE_WITH_TIMEOUT(closed.size(), 1, kLongMs);
    QStringList closing;
    for (const WirePiece& piece : lineClearing()) {
        closing << QString::fromLatin1(piece.bytes.toHex());
    }
    QVERIFY(sent.size() > closing.size());
    QCOMPARE(sent.mid(sent.size() - closing.size()), closing);
    for (const QString& packet : sent.mid(0, sent.size() - closing.size())) {
        QCOMPARE(packet, u"82"_s);
    }
}

void TestLineChange::texts_nameWhatCameBack()
{
    QSet<QString> advice;
    for (const auto heard :
         {LineAnswer::Silence, LineAnswer::EchoOnly, LineAnswer::Zeros, LineAnswer::Garbage}) {
        QVERIFY(!wiringAdvice(heard).isEmpty());
        advice << wiringAdvice(heard);
    }
    QCOMPARE(advice.size(), 4);
    LineSettings line;
    line.errorDetection = ErrorDetection::Crc7;
    line.polynomial = 0x91;
    line.stopBits = 2;
    QCOMPARE(lineText(line), u"19200 baud, CRC-7 with polynomial 0x91, two stop bits"_s);
    QVERIFY(vendorResetText().contains(u"inferred"_s)); // facts.md 6: grade I
    QVERIFY(leftOutText({}).isEmpty());
    QVERIFY(leftOutText({line}).contains(u"19200 baud, CRC-7 with polynomial 0x91,"_s));
}

QTEST_GUILESS_MAIN(TestLineChange)
#include "tst_linechange.moc"
