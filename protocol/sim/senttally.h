// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QByteArrayView>

#include <array>
#include <cstdint>

namespace trex::sim {

/// What a controller has answered since it was made, by command: how often, and for each byte of
/// the replies a digest in which every value and their order count. What a host has kept can be
/// held against it, however long it took.
class SentTally {
public:
    static constexpr std::size_t kLongest = 10; ///< payload: five words
    struct Replies {
        std::uint64_t count = 0;
        std::array<std::uint64_t, kLongest> digests{};
    };

    /// FNV-1a, 64 bits; begins with 0.
    [[nodiscard]] static constexpr std::uint64_t step(std::uint64_t digest, std::uint8_t byte)
    {
        return (digest ^ (byte + std::uint64_t(1))) * 0x0000'0100'0000'01B3U;
    }
    void add(std::uint8_t command, QByteArrayView payload)
    {
        Replies& replies = m_replies[command & 0x7FU];
        ++replies.count;
        for (std::size_t i = 0; i < kLongest && i < std::size_t(payload.size()); ++i) {
            replies.digests[i] =
                step(replies.digests[i], static_cast<std::uint8_t>(payload[qsizetype(i)]));
        }
    }
    [[nodiscard]] const Replies& of(std::uint8_t command) const
    {
        return m_replies[command & 0x7FU];
    }

private:
    std::array<Replies, 128> m_replies{}; ///< all commands have their highest bit set
};

} // namespace trex::sim
