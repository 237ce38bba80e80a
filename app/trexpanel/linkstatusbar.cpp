// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/trexpanel/linkstatusbar.h"

#include "protocol/session/controller.h"
#include "protocol/session/linkfigures.h"
#include "widgets/common/frameticker.h"
#include "widgets/common/theme.h"

#include <QLabel>
#include <QPainter>

namespace trex {

using namespace Qt::Literals::StringLiterals;

namespace {

constexpr int kTicksBetween = 15; ///< half a second: figures that can be read
constexpr double kWorthTelling = 0.9; ///< part of the asked rate below which it is told

StateShape shapeOf(LinkState state)
{
    switch (state) {
    case LinkState::Connected:
        return StateShape::Ok;
    case LinkState::Connecting:
        return StateShape::Stale;
    case LinkState::Lost:
        return StateShape::Fault;
    case LinkState::Retrying:
        return StateShape::Warning;
    case LinkState::Disconnected:
        break;
    }
    return StateShape::Off;
}

QString textOf(LinkState state)
{
    switch (state) {
    case LinkState::Connected:
        return LinkStatusBar::tr("connected");
    case LinkState::Connecting:
        return LinkStatusBar::tr("connecting");
    case LinkState::Lost:
        return LinkStatusBar::tr("link lost");
    case LinkState::Retrying:
        return LinkStatusBar::tr("link lost, trying again");
    case LinkState::Disconnected:
        break;
    }
    return LinkStatusBar::tr("disconnected");
}

} // namespace

/// The state's shape, beside its word.
class LinkStatusBar::StateLamp : public QWidget {
public:
    explicit StateLamp(QWidget* parent) : QWidget(parent) { setFixedSize(16, 16); }
    void show(StateShape shape)
    {
        m_shape = shape;
        update();
    }

protected:
    void paintEvent(QPaintEvent* /*event*/) override
    {
        QPainter painter(this);
        painter.setRenderHint(QPainter::Antialiasing);
        drawStateShape(painter, QRectF(rect()).adjusted(2, 2, -2, -2), m_shape);
    }

private:
    StateShape m_shape = StateShape::Off;
};

LinkStatusBar::LinkStatusBar(PanelContext& context, QWidget* parent)
    : QStatusBar(parent)
    , m_controller(context.controller)
    , m_lamp(new StateLamp(this))
    , m_state(named(new QLabel(this), u"mainWindow.linkState"_s, tr("State of the link")))
    , m_rate(named(new QLabel(this), u"mainWindow.rate"_s, tr("Transactions a second")))
    , m_roundTrip(named(new QLabel(this), u"mainWindow.roundTrip"_s, tr("Round trip")))
    , m_errors(named(new QLabel(this), u"mainWindow.errors"_s, tr("Errors of the link")))
    , m_tooSlow(named(new QLabel(this), u"mainWindow.tooSlow"_s, tr("Rates that the line allows")))
{
    setSizeGripEnabled(false);
    setContentsMargins(8, 0, 8, 0);
    addWidget(m_lamp);
    for (QLabel* label : {m_state, m_rate, m_roundTrip, m_errors, m_tooSlow}) {
        label->setFont(theme::font(1.0, true));
        label->setTextFormat(Qt::PlainText);
        addWidget(label);
        label->setContentsMargins(0, 0, 16, 0);
    }
    connect(&context.ticker, &FrameTicker::tick, this, &LinkStatusBar::onTick);
    connect(&m_controller, &Controller::stateChanged, this, &LinkStatusBar::refresh);
    refresh();
}

void LinkStatusBar::onTick()
{
    if (++m_ticks >= kTicksBetween) {
        m_ticks = 0;
        refresh();
    }
}

void LinkStatusBar::refresh()
{
    const LinkState state = m_controller.state();
    const LinkStats& stats = m_controller.stats();
    m_lamp->show(shapeOf(state));
    m_state->setText(textOf(state));
    const bool isOn = state == LinkState::Connected;
    m_rate->setVisible(isOn);
    m_roundTrip->setVisible(isOn);
    m_errors->setVisible(state != LinkState::Disconnected);
    m_tooSlow->setVisible(isOn);
    m_rate->setText(tr("%1 transactions/s").arg(qRound(stats.transactionsPerSecond), 4));
    m_roundTrip->setText(tr("%1 ms").arg(stats.roundTripMs, 5, 'f', 1));
    const quint64 errors = stats.timeouts + stats.crcErrors + stats.badReplies;
    m_errors->setText(tr("%n error(s)", nullptr, static_cast<int>(errors)));
    m_errors->setToolTip(
        tr("No reply in time: %1\nReply failed its CRC: %2\nImplausible reply: %3\n"
           "Asked again: %4\nLate or foreign bytes dropped: %5")
            .arg(stats.timeouts)
            .arg(stats.crcErrors)
            .arg(stats.badReplies)
            .arg(stats.retries)
            .arg(stats.surplusBytes));
    m_tooSlow->setText(tooSlowText());
}

QString LinkStatusBar::tooSlowText() const
{
    const LinkStats& stats = m_controller.stats();
    if (stats.pollScale >= 1.0) {
        return {};
    }
    for (std::size_t i = 0; i < stats.askedHertz.size(); ++i) {
        const double asked = stats.askedHertz.at(i);
        if (asked > 0 && stats.achievedHertz.at(i) < asked * kWorthTelling) {
            return tr("line too slow: %1 %2 of %3 Hz")
                .arg(pollText(static_cast<PollId>(i)))
                .arg(qRound(stats.achievedHertz.at(i)))
                .arg(qRound(asked));
        }
    }
    return {};
}

} // namespace trex
