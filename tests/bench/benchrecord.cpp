// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/bench/benchsections.h"

#include "protocol/storage/recordingreader.h"
#include "protocol/storage/recordingwriter.h"
#include "protocol/storage/sampletap.h"
#include "protocol/storage/sessionrecorder.h"

#include <QElapsedTimer>
#include <QFileInfo>
#include <QTemporaryDir>

#include <cmath>
#include <random>

#include <sys/resource.h>

namespace trex::bench {

using namespace std::chrono_literals;
using namespace Qt::Literals::StringLiterals;

namespace {

constexpr Instant kStart(1000s);
constexpr double kNsPerMs = 1e6;

double threadSeconds()
{
    rusage usage{};
    getrusage(RUSAGE_THREAD, &usage);
    const auto seconds = [](const timeval& time) {
        return double(time.tv_sec) + double(time.tv_usec) * 1e-6;
    };
    return seconds(usage.ru_utime) + seconds(usage.ru_stime);
}

/// Full polling as it comes: slow movements, noise of a count or two, times that jitter.
class Session {
public:
    /// 80 Hz currents, 50 Hz channels of both kinds, 10 Hz of both latched bytes.
    void advance(TelemetryStore& store, std::chrono::milliseconds span)
    {
        for (const Instant end = m_now + span; m_now < end; m_now += 12'500us, ++m_round) {
            const Instant time = m_now + std::chrono::microseconds(m_random() % 800);
            const double wave = std::sin(double(m_round) * 0.002);
            store.append({PollId::Currents, {noisy(60 + 40 * wave), noisy(30)}, time});
            if (m_round % 8 < 5) {
                const auto stick = noisy(3750 + 1000 * wave);
                store.append({PollId::RawChannels,
                              {stick, noisy(3700), noisy(3760), noisy(2500), noisy(5000)},
                              time + 3ms});
                store.append({PollId::RemappedChannels,
                              {std::uint16_t(stick / 50), 0, noisy(1), 3, 4},
                              time + 6ms});
            }
            if (m_round % 8 == 0) {
                store.append({PollId::Status, {0}, time + 8ms});
                store.append({PollId::UartErrors, {0}, time + 9ms});
            }
        }
    }

private:
    std::uint16_t noisy(double centre)
    {
        return static_cast<std::uint16_t>(std::lround(centre) + int(m_random() % 4));
    }
    Instant m_now = kStart;
    std::minstd_rand m_random{1};
    std::int64_t m_round = 0;
};

std::size_t valuesIn(const TelemetryStore& store)
{
    std::size_t count = 0;
    for (std::size_t i = 0; i < streams().size(); ++i) {
        count += store.series(static_cast<int>(i)).size();
    }
    return count;
}

struct Written {
    double processorSeconds = 0.0;
    std::size_t values = 0;
};

/// Writes so long a session, taken from the store in such steps.
Written write(const QString& path, std::chrono::seconds length, std::chrono::milliseconds step)
{
    SampleTap::Wanted all;
    all.fill(true);
    TelemetryStore store;
    SampleTap tap(store);
    Session session;
    Written written;
    auto writer = RecordingWriter::create(path, {});
    for (std::chrono::milliseconds at(0); writer && at < length; at += step) {
        session.advance(store, step);
        const double before = threadSeconds();
        RecordingBatch batch;
        tap.take(all, TimeAxis::ticksOf(kStart), std::numeric_limits<std::int32_t>::max(),
                 batch.runs);
        static_cast<void>((*writer)->write(batch));
        written.processorSeconds += threadSeconds() - before;
    }
    if (writer) {
        static_cast<void>((*writer)->finish());
    }
    written.values = valuesIn(store);
    return written;
}

} // namespace

void measureRecording(Results& results)
{
    const QTemporaryDir folder;
    const QString live = folder.filePath(u"live"_s);
    constexpr auto kLive = 600s;
    const Written written = write(live, kLive, SessionRecorder::kInterval);
    const double liveSeconds = std::chrono::duration<double>(kLive).count();
    results.add(u"record.cpu"_s, u"record: processor time at full polling, as it comes"_s,
                100.0 * written.processorSeconds / liveSeconds, u"% of a core"_s);
    results.add(u"record.bytes"_s, u"record: file, times and all"_s,
                double(QFileInfo(live).size()) / double(written.values), u"bytes a value"_s);

    const QString day = folder.filePath(u"day.trexrec"_s);
    const Written whole = write(day, 24h, 60s);
    results.add(u"record.day.size"_s, u"record: a day of full polling"_s,
                double(QFileInfo(day).size()) / 1048576.0, u"MiB"_s);
    results.add(u"record.day.values"_s, u"record: values in it"_s, double(whole.values) / 1e6,
                u"million"_s);
    std::vector<double> openMs;
    std::vector<double> loadMs;
    for (int run = 0; run < 3; ++run) {
        QElapsedTimer timer;
        timer.start();
        const auto reader = RecordingReader::open(day);
        const auto spans = reader ? (*reader)->overview(0).size() : 0;
        openMs.push_back(spans > 0 ? double(timer.nsecsElapsed()) / kNsPerMs : 0.0);
        timer.restart();
        TelemetryStore store;
        if (reader) {
            (*reader)->loadAll(store, kStart);
        }
        loadMs.push_back(double(timer.nsecsElapsed()) / kNsPerMs);
    }
    results.add(u"record.day.open"_s, u"record: opening the day, overview of every stream"_s,
                median(openMs), u"ms"_s);
    results.add(u"record.day.load"_s, u"record: loading every sample of the day"_s, median(loadMs),
                u"ms"_s);
    measureOpening(day, results);
}

} // namespace trex::bench
