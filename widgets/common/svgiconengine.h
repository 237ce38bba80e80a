// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/common/theme.h"

#include <QIconEngine>

namespace trex {

/// Draws an icon file in the colour that a role has at that moment, at the pixels that the screen
/// needs: icons follow a change of theme by themselves. GUI thread.
class SvgIconEngine : public QIconEngine {
public:
    SvgIconEngine(QString file, ColourRole role);

    void paint(QPainter* painter, const QRect& rect, QIcon::Mode mode, QIcon::State state) override;
    QPixmap pixmap(const QSize& size, QIcon::Mode mode, QIcon::State state) override;
    QIconEngine* clone() const override;
    QString key() const override;
    bool isNull() override { return false; }

private:
    QString m_file;
    ColourRole m_role;
};

} // namespace trex
