// SPDX-License-Identifier: GPL-3.0-or-later
#include "protocol/session/linkworker.h"

#include "protocol/codec/packet.h"
#include "protocol/session/openoptions.h"
#include "protocol/transport/laststop.h"
#include "protocol/transport/transportregistry.h"

namespace trex {

namespace {

using namespace std::chrono_literals;

constexpr auto kBatchInterval = 17ms; // at most 60 batches a second
constexpr auto kReopenInterval = 500ms;
constexpr auto kLongestClose = 1000ms;
// Shorter waits are spent on the port itself: timers of the event loop are a millisecond coarse.
constexpr auto kShortWait = 2ms;
// A stop that the façade has posted gets its turn after this much, however long the timeout is.
constexpr auto kLongestBlock = 20ms;

} // namespace

LinkWorker::LinkWorker() : m_wake(this), m_reopen(this), m_publish(this), m_freeze(this)
{
    for (QTimer* timer : {&m_wake, &m_reopen, &m_publish}) {
        timer->setSingleShot(true);
    }
    m_wake.setTimerType(Qt::PreciseTimer);
    connect(&m_wake, &QTimer::timeout, this, &LinkWorker::pump);
    connect(&m_reopen, &QTimer::timeout, this, &LinkWorker::openTransport);
    connect(&m_publish, &QTimer::timeout, this, [this] { publish(true); });
    m_freeze.setInterval(kHeartbeat);
    connect(&m_freeze, &QTimer::timeout, this, &LinkWorker::lookForFreeze);
}

LinkWorker::~LinkWorker()
{
    laststop::withdraw(this);
}

Instant LinkWorker::clockNow() const
{
    return m_transport ? m_transport->now() : std::chrono::steady_clock::now();
}

void LinkWorker::open(const OpenOptions& options, quint32 generation)
{
    m_reopen.stop();
    if (m_engine) {
        m_engine->shutDown();
        sendRest();
    }
    closeTransport();
    m_generation = generation;
    m_line = options.line;
    m_stopOnClose = options.stopOnClose;
    setArmed(false);
    // A simulated controller keeps its power while the line is closed.
    const bool isNew = !m_transport || m_address != options.port;
    auto made = isNew ? makeTransport(options.port) : Result<std::unique_ptr<Transport>>{};
    m_reconnect = options.reconnect && made; // an address that makes no sense never will
    if (made && isNew) {
        m_transport = std::move(*made);
    }
    m_engine = std::make_unique<LinkEngine>(options.line, options.identify, m_reconnect,
                                            made && m_transport->canSetLine(), options.stopOnClose);
    if (!made) {
        m_transport.reset();
        m_engine->lineFailed(made.error(), clockNow());
        publish(true);
        return;
    }
    if (isNew) {
        m_address = options.port;
        connect(m_transport.get(), &Transport::opened, this, [this] {
            m_isOpen = true;
            m_engine->opened(clockNow(), m_transport->adapter());
            schedulePump();
        });
        connect(m_transport.get(), &Transport::received, this, &LinkWorker::onReceived);
        connect(m_transport.get(), &Transport::failed, this, &LinkWorker::onFailed);
    }
    m_engine->setWishes(m_wishes, clockNow());
    openTransport();
}

void LinkWorker::openTransport()
{
    if (m_transport && m_engine && !m_isOpen) {
        m_transport->open(m_line);
    }
}

void LinkWorker::closeTransport()
{
    if (std::exchange(m_isOpen, false)) {
        withdrawLastStop();
        m_transport->close();
    }
}

void LinkWorker::onReceived(const QByteArray& bytes, Instant at)
{
    if (m_engine && m_isOpen && m_flood.isTooMuch(bytes.size(), at)) {
        cutOff();
    } else if (m_engine && m_isOpen) {
        m_engine->received(bytes, at);
        schedulePump();
    }
}

void LinkWorker::onFailed(const Error& error)
{
    m_isOpen = false;
    withdrawLastStop();
    if (!m_engine) {
        return;
    }
    m_engine->lineFailed(error, clockNow());
    publish(true);
    if (!m_reconnect) {
        return;
    }
    if (m_transport && !m_transport->isRealTime()) {
        m_transport->waitForBytes(kReopenInterval);
        m_reopen.start(0);
    } else {
        m_reopen.start(kReopenInterval);
    }
}

void LinkWorker::submit(const Transaction& transaction)
{
    if (m_engine && transaction.priority == Priority::Motor && !m_isArmed) {
        refuse(transaction); // it was under way when the gate closed on this side
    } else if (m_engine) {
        m_engine->submit(transaction);
        schedulePump();
    }
}

void LinkWorker::stop(const std::vector<Transaction>& packets)
{
    m_silentUntil = {};
    if (m_engine) {
        m_engine->stop(packets, clockNow());
        pump();
    }
}

void LinkWorker::setWishes(const PollWishes& wishes)
{
    m_wishes = wishes;
    if (m_engine) {
        m_engine->setWishes(wishes, clockNow());
        schedulePump();
    }
}

void LinkWorker::powerCycle()
{
    if (m_transport) {
        m_transport->powerCycle();
    }
}

void LinkWorker::resetHealth()
{
    if (m_engine) {
        m_engine->resetHealth(clockNow());
    }
}

void LinkWorker::close(const std::vector<Transaction>& packets)
{
    m_reopen.stop();
    m_silentUntil = {};
    setArmed(false);
    if (m_engine) {
        m_engine->shutDown();
        m_engine->stop(packets, clockNow());
        sendRest();
        m_isOpen = false;
        withdrawLastStop();
        publish(true);
        m_engine.reset();
    }
    m_wake.stop();
    m_publish.stop();
    if (m_transport) {
        m_transport->close();
    }
    emit closed(m_generation);
}

/// What has to be out before the port is closed: stops, and what closes open packets. Bounded.
void LinkWorker::sendRest()
{
    const Instant end = clockNow() + kLongestClose;
    while (m_isOpen && (m_engine->isStopQueued() || m_engine->isClearing()) && clockNow() < end) {
        const LinkEngine::Action action = m_engine->next(clockNow());
        if (action.kind == LinkEngine::Action::Kind::Send) {
            send(action);
        } else if (action.kind == LinkEngine::Action::Kind::Wait) {
            m_transport->waitForBytes(
                std::max<Duration>(std::min(action.until, end) - clockNow(), Duration(1)));
        } else {
            break;
        }
    }
    // The port is closed only when the last byte has had its time on the wire.
    for (Instant now = clockNow(); m_isOpen && now < std::min(end, m_engine->lineFreeAt());
         now = clockNow()) {
        m_transport->waitForBytes(m_engine->lineFreeAt() - now);
    }
}

/// On a line that cannot be set as asked nothing goes out: it would be read otherwise.
void LinkWorker::send(const LinkEngine::Action& action)
{
    if (!action.line || m_transport->setLine(*action.line)) {
        m_transport->write(action.bytes);
    }
}

void LinkWorker::schedulePump()
{
    // One pump at a time, through the event loop: what the façade has posted gets its turn.
    if (!m_isPumping && !m_isPumpPosted) {
        m_isPumpPosted = true;
        QMetaObject::invokeMethod(
            this,
            [this] {
                m_isPumpPosted = false;
                pump();
            },
            Qt::QueuedConnection);
    }
}

void LinkWorker::pump()
{
    if (m_isPumping || !m_engine || !m_isOpen) {
        publish(false);
        return;
    }
    m_isPumping = true;
    const bool more = step();
    m_isPumping = false;
    publish(false);
    if (more) {
        schedulePump();
    }
}

bool LinkWorker::step()
{
    const Duration silence = m_silentUntil - clockNow();
    if (silence > Duration::zero() && !m_engine->isStopQueued() && !m_engine->isReplyDue()) {
        if (m_transport->isRealTime()) {
            m_wake.start(std::chrono::ceil<std::chrono::milliseconds>(silence));
            return false;
        }
        m_transport->waitForBytes(silence);
        return true;
    }
    const LinkEngine::Action action = m_engine->next(clockNow());
    switch (action.kind) {
    case LinkEngine::Action::Kind::Idle:
        if (m_engine->state() == LinkState::Disconnected) {
            closeTransport(); // given up: the port is free for others
        }
        return false;
    case LinkEngine::Action::Kind::Send:
        send(action);
        waitForReply();
        return true;
    case LinkEngine::Action::Kind::Wait:
        break;
    }
    if (m_engine->isReplyDue() && !m_engine->isReplyOverdue(clockNow())) {
        waitForReply();
        return true;
    }
    const Duration wait = action.until - clockNow();
    if (wait <= kShortWait || !m_transport->isRealTime()) {
        if (wait > Duration::zero()) {
            m_transport->waitForBytes(wait);
        }
        return true;
    }
    m_wake.start(std::chrono::floor<std::chrono::milliseconds>(wait));
    return false;
}

/// Waits on the port while a reply is due: nothing may be sent before it anyway, and the event loop
/// would cost a part of the line (42 µs a reply against 68 µs). Bounded, and not beyond the time at
/// which a stop need not wait any longer; the caller comes again.
void LinkWorker::waitForReply()
{
    const Instant end = clockNow() + kLongestBlock;
    for (Instant now = clockNow();
         m_isOpen && m_engine->isReplyDue() && !m_engine->isReplyOverdue(now) && now < end;
         now = clockNow()) {
        const LinkEngine::Action action = m_engine->next(now);
        if (action.kind == LinkEngine::Action::Kind::Send) {
            send(action);
        } else if (action.kind == LinkEngine::Action::Kind::Wait && m_engine->isReplyDue()) {
            const Instant until = std::min({action.until, end, m_engine->overdueAt()});
            m_transport->waitForBytes(std::max<Duration>(until - clockNow(), Duration(1)));
        }
        publish(false);
    }
}

void LinkWorker::publish(bool always)
{
    if (!m_engine) {
        return;
    }
    followState();
    const Instant now = clockNow();
    if (!always && !m_engine->hasNews() && now - m_lastPublished < kBatchInterval) {
        if (!m_publish.isActive()) {
            m_publish.start(kBatchInterval);
        }
        return;
    }
    m_lastPublished = now;
    m_publish.stop();
    LinkBatch batch = m_engine->takeBatch(now);
    batch.generation = m_generation;
    emit batchReady(batch);
}

} // namespace trex
