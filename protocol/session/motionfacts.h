// SPDX-License-Identifier: GPL-3.0-or-later
// What is known about the motors at one moment, and the questions that motionreason.cpp asks of it.
#pragma once

#include "protocol/codec/polltable.h"
#include "protocol/codec/replies.h"
#include "protocol/session/motorgate.h"
#include "protocol/session/transaction.h"

namespace trex {

/// What is known now. An empty optional is not known, never assumed.
struct MotionFacts {
    LinkState link = LinkState::Disconnected;
    std::optional<Error> error; ///< of the link
    QString port;
    bool wasConnected = false; ///< on this line: losing it is another thing than not finding it
    bool isArmed = false;
    Disarming disarming;
    bool isLockedOut = false;
    bool isJustStopped = false; ///< asked for within the last seconds
    StopProgress stop = StopProgress::None; ///< of a stop of the last seconds
    std::array<MotorOrder, 3> orders{};
    std::array<MotorOrder, 3> sent{};
    bool isSettled = false; ///< the orders stand for a second: currents have followed them
    bool isRampingDown = false; ///< by the stall guard
    bool isProving = false; ///< the watchdog proof is silent on purpose
    std::optional<Mode> mode;
    std::optional<bool> serialControls;
    std::optional<std::array<std::uint16_t, kChannelCount>> raw; ///< inputs
    std::optional<std::array<std::uint16_t, kChannelCount>> remapped;
    std::optional<std::array<std::uint16_t, 2>> currents; ///< counts
    std::uint8_t status = 0; ///< bits seen in the last seconds
    std::uint8_t uart = 0;
    std::optional<bool> isJoint;
    std::optional<int> requiredChannels; ///< masks
    std::optional<int> ignoredChannels;
    std::optional<int> uartErrorShutdown;
    std::optional<std::array<int, 2>> currentLimits; ///< raw; 0: none
};

namespace motionfacts {

// Command documentation, 0x84 and 0x85.
inline constexpr std::uint8_t kOverCurrent = 0x80 | 0x20;
inline constexpr std::uint8_t kMotor1OverCurrent = 0x20;
inline constexpr std::uint8_t kDriverFault = 0x50;
inline constexpr std::uint8_t kMotor1Fault = 0x10;
inline constexpr std::uint8_t kTimeout = 0x80;
inline constexpr int kNearNeutral = 10; ///< of 127; how near safe-start wants it is not published
inline constexpr int kWorthCurrent = 20; ///< speeds below may draw less than one count

[[nodiscard]] bool isMoved(const MotorOrder& order);
[[nodiscard]] bool isDriven(const MotionFacts& facts);
[[nodiscard]] bool hasChannelMode(const MotionFacts& facts);
[[nodiscard]] QString orderText(const MotorOrder& order);
[[nodiscard]] QString ordersText(const std::array<MotorOrder, 3>& orders);
/// 1-based; 0: none. The first required channel without a valid pulse, as far as both are known.
[[nodiscard]] int missingChannel(const MotionFacts& facts);
[[nodiscard]] int remappedOf(const MotionFacts& facts, std::size_t channel);
/// What the channels tell motors 1 and 2 (conformance C-29).
[[nodiscard]] bool doChannelsOrder(const MotionFacts& facts);
[[nodiscard]] bool isWithoutCurrent(const MotionFacts& facts);
[[nodiscard]] bool isSafeStartLikely(const MotionFacts& facts);
/// A motor that is driven over its limit's worth, as the status byte says.
[[nodiscard]] bool isLimited(const MotionFacts& facts);
[[nodiscard]] bool isConnected(const MotionFacts& facts);
[[nodiscard]] bool isDisconnected(const MotionFacts& facts);
[[nodiscard]] bool isTrying(const MotionFacts& facts);
[[nodiscard]] bool isBraking(const MotionFacts& facts);
[[nodiscard]] bool isDisarmedByHand(const MotionFacts& facts); ///< or not armed ever
[[nodiscard]] bool isDisarmedFor(const MotionFacts& facts);
[[nodiscard]] int speedOf(const MotorOrder& order);
[[nodiscard]] QStringList errorWords(const MotionFacts& facts);
[[nodiscard]] QStringList faultyMotor(const MotionFacts& facts);
[[nodiscard]] QStringList overCurrentMotor(const MotionFacts& facts);
[[nodiscard]] QStringList disarmedWords(const MotionFacts& facts);
[[nodiscard]] QStringList channelOrders(const MotionFacts& facts);

} // namespace motionfacts
} // namespace trex
