// SPDX-License-Identifier: GPL-3.0-or-later
#include "protocol/procedures/markkeeper.h"

#include "protocol/errortext.h"
#include "protocol/procedures/writeaudit.h"
#include "protocol/session/controller.h"
#include "protocol/session/devicesettings.h"

namespace trex {

using namespace Qt::Literals::StringLiterals;

namespace {

struct BitRow {
    StatusLatch::Byte byte;
    std::uint8_t mask;
    MarkKind kind;
    const char* text; ///< QT_TRANSLATE_NOOP("trex::MarkKeeper", …)
};

constexpr auto kStatus = StatusLatch::Byte::Status;
constexpr auto kUart = StatusLatch::Byte::Uart;

// The summary bit "UART error" of the status byte is left out: the error byte says which it was.
// clang-format off
constexpr std::array kBits{
    BitRow{kStatus, statusbit::kMotor1OverCurrent, MarkKind::OverCurrent, QT_TRANSLATE_NOOP("trex::MarkKeeper", "Motor 1 over its current limit")},
    BitRow{kStatus, statusbit::kMotor2OverCurrent, MarkKind::OverCurrent, QT_TRANSLATE_NOOP("trex::MarkKeeper", "Motor 2 over its current limit")},
    BitRow{kStatus, statusbit::kMotor1Fault,       MarkKind::Fault,       QT_TRANSLATE_NOOP("trex::MarkKeeper", "Motor 1 fault")},
    BitRow{kStatus, statusbit::kMotor2Fault,       MarkKind::Fault,       QT_TRANSLATE_NOOP("trex::MarkKeeper", "Motor 2 fault")},
    BitRow{kUart,   uartbit::kTimeout,             MarkKind::Timeout,     QT_TRANSLATE_NOOP("trex::MarkKeeper", "Serial timeout in the controller")},
    BitRow{kUart,   uartbit::kFormat,              MarkKind::LineError,   QT_TRANSLATE_NOOP("trex::MarkKeeper", "UART error: packet format")},
    BitRow{kUart,   uartbit::kCrc,                 MarkKind::LineError,   QT_TRANSLATE_NOOP("trex::MarkKeeper", "UART error: CRC")},
    BitRow{kUart,   uartbit::kFrame,               MarkKind::LineError,   QT_TRANSLATE_NOOP("trex::MarkKeeper", "UART error: frame")},
    BitRow{kUart,   uartbit::kOverrun,             MarkKind::LineError,   QT_TRANSLATE_NOOP("trex::MarkKeeper", "UART error: data overrun")},
    BitRow{kUart,   uartbit::kParity,              MarkKind::LineError,   QT_TRANSLATE_NOOP("trex::MarkKeeper", "UART error: parity")},
    BitRow{kUart,   uartbit::kReadBufferOverrun,   MarkKind::LineError,   QT_TRANSLATE_NOOP("trex::MarkKeeper", "UART error: read buffer overrun")},
    BitRow{kUart,   uartbit::kSendBufferOverrun,   MarkKind::LineError,   QT_TRANSLATE_NOOP("trex::MarkKeeper", "UART error: send buffer overrun")},
};
// clang-format on

int bitOf(std::uint8_t mask)
{
    int bit = 0;
    while ((mask >> bit & 1) == 0) {
        ++bit;
    }
    return bit;
}

} // namespace

MarkKeeper::MarkKeeper(MarkTrack& track, Controller& controller, const StatusLatch& latch,
                       DeviceSettings& settings, QObject* parent)
    : QObject(parent), m_track(track), m_controller(controller), m_latch(latch)
{
    connect(&controller, &Controller::stateChanged, this, &MarkKeeper::onState);
    connect(&controller, &Controller::armedChanged, this,
            [this](bool armed) { add(armed ? MarkKind::Armed : MarkKind::Disarmed); });
    connect(&controller, &Controller::stopped, this, [this] { add(MarkKind::Stop); });
    connect(&controller, &Controller::restarted, this, [this] { add(MarkKind::Restarted); });
    connect(&latch, &StatusLatch::changed, this, &MarkKeeper::onLatch);
    connect(&settings, &DeviceSettings::writeConcluded, this, &MarkKeeper::onWrite);
}

void MarkKeeper::add(MarkKind kind, const QString& text)
{
    m_track.append({std::chrono::steady_clock::now(), kind, text});
}

void MarkKeeper::onState(LinkState state)
{
    const auto error = m_controller.lastError();
    switch (state) {
    case LinkState::Connected:
        add(MarkKind::Connected, m_isLost ? tr("Link back") : QString());
        m_isOpen = true;
        m_isLost = false;
        break;
    case LinkState::Lost:
    case LinkState::Retrying:
        if (m_isOpen && !std::exchange(m_isLost, true)) {
            add(MarkKind::LinkLost, error ? tr("Link lost: %1").arg(errorText(*error)) : QString());
        }
        break;
    case LinkState::Disconnected:
        if (std::exchange(m_isOpen, false)) {
            add(MarkKind::Disconnected);
        }
        m_isLost = false;
        break;
    case LinkState::Connecting:
        break;
    }
}

/// A bit that stays set from read to read is one event, marked where it was first seen.
void MarkKeeper::onLatch()
{
    for (const BitRow& row : kBits) {
        const auto read = m_latch.lastRead(row.byte);
        const int bit = bitOf(row.mask);
        const bool isLit = read && m_latch.entry(row.byte, bit).lit;
        bool& wasLit =
            m_wasLit.at(static_cast<std::size_t>(row.byte)).at(static_cast<std::size_t>(bit));
        if (isLit && !wasLit) {
            m_track.append({*read, row.kind, tr(row.text)});
        }
        wasLit = isLit;
    }
}

std::vector<Mark> MarkKeeper::marksOf(StatusLatch::Byte byte, std::uint8_t risen, Instant time)
{
    std::vector<Mark> marks;
    for (const BitRow& row : kBits) {
        if (row.byte == byte && (row.mask & risen) != 0) {
            marks.push_back({time, row.kind, tr(row.text)});
        }
    }
    return marks;
}

void MarkKeeper::onWrite(const WriteIntent& intent, const WriteConclusion& conclusion)
{
    if (conclusion.result == WriteResult::Refused || conclusion.result == WriteResult::Old) {
        return; // nothing changed
    }
    const SettingId& setting = intent.setting;
    if (setting.row != nullptr && setting.row->isTrigger) {
        add(MarkKind::Written, tr("Factory reset"));
        return;
    }
    const bool isSeen =
        conclusion.result == WriteResult::New || conclusion.result == WriteResult::Other;
    const QString now =
        textOf(setting, isSeen && conclusion.found ? conclusion.found : intent.after);
    const QString text =
        u"%1: %2 → %3"_s.arg(titleOf(setting), textOf(setting, intent.before), now);
    add(MarkKind::Written, isSeen ? text : tr("%1 (not read back)").arg(text));
}

} // namespace trex
