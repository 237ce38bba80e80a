// SPDX-License-Identifier: GPL-3.0-or-later
#include "protocol/storage/flightrecorder.h"

#include "protocol/storage/recordingwriter.h"

#include <QDateTime>
#include <QDir>

using namespace Qt::Literals::StringLiterals;

namespace trex {
namespace {

constexpr std::size_t kMostEvents = 20'000;
constexpr std::size_t kMostPackets = 50'000;
constexpr auto kPrefix = "flight-"_L1;
constexpr auto kSuffix = ".trexrec"_L1;

constexpr std::uint8_t kFaults = statusbit::kMotor1Fault | statusbit::kMotor2Fault
    | statusbit::kMotor1OverCurrent | statusbit::kMotor2OverCurrent;
// The motors were shut down because the controller heard nothing (command documentation, 0x85).
constexpr std::uint8_t kUartFaults = uartbit::kTimeout;

Instant clockNow()
{
    return std::chrono::steady_clock::now();
}

/// Frozen files but the newest ones go; their names sort by time.
void prune(const QString& folder, int files)
{
    QDir directory(folder);
    const QStringList names =
        directory.entryList({kPrefix + u'*' + kSuffix}, QDir::Files, QDir::Name | QDir::Reversed);
    for (qsizetype i = files; i < names.size(); ++i) {
        directory.remove(names[i]);
    }
}

Result<void> writeWhole(const QString& path, const RecordingFacts& facts,
                        const RecordingBatch& batch, int files)
{
    const QString folder = QFileInfo(path).path();
    if (!QDir().mkpath(folder)) {
        return fail(ErrorCode::FileUnwritable, folder);
    }
    auto writer = RecordingWriter::create(path, facts);
    if (!writer) {
        return tl::make_unexpected(writer.error());
    }
    auto done = (*writer)->write(batch).and_then([&] { return (*writer)->finish(); });
    if (done) {
        prune(folder, files);
    }
    return done;
}

} // namespace

FlightRecorder::FlightRecorder(Controller& controller, const TelemetryStore& store, QObject* parent)
    : QObject(parent), m_controller(controller), m_store(store), m_feed(controller)
{
    m_after.setSingleShot(true);
    m_after.callOnTimeout(this, [this] { writeFile(m_policy.after); });
    connect(&controller, &Controller::batchArrived, this, &FlightRecorder::onBatch);
    connect(&m_feed, &RecordingFeed::eventSeen, this, &FlightRecorder::onEvent);
    connect(&m_feed, &RecordingFeed::packetSeen, this,
            [this](const RecordedPacket& packet) { m_packets.push_back(packet); });
    connect(&m_feed, &RecordingFeed::healthSeen, this,
            [this](const RecordedHealth& health) { m_health.push_back(health); });
    connect(&controller, &Controller::lockedOut, this, [this] {
        // Told before the gate closes; disarming with the motors at rest is nothing to keep.
        if (m_policy.onStop && m_controller.isArmed()) {
            freeze(u"stop"_s);
        }
    });
    connect(&controller, &Controller::stateChanged, this, [this](LinkState state) {
        if (m_policy.onLoss && state == LinkState::Lost) {
            freeze(u"loss"_s);
        }
    });
    for (const RecordedEvent& event : m_feed.state()) {
        m_before[event.kind] = event;
    }
    setPolicy({});
}

FlightRecorder::~FlightRecorder()
{
    if (m_after.isActive()) {
        m_after.stop();
        writeFile(m_policy.after);
    }
}

void FlightRecorder::setPolicy(const FlightPolicy& policy)
{
    m_policy = policy;
    m_feed.setPacketsWanted(policy.isEnabled && policy.packetsBefore > Duration(0));
}

void FlightRecorder::onEvent(const RecordedEvent& event)
{
    m_events.push_back(event);
    if (m_events.size() > kMostEvents) {
        dropOldestEvent();
    }
}

/// What it said of the state still holds until a later one says otherwise.
void FlightRecorder::dropOldestEvent()
{
    RecordedEvent& event = m_events.front();
    if (RecordingFeed::isState(event.kind)) {
        m_before[event.kind] = std::move(event);
    }
    m_events.pop_front();
}

void FlightRecorder::onBatch()
{
    forgetOld();
    if (m_clears != m_store.clears()) {
        m_clears = m_store.clears();
        m_nextStatus = {};
    }
    bool isFault = false;
    const std::array<std::pair<std::string_view, std::uint8_t>, 2> watched{
        {{"status", kFaults}, {"uart-errors", kUartFaults}}};
    for (std::size_t i = 0; i < watched.size(); ++i) {
        const TimeSeries& series = m_store.series(watched[i].first);
        m_nextStatus[i] = std::max(m_nextStatus[i], series.first());
        for (; m_nextStatus[i] < series.size(); ++m_nextStatus[i]) {
            // Reading clears the bits: each one that is set happened since the read before.
            isFault = isFault || (series.value(m_nextStatus[i]) & watched[i].second) != 0;
        }
    }
    if (isFault && m_policy.onFault) {
        freeze(u"fault"_s);
    }
}

void FlightRecorder::forgetOld()
{
    const Tick oldest = TimeAxis::ticksOf(clockNow() - m_policy.before);
    const Tick oldestPacket = TimeAxis::ticksOf(clockNow() - m_policy.packetsBefore);
    while (!m_events.empty() && m_events.front().tick < oldest) {
        dropOldestEvent();
    }
    while (!m_health.empty() && m_health.front().tick < oldest) {
        m_health.pop_front();
    }
    while (!m_packets.empty()
           && (m_packets.front().ended < oldestPacket || m_packets.size() > kMostPackets)) {
        m_packets.pop_front();
    }
}

void FlightRecorder::freeze(const QString& reason)
{
    if (m_after.isActive() && reason == u"fault"_s) {
        m_reason = reason; // the stop that is about to be frozen was its consequence
        return;
    }
    const Instant now = clockNow();
    const bool isTooSoon = m_lastFreeze && now - *m_lastFreeze < m_policy.distance;
    if (!m_policy.isEnabled || m_policy.folder.isEmpty() || isTooSoon) {
        return;
    }
    m_lastFreeze.emplace(now); // as an assignment it is a dangling pointer to GCC 12 at -O3
    m_reason = reason;
    m_after.start(m_policy.after);
}

void FlightRecorder::keepNow(const QString& reason)
{
    if (m_after.isActive()) { // what waits is in it
        m_after.stop();
    }
    m_reason = reason;
    writeFile(Duration(0));
}

RecordingBatch FlightRecorder::collect(Instant from)
{
    const Tick origin = TimeAxis::ticksOf(from);
    RecordingBatch batch;
    SampleTap tap(m_store);
    SampleTap::Wanted all;
    all.fill(true);
    tap.startAt(from);
    tap.take(all, origin, std::numeric_limits<std::int32_t>::max(), batch.runs);
    for (const auto& [kind, event] : m_before) {
        batch.events.push_back(event);
        batch.events.back().tick = origin; // it began before, and held then
    }
    batch.events.insert(batch.events.end(), m_events.begin(), m_events.end());
    batch.packets.assign(m_packets.begin(), m_packets.end());
    batch.health.assign(m_health.begin(), m_health.end());
    for (RecordedEvent& event : batch.events) {
        event.tick -= origin;
    }
    for (RecordedHealth& health : batch.health) {
        health.tick -= origin;
    }
    for (RecordedPacket& packet : batch.packets) {
        packet.sent -= origin;
        packet.ended -= origin;
    }
    if (m_configuration) {
        batch.configurations.push_back({0, *m_configuration});
    }
    return batch;
}

void FlightRecorder::writeFile(Duration after)
{
    forgetOld();
    const Instant now = clockNow();
    const Duration length = m_policy.before + after;
    const Instant from = now - length;
    const auto lengthMs = std::chrono::duration_cast<std::chrono::milliseconds>(length);
    const QDateTime wall = QDateTime::currentDateTimeUtc();
    RecordingBatch batch = collect(from);
    RecordingFacts facts = m_policy.facts;
    facts.merge(m_feed.facts());
    const auto set = [&facts](const char* name, const QString& value) {
        facts[QString::fromLatin1(name)] = value;
    };
    set(recordingfact::kReason, m_reason);
    set(recordingfact::kStartedUtc, wall.addMSecs(-lengthMs.count()).toString(Qt::ISODateWithMs));
    set(recordingfact::kSteadyOriginNs, QString::number(from.time_since_epoch().count()));
    set(recordingfact::kEndedTick, QString::number(length / TimeAxis::kTick));
    const QString name =
        kPrefix + wall.toString(u"yyyyMMdd-HHmmss-zzz"_s) + u'-' + m_reason + kSuffix;
    const QString path = QDir(m_policy.folder).filePath(name);
    m_thread.post([path, facts, batch = std::move(batch), files = m_policy.files](
                      RecorderThread::Writer&) { return writeWhole(path, facts, batch, files); },
                  [this, path, reason = m_reason](const Result<void>& done) {
                      if (done) {
                          emit frozen(path, reason);
                      } else {
                          emit failed(done.error());
                      }
                  });
}

} // namespace trex
