// SPDX-License-Identifier: GPL-3.0-or-later
// A LinkEngine and a simulated line on one virtual clock: no thread, no waiting, no port.
#pragma once

#include "protocol/session/linkengine.h"
#include "protocol/sim/simulatedline.h"

#include <functional>
#include <map>
#include <optional>

namespace trex::test {

class SimulatedLink {
public:
    SimulatedLink(const sim::SimOptions& options, const LineSettings& settings)
        : line(options, Instant(std::chrono::hours(1))), engine(settings, true, true)
    {
        line.setHostLine(sim::HostLine{settings.baud, settings.errorDetection, settings.stopBits});
    }

    void open()
    {
        engine.opened(now);
        isOpen = true;
    }

    /// As LinkWorker does it, but that time jumps to whatever comes next.
    void run(Duration duration)
    {
        const Instant end = now + duration;
        while (now < end) {
            followHangUp();
            listen();
            const LinkEngine::Action action = engine.next(now);
            if (action.kind == LinkEngine::Action::Kind::Send) {
                if (action.line) {
                    line.setHostLine(sim::HostLine{action.line->baud, action.line->errorDetection,
                                                   action.line->stopBits});
                }
                line.write(action.bytes, now);
                ++packets;
                listen();
                continue;
            }
            Instant next = std::min(end, now + std::chrono::milliseconds(10));
            if (action.kind == LinkEngine::Action::Kind::Wait) {
                next = std::min(next, action.until);
            }
            if (const auto byte = line.nextByteAt()) {
                next = std::min(next, *byte);
            }
            now = std::max(next, now + Duration(1000));
            take();
        }
        listen();
        take();
    }

    /// Runs until the outcome of this transaction is there, at most so long.
    std::optional<Result<trex::Reply>> ask(const Transaction& transaction,
                                           Duration longest = std::chrono::seconds(5))
    {
        engine.submit(transaction);
        take();
        for (const Instant end = now + longest; now < end && !outcomes.contains(transaction.id);) {
            run(std::chrono::milliseconds(1));
        }
        const auto found = outcomes.find(transaction.id);
        return found == outcomes.end() ? std::nullopt : std::optional(found->second);
    }

    void take()
    {
        LinkBatch batch = engine.takeBatch(now);
        stats = batch.stats;
        if (onBatch) {
            onBatch(batch);
        }
        for (const PollSample& sample : batch.samples) {
            ++sampleCounts.at(static_cast<std::size_t>(sample.poll));
            if (onSample) {
                onSample(sample);
            }
        }
        for (const Outcome& outcome : batch.outcomes) {
            if (outcomes.contains(outcome.id)) {
                ++doubleOutcomes;
            }
            outcomes.insert_or_assign(outcome.id, outcome.reply);
        }
        for (const LinkEvent& event : batch.events) {
            events.push_back(event);
        }
    }

    Instant now{std::chrono::hours(1)};
    sim::SimulatedLine line;
    LinkEngine engine;
    bool isOpen = false;
    LinkStats stats;
    std::map<quint64, Result<trex::Reply>> outcomes;
    int doubleOutcomes = 0; ///< told twice how a transaction ended: never
    std::array<int, kPollCount> sampleCounts{};
    std::function<void(const PollSample&)> onSample;
    std::function<void(const LinkBatch&)> onBatch;
    std::vector<LinkEvent> events;
    int packets = 0;

private:
    void listen()
    {
        const QByteArray bytes = line.read(now);
        if (isOpen && !bytes.isEmpty()) {
            engine.received(bytes, now);
        }
    }

    /// The port goes and comes; it is tried again every 500 ms, as LinkWorker does.
    void followHangUp()
    {
        const bool gone = line.isHungUp(now);
        if (gone && isOpen) {
            isOpen = false;
            engine.lineFailed({ErrorCode::LineLost, {}}, now);
            m_reopenAt = now + std::chrono::milliseconds(500);
        } else if (!isOpen && m_reopenAt && now >= *m_reopenAt) {
            m_reopenAt = now + std::chrono::milliseconds(500);
            if (!gone) {
                open();
                m_reopenAt.reset();
            }
        }
    }

    std::optional<Instant> m_reopenAt;
};

} // namespace trex::test
