// SPDX-License-Identifier: GPL-3.0-or-later
#include "protocol/procedures/scan.h"

#include "protocol/codec/packet.h"
#include "protocol/codec/parametertable.h"

#include <QTimer>

#include <utility>

namespace trex {
namespace {

using namespace Qt::Literals::StringLiterals;

constexpr int kDeviceNumbers = 128;
constexpr int kSignatureJr = 9; // command documentation, 0x81

LineSearchOptions searchOptions(const ScanOptions& options)
{
    return {.given = options.line,
            .remembered = options.remembered,
            .only = options.only,
            .isNetwork = options.port.startsWith("tcp:"_L1)};
}

} // namespace

LineSettings ScanHit::line(const LineSettings& base) const
{
    LineSettings settings = base;
    settings.baud = baud;
    settings.errorDetection = errorDetection;
    settings.stopBits = stopBits;
    settings.device = device;
    if (settings.hasCrc()) {
        settings.polynomial = polynomial;
    }
    return settings;
}

Scan::Scan(ScanOptions options, QObject* parent)
    : Procedure(parent)
    , m_options(std::move(options))
    , m_search(searchOptions(m_options))
    , m_controller(nullptr, nullptr)
{
    connect(&m_controller, &Controller::stateChanged, this, &Scan::onState);
    connect(&m_controller, &Controller::closed, this, &Scan::onClosed, Qt::QueuedConnection);
    connect(&m_controller, &Controller::recordsArrived, this,
            [this](const std::vector<TransactionRecord>& records) {
                m_received = records.back().receivedBytes;
            });
}

void Scan::start()
{
    m_search = LineSearch(searchOptions(m_options));
    m_hits.clear();
    m_sweep.clear();
    m_swept = 0;
    m_step = Step::Search;
    m_ending.reset();
    m_isCancelled = false;
    m_elapsed.start();
    setRunning();
    next();
}

void Scan::cancel()
{
    if (isOver() || m_isCancelled) {
        return;
    }
    m_isCancelled = true;
    const bool isWaiting = m_step != Step::Search;
    m_sweep.clear();
    if (isWaiting) {
        end(fail(ErrorCode::Cancelled)); // on a line that is known: nothing to clear
    } else {
        m_search.giveUp(); // what is on its way ends first
    }
}

Duration Scan::estimatedRemaining() const
{
    const int done = m_search.done() + m_swept;
    if (done == 0) {
        return Duration::zero();
    }
    const auto left = m_search.total() - m_search.done() + static_cast<int>(m_sweep.size());
    return std::chrono::milliseconds(m_elapsed.elapsed() * left / done);
}

void Scan::next()
{
    if (m_step == Step::Sweep) {
        if (m_sweep.empty()) {
            endSweep();
            return;
        }
        m_hit.device = m_sweep.front();
        m_sweep.pop_front();
        LineSettings line = m_hit.line(m_options.line);
        line.form = PacketForm::Pololu;
        m_ask = {line, encode(query("get-signature"), line), kSignatureJr, true};
        ++m_swept;
        tell();
        openFor(line);
        return;
    }
    const auto ask = m_search.next();
    if (!ask && m_isCancelled) {
        end(fail(ErrorCode::Cancelled));
        return;
    }
    if (!ask) {
        m_search.found()
            ? onFound()
            : end(m_hits.empty() ? fail(ErrorCode::NoReply, m_options.port) : Result<void>());
        return;
    }
    m_ask = *ask;
    if (m_ask.isTry) {
        tell();
        if (m_isCancelled) { // by a listener
            next();
            return;
        }
    }
    openFor(m_ask.line);
}

void Scan::tell()
{
    const LineSettings& line = m_ask.line;
    //: %1 a baud rate; %2 none, even, odd or crc7
    QString text = tr("Trying %1 baud, error detection %2")
                       .arg(line.baud)
                       .arg(QString::fromLatin1(keyOf(line.errorDetection)));
    if (line.form == PacketForm::Pololu) {
        text = tr("%1, device %2").arg(text).arg(line.device);
    }
    emit progressed(m_search.done() - 1 + m_swept,
                    m_search.total() + m_swept + static_cast<int>(m_sweep.size()), text);
}

/// A fresh connection for each question, believed in without another: one that follows a probe
/// without an answer would be more than the probe. And nothing is sent at its end.
void Scan::openFor(const LineSettings& line)
{
    if (isOver()) {
        return;
    }
    m_isAsking = true;
    m_controller.open({.port = m_options.port,
                       .line = line,
                       .identify = false,
                       .stopOnClose = false,
                       .reconnect = false});
}

void Scan::onState(LinkState state)
{
    if (isOver() || !m_isAsking) {
        return;
    }
    if (state == LinkState::Connected) {
        onConnected();
    } else if (state == LinkState::Disconnected && m_controller.lastError()) {
        // The port itself failed: no other speed will help.
        end(tl::make_unexpected(*m_controller.lastError()));
    }
}

void Scan::onConnected()
{
    if (m_step == Step::Details) {
        askStopBits();
        return;
    }
    m_received.clear();
    m_controller.requestRaw(m_ask.bytes, m_ask.replyBytes, this, [this](const Result<Reply>&) {
        if (m_ask.replyBytes > 0) {
            onAnswer();
        } else {
            // Handed over; then its own time on the wire, and the rest.
            const Duration wire = m_ask.line.timeOf(static_cast<int>(m_ask.bytes.size()));
            QTimer::singleShot(std::chrono::ceil<std::chrono::milliseconds>(wire) + kWireRest, this,
                               &Scan::onAnswer);
        }
    });
}

void Scan::onAnswer()
{
    if (isOver() || m_controller.state() != LinkState::Connected) {
        return; // onState() has ended it
    }
    if (m_step == Step::Sweep) {
        onSwept();
    } else {
        if (!m_isCancelled) {
            m_search.answer(m_received);
        }
        next();
    }
}

void Scan::onFound()
{
    const LineFound& found = *m_search.found();
    m_hit = {found.line.baud,       found.line.errorDetection,
             found.line.stopBits,   found.line.device,
             found.signature,       found.echo,
             found.line.polynomial, found.status};
    m_step = Step::Details;
    LineSettings line = m_hit.line(m_options.line);
    line.form = PacketForm::Compact;
    line.echo = found.echo ? EchoMode::On : EchoMode::Off;
    openFor(line);
}

/// The line works with one stop bit and with two: only the controller knows what it was told. What
/// is stored may wait for a power cycle; then speed and error detection tell.
void Scan::askStopBits()
{
    m_controller.request(readParameter(parameterRow("uart-settings").number), this,
                         [this](const Result<Reply>& reply) {
                             if (isOver()) {
                                 return;
                             }
                             if (reply) {
                                 const auto stored = UartSettings::fromRaw(
                                     static_cast<std::uint8_t>(reply->payload.front()));
                                 if (stored && stored->baudIndex == baudIndex(m_hit.baud)
                                     && stored->errorDetection == m_hit.errorDetection) {
                                     m_hit.stopBits = stored->stopBits;
                                 }
                             }
                             m_options.all ? sweepDevices() : askDeviceNumber();
                         });
}

void Scan::askDeviceNumber()
{
    m_controller.request(readParameter(parameterRow("device-number").number), this,
                         [this](const Result<Reply>& reply) {
                             if (isOver()) {
                                 return;
                             }
                             if (reply) {
                                 m_hit.device = static_cast<std::uint8_t>(reply->payload.front());
                             }
                             addHit();
                             end({});
                         });
}

/// Every device number on this line next, then on with the rest of the plan.
void Scan::sweepDevices()
{
    m_step = Step::Sweep;
    m_sweptAny = false;
    for (int device = 0; device < kDeviceNumbers; ++device) {
        m_sweep.push_back(static_cast<std::uint8_t>(device));
    }
    next();
}

void Scan::onSwept()
{
    if (const auto signature = signatureIn(m_received, m_ask.line)) {
        m_hit.signature = *signature;
        m_sweptAny = true;
        addHit();
    }
    next();
}

/// A controller that answers compact packets and no device number is still one.
void Scan::endSweep()
{
    if (!m_sweptAny) {
        m_hit.device = m_options.line.device;
        m_hit.signature = m_search.found()->signature;
        addHit();
    }
    m_step = Step::Search;
    m_search.resume();
    next();
}

void Scan::addHit()
{
    m_hits.push_back(m_hit);
    emit found(m_hits.back());
}

void Scan::end(const Result<void>& result)
{
    m_sweep.clear();
    m_isAsking = false;
    m_ending = result;
    m_controller.close();
}

void Scan::onClosed()
{
    if (!m_ending) {
        return;
    }
    if (m_controller.state() != LinkState::Disconnected) {
        m_controller.close(); // a question that was under way has opened it once more
        return;
    }
    finish(*std::exchange(m_ending, std::nullopt));
}

} // namespace trex
