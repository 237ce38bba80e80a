// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/connection/linechangebox.h"

#include "widgets/common/panel.h"
#include "widgets/common/theme.h"

#include <QGridLayout>
#include <QLabel>
#include <QPushButton>
#include <QScrollArea>

#include <utility>

namespace trex {

using namespace Qt::Literals::StringLiterals;

LineChangeBox::LineChangeBox(LineChange& change, Panel& panel, QWidget* parent)
    : QWidget(parent)
    , m_change(change)
    , m_panel(panel)
    , m_text(named(new QLabel(this), u"connection.lineChange.text"_s,
                   tr("Change of the line settings")))
    , m_reconnect(named(new QPushButton(theme::icon(u"connect"_s), tr("Reconnect &now"), this),
                        u"connection.lineChange.reconnect"_s))
    , m_recover(named(new QPushButton(theme::icon(u"search"_s), tr("Search no&w"), this),
                      u"connection.lineChange.recover"_s))
    , m_cancel(named(new QPushButton(theme::icon(u"cancel"_s), tr("Canc&el"), this),
                     u"connection.lineChange.cancel"_s))
{
    setObjectName(u"connection.lineChange"_s);
    m_text->setWordWrap(true);
    m_text->setTextFormat(Qt::PlainText);
    m_text->setTextInteractionFlags(Qt::TextSelectableByMouse | Qt::TextSelectableByKeyboard);
    m_reconnect->setToolTip(tr("Looks for the controller at once, with its new line settings and "
                               "its old ones."));
    m_recover->setToolTip(tr("Tries every baud rate and error detection on this port."));
    m_cancel->setToolTip(tr("Waits no longer. What is stored in the controller stays."));
    auto* grid = new QGridLayout(this);
    grid->setContentsMargins(0, 0, 0, 0);
    grid->setSpacing(8);
    grid->addWidget(m_text, 0, 0, 1, 2);
    grid->addWidget(m_reconnect, 1, 0);
    grid->addWidget(m_recover, 1, 1);
    grid->addWidget(m_cancel, 2, 0);
    grid->setColumnStretch(0, 1);
    grid->setColumnStretch(1, 1);
    for (QPushButton* button : {m_reconnect, m_recover, m_cancel}) {
        button->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
    }
    connect(&change, &LineChange::changed, this, &LineChangeBox::refresh);
    connect(m_reconnect, &QPushButton::clicked, &change, &LineChange::reconnectNow);
    connect(m_recover, &QPushButton::clicked, &change, &LineChange::recoverNow);
    connect(m_cancel, &QPushButton::clicked, &change, &LineChange::cancel);
    refresh();
}

QString LineChangeBox::phase() const
{
    switch (m_change.phase()) {
    case LineChange::Phase::None:
        break;
    case LineChange::Phase::Waiting:
        return u"waiting"_s;
    case LineChange::Phase::Reconnecting:
        return u"reconnecting"_s;
    case LineChange::Phase::Recovering:
        return u"recovering"_s;
    }
    return u"none"_s;
}

void LineChangeBox::refresh()
{
    const LineChange::Phase phase = m_change.phase();
    const bool isWaiting = phase == LineChange::Phase::Waiting;
    m_text->setText(m_change.text());
    m_reconnect->setVisible(isWaiting);
    m_recover->setVisible(isWaiting || phase == LineChange::Phase::Reconnecting);
    m_cancel->setVisible(phase != LineChange::Phase::None);
    setVisible(!m_change.text().isEmpty());
    if (std::exchange(m_shown, phase) != phase && !m_change.text().isEmpty()) {
        bringForward();
    }
}

/// What is said here asks for something to be done, or is its end: it must not stay behind another
/// panel's tab, or below the edge.
void LineChangeBox::bringForward()
{
    emit m_panel.panelRequested(u"connection"_s);
    QMetaObject::invokeMethod(
        this,
        [this] {
            for (QWidget* each = parentWidget(); each != nullptr; each = each->parentWidget()) {
                if (auto* const area = qobject_cast<QScrollArea*>(each)) {
                    area->ensureWidgetVisible(this);
                    return;
                }
            }
        },
        Qt::QueuedConnection); // when it has its place
}

} // namespace trex
