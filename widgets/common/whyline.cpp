// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/common/whyline.h"

#include "protocol/errortext.h"
#include "protocol/session/devicesettings.h"
#include "protocol/telemetry/statuslatch.h"
#include "protocol/telemetry/telemetrystore.h"
#include "widgets/common/eventlog.h"
#include "widgets/common/panel.h"
#include "widgets/common/theme.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QPainter>
#include <QPushButton>

namespace trex {

using namespace Qt::Literals::StringLiterals;
using namespace std::chrono_literals;

namespace {

constexpr auto kStoppedShown = 5s;
constexpr auto kLook = 250ms;
constexpr int kBitShownMs = 3000; ///< a latched bit is read once, and is worth telling for a while
constexpr int kSettledMs = 1000;
constexpr auto kFresh = 1s; ///< samples older than that say nothing about now
constexpr int kShapeSize = 14;
constexpr int kMargin = 8;

QString remedyText(const MotionReason& reason)
{
    switch (reason.remedy) {
    case MotionRemedy::Connect:
        return WhyLine::tr("Connect");
    case MotionRemedy::Disconnect:
        return WhyLine::tr("Disconnect");
    case MotionRemedy::Arm:
        return WhyLine::tr("Arm");
    case MotionRemedy::Disarm:
        return WhyLine::tr("Disarm");
    case MotionRemedy::Stop:
        return WhyLine::tr("STOP");
    case MotionRemedy::OpenPanel:
        return reason.panel == "channels"_L1 ? WhyLine::tr("Channels")
            : reason.panel == "status"_L1    ? WhyLine::tr("Status")
                                             : WhyLine::tr("Parameters");
    case MotionRemedy::None:
        break;
    }
    return {};
}

StateShape shapeOf(MotionLook look)
{
    switch (look) {
    case MotionLook::Ok:
        return StateShape::Ok;
    case MotionLook::Waiting:
        return StateShape::Stale;
    case MotionLook::Warning:
        return StateShape::Warning;
    case MotionLook::Fault:
        return StateShape::Fault;
    case MotionLook::Off:
        break;
    }
    return StateShape::Off;
}

/// Bits seen a moment ago.
std::uint8_t recentBits(const StatusLatch& latch, StatusLatch::Byte byte)
{
    int bits = 0;
    const QDateTime now = QDateTime::currentDateTime();
    for (int bit = 0; bit < 8; ++bit) {
        const StatusLatch::Entry& entry = latch.entry(byte, bit);
        if (entry.count > 0 && entry.lastSeen.msecsTo(now) < kBitShownMs) {
            bits |= 1 << bit;
        }
    }
    return static_cast<std::uint8_t>(bits);
}

/// A sample that still says something about now.
const PollSample* fresh(const TelemetryStore& store, PollId poll)
{
    const PollSample* sample = store.latest(poll);
    return sample != nullptr && std::chrono::steady_clock::now() - sample->time < kFresh ? sample
                                                                                         : nullptr;
}

} // namespace

WhyLine::WhyLine(PanelContext& context, QWidget* parent)
    : QWidget(parent)
    , m_context(context)
    , m_text(named(new QLabel(this), u"why.text"_s, tr("Why the motors do or do not move")))
    , m_remedy(named(new QPushButton(this), u"why.remedy"_s))
    , m_look(this)
{
    m_text->setTextFormat(Qt::PlainText);
    m_text->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Preferred);
    auto* layout = new QHBoxLayout(this);
    layout->setContentsMargins(kMargin + kShapeSize + kMargin, 4, kMargin, 4);
    layout->addWidget(m_text, 1);
    layout->addWidget(m_remedy);
    for (QTimer* timer : {&m_stoppedFor, &m_lockout}) {
        timer->setSingleShot(true);
        timer->setTimerType(Qt::PreciseTimer); // a coarse one may end before the lockout does
        connect(timer, &QTimer::timeout, this, &WhyLine::refresh);
    }
    listen();
    refresh();
}

void WhyLine::listen()
{
    const Controller& controller = m_context.controller;
    connect(m_remedy, &QPushButton::clicked, this, &WhyLine::onRemedy);
    connect(&controller, &Controller::stateChanged, this, [this](LinkState state) {
        // The first thing that a regained line hears is stop, and a closed one has none to doubt.
        const bool isOver = state == LinkState::Connected || state == LinkState::Disconnected;
        doubtStop(m_isStopDoubtful && !isOver);
    });
    connect(&controller, &Controller::deviceChanged, this, &WhyLine::refresh);
    connect(&controller, &Controller::armedChanged, this, &WhyLine::refresh);
    connect(&controller, &Controller::ordersChanged, this, [this] {
        m_sinceOrder.start();
        refresh();
    });
    connect(&controller, &Controller::stopped, this, [this] { doubtStop(false); });
    connect(&controller, &Controller::stopFailed, this, [this] { doubtStop(true); });
    connect(&controller, &Controller::lockedOut, this, [this] {
        m_stoppedFor.start(kStoppedShown);
        m_lockout.start(Controller::kStopLockout);
        refresh();
    });
    connect(&m_context.latch, &StatusLatch::changed, this, &WhyLine::refresh);
    m_look.setInterval(kLook);
    connect(&m_look, &QTimer::timeout, this, &WhyLine::refresh);
    m_look.start();
}

void WhyLine::doubtStop(bool doubtful)
{
    m_isStopDoubtful = doubtful;
    refresh();
}

QString WhyLine::text() const
{
    return m_text->text();
}

MotionFacts WhyLine::facts() const
{
    const Controller& controller = m_context.controller;
    MotionFacts facts;
    facts.link = controller.state();
    facts.error = controller.lastError();
    facts.port = controller.options().port;
    facts.wasConnected = m_wasConnected;
    facts.isArmed = controller.isArmed();
    facts.disarming = controller.gate().lastDisarming();
    facts.isLockedOut = m_lockout.isActive();
    facts.isJustStopped = m_stoppedFor.isActive();
    // A failure is not over by itself; what is asked goes by its records.
    if (m_isStopDoubtful) {
        facts.stop = StopProgress::Failed;
    } else if (facts.isJustStopped && controller.gate().stopProgress() != StopProgress::Failed) {
        facts.stop = controller.gate().stopProgress();
    }
    for (const auto motor : {MotorId::Motor1, MotorId::Motor2, MotorId::Aux}) {
        facts.orders.at(static_cast<std::size_t>(motor)) = controller.lastOrder(motor);
        facts.sent.at(static_cast<std::size_t>(motor)) = controller.sentOrder(motor);
    }
    facts.isSettled = m_sinceOrder.isValid() && m_sinceOrder.hasExpired(kSettledMs);
    facts.isRampingDown = controller.shaper().isRampingDown();
    facts.isProving = controller.isSilent();
    if (facts.link == LinkState::Connected) {
        addDeviceFacts(facts);
    }
    return facts;
}

void WhyLine::addDeviceFacts(MotionFacts& facts) const
{
    facts.mode = m_context.controller.device().mode;
    facts.serialControls = m_context.controller.device().serialControls;
    if (const PollSample* sample = fresh(m_context.store, PollId::RawChannels)) {
        facts.raw = sample->raw;
    }
    if (const PollSample* sample = fresh(m_context.store, PollId::RemappedChannels)) {
        facts.remapped = sample->raw;
    }
    if (const PollSample* sample = fresh(m_context.store, PollId::Currents)) {
        facts.currents = {sample->raw[0], sample->raw[1]};
    }
    facts.status = recentBits(m_context.latch, StatusLatch::Byte::Status);
    facts.uart = recentBits(m_context.latch, StatusLatch::Byte::Uart);
    const DeviceSettings& settings = m_context.deviceSettings;
    const auto value = [&settings](const ParameterRow& row) {
        return settings.isPending(row.number) ? std::nullopt : settings.parameter(row.number);
    };
    if (const auto mode = value(parameterRow("motor-mode"))) {
        facts.isJoint = *mode == 1;
    }
    facts.requiredChannels = value(parameterRow("required-channels"));
    facts.ignoredChannels = value(parameterRow("ignored-channels"));
    facts.uartErrorShutdown = value(parameterRow("uart-error-shutdown"));
    const auto limit1 = value(parameterRow("motor1-current-limit"));
    const auto limit2 = value(parameterRow("motor2-current-limit"));
    if (limit1 && limit2) {
        facts.currentLimits = {*limit1, *limit2};
    }
}

void WhyLine::refresh()
{
    const LinkState state = m_context.controller.state();
    m_wasConnected = state == LinkState::Connected
        || (m_wasConnected && state != LinkState::Disconnected && state != LinkState::Connecting);
    const MotionReason reason = motionReason(facts());
    const bool mayArm = reason.remedy != MotionRemedy::Arm || !m_lockout.isActive();
    m_remedy->setEnabled(mayArm);
    if (reason.sentence == m_reason.sentence && reason.remedy == m_reason.remedy) {
        return;
    }
    m_reason = reason;
    m_text->setText(m_reason.sentence);
    m_text->setToolTip(m_reason.sentence);
    m_remedy->setVisible(m_reason.remedy != MotionRemedy::None);
    m_remedy->setText(remedyText(m_reason));
    m_remedy->setAccessibleDescription(m_reason.sentence);
    update();
}

void WhyLine::onRemedy()
{
    Controller& controller = m_context.controller;
    switch (m_reason.remedy) {
    case MotionRemedy::Connect:
        emit connectRequested();
        break;
    case MotionRemedy::Disconnect:
        controller.close();
        break;
    case MotionRemedy::Disarm:
        controller.disarm();
        break;
    case MotionRemedy::Stop:
        controller.stop();
        break;
    case MotionRemedy::Arm:
        if (const Result<void> armed = controller.arm(); !armed) {
            m_context.log.add(EventLog::Warning, errorText(armed.error()));
        }
        break;
    case MotionRemedy::OpenPanel:
        emit panelRequested(m_reason.panel);
        break;
    case MotionRemedy::None:
        break;
    }
}

void WhyLine::paintEvent(QPaintEvent* /*event*/)
{
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.fillRect(rect(), theme::colour(ColourRole::Panel));
    painter.setPen(theme::colour(ColourRole::Border));
    painter.drawLine(QPointF(0, height() - 0.5), QPointF(width(), height() - 0.5));
    drawStateShape(painter, QRectF(kMargin, (height() - kShapeSize) / 2.0, kShapeSize, kShapeSize),
                   shapeOf(m_reason.look));
}

} // namespace trex
