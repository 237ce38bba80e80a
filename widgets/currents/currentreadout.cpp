// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/currents/currentreadout.h"

#include "widgets/common/panel.h"

#include <QEvent>
#include <QGridLayout>
#include <QPainter>

namespace trex {

namespace {

constexpr int kDecimals = 2;
constexpr int kBarWidth = 4;

void setColour(QWidget* widget, ColourRole role)
{
    QPalette palette = widget->palette();
    // A label writes in one or the other, by the background that its panel gives it.
    palette.setColor(QPalette::WindowText, theme::colour(role));
    palette.setColor(QPalette::Text, theme::colour(role));
    widget->setPalette(palette);
}

} // namespace

QString ampereText(std::optional<double> amperes, bool isInferred)
{
    if (!amperes) {
        return QStringLiteral("–");
    }
    const QString text = QStringLiteral("%1 A").arg(*amperes, 0, 'f', kDecimals);
    return isInferred ? QStringLiteral("≈ ") + text : text;
}

CurrentValue::CurrentValue(QWidget* parent) : QLabel(ampereText({}, false), parent)
{
    setAlignment(Qt::AlignLeft | Qt::AlignVCenter);
}

QVariant CurrentValue::amperes() const
{
    return m_amperes ? QVariant(*m_amperes) : QVariant();
}

void CurrentValue::setAmperes(std::optional<double> amperes, bool isInferred, bool isStale)
{
    m_amperes = amperes;
    m_stale = isStale;
    setText(ampereText(amperes, isInferred));
    setToolTip(isInferred ? tr("The scale of a TReX, about 150 mA a count, is inferred.")
                          : QString());
    setColour(this, isStale ? ColourRole::Stale : ColourRole::Text);
}

CurrentReadOut::CurrentReadOut(const QString& title, ColourRole colour, const QString& valueName,
                               QWidget* parent)
    : QWidget(parent)
    , m_colour(colour)
    , m_titleText(title)
    , m_title(new QLabel(title, this))
    , m_value(named(new CurrentValue(this), valueName, tr("%1 current").arg(title)))
    , m_peak(new QLabel(this))
    , m_mean(new QLabel(this))
{
    auto* layout = new QGridLayout(this);
    layout->setContentsMargins(kBarWidth + 8, 2, 8, 2);
    layout->setHorizontalSpacing(16);
    layout->setVerticalSpacing(0);
    layout->addWidget(m_title, 0, 0, 1, 2);
    layout->addWidget(m_value, 1, 0, 2, 1);
    layout->addWidget(m_peak, 1, 1, Qt::AlignBottom);
    layout->addWidget(m_mean, 2, 1, Qt::AlignTop);
    layout->setColumnStretch(1, 1);
    applyTheme();
    show({});
}

void CurrentReadOut::applyTheme()
{
    m_value->setFont(theme::font(2.0, true));
    // As wide as any figure gets, so that nothing beside it moves.
    m_value->setMinimumWidth(m_value->fontMetrics().horizontalAdvance(QStringLiteral("10.20 A")));
    for (QLabel* label : {m_peak, m_mean}) {
        label->setFont(theme::font(1.0, true));
        setColour(label, ColourRole::DimText);
    }
    setColour(m_title, ColourRole::DimText);
    setColour(m_value, m_value->isStale() ? ColourRole::Stale : ColourRole::Text);
    update();
}

void CurrentReadOut::show(const Figures& figures)
{
    m_value->setAmperes(figures.present, figures.isInferred, figures.isStale);
    m_peak->setText(tr("peak %1").arg(ampereText(figures.peak, figures.isInferred)));
    m_mean->setText(tr("mean %1").arg(ampereText(figures.mean, figures.isInferred)));
    m_title->setText(figures.note.isEmpty()
                         ? m_titleText
                         : QStringLiteral("%1 · %2").arg(m_titleText, figures.note));
}

void CurrentReadOut::changeEvent(QEvent* event)
{
    QWidget::changeEvent(event);
    if (event->type() == QEvent::PaletteChange) {
        applyTheme();
    }
}

void CurrentReadOut::paintEvent(QPaintEvent*)
{
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setPen(Qt::NoPen);
    painter.setBrush(theme::colour(m_colour));
    painter.drawRoundedRect(QRectF(0, 4, kBarWidth, height() - 8), kBarWidth / 2.0,
                            kBarWidth / 2.0);
}

} // namespace trex
