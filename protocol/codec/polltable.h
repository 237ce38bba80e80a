// SPDX-License-Identifier: GPL-3.0-or-later
// The queries that are asked over and over while panels want them, with the rates they run at
// when the line can carry them.
#pragma once

#include "protocol/codec/command.h"

#include <array>
#include <string_view>

namespace trex {

enum class PollId : std::uint8_t {
    Currents,
    RawChannels,
    RemappedChannels,
    Status,
    UartErrors,
    Mode,
    SerialControl,
    Learned
};
inline constexpr int kPollCount = 8;

struct PollRow {
    PollId id;
    std::string_view key;
    std::string_view commandKey;
    bool hasMask; ///< asks for all five channels
    double hertz; ///< the rate asked for at the default 19200 baud
    int values; ///< how many numbers one reply carries
};

inline constexpr std::array<PollRow, kPollCount> kPolls{{
    {PollId::Currents, "currents", "get-currents", false, 80.0, 2},
    {PollId::RawChannels, "raw-channels", "get-raw-channels", true, 50.0, 5},
    {PollId::RemappedChannels, "remapped-channels", "get-remapped-channels", true, 50.0, 5},
    {PollId::Status, "status", "get-status", false, 10.0, 1},
    {PollId::UartErrors, "uart-errors", "get-uart-errors", false, 10.0, 1},
    {PollId::Mode, "mode", "get-mode", false, 2.0, 1},
    {PollId::SerialControl, "serial-control", "get-serial-control", false, 5.0, 1},
    {PollId::Learned, "learned", "get-learned", false, 1.0, 1},
}};

[[nodiscard]] const PollRow& pollRow(PollId id);
[[nodiscard]] Command pollCommand(PollId id);

/// One poll's reply, decoded to raw numbers, with the time of its read.
struct PollSample {
    PollId poll = PollId::Currents;
    std::array<std::uint16_t, kChannelCount> raw{}; ///< the first PollRow::values are meant
    Instant time;
};
[[nodiscard]] PollSample decodePoll(PollId id, QByteArrayView payload, Instant time);

} // namespace trex
