// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/common/fitting.h"

#include <QScreen>
#include <QWidget>

namespace trex {

void resizeToFit(QWidget& window, const QSize& wanted)
{
    window.resize(wanted.boundedTo(window.screen()->availableSize()));
}

} // namespace trex
