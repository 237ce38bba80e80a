// SPDX-License-Identifier: GPL-3.0-or-later
#include "protocol/procedures/calibrationtext.h"
#include "protocol/procedures/channelcalibration.h"

namespace trex {

QLatin1StringView ChannelCalibration::stepKey() const
{
    static constexpr std::array<QLatin1StringView, 7> kKeys{
        QLatin1StringView("choose"), QLatin1StringView("neutral"), QLatin1StringView("extremes"),
        QLatin1StringView("review"), QLatin1StringView("writing"), QLatin1StringView("done"),
        QLatin1StringView("stopped")};
    return kKeys.at(static_cast<std::size_t>(m_step));
}

QString ChannelCalibration::whyNot() const
{
    switch (m_step) {
    case Step::Choose:
        if (m_controller.state() != LinkState::Connected) {
            return tr("Connect to a controller first.");
        }
        if (m_isPreparing) {
            return tr("Reading the present calibrations…");
        }
        return m_channels == 0 ? tr("Choose at least one channel.") : QString();
    case Step::Neutral:
        return neutralReason();
    case Step::Extremes:
        return extremesReason();
    case Step::Review:
        return reviewReason();
    case Step::Writing:
        return m_isCancelAsked ? tr("Stopping behind this channel…") : tr("Writing…");
    case Step::Done:
    case Step::Stopped:
        break;
    }
    return {};
}

QString ChannelCalibration::neutralReason() const
{
    if (isStarved()) {
        return tr("No fresh readings come from the controller.");
    }
    for (int channel = 1; channel <= kChannelCount; ++channel) {
        const auto& learner = m_learner->channel(channel);
        if (isChosen(channel) && !learner.isValid()) {
            return tr("Channel %1 gives no valid reading. Connect it, or go back and leave it out.")
                .arg(channel);
        }
    }
    if (m_learner->isNeutralDone()) {
        return {};
    }
    const double seconds = std::chrono::duration<double>(m_learner->neutralRemaining()).count();
    return seconds > 0.0 ? tr("Hold still for %1 s more.").arg(seconds, 0, 'f', 1)
                         : tr("Something still drifts: hold still.");
}

QString ChannelCalibration::extremesReason() const
{
    if (isStarved()) {
        return tr("No fresh readings come from the controller.");
    }
    std::uint8_t waiting = 0;
    std::uint8_t settling = 0;
    for (int channel = 1; channel <= kChannelCount; ++channel) {
        const auto& learner = m_learner->channel(channel);
        if (!isChosen(channel) || learner.areEndsSettled()) {
            continue;
        }
        const auto bit = static_cast<std::uint8_t>(1U << (channel - 1));
        const bool isReached = learner.lowNeeded() == 0 && learner.highNeeded() == 0;
        isReached ? settling |= bit : waiting |= bit;
    }
    if (waiting != 0) {
        return tr("Channels still to be moved to both ends: %1.").arg(channelListText(waiting));
    }
    return settling != 0 ? tr("Waiting until no end moves further…") : QString();
}

QString ChannelCalibration::reviewReason() const
{
    if (!canWrite()) {
        return tr("Settings can be written in serial mode only: the controller would refuse. "
                  "Switch its power off, take the mode jumper off, switch it on and calibrate "
                  "again.");
    }
    if (m_channels == 0) {
        return acceptable() == 0 ? tr("No channel was learned well enough to be written.")
                                 : tr("Choose at least one channel to write.");
    }
    return {};
}

std::uint8_t ChannelCalibration::maskOf(WriteState state) const
{
    std::uint8_t mask = 0;
    for (int channel = 1; channel <= kChannelCount; ++channel) {
        if (at(channel).state == state) {
            mask |= static_cast<std::uint8_t>(1U << (channel - 1));
        }
    }
    return mask;
}

/// What is in the controller now, as sentences. No error: everything was written.
QString ChannelCalibration::writtenText(const Error& error) const
{
    const auto written = maskOf(WriteState::Written);
    const auto nearest = maskOf(WriteState::NearestWritten);
    const auto unchanged = maskOf(WriteState::Unchanged);
    const auto failed = maskOf(WriteState::Failed);
    QStringList sentences;
    if ((written | nearest | failed) == 0) {
        return unchanged != 0 && m_step == Step::Writing
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
    if (failed != 0) {
        const bool isRefused = error.code == ErrorCode::BadValue
            || error.code == ErrorCode::NotInSerialMode || error.code == ErrorCode::OutOfRange;
        sentences << (isRefused
                          ? tr("Channel %1 was refused and keeps its old values.")
                          : tr("Channel %1 may hold its old or its new values: read it again."))
                         .arg(channelListText(failed));
    }
    if (failed != 0 || m_isCancelAsked) {
        sentences << tr("All other channels are as before.");
    }
    return sentences.join(u' ');
}

} // namespace trex
