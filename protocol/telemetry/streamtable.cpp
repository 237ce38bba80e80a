// SPDX-License-Identifier: GPL-3.0-or-later
#include "protocol/telemetry/streamtable.h"

#include <QtGlobal>

namespace trex {

namespace {

// clang-format off
// A row's place is its number in recordings: new rows come last.
// Raw channels keep the wire's number: whether it is 0.4 µs or 4.9 mV, the mode of the moment says.
// Currents scale as on a TReX Jr; a TReX's differs (amperesPerCount).
constexpr auto kStreams = std::to_array<StreamRow>({
    {.key = "motor1-current", .title = QT_TRANSLATE_NOOP("Streams", "Motor 1"), .unit = "A", .scale = amperesPerCount(Model::TrexJr), .decimals = 2, .source = PollId::Currents, .field = 0, .colour = StreamColour::Motor1},
    {.key = "motor2-current", .title = QT_TRANSLATE_NOOP("Streams", "Motor 2"), .unit = "A", .scale = amperesPerCount(Model::TrexJr), .decimals = 2, .source = PollId::Currents, .field = 1, .colour = StreamColour::Motor2},
    {.key = "channel1-raw", .title = QT_TRANSLATE_NOOP("Streams", "Channel 1"), .source = PollId::RawChannels, .field = 0, .width = ValueWidth::Word, .invalid = kInvalidPulse, .colour = StreamColour::Channel1},
    {.key = "channel2-raw", .title = QT_TRANSLATE_NOOP("Streams", "Channel 2"), .source = PollId::RawChannels, .field = 1, .width = ValueWidth::Word, .invalid = kInvalidPulse, .colour = StreamColour::Channel2},
    {.key = "channel3-raw", .title = QT_TRANSLATE_NOOP("Streams", "Channel 3"), .source = PollId::RawChannels, .field = 2, .width = ValueWidth::Word, .invalid = kInvalidPulse, .colour = StreamColour::Channel3},
    {.key = "channel4-raw", .title = QT_TRANSLATE_NOOP("Streams", "Channel 4"), .source = PollId::RawChannels, .field = 3, .width = ValueWidth::Word, .invalid = kInvalidPulse, .colour = StreamColour::Channel4},
    {.key = "channel5-raw", .title = QT_TRANSLATE_NOOP("Streams", "Channel 5"), .source = PollId::RawChannels, .field = 4, .width = ValueWidth::Word, .invalid = kInvalidPulse, .colour = StreamColour::Channel5},
    {.key = "channel1-remapped", .title = QT_TRANSLATE_NOOP("Streams", "Channel 1 remapped"), .offset = -kFullSpeed, .source = PollId::RemappedChannels, .field = 0, .encoding = StreamEncoding::SignMagnitude, .colour = StreamColour::Channel1},
    {.key = "channel2-remapped", .title = QT_TRANSLATE_NOOP("Streams", "Channel 2 remapped"), .offset = -kFullSpeed, .source = PollId::RemappedChannels, .field = 1, .encoding = StreamEncoding::SignMagnitude, .colour = StreamColour::Channel2},
    {.key = "channel3-remapped", .title = QT_TRANSLATE_NOOP("Streams", "Channel 3 remapped"), .offset = -kFullSpeed, .source = PollId::RemappedChannels, .field = 2, .encoding = StreamEncoding::SignMagnitude, .colour = StreamColour::Channel3},
    {.key = "channel4-remapped", .title = QT_TRANSLATE_NOOP("Streams", "Channel 4 remapped"), .offset = -kFullSpeed, .source = PollId::RemappedChannels, .field = 3, .encoding = StreamEncoding::SignMagnitude, .colour = StreamColour::Channel4},
    {.key = "channel5-remapped", .title = QT_TRANSLATE_NOOP("Streams", "Channel 5 remapped"), .offset = -kFullSpeed, .source = PollId::RemappedChannels, .field = 4, .encoding = StreamEncoding::SignMagnitude, .colour = StreamColour::Channel5},
    {.key = "status", .title = QT_TRANSLATE_NOOP("Streams", "Status byte"), .source = PollId::Status, .field = 0},
    {.key = "uart-errors", .title = QT_TRANSLATE_NOOP("Streams", "UART error byte"), .source = PollId::UartErrors, .field = 0},
    {.key = "motor1-command", .title = QT_TRANSLATE_NOOP("Streams", "Motor 1 command"), .offset = -kFullSpeed, .source = Source::orders(), .field = 0, .invalid = kUnknownOrder, .colour = StreamColour::Motor1},
    {.key = "motor2-command", .title = QT_TRANSLATE_NOOP("Streams", "Motor 2 command"), .offset = -kFullSpeed, .source = Source::orders(), .field = 1, .invalid = kUnknownOrder, .colour = StreamColour::Motor2},
    {.key = "aux-command", .title = QT_TRANSLATE_NOOP("Streams", "Auxiliary motor command"), .offset = -kFullSpeed, .source = Source::orders(), .field = 2, .invalid = kUnknownOrder, .colour = StreamColour::Aux},
    {.key = "link-rate", .title = QT_TRANSLATE_NOOP("Streams", "Transactions"), .unit = "/s", .scale = 0.1, .decimals = 1, .source = Source::linkHealth(), .field = 0, .width = ValueWidth::Word},
    {.key = "link-latency", .title = QT_TRANSLATE_NOOP("Streams", "Round trip"), .unit = "ms", .scale = 0.01, .decimals = 2, .source = Source::linkHealth(), .field = 1, .width = ValueWidth::Word, .invalid = kNoLatency},
    {.key = "link-errors", .title = QT_TRANSLATE_NOOP("Streams", "Link errors"), .unit = "/s", .source = Source::linkHealth(), .field = 2},
});
// clang-format on

constexpr bool areRowsSound()
{
    for (std::size_t i = 0; i < kStreams.size(); ++i) {
        const StreamRow& row = kStreams[i];
        if (row.key.empty() || row.title == nullptr || row.field < 0
            || row.field >= sourceRow(row.source).values) {
            return false;
        }
        for (std::size_t j = 0; j < i; ++j) {
            if (kStreams[j].key == row.key) {
                return false;
            }
        }
    }
    return true;
}
static_assert(areRowsSound());

} // namespace

std::span<const StreamRow> streams()
{
    return kStreams;
}

int streamIndex(std::string_view key)
{
    for (std::size_t i = 0; i < kStreams.size(); ++i) {
        if (kStreams[i].key == key) {
            return static_cast<int>(i);
        }
    }
    return -1;
}

std::uint16_t storedFromRaw(const StreamRow& row, std::uint16_t raw)
{
    if (row.encoding == StreamEncoding::SignMagnitude) {
        return static_cast<std::uint16_t>(signedFromRemapped(static_cast<std::uint8_t>(raw))
                                          + kFullSpeed);
    }
    return raw;
}

std::uint16_t rawFromStored(const StreamRow& row, int stored)
{
    if (row.encoding == StreamEncoding::SignMagnitude) {
        constexpr int kSign = 0x80;
        const int speed = stored - kFullSpeed;
        return static_cast<std::uint16_t>(speed < 0 ? kSign - speed : speed);
    }
    return static_cast<std::uint16_t>(stored);
}

} // namespace trex
