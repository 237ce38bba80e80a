// SPDX-License-Identifier: GPL-3.0-or-later
// What goes into a recording and comes out of it. Plain values: they cross to the recorder's
// thread.
#pragma once

#include "protocol/storage/configfile.h"
#include "protocol/storage/recordingblock.h"

#include <QString>

#include <array>
#include <map>

namespace trex {

/// Facts of the whole recording by name; the names are listed in protocol/storage/recording.md.
/// Later facts replace earlier ones.
using RecordingFacts = std::map<QString, QString>;
namespace recordingfact {
inline constexpr auto kProgram = "program", kProgramVersion = "program-version",
                      kStartedUtc = "started-utc", kSteadyOriginNs = "steady-origin-ns",
                      kPort = "port", kBaud = "baud", kErrorDetection = "error-detection",
                      kStopBits = "stop-bits", kProtocol = "protocol", kDevice = "device",
                      kSignature = "signature", kMode = "mode", kEndedTick = "ended-tick",
                      kDropped = "dropped", kReason = "reason";
}

// All ticks count from the recording's origin.

struct RecordedEvent {
    Tick tick = 0;
    int severity = 0; ///< 0 information, 1 warning, 2 error
    QString kind; ///< "log", "armed", "stop", …: protocol/storage/recording.md
    QString text;
    bool operator==(const RecordedEvent&) const = default;
};

struct RecordedPacket {
    Tick sent = 0;
    Tick ended = 0;
    int priority = 0; ///< Priority
    int attempt = 1;
    int error = -1; ///< ErrorCode; −1: complete and valid, or nothing was due
    QByteArray sentBytes;
    QByteArray receivedBytes;
    bool operator==(const RecordedPacket&) const = default;
};

/// The counters of the line since it was opened (LinkStats).
struct RecordedHealth {
    Tick tick = 0;
    quint64 transactions = 0;
    quint64 retries = 0;
    quint64 timeouts = 0;
    quint64 crcErrors = 0;
    quint64 badReplies = 0;
    quint64 surplusBytes = 0;
    quint64 resyncs = 0;
    quint64 bytesSent = 0;
    quint64 bytesReceived = 0;
    double roundTripMs = 0.0;
    double transactionsPerSecond = 0.0;
    bool operator==(const RecordedHealth&) const = default;
};

struct RecordedConfiguration {
    Tick tick = 0;
    Configuration configuration;
};

/// One go at the file: all of it is written, or nothing.
struct RecordingBatch {
    RecordingFacts facts;
    std::array<SampleRun, kSourceCount> runs;
    std::vector<RecordedEvent> events;
    std::vector<RecordedPacket> packets;
    std::vector<RecordedHealth> health;
    std::vector<RecordedConfiguration> configurations;

    [[nodiscard]] std::size_t samples() const
    {
        std::size_t count = 0;
        for (const SampleRun& run : runs) {
            count += run.size();
        }
        return count;
    }
    [[nodiscard]] bool isEmpty() const
    {
        return samples() == 0 && facts.empty() && events.empty() && packets.empty()
            && health.empty() && configurations.empty();
    }
};

} // namespace trex
