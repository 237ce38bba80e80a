// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/recording/playbar.h"

#include "protocol/storage/recordingplayer.h"
#include "widgets/common/frameticker.h"
#include "widgets/common/panel.h"
#include "widgets/common/theme.h"
#include "widgets/recording/recordings.h"
#include "widgets/recording/recordingtimeline.h"

#include <QAction>
#include <QComboBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QToolButton>
#include <QVBoxLayout>

namespace trex {

using namespace Qt::Literals::StringLiterals;

namespace {

constexpr std::array kSpeeds{0.1, 0.25, 0.5, 1.0, 2.0, 5.0, 10.0, 60.0, 600.0};
constexpr qsizetype kUsualSpeed = 3;

Instant clockNow()
{
    return std::chrono::steady_clock::now();
}

/// "00:12:31.250"
QString timeText(Tick ticks)
{
    const auto ms = std::chrono::duration_cast<std::chrono::milliseconds>(ticks * TimeAxis::kTick);
    return recordingTimeText(ms) + u".%1"_s.arg(ms.count() % 1000, 3, 10, '0'_L1);
}

} // namespace

PlayBar::PlayBar(RecordingPlayer& player, FrameTicker& ticker, QWidget* parent)
    : QWidget(parent)
    , m_player(player)
    , m_speed(named(new QComboBox(this), u"recording.speed"_s, tr("Speed of play")))
    , m_time(named(new QLabel(this), u"recording.time"_s, tr("Time at the playhead")))
    , m_clock(named(new QLabel(this), u"recording.clock"_s, tr("Date and time at the playhead")))
    , m_timeline(named(new RecordingTimeline(player, this), u"recording.timeline"_s,
                       tr("The whole recording and the playhead")))
{
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 4, 0, 4);
    layout->setSpacing(4);
    makeActions();
    layout->addWidget(m_timeline);
    connect(&ticker, &FrameTicker::tick, this, [this] { m_player.advance(clockNow()); });
    connect(&player, &RecordingPlayer::moved, this, &PlayBar::refreshTime);
    connect(&player, &RecordingPlayer::playingChanged, this, &PlayBar::refresh);
    connect(&player.loader(), &RecordingLoader::progressed, this, &PlayBar::refreshTime);
    refresh();
    refreshTime();
}

QAction* PlayBar::addAction(QHBoxLayout& row, const QString& part, const QString& text,
                            const QString& icon, const QKeySequence& key,
                            const std::function<void()>& triggered)
{
    auto* action = new QAction(theme::icon(icon), text, this);
    action->setObjectName(u"action.recording."_s + part);
    action->setShortcut(key);
    action->setToolTip(
        u"%1 (%2)"_s.arg(QString(text).remove(u'&'), key.toString(QKeySequence::NativeText)));
    connect(action, &QAction::triggered, this, triggered);
    m_actions << action;
    auto* button = named(new QToolButton(this), u"recording."_s + part, QString(text).remove(u'&'));
    button->setDefaultAction(action);
    button->setIconSize({20, 20});
    button->setFocusPolicy(Qt::TabFocus);
    row.addWidget(button);
    return action;
}

void PlayBar::makeActions()
{
    auto* row = new QHBoxLayout;
    row->setContentsMargins(12, 0, 12, 0);
    row->setSpacing(4);
    addAction(*row, u"previousEvent"_s, tr("Previous &event"), u"event-back"_s,
              Qt::CTRL | Qt::SHIFT | Qt::Key_Left, [this] { m_player.stepEvent(-1); });
    addAction(*row, u"back"_s, tr("Sample &back"), u"step-back"_s, Qt::ALT | Qt::Key_Left,
              [this] { m_player.stepSample(-1); });
    m_play = addAction(*row, u"play"_s, tr("&Play"), u"play"_s, Qt::CTRL | Qt::Key_Space,
                       [this] { togglePlay(); });
    addAction(*row, u"forward"_s, tr("Sample &forward"), u"step-forward"_s, Qt::ALT | Qt::Key_Right,
              [this] { m_player.stepSample(1); });
    addAction(*row, u"nextEvent"_s, tr("&Next event"), u"event-forward"_s,
              Qt::CTRL | Qt::SHIFT | Qt::Key_Right, [this] { m_player.stepEvent(1); });
    row->addSpacing(8);
    addSpeeds();
    row->addWidget(m_speed);
    row->addSpacing(8);
    for (QLabel* label : {m_time, m_clock}) {
        label->setFont(theme::font(1.0, true));
        label->setTextFormat(Qt::PlainText);
    }
    row->addWidget(m_time);
    row->addStretch(1);
    row->addWidget(m_clock);
    static_cast<QVBoxLayout*>(layout())->addLayout(row);
}

void PlayBar::addSpeeds()
{
    for (const double speed : kSpeeds) {
        m_speed->addItem(u"× %1"_s.arg(speed), speed);
    }
    m_speed->setCurrentIndex(kUsualSpeed);
    m_speed->setToolTip(tr("How fast the recording is played"));
    connect(m_speed, &QComboBox::currentIndexChanged, this,
            [this] { m_player.setSpeed(m_speed->currentData().toDouble(), clockNow()); });
}

void PlayBar::togglePlay()
{
    if (m_player.isPlaying()) {
        m_player.pause();
    } else {
        m_player.play(clockNow());
    }
}

void PlayBar::refresh()
{
    const bool isPlaying = m_player.isPlaying();
    m_play->setText(isPlaying ? tr("&Pause") : tr("&Play"));
    m_play->setIcon(theme::icon(isPlaying ? u"pause"_s : u"play"_s));
}

void PlayBar::refreshTime()
{
    QString time = tr("%1 of %2")
                       .arg(timeText(m_player.playhead() - m_player.first()),
                            timeText(m_player.last() - m_player.first()));
    if (!m_player.loader().isFinished()) {
        time += u" · "_s + tr("loading, %1 %").arg(qRound(m_player.loader().progress() * 100.0));
    }
    m_time->setText(time);
    const QDateTime clock = m_player.wallClock();
    const QString armed = m_player.wasArmed() ? tr("armed then") : tr("disarmed then");
    m_clock->setText(clock.isValid()
                         ? u"%1 · %2"_s.arg(armed, clock.toString(u"yyyy-MM-dd HH:mm:ss.zzz"_s))
                         : armed);
}

} // namespace trex
