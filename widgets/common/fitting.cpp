// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/common/fitting.h"

#include <QGuiApplication>
#include <QScreen>
#include <QWidget>

namespace trex {

bool hasScreen()
{
    return QGuiApplication::platformName() != QLatin1StringView("offscreen")
        || qgetenv("QT_QPA_PLATFORM").startsWith("offscreen:");
}

void resizeToFit(QWidget& window, const QSize& wanted)
{
    window.resize(hasScreen() ? wanted.boundedTo(window.screen()->availableSize()) : wanted);
}

} // namespace trex
