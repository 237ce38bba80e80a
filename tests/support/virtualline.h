// SPDX-License-Identifier: GPL-3.0-or-later
// Drives a LinkEngine on a virtual clock against a peer written in the test: no thread, no waiting.
#pragma once

#include "protocol/session/linkengine.h"

#include <QByteArrayList>

#include <deque>
#include <functional>

namespace trex::test {

class VirtualLine {
public:
    struct Incoming {
        Instant at;
        QByteArray bytes;
    };

    explicit VirtualLine(const LineSettings& settings = {}, bool identify = true,
                         bool reconnect = true, bool stopsInDoubt = true)
        : engine(settings, identify, reconnect, true, stopsInDoubt), line(settings)
    {
    }

    /// Opens the line, after which the peer answers each packet with what it returns, when the
    /// bytes have had their time on the wire.
    void open() { engine.opened(now); }

    void run(Duration duration)
    {
        const Instant end = now + duration;
        while (now < end) {
            deliverDue();
            const LinkEngine::Action action = engine.next(now);
            if (action.kind == LinkEngine::Action::Kind::Send) {
                sent.push_back({now, action.bytes});
                answer(action.bytes);
                continue;
            }
            Instant next =
                action.kind == LinkEngine::Action::Kind::Wait ? std::max(action.until, now) : end;
            if (!incoming.empty()) {
                next = std::min(next, std::max(incoming.front().at, now));
            }
            now = std::min(next, end);
            take();
        }
        deliverDue();
        take();
    }

    void take()
    {
        LinkBatch batch = engine.takeBatch(now);
        stats = batch.stats;
        if (!batch.health.empty()) {
            health = batch.health.back();
        }
        std::move(batch.samples.begin(), batch.samples.end(), std::back_inserter(samples));
        std::move(batch.outcomes.begin(), batch.outcomes.end(), std::back_inserter(outcomes));
        std::move(batch.events.begin(), batch.events.end(), std::back_inserter(events));
        std::move(batch.records.begin(), batch.records.end(), std::back_inserter(records));
    }

    [[nodiscard]] QByteArrayList sentPackets() const
    {
        QByteArrayList packets;
        for (const Incoming& packet : sent) {
            packets.append(packet.bytes);
        }
        return packets;
    }

    std::function<QByteArray(const QByteArray&)> peer = [](const QByteArray&) {
        return QByteArray();
    };
    Duration replyDelay{0}; ///< beyond the time on the wire
    LinkEngine engine;
    LineSettings line;
    Instant now{std::chrono::hours(1)};
    std::vector<Incoming> sent;
    std::deque<Incoming> incoming;
    std::vector<PollSample> samples;
    std::vector<Outcome> outcomes;
    std::vector<LinkEvent> events;
    std::vector<TransactionRecord> records;
    LinkStats stats;
    LinkHealth health; ///< the latest that crossed

private:
    void answer(const QByteArray& packet)
    {
        const QByteArray reply = peer(packet);
        if (!reply.isEmpty()) {
            const auto bytes = static_cast<int>(packet.size() + reply.size());
            incoming.push_back({now + line.timeOf(bytes) + replyDelay, reply});
        }
    }

    void deliverDue()
    {
        while (!incoming.empty() && incoming.front().at <= now) {
            const Incoming due = incoming.front();
            incoming.pop_front();
            engine.received(due.bytes, due.at);
        }
    }
};

/// What the façade sends to stop, with numbers from 1000.
inline std::vector<Transaction> stopPackets()
{
    std::vector<Transaction> packets;
    for (const Command& command : stopCommands(false)) {
        packets.push_back(
            {.id = 1000 + packets.size(), .command = command, .priority = Priority::Stop});
    }
    return packets;
}

} // namespace trex::test
