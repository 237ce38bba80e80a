// SPDX-License-Identifier: GPL-3.0-or-later
#include "protocol/storage/recordinghistory.h"

#include "protocol/codec/replies.h"

using namespace Qt::Literals::StringLiterals;

namespace trex {
namespace {

QString textOf(std::string_view text)
{
    return QString::fromUtf8(text.data(), static_cast<qsizetype>(text.size()));
}

std::optional<Mode> modeFromKey(const QString& key)
{
    for (const Mode mode : {Mode::Rc, Mode::Analog, Mode::SerialRc, Mode::SerialAnalog}) {
        if (key == textOf(keyOf(mode))) {
            return mode;
        }
    }
    return std::nullopt;
}

std::optional<LinkState> linkFromKey(const QString& key)
{
    for (const LinkState state : {LinkState::Disconnected, LinkState::Connecting,
                                  LinkState::Connected, LinkState::Lost, LinkState::Retrying}) {
        if (key == keyOf(state)) {
            return state;
        }
    }
    return std::nullopt;
}

/// What the facts say of the line; what makes no sense is as on a usual one.
OpenOptions optionsOf(const RecordingReader& reader)
{
    using namespace recordingfact;
    OpenOptions options;
    options.port = reader.fact(kPort);
    LineSettings line;
    line.baud = reader.fact(kBaud).toInt();
    line.stopBits = reader.fact(kStopBits).toInt();
    line.device = static_cast<std::uint8_t>(reader.fact(kDevice).toUInt());
    line.errorDetection =
        errorDetectionFromKey(reader.fact(kErrorDetection)).value_or(ErrorDetection::None);
    line.form = packetFormFromKey(reader.fact(kProtocol)).value_or(PacketForm::Compact);
    if (validate(line)) {
        options.line = line;
    }
    return options;
}

/// Index past the last entry at or before the tick.
template <class T>
std::size_t countUpTo(const std::vector<T>& list, Tick tick, Tick T::*time)
{
    const auto end =
        std::upper_bound(list.begin(), list.end(), tick,
                         [time](Tick wanted, const T& entry) { return wanted < entry.*time; });
    return static_cast<std::size_t>(end - list.begin());
}

template <class T>
void sortByTime(std::vector<T>& list)
{
    std::stable_sort(list.begin(), list.end(),
                     [](const T& a, const T& b) { return a.tick < b.tick; });
}

} // namespace

RecordingHistory::RecordingHistory(RecordingReader& reader)
    : m_events(reader.events())
    , m_health(reader.health())
    , m_configurations(reader.configurations())
    , m_options(optionsOf(reader))
{
    sortByTime(m_health);
    sortByTime(m_configurations);
    const auto signature = parseSignature(reader.fact(recordingfact::kSignature).toLatin1());
    m_signature = signature ? std::optional(*signature) : std::nullopt;
    collectStates();
    if (m_states.size() == 1) { // a recording that tells of no change: its facts hold throughout
        m_states.front().device.mode = modeFromKey(reader.fact(recordingfact::kMode));
    }
}

void RecordingHistory::collectStates()
{
    State state;
    state.since = -kLargestTick;
    m_states.push_back(state);
    for (const RecordedEvent& event : m_events) {
        follow(state, event);
        if (state.since == event.tick) {
            m_states.push_back(state);
        }
    }
}

/// `since` becomes the event's tick when it changes the state.
void RecordingHistory::follow(State& state, const RecordedEvent& event)
{
    if (event.kind == u"link"_s) {
        const auto link = linkFromKey(event.text);
        if (!link) {
            return;
        }
        if (*link != LinkState::Connected && state.link == LinkState::Connected) {
            state.device = {};
            state.lostAt = event.tick;
        }
        state.link = *link;
    } else if (event.kind == u"armed"_s) {
        state.isArmed = event.text == u"true"_s;
    } else if (event.kind == u"mode"_s) {
        state.device.mode = modeFromKey(event.text);
    } else if (event.kind == u"serial-control"_s) {
        state.device.serialControls = event.text == u"true"_s;
    } else if (event.kind == u"learned"_s) {
        state.device.learnedMask = static_cast<std::uint8_t>(event.text.toUInt());
    } else {
        return;
    }
    state.since = event.tick;
}

RecordingHistory::Moment RecordingHistory::at(Tick tick) const
{
    // A state that begins with the recording holds at its first moment, too.
    const State& state =
        m_states[std::max<std::size_t>(countUpTo(m_states, tick, &State::since), 1) - 1];
    Moment moment;
    moment.state.link = state.link;
    moment.state.options = m_options;
    moment.state.device = state.device;
    // Of one controller, whatever its link did: what a count of current is worth hangs on it.
    moment.state.device.signature = m_signature;
    moment.state.stats = statsAt(tick);
    moment.isArmed = state.isArmed;
    moment.lostAt = state.lostAt;
    const std::size_t count = countUpTo(m_configurations, tick, &RecordedConfiguration::tick);
    if (count > 0) {
        moment.configuration = count - 1;
    }
    return moment;
}

LinkStats RecordingHistory::statsAt(Tick tick) const
{
    const std::size_t count = countUpTo(m_health, tick, &RecordedHealth::tick);
    LinkStats stats;
    if (count > 0) {
        const RecordedHealth& health = m_health[count - 1];
        stats.transactions = health.transactions;
        stats.retries = health.retries;
        stats.timeouts = health.timeouts;
        stats.crcErrors = health.crcErrors;
        stats.badReplies = health.badReplies;
        stats.surplusBytes = health.surplusBytes;
        stats.resyncs = health.resyncs;
        stats.bytesSent = health.bytesSent;
        stats.bytesReceived = health.bytesReceived;
        stats.roundTripMs = health.roundTripMs;
        stats.transactionsPerSecond = health.transactionsPerSecond;
    }
    return stats;
}

std::size_t RecordingHistory::eventsUpTo(Tick tick) const
{
    return countUpTo(m_events, tick, &RecordedEvent::tick);
}

std::optional<Tick> RecordingHistory::nextEvent(Tick tick) const
{
    const std::size_t next = eventsUpTo(tick);
    return next < m_events.size() ? std::optional(m_events[next].tick) : std::nullopt;
}

std::optional<Tick> RecordingHistory::previousEvent(Tick tick) const
{
    const std::size_t count = eventsUpTo(tick - 1);
    return count > 0 ? std::optional(m_events[count - 1].tick) : std::nullopt;
}

} // namespace trex
