// SPDX-License-Identifier: GPL-3.0-or-later
// The menus of PlotStack: all that dragging does, and the looks of a curve.
#include "widgets/common/panel.h"
#include "widgets/plots/plotstack.h"

#include <QActionGroup>
#include <QCoreApplication>
#include <QMenu>
#include <QPainter>

namespace trex {

using namespace Qt::Literals::StringLiterals;

namespace {

constexpr int kHeightStep = 40; ///< pixels

QIcon lineIcon(const QColor& colour, double width)
{
    constexpr int kSize = 16;
    QPixmap pixmap(kSize, kSize);
    pixmap.fill(Qt::transparent);
    QPainter painter(&pixmap);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setPen(QPen(colour, width + 1.0, Qt::SolidLine, Qt::RoundCap));
    painter.drawLine(QPointF(2, kSize / 2.0), QPointF(kSize - 2, kSize / 2.0));
    return pixmap;
}

} // namespace

void PlotStack::showCurveMenu(PlotPane* pane, const QString& key, const QPoint& at)
{
    const auto& curves = pane->curves();
    const auto found = std::find_if(curves.begin(), curves.end(),
                                    [&key](const CurveSpec& curve) { return curve.key == key; });
    if (found == curves.end()) {
        return;
    }
    const CurveSpec curve = *found;
    auto* menu = named(new QMenu(this), u"plots.curveMenu"_s);
    menu->setAttribute(Qt::WA_DeleteOnClose);
    QAction* shown = menu->addAction(tr("Shown"));
    shown->setCheckable(true);
    shown->setChecked(curve.isVisible);
    connect(shown, &QAction::toggled, pane, [pane, curve](bool isShown) {
        CurveSpec changed = curve;
        changed.isVisible = isShown;
        pane->changeCurve(changed);
    });
    QMenu* colours = menu->addMenu(tr("Colour"));
    for (const CurveColourRow& row : curveColours()) {
        QAction* entry = colours->addAction(lineIcon(theme::colour(row.role), 3.0),
                                            QCoreApplication::translate("Plots", row.title));
        entry->setCheckable(true);
        entry->setChecked(row.role == curve.colour);
        connect(entry, &QAction::triggered, pane, [pane, curve, role = row.role] {
            CurveSpec changed = curve;
            changed.colour = role;
            pane->changeCurve(changed);
        });
    }
    QMenu* widths = menu->addMenu(tr("Width"));
    for (const CurveWidthRow& row : curveWidths()) {
        QAction* entry = widths->addAction(lineIcon(theme::colour(curve.colour), row.pixels),
                                           QCoreApplication::translate("Plots", row.title));
        entry->setCheckable(true);
        entry->setChecked(row.pixels == curve.width);
        connect(entry, &QAction::triggered, pane, [pane, curve, pixels = row.pixels] {
            CurveSpec changed = curve;
            changed.width = pixels;
            pane->changeCurve(changed);
        });
    }
    QMenu* targets = menu->addMenu(tr("Move to"));
    for (PlotPane* target : m_panes) {
        if (target != pane) {
            targets->addAction(target->accessibleName(), pane,
                               [this, pane, target, key] { moveCurve(key, pane, target); });
        }
    }
    targets->addAction(tr("A new plot"), pane,
                       [this, pane, key] { moveCurve(key, pane, nullptr); });
    menu->addSeparator();
    menu->addAction(theme::icon(u"cancel"_s), tr("Remove from this plot"), pane,
                    [pane, key] { pane->takeCurve(key); });
    menu->popup(at);
}

void PlotStack::showPaneMenu(PlotPane* pane, const QPoint& at)
{
    auto* menu = named(new QMenu(this), u"plots.plotMenu"_s);
    menu->setAttribute(Qt::WA_DeleteOnClose);
    QMenu* add = menu->addMenu(tr("Add a curve"));
    for (const StreamRow& row : streams()) {
        QAction* entry = add->addAction(titleOf(row));
        entry->setEnabled(!pane->has(keyOf(row)));
        connect(entry, &QAction::triggered, pane,
                [this, pane, key = keyOf(row)] { addCurve(key, pane); });
    }
    menu->addSeparator();
    QAction* up = menu->addAction(tr("Move up"), pane, [this, pane] { movePlot(pane, -1); });
    up->setEnabled(pane != m_panes.front());
    QAction* down = menu->addAction(tr("Move down"), pane, [this, pane] { movePlot(pane, 1); });
    down->setEnabled(pane != m_panes.back());
    menu->addAction(tr("Higher"), pane, [this, pane] { resizePlot(pane, kHeightStep); })
        ->setEnabled(m_panes.size() > 1);
    menu->addAction(tr("Lower"), pane, [this, pane] { resizePlot(pane, -kHeightStep); })
        ->setEnabled(m_panes.size() > 1);
    menu->addSeparator();
    menu->addAction(tr("New plot"), this, [this] { addPlot(); });
    menu->addAction(theme::icon(u"cancel"_s), tr("Remove this plot"), this,
                    [this, pane] { removePlot(pane); });
    menu->popup(at);
}

} // namespace trex
