// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/plots/toolrow.h"

#include <QLayout>
#include <QResizeEvent>
#include <QToolButton>

namespace trex {
namespace {

constexpr char kHasText[] = "text-beside"; ///< property of the buttons that have shown a text

} // namespace

/// What the texts of the buttons take, shown or not.
int ToolRow::widthOfTexts() const
{
    int width = 0;
    for (const auto* button : findChildren<QToolButton*>(Qt::FindDirectChildrenOnly)) {
        if (button->toolButtonStyle() == Qt::ToolButtonTextBesideIcon
            || button->property(kHasText).toBool()) {
            width += button->fontMetrics().horizontalAdvance(button->text() + u' ');
        }
    }
    return width;
}

QSize ToolRow::minimumSizeHint() const
{
    const QSize now = QWidget::minimumSizeHint();
    return m_isShort ? now : QSize(now.width() - widthOfTexts(), now.height());
}

void ToolRow::resizeEvent(QResizeEvent* event)
{
    QWidget::resizeEvent(event);
    const int now = layout()->minimumSize().width();
    const int full = m_isShort ? now + widthOfTexts() : now;
    // Some room to spare before they come back: what they take is not known to the pixel.
    constexpr int kSpare = 24;
    const bool isShort = event->size().width() < full + (m_isShort ? kSpare : 0);
    if (isShort == m_isShort) {
        return;
    }
    m_isShort = isShort;
    for (auto* button : findChildren<QToolButton*>(Qt::FindDirectChildrenOnly)) {
        if (isShort && button->toolButtonStyle() == Qt::ToolButtonTextBesideIcon) {
            button->setProperty(kHasText, true);
            button->setToolButtonStyle(Qt::ToolButtonIconOnly);
        } else if (!isShort && button->property(kHasText).toBool()) {
            button->setProperty(kHasText, false);
            button->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
        }
    }
}

} // namespace trex
