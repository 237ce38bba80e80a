// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QSize>

class QWidget;

namespace trex {

/// False on the offscreen platform's screen, which is none that a window would have to fit, unless
/// it was given (QT_QPA_PLATFORM=offscreen:configfile=FILE).
[[nodiscard]] bool hasScreen();

/// Gives a window this size, or as much of it as its screen has.
void resizeToFit(QWidget& window, const QSize& wanted);

} // namespace trex
