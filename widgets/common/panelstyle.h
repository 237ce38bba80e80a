// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QProxyStyle>

namespace trex {

/// Fusion, with check boxes that can be seen on a dark panel. GUI thread.
class PanelStyle : public QProxyStyle {
    Q_OBJECT
    Q_DISABLE_COPY_MOVE(PanelStyle)

public:
    PanelStyle();
    void drawPrimitive(PrimitiveElement element, const QStyleOption* option, QPainter* painter,
                       const QWidget* widget) const override;
};

} // namespace trex
