// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/connection/linkstatelabel.h"

#include "widgets/common/stateshape.h"

#include <QEvent>
#include <QPainter>

namespace trex {

namespace {

constexpr int kGap = 8;

StateShape shapeOf(LinkState state)
{
    switch (state) {
    case LinkState::Disconnected:
        return StateShape::Off;
    case LinkState::Connecting:
        return StateShape::Stale;
    case LinkState::Connected:
        return StateShape::Ok;
    case LinkState::Lost:
        return StateShape::Fault;
    case LinkState::Retrying:
        return StateShape::Warning;
    }
    return StateShape::Off;
}

} // namespace

LinkStateLabel::LinkStateLabel(QWidget* parent) : QLabel(parent)
{
    setWordWrap(true);
    setTextFormat(Qt::PlainText);
    setTextInteractionFlags(Qt::TextSelectableByMouse | Qt::TextSelectableByKeyboard);
    makeRoom();
}

void LinkStateLabel::setLink(LinkState state, const QString& text)
{
    m_state = state;
    setText(text);
    update();
}

void LinkStateLabel::makeRoom()
{
    setContentsMargins(fontMetrics().ascent() + kGap, 0, 0, 0);
}

void LinkStateLabel::changeEvent(QEvent* event)
{
    QLabel::changeEvent(event);
    if (event->type() == QEvent::FontChange) {
        makeRoom();
    }
}

void LinkStateLabel::paintEvent(QPaintEvent* event)
{
    QLabel::paintEvent(event);
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    const QFontMetrics metrics = fontMetrics();
    const int size = metrics.ascent();
    // Beside the first line, where the text is when it is one line.
    const bool isOneLine = heightForWidth(width()) < 2 * metrics.lineSpacing();
    const double top = isOneLine ? (height() - size) / 2.0 : (metrics.height() - size) / 2.0;
    drawStateShape(painter, QRectF(0.5, top, size - 1, size - 1), shapeOf(m_state));
}

} // namespace trex
