// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/common/frameticker.h"

#include <QGuiApplication>
#include <QMetaMethod>
#include <QTimerEvent>
#include <QWindow>

#include <algorithm>
#include <vector>

namespace trex {

namespace {

constexpr qsizetype kMostDurations = 4096; ///< over two minutes of frames
constexpr int kUnseenTicks = 15; ///< of which one is told while nobody can see anything

double quantile(const QList<float>& durations, double part)
{
    if (durations.isEmpty()) {
        return 0.0;
    }
    std::vector<float> sorted(durations.begin(), durations.end());
    const auto index =
        static_cast<std::ptrdiff_t>(part * static_cast<double>(sorted.size() - 1) + 0.5);
    std::nth_element(sorted.begin(), sorted.begin() + index, sorted.end());
    return static_cast<double>(sorted.at(static_cast<std::size_t>(index)));
}

} // namespace

FrameTicker::FrameTicker(QObject* parent) : QObject(parent)
{
    m_timer.start(kIntervalMs, Qt::PreciseTimer, this);
}

void FrameTicker::framePainted(double milliseconds)
{
    ++m_frames;
    if (m_durations.size() >= kMostDurations) {
        m_durations.removeFirst();
    }
    m_durations.append(static_cast<float>(milliseconds));
}

double FrameTicker::medianMs() const
{
    return quantile(m_durations, 0.5);
}

double FrameTicker::percentile95Ms() const
{
    return quantile(m_durations, 0.95);
}

bool FrameTicker::isEverythingMinimised()
{
    bool isAnyVisible = false;
    const QWindowList windows = QGuiApplication::topLevelWindows();
    for (const QWindow* window : windows) {
        const bool isMinimised = window->windowStates().testFlag(Qt::WindowMinimized);
        if (window->isVisible() && window->isExposed() && !isMinimised) {
            return false;
        }
        isAnyVisible = isAnyVisible || window->isVisible();
    }
    return isAnyVisible;
}

void FrameTicker::timerEvent(QTimerEvent* event)
{
    if (event->timerId() != m_timer.timerId()) {
        return;
    }
    const bool isDue = !isEverythingMinimised() || m_untold + 1 >= kUnseenTicks;
    m_untold = isDue ? 0 : m_untold + 1;
    if (isDue && isSignalConnected(QMetaMethod::fromSignal(&FrameTicker::tick))) {
        emit tick();
    }
}

} // namespace trex
