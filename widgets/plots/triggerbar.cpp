// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/plots/triggerbar.h"

#include "widgets/common/panel.h"
#include "widgets/common/plotticks.h"
#include "widgets/common/plottimeline.h"

#include <QCheckBox>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QSignalBlocker>
#include <QSpinBox>
#include <QToolButton>

#include <algorithm>

namespace trex {

using namespace Qt::Literals::StringLiterals;

namespace {

using Edge = TriggerSettings::Edge;
using Mode = TriggerSettings::Mode;

constexpr int kUsualBefore = 25; ///< per cent
constexpr double kHysteresisCounts = 1.5; ///< of the stream's own steps: its last digit's flicker

constexpr double kLevelStep = 2.5; ///< counts that one click of the level's arrows is

const StreamRow& rowOf(const QString& key)
{
    return streams()[static_cast<std::size_t>(streamIndex(key.toStdString()))];
}

} // namespace

TriggerBar::TriggerBar(PlotTimeline& timeline, QWidget* parent)
    : QWidget(parent)
    , m_timeline(timeline)
    , m_amperesPerCount(amperesPerCount(Model::TrexJr))
    , m_on(named(new QCheckBox(tr("Trigger"), this), u"plots.trigger.on"_s, tr("Trigger")))
    , m_source(named(new QComboBox(this), u"plots.trigger.source"_s, tr("Trigger source")))
    , m_edge(named(new QComboBox(this), u"plots.trigger.edge"_s, tr("Trigger edge")))
    , m_level(named(new QDoubleSpinBox(this), u"plots.trigger.level"_s, tr("Trigger level")))
    , m_mode(named(new QComboBox(this), u"plots.trigger.mode"_s, tr("Trigger mode")))
    , m_before(named(new QSpinBox(this), u"plots.trigger.before"_s, tr("Shown before the trigger")))
    , m_arm(named(new QToolButton(this), u"plots.trigger.arm"_s, tr("Wait again")))
    , m_state(named(new QLabel(this), u"plots.trigger.state"_s, tr("Trigger state")))
{
    build();
    connect(m_on, &QCheckBox::toggled, this, &TriggerBar::arm);
    connect(m_source, &QComboBox::currentIndexChanged, this, &TriggerBar::arm);
    connect(m_edge, &QComboBox::currentIndexChanged, this, &TriggerBar::apply);
    connect(m_mode, &QComboBox::currentIndexChanged, this, &TriggerBar::arm);
    connect(m_level, &QDoubleSpinBox::valueChanged, this, &TriggerBar::apply);
    connect(m_before, &QSpinBox::valueChanged, this, &TriggerBar::apply);
    connect(m_arm, &QToolButton::clicked, this, &TriggerBar::arm);
    connect(&timeline, &PlotTimeline::viewChanged, this, &TriggerBar::apply);
    apply();
}

void TriggerBar::build()
{
    auto* row = new QHBoxLayout(this);
    row->setContentsMargins(4, 0, 4, 0);
    row->setSpacing(6);
    m_edge->addItem(tr("rising"), int(Edge::Rising));
    m_edge->addItem(tr("falling"), int(Edge::Falling));
    m_edge->addItem(tr("both ways"), int(Edge::Both));
    m_mode->addItem(tr("Single"), int(Mode::Single));
    m_mode->addItem(tr("Normal"), int(Mode::Normal));
    m_mode->addItem(tr("Auto"), int(Mode::Auto));
    m_mode->setCurrentIndex(1);
    m_mode->setToolTip(
        tr("Single: the first crossing is held. Normal: each crossing replaces the "
           "one before. Auto: as Normal, but the picture moves on while none comes."));
    m_level->setRange(-1e5, 1e5);
    m_level->setDecimals(2);
    m_level->setValue(1.0);
    m_level->setToolTip(tr("The level; its line in the plot can be dragged"));
    m_before->setRange(0, 95);
    m_before->setSuffix(u" %"_s);
    m_before->setValue(kUsualBefore);
    m_before->setToolTip(tr("How much of the window lies before the crossing"));
    m_arm->setText(tr("Wait again"));
    m_arm->setIcon(theme::icon(u"refresh"_s));
    m_arm->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
    m_arm->setToolTip(tr("Forget what was caught and wait for the next crossing"));
    for (QWidget* widget : std::initializer_list<QWidget*>{m_on, m_source, m_edge, m_level, m_mode,
                                                           m_before, m_arm, m_state}) {
        row->addWidget(widget);
    }
    row->addStretch(1);
    // What is chosen may be cut in a narrow window; the window is not made wider for it.
    for (QComboBox* combo : {m_source, m_edge, m_mode}) {
        combo->setSizeAdjustPolicy(QComboBox::AdjustToContents);
        combo->setMinimumWidth(80);
    }
}

bool TriggerBar::isOn() const
{
    return m_on->isChecked();
}

void TriggerBar::setOn(bool on)
{
    m_on->setChecked(on);
}

QString TriggerBar::source() const
{
    return m_source->currentData().toString();
}

CurveUnit TriggerBar::unit() const
{
    const auto found = std::find_if(m_curves.begin(), m_curves.end(),
                                    [this](const auto& curve) { return curve.key == source(); });
    return found == m_curves.end() ? CurveUnit{} : unitOf(*found, m_amperesPerCount);
}

ValueScale TriggerBar::scale() const
{
    return source().isEmpty() ? ValueScale{} : ValueScale{unit().scale, rowOf(source()).offset};
}

std::optional<double> TriggerBar::level() const
{
    return isOn() && !source().isEmpty() ? std::optional(settings().level) : std::nullopt;
}

std::optional<Instant> TriggerBar::crossing() const
{
    return isOn() ? m_trigger.crossing() : std::nullopt;
}

void TriggerBar::setSources(const std::vector<CurveSpec>& curves)
{
    const QString before = source();
    const double scaleBefore = scale().scale;
    m_curves = curves;
    {
        const QSignalBlocker blocker(m_source);
        m_source->clear();
        for (const CurveSpec& curve : curves) {
            m_source->addItem(titleOf(rowOf(curve.key)), curve.key);
        }
        m_source->setCurrentIndex(std::max(m_source->findData(before), 0));
    }
    if (source() != before || scale().scale != scaleBefore) {
        arm(); // another curve, or its level means something else now
    }
}

void TriggerBar::setLevel(double physical)
{
    m_level->setValue(physical);
}

void TriggerBar::apply()
{
    TriggerSettings settings;
    settings.edge = Edge(m_edge->currentData().toInt());
    settings.mode = Mode(m_mode->currentData().toInt());
    settings.level = m_level->value();
    settings.hysteresis = kHysteresisCounts * scale().scale;
    constexpr int kUsualSeconds = 10;
    const int window = m_timeline.windowSeconds() == PlotTimeline::kWholeSession
        ? kUsualSeconds
        : m_timeline.windowSeconds();
    constexpr int kPercent = 100;
    const Duration shown = std::chrono::seconds(window);
    settings.before = shown * m_before->value() / kPercent;
    settings.after = shown - settings.before;
    if (!source().isEmpty()) {
        const CurveUnit own = unit();
        m_level->setSuffix(own.text.isEmpty() ? QString() : u' ' + own.text);
        m_level->setDecimals(own.decimals);
        m_level->setSingleStep(own.scale * (own.text.isEmpty() ? 1.0 : kLevelStep));
    }
    m_trigger.setSettings(settings);
    for (QWidget* widget :
         std::initializer_list<QWidget*>{m_source, m_edge, m_level, m_mode, m_before, m_arm}) {
        widget->setEnabled(isOn());
    }
    showCapture();
    showState();
    emit changed();
}

void TriggerBar::arm()
{
    m_trigger.arm(m_timeline.now());
    apply();
    if (isOn()) {
        m_timeline.setPaused(false);
    }
}

void TriggerBar::showCapture()
{
    const auto found = crossing();
    if (!found || m_trigger.runsFreely(m_timeline.now())) {
        m_timeline.setCapture({});
    } else {
        m_timeline.setCapture(TimeRange{*found - settings().before, *found + settings().after});
    }
}

void TriggerBar::advance(double amperes)
{
    m_amperesPerCount = amperes;
    if (!isOn() || source().isEmpty()) {
        return;
    }
    const TelemetryStore& store = m_timeline.store();
    if (std::exchange(m_clears, store.clears()) != store.clears()) {
        m_trigger.arm(m_timeline.now());
    }
    const TimeSeries& series = store.series(streamIndex(source().toStdString()));
    const bool isNew = m_trigger.advance(series, scale(), m_timeline.now());
    showCapture();
    showState();
    if (isNew) {
        emit changed();
    }
}

void TriggerBar::showState()
{
    QString text;
    if (isOn()) {
        switch (m_trigger.state()) {
        case Trigger::State::Waiting:
            text = m_trigger.runsFreely(m_timeline.now()) ? tr("Waiting, running freely")
                                                          : tr("Waiting");
            break;
        case Trigger::State::Capturing:
            text = tr("Triggered");
            break;
        case Trigger::State::Holding:
            text = tr("Holding");
            break;
        }
        if (const auto found = m_trigger.crossing()) {
            const std::chrono::duration<double> since = *found - m_timeline.origin();
            text += u" · "_s + ticks::timeLabel(since.count(), 0.01);
        }
    }
    if (m_state->text() != text) {
        m_state->setText(text);
    }
}

} // namespace trex
