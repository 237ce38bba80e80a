// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/common/indicator.h"

#include "widgets/common/stateshape.h"
#include "widgets/common/theme.h"

#include <QFontMetrics>
#include <QPainter>

namespace trex {

using namespace Qt::Literals::StringLiterals;

namespace {

constexpr int kGap = 8;
constexpr int kMostCountShown = 9999;

StateShape litShape(Indicator::Meaning meaning)
{
    switch (meaning) {
    case Indicator::Meaning::Ok:
        return StateShape::Ok;
    case Indicator::Meaning::Warning:
        return StateShape::Warning;
    case Indicator::Meaning::Fault:
        return StateShape::Fault;
    }
    return StateShape::Off;
}

int shapeSize(const QFontMetrics& metrics)
{
    return metrics.ascent();
}

QString countText(int count)
{
    return count > kMostCountShown ? u"> %L1"_s.arg(kMostCountShown) : u"× %L1"_s.arg(count);
}

} // namespace

Indicator::Indicator(const QString& label, Meaning meaning, QWidget* parent)
    : QWidget(parent), m_label(label), m_meaning(meaning)
{
    setAccessibleName(label);
    setAccessibleDescription(tr("not known"));
    setSizePolicy(QSizePolicy::Preferred, QSizePolicy::Fixed);
}

void Indicator::setState(bool active, int count, bool stale)
{
    if (active == m_active && count == m_count && stale == m_stale) {
        return;
    }
    m_active = active;
    m_count = count;
    m_stale = stale;
    const QString state = stale ? tr("not known") : active ? tr("lit") : tr("off");
    setAccessibleDescription(tr("%1, seen %n time(s)", nullptr, count).arg(state));
    update();
}

void Indicator::setDetail(const QString& detail)
{
    setToolTip(detail);
}

QSize Indicator::sizeHint() const
{
    const QFontMetrics metrics = fontMetrics();
    return {shapeSize(metrics) + 2 * kGap + metrics.horizontalAdvance(m_label)
                + metrics.horizontalAdvance(u"× 000"_s),
            metrics.height() + 4};
}

QSize Indicator::minimumSizeHint() const
{
    const QFontMetrics metrics = fontMetrics();
    return {shapeSize(metrics) + 2 * kGap + metrics.averageCharWidth() * 6
                + metrics.horizontalAdvance(u"× 000"_s),
            metrics.height() + 4};
}

void Indicator::paintEvent(QPaintEvent* /*event*/)
{
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    const QFontMetrics metrics = fontMetrics();
    const int size = shapeSize(metrics);
    const StateShape shape = m_stale ? StateShape::Stale
        : m_active                   ? litShape(m_meaning)
                                     : StateShape::Off;
    drawStateShape(painter, QRectF(0.5, (height() - size) / 2.0, size, size), shape);

    QRect rest = rect().adjusted(size + kGap, 0, 0, 0);
    if (m_count > 0) {
        const QString count = countText(m_count);
        painter.setPen(theme::colour(m_stale ? ColourRole::Stale : ColourRole::Text));
        painter.drawText(rest, Qt::AlignRight | Qt::AlignVCenter, count);
        rest.setRight(rest.right() - metrics.horizontalAdvance(count) - kGap);
    }
    const bool quiet = m_stale || !m_active;
    painter.setPen(theme::colour(m_stale     ? ColourRole::Stale
                                     : quiet ? ColourRole::DimText
                                             : ColourRole::Text));
    painter.drawText(rest, Qt::AlignLeft | Qt::AlignVCenter,
                     metrics.elidedText(m_label, Qt::ElideRight, rest.width()));
}

} // namespace trex
