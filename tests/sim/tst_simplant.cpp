// SPDX-License-Identifier: GPL-3.0-or-later
#include "protocol/sim/inputmodel.h"
#include "protocol/sim/motormodel.h"

#include <QTest>

#include <cmath>

using namespace trex;
using namespace trex::sim;

class TstSimPlant : public QObject {
    Q_OBJECT
private slots:
    void motor_drawsWhatABenchMotorDraws_data();
    void motor_drawsWhatABenchMotorDraws();
    void start_drawsASpike();
    void reversal_drawsMoreThanStalling();
    void braking_endsSoonerThanCoasting();
    void friction_holdsAtSmallDuty();
    void rest_isRest();
    void stick_restsThenReachesBothEnds();
    void defaultSignals_areGentle();
    void waves_stayWithinTheirLimits_data();
    void waves_stayWithinTheirLimits();
    void sameSeed_givesTheSameSignals();
};

namespace {

void run(MotorModel& motor, double duty, int ms, double brake = 0.0)
{
    for (int i = 0; i < ms; ++i) {
        motor.step(duty, brake);
    }
}

} // namespace

void TstSimPlant::motor_drawsWhatABenchMotorDraws_data()
{
    QTest::addColumn<double>("load");
    QTest::addColumn<bool>("stall");
    QTest::addColumn<double>("amperes");
    QTest::newRow("free") << 0.0 << false << 0.25;
    QTest::newRow("load 0.4") << 0.4 << false << 1.2;
    QTest::newRow("stalled") << 0.0 << true << 5.5;
}

void TstSimPlant::motor_drawsWhatABenchMotorDraws()
{
    QFETCH(double, load);
    QFETCH(bool, stall);
    QFETCH(double, amperes);
    for (const double duty : {1.0, -1.0}) {
        MotorModel motor;
        motor.setLoad(load);
        motor.setStall(stall);
        run(motor, duty, 3000);
        QVERIFY2(std::abs(motor.amperes() * duty - amperes) < 0.1 * amperes,
                 qPrintable(QString::number(motor.amperes())));
        QCOMPARE(motor.radiansPerSecond() == 0.0, stall);
        QVERIFY(motor.radiansPerSecond() * duty >= 0.0);
    }
}

void TstSimPlant::start_drawsASpike()
{
    MotorModel motor;
    double peak = 0.0;
    for (int i = 0; i < 1000; ++i) {
        motor.step(1.0, 0.0);
        peak = std::max(peak, motor.amperes());
    }
    QVERIFY(peak > 4.0);
    QVERIFY(motor.amperes() < 0.4);
}

void TstSimPlant::reversal_drawsMoreThanStalling()
{
    MotorModel motor;
    run(motor, 1.0, 2000);
    double peak = 0.0;
    for (int i = 0; i < 50; ++i) {
        motor.step(-1.0, 0.0);
        peak = std::max(peak, -motor.amperes());
    }
    QVERIFY2(peak > 8.0 && peak < 11.5, qPrintable(QString::number(peak)));
}

void TstSimPlant::braking_endsSoonerThanCoasting()
{
    const auto timeToRest = [](double brake) {
        MotorModel motor;
        run(motor, 1.0, 2000);
        int ms = 0;
        while (motor.radiansPerSecond() > 10.0 && ms < 60'000) {
            motor.step(0.0, brake);
            ++ms;
        }
        return ms;
    };
    QVERIFY(timeToRest(1.0) * 3 < timeToRest(0.0));
    QVERIFY(timeToRest(1.0) < timeToRest(0.5));
    QVERIFY(timeToRest(0.5) < timeToRest(0.0));
}

void TstSimPlant::friction_holdsAtSmallDuty()
{
    MotorModel motor;
    run(motor, 0.02, 1000);
    QCOMPARE(motor.radiansPerSecond(), 0.0);
    QVERIFY(motor.amperes() > 0.05);
}

void TstSimPlant::rest_isRest()
{
    MotorModel motor;
    run(motor, 1.0, 1000);
    run(motor, 0.0, 10'000);
    QCOMPARE(motor.amperes(), 0.0);
    QCOMPARE(motor.radiansPerSecond(), 0.0);
}

void TstSimPlant::stick_restsThenReachesBothEnds()
{
    Scenario scenario;
    scenario.stick = StickPlan{3.0, 6.0};
    InputModel inputs(scenario, 5);
    for (int channel = 1; channel <= kChannelCount; ++channel) {
        int restLow = 9999;
        int restHigh = 0;
        int low = 9999;
        int high = 0;
        for (int i = 0; i < 450; ++i) {
            const int raw = inputs.sample(channel, i * 0.02, InputKind::Rc).value_or(0);
            (i < 150 ? restLow : low) = std::min(i < 150 ? restLow : low, raw);
            (i < 150 ? restHigh : high) = std::max(i < 150 ? restHigh : high, raw);
        }
        QVERIFY(restHigh - restLow <= 4 && restHigh > restLow);
        QVERIFY(std::abs(restLow - 3750) < 30);
        QVERIFY(low > 2500 && low < 2700);
        QVERIFY(high > 4800 && high < 5000);
    }
}

// C-19: channel 5 stays off
void TstSimPlant::defaultSignals_areGentle()
{
    InputModel inputs({}, 1);
    for (const InputKind kind : {InputKind::Rc, InputKind::Analog}) {
        std::optional<int> before;
        for (int i = 0; i < 1000; ++i) {
            const int raw = inputs.sample(1, i * 0.02, kind).value_or(0xFFFF);
            QVERIFY(raw <= 5002);
            QVERIFY(!before || std::abs(raw - *before) < 40);
            before = raw;
            const int top = kind == InputKind::Rc ? 5000 : 1023;
            QVERIFY(std::abs(inputs.sample(4, i * 0.02, kind).value_or(0) - top) <= 2);
            QVERIFY(std::abs(inputs.sample(5, i * 0.02, kind).value_or(0) - top) <= 2);
        }
    }
}

void TstSimPlant::waves_stayWithinTheirLimits_data()
{
    QTest::addColumn<Wave>("wave");
    QTest::newRow("sine") << Wave::Sine;
    QTest::newRow("square") << Wave::Square;
    QTest::newRow("ramp") << Wave::Ramp;
    QTest::newRow("noise") << Wave::Noise;
    QTest::newRow("stick") << Wave::Stick;
}

void TstSimPlant::waves_stayWithinTheirLimits()
{
    QFETCH(Wave, wave);
    ChannelWave row;
    row.channel = 2;
    row.wave = wave;
    row.minimum = 3000;
    row.maximum = 4500;
    row.period = 1.0;
    row.jitter = 0.0;
    row.from = 1.0;
    row.to = 21.0;
    Scenario scenario;
    scenario.channels = {row};
    InputModel inputs(scenario, 3);
    QCOMPARE(int(inputs.sample(2, 0.5, InputKind::Rc).value_or(0)), 3750);
    int low = 9999;
    int high = 0;
    for (int i = 0; i < 2000; ++i) {
        const int raw = inputs.sample(2, 1.0 + i * 0.01, InputKind::Rc).value_or(0);
        low = std::min(low, raw);
        high = std::max(high, raw);
    }
    QVERIFY(low >= 3000 && low < 3010);
    QVERIFY(high <= 4500 && high > 4490);
    QCOMPARE(int(inputs.sample(2, 21.5, InputKind::Rc).value_or(0)), 3750);
}

void TstSimPlant::sameSeed_givesTheSameSignals()
{
    ChannelWave row;
    row.wave = Wave::Noise;
    row.missing = 0.3;
    Scenario scenario;
    scenario.channels = {row};
    InputModel first(scenario, 3);
    InputModel second(scenario, 3);
    InputModel third(scenario, 4);
    int differences = 0;
    int missing = 0;
    for (int i = 0; i < 500; ++i) {
        const auto sample = first.sample(1, i * 0.02, InputKind::Rc);
        QCOMPARE(second.sample(1, i * 0.02, InputKind::Rc), sample);
        differences += third.sample(1, i * 0.02, InputKind::Rc) != sample ? 1 : 0;
        missing += sample ? 0 : 1;
    }
    QVERIFY(differences > 100);
    QVERIFY(missing > 100 && missing < 200);
}

QTEST_GUILESS_MAIN(TstSimPlant)
#include "tst_simplant.moc"
