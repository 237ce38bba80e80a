// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/common/plotview.h"

namespace trex {

class DeviceSettings;

/// The current limits of both motors as lines for a plot of currents, as far as they were read and
/// are set at all.
[[nodiscard]] std::vector<PlotView::Limit> currentLimits(const DeviceSettings& settings);

} // namespace trex
