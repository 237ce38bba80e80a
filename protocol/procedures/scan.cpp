// SPDX-License-Identifier: GPL-3.0-or-later
#include "protocol/procedures/scan.h"

#include "protocol/codec/packet.h"
#include "protocol/codec/parametertable.h"
#include "protocol/codec/replyparser.h"

#include <utility>

namespace trex {
namespace {

constexpr int kSignatureJr = 9; // command documentation, 0x81
constexpr std::uint8_t kLastDeviceNumber = 127;

// The default first (facts.md 2), then as people use them; 76800 is the least certain (facts.md
// 2.3).
constexpr std::array<int, 11> kLikelyRates{19200, 115200, 9600,  38400, 57600, 2400,
                                           4800,  28800,  14400, 1200,  76800};
static_assert(kLikelyRates.size() == kBaudRates.size());
constexpr std::array kLikelyDetections{ErrorDetection::None, ErrorDetection::Crc7,
                                       ErrorDetection::Even, ErrorDetection::Odd};

bool isSameLine(const LineSettings& a, const LineSettings& b)
{
    return a.baud == b.baud && a.errorDetection == b.errorDetection && a.stopBits == b.stopBits
        && a.form == b.form && (a.form == PacketForm::Compact || a.device == b.device);
}

void addTry(std::vector<ScanTry>& tries, const LineSettings& line)
{
    for (const ScanTry& before : tries) {
        if (isSameLine(before.line, line)) {
            return;
        }
    }
    tries.push_back({line});
}

} // namespace

LineSettings ScanHit::line(const LineSettings& base) const
{
    LineSettings settings = base;
    settings.baud = baud;
    settings.errorDetection = errorDetection;
    settings.stopBits = stopBits;
    settings.device = device;
    return settings;
}

std::vector<ScanTry> scanPlan(const LineSettings& given)
{
    std::vector<ScanTry> tries;
    LineSettings line = given;
    line.timeout = Scan::kReplyTimeout;
    addTry(tries, line);
    for (const PacketForm form : {PacketForm::Compact, PacketForm::Pololu}) {
        line.form = form;
        for (const ErrorDetection detection : kLikelyDetections) {
            line.errorDetection = detection;
            for (const int baud : kLikelyRates) {
                line.baud = baud;
                addTry(tries, line);
            }
        }
    }
    return tries;
}

Scan::Scan(ScanOptions options, QObject* parent)
    : Procedure(parent), m_options(std::move(options)), m_controller(nullptr, nullptr)
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
    const auto plan = scanPlan(m_options.line);
    m_tries.assign(plan.begin(), plan.end());
    m_hits.clear();
    m_done = 0;
    m_answered.reset();
    m_ending.reset();
    m_elapsed.start();
    setRunning();
    next();
}

void Scan::cancel()
{
    if (isRunning() && !m_ending) {
        end(fail(ErrorCode::Cancelled));
    }
}

Duration Scan::estimatedRemaining() const
{
    if (m_done == 0) {
        return Duration::zero();
    }
    return std::chrono::milliseconds(m_elapsed.elapsed() * static_cast<qint64>(m_tries.size())
                                     / m_done);
}

void Scan::next()
{
    if (m_current.isSweep && (m_tries.empty() || !m_tries.front().isSweep)) {
        endSweep();
    }
    if (m_tries.empty()) {
        end(m_hits.empty() ? Result<void>(fail(ErrorCode::NoReply, m_options.port))
                           : Result<void>());
        return;
    }
    m_current = m_tries.front();
    m_tries.pop_front();
    const LineSettings& line = m_current.line;
    const int total = m_done + static_cast<int>(m_tries.size()) + 1;
    //: %1 a baud rate; %2 none, even, odd or crc7
    QString text = tr("Trying %1 baud, error detection %2")
                       .arg(line.baud)
                       .arg(QString::fromLatin1(keyOf(line.errorDetection)));
    if (line.form == PacketForm::Pololu) {
        text = tr("%1, device %2").arg(text).arg(line.device);
    }
    emit progressed(m_done, total, text);
    if (!isRunning() || m_ending) {
        return; // cancelled by a listener
    }
    ++m_done;
    m_isProbing = true;
    // A fresh connection for each try, believed in without a question: one that follows a probe
    // without an answer would be more than 0x81. And nothing is sent at its end.
    m_controller.open({.port = m_options.port,
                       .line = line,
                       .identify = false,
                       .stopOnClose = false,
                       .reconnect = false});
}

void Scan::onState(LinkState state)
{
    if (!isRunning() || m_ending || !m_isProbing) {
        return;
    }
    if (state == LinkState::Connected) {
        probe();
    } else if (state == LinkState::Disconnected && m_controller.lastError()) {
        // The port itself failed: no other speed will help.
        end(tl::make_unexpected(*m_controller.lastError()));
    }
}

void Scan::probe()
{
    m_received.clear();
    m_controller.requestRaw(encode(query("get-signature"), m_current.line), kSignatureJr, this,
                            [this](const Result<Reply>&) { onAnswer(); });
}

/// The bytes that came may make a signature even when the request ended without all that it waited
/// for: a TReX answers two bytes fewer than a TReX Jr (conformance C-70).
std::optional<Signature> Scan::signatureIn(const QByteArray& bytes) const
{
    const qsizetype start = bytes.indexOf("TReX");
    if (start < 0) {
        return std::nullopt;
    }
    ReplyParser parser(query("get-signature"), m_current.line);
    parser.feed(QByteArrayView(bytes).sliced(start));
    if (parser.verdict() != ReplyParser::Verdict::Complete) {
        return std::nullopt;
    }
    const auto signature = parseSignature(parser.payload());
    return signature ? std::optional(*signature) : std::nullopt;
}

void Scan::onAnswer()
{
    if (!isRunning() || m_ending || m_controller.state() != LinkState::Connected) {
        return; // onState() has ended it
    }
    const auto signature = signatureIn(m_received);
    if (!signature) {
        next();
    } else if (m_current.isSweep) {
        m_answered.reset();
        addHit(m_current.line.device, *signature);
        next();
    } else if (m_current.line.errorDetection == ErrorDetection::None) {
        confirm(*signature);
    } else {
        accept(*signature);
    }
}

/// A controller set to odd parity takes an 0x81 that was sent without: its parity bit is 1, as a
/// stop bit is. That of 0x83 is 0, so that such a controller does not answer it.
void Scan::confirm(const Signature& signature)
{
    m_controller.requestRaw(encode(query("get-serial-control"), m_current.line), 1, this,
                            [this, signature](const Result<Reply>& reply) {
                                if (!isRunning() || m_ending
                                    || m_controller.state() != LinkState::Connected) {
                                    return;
                                }
                                reply ? accept(signature) : next();
                            });
}

void Scan::accept(const Signature& signature)
{
    if (m_options.all) {
        m_answered = hitFor(m_current.line.device, signature);
        sweepDevices();
        next();
    } else if (m_current.line.form == PacketForm::Pololu) {
        addHit(m_current.line.device, signature);
        end({});
    } else {
        askDeviceNumber(signature);
    }
}

void Scan::askDeviceNumber(const Signature& signature)
{
    // The line is right, so that a query other than 0x81 is safe now.
    m_controller.request(readParameter(parameterRow("device-number").number), this,
                         [this, signature](const Result<Reply>& reply) {
                             if (!isRunning() || m_ending) {
                                 return;
                             }
                             addHit(reply ? static_cast<std::uint8_t>(reply->payload.front())
                                          : m_current.line.device,
                                    signature);
                             end({});
                         });
}

/// Every device number on this line next, then on with the rest of the plan.
void Scan::sweepDevices()
{
    LineSettings line = m_current.line;
    line.form = PacketForm::Pololu;
    std::erase_if(m_tries, [&line](const ScanTry& other) {
        return other.line.form == PacketForm::Pololu && other.line.baud == line.baud
            && other.line.errorDetection == line.errorDetection;
    });
    for (int device = kLastDeviceNumber; device >= 0; --device) {
        line.device = static_cast<std::uint8_t>(device);
        m_tries.push_front({line, true});
    }
}

/// A controller that answers compact packets and no device number is still one.
void Scan::endSweep()
{
    if (const auto hit = std::exchange(m_answered, std::nullopt)) {
        m_hits.push_back(*hit);
        emit found(*hit);
    }
}

ScanHit Scan::hitFor(std::uint8_t device, const Signature& signature) const
{
    const LineSettings& line = m_current.line;
    return {line.baud, line.errorDetection, line.stopBits,
            device,    signature,           m_controller.stats().echo};
}

void Scan::addHit(std::uint8_t device, const Signature& signature)
{
    m_hits.push_back(hitFor(device, signature));
    emit found(m_hits.back());
}

void Scan::end(const Result<void>& result)
{
    m_tries.clear();
    m_isProbing = false;
    m_ending = result;
    m_controller.close();
}

void Scan::onClosed()
{
    if (!m_ending) {
        return;
    }
    if (m_controller.state() != LinkState::Disconnected) {
        m_controller.close(); // a try that was under way has opened it once more
        return;
    }
    finish(*std::exchange(m_ending, std::nullopt));
}

} // namespace trex
