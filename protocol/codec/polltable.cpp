// SPDX-License-Identifier: GPL-3.0-or-later
#include "protocol/codec/polltable.h"

namespace trex {
namespace {

static_assert([] {
    for (std::size_t i = 0; i < kPolls.size(); ++i) {
        if (static_cast<std::size_t>(kPolls[i].id) != i || kPolls[i].values > kChannelCount) {
            return false;
        }
    }
    return true;
}());

} // namespace

const PollRow& pollRow(PollId id)
{
    return kPolls[static_cast<std::size_t>(id)];
}

Command pollCommand(PollId id)
{
    const auto& row = pollRow(id);
    return row.hasMask ? channelsQuery(row.commandKey, kAllChannelsMask) : query(row.commandKey);
}

PollSample decodePoll(PollId id, QByteArrayView payload, Instant time)
{
    PollSample sample{id, {}, time};
    const auto& row = pollRow(id);
    const qsizetype width = findCommand(row.commandKey)->reply.front().width();
    for (int i = 0; i < row.values && (i + 1) * width <= payload.size(); ++i) {
        const char* const bytes = payload.data() + i * width;
        const auto low = static_cast<std::uint8_t>(bytes[0]);
        const auto high = width == 2 ? static_cast<std::uint8_t>(bytes[1]) : std::uint8_t{0};
        sample.raw[static_cast<std::size_t>(i)] = static_cast<std::uint16_t>(low | high << 8);
    }
    return sample;
}

} // namespace trex
