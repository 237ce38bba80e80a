// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/plots/plotstack.h"

#include "widgets/common/panel.h"
#include "widgets/common/plotframe.h"
#include "widgets/plots/curvechip.h"

#include <QPainter>
#include <QSplitter>

#include <algorithm>

namespace trex {

using namespace Qt::Literals::StringLiterals;

PlotStack::PlotStack(PanelContext& context, PlotTimeline& timeline, QWidget* parent)
    : QScrollArea(parent)
    , m_context(context)
    , m_timeline(timeline)
    , m_splitter(new QSplitter(Qt::Vertical))
    , m_amperesPerCount(amperesPerCount(Model::TrexJr))
{
    setFrameShape(QFrame::NoFrame);
    setWidgetResizable(true);
    setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    setFocusPolicy(Qt::NoFocus);
    setWidget(m_splitter); // owns it
    m_splitter->setChildrenCollapsible(false);
    m_splitter->setHandleWidth(5);
    m_splitter->setAutoFillBackground(true);
    m_splitter->setBackgroundRole(QPalette::Base);
    viewport()->setBackgroundRole(QPalette::Base);
    connect(m_splitter, &QSplitter::splitterMoved, this, &PlotStack::layoutChanged);
}

PlotStack::~PlotStack() = default;

void PlotStack::wire(PlotPane* pane)
{
    connect(pane, &PlotPane::changed, this, [this] {
        if (!m_isBuilding) {
            lineUp();
            emit layoutChanged();
        }
    });
    connect(&pane->plot(), &PlotView::axisExtentChanged, this, &PlotStack::lineUp);
    connect(&pane->plot(), &PlotView::focused, this, [this, pane] { m_active = pane; });
    connect(&pane->plot(), &PlotView::levelDragged, this, &PlotStack::levelDragged);
    connect(pane, &PlotPane::removalRequested, this,
            [pane](const QString& key) { pane->takeCurve(key); });
    connect(pane, &PlotPane::menuRequested, this,
            [this, pane](const QString& key, const QPoint& at) { showCurveMenu(pane, key, at); });
    connect(pane, &PlotPane::paneMenuRequested, this,
            [this, pane](const QPoint& at) { showPaneMenu(pane, at); });
    connect(pane, &PlotPane::curveDraggedTo, this, &PlotStack::markPaneAt);
    connect(pane, &PlotPane::curveDroppedAt, this,
            [this, pane](const QString& key, const QPoint& at) {
                markPaneAt({});
                if (PlotPane* target = paneAt(at); target != nullptr && target != pane) {
                    moveCurve(key, pane, target);
                }
            });
}

PlotPane* PlotStack::addPlot(const PlotSpec& spec)
{
    auto* pane = new PlotPane(m_context, m_timeline, m_splitter);
    m_splitter->addWidget(pane);
    m_panes.push_back(pane);
    wire(pane);
    pane->plot().setReferences(m_references);
    pane->plot().setTool(m_tool);
    const bool wasBuilding = std::exchange(m_isBuilding, true);
    pane->setAmperesPerCount(m_amperesPerCount);
    pane->setLimits(m_limits);
    for (const CurveSpec& curve : spec.curves) {
        pane->addCurve(curve);
    }
    m_isBuilding = wasBuilding;
    renumber();
    if (!m_isBuilding) {
        emit layoutChanged();
    }
    return pane;
}

void PlotStack::setLayoutOf(const PlotLayout& layout)
{
    m_isBuilding = true;
    for (PlotPane* pane : m_panes) {
        pane->hide();
        pane->setParent(nullptr);
        pane->deleteLater();
    }
    m_panes.clear();
    m_active = nullptr;
    QList<int> heights;
    for (const PlotSpec& spec : layout) {
        addPlot(spec);
        heights.append(spec.height);
    }
    m_splitter->setSizes(heights);
    m_isBuilding = false;
    renumber();
    emit layoutChanged();
}

PlotLayout PlotStack::layoutOf() const
{
    PlotLayout layout;
    const QList<int> sizes = m_splitter->sizes();
    for (std::size_t i = 0; i < m_panes.size(); ++i) {
        const int height = sizes.value(static_cast<qsizetype>(i));
        layout.push_back({m_panes[i]->curves(), height > 0 ? height : PlotSpec().height});
    }
    return layout;
}

std::vector<CurveSpec> PlotStack::visibleCurves() const
{
    std::vector<CurveSpec> all;
    for (const PlotPane* pane : m_panes) {
        for (const CurveSpec& curve : pane->curves()) {
            const bool isThere =
                std::any_of(all.begin(), all.end(),
                            [&curve](const CurveSpec& other) { return other.key == curve.key; });
            if (curve.isVisible && !isThere) {
                all.push_back(curve);
            }
        }
    }
    return all;
}

void PlotStack::removePlot(PlotPane* pane)
{
    if (m_panes.size() == 1) {
        while (!pane->curves().empty()) {
            pane->takeCurve(pane->curves().front().key);
        }
        return;
    }
    std::erase(m_panes, pane);
    m_active = m_active == pane ? nullptr : m_active;
    pane->hide();
    pane->setParent(nullptr);
    pane->deleteLater(); // its own menu may be what asked
    renumber();
    emit layoutChanged();
}

void PlotStack::movePlot(PlotPane* pane, int by)
{
    const auto found = std::find(m_panes.begin(), m_panes.end(), pane);
    const auto from = found - m_panes.begin();
    const auto to = from + by;
    if (found == m_panes.end() || to < 0 || to >= static_cast<std::ptrdiff_t>(m_panes.size())) {
        return;
    }
    QList<int> sizes = m_splitter->sizes();
    sizes.move(from, to);
    std::swap(m_panes[static_cast<std::size_t>(from)], m_panes[static_cast<std::size_t>(to)]);
    m_splitter->insertWidget(static_cast<int>(to), pane);
    m_splitter->setSizes(sizes);
    renumber();
    emit layoutChanged();
}

void PlotStack::resizePlot(PlotPane* pane, int by)
{
    QList<int> sizes = m_splitter->sizes();
    const auto index = static_cast<qsizetype>(m_splitter->indexOf(pane));
    const int others = static_cast<int>(sizes.size()) - 1;
    if (index < 0 || others < 1) {
        return;
    }
    for (qsizetype i = 0; i < sizes.size(); ++i) {
        sizes[i] = std::max(sizes[i] + (i == index ? by : -by / others), 1);
    }
    m_splitter->setSizes(sizes);
    emit layoutChanged();
}

void PlotStack::moveCurve(const QString& key, PlotPane* from, PlotPane* to)
{
    if (const auto curve = from->takeCurve(key)) {
        (to != nullptr ? to : addPlot())->addCurve(*curve);
    }
}

void PlotStack::addCurve(const QString& key, PlotPane* to)
{
    const int index = streamIndex(key.toStdString());
    PlotPane* pane = to != nullptr ? to : m_active != nullptr ? m_active : m_panes.front();
    if (index >= 0) {
        pane->addCurve(curveOf(streams()[static_cast<std::size_t>(index)]));
    }
}

PlotPane* PlotStack::paneAt(const QPoint& globalPosition) const
{
    for (PlotPane* pane : m_panes) {
        if (pane->rect().contains(pane->mapFromGlobal(globalPosition))
            && viewport()->rect().contains(viewport()->mapFromGlobal(globalPosition))) {
            return pane;
        }
    }
    return nullptr;
}

void PlotStack::markPaneAt(const QPoint& globalPosition)
{
    const PlotPane* target = globalPosition.isNull() ? nullptr : paneAt(globalPosition);
    for (PlotPane* pane : m_panes) {
        pane->setMarked(pane == target);
    }
}

void PlotStack::renumber()
{
    const auto count = static_cast<int>(m_panes.size());
    for (int i = 0; i < count; ++i) {
        PlotPane* pane = m_panes[static_cast<std::size_t>(i)];
        pane->setNumber(i + 1, count);
        pane->plot().setPlaceInStack(i == 0, i == count - 1);
    }
    lineUp();
}

/// The widest value axis decides where all plot areas begin.
void PlotStack::lineUp()
{
    if (m_isLiningUp || m_isBuilding) {
        return; // moving one tells of it
    }
    m_isLiningUp = true;
    double widest = 0.0;
    for (const PlotPane* pane : m_panes) {
        widest = std::max(widest, pane->plot().axisExtent());
    }
    for (const PlotPane* pane : m_panes) {
        pane->plot().setAxisExtent(widest);
    }
    m_isLiningUp = false;
}

void PlotStack::setAmperesPerCount(double amperes)
{
    if (m_amperesPerCount != amperes) {
        m_amperesPerCount = amperes;
        for (PlotPane* pane : m_panes) {
            pane->setAmperesPerCount(amperes);
        }
    }
}

void PlotStack::setLimits(const std::vector<PlotView::Limit>& limits)
{
    m_limits = limits;
    for (PlotPane* pane : m_panes) {
        pane->setLimits(limits);
    }
}

void PlotStack::setReferences(const PlotReferences* references)
{
    m_references = references;
    for (const PlotPane* pane : m_panes) {
        pane->plot().setReferences(references);
    }
}

void PlotStack::setTool(PlotView::Tool tool)
{
    m_tool = tool;
    for (const PlotPane* pane : m_panes) {
        pane->plot().setTool(tool);
    }
}

void PlotStack::setTrigger(const QString& source, std::optional<double> level,
                           std::optional<Instant> crossing)
{
    for (const PlotPane* pane : m_panes) {
        pane->plot().setTrigger(pane->has(source) ? level : std::nullopt, crossing);
    }
}

void PlotStack::showValues()
{
    for (PlotPane* pane : m_panes) {
        pane->showValues();
    }
}

QSize PlotStack::pictureSize() const
{
    return m_splitter->size();
}

void PlotStack::renderTo(QPainter& painter)
{
    painter.fillRect(QRect(QPoint(), pictureSize()), theme::colour(ColourRole::Panel));
    for (PlotPane* pane : m_panes) {
        pane->plot().redraw();
        painter.save();
        painter.translate(pane->pos());
        painter.setClipRect(pane->rect());
        for (CurveChip* chip : pane->findChildren<CurveChip*>()) {
            painter.save();
            painter.translate(chip->pos());
            chip->paintTo(painter);
            painter.restore();
        }
        const QRect view = pane->plot().geometry();
        pane->plot().render(&painter, QRectF(view), pane->plot().viewport()->rect());
        painter.restore();
    }
}

} // namespace trex
