// SPDX-License-Identifier: GPL-3.0-or-later
#include "protocol/storage/recordingplayer.h"

#include "protocol/codec/packet.h"
#include "protocol/codec/replyparser.h"

namespace trex {
namespace {

constexpr std::size_t kMostAtOnce = 2000; ///< packets or events told in one go
constexpr double kSlowest = 0.001;
constexpr double kFastest = 100'000.0;

} // namespace

RecordingPlayer::RecordingPlayer(std::unique_ptr<RecordingReader> reader,
                                 const RecordingStage& stage, QObject* parent)
    : QObject(parent)
    , m_reader(std::move(reader))
    , m_stage(stage)
    , m_loader(*m_reader, stage.store, instantOf(0))
    , m_history(*m_reader)
{
    const auto& events = m_history.events();
    if (const auto range = m_reader->range()) {
        std::tie(m_first, m_last) = *range;
    } else if (!events.empty()) {
        m_first = m_last = events.front().tick;
    }
    if (!events.empty()) {
        m_first = std::min(m_first, events.front().tick);
        m_last = std::max(m_last, events.back().tick);
    }
    connect(&m_loader, &RecordingLoader::finished, this, [this] { show(true); });
    m_playhead = m_last;
    show(true);
}

RecordingPlayer::~RecordingPlayer() = default;

QDateTime RecordingPlayer::wallClock() const
{
    constexpr qint64 kTicksPerMs = std::chrono::milliseconds(1) / TimeAxis::kTick;
    return m_reader->started().addMSecs(m_playhead / kTicksPerMs).toLocalTime();
}

void RecordingPlayer::seek(Tick tick)
{
    const Tick before = std::exchange(m_playhead, std::clamp(tick, m_first, m_last));
    if (m_playedFrom) {
        m_playedFrom->tick += m_playhead - before;
    }
    show(m_playhead < before);
}

// ---- running

void RecordingPlayer::play(Instant now)
{
    if (m_playhead >= m_last) {
        seek(m_first);
    }
    m_playedFrom = Start{m_playhead, now};
    emit playingChanged(true);
}

void RecordingPlayer::pause()
{
    if (m_playedFrom) {
        m_playedFrom.reset();
        emit playingChanged(false);
    }
}

void RecordingPlayer::setSpeed(double speed, Instant now)
{
    advance(now);
    m_speed = std::clamp(speed, kSlowest, kFastest);
    if (m_playedFrom) {
        m_playedFrom = Start{m_playhead, now};
    }
}

void RecordingPlayer::advance(Instant now)
{
    if (!m_playedFrom) {
        return;
    }
    const auto ticks = static_cast<double>((now - m_playedFrom->time) / TimeAxis::kTick) * m_speed;
    const auto left = static_cast<double>(m_last - m_playedFrom->tick);
    if (ticks >= left) {
        seek(m_last);
        pause();
    } else {
        m_playhead = m_playedFrom->tick + static_cast<Tick>(ticks);
        show(false);
    }
}

// ---- stepping

void RecordingPlayer::stepSample(int direction)
{
    std::optional<Tick> target;
    for (const StreamRow& row : streams()) {
        const TimeAxis& axis = m_stage.store.series(row.key).axis();
        if (direction > 0) {
            const std::size_t next = axis.lowerBound(m_playhead + 1);
            if (next < axis.size()) {
                target = std::min(target.value_or(axis.tick(next)), axis.tick(next));
            }
        } else {
            const std::size_t end = axis.lowerBound(m_playhead);
            if (end > 0) {
                target = std::max(target.value_or(axis.tick(end - 1)), axis.tick(end - 1));
            }
        }
    }
    pause();
    if (target) {
        seek(*target);
    }
}

void RecordingPlayer::stepEvent(int direction)
{
    pause();
    const auto target =
        direction > 0 ? m_history.nextEvent(m_playhead) : m_history.previousEvent(m_playhead);
    if (target) {
        seek(*target);
    }
}

// ---- showing

void RecordingPlayer::show(bool isJump)
{
    const RecordingHistory::Moment moment = m_history.at(m_playhead);
    m_stage.store.standAt(instantOf(m_playhead), instantOf(moment.lostAt));
    m_latch.follow(m_stage.store);
    m_stage.latch.show(m_latch.shownAt(m_stage.store, m_playhead, wallClock()));
    m_wasArmed = moment.isArmed;
    RecordedState state = moment.state;
    state.orders = orders(moment.lostAt);
    if (m_stage.controller.state() != state.link) {
        m_shownConfiguration.reset(); // the settings are forgotten with the link
    }
    if (isJump) {
        m_stage.controller.showRecords({}, true);
    }
    m_stage.controller.show(state);
    if (state.link == LinkState::Connected) {
        showSettings(moment.configuration);
    }
    showPackets(isJump);
    tellEvents(isJump);
    emit moved();
}

void RecordingPlayer::showSettings(const std::optional<std::size_t>& configuration)
{
    if (configuration == m_shownConfiguration) {
        return;
    }
    m_shownConfiguration = configuration;
    if (configuration) {
        const Configuration& known = m_history.configurations()[*configuration].configuration;
        m_stage.settings.show(known.parameters, known.calibrations);
    } else {
        m_stage.settings.show({}, {});
    }
}

std::array<MotorOrder, 3> RecordingPlayer::orders(Tick since) const
{
    constexpr std::array<std::string_view, 3> kStreams{"motor1-command", "motor2-command",
                                                       "aux-command"}; // by MotorId
    std::array<MotorOrder, 3> orders{};
    for (std::size_t motor = 0; motor < kStreams.size(); ++motor) {
        const int index = streamIndex(kStreams[motor]);
        if (index < 0) {
            continue;
        }
        const TimeSeries& series = m_stage.store.series(index);
        const std::size_t end = series.axis().lowerBound(m_playhead + 1);
        if (end > 0 && series.isValid(end - 1) && series.axis().tick(end - 1) >= since) {
            orders[motor].amount = series.value(end - 1) + streams()[std::size_t(index)].offset;
        }
    }
    return orders;
}

void RecordingPlayer::tellEvents(bool isJump)
{
    const std::size_t end = m_history.eventsUpTo(m_playhead);
    const bool isAnew = isJump || end < m_passedEvents || end - m_passedEvents > kMostAtOnce;
    const std::size_t begin = isAnew ? end - std::min(end, kMostAtOnce) : m_passedEvents;
    m_passedEvents = end;
    if (isAnew || begin < end) {
        emit eventsPassed(begin, end, isAnew);
    }
}

void RecordingPlayer::showPackets(bool isJump)
{
    const std::size_t end = m_reader->packetsUpTo(m_playhead);
    const bool isAnew = isJump || end < m_passedPackets || end - m_passedPackets > kMostAtOnce;
    const std::size_t begin = isAnew ? end - std::min(end, kMostAtOnce) : m_passedPackets;
    m_passedPackets = end;
    std::vector<TransactionRecord> records;
    if (begin < end) {
        for (const RecordedPacket& packet : m_reader->packets(begin, end - begin)) {
            records.push_back(recordOf(packet));
        }
    }
    if (isAnew || !records.empty()) {
        m_stage.controller.showRecords(records, isAnew);
    }
}

/// What makes no sense on the line of the recording is shown as bytes.
TransactionRecord RecordingPlayer::recordOf(const RecordedPacket& packet) const
{
    const LineSettings& line = m_stage.controller.options().line;
    TransactionRecord record;
    record.priority = static_cast<Priority>(packet.priority);
    record.sentBytes = packet.sentBytes;
    record.receivedBytes = packet.receivedBytes;
    record.sent = instantOf(packet.sent);
    record.ended = instantOf(packet.ended);
    record.attempt = packet.attempt;
    if (packet.error >= 0) {
        record.error = static_cast<ErrorCode>(packet.error);
    }
    const auto decoded = decodePacket(packet.sentBytes, line);
    record.isRaw = !decoded;
    if (decoded) {
        record.command = decoded->command;
        const qsizetype due = replyLength(record.command);
        const qsizetype expected = due > 0 && line.hasCrc() ? due + 1 : due;
        if (!record.error && packet.receivedBytes.size() != expected) {
            record.error = ErrorCode::BadReply; // no recorder of ours would have called it complete
        }
    }
    return record;
}

} // namespace trex
