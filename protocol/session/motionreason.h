// SPDX-License-Identifier: GPL-3.0-or-later
// Why the motors do, or do not, move: one sentence out of everything known, and what to do about
// it.
#pragma once

#include "protocol/session/motionfacts.h"

namespace trex {

enum class MotionCause : std::uint8_t {
    StopAsked,
    StopFailed,
    Connecting,
    NotFound,
    LinkLost,
    LinkError,
    NotConnected,
    Proving,
    StallGuard,
    LockedOut,
    Stopped,
    DriverFault,
    RequiredChannelMissing,
    OverrideActive,
    SafeStart,
    CommandPending,
    ArmedWithoutControl,
    ChannelsDrive,
    ChannelsControl,
    TimeoutLatched,
    UartShutdown,
    CurrentLimited,
    OverCurrent,
    DisarmedFor,
    Disarmed,
    JointMode,
    Braking,
    Ramping,
    NoCurrent,
    Driving,
    Armed,
};
inline constexpr int kMotionCauseCount = static_cast<int>(MotionCause::Armed) + 1;

enum class MotionRemedy : std::uint8_t { None, Connect, Disconnect, Arm, Disarm, Stop, OpenPanel };
enum class MotionLook : std::uint8_t { Off, Ok, Waiting, Warning, Fault };

struct MotionReason {
    MotionCause cause = MotionCause::NotConnected;
    MotionLook look = MotionLook::Off;
    QString sentence;
    MotionRemedy remedy = MotionRemedy::None;
    QLatin1StringView panel; ///< the control that changes it, for OpenPanel
    bool isGuess = false; ///< inferred (facts.md): the sentence says so, too
};

/// The first of the causes, in the order of MotionCause, that the facts bear out.
[[nodiscard]] MotionReason motionReason(const MotionFacts& facts);

} // namespace trex
