// SPDX-License-Identifier: GPL-3.0-or-later
// The whole worker of a line over a transport that gives it the input's bytes: at once, late, in
// floods, or a lost line; and a person who arms, orders, asks, stops, closes and opens again. Time
// is virtual, everything is on one thread.
//
// The functions of transportregistry.h are this file's own, so that the worker gets its transport
// from here: the linker does not take the library's then.
#include "protocol/codec/packet.h"
#include "protocol/session/linkworker.h"
#include "protocol/session/openoptions.h"
#include "protocol/transport/transportregistry.h"
#include "tests/fuzz/peer.h"

#include <QCoreApplication>

#include <set>

using namespace trex;
using namespace std::chrono_literals;
using fuzz::holds;

namespace {

/// What one input stands for: the same stream of choices feeds the line and the person.
struct World {
    fuzz::Input* input = nullptr;
    LineSettings line;
    Instant now{1h};
    bool isOpen = false;
    bool mayMove = false; ///< armed, and no stop since
    std::multiset<QByteArray> orders; ///< given and not sent
    bool sawStop = false;
} world;

class FuzzTransport : public Transport {
public:
    void open(const LineSettings& /*settings*/) override
    {
        world.isOpen = world.input->isAtEnd() || world.input->byte() < 0xE0;
        if (world.isOpen) {
            emit opened();
        } else {
            emit failed({ErrorCode::PortMissing, QStringLiteral("fuzz")});
        }
    }
    void close() override { world.isOpen = false; }
    bool setLine(const LineSettings& /*settings*/) override { return true; }
    [[nodiscard]] bool canSetLine() const override { return true; }
    void write(const QByteArray& bytes) override
    {
        holds(world.isOpen, "nothing is written to a closed port");
        m_last = decodePacket(bytes, world.line);
        if (!m_last || m_last->command.row().kind != CommandKind::Motor) {
            return;
        }
        for (const bool brake : {false, true}) {
            for (const Command& stop : stopCommands(brake)) {
                if (m_last->command == stop) {
                    world.sawStop = true;
                    return;
                }
            }
        }
        const auto given = world.orders.find(bytes);
        holds(world.mayMove && given != world.orders.end(),
              "a motor order was given while armed, and is sent once");
        world.orders.erase(given);
    }
    bool waitForBytes(Duration longest) override
    {
        const int choice = world.input->isAtEnd() ? 0 : world.input->byte();
        const Duration part = std::min<Duration>(longest, std::chrono::microseconds(50 * choice));
        if (choice < 0x40 || !world.isOpen) {
            world.now += longest;
            return false;
        }
        world.now += part;
        if (choice < 0xA0) {
            return m_last && arrive(fuzz::honestReply(m_last->command, world.line));
        }
        if (choice < 0xE0) {
            return arrive(world.input->bytes(1 + (choice & 0x0F)));
        }
        if (choice < 0xF8) {
            return arrive(world.input->bytes(4).repeated(64));
        }
        world.isOpen = false;
        world.orders.clear();
        world.mayMove = false;
        emit failed({ErrorCode::LineLost, QStringLiteral("fuzz")});
        return false;
    }
    [[nodiscard]] Instant now() const override { return world.now; }
    [[nodiscard]] bool isRealTime() const override { return false; }

private:
    bool arrive(const QByteArray& bytes)
    {
        if (!bytes.isEmpty()) {
            emit received(bytes, world.now);
        }
        return !bytes.isEmpty();
    }
    Result<DecodedPacket> m_last = fail(ErrorCode::BadCommand);
};

/// Uses the worker as the façade does.
class Person {
public:
    Person()
    {
        QObject::connect(&m_worker, &LinkWorker::batchReady, &m_worker,
                         [this](const LinkBatch& batch) { take(batch); });
        QObject::connect(&m_worker, &LinkWorker::closed, &m_worker,
                         [this](quint32 generation) { m_closed.insert(generation); });
        open();
    }
    void play()
    {
        for (int turns = 0; turns < 300 && !world.input->isAtEnd(); ++turns) {
            act(world.input->byte());
            for (int i = 0; i < 3; ++i) {
                QCoreApplication::processEvents();
            }
        }
        close();
        holds(m_waiting.empty(), "everything that was asked ends by the time the line is closed");
    }

private:
    void open()
    {
        OpenOptions options;
        options.port = QStringLiteral("fuzz");
        options.line = world.line;
        options.reconnect = true;
        m_waiting.clear(); // of the connection before; nobody looks at its batches any more
        world.orders.clear();
        world.mayMove = false;
        m_worker.open(options, ++m_generation);
    }
    void close()
    {
        const bool wasConnected = m_isConnected && world.isOpen;
        world.sawStop = false;
        world.mayMove = false;
        world.orders.clear();
        const Instant begun = world.now;
        m_worker.close(stops());
        holds(m_closed.contains(m_generation), "a close is told");
        holds(!world.isOpen, "a closed port is closed");
        holds(world.now - begun < 2500ms, "a close takes a bounded time");
        holds(!wasConnected || world.sawStop || m_wasLost, "the motors are stopped before");
        m_isConnected = false;
    }
    void act(int choice)
    {
        switch (choice % 12) {
        case 0:
            ask({.command = query("get-status")});
            return;
        case 1:
            ask({.command = readParameter(std::uint8_t(choice & 0x7F))});
            return;
        case 2:
            ask({.command = writeParameter(7, std::uint8_t(choice & 0x7F))});
            return;
        case 3:
            m_worker.setArmed(true);
            world.mayMove = true;
            return;
        case 4:
        case 5: {
            const auto motor = static_cast<MotorId>(choice % 3);
            const auto command = driveMotor(motor, {MotorOrder::Action::Set, 1 + choice / 3});
            world.orders.insert(encode(*command, world.line));
            ask({.command = *command, .priority = Priority::Motor});
            return;
        }
        case 6:
            world.orders.clear();
            world.mayMove = false;
            m_worker.setArmed(false);
            m_worker.stop(stops());
            return;
        case 7: {
            PollWishes wishes{};
            wishes[std::size_t(choice) % wishes.size()] = 20.0;
            wishes[0] = choice;
            m_worker.setWishes(wishes);
            return;
        }
        case 8:
            if (choice > 0xC0) {
                close();
                open();
            }
            return;
        case 9:
            if (choice > 0xC0) {
                open(); // over an open line
            }
            return;
        default:
            return;
        }
    }
    void ask(Transaction transaction)
    {
        transaction.id = ++m_lastId;
        m_waiting.insert(m_lastId);
        m_worker.submit(transaction);
    }
    std::vector<Transaction> stops()
    {
        std::vector<Transaction> packets;
        for (const Command& command : stopCommands(false)) {
            packets.push_back({.id = ++m_lastId, .command = command, .priority = Priority::Stop});
            m_waiting.insert(m_lastId);
        }
        return packets;
    }
    void take(const LinkBatch& batch)
    {
        holds(batch.generation <= m_generation, "batches are of a line that was opened");
        if (batch.generation < m_generation) {
            return; // as the facade does
        }
        for (const Outcome& outcome : batch.outcomes) {
            holds(m_waiting.erase(outcome.id) == 1 || outcome.id <= m_lastId,
                  "what was asked is answered");
            holds(m_ended.insert(outcome.id).second, "each question ends once");
        }
        for (const LinkEvent& event : batch.events) {
            if (event.kind == LinkEvent::Kind::StateChanged) {
                m_isConnected = event.state == LinkState::Connected;
                m_wasLost = !m_isConnected;
                world.mayMove = world.mayMove && m_isConnected;
            }
        }
    }

    LinkWorker m_worker;
    quint32 m_generation = 0;
    quint64 m_lastId = 0;
    bool m_isConnected = false;
    bool m_wasLost = false;
    std::set<quint64> m_waiting;
    std::set<quint64> m_ended;
    std::set<quint32> m_closed;
};

} // namespace

namespace trex {

QList<PortInfo> availablePorts()
{
    return {};
}

Result<std::unique_ptr<Transport>> makeTransport(const QString& /*address*/)
{
    return std::make_unique<FuzzTransport>();
}

Result<void> checkAddress(const QString& /*address*/)
{
    return {};
}

} // namespace trex

extern "C" int LLVMFuzzerInitialize(int* argc, char*** argv)
{
    static QCoreApplication application(*argc, *argv);
    return 0;
}

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
    fuzz::Input input(data, size);
    world = {};
    world.input = &input;
    world.line = fuzz::anyLine(input);
    Person().play();
    QCoreApplication::sendPostedEvents(nullptr, QEvent::DeferredDelete);
    world.input = nullptr;
    return 0;
}
