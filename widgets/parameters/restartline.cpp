// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/parameters/restartline.h"

#include "widgets/common/panel.h"
#include "widgets/common/theme.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QLocale>
#include <QPushButton>

#include <utility>

using namespace Qt::Literals::StringLiterals;

namespace trex {

RestartLine::RestartLine(QWidget* parent)
    : QWidget(parent)
    , m_text(named(new QLabel(this), u"parameters.restarted"_s, tr("Restart of the controller")))
{
    m_text->setWordWrap(true);
    m_text->setTextFormat(Qt::PlainText);
    m_text->setTextInteractionFlags(Qt::TextSelectableByMouse);
    auto* const dismiss = named(new QPushButton(theme::icon(u"ok"_s), tr("Dis&miss"), this),
                                u"parameters.restarted.dismiss"_s);
    dismiss->setToolTip(tr("Takes this line away"));
    auto* const row = new QHBoxLayout(this);
    row->setContentsMargins(0, 0, 0, 0);
    row->setSpacing(8);
    row->addWidget(m_text, 1);
    row->addWidget(dismiss, 0, Qt::AlignTop);
    connect(dismiss, &QPushButton::clicked, this, &RestartLine::dismiss);
    hide();
}

void RestartLine::tell(Kind kind, const QTime& at, const QStringList& waited)
{
    // Seen once more, before all was read again, it is the same one.
    const bool isSame = std::exchange(m_isShown, true) && m_reading != Reading::Done;
    m_kind = kind;
    m_at = at;
    m_waited = isSame ? m_waited + waited : waited;
    m_waited.removeDuplicates();
    m_reading = Reading::Running;
    refresh();
}

void RestartLine::setReading(Reading reading)
{
    if (m_isShown && m_reading != reading) {
        m_reading = reading;
        refresh();
    }
}

void RestartLine::dismiss()
{
    m_isShown = false;
    hide();
}

void RestartLine::refresh()
{
    const QString time = QLocale().toString(m_at, u"HH:mm:ss"_s);
    const bool isSure = m_kind == Kind::Sure;
    QStringList sentences{
        isSure ? tr("The controller was restarted at %1.").arg(time)
               : tr("The controller was silent and answers again since %1: it may have been "
                    "restarted.")
                     .arg(time)};
    switch (m_reading) {
    case Reading::Running:
        sentences << tr("Everything is being read again.");
        break;
    case Reading::Done:
        sentences << tr("Everything was read again.");
        break;
    case Reading::Failed:
        sentences << tr("Not everything could be read again: press Reload.");
        break;
    }
    if (!m_waited.isEmpty()) {
        const QString titles = m_waited.join(u", "_s);
        sentences << (isSure ? tr("In force since then: %1.").arg(titles)
                             : tr("If it was, in force since then: %1.").arg(titles));
    }
    m_text->setText(u"▲ "_s + sentences.join(u' '));
    theme::setTextColour(*m_text, ColourRole::Warning);
    show();
}

} // namespace trex
