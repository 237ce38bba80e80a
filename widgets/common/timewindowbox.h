// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/common/uisettings.h"

#include <QComboBox>

namespace trex {

class PlotTimeline;

/// How much time a plot shows: choices for following the newest sample, kept in the settings. While
/// the plot stands at another length (zoomed, fitted), no choice is marked and that length is told.
class TimeWindowBox : public QComboBox {
    Q_OBJECT

public:
    /// Sets the timeline to the length that is kept under `setting`. All must live on.
    TimeWindowBox(PlotTimeline& timeline, UiSettings& settings, const Setting<int>& setting,
                  QWidget* parent = nullptr);

    /// "2.5 s", "1:02:30": a length of time for people.
    [[nodiscard]] static QString lengthText(double seconds);

private:
    void choose();
    void showView();

    PlotTimeline& m_timeline;
    UiSettings& m_settings;
    Setting<int> m_setting;
};

} // namespace trex
