// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/plots/plotpane.h"

#include "widgets/common/panel.h"
#include "widgets/common/plotframe.h"
#include "widgets/plots/curvechip.h"

#include <QHBoxLayout>
#include <QPainter>
#include <QSignalBlocker>
#include <QToolButton>
#include <QVBoxLayout>

#include <algorithm>

namespace trex {

using namespace Qt::Literals::StringLiterals;

namespace {

constexpr double kSmallestAmperes = 0.9; ///< the axis ends at 1 A when little is drawn
constexpr double kSmallestPlain = 10.0;
constexpr auto kFreshFor = std::chrono::seconds(2); ///< the slowest stream comes once a second

const StreamRow& rowOf(const QString& key)
{
    return streams()[static_cast<std::size_t>(streamIndex(key.toStdString()))];
}

} // namespace

PlotPane::PlotPane(PanelContext& context, PlotTimeline& timeline, QWidget* parent)
    : QWidget(parent)
    , m_context(context)
    , m_plot(new PlotView(context.store, context.ticker, this, &timeline))
    , m_head(new QHBoxLayout)
    , m_menu(new QToolButton(this))
    , m_amperesPerCount(amperesPerCount(Model::TrexJr))
{
    setMinimumHeight(96);
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 2, 0, 0);
    layout->setSpacing(0);
    layout->addLayout(m_head);
    layout->addWidget(m_plot, 1);
    m_head->setContentsMargins(4, 0, 4, 0);
    m_head->setSpacing(2);
    m_head->addStretch(1);
    m_menu->setIcon(theme::icon(u"settings"_s));
    m_menu->setAutoRaise(true);
    m_menu->setIconSize({14, 14});
    m_menu->setFocusPolicy(Qt::TabFocus);
    m_menu->setToolTip(tr("Add curves, move or remove this plot"));
    m_head->addWidget(m_menu);
    connect(m_menu, &QToolButton::clicked, this,
            [this] { emit paneMenuRequested(m_menu->mapToGlobal(m_menu->rect().bottomLeft())); });
    m_plot->setLegendShown(false);
    refit();
}

PlotPane::~PlotPane() = default;

void PlotPane::setNumber(int number, int count)
{
    const QString name = tr("Plot %1 of %2").arg(number).arg(count);
    named(this, u"plots.plot%1"_s.arg(number), name);
    named(m_plot, u"plots.plot%1.view"_s.arg(number), name);
    named(m_menu, u"plots.plot%1.menu"_s.arg(number), tr("Plot %1: menu").arg(number));
    for (CurveChip* chip : m_chips) {
        chip->setObjectName(u"plots.plot%1.%2"_s.arg(number).arg(chip->curve().key));
    }
}

int PlotPane::indexOf(const QString& key) const
{
    const auto found = std::find_if(m_curves.begin(), m_curves.end(),
                                    [&key](const CurveSpec& curve) { return curve.key == key; });
    return found == m_curves.end() ? -1 : static_cast<int>(found - m_curves.begin());
}

bool PlotPane::has(const QString& key) const
{
    return indexOf(key) >= 0;
}

void PlotPane::addCurve(const CurveSpec& curve)
{
    if (has(curve.key)) {
        return;
    }
    const int index = m_plot->addCurve(rowOf(curve.key).key, curve.colour);
    m_plot->setCurveWidth(index, curve.width);
    m_plot->setCurveVisible(index, curve.isVisible);
    m_curves.push_back(curve);
    addChip(curve);
    setAmperesPerCount(m_amperesPerCount);
    refit();
    emit changed();
}

void PlotPane::addChip(const CurveSpec& curve)
{
    auto* chip = new CurveChip(this);
    chip->setCurve(curve);
    chip->setObjectName(objectName() + u'.' + curve.key);
    m_head->insertWidget(static_cast<int>(m_chips.size()), chip);
    m_chips.push_back(chip);
    const QString key = curve.key;
    connect(chip, &CurveChip::clicked, this, [this, key](bool isShown) {
        CurveSpec shown = m_curves.at(static_cast<std::size_t>(indexOf(key)));
        shown.isVisible = isShown;
        changeCurve(shown);
    });
    connect(chip, &CurveChip::menuRequested, this,
            [this, key](const QPoint& at) { emit menuRequested(key, at); });
    connect(chip, &CurveChip::removalRequested, this, [this, key] { emit removalRequested(key); });
    connect(chip, &CurveChip::draggedTo, this, &PlotPane::curveDraggedTo);
    connect(chip, &CurveChip::droppedAt, this,
            [this, key](const QPoint& at) { emit curveDroppedAt(key, at); });
}

std::optional<CurveSpec> PlotPane::takeCurve(const QString& key)
{
    const int index = indexOf(key);
    if (index < 0) {
        return std::nullopt;
    }
    const CurveSpec taken = m_curves.at(static_cast<std::size_t>(index));
    m_plot->removeCurve(index);
    m_curves.erase(m_curves.begin() + index);
    m_chips.at(static_cast<std::size_t>(index))->hide();
    m_chips.at(static_cast<std::size_t>(index))->deleteLater(); // it may be what asked
    m_chips.erase(m_chips.begin() + index);
    refit();
    emit changed();
    return taken;
}

void PlotPane::changeCurve(const CurveSpec& curve)
{
    const int index = indexOf(curve.key);
    if (index < 0) {
        return;
    }
    m_curves.at(static_cast<std::size_t>(index)) = curve;
    m_plot->setCurveColour(index, curve.colour);
    m_plot->setCurveWidth(index, curve.width);
    m_plot->setCurveVisible(index, curve.isVisible);
    m_chips.at(static_cast<std::size_t>(index))->setCurve(curve);
    refit();
    emit changed();
}

/// A plot of currents begins at zero; others where their values do. The axis has a unit when all
/// curves in it share one.
void PlotPane::refit()
{
    std::optional<QString> unit;
    bool isMixed = false;
    bool isFromZero = true;
    for (const CurveSpec& curve : m_curves) {
        const StreamRow& row = rowOf(curve.key);
        if (!curve.isVisible) {
            continue;
        }
        isMixed |= unit && *unit != unitOf(row);
        unit = unitOf(row);
        isFromZero &= !row.unit.empty();
    }
    const bool areCurrents = unit == u"A"_s && !isMixed;
    using Foot = ticks::AxisRange::Foot;
    m_plot->setUnit(isMixed ? QString() : unit.value_or(QString()));
    m_plot->setFoot(isFromZero ? Foot::Zero : Foot::Free,
                    areCurrents ? kSmallestAmperes : kSmallestPlain);
    m_plot->setMessage(m_curves.empty()
                           ? tr("No curves. Drag one in here, or add one from the menu.")
                           : QString());
    applyLimits();
}

void PlotPane::setAmperesPerCount(double amperes)
{
    m_amperesPerCount = amperes;
    for (std::size_t i = 0; i < m_curves.size(); ++i) {
        if (rowOf(m_curves[i].key).source == Source(PollId::Currents)) {
            m_plot->setCurveScale(static_cast<int>(i), amperes);
        }
    }
}

void PlotPane::setLimits(const std::vector<PlotView::Limit>& limits)
{
    m_limits = limits;
    applyLimits();
}

void PlotPane::applyLimits()
{
    const bool hasCurrents = std::any_of(m_curves.begin(), m_curves.end(), [](const auto& curve) {
        return rowOf(curve.key).source == Source(PollId::Currents);
    });
    m_plot->setLimits(hasCurrents ? m_limits : std::vector<PlotView::Limit>());
}

void PlotPane::setMarked(bool marked)
{
    if (m_isMarked != marked) {
        m_isMarked = marked;
        update();
    }
}

void PlotPane::showValues()
{
    const PlotTimeline& timeline = m_plot->timeline();
    for (std::size_t i = 0; i < m_chips.size(); ++i) {
        const PlotFrame::Curve& curve = m_plot->frame().curves[i];
        std::optional<std::size_t> sample;
        if (const auto cursor = timeline.cursor(timeline.activeCursor())) {
            sample = sampleAt(*curve.series, *cursor);
        } else if (!curve.series->isEmpty()) {
            const std::size_t last = curve.series->size() - 1;
            const bool isFresh =
                !timeline.isLive() || timeline.now() - curve.series->time(last) < kFreshFor;
            if (isFresh && curve.series->isValid(last)) {
                sample = last;
            }
        }
        m_chips[i]->setValue(sample ? valueText(curve.scale.physical(curve.series->value(*sample)),
                                                curve.decimals, curve.unit)
                                    : u"–"_s);
    }
}

void PlotPane::paintEvent(QPaintEvent*)
{
    QPainter painter(this);
    painter.setPen(theme::colour(ColourRole::Grid));
    painter.drawLine(rect().topLeft(), rect().topRight());
    if (m_isMarked) {
        painter.setPen(QPen(theme::colour(ColourRole::Accent), 2.0));
        painter.drawRect(rect().adjusted(1, 1, -1, -1));
    }
}

void PlotPane::changeEvent(QEvent* event)
{
    QWidget::changeEvent(event);
    if (event->type() == QEvent::PaletteChange) {
        for (CurveChip* chip : m_chips) {
            chip->update();
        }
    }
}

} // namespace trex
