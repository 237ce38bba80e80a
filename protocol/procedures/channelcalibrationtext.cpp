// SPDX-License-Identifier: GPL-3.0-or-later
#include "protocol/procedures/calibrationtext.h"
#include "protocol/procedures/channelcalibration.h"

namespace trex {
QLatin1StringView ChannelCalibration::stepKey() const
{
    static constexpr std::array<QLatin1StringView, 10> kKeys{
        QLatin1StringView("choose"),   QLatin1StringView("neutral"),   QLatin1StringView("returns"),
        QLatin1StringView("extremes"), QLatin1StringView("direction"), QLatin1StringView("verify"),
        QLatin1StringView("review"),   QLatin1StringView("writing"),   QLatin1StringView("done"),
        QLatin1StringView("stopped")};
    return kKeys.at(static_cast<std::size_t>(m_step));
}

QString ChannelCalibration::sticksDriveText()
{
    return tr("In RC and analog mode the sticks move the motors: switch the motors' power off and "
              "tick that it is off, or put the controller into serial mode.");
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
        if (doSticksDrive() && !m_isMotorPowerOff) {
            return tr("Say first that the motor power is off.");
        }
        return m_channels == 0 ? tr("Choose at least one channel.") : QString();
    case Step::Neutral:
        return neutralReason();
    case Step::Extremes:
        return extremesReason();
    case Step::Review:
        return reviewReason();
    case Step::Writing:
        return m_writer.isStopping() ? tr("Stopping behind this channel…") : tr("Writing…");
    case Step::Done:
    case Step::Stopped:
        return endReason();
    case Step::Returns:
    case Step::Direction:
    case Step::Verify:
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
    std::uint8_t vague = 0;
    for (int channel = 1; channel <= kChannelCount; ++channel) {
        const auto& learner = m_learner->channel(channel);
        if (!isChosen(channel) || learner.areEndsSettled()) {
            continue;
        }
        const auto bit = static_cast<std::uint8_t>(1U << (channel - 1));
        const bool isReached = learner.lowNeeded() == 0 && learner.highNeeded() == 0;
        learner.areEndsVague() ? vague |= bit : isReached ? settling |= bit : waiting |= bit;
    }
    if (waiting != 0) {
        return tr("Channels still to be moved to both ends: %1.").arg(channelListText(waiting));
    }
    if (vague != 0) {
        return tr("Channels to be held at each end for longer: %1.").arg(channelListText(vague));
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

QString ChannelCalibration::endReason() const
{
    if (m_isUndoing) {
        return tr("Putting the former values back…");
    }
    if (m_writer.isBusy()) {
        return tr("Reading back what the controller holds…");
    }
    const bool isThere = m_controller.state() == LinkState::Connected && m_controller.device().mode;
    return m_writer.needsCheck() && !isThere
        ? tr("When the controller is there again, what it holds is read back.")
        : QString();
}

} // namespace trex
