// SPDX-License-Identifier: GPL-3.0-or-later
#include "protocol/storage/settingsadvice.h"

#include <QCoreApplication>

#include <cmath>

using namespace Qt::Literals::StringLiterals;

namespace trex {
namespace {

constexpr double kRatedHertzJr = 10'000.0; // facts.md 2.1: the TReX Jr's driver is rated for 10 kHz
constexpr int kLargestReading = 0xFF; // a motor current is one byte (command documentation, 0x8D)
constexpr int kLongestQueryBytes = 4; // a Pololu packet's query of one data byte (conformance C-03)
constexpr auto kDeviceNumber = parameterRow("device-number").number;
constexpr auto kRequired = parameterRow("required-channels").number;
constexpr auto kIgnored = parameterRow("ignored-channels").number;
constexpr auto kTimeout = parameterRow("serial-timeout").number;
constexpr auto kMotorMode = parameterRow("motor-mode").number;
constexpr auto kInputSource = parameterRow("channel-input-source").number;
constexpr auto kPolynomial = parameterRow("crc7-polynomial").number;
constexpr auto kUart = parameterRow("uart-settings").number;

struct Sentences {
    Q_DECLARE_TR_FUNCTIONS(Advice)
};

/// The values asked about, and the sentences as they come.
class Adviser {
public:
    Adviser(const ParameterValues& present, const ParameterValues& wanted)
        : m_present(present), m_wanted(wanted)
    {
    }

    [[nodiscard]] std::optional<int> wanted(std::uint8_t number) const
    {
        const auto found = m_wanted.find(number);
        return found == m_wanted.end() ? std::nullopt : std::optional(found->second);
    }
    [[nodiscard]] bool changes(std::uint8_t number) const
    {
        const auto found = m_present.find(number);
        return wanted(number) && (found == m_present.end() || found->second != *wanted(number));
    }
    void onValue(std::uint8_t number, const QString& text) { m_advice.push_back({number, text}); }
    void onChange(std::uint8_t number, const QString& text)
    {
        m_advice.push_back({number, text, true});
    }
    [[nodiscard]] std::vector<Advice> all() const { return m_advice; }

private:
    const ParameterValues& m_present;
    const ParameterValues& m_wanted;
    std::vector<Advice> m_advice;
};

void adviseOnTimeout(Adviser& adviser, const LineSettings& line)
{
    using std::chrono::milliseconds;
    const auto raw = adviser.wanted(kTimeout);
    if (raw == 0) {
        adviser.onValue(
            kTimeout,
            Sentences::tr("With the serial timeout off, motors keep running if the line is lost."));
        return;
    }
    // Between two of our packets there may be a reply that does not come (conformance C-10).
    const auto silence = line.timeout + line.timeOf(kLongestQueryBytes);
    const auto allowed =
        milliseconds(std::lround(physicalFromRaw(parameterRow("serial-timeout"), raw.value_or(0))));
    if (raw && allowed <= silence) {
        adviser.onValue(kTimeout,
                        Sentences::tr("%1 ms are no longer than this program waits for a reply "
                                      "(%2 ms): one lost reply may stop the motors.")
                            .arg(allowed.count())
                            .arg(std::chrono::ceil<milliseconds>(silence).count()));
    }
}

void adviseOnSafety(Adviser& adviser, const LineSettings& line)
{
    adviseOnTimeout(adviser, line);
    const int both = adviser.wanted(kRequired).value_or(0) & adviser.wanted(kIgnored).value_or(0);
    if (both != 0) {
        adviser.onValue(kRequired,
                        Sentences::tr("Both required and ignored: %1.")
                            .arg(parameterText(parameterRow("ignored-channels"), both)));
    }
}

void adviseOnPwm(Adviser& adviser, Model model)
{
    struct Motor {
        int number;
        std::uint8_t prescaler;
        std::uint8_t maximum;
    };
    constexpr std::array kMotors{Motor{1, parameterRow("motor1-pwm-prescaler").number,
                                       parameterRow("motor1-pwm-maximum").number},
                                 Motor{2, parameterRow("motor2-pwm-prescaler").number,
                                       parameterRow("motor2-pwm-maximum").number}};
    for (const auto& motor : kMotors) {
        const auto prescaler = adviser.wanted(motor.prescaler);
        const auto maximum = adviser.wanted(motor.maximum);
        const double hertz = prescaler && maximum ? pwmHertz(*prescaler, *maximum) : 0.0;
        if (model == Model::TrexJr && hertz > kRatedHertzJr) {
            adviser.onValue(
                motor.prescaler,
                Sentences::tr("Motor %1 gets %2 kHz; the TReX Jr's motor driver is rated for "
                              "10 kHz and may overheat.")
                    .arg(QString::number(motor.number), QString::number(hertz / 1000.0, 'f', 1)));
        }
    }
}

/// Current limits act in the 10 ms update, on accelerate commands only (facts.md 2.2).
void adviseOnLimits(Adviser& adviser, Model model)
{
    struct Motor {
        int number;
        const ParameterRow& limit;
        const ParameterRow& gain;
        const ParameterRow& acceleration;
    };
    const std::array motors{
        Motor{1, parameterRow("motor1-current-limit"), parameterRow("motor1-current-limit-p"),
              parameterRow("motor1-acceleration")},
        Motor{2, parameterRow("motor2-current-limit"), parameterRow("motor2-current-limit-p"),
              parameterRow("motor2-acceleration")}};
    for (const auto& motor : motors) {
        const int limit = adviser.wanted(motor.limit.number).value_or(0);
        if (limit == 0) {
            continue; // probably off
        }
        const auto say = [&](const QString& text) { adviser.onValue(motor.limit.number, text); };
        const QString name = QString::number(motor.number);
        if (2 * limit + 1 >= kLargestReading) { // facts.md 2, 0x13: value = 8-bit current / 2
            const double amperes = kLargestReading * amperesPerCount(model);
            say(Sentences::tr("The current reading of motor %1 is one byte and ends at %2 A, "
                              "within one step of this limit: it probably never exceeds it, and "
                              "the limit never acts.")
                    .arg(name, QString::number(amperes, 'f', 2)));
        }
        if (adviser.wanted(kMotorMode) == 1) {
            say(Sentences::tr("In joint mode no current is measured: the limit of motor %1 cannot "
                              "act.")
                    .arg(name));
        }
        if (adviser.wanted(motor.acceleration.number) == 0) {
            say(Sentences::tr("Motor %1 has unlimited acceleration, so that every 10 ms the speed "
                              "may jump back up before the limit holds it (inferred). Give it an "
                              "acceleration; the limit acts on accelerate commands only.")
                    .arg(name));
        }
        if (adviser.wanted(motor.gain.number) == 0) {
            say(Sentences::tr("With gain 0, motor %1 may not be slowed at all when it is over its "
                              "limit (a guess: the vendor does not state the law).")
                    .arg(name));
        }
    }
}

void adviseOnDeviceNumber(Adviser& adviser, const LineSettings& line,
                          const std::set<int>& numbersInUse)
{
    if (adviser.changes(kDeviceNumber)) {
        const int number = *adviser.wanted(kDeviceNumber);
        if (numbersInUse.contains(number)) {
            adviser.onChange(kDeviceNumber,
                             Sentences::tr("Another controller on this line has device number %1 "
                                           "already: both would answer at once.")
                                 .arg(number));
        }
        adviser.onChange(
            kDeviceNumber,
            line.form == PacketForm::Pololu
                ? Sentences::tr("The new device number acts at once: after writing, connect "
                                "again with device number %1.")
                      .arg(number)
                : Sentences::tr("Pololu packets reach this controller under number %1 from "
                                "then on; compact packets always do.")
                      .arg(number));
    }
}

/// The polynomial has eight bits, the parameter seven: the top bit is always 1 and not stored
/// (facts.md 2, 0x7D).
void adviseOnPolynomial(Adviser& adviser)
{
    const auto raw = adviser.wanted(kPolynomial);
    if (!raw || !accepts(parameterRow("crc7-polynomial"), *raw)) {
        return;
    }
    const QString full = parameterText(parameterRow("crc7-polynomial"), *raw);
    const auto uart = UartSettings::fromRaw(adviser.wanted(kUart).value_or(-1));
    const bool isOn = uart && uart->errorDetection == ErrorDetection::Crc7;
    if (isOn && *raw == 0) { // a multiple of x⁷ leaves no remainder
        adviser.onValue(kPolynomial,
                        Sentences::tr("With polynomial 0x80 every check byte is 0: CRC-7 would "
                                      "find no error at all."));
    } else if (isOn && *raw % 2 == 0) { // a polynomial without its lowest bit is a multiple of x
        adviser.onValue(kPolynomial,
                        Sentences::tr("The lowest bit of polynomial %1 is 0, so that the lowest "
                                      "bit of every check byte is too: CRC-7 finds fewer errors.")
                            .arg(full));
    }
    if (adviser.changes(kPolynomial)) {
        adviser.onChange(kPolynomial,
                         Sentences::tr("Stored is 0x%1, used is 0x%2: the top bit is always 1 and "
                                       "not stored. With CRC-7, connect with polynomial 0x%2 "
                                       "after the power cycle, or nothing answers.")
                             .arg(QString::number(*raw, 16).toUpper().rightJustified(2, u'0'))
                             .arg(full.mid(2)));
    }
}

void adviseOnUart(Adviser& adviser)
{
    if (adviser.changes(kUart)) {
        adviser.onChange(
            kUart,
            Sentences::tr("After the power cycle, connect with %1, or nothing answers.")
                .arg(parameterText(parameterRow("uart-settings"), *adviser.wanted(kUart))));
        const auto uart = UartSettings::fromRaw(*adviser.wanted(kUart));
        const int baud = uart ? kBaudRates[static_cast<std::size_t>(uart->baudIndex)] : 0;
        if (baud == 38400 || baud == 28800) { // facts.md 2.3
            adviser.onChange(
                kUart, Sentences::tr("Firmware before 1.2 runs at half of %1 baud.").arg(baud));
        }
    }
}

void adviseOnModes(Adviser& adviser)
{
    if (adviser.wanted(kMotorMode) == 1) {
        adviser.onValue(kMotorMode,
                        Sentences::tr("In joint mode there are no current readings, and motor 1 "
                                      "commands drive both bridges."));
    }
    if (adviser.changes(kInputSource)) {
        adviser.onChange(kInputSource,
                         Sentences::tr("The inputs have a calibration of their own for RC and "
                                       "for analog: after the power cycle the other one is in "
                                       "force."));
    }
}

} // namespace

std::vector<Advice> adviceOn(const ParameterValues& present, const ParameterValues& wanted,
                             const LineSettings& line, Model model,
                             const std::set<int>& numbersInUse)
{
    Adviser adviser(present, wanted);
    adviseOnSafety(adviser, line);
    adviseOnPwm(adviser, model);
    adviseOnLimits(adviser, model);
    adviseOnDeviceNumber(adviser, line, numbersInUse);
    adviseOnPolynomial(adviser);
    adviseOnUart(adviser);
    adviseOnModes(adviser);
    return adviser.all();
}

} // namespace trex
