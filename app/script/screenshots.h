// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/script/scriptactions.h"

class QWidget;

namespace trex {

/// Brings the widget forward, lets it paint, and writes its picture.
[[nodiscard]] StepResult screenshot(StepContext& context, QWidget& widget, const QString& file);

/// One picture of each panel of the registry, ID.png.
[[nodiscard]] StepResult screenshotEveryPanel(StepContext& context);

} // namespace trex
