// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/channels/channelspanel.h"

#include "protocol/session/controller.h"
#include "protocol/session/devicesettings.h"
#include "protocol/telemetry/telemetrystore.h"
#include "widgets/channels/channelbar.h"
#include "widgets/common/frameticker.h"
#include "widgets/common/theme.h"

#include <QEvent>
#include <QGridLayout>
#include <QLabel>
#include <QPushButton>

namespace trex {

using namespace std::chrono_literals;
using namespace Qt::Literals::StringLiterals;

namespace {

constexpr auto kStaleAfter = 1s;
constexpr int kRowSpacing = 8;

/// What each channel is for (facts.md 5.4). Whether the mix jumper is on, no command tells.
constexpr std::array<const char*, kChannelCount> kRoles{
    QT_TRANSLATE_NOOP("trex::ChannelsPanel", "Motor 1, or turn"),
    QT_TRANSLATE_NOOP("trex::ChannelsPanel", "Motor 2, or forward"),
    QT_TRANSLATE_NOOP("trex::ChannelsPanel", "Auxiliary motor"),
    QT_TRANSLATE_NOOP("trex::ChannelsPanel", "Flip switch"),
    QT_TRANSLATE_NOOP("trex::ChannelsPanel", "Serial override"),
};
constexpr std::array<const char*, kChannelCount> kRoleHelps{
    QT_TRANSLATE_NOOP("trex::ChannelsPanel",
                      "Drives motor 1; with the mix jumper on, steers both motors."),
    QT_TRANSLATE_NOOP("trex::ChannelsPanel",
                      "Drives motor 2; with the mix jumper on, drives both motors."),
    QT_TRANSLATE_NOOP("trex::ChannelsPanel", "Speed of the auxiliary motor, in one direction."),
    QT_TRANSLATE_NOOP("trex::ChannelsPanel",
                      "Low: the robot is upside down; motors and directions swap."),
    QT_TRANSLATE_NOOP("trex::ChannelsPanel",
                      "Low: serial commands drive the motors instead of the channels."),
};

void setColour(QWidget* widget, const QColor& colour)
{
    QPalette palette = widget->palette();
    // A label writes in one or the other, by the background that its panel gives it.
    palette.setColor(QPalette::WindowText, colour);
    palette.setColor(QPalette::Text, colour);
    widget->setPalette(palette);
}

bool isFresh(const PollSample* sample, Instant now)
{
    return sample != nullptr && now - sample->time <= kStaleAfter;
}

/// "−12": a true minus, as wide as the digits beside it.
QString signedText(int number)
{
    return number < 0 ? u"−%1"_s.arg(-number) : QString::number(number);
}

} // namespace

ChannelsPanel::ChannelsPanel(PanelContext& panelContext, QWidget* parent)
    : Panel(panelContext, parent)
    , m_input(new QLabel(this))
    , m_calibrate(named(new QPushButton(theme::icon(u"calibrate"_s), tr("Calibrate…"), this),
                        u"channels.calibrate"_s, tr("Calibrate the channels")))
{
    setObjectName(u"channels"_s);
    auto* grid = new QGridLayout(this);
    grid->setContentsMargins(8, 8, 8, 8);
    grid->setHorizontalSpacing(8);
    grid->setVerticalSpacing(2);
    grid->setColumnStretch(1, 1);
    for (int channel = 1; channel <= kChannelCount; ++channel) {
        addRow(grid, channel);
    }
    const int last = grid->rowCount();
    grid->setRowStretch(last, 1);
    auto* footer = new QHBoxLayout;
    footer->addWidget(m_input, 1);
    footer->addWidget(m_calibrate);
    grid->addLayout(footer, last + 1, 0, 1, 4);
    m_calibrate->setVisible(!panelContext.controller.isRecording());
    connect(m_calibrate, &QPushButton::clicked, this,
            [this] { emit panelRequested(u"calibration"_s); });

    connect(&context().ticker, &FrameTicker::tick, this, &ChannelsPanel::updateValues);
    connect(&context().controller, &Controller::stateChanged, this, &ChannelsPanel::updateDevice);
    connect(&context().controller, &Controller::deviceChanged, this, &ChannelsPanel::updateDevice);
    connect(&context().deviceSettings, &DeviceSettings::forgotten, this,
            &ChannelsPanel::updateDevice);
    connect(&context().deviceSettings, &DeviceSettings::calibrationChanged, this,
            &ChannelsPanel::updateDevice);
    applyTheme();
    updateDevice();
    updateValues();
}

ChannelsPanel::~ChannelsPanel()
{
    context().controller.wantNothing(this);
}

void ChannelsPanel::addRow(QGridLayout* grid, int channel)
{
    const auto index = static_cast<std::size_t>(channel - 1);
    const QString prefix = u"channels.%1."_s.arg(channel);
    Row& row = m_rows[index];
    row.number = new QLabel(QString::number(channel), this);
    row.role = new QLabel(tr(kRoles[index]), this);
    row.role->setToolTip(tr(kRoleHelps[index]));
    row.learned =
        named(new QLabel(this), prefix + u"learned"_s, tr("Channel %1 learned").arg(channel));
    row.text = named(new QLabel(this), prefix + u"text"_s, tr("Channel %1 input").arg(channel));
    row.text->setAlignment(Qt::AlignRight | Qt::AlignVCenter);
    row.bar = named(new ChannelBar(channel, this), prefix + u"bar"_s);
    row.remapped =
        named(new QLabel(this), prefix + u"remapped"_s, tr("Channel %1 remapped").arg(channel));
    row.text->setText(row.bar->text());
    row.remapped->setText(u"–"_s);
    row.remapped->setAlignment(Qt::AlignRight | Qt::AlignVCenter);
    row.remapped->setToolTip(tr("Remapped value, −127 to 127: what the motor would be told"));

    const int top = grid->rowCount();
    if (channel > 1) {
        grid->setRowMinimumHeight(top, kRowSpacing);
    }
    grid->addWidget(row.number, top + 1, 0);
    auto* caption = new QHBoxLayout;
    caption->setSpacing(6);
    caption->addWidget(row.role);
    caption->addWidget(row.learned);
    caption->addStretch(1);
    grid->addLayout(caption, top + 1, 1);
    grid->addWidget(row.text, top + 1, 2, 1, 2);
    grid->addWidget(row.bar, top + 2, 0, 1, 3);
    grid->addWidget(row.remapped, top + 2, 3);
}

void ChannelsPanel::applyTheme()
{
    const QFont figures = theme::font(1.0, true);
    QFont bold = theme::font(1.0);
    bold.setBold(true);
    for (std::size_t i = 0; i < m_rows.size(); ++i) {
        const Row& row = m_rows[i];
        row.number->setFont(bold);
        setColour(row.number, theme::channelColour(static_cast<int>(i) + 1));
        setColour(row.role, theme::colour(ColourRole::DimText));
        row.text->setFont(figures);
        row.remapped->setFont(figures);
        row.remapped->setMinimumWidth(
            QFontMetrics(figures).horizontalAdvance(signedText(-kFullSpeed)) + 2);
    }
    setColour(m_input, theme::colour(ColourRole::DimText));
    m_wasFresh = false;
    m_shownRevision = 0;
}

void ChannelsPanel::changeEvent(QEvent* event)
{
    Panel::changeEvent(event);
    if (event->type() == QEvent::PaletteChange && m_calibrate != nullptr) {
        applyTheme();
        updateDevice();
    }
}

void ChannelsPanel::showEvent(QShowEvent* event)
{
    Panel::showEvent(event);
    updateWish();
}

void ChannelsPanel::hideEvent(QHideEvent* event)
{
    Panel::hideEvent(event);
    updateWish();
}

void ChannelsPanel::updateWish()
{
    const double hertz = isVisible() ? kHertz : 0.0;
    context().controller.want(this, PollId::RawChannels, hertz);
    context().controller.want(this, PollId::RemappedChannels, hertz);
}

void ChannelsPanel::updateDevice()
{
    const DeviceInfo& device = context().controller.device();
    const InputKind input = device.mode ? inputOf(*device.mode) : m_rows[0].bar->input();
    const bool isRc = input == InputKind::Rc;
    m_input->setText(!device.mode ? QString() : (isRc ? tr("RC pulses") : tr("Analog voltages")));
    for (std::size_t i = 0; i < m_rows.size(); ++i) {
        const Row& row = m_rows[i];
        const int channel = static_cast<int>(i) + 1;
        row.bar->setInput(input);
        row.bar->setCalibration(context().deviceSettings.calibration(input, channel));
        const bool isKnown = device.learnedMask.has_value();
        const bool isLearned = isKnown && ((*device.learnedMask >> i) & 1U) != 0;
        row.learned->setText(!isKnown ? QString() : (isLearned ? u"✓"_s : u"○"_s));
        row.learned->setToolTip(isLearned ? tr("Learned: calibrated for this transmitter")
                                          : tr("Not learned: the factory's calibration"));
        row.learned->setAccessibleDescription(row.learned->toolTip());
        setColour(row.learned, theme::colour(isLearned ? ColourRole::Ok : ColourRole::DimText));
    }
    readCalibrations();
}

void ChannelsPanel::readCalibrations()
{
    const Controller& controller = context().controller;
    if (m_readsPending > 0 || controller.state() != LinkState::Connected
        || !controller.device().mode) {
        return;
    }
    const InputKind input = inputOf(*controller.device().mode);
    std::vector<int> unknown;
    for (int channel = 1; channel <= kChannelCount; ++channel) {
        if (!context().deviceSettings.calibration(input, channel)) {
            unknown.push_back(channel);
        }
    }
    m_readsPending = static_cast<int>(unknown.size());
    for (const int channel : unknown) {
        context().deviceSettings.readCalibration(
            channel, this, [this](const Result<Calibration>&) { --m_readsPending; });
    }
}

void ChannelsPanel::updateValues()
{
    const PollSample* raw = context().store.latest(PollId::RawChannels);
    const bool isNowFresh = isFresh(raw, context().store.now());
    const bool isNew = context().store.revision() != m_shownRevision || isNowFresh != m_wasFresh;
    if (!isVisible() || !isNew) {
        return;
    }
    m_shownRevision = context().store.revision();
    m_wasFresh = isNowFresh;
    const PollSample* remapped = context().store.latest(PollId::RemappedChannels);
    for (int channel = 1; channel <= kChannelCount; ++channel) {
        updateRow(channel, raw, remapped);
    }
}

void ChannelsPanel::updateRow(int channel, const PollSample* raw, const PollSample* remapped)
{
    const auto index = static_cast<std::size_t>(channel - 1);
    const Row& row = m_rows[index];
    // What a number means, its unit, is known with the mode only.
    const bool isKnown =
        isFresh(raw, context().store.now()) && context().controller.device().mode.has_value();
    if (isKnown) {
        row.bar->setRaw(raw->raw[index]);
    }
    row.bar->setStale(!isKnown);
    const bool hasRemapped = isFresh(remapped, context().store.now());
    if (hasRemapped) {
        row.bar->setRemapped(signedFromRemapped(static_cast<std::uint8_t>(remapped->raw[index])));
    }
    row.text->setText(row.bar->text());
    const bool isInvalid = row.bar->raw() == kInvalidPulse;
    const bool isAbsent = isInvalid || !row.bar->hasRemapped();
    row.remapped->setText(isAbsent ? u"–"_s : signedText(row.bar->remapped()));
    setColour(row.text,
              theme::colour(!isKnown        ? ColourRole::Stale
                                : isInvalid ? ColourRole::Warning
                                            : ColourRole::Text));
    setColour(row.remapped,
              theme::colour(hasRemapped && !isInvalid ? ColourRole::Text : ColourRole::Stale));
}

} // namespace trex
