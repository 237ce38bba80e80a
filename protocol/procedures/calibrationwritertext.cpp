// SPDX-License-Identifier: GPL-3.0-or-later
// What a CalibrationWriter did, found or put back, as sentences.
#include "protocol/procedures/calibrationtext.h"
#include "protocol/procedures/calibrationwriter.h"

namespace trex {
namespace {

bool isOne(std::uint8_t mask)
{
    return (mask & (mask - 1)) == 0;
}

} // namespace

/// What is in the controller now, as far as is known without asking it again.
QString CalibrationWriter::writtenText() const
{
    const auto written = channelsIn(State::Written);
    const auto nearest = channelsIn(State::NearestWritten);
    const auto unchanged = channelsIn(State::Unchanged);
    const auto failed = channelsIn(State::Failed);
    const auto refused = channelsIn(State::Refused);
    const auto directions = state(kDirections);
    const bool areDirectionsQuiet =
        directions == State::Untouched || directions == State::Unchanged;
    QStringList sentences;
    if ((written | nearest | failed | refused) == 0 && areDirectionsQuiet) {
        return unchanged != 0 && !m_isInterrupted && !m_isStopAsked
            ? tr("The controller already held these values; nothing was written.")
            : tr("Nothing was changed in the controller.");
    }
    if (written != 0) {
        sentences << tr("Channels written and read back: %1.").arg(channelListText(written));
    }
    if (nearest != 0) {
        sentences << tr("Channels written as the nearest values that this controller can take: %1 "
                        "(it reads the bytes of a calibration as 8 bits each).")
                         .arg(channelListText(nearest));
    }
    if (unchanged != 0) {
        sentences << tr("Channels that were so already: %1.").arg(channelListText(unchanged));
    }
    if (refused != 0) {
        sentences
            << tr("Channel %1 was refused and keeps its old values.").arg(channelListText(refused));
    }
    if (failed != 0) {
        sentences << tr("Channel %1 may hold its old or its new values: read it again.")
                         .arg(channelListText(failed));
    }
    if (directions == State::Written) {
        sentences << tr("Directions (parameter 0x03) written and read back: %1.")
                         .arg(channelListText(m_plan.reversedMask));
    } else if (directions == State::Failed) {
        sentences << tr("The directions (parameter 0x03) may be the old or the new ones.");
    } else if (directions == State::Refused) {
        sentences << tr("The directions (parameter 0x03) were refused and stay as they were.");
    }
    if ((failed | refused) != 0 || m_isStopAsked) {
        sentences << tr("All other channels are as before.");
    }
    return sentences.join(u' ');
}

/// What was found when everything that had been written was read once more.
QString CalibrationWriter::heldText() const
{
    const auto held = channelsIn(State::HoldsNew);
    const auto old = channelsIn(State::HoldsOld);
    const auto other = channelsIn(State::HoldsOther);
    QStringList parts;
    if (held != 0) {
        parts << (isOne(held) ? tr("Channel %1 holds the new values")
                              : tr("Channels %1 hold the new values"))
                     .arg(channelListText(held));
    }
    if (old != 0) {
        const bool isFirst = parts.isEmpty();
        parts << (isOne(old)    ? isFirst ? tr("Channel %1 still holds the old values")
                                          : tr("channel %1 still the old ones")
                         : isFirst ? tr("Channels %1 still hold the old values")
                                : tr("channels %1 still the old ones"))
                     .arg(channelListText(old));
    }
    if (other != 0) {
        parts << tr("channel %1 holds neither the old nor the new values: undo, or calibrate it "
                    "again")
                     .arg(channelListText(other));
    }
    QStringList sentences;
    if (!parts.isEmpty()) {
        sentences << tr("Read back: %1.").arg(parts.join(u"; "));
    }
    switch (state(kDirections)) {
    case State::HoldsNew:
        sentences << tr("The directions (parameter 0x03) are the new ones.");
        break;
    case State::HoldsOld:
        sentences << tr("The directions (parameter 0x03) are still the old ones.");
        break;
    case State::HoldsOther:
        sentences << tr("The directions (parameter 0x03) are neither the old nor the new ones.");
        break;
    default:
        break;
    }
    return sentences.isEmpty() ? tr("Nothing was changed in the controller.")
                               : sentences.join(u' ');
}

QString CalibrationWriter::undoneText() const
{
    const auto restored = channelsIn(State::Restored);
    const auto nearest = channelsIn(State::NearestRestored);
    QStringList sentences;
    if (restored != 0) {
        sentences << tr("The former values are back, and were read back: channels %1.")
                         .arg(channelListText(restored));
    }
    if (nearest != 0) {
        sentences << tr("The nearest to the former values that this controller can take: channels "
                        "%1.")
                         .arg(channelListText(nearest));
    }
    if (state(kDirections) == State::Restored) {
        sentences << tr("The directions (parameter 0x03) are as they were.");
    }
    return sentences.join(u' ');
}

} // namespace trex
