// SPDX-License-Identifier: GPL-3.0-or-later
#include "protocol/storage/sessionrecorder.h"

#include <QDateTime>

using namespace Qt::Literals::StringLiterals;

namespace trex {
namespace {

// Bounds of what waits for a slow disk: about a minute of everything.
constexpr int kMostUnderWay = 4; // batches
constexpr std::size_t kMostSamples = 200'000; // a batch, of one source; the rest waits in the store
constexpr std::size_t kMostEntries = 50'000; // a batch, of each kind

Instant clockNow()
{
    return std::chrono::steady_clock::now();
}

} // namespace

std::optional<std::vector<PollId>> pollsOfStreamName(QStringView name)
{
    if (name == u"currents") {
        return std::vector{PollId::Currents};
    }
    if (name == u"channels") {
        return std::vector{PollId::RawChannels, PollId::RemappedChannels};
    }
    if (name == u"status") {
        return std::vector{PollId::Status, PollId::UartErrors};
    }
    return std::nullopt;
}

SessionRecorder::SessionRecorder(Controller& controller, const TelemetryStore& store,
                                 QObject* parent)
    : QObject(parent), m_store(store), m_feed(controller), m_tap(store)
{
    connect(&controller, &Controller::batchArrived, this, &SessionRecorder::pull);
    connect(&m_feed, &RecordingFeed::eventSeen, this,
            [this](const RecordedEvent& event) { keep(m_pending.events, event); });
    connect(&m_feed, &RecordingFeed::packetSeen, this,
            [this](const RecordedPacket& packet) { keep(m_pending.packets, packet); });
    connect(&m_feed, &RecordingFeed::healthSeen, this,
            [this](const RecordedHealth& health) { keep(m_pending.health, health); });
    connect(&m_feed, &RecordingFeed::factsChanged, this, [this] {
        if (m_isRecording) {
            RecordingFacts newest = m_feed.facts();
            newest.merge(m_pending.facts);
            m_pending.facts = std::move(newest);
        }
    });
    connect(&m_timer, &QTimer::timeout, this, &SessionRecorder::flush);
}

SessionRecorder::~SessionRecorder()
{
    stop();
}

/// Ticks become the recording's own when an entry is kept.
template <class T>
void SessionRecorder::keep(std::vector<T>& list, const T& entry)
{
    if (!m_isRecording) {
        return;
    }
    if (list.size() >= kMostEntries) {
        ++m_dropped;
        return;
    }
    T& kept = list.emplace_back(entry);
    if constexpr (requires { kept.tick; }) {
        kept.tick -= m_origin;
    } else {
        kept.sent -= m_origin;
        kept.ended -= m_origin;
    }
}

void SessionRecorder::start(const RecordingPlan& plan)
{
    stop();
    ++m_generation;
    m_plan = plan;
    m_feed.setPacketsWanted(plan.hasPackets);
    const Instant from = clockNow() - plan.history;
    m_origin = TimeAxis::ticksOf(from);
    m_pending = {};
    m_underWay = 0;
    m_samples = {};
    m_first.reset();
    m_last = 0;
    m_dropped = 0;
    m_droppedTold = 0;
    if (plan.history > Duration(0)) {
        m_tap.startAt(from);
    } else {
        m_tap.startNow();
    }
    m_isRecording = true;
    for (const RecordedEvent& event : m_feed.state()) {
        keep(m_pending.events, event);
    }
    m_thread.create(plan.path, startFacts(), plan.existing,
                    [this, generation = m_generation](const Result<QString>& created) {
                        if (generation != m_generation) {
                            return;
                        }
                        if (created) {
                            m_plan.path = *created;
                            emit started(m_plan.path);
                        } else {
                            onFailure(created.error());
                        }
                    });
    m_timer.start(kInterval);
}

RecordingFacts SessionRecorder::startFacts() const
{
    RecordingFacts facts = m_plan.facts;
    facts.merge(m_feed.facts());
    const auto history = std::chrono::ceil<std::chrono::milliseconds>(m_plan.history);
    facts[QString::fromLatin1(recordingfact::kStartedUtc)] =
        QDateTime::currentDateTimeUtc().addMSecs(-history.count()).toString(Qt::ISODateWithMs);
    facts[QString::fromLatin1(recordingfact::kSteadyOriginNs)] =
        QString::number(TimeAxis::instantOf(m_origin).time_since_epoch().count());
    return facts;
}

void SessionRecorder::pull()
{
    if (!m_isRecording) {
        return;
    }
    std::array<std::size_t, kSourceCount> before{};
    for (std::size_t i = 0; i < before.size(); ++i) {
        before[i] = m_pending.runs[i].size();
    }
    if (m_pending.samples() >= kMostSamples
        || m_tap.take(m_plan.polls, m_origin, kMostSamples, m_pending.runs) == 0) {
        return;
    }
    for (std::size_t i = 0; i < before.size(); ++i) {
        const SampleRun& run = m_pending.runs[i];
        if (run.size() > before[i]) {
            m_samples[i] += run.size() - before[i];
            m_first = std::min(m_first.value_or(run.ticks[before[i]]), run.ticks[before[i]]);
            m_last = std::max(m_last, run.ticks.back());
        }
    }
}

RecordingBatch SessionRecorder::takePending()
{
    if (m_dropped != m_droppedTold) {
        m_droppedTold = m_dropped;
        m_pending.facts[QString::fromLatin1(recordingfact::kDropped)] = QString::number(m_dropped);
        m_pending.events.push_back(
            {TimeAxis::ticksOf(clockNow()) - m_origin, 1, u"dropped"_s,
             tr("The disk was too slow: %n events or packets were left out so far.", nullptr,
                static_cast<int>(m_dropped))});
    }
    return std::exchange(m_pending, {});
}

void SessionRecorder::flush()
{
    pull();
    if (m_underWay < kMostUnderWay) {
        if (RecordingBatch batch = takePending(); !batch.isEmpty()) {
            write(std::move(batch));
        }
    }
}

void SessionRecorder::write(RecordingBatch batch)
{
    ++m_underWay;
    m_thread.write(std::move(batch), [this, generation = m_generation](const Result<void>& done) {
        if (generation != m_generation) {
            return;
        }
        --m_underWay;
        if (!done) {
            onFailure(done.error());
        }
    });
}

void SessionRecorder::stop()
{
    if (!m_isRecording) {
        return;
    }
    pull();
    m_pending.facts[QString::fromLatin1(recordingfact::kEndedTick)] =
        QString::number(TimeAxis::ticksOf(clockNow()) - m_origin);
    write(takePending());
    m_tap.stop();
    m_isRecording = false;
    m_timer.stop();
    m_thread.finish([this, generation = m_generation](const Result<void>& done) {
        if (generation != m_generation) {
            return;
        }
        if (done) {
            emit finished(m_plan.path);
        } else if (done.error().code != ErrorCode::Cancelled) { // told by the batch before
            emit failed(done.error());
        }
    });
}

/// Only the first is news.
void SessionRecorder::onFailure(const Error& error)
{
    if (error.code == ErrorCode::Cancelled) {
        return;
    }
    m_isRecording = false;
    m_tap.stop();
    m_timer.stop();
    m_pending = {};
    emit failed(error);
}

void SessionRecorder::addConfiguration(const Configuration& configuration)
{
    if (m_isRecording) {
        m_pending.configurations.push_back(
            {TimeAxis::ticksOf(clockNow()) - m_origin, configuration});
    }
}

void SessionRecorder::addEvent(int severity, const QString& kind, const QString& text)
{
    addEvent({TimeAxis::ticksOf(clockNow()), severity, kind, text});
}

void SessionRecorder::addEvent(const RecordedEvent& event)
{
    keep(m_pending.events, event);
}

std::size_t SessionRecorder::samples() const
{
    return *std::max_element(m_samples.begin(), m_samples.end());
}

Duration SessionRecorder::length() const
{
    return m_first ? (m_last - *m_first) * TimeAxis::kTick : Duration(0);
}

} // namespace trex
