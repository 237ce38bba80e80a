// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/recording/recordingtimeline.h"

#include "protocol/storage/recordingplayer.h"
#include "widgets/common/theme.h"

#include <QEvent>
#include <QHelpEvent>
#include <QKeyEvent>
#include <QMouseEvent>
#include <QPainter>
#include <QTextDocument>
#include <QToolTip>

namespace trex {

using namespace Qt::Literals::StringLiterals;

namespace {

constexpr int kMargin = 12;
constexpr int kEventsHeight = 10;
constexpr int kHeight = 64;
constexpr double kTicksPerSecond = std::chrono::seconds(1) / TimeAxis::kTick;
constexpr std::array<std::string_view, 2> kCurves{"motor1-current", "motor2-current"};
constexpr std::array kColours{ColourRole::Motor1, ColourRole::Motor2};
constexpr double kKeyPart = 0.01; ///< of the whole, a key

ColourRole colourOf(int severity)
{
    return severity == 2 ? ColourRole::Fault
        : severity == 1  ? ColourRole::Warning
                         : ColourRole::DimText;
}

/// What a person asks "what happened then" for; sentences of the log repeat it.
bool isShown(const RecordedEvent& event)
{
    return event.severity > 0 || (event.kind != "log"_L1 && event.kind != "order"_L1);
}

} // namespace

RecordingTimeline::RecordingTimeline(RecordingPlayer& player, QWidget* parent)
    : QWidget(parent), m_player(player)
{
    setFocusPolicy(Qt::StrongFocus);
    setMouseTracking(false);
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
    setToolTip(tr("Drag to move the playhead. Keys: Left, Right, Home, End."));
    connect(&player, &RecordingPlayer::moved, this, [this] { update(); });
    connect(&player.loader(), &RecordingLoader::progressed, this, [this] { update(); });
    connect(&player.loader(), &RecordingLoader::finished, this, [this] {
        collect();
        update();
    });
}

QSize RecordingTimeline::sizeHint() const
{
    return {600, kHeight};
}

double RecordingTimeline::seconds() const
{
    return static_cast<double>(m_player.playhead() - m_player.first()) / kTicksPerSecond;
}

void RecordingTimeline::setSeconds(double seconds)
{
    const double wanted = std::clamp(seconds, 0.0, length());
    m_player.seek(m_player.first() + static_cast<Tick>(wanted * kTicksPerSecond));
}

double RecordingTimeline::length() const
{
    return static_cast<double>(m_player.last() - m_player.first()) / kTicksPerSecond;
}

QRectF RecordingTimeline::strip() const
{
    return QRectF(rect()).adjusted(kMargin, 4, -kMargin, -4);
}

double RecordingTimeline::xOf(Tick tick) const
{
    const auto whole = static_cast<double>(std::max<Tick>(m_player.last() - m_player.first(), 1));
    return strip().left() + static_cast<double>(tick - m_player.first()) / whole * strip().width();
}

Tick RecordingTimeline::tickAt(double x) const
{
    const double part = std::clamp((x - strip().left()) / strip().width(), 0.0, 1.0);
    const auto whole = static_cast<double>(m_player.last() - m_player.first());
    return m_player.first() + static_cast<Tick>(part * whole);
}

// ---- what is drawn

void RecordingTimeline::collect()
{
    m_highest = 1;
    for (int curve = 0; curve < static_cast<int>(kCurves.size()); ++curve) {
        m_columns.at(static_cast<std::size_t>(curve))
            .assign(static_cast<std::size_t>(std::max(1.0, strip().width())), {});
        m_joined.at(static_cast<std::size_t>(curve))
            .assign(m_columns.at(static_cast<std::size_t>(curve)).size(), -1);
        if (m_player.loader().isFinished()) {
            collectFromStore(curve);
        } else {
            collectFromSummaries(curve);
        }
        for (const Extent& extent : m_columns.at(static_cast<std::size_t>(curve))) {
            m_highest = extent.isEmpty() ? m_highest : std::max(m_highest, extent.high);
        }
    }
    collectEvents();
}

void RecordingTimeline::collectEvents()
{
    m_worst.assign(m_columns.front().size(), -1);
    for (const RecordedEvent& event : m_player.history().events()) {
        const double x = xOf(event.tick) - strip().left();
        if (isShown(event) && x >= 0.0) {
            const auto last = static_cast<double>(m_worst.size() - 1);
            int& place = m_worst[static_cast<std::size_t>(std::min(x, last))];
            place = std::max(place, event.severity);
        }
    }
}

void RecordingTimeline::collectFromStore(int curve)
{
    auto& columns = m_columns.at(static_cast<std::size_t>(curve));
    const TimeSeries& series = m_player.store().series(kCurves.at(static_cast<std::size_t>(curve)));
    const Tick whole = m_player.last() - m_player.first() + 1;
    const auto count = static_cast<Tick>(columns.size());
    auto& joined = m_joined.at(static_cast<std::size_t>(curve));
    int lastColumn = -1;
    std::size_t lastSample = 0;
    for (Tick i = 0; i < count; ++i) {
        const auto [begin, end] =
            series.range(RecordingPlayer::instantOf(m_player.first() + whole * i / count),
                         RecordingPlayer::instantOf(m_player.first() + whole * (i + 1) / count));
        columns[static_cast<std::size_t>(i)] = series.extent(begin, end);
        if (begin < end) { // a gap is not bridged
            const bool isGap = lastColumn >= 0 && series.axis().hasGapBetween(lastSample, begin);
            joined[static_cast<std::size_t>(i)] = isGap ? -1 : lastColumn;
            lastColumn = static_cast<int>(i);
            lastSample = end - 1;
        }
    }
}

void RecordingTimeline::collectFromSummaries(int curve)
{
    auto& columns = m_columns.at(static_cast<std::size_t>(curve));
    const int stream = streamIndex(kCurves.at(static_cast<std::size_t>(curve)));
    const auto indexOf = [&](Tick tick) {
        const double x = xOf(tick) - strip().left();
        return std::clamp<std::size_t>(static_cast<std::size_t>(std::max(0.0, x)), 0,
                                       columns.size() - 1);
    };
    for (const RecordingSpan& span : m_player.reader().overview(stream)) {
        for (std::size_t i = indexOf(span.first); i <= indexOf(span.last); ++i) {
            columns[i].add(span.extent);
        }
    }
}

void RecordingTimeline::drawCurves(QPainter& painter) const
{
    const QRectF area = strip().adjusted(0, kEventsHeight, 0, -2);
    const auto yOf = [&](double value) {
        return area.bottom() - area.height() * value / std::max(m_highest, 1);
    };
    for (std::size_t curve = 0; curve < kCurves.size(); ++curve) {
        QColor colour = theme::colour(kColours[curve]);
        painter.setPen(QPen(colour, 1.0));
        for (std::size_t i = 0; i < m_columns[curve].size(); ++i) {
            const Extent& extent = m_columns[curve][i];
            if (extent.isEmpty()) {
                continue;
            }
            const double x = area.left() + static_cast<double>(i) + 0.5;
            painter.drawLine(QPointF(x, yOf(extent.low)), QPointF(x, yOf(extent.high) - 0.5));
            const int from = m_joined[curve][i];
            const Extent before =
                from < 0 ? Extent() : m_columns[curve][static_cast<std::size_t>(from)];
            if (!before.isEmpty()) {
                const double middle = (before.low + before.high) / 2.0;
                const double here = std::clamp<double>(middle, extent.low, extent.high);
                painter.drawLine(QPointF(area.left() + from + 0.5, yOf(middle)),
                                 QPointF(x, yOf(here)));
            }
        }
    }
}

/// A tick for each pixel in which something happened, as severe as the worst of it; faults are
/// taller, too.
void RecordingTimeline::drawEvents(QPainter& painter) const
{
    const double top = strip().top();
    for (std::size_t i = 0; i < m_worst.size(); ++i) {
        if (m_worst[i] >= 0) {
            painter.setPen(QPen(theme::colour(colourOf(m_worst[i])), 1.0 + m_worst[i] * 0.5));
            const double x = strip().left() + static_cast<double>(i) + 0.5;
            const double length = kEventsHeight * (m_worst[i] + 1) / 3.0;
            painter.drawLine(QPointF(x, top), QPointF(x, top + length));
        }
    }
}

void RecordingTimeline::drawPlayhead(QPainter& painter) const
{
    const double x = xOf(m_player.playhead());
    const QColor colour = theme::colour(ColourRole::Text);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setPen(QPen(colour, 1.5));
    painter.drawLine(QPointF(x, strip().top()), QPointF(x, strip().bottom()));
    painter.setPen(Qt::NoPen);
    painter.setBrush(colour);
    const double y = strip().top();
    painter.drawPolygon(QPolygonF{{{x - 5, y - 4}, {x + 5, y - 4}, {x, y + 4}}});
}

void RecordingTimeline::paintEvent(QPaintEvent* /*event*/)
{
    if (m_columns.front().empty()) {
        collect();
    }
    QPainter painter(this);
    painter.fillRect(strip(), theme::colour(ColourRole::Panel));
    drawCurves(painter);
    drawEvents(painter);
    if (!m_player.loader().isFinished()) { // what is not there yet looks so
        QRectF rest = strip();
        rest.setLeft(rest.left() + rest.width() * m_player.loader().progress());
        painter.fillRect(rest, QBrush(theme::colour(ColourRole::Stale), Qt::BDiagPattern));
    }
    painter.setPen(hasFocus() ? QPen(theme::colour(ColourRole::Accent), 2.0)
                              : QPen(theme::colour(ColourRole::Border), 1.0));
    painter.setBrush(Qt::NoBrush);
    painter.drawRect(strip());
    drawPlayhead(painter);
}

void RecordingTimeline::resizeEvent(QResizeEvent* event)
{
    QWidget::resizeEvent(event);
    collect();
}

void RecordingTimeline::changeEvent(QEvent* event)
{
    QWidget::changeEvent(event);
    if (event->type() == QEvent::PaletteChange) {
        update();
    }
}

// ---- moving the playhead

void RecordingTimeline::mousePressEvent(QMouseEvent* event)
{
    if (event->button() == Qt::LeftButton) {
        m_player.seek(tickAt(event->position().x()));
    }
}

void RecordingTimeline::mouseMoveEvent(QMouseEvent* event)
{
    if (event->buttons().testFlag(Qt::LeftButton)) {
        m_player.seek(tickAt(event->position().x()));
    }
}

void RecordingTimeline::keyPressEvent(QKeyEvent* event)
{
    const auto step =
        static_cast<Tick>(static_cast<double>(m_player.last() - m_player.first()) * kKeyPart);
    switch (event->key()) {
    case Qt::Key_Left:
        m_player.seek(m_player.playhead() - step);
        break;
    case Qt::Key_Right:
        m_player.seek(m_player.playhead() + step);
        break;
    case Qt::Key_Home:
        m_player.seek(m_player.first());
        break;
    case Qt::Key_End:
        m_player.seek(m_player.last());
        break;
    default:
        QWidget::keyPressEvent(event);
    }
}

QString RecordingTimeline::textAt(double x) const
{
    constexpr double kNear = 3.0;
    constexpr int kMost = 12;
    QStringList lines;
    const RecordingHistory& history = m_player.history();
    for (std::size_t i = history.eventsUpTo(tickAt(x - kNear) - 1);
         i < history.eventsUpTo(tickAt(x + kNear)) && lines.size() < kMost; ++i) {
        const RecordedEvent& event = history.events()[i];
        if (event.kind == "log"_L1) {
            lines << event.text;
        }
    }
    return lines.isEmpty() ? QString() : Qt::convertFromPlainText(lines.join(u'\n'));
}

bool RecordingTimeline::event(QEvent* event)
{
    if (event->type() == QEvent::ToolTip) {
        auto* help = static_cast<QHelpEvent*>(event);
        const QString text = textAt(help->pos().x());
        QToolTip::showText(help->globalPos(), text.isEmpty() ? toolTip() : text, this);
        return true;
    }
    return QWidget::event(event);
}

} // namespace trex
