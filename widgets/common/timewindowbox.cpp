// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/common/timewindowbox.h"

#include "widgets/common/plotticks.h"
#include "widgets/common/plottimeline.h"

#include <QSignalBlocker>

#include <cmath>

namespace trex {
namespace {

struct WindowRow {
    int seconds;
    const char* title;
};
constexpr std::array kWindows{
    WindowRow{10, QT_TRANSLATE_NOOP("trex::TimeWindowBox", "10 s")},
    WindowRow{30, QT_TRANSLATE_NOOP("trex::TimeWindowBox", "30 s")},
    WindowRow{60, QT_TRANSLATE_NOOP("trex::TimeWindowBox", "1 min")},
    WindowRow{300, QT_TRANSLATE_NOOP("trex::TimeWindowBox", "5 min")},
    WindowRow{1800, QT_TRANSLATE_NOOP("trex::TimeWindowBox", "30 min")},
    WindowRow{3600, QT_TRANSLATE_NOOP("trex::TimeWindowBox", "1 h")},
    WindowRow{PlotTimeline::kWholeSession,
              QT_TRANSLATE_NOOP("trex::TimeWindowBox", "whole session")},
};
constexpr int kNone = -1;

} // namespace

TimeWindowBox::TimeWindowBox(PlotTimeline& timeline, UiSettings& settings,
                             const Setting<int>& setting, QWidget* parent)
    : QComboBox(parent), m_timeline(timeline), m_settings(settings), m_setting(setting)
{
    for (const WindowRow& window : kWindows) {
        addItem(tr(window.title), window.seconds);
    }
    setCurrentIndex(std::max(findData(settings.value(setting)), 0));
    m_timeline.setWindowSeconds(currentData().toInt());
    connect(this, &QComboBox::currentIndexChanged, this, [this](int index) {
        if (index != kNone) {
            choose();
        }
    });
    connect(&m_timeline, &PlotTimeline::viewChanged, this, &TimeWindowBox::showView);
}

void TimeWindowBox::choose()
{
    const int seconds = currentData().toInt();
    m_settings.set(m_setting, seconds);
    m_timeline.setWindowSeconds(seconds);
}

void TimeWindowBox::showView()
{
    const int seconds = m_timeline.windowSeconds();
    const QSignalBlocker quiet(this);
    if (!m_timeline.isPaused() || m_timeline.span() == std::chrono::seconds(seconds)) {
        setCurrentIndex(findData(seconds));
        setAccessibleDescription({});
        return;
    }
    // Without a choice each of them, the former one too, leads back to its own length.
    const QString length = lengthText(std::chrono::duration<double>(m_timeline.span()).count());
    setPlaceholderText(length);
    setAccessibleDescription(length);
    setCurrentIndex(kNone);
    update(); // another placeholder alone repaints nothing
}

QString TimeWindowBox::lengthText(double seconds)
{
    constexpr double kMinute = 60.0;
    if (seconds < 1.0) {
        return tr("%1 ms").arg(std::lround(seconds * 1000.0));
    }
    if (seconds < kMinute) {
        return tr("%1 s").arg(seconds, 0, 'g', 3);
    }
    return ticks::timeLabel(seconds, 1.0);
}

} // namespace trex
