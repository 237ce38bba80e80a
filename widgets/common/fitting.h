// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QSize>

class QWidget;

namespace trex {

/// Gives a window this size, or as much of it as its screen has.
void resizeToFit(QWidget& window, const QSize& wanted);

} // namespace trex
