// SPDX-License-Identifier: GPL-3.0-or-later
// What the wizard says on each page, made from the state of the calibration. GUI thread.
#pragma once

#include "protocol/procedures/channelcalibration.h"
#include "widgets/common/stateshape.h"

#include <QCoreApplication>
#include <QStringList>

namespace trex::calibrationpages {

/// The words of the wizard, for tr().
struct Texts {
    Q_DECLARE_TR_FUNCTIONS(Calibration)
};

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
/// `raw`: the fresh reading, if there is one.
[[nodiscard]] ChannelState channelState(const ChannelCalibration& calibration, int channel,
                                        std::optional<int> raw);
/// How sure one may be of a learned channel, figure by figure; empty before it is learned.
[[nodiscard]] QString confidence(const ChannelCalibration& calibration, int channel);

/// A remapped value with its sign: "+64", "−127", "0".
[[nodiscard]] QString remappedText(int remapped);

} // namespace trex::calibrationpages
