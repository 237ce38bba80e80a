// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/trexpanel/docktitle.h"

#include "widgets/common/panel.h"
#include "widgets/common/theme.h"

#include <QDockWidget>
#include <QHBoxLayout>
#include <QLabel>
#include <QMainWindow>
#include <QToolButton>

namespace trex {

using namespace Qt::Literals::StringLiterals;

DockTitle::DockTitle(QDockWidget& dock)
    : QWidget(&dock)
    , m_dock(dock)
    , m_row(new QWidget(this))
    , m_text(new QLabel(dock.windowTitle(), m_row))
{
    setAutoFillBackground(true);
    setBackgroundRole(QPalette::Base);
    QFont font = theme::font(1.25);
    font.setWeight(QFont::DemiBold);
    m_text->setFont(font);

    auto* outer = new QVBoxLayout(this);
    outer->setContentsMargins(0, 0, 0, 0);
    outer->addWidget(m_row);
    auto* row = new QHBoxLayout(m_row);
    row->setContentsMargins(8, 4, 4, 0);
    row->setSpacing(0);
    row->addWidget(m_text, 1);
    const auto addButton = [&](const QString& icon, const QString& text, const QString& part) {
        auto* button = named(new QToolButton(m_row), dock.objectName() + part, text);
        button->setIcon(theme::icon(icon, ColourRole::DimText));
        button->setIconSize({14, 14});
        button->setAutoRaise(true);
        button->setToolTip(text);
        button->setFocusPolicy(Qt::TabFocus);
        row->addWidget(button);
        return button;
    };
    auto* tearOff =
        addButton(u"window"_s, tr("Tear off or put back: %1").arg(dock.windowTitle()), u".float"_s);
    auto* close = addButton(u"cancel"_s, tr("Close: %1").arg(dock.windowTitle()), u".close"_s);
    connect(tearOff, &QToolButton::clicked, &dock,
            [&dock] { dock.setFloating(!dock.isFloating()); });
    connect(close, &QToolButton::clicked, &dock, &QDockWidget::close);
    refresh();
}

void DockTitle::refresh()
{
    const auto* window = qobject_cast<const QMainWindow*>(m_dock.parentWidget());
    m_isTabbed = window != nullptr && !m_dock.isFloating()
        && !window->tabifiedDockWidgets(&m_dock).isEmpty();
    m_row->setVisible(!m_isTabbed);
    updateGeometry();
}

QSize DockTitle::sizeHint() const
{
    return m_isTabbed ? QSize(0, 0) : m_row->sizeHint();
}

QSize DockTitle::minimumSizeHint() const
{
    return m_isTabbed ? QSize(0, 0) : m_row->minimumSizeHint();
}

} // namespace trex
