// SPDX-License-Identifier: GPL-3.0-or-later
// The host's whole reply path: LinkEngine with a person who asks, orders and stops, and a line that
// answers honestly, wrongly, late, or with whatever bytes the input holds, at any time.
//
// An engine's word is held against a record of its own kept here: every value that it tells must
// have come, whole and valid, after its question; no motor order leaves that nobody gave, or twice,
// or after a stop or a loss; a stop leaves first and in time; each question ends exactly once.
#include "protocol/codec/packet.h"
#include "protocol/session/linkengine.h"
#include "tests/fuzz/peer.h"

#include <map>
#include <set>

using namespace trex;
using namespace std::chrono_literals;
using fuzz::holds;

namespace {

bool isSubsequence(QByteArrayView part, QByteArrayView whole)
{
    qsizetype found = 0;
    for (qsizetype i = 0; i < whole.size() && found < part.size(); ++i) {
        found += whole[i] == part[found] ? 1 : 0;
    }
    return found == part.size();
}

class World {
public:
    explicit World(fuzz::Input& input)
        : m_input(input)
        , m_line(fuzz::anyLine(input))
        , m_flags(input.byte())
        , m_engine(m_line, (m_flags & 1) == 0, (m_flags & 2) == 0, (m_flags & 4) == 0)
    {
        m_isHonest = (m_flags & 8) != 0;
        m_echoes = (m_flags & 16) != 0;
        open();
    }
    void play()
    {
        for (int steps = 0; steps < 200 && !m_input.isAtEnd(); ++steps) {
            act();
            pump();
            settle();
        }
        m_engine.shutDown();
        stop();
        pump();
        pass(1s);
        settle();
        holds(m_waiting.empty(), "everything that was asked ends by the time the line is closed");
    }

private:
    struct Order {
        QByteArray bytes;
        quint64 id = 0;
    };

    void open()
    {
        m_isOpen = true;
        m_engine.opened(m_now);
    }
    void act()
    {
        switch (m_input.below(16)) {
        case 0:
            pass(4ms * m_input.byte());
            return;
        case 1:
            pass(std::chrono::microseconds(100 * m_input.byte()));
            return;
        case 2:
            arrive(m_input.bytes(m_input.byte() & 0x3F));
            return;
        case 3: { // one honest reply, a bit of it turned
            QByteArray reply = fuzz::honestReply(m_lastSent, m_line);
            if (const int at = m_input.byte(); at < 8 * reply.size()) {
                reply[at / 8] = static_cast<char>(reply[at / 8] ^ (1 << at % 8));
            }
            arrive(reply);
            return;
        }
        case 4:
            ask(kCommands[std::size_t(m_input.below(int(kCommands.size())))]);
            return;
        case 5:
            submit({.command = writeParameter(std::uint8_t(m_input.byte() & 0x7F),
                                              std::uint8_t(m_input.byte() & 0x7F))});
            return;
        case 6:
            order();
            return;
        case 7: {
            const int length = 1 + m_input.below(6);
            submit({.rawBytes = m_input.bytes(length), .rawReplyBytes = m_input.below(6)});
            return;
        }
        case 8:
            stop();
            return;
        case 9: {
            PollWishes wishes{};
            const int chosen = m_input.byte();
            for (std::size_t i = 0; i < wishes.size(); ++i) {
                wishes[i] = (chosen >> i & 1) != 0 ? 1.0 + m_input.byte() : 0.0;
            }
            m_engine.setWishes(wishes, m_now);
            return;
        }
        case 10:
            m_isOpen = false;
            m_incoming.clear();
            m_orders.clear();
            m_stopDue.reset();
            m_engine.lineFailed({ErrorCode::LineLost, {}}, m_now);
            return;
        case 11:
            if (!m_isOpen && (m_flags & 2) == 0) {
                open();
            }
            return;
        case 12:
            m_isHonest = m_input.flag();
            return;
        case 13:
            m_echoes = m_input.flag();
            return;
        default:
            pass(20ms);
            return;
        }
    }

    // What a person does.
    void submit(Transaction transaction)
    {
        const bool isRaw = !transaction.rawBytes.isEmpty();
        if (!isRaw && (transaction.command.opcode == 0)) {
            return; // there was no byte left
        }
        transaction.id = ++m_lastId;
        m_waiting.insert(transaction.id);
        const QByteArray bytes = isRaw ? transaction.rawBytes : encode(transaction.command, m_line);
        if (isRaw || transaction.command.row().kind != CommandKind::Query) {
            m_orders.push_back({key(transaction, bytes), transaction.id});
        }
        m_engine.submit(transaction);
    }
    void ask(const CommandRow& row)
    {
        if (row.kind != CommandKind::Query) {
            return;
        }
        Command command{
            static_cast<std::uint8_t>(row.first + m_input.below(row.last - row.first + 1)), {}};
        for (int i = 0; i < argumentBytes(row); ++i) {
            command.data.append(static_cast<char>(m_input.byte() & 0x1F));
        }
        if (replyLength(command) > 0) {
            submit({.command = command});
        }
    }
    void order()
    {
        const auto motor = static_cast<MotorId>(m_input.below(3));
        const int amount = 1 + m_input.below(127);
        const MotorOrder given{
            m_input.flag() ? MotorOrder::Action::Set : MotorOrder::Action::Accelerate, amount};
        const auto command = m_input.flag() ? driveMotor(motor, given) : driveBoth(given, given);
        holds(command.has_value(), "an order in range can be sent");
        submit({.command = *command, .priority = Priority::Motor});
    }
    void stop()
    {
        std::vector<Transaction> packets;
        m_firstStop = m_lastId + 1;
        for (const Command& command : stopCommands(m_input.flag())) {
            packets.push_back({.id = ++m_lastId, .command = command, .priority = Priority::Stop});
            m_waiting.insert(m_lastId);
        }
        m_lastStop = m_lastId;
        std::erase_if(m_orders, [](const Order& each) { return each.bytes.front() != 'w'; });
        m_stopsAsked = packets.size();
        m_stopDue = m_now + 100ms + m_line.timeOf(32) + 60ms;
        m_engine.stop(packets, m_now);
        settle();
    }

    // The line.
    void arrive(const QByteArray& bytes)
    {
        if (m_isOpen && !bytes.isEmpty()) {
            m_heard.push_back({m_now, bytes});
            m_engine.received(bytes, m_now);
        }
    }
    void pass(Duration duration)
    {
        const Instant end = m_now + duration;
        for (int turns = 0; turns < 2000; ++turns) {
            pump();
            Instant next = end;
            if (m_wake) {
                next = std::min(next, *m_wake);
            }
            if (!m_incoming.empty()) {
                next = std::min(next, m_incoming.begin()->first);
            }
            m_now = std::max(next, m_now);
            while (!m_incoming.empty() && m_incoming.begin()->first <= m_now) {
                const QByteArray bytes = m_incoming.begin()->second;
                m_incoming.erase(m_incoming.begin());
                arrive(bytes);
            }
            if (m_now == end) {
                break;
            }
        }
        m_now = end;
    }
    void pump()
    {
        for (int sends = 0;; ++sends) {
            holds(sends < 1000, "the engine rests");
            const LinkEngine::Action action = m_engine.next(m_now);
            if (action.kind != LinkEngine::Action::Kind::Send) {
                m_wake.reset();
                if (action.kind == LinkEngine::Action::Kind::Wait) {
                    holds(action.until > m_now, "a wait is for a later time");
                    m_wake = action.until;
                }
                break;
            }
            sent(action.bytes);
        }
        holds(!m_stopDue || m_now <= *m_stopDue, "a stop leaves within its time");
        settle();
    }

    // What left.
    void sent(const QByteArray& bytes)
    {
        holds(m_isOpen, "nothing is sent on a closed line");
        const auto packet = decodePacket(bytes, m_line);
        const bool isMotor = packet && packet->command.row().kind == CommandKind::Motor;
        const bool isNeutral = isMotor && isStop(packet->command);
        if (m_stopDue) {
            holds(isNeutral, "what waits stays behind a stop");
            m_stopsAsked -= std::min<std::size_t>(m_stopsAsked, 1);
            if (m_stopsAsked == 0) {
                m_stopDue.reset();
            }
        } else if (!isNeutral) {
            take(bytes, isMotor, packet && packet->command.row().needsSerialMode);
        }
        if (packet) {
            m_lastSent = packet->command;
        }
        const Instant done = m_now + m_line.timeOf(int(bytes.size()));
        if (m_echoes) {
            m_incoming.emplace(done, bytes);
        }
        const QByteArray reply =
            packet && m_isHonest ? fuzz::honestReply(packet->command, m_line) : QByteArray();
        if (!reply.isEmpty()) {
            m_incoming.emplace(done + m_line.timeOf(int(reply.size())), reply);
        }
    }
    static bool isStop(const Command& command)
    {
        return command == stopCommands(false)[0] || command == stopCommands(false)[1]
            || command == stopCommands(true)[0];
    }
    static QByteArray key(const Transaction& transaction, const QByteArray& bytes)
    {
        if (!transaction.rawBytes.isEmpty()) {
            return 'r' + bytes;
        }
        return (transaction.command.row().kind == CommandKind::Motor ? 'm' : 'w') + bytes;
    }
    /// An order that leaves was given, and is gone with that.
    void take(const QByteArray& bytes, bool isMotor, bool isWrite)
    {
        const auto given = [&](char kind) {
            const QByteArray wanted = kind + withDevice(bytes);
            const auto found = std::ranges::find_if(m_orders, [&](const Order& each) {
                return each.bytes.front() + withDevice(each.bytes.sliced(1)) == wanted;
            });
            if (found == m_orders.end()) {
                return false;
            }
            m_orders.erase(found);
            return true;
        };
        if (isMotor) {
            holds(given('m') || given('r'), "a motor order was given, and is sent once");
        } else if (isWrite) {
            holds(given('w') || given('r'), "a setting was asked for, and is sent once");
        } else {
            (void)given('r');
        }
    }
    /// The device number may change with a setting: it is left out of the comparison.
    [[nodiscard]] QByteArray withDevice(QByteArray bytes) const
    {
        if (m_line.form == PacketForm::Pololu && bytes.size() > 3) {
            bytes[1] = 0;
            bytes.chop(m_line.hasCrc() ? 1 : 0);
        }
        return bytes;
    }

    // What was told.
    void settle()
    {
        LinkBatch batch = m_engine.takeBatch(m_now);
        for (const PollSample& sample : batch.samples) {
            holds(std::ranges::any_of(batch.records,
                                      [&](const auto& each) { return saysSo(each, sample); }),
                  "a value is told only after a whole and valid reply to its question");
        }
        for (const Outcome& outcome : batch.outcomes) {
            holds(m_waiting.erase(outcome.id) == 1, "each question ends once");
            if (outcome.reply) {
                checkOutcome(batch, *outcome.reply);
            } else {
                std::erase_if(m_orders, [&](const Order& each) { return each.id == outcome.id; });
                if (outcome.id >= m_firstStop && outcome.id <= m_lastStop) {
                    m_stopDue.reset(); // the line had been given up
                }
            }
        }
        for (const LinkEvent& event : batch.events) {
            if (event.kind == LinkEvent::Kind::Identified) {
                const QByteArray text = event.signature->text().toLatin1();
                holds(std::ranges::any_of(batch.records,
                                          [&](const TransactionRecord& each) {
                                              return each.receivedBytes.contains(
                                                         fuzz::withCrc(text, m_line))
                                                  && isHeard(each);
                                          }),
                      "a controller is believed in after its signature");
            }
        }
    }
    [[nodiscard]] bool saysSo(const TransactionRecord& record, const PollSample& sample) const
    {
        const Command asked = pollCommand(sample.poll);
        const int length = replyLength(asked) + (m_line.hasCrc() ? 1 : 0);
        if (record.error || record.ended != sample.time || record.command != asked
            || record.receivedBytes.size() < length || !isHeard(record)) {
            return false;
        }
        const QByteArray payload =
            record.receivedBytes.last(length).chopped(m_line.hasCrc() ? 1 : 0);
        return record.receivedBytes.endsWith(fuzz::withCrc(payload, m_line))
            && isPlausible(asked, payload)
            && decodePoll(sample.poll, payload, sample.time).raw == sample.raw;
    }
    void checkOutcome(const LinkBatch& batch, const Reply& reply) const
    {
        const auto record = std::ranges::find_if(batch.records, [&](const TransactionRecord& each) {
            return !each.error && each.sent == reply.sent && each.ended == reply.received
                && each.sentBytes == reply.sentBytes;
        });
        holds(record != batch.records.end(), "what is told stands in the record of the line");
        if (reply.payload.isEmpty()) {
            return;
        }
        holds(record->receivedBytes.startsWith(fuzz::withCrc(reply.payload, m_line))
                  && isHeard(*record),
              "a reply is what came after its question, with its CRC");
        if (!record->isRaw) {
            holds(record->receivedBytes == fuzz::withCrc(reply.payload, m_line)
                      && isPlausible(reply.command, reply.payload)
                      && reply.payload.size() <= replyLength(reply.command),
                  "a reply has its length and makes sense");
        }
    }
    [[nodiscard]] bool isHeard(const TransactionRecord& record) const
    {
        QByteArray heard;
        for (const auto& [at, bytes] : m_heard) {
            if (at >= record.sent && at <= record.ended) {
                heard += bytes;
            }
        }
        return isSubsequence(record.receivedBytes, heard);
    }

    fuzz::Input& m_input;
    LineSettings m_line;
    int m_flags;
    LinkEngine m_engine;
    Instant m_now{1h};
    std::optional<Instant> m_wake;
    bool m_isOpen = false;
    bool m_isHonest = false;
    bool m_echoes = false;
    Command m_lastSent{0x81, {}};
    std::multimap<Instant, QByteArray> m_incoming;
    std::vector<std::pair<Instant, QByteArray>> m_heard;
    std::vector<Order> m_orders; ///< given, not sent: motor orders, raw bytes, writes
    std::set<quint64> m_waiting;
    quint64 m_lastId = 0;
    quint64 m_firstStop = ~quint64(0); ///< of the last stop's packets
    quint64 m_lastStop = 0;
    std::size_t m_stopsAsked = 0;
    std::optional<Instant> m_stopDue;
};

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
    fuzz::Input input(data, size);
    World(input).play();
    return 0;
}
