// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/plots/plotspanel.h"

#include "protocol/session/controller.h"
#include "protocol/session/devicesettings.h"
#include "protocol/telemetry/plotreferences.h"
#include "widgets/common/frameticker.h"
#include "widgets/common/measurementview.h"
#include "widgets/common/plotlimits.h"
#include "widgets/common/uisettings.h"
#include "widgets/plots/plotstack.h"
#include "widgets/plots/triggerbar.h"

#include <QSplitter>
#include <QTabWidget>
#include <QToolButton>
#include <QVBoxLayout>

namespace trex {

using namespace std::chrono_literals;
using namespace Qt::Literals::StringLiterals;

namespace {

constexpr int kTicksBetweenValues = 3; ///< digits that change faster cannot be read
constexpr auto kSaveAfter = 500ms;
constexpr int kSideWidth = 300;

} // namespace

PlotsPanel::PlotsPanel(PanelContext& panelContext, QWidget* parent)
    : Panel(panelContext, parent)
    , m_timeline(new PlotTimeline(panelContext.store, this))
    , m_references(panelContext.references != nullptr ? panelContext.references
                                                      : new PlotReferences(this))
    , m_side(new QTabWidget(this))
{
    setObjectName(u"plots"_s);
    m_timeline->setMarks(panelContext.marks);
    m_stack = named(new PlotStack(panelContext, *m_timeline, this), u"plots.stack"_s, tr("Plots"));
    m_trigger = named(new TriggerBar(*m_timeline, this), u"plots.trigger"_s);
    m_measurement =
        new MeasurementView(*m_timeline, panelContext.ticker, u"plots.measurement"_s, this);
    makeSide();
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(8, 4, 8, 4);
    layout->setSpacing(4);
    layout->addWidget(makeToolRow());
    layout->addWidget(m_trigger);
    auto* middle = new QSplitter(this);
    middle->setHandleWidth(5);
    middle->addWidget(m_stack);
    middle->addWidget(m_side);
    middle->setStretchFactor(0, 1);
    middle->setStretchFactor(1, 0);
    middle->setSizes({3 * kSideWidth, kSideWidth});
    layout->addWidget(middle, 1);
    layout->addWidget(m_measurement);
    m_saveLayout.setSingleShot(true);
    m_saveLayout.setInterval(kSaveAfter);
    connectTimeline();
    connectStack();
    connectContext();
    updateDevice();
}

PlotsPanel::~PlotsPanel()
{
    if (m_saveLayout.isActive()) {
        context().settings.set(settings::kPlotsLayout, toJson(m_stack->layoutOf()));
    }
    context().controller.wantNothing(this);
}

void PlotsPanel::connectTimeline()
{
    connect(m_pause, &QToolButton::clicked, this, [this](bool paused) {
        if (paused) {
            m_timeline->setPaused(true);
        } else {
            m_timeline->follow();
        }
    });
    connect(m_timeline, &PlotTimeline::pausedChanged, this, [this](bool paused) {
        m_pause->setChecked(paused);
        m_pause->setText(paused ? tr("Resume") : tr("Pause"));
        m_pause->setIcon(theme::icon(paused ? u"play"_s : u"pause"_s));
    });
    connect(m_timeline, &PlotTimeline::viewChanged, this, [this] {
        m_back->setEnabled(m_timeline->canGoBack());
        m_forward->setEnabled(m_timeline->canGoForward());
        updateAnchors();
    });
    connect(m_timeline, &PlotTimeline::cursorsChanged, this, [this] {
        m_cursors->setChecked(m_timeline->cursor(0) || m_timeline->cursor(1));
        m_stack->showValues();
    });
}

void PlotsPanel::connectStack()
{
    const auto stored = layoutFromJson(context().settings.value(settings::kPlotsLayout));
    m_stack->setReferences(m_references);
    m_stack->setLayoutOf(stored.value_or(defaultLayout()));
    onLayoutChanged();
    m_saveLayout.stop(); // nothing has changed yet
    connect(m_stack, &PlotStack::layoutChanged, this, &PlotsPanel::onLayoutChanged);
    connect(&m_saveLayout, &QTimer::timeout, this, [this] {
        context().settings.set(settings::kPlotsLayout, toJson(m_stack->layoutOf()));
    });
    connect(m_stack, &PlotStack::levelDragged, m_trigger, &TriggerBar::setLevel);
    connect(m_trigger, &TriggerBar::changed, this, &PlotsPanel::updateTrigger);
    connect(m_references, &PlotReferences::changed, this, [this] {
        alignRuns();
        updateAnchors();
    });
    alignRuns();
}

void PlotsPanel::connectContext()
{
    connect(&context().ticker, &FrameTicker::tick, this, &PlotsPanel::onTick);
    connect(&context().controller, &Controller::stateChanged, this, &PlotsPanel::updateDevice);
    connect(&context().controller, &Controller::deviceChanged, this, &PlotsPanel::updateDevice);
    connect(&context().deviceSettings, &DeviceSettings::parameterChanged, this,
            &PlotsPanel::updateLimits);
    connect(&context().deviceSettings, &DeviceSettings::forgotten, this, &PlotsPanel::updateLimits);
}

void PlotsPanel::onLayoutChanged()
{
    std::vector<const PlotView*> plots;
    for (const PlotPane* pane : m_stack->panes()) {
        plots.push_back(&pane->plot());
    }
    m_measurement->setPlots(std::move(plots));
    m_trigger->setSources(m_stack->visibleCurves());
    updateTrigger();
    updateWish();
    m_saveLayout.start();
}

void PlotsPanel::updateDevice()
{
    const LinkState state = context().controller.state();
    m_timeline->setLive(state == LinkState::Connected || state == LinkState::Lost
                        || state == LinkState::Retrying);
    m_stack->setAmperesPerCount(amperesPerCount(context().controller.model()));
    updateLimits();
    updateWish();
}

void PlotsPanel::updateLimits()
{
    m_stack->setLimits(currentLimits(context().deviceSettings));
}

/// The sources of what is visible; a trigger waits for its own even while nobody looks.
void PlotsPanel::updateWish()
{
    std::array<bool, kPollCount> wanted{};
    for (const CurveSpec& curve : m_stack->visibleCurves()) {
        const StreamRow& row =
            streams()[static_cast<std::size_t>(streamIndex(curve.key.toStdString()))];
        const bool isWatched = m_trigger->isOn() && m_trigger->source() == curve.key;
        if (const auto poll = row.source.poll(); poll && (isVisible() || isWatched)) {
            wanted.at(static_cast<std::size_t>(*poll)) = true;
        }
    }
    for (const PollRow& poll : kPolls) {
        const bool isWanted = wanted.at(static_cast<std::size_t>(poll.id));
        context().controller.want(this, poll.id, isWanted ? poll.hertz : 0.0);
    }
}

void PlotsPanel::updateTrigger()
{
    m_stack->setTrigger(m_trigger->source(), m_trigger->level(), m_trigger->crossing());
    alignRuns();
    updateAnchors();
    updateWish();
}

void PlotsPanel::alignRuns()
{
    const QString source = m_trigger->source();
    if (m_references->alignment() != Alignment::Trigger || source.isEmpty()) {
        return;
    }
    std::vector<std::pair<int, std::optional<Instant>>> found;
    for (const PlotReferences::Run& run : m_references->runs()) {
        const TimeSeries& series = run.store->series(streamIndex(source.toStdString()));
        found.emplace_back(
            run.id, firstCrossing(series, m_trigger->scale(), m_trigger->settings(), run.origin));
    }
    for (const auto& [id, crossing] : found) {
        m_references->setTrigger(id, crossing);
    }
}

/// Where the run that is looked at has the moments that others are laid on.
void PlotsPanel::updateAnchors()
{
    if (m_references->runs().empty()) {
        return;
    }
    const TelemetryStore& store = context().store;
    const Alignment alignment = m_references->alignment();
    std::optional<Instant> anchor;
    switch (alignment) {
    case Alignment::View:
        // Standing still, it stays with what it lies on: looking closer moves both.
        if (!m_timeline->isPaused() || !m_viewAnchor) {
            m_viewAnchor = m_timeline->from();
        }
        anchor = m_viewAnchor;
        break;
    case Alignment::Start:
        anchor = store.start();
        break;
    case Alignment::Trigger:
        anchor = m_trigger->crossing();
        if (!anchor && !m_trigger->source().isEmpty()) { // switched off: the first in sight
            const TimeSeries& series = store.series(streamIndex(m_trigger->source().toStdString()));
            anchor = firstCrossing(series, m_trigger->scale(), m_trigger->settings(),
                                   m_timeline->from());
        }
        break;
    case Alignment::Command:
        if (m_timeline->isPaused()) {
            anchor = lastCommandStep(store, m_timeline->from() + m_timeline->span());
            break;
        }
        if (std::exchange(m_clears, store.clears()) != store.clears() || !m_searchedTo) {
            m_lastStep = lastCommandStep(store, m_timeline->now());
        } else {
            for (auto step = firstCommandStep(store, *m_searchedTo); step;
                 step = firstCommandStep(store, *step + TimeAxis::kTick)) {
                m_lastStep = step;
            }
        }
        m_searchedTo = m_timeline->lastSample();
        anchor = m_lastStep;
        break;
    }
    m_references->setAnchor(alignment, anchor);
}

void PlotsPanel::onTick()
{
    m_trigger->advance(amperesPerCount(context().controller.model()));
    if (!isVisible()) {
        return;
    }
    updateAnchors();
    if (++m_ticks % kTicksBetweenValues == 0) {
        m_stack->showValues();
    }
}

void PlotsPanel::toggleCursors(bool on)
{
    if (!on) {
        m_timeline->clearCursors();
        return;
    }
    const TimeRange range = m_timeline->range();
    const Duration third = (range.to - range.from) / 3;
    m_timeline->setActiveCursor(0);
    m_timeline->setCursor(0, range.from + third);
    m_timeline->setCursor(1, range.to - third);
}

void PlotsPanel::freeze()
{
    const TimeRange range = m_timeline->range();
    auto copy = copyOf(context().store, range.from, range.to);
    m_viewAnchor = range.from;
    m_references->add(std::move(copy), tr("Frozen view %1").arg(++m_frozen), range.from,
                      amperesPerCount(context().controller.model()));
}

void PlotsPanel::showEvent(QShowEvent* event)
{
    Panel::showEvent(event);
    updateWish();
}

void PlotsPanel::hideEvent(QHideEvent* event)
{
    Panel::hideEvent(event);
    updateWish();
}

} // namespace trex
