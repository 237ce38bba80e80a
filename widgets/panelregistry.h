// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/common/panel.h"

#include <span>
#include <string_view>

namespace trex {

/// One panel of the main window: dock, menu entry, picture of the demonstration and tests loop over
/// the rows.
struct PanelRow {
    std::string_view id; ///< object name of the panel and file name of its picture
    const char* title; ///< QT_TRANSLATE_NOOP("Panels", …)
    std::string_view icon;
    Qt::DockWidgetArea area;
    int order; ///< within the area; equal orders are tabbed together
    Panel* (*make)(PanelContext& context, QWidget* parent);
    bool inRecordings = false; ///< has something to show without a controller: of a recording
};

[[nodiscard]] std::span<const PanelRow> panels();

} // namespace trex
