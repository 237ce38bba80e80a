// SPDX-License-Identifier: GPL-3.0-or-later
#include "protocol/storage/settingsadvice.h"

#include <QCoreApplication>

using namespace Qt::Literals::StringLiterals;

namespace trex {
namespace {

constexpr double kRatedHertzJr = 10'000.0; // facts.md 2.1: the TReX Jr's driver is rated for 10 kHz
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

void adviseOnSafety(Adviser& adviser)
{
    if (adviser.wanted(kTimeout) == 0) {
        adviser.onValue(
            kTimeout,
            Sentences::tr("With the serial timeout off, motors keep running if the line is lost."));
    }
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

void adviseOnLine(Adviser& adviser, const LineSettings& line)
{
    if (adviser.changes(kDeviceNumber)) {
        const int number = *adviser.wanted(kDeviceNumber);
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
    const auto polynomial = adviser.wanted(kPolynomial);
    if (adviser.changes(kPolynomial)) {
        adviser.onChange(
            kPolynomial,
            Sentences::tr("With CRC-7, connect with polynomial %1 after the power cycle, or "
                          "nothing answers.")
                .arg(parameterText(parameterRow("crc7-polynomial"), *polynomial)));
    }
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
                             const LineSettings& line, Model model)
{
    Adviser adviser(present, wanted);
    adviseOnSafety(adviser);
    adviseOnPwm(adviser, model);
    adviseOnLine(adviser, line);
    adviseOnModes(adviser);
    return adviser.all();
}

} // namespace trex
