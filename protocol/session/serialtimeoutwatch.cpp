// SPDX-License-Identifier: GPL-3.0-or-later
#include "protocol/session/serialtimeoutwatch.h"

#include "protocol/errortext.h"
#include "protocol/session/devicesettings.h"

namespace trex {

using namespace std::chrono_literals;

namespace {

constexpr const ParameterRow& kRow = parameterRow("serial-timeout");
constexpr auto kUnit = 100ms; // facts.md 2, 0x07
constexpr auto kShortest = kUnit; // what to expect while it is not known
constexpr double kMargin = 1.1; // timers are late now and then

} // namespace

SerialTimeoutWatch::SerialTimeoutWatch(Controller& controller, DeviceSettings& settings,
                                       QObject* parent)
    : QObject(parent), m_controller(controller), m_settings(settings)
{
    connect(&controller, &Controller::stateChanged, this, [this](LinkState state) {
        if (state == LinkState::Connected) {
            onConnected();
        }
        refresh();
    });
    connect(&controller, &Controller::armedChanged, this, &SerialTimeoutWatch::refresh);
    connect(&settings, &DeviceSettings::forgotten, this, &SerialTimeoutWatch::refresh);
    connect(&settings, &DeviceSettings::parameterChanged, this, [this](int number) {
        if (number == kRow.number) {
            refresh();
        }
    });
}

void SerialTimeoutWatch::onConnected()
{
    // Surely: without CRC-7 a damaged reply could hide that it is off.
    m_settings.readSurely(kRow, std::nullopt, this, [this](const Result<int>& read) {
        if (!read) {
            tell(1,
                 tr("The controller's serial timeout could not be read (%1). Whether the "
                    "motors would stop if this program died is not known.")
                     .arg(errorText(read.error())));
        }
        refresh();
    });
}

SerialTimeoutWatch::State SerialTimeoutWatch::state() const
{
    const auto raw = m_settings.parameter(kRow.number);
    if (m_controller.state() != LinkState::Connected || !raw) {
        return State::Unknown;
    }
    return *raw == 0 ? State::Off : State::On;
}

std::chrono::milliseconds SerialTimeoutWatch::timeout() const
{
    return state() == State::On ? *m_settings.parameter(kRow.number) * kUnit : 0ms;
}

double SerialTimeoutWatch::keepAliveHertz(std::chrono::milliseconds timeout)
{
    return timeout > 0ms ? kMargin * 3.0 * 1000.0 / static_cast<double>(timeout.count()) : 0.0;
}

void SerialTimeoutWatch::refresh()
{
    const State now = state();
    const auto silence = now == State::Unknown ? kShortest : timeout();
    m_controller.want(this, PollId::SerialControl,
                      m_controller.isArmed() ? keepAliveHertz(silence) : 0.0);
    if (now == m_state && now != State::On) {
        return;
    }
    if (now == State::Off && m_state != now) {
        tell(1,
             tr("The controller's serial timeout is off: if this program, its computer or the "
                "cable fails, the motors run on."));
    }
    m_state = now;
    emit changed();
}

void SerialTimeoutWatch::tell(int severity, const QString& text)
{
    emit m_controller.eventLogged(severity, text);
}

void SerialTimeoutWatch::setIt()
{
    m_settings.writeParameter(
        kRow, kSensible, true, this, [this](const Result<DeviceSettings::ParameterWrite>& written) {
            if (written) {
                tell(0,
                     tr("The controller's serial timeout is %1 ms now: the motors stop when "
                        "nothing is heard from here for so long.")
                         .arg(kSensible * kUnit / 1ms));
            } else {
                tell(2, tr("The serial timeout was not set: %1").arg(errorText(written.error())));
            }
            refresh();
        });
}

} // namespace trex
