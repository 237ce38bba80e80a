// SPDX-License-Identifier: GPL-3.0-or-later
#include "protocol/storage/recordingfeed.h"

#include "protocol/codec/commandtable.h"

using namespace Qt::Literals::StringLiterals;

namespace trex {
namespace {

constexpr std::chrono::seconds kHealthInterval{1};

Instant clockNow()
{
    return std::chrono::steady_clock::now();
}

QString textOf(std::string_view text)
{
    return QString::fromUtf8(text.data(), static_cast<qsizetype>(text.size()));
}

QString textOf(bool is)
{
    return is ? u"true"_s : u"false"_s;
}

RecordedPacket packetOf(const TransactionRecord& record)
{
    return {.sent = TimeAxis::ticksOf(record.sent),
            .ended = TimeAxis::ticksOf(record.ended),
            .priority = static_cast<int>(record.priority),
            .attempt = record.attempt,
            .error = record.error ? static_cast<int>(*record.error) : -1,
            .sentBytes = record.sentBytes,
            .receivedBytes = record.receivedBytes};
}

} // namespace

RecordingFeed::RecordingFeed(Controller& controller, QObject* parent)
    : QObject(parent), m_controller(controller), m_device(controller.device())
{
    connect(&controller, &Controller::eventLogged, this,
            [this](int severity, const QString& text) { tell(severity, "log"_L1, text); });
    connect(&controller, &Controller::stateChanged, this, [this](LinkState state) {
        const bool isLoss = state == LinkState::Lost || state == LinkState::Retrying;
        tell(isLoss ? 2 : 0, "link"_L1, keyOf(state));
        emit factsChanged();
    });
    connect(&controller, &Controller::armedChanged, this,
            [this](bool armed) { tell(0, "armed"_L1, textOf(armed)); });
    connect(&controller, &Controller::lockedOut, this, [this] { tell(1, "stop"_L1, {}); });
    connect(&controller, &Controller::restarted, this, [this] { tell(1, "restarted"_L1, {}); });
    connect(&controller, &Controller::deviceChanged, this, &RecordingFeed::onDevice);
    connect(&controller, &Controller::recordsArrived, this, &RecordingFeed::onRecords);
    connect(&controller, &Controller::batchArrived, this, &RecordingFeed::onBatch);
}

void RecordingFeed::tell(int severity, QLatin1StringView kind, const QString& text)
{
    emit eventSeen({TimeAxis::ticksOf(clockNow()), severity, kind, text});
}

void RecordingFeed::onRecords(const std::vector<TransactionRecord>& records)
{
    for (const TransactionRecord& record : records) {
        if (m_arePacketsWanted) {
            emit packetSeen(packetOf(record));
        }
        if (record.isRaw) {
            emit eventSeen({TimeAxis::ticksOf(record.sent), 0, u"raw"_s,
                            QString::fromLatin1(record.sentBytes.toHex().toUpper())});
            continue;
        }
        const CommandKind kind = record.command.row().kind;
        if (kind == CommandKind::Motor) {
            emit eventSeen(
                {TimeAxis::ticksOf(record.sent), 0, u"order"_s, describe(record.command)});
        } else if (kind == CommandKind::Setting) {
            emit eventSeen({TimeAxis::ticksOf(record.sent), record.error ? 1 : 0, u"setting"_s,
                            describe(record.command)});
        }
    }
}

void RecordingFeed::onBatch()
{
    const Instant now = clockNow();
    if (m_lastHealth && now - *m_lastHealth < kHealthInterval) {
        return;
    }
    m_lastHealth = now;
    const LinkStats& stats = m_controller.stats();
    emit healthSeen({.tick = TimeAxis::ticksOf(now),
                     .transactions = stats.transactions,
                     .retries = stats.retries,
                     .timeouts = stats.timeouts,
                     .crcErrors = stats.crcErrors,
                     .badReplies = stats.badReplies,
                     .surplusBytes = stats.surplusBytes,
                     .resyncs = stats.resyncs,
                     .bytesSent = stats.bytesSent,
                     .bytesReceived = stats.bytesReceived,
                     .roundTripMs = stats.roundTripMs,
                     .transactionsPerSecond = stats.transactionsPerSecond});
}

void RecordingFeed::onDevice()
{
    const DeviceInfo& device = m_controller.device();
    if (device.mode && device.mode != m_device.mode) {
        tell(0, "mode"_L1, textOf(keyOf(*device.mode)));
    }
    if (device.serialControls && device.serialControls != m_device.serialControls) {
        tell(0, "serial-control"_L1, textOf(*device.serialControls));
    }
    if (device.learnedMask && device.learnedMask != m_device.learnedMask) {
        tell(0, "learned"_L1, QString::number(*device.learnedMask));
    }
    m_device = device;
    emit factsChanged();
}

std::vector<RecordedEvent> RecordingFeed::state() const
{
    const DeviceInfo& device = m_controller.device();
    const Tick now = TimeAxis::ticksOf(clockNow());
    std::vector<RecordedEvent> events;
    const auto add = [&](QLatin1StringView kind, const QString& text) {
        events.push_back({now, 0, kind, text});
    };
    add("link"_L1, keyOf(m_controller.state()));
    add("armed"_L1, textOf(m_controller.isArmed()));
    if (device.mode) {
        add("mode"_L1, textOf(keyOf(*device.mode)));
    }
    if (device.serialControls) {
        add("serial-control"_L1, textOf(*device.serialControls));
    }
    if (device.learnedMask) {
        add("learned"_L1, QString::number(*device.learnedMask));
    }
    return events;
}

bool RecordingFeed::isState(const QString& kind)
{
    static const std::array kinds{u"link"_s, u"armed"_s, u"mode"_s, u"serial-control"_s,
                                  u"learned"_s};
    return std::find(kinds.begin(), kinds.end(), kind) != kinds.end();
}

RecordingFacts RecordingFeed::facts() const
{
    using namespace recordingfact;
    const OpenOptions& options = m_controller.options();
    const DeviceInfo& device = m_controller.device();
    RecordingFacts facts;
    const auto set = [&facts](const char* name, const QString& value) {
        facts[QString::fromLatin1(name)] = value;
    };
    set(kPort, options.port);
    set(kBaud, QString::number(options.line.baud));
    set(kErrorDetection, textOf(keyOf(options.line.errorDetection)));
    set(kStopBits, QString::number(options.line.stopBits));
    set(kProtocol, textOf(keyOf(options.line.form)));
    set(kDevice, QString::number(options.line.device));
    if (device.signature) { // what a lost link forgets stays in the file
        set(kSignature, device.signature->text());
    }
    if (device.mode) {
        set(kMode, textOf(keyOf(*device.mode)));
    }
    return facts;
}

} // namespace trex
