// SPDX-License-Identifier: GPL-3.0-or-later
// What the wizard says on each page, made from the state of the calibration. GUI thread.
#pragma once

#include "protocol/procedures/channelcalibration.h"
#include "widgets/common/stateshape.h"

#include <QStringList>

namespace trex::calibrationpages {

/// The steps as a person counts them, and which one is on (−1: none).
[[nodiscard]] QStringList stepTitles();
[[nodiscard]] int stepIndex(const ChannelCalibration& calibration);

[[nodiscard]] QString instruction(const ChannelCalibration& calibration);
[[nodiscard]] QString nextText(const ChannelCalibration& calibration);

struct Notice {
    StateShape shape = StateShape::Ok;
    QString text; ///< empty: nothing to say
};
[[nodiscard]] Notice notice(const ChannelCalibration& calibration);

/// One channel's state: a word with its shape, and what is still needed.
struct ChannelState {
    StateShape shape = StateShape::Off;
    QString word;
    QString detail;
    QString figures; ///< tool tip
};
[[nodiscard]] ChannelState channelState(const ChannelCalibration& calibration, int channel);

} // namespace trex::calibrationpages
