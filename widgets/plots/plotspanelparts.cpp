// SPDX-License-Identifier: GPL-3.0-or-later
// The part of PlotsPanel that makes its controls, and that exports.
#include "protocol/errortext.h"
#include "protocol/session/controller.h"
#include "protocol/telemetry/plotreferences.h"
#include "widgets/common/eventlog.h"
#include "widgets/common/filedialogs.h"
#include "widgets/common/plottimeline.h"
#include "widgets/common/timewindowbox.h"
#include "widgets/common/uisettings.h"
#include "widgets/plots/comparelist.h"
#include "widgets/plots/curvechip.h"
#include "widgets/plots/eventlist.h"
#include "widgets/plots/plotexport.h"
#include "widgets/plots/plotspanel.h"
#include "widgets/plots/plotstack.h"
#include "widgets/plots/toolrow.h"
#include "widgets/plots/triggerbar.h"

#include <QClipboard>
#include <QDateTime>
#include <QDir>
#include <QFileInfo>
#include <QGuiApplication>
#include <QHBoxLayout>
#include <QImage>
#include <QLabel>
#include <QMenu>
#include <QScrollArea>
#include <QTabWidget>
#include <QTemporaryFile>
#include <QToolButton>

namespace trex {

using namespace Qt::Literals::StringLiterals;

namespace {

constexpr qint64 kMostCopied = 16LL * 1024 * 1024; ///< bytes; more than a clipboard is for

QString suggestedName()
{
    return u"plots-%1.csv"_s.arg(QDateTime::currentDateTime().toString(u"yyyyMMdd-HHmmss"_s));
}

} // namespace

QToolButton* PlotsPanel::addButton(QHBoxLayout* row, const QString& objectName, const QString& icon,
                                   const QString& text, const QString& toolTip)
{
    auto* button = named(new QToolButton(this), objectName, text);
    button->setIcon(theme::icon(icon));
    button->setText(text);
    button->setToolTip(toolTip);
    button->setAutoRaise(true);
    button->setFocusPolicy(Qt::TabFocus);
    row->addWidget(button);
    return button;
}

void PlotsPanel::addMoveButtons(QHBoxLayout* row)
{
    m_back = addButton(row, u"plots.back"_s, u"back"_s, tr("View before"),
                       tr("Back to the view before (Alt+Left in a plot)"));
    m_forward = addButton(row, u"plots.forward"_s, u"next"_s, tr("View after"),
                          tr("Forward again (Alt+Right in a plot)"));
    m_back->setEnabled(false);
    m_forward->setEnabled(false);
    connect(m_back, &QToolButton::clicked, m_timeline, &PlotTimeline::back);
    connect(m_forward, &QToolButton::clicked, m_timeline, &PlotTimeline::forward);
    auto* closer = addButton(row, u"plots.zoomIn"_s, u"zoom-in"_s, tr("Zoom in"),
                             tr("Closer in time (+ or the wheel; with Ctrl the values)"));
    auto* farther = addButton(row, u"plots.zoomOut"_s, u"zoom-out"_s, tr("Zoom out"),
                              tr("More time (− or the wheel; with Ctrl the values)"));
    constexpr double kStep = 0.5;
    constexpr double kMiddle = 0.5;
    connect(closer, &QToolButton::clicked, this, [this] { m_timeline->zoom(kStep, kMiddle); });
    connect(farther, &QToolButton::clicked, this,
            [this] { m_timeline->zoom(1.0 / kStep, kMiddle); });
    auto* fit = addButton(row, u"plots.fit"_s, u"fit"_s, tr("Show everything"),
                          tr("Show everything recorded in this session (F)"));
    connect(fit, &QToolButton::clicked, m_timeline, &PlotTimeline::fit);
    auto* hand = addButton(row, u"plots.pan"_s, u"hand"_s, tr("Drag to pan"),
                           tr("Dragging moves the picture instead of zooming into a box"));
    hand->setCheckable(true);
    connect(hand, &QToolButton::toggled, this, [this](bool isOn) {
        m_stack->setTool(isOn ? PlotView::Tool::Pan : PlotView::Tool::Zoom);
    });
}

QWidget* PlotsPanel::makeToolRow()
{
    auto* bar = new ToolRow(this);
    auto* row = new QHBoxLayout(bar);
    row->setContentsMargins(0, 0, 0, 0);
    row->setSpacing(4);
    auto* window = named(
        new TimeWindowBox(*m_timeline, context().settings, settings::kPlotsWindowSeconds, bar),
        u"plots.window"_s, tr("Time shown"));
    window->setToolTip(tr("How much time the plots show"));
    row->addWidget(window);
    m_pause = addButton(row, u"plots.pause"_s, u"pause"_s, tr("Pause"),
                        tr("Hold the picture still; recording goes on behind"));
    m_pause->setCheckable(true);
    m_pause->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
    addMoveButtons(row);
    m_cursors = addButton(row, u"plots.cursors"_s, u"cursors"_s, tr("Cursors"),
                          tr("Two cursors to measure with (1 and 2 in a plot)"));
    m_cursors->setCheckable(true);
    m_cursors->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
    connect(m_cursors, &QToolButton::clicked, this, &PlotsPanel::toggleCursors);
    auto* trigger = addButton(row, u"plots.showTrigger"_s, u"trigger"_s, tr("Trigger"),
                              tr("Catch the moment a curve crosses a level"));
    trigger->setCheckable(true);
    trigger->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
    m_trigger->hide();
    connect(trigger, &QToolButton::toggled, this, [this](bool isShown) {
        m_trigger->setVisible(isShown);
        m_trigger->setOn(isShown);
    });
    row->addStretch(1);
    m_sideButton = addButton(row, u"plots.showSide"_s, u"log"_s, tr("Lists"),
                             tr("Curves to add, events, runs to compare with"));
    m_sideButton->setCheckable(true);
    m_sideButton->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
    connect(m_sideButton, &QToolButton::toggled, m_side, &QWidget::setVisible);
    auto* plots = addButton(row, u"plots.menu"_s, u"window"_s, tr("Plots"),
                            tr("Add a plot, or put them as they were at first"));
    makePlotMenu(plots);
    auto* save = addButton(row, u"plots.export"_s, u"export"_s, tr("Export"),
                           tr("Save samples as CSV, or the picture as PNG or SVG"));
    save->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
    makeExportMenu(save);
    return bar;
}

void PlotsPanel::makePlotMenu(QToolButton* button)
{
    auto* menu = new QMenu(button);
    menu->addAction(tr("New plot"), this, [this] { m_stack->addPlot(); })
        ->setObjectName(u"plots.newPlot"_s);
    menu->addAction(tr("As at first"), this, [this] { m_stack->setLayoutOf(defaultLayout()); })
        ->setObjectName(u"plots.defaultPlots"_s);
    button->setMenu(menu);
    button->setPopupMode(QToolButton::InstantPopup);
}

void PlotsPanel::makeExportMenu(QToolButton* button)
{
    auto* menu = new QMenu(button);
    menu->addAction(tr("All samples or picture…"), this, [this] { askExport(false); });
    menu->addAction(tr("Visible part…"), this, [this] { askExport(true); });
    menu->addSeparator();
    menu->addAction(theme::icon(u"copy"_s), tr("Copy picture"), this, [this] { copyPicture(); })
        ->setObjectName(u"plots.copyPicture"_s);
    menu->addAction(theme::icon(u"copy"_s), tr("Copy visible samples"), this,
                    [this] { copySamples(); })
        ->setObjectName(u"plots.copySamples"_s);
    button->setMenu(menu);
    button->setPopupMode(QToolButton::MenuButtonPopup);
    connect(button, &QToolButton::clicked, this, [this] { askExport(false); });
}

QWidget* PlotsPanel::makeCurveList()
{
    auto* scroll = new QScrollArea(m_side);
    scroll->setFrameShape(QFrame::NoFrame);
    scroll->setWidgetResizable(true);
    auto* list = new QWidget(scroll);
    auto* column = new QVBoxLayout(list);
    column->setContentsMargins(4, 4, 4, 4);
    column->setSpacing(0);
    auto* hint = new QLabel(tr("Click to add to the plot used last, or drag into a plot."), list);
    hint->setWordWrap(true);
    theme::setTextColour(*hint, ColourRole::DimText);
    column->addWidget(hint);
    for (const StreamRow& row : streams()) {
        auto* chip = new CurveChip(list);
        const CurveSpec curve = curveOf(row);
        chip->setCurve(curve);
        chip->setObjectName(u"plots.curves."_s + curve.key);
        chip->setToolTip(hint->text());
        column->addWidget(chip);
        connect(chip, &CurveChip::clicked, this, [this, chip, curve] {
            chip->setChecked(true);
            m_stack->addCurve(curve.key, nullptr);
        });
        connect(chip, &CurveChip::draggedTo, m_stack, &PlotStack::markPaneAt);
        connect(chip, &CurveChip::droppedAt, this, [this, key = curve.key](const QPoint& at) {
            m_stack->markPaneAt({});
            if (PlotPane* target = m_stack->paneAt(at)) {
                m_stack->addCurve(key, target);
            }
        });
    }
    column->addStretch(1);
    list->setBackgroundRole(QPalette::Base);
    scroll->setWidget(list);
    scroll->viewport()->setBackgroundRole(QPalette::Base);
    return scroll;
}

void PlotsPanel::makeSide()
{
    named(m_side, u"plots.side"_s, tr("Lists"));
    m_side->setDocumentMode(true);
    m_side->addTab(makeCurveList(), tr("Curves"));
    m_side->addTab(named(new EventList(context().marks, *m_timeline, context().ticker, m_side),
                         u"plots.events"_s),
                   tr("Events"));
    auto* compare = named(new CompareList(*m_references, m_side), u"plots.compare"_s);
    connect(compare, &CompareList::freezeRequested, this, &PlotsPanel::freeze);
    m_side->addTab(compare, tr("Compare"));
    m_side->hide();
}

void PlotsPanel::showSide(int tab)
{
    m_sideButton->setChecked(tab >= 0);
    if (tab >= 0) {
        m_side->setCurrentIndex(tab);
    }
}

void PlotsPanel::askExport(bool isVisiblePartOnly)
{
    context().fileDialogs.askSave(
        this, isVisiblePartOnly ? tr("Export the visible part") : tr("Export"), suggestedName(),
        tr("Samples as CSV (*.csv);;Picture as PNG (*.png);;Picture as SVG (*.svg)"),
        [this, isVisiblePartOnly](const QString& path) { writeExport(path, isVisiblePartOnly); });
}

Result<std::size_t> PlotsPanel::writeCsv(const QString& path, bool isVisiblePartOnly)
{
    std::vector<QString> keys;
    for (const CurveSpec& curve : m_stack->visibleCurves()) {
        keys.push_back(curve.key);
    }
    const auto range =
        isVisiblePartOnly ? std::optional(m_timeline->range()) : std::optional<TimeRange>();
    const auto mode = context().controller.device().mode;
    return exportPlotsCsv(path, context().store, keys, context().controller.model(),
                          mode ? std::optional(inputOf(*mode)) : std::nullopt, range);
}

void PlotsPanel::writeExport(const QString& path, bool isVisiblePartOnly)
{
    const QString shown = QDir::toNativeSeparators(path);
    const QString suffix = QFileInfo(path).suffix().toLower();
    if (suffix == u"png"_s || suffix == u"svg"_s) {
        const auto written =
            suffix == u"png"_s ? exportPlotsPng(path, *m_stack) : exportPlotsSvg(path, *m_stack);
        if (written) {
            context().log.add(EventLog::Information, tr("Plots saved as %1.").arg(shown));
        } else {
            context().log.add(EventLog::Failure, errorText(written.error()));
        }
        return;
    }
    if (const auto rows = writeCsv(path, isVisiblePartOnly)) {
        context().log.add(
            EventLog::Information,
            tr("%n row(s) of samples exported to %1.", nullptr, static_cast<int>(*rows))
                .arg(shown));
    } else {
        context().log.add(EventLog::Failure, errorText(rows.error()));
    }
}

void PlotsPanel::copyPicture()
{
    QGuiApplication::clipboard()->setImage(pictureOf(*m_stack));
    context().log.add(EventLog::Information, tr("The picture of the plots was copied."));
}

void PlotsPanel::copySamples()
{
    QTemporaryFile file;
    if (!file.open()) {
        context().log.add(EventLog::Failure,
                          errorText({ErrorCode::FileUnwritable, file.errorString()}));
        return;
    }
    const auto rows = writeCsv(file.fileName(), true);
    QFile written(file.fileName());
    if (!rows || !written.open(QIODevice::ReadOnly)) {
        context().log.add(EventLog::Failure,
                          errorText(rows ? Error{ErrorCode::FileUnwritable, written.errorString()}
                                         : rows.error()));
        return;
    }
    if (written.size() > kMostCopied) {
        context().log.add(EventLog::Warning,
                          tr("Too much for the clipboard: export the visible part to a file."));
        return;
    }
    QGuiApplication::clipboard()->setText(QString::fromUtf8(written.readAll()));
    context().log.add(EventLog::Information,
                      tr("%n row(s) of samples copied.", nullptr, static_cast<int>(*rows)));
}

} // namespace trex
