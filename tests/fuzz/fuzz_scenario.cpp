// SPDX-License-Identifier: GPL-3.0-or-later
// What the simulator is told by people and files: a scenario, an address "sim:?...", a stored
// EEPROM. What it takes is then played for a moment.
#include "protocol/sim/scenario.h"
#include "protocol/sim/simulatedline.h"
#include "tests/fuzz/sentence.h"

#include <QJsonDocument>

#include <cmath>

using namespace trex;
using namespace std::chrono_literals;
using fuzz::holds;

namespace {

void playFor(sim::SimOptions options, Duration duration)
{
    options.stateFile.clear();
    sim::SimulatedLine line(options, Instant(1h));
    for (Instant now(1h); now < Instant(1h) + duration; now += 20ms) {
        line.write(QByteArrayView("\x86\x1F\x8F\x84", 4), now);
        (void)line.read(now + 10ms);
        for (std::size_t i = 0; i < line.deviceCount(); ++i) {
            holds(std::isfinite(line.device(i).amperes(MotorId::Motor1)), "currents are numbers");
        }
    }
}

void readScenario(const QByteArray& json)
{
    const auto scenario = sim::parseScenario(json, fuzz::fileName());
    if (!scenario) {
        fuzz::holdsSentence(scenario.error());
        return;
    }
    sim::SimOptions options;
    options.scenario = *scenario;
    playFor(options, 200ms);
}

void readAddress(const QByteArray& text)
{
    const QString address = QStringLiteral("sim:?") + QString::fromUtf8(text);
    if (address.contains(QStringLiteral("scenario")) || address.contains(QStringLiteral("state"))
        || address.contains(u'%')) {
        return; // they name files
    }
    const auto options = sim::simOptionsFromUrl(address);
    if (!options) {
        holds(!options.error().context.isEmpty(), "a refused address is told why");
        return;
    }
    holds(options->validate().has_value(), "what an address says is in range");
    playFor(*options, 100ms);
}

void readEeprom(const QByteArray& json)
{
    const auto eeprom = sim::Eeprom::fromJson(QJsonDocument::fromJson(json).object());
    if (!eeprom) {
        holds(!eeprom.error().context.isEmpty(), "a refused state is told why");
        return;
    }
    const auto again = sim::Eeprom::fromJson(eeprom->toJson());
    holds(again.has_value() && again->toJson() == eeprom->toJson(), "a state is kept as it is");
    // Whatever it holds, a controller with it runs.
    sim::Device device({}, 0, &*eeprom, Instant(1h));
    for (const char each : QByteArray("\x81\xC2\x40\x90\x9F\x01\xFF")) {
        device.receive({.value = static_cast<std::uint8_t>(each)}, Instant(1h), Instant(1h) + 5ms);
    }
    device.advance(Instant(1h) + 200ms);
}

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
    fuzz::Input input(data, size);
    const int kind = input.byte();
    if (kind == 'A') {
        readAddress(input.rest());
    } else if (kind == 'E') {
        readEeprom(input.rest());
    } else {
        readScenario(input.rest());
    }
    return 0;
}
