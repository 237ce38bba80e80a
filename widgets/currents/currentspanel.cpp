// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/currents/currentspanel.h"

#include "protocol/session/controller.h"
#include "protocol/session/devicesettings.h"
#include "widgets/common/frameticker.h"
#include "widgets/common/measurementview.h"
#include "widgets/common/plotlimits.h"
#include "widgets/common/plotview.h"
#include "widgets/common/timewindowbox.h"
#include "widgets/common/uisettings.h"
#include "widgets/currents/currentreadout.h"

#include <QHBoxLayout>
#include <QMenu>
#include <QSignalBlocker>
#include <QToolButton>
#include <QVBoxLayout>

namespace trex {

using namespace std::chrono_literals;
using namespace Qt::Literals::StringLiterals;

namespace {

constexpr auto kStaleAfter = 1s;
constexpr qint64 kReadOutIntervalMs = 100; ///< digits that change faster cannot be read
constexpr double kSmallestTopAmperes = 0.9; ///< the axis ends at 1 A when little is drawn
constexpr auto kMotorMode = parameterRow("motor-mode");
constexpr int kJointMode = 1;

} // namespace

CurrentsPanel::CurrentsPanel(PanelContext& panelContext, QWidget* parent)
    : Panel(panelContext, parent)
    , m_recorder(panelContext.store)
    , m_plot(named(new PlotView(panelContext.store, panelContext.ticker, this), u"currents.plot"_s,
                   tr("Motor currents over time")))
    , m_measurement(new MeasurementView(m_plot->timeline(), panelContext.ticker,
                                        u"currents.measurement"_s, this))
{
    setObjectName(u"currents"_s);
    m_plot->addCurve("motor1-current", ColourRole::Motor1);
    m_plot->addCurve("motor2-current", ColourRole::Motor2);
    m_plot->setUnit(u"A"_s);
    m_plot->setSmallestTop(kSmallestTopAmperes);
    m_plot->timeline().setMarks(panelContext.marks);
    m_measurement->setPlots({m_plot});
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(8, 4, 8, 8);
    layout->setSpacing(4);
    layout->addWidget(makeToolRow());
    layout->addWidget(m_plot, 1);
    layout->addWidget(m_measurement);
    layout->addWidget(makeReadOutRow());
    connectPlot();
    connectCursors();
    connectContext();
    m_sinceReadOuts.start();
    updateDevice();
    m_plot->setLimits(currentLimits(context().deviceSettings));
    showRecording();
}

CurrentsPanel::~CurrentsPanel()
{
    context().controller.wantNothing(this);
}

QToolButton* CurrentsPanel::addButton(QHBoxLayout* row, const QString& objectName,
                                      const QString& icon, const QString& text,
                                      const QString& toolTip)
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

QWidget* CurrentsPanel::makeToolRow()
{
    auto* bar = new QWidget(this);
    auto* row = new QHBoxLayout(bar);
    row->setContentsMargins(0, 0, 0, 0);
    row->setSpacing(4);
    auto* window = named(new TimeWindowBox(m_plot->timeline(), context().settings,
                                           settings::kPlotWindowSeconds, bar),
                         u"currents.window"_s, tr("Time shown"));
    window->setToolTip(tr("How much time the plot shows"));
    row->addWidget(window);
    m_pause = addButton(row, u"currents.pause"_s, u"pause"_s, tr("Pause"),
                        tr("Hold the picture still; recording goes on behind"));
    m_pause->setCheckable(true);
    m_pause->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
    auto* fit = addButton(row, u"currents.fit"_s, u"fit"_s, tr("Show everything"),
                          tr("Show everything recorded in this session"));
    connect(fit, &QToolButton::clicked, m_plot, &PlotView::fit);
    m_cursors = addButton(row, u"currents.cursors"_s, u"cursors"_s, tr("Cursors"),
                          tr("Two cursors to measure with (1 and 2 in the plot)"));
    m_cursors->setCheckable(true);
    row->addStretch(1);
    m_record = addButton(row, u"currents.record"_s, u"record"_s, tr("Record"), {});
    m_record->setCheckable(true);
    m_record->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
    connect(m_record, &QToolButton::clicked, this, &CurrentsPanel::toggleRecording);
    m_export = addButton(row, u"currents.export"_s, u"export"_s, tr("Export"),
                         tr("Save all samples as CSV, or the plot as a PNG picture"));
    m_export->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
    makeExportMenu();
    auto* clear = addButton(row, u"currents.clear"_s, u"clear"_s, tr("Clear"),
                            tr("Forget all samples of this session and start anew"));
    connect(clear, &QToolButton::clicked, this, &CurrentsPanel::clearSamples);
    const bool isLive = !context().controller.isRecording(); // nothing new comes to a recording
    m_record->setVisible(isLive);
    clear->setVisible(isLive);
    return bar;
}

void CurrentsPanel::makeExportMenu()
{
    auto* menu = new QMenu(m_export);
    menu->addAction(tr("All samples or picture…"), this, [this] { askExport(false); });
    menu->addAction(tr("Visible part…"), this, [this] { askExport(true); });
    m_export->setMenu(menu);
    m_export->setPopupMode(QToolButton::MenuButtonPopup);
    connect(m_export, &QToolButton::clicked, this, [this] { askExport(false); });
}

QWidget* CurrentsPanel::makeReadOutRow()
{
    auto* bar = new QWidget(this);
    auto* row = new QHBoxLayout(bar);
    row->setContentsMargins(0, 0, 0, 0);
    row->setSpacing(16);
    m_readOuts = {
        new CurrentReadOut(tr("Motor 1"), ColourRole::Motor1, u"currents.motor1.value"_s, bar),
        new CurrentReadOut(tr("Motor 2"), ColourRole::Motor2, u"currents.motor2.value"_s, bar)};
    for (CurrentReadOut* readOut : m_readOuts) {
        row->addWidget(readOut, 1);
    }
    return bar;
}

void CurrentsPanel::connectPlot()
{
    connect(m_pause, &QToolButton::clicked, this, [this](bool paused) {
        if (paused) {
            m_plot->setPaused(true);
        } else {
            m_plot->follow();
        }
    });
    connect(m_plot, &PlotView::pausedChanged, this, [this](bool paused) {
        m_pause->setChecked(paused);
        m_pause->setText(paused ? tr("Resume") : tr("Pause"));
        m_pause->setIcon(theme::icon(paused ? u"play"_s : u"pause"_s));
    });
    connect(m_plot, &PlotView::viewChanged, this, &CurrentsPanel::updateReadOuts);
}

void CurrentsPanel::connectCursors()
{
    PlotTimeline& timeline = m_plot->timeline();
    connect(m_cursors, &QToolButton::clicked, this, [&timeline](bool on) {
        if (!on) {
            timeline.clearCursors();
            return;
        }
        const TimeRange range = timeline.range();
        const Duration third = (range.to - range.from) / 3;
        timeline.setActiveCursor(0);
        timeline.setCursor(0, range.from + third);
        timeline.setCursor(1, range.to - third);
    });
    connect(&timeline, &PlotTimeline::cursorsChanged, this,
            [this, &timeline] { m_cursors->setChecked(timeline.cursor(0) || timeline.cursor(1)); });
}

void CurrentsPanel::connectContext()
{
    Controller& controller = context().controller;
    connect(&context().ticker, &FrameTicker::tick, this, &CurrentsPanel::onTick);
    connect(&controller, &Controller::stateChanged, this, &CurrentsPanel::onStateChanged);
    connect(&controller, &Controller::deviceChanged, this, &CurrentsPanel::updateDevice);
    connect(&context().deviceSettings, &DeviceSettings::forgotten, this, [this] {
        m_plot->setLimits({});
        updateDevice();
        readMotorMode();
    });
    connect(&context().deviceSettings, &DeviceSettings::parameterChanged, this, [this](int number) {
        m_plot->setLimits(currentLimits(context().deviceSettings));
        if (number == kMotorMode.number) {
            updateDevice();
        }
    });
}

void CurrentsPanel::onStateChanged()
{
    readMotorMode();
    updateDevice();
}

void CurrentsPanel::readMotorMode()
{
    const bool isConnected = context().controller.state() == LinkState::Connected;
    if (isConnected && !m_isReadingMode && !context().deviceSettings.parameter(kMotorMode.number)) {
        m_isReadingMode = true;
        context().deviceSettings.readParameter(parameterRow("motor-mode"), this,
                                               [this](const Result<int>&) {
                                                   m_isReadingMode = false;
                                                   updateDevice();
                                               });
    }
}

bool CurrentsPanel::isJoint() const
{
    // The value read is the stored one; when it waits for a power cycle, the other is in force.
    const auto mode = context().deviceSettings.parameter(kMotorMode.number);
    return mode && (*mode == kJointMode) != context().deviceSettings.isPending(kMotorMode.number);
}

double CurrentsPanel::scale() const
{
    return amperesPerCount(context().controller.model());
}

void CurrentsPanel::updateDevice()
{
    const LinkState state = context().controller.state();
    for (int curve = 0; curve < static_cast<int>(m_readOuts.size()); ++curve) {
        m_plot->setCurveScale(curve, scale());
    }
    const bool isOpen =
        state == LinkState::Connected || state == LinkState::Lost || state == LinkState::Retrying;
    m_plot->setLive(isOpen && !isJoint());
    QString message;
    if (isJoint()) {
        message = tr("Motor currents are not available in joint mode.");
    } else if (state == LinkState::Disconnected && !context().store.start()) {
        message = tr("No samples yet. Connect to a controller, or simulate one.");
    }
    m_plot->setMessage(message);
    updateWish();
    updateReadOuts();
}

void CurrentsPanel::updateWish()
{
    const bool isNeeded = !isJoint() && (isVisible() || m_recorder.isRecording());
    context().controller.want(this, PollId::Currents, isNeeded ? kHertz : 0.0);
}

void CurrentsPanel::showEvent(QShowEvent* event)
{
    Panel::showEvent(event);
    updateWish();
}

void CurrentsPanel::hideEvent(QHideEvent* event)
{
    Panel::hideEvent(event);
    updateWish();
}

void CurrentsPanel::onTick()
{
    if (const PollSample* latest = context().store.latest(PollId::Currents)) {
        m_latest = *latest;
    } else if (m_latest && m_latest->time > context().store.now()) {
        m_latest.reset(); // a playhead before all samples
    }
    if (m_recorder.isRecording()) {
        showRecording();
    }
    if (isVisible() && m_sinceReadOuts.elapsed() >= kReadOutIntervalMs) {
        updateReadOuts();
    }
}

void CurrentsPanel::updateReadOuts()
{
    m_sinceReadOuts.start();
    const bool isInferred = isGuess(amperesGrade(context().controller.model()));
    const PollSample* latest = context().store.latest(PollId::Currents);
    const Instant now = context().store.now();
    const TimeRange range = m_plot->visibleRange();
    for (std::size_t i = 0; i < m_readOuts.size(); ++i) {
        CurrentReadOut::Figures figures;
        figures.isInferred = isInferred;
        if (isJoint()) {
            figures.note = tr("not available in joint mode");
        } else if (m_latest) {
            const auto age = now - m_latest->time;
            figures.present = m_latest->raw[i] * scale();
            figures.isStale = latest == nullptr || age > kStaleAfter;
            if (figures.isStale) {
                figures.note =
                    tr("%1 s old")
                        .arg(std::chrono::duration_cast<std::chrono::seconds>(age).count());
            }
            const TimeSeries& series =
                context().store.series(i == 0 ? "motor1-current" : "motor2-current");
            const auto [begin, end] = series.range(range.from, range.to);
            if (const Extent extent = series.extent(begin, end); !extent.isEmpty()) {
                figures.peak = extent.high * scale();
            }
            if (const auto mean = series.mean(begin, end)) {
                figures.mean = *mean * scale();
            }
        }
        m_readOuts[i]->show(figures);
    }
}

} // namespace trex
