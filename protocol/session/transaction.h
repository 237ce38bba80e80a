// SPDX-License-Identifier: GPL-3.0-or-later
// What goes through the link: asked transactions in, replies and records out. Plain values.
#pragma once

#include "protocol/codec/command.h"
#include "protocol/codec/linesettings.h"
#include "protocol/codec/polltable.h"
#include "protocol/codec/replies.h"
#include "protocol/result.h"
#include "protocol/session/linkhealth.h"

#include <array>
#include <vector>

namespace trex {

/// High to low. A lower class never goes before a higher one.
enum class Priority : std::uint8_t { Stop, Motor, User, Poll };

struct Transaction {
    quint64 id = 0; ///< 0: nobody waits for the outcome
    Command command{};
    Priority priority = Priority::User;
    QByteArray rawBytes{}; ///< not empty: sent as given instead of the command, for `raw`
    int rawReplyBytes = 0; ///< reply bytes to wait for with rawBytes, CRC byte not counted
};

struct Reply {
    Command command{};
    QByteArray payload; ///< without echo and CRC byte; empty for motor commands
    QByteArray sentBytes; ///< as framed
    Instant sent;
    Instant received; ///< time of the read that completed it
};

/// The end of a transaction that somebody waits for.
struct Outcome {
    quint64 id = 0;
    Result<Reply> reply = fail(ErrorCode::Cancelled);
};

/// One attempt on the wire, for the packet view, the logs and the metrics.
struct TransactionRecord {
    Command command{};
    Priority priority = Priority::Poll;
    QByteArray sentBytes;
    QByteArray receivedBytes; ///< what came, valid or not, echo left out
    Instant sent;
    Instant ended;
    int attempt = 1;
    std::optional<ErrorCode> error; ///< none: complete and valid (or nothing was due)
    bool isRaw = false; ///< sent as given; command means nothing
};

/// Counters since the line was opened.
struct LinkStats {
    quint64 transactions = 0; ///< packets sent, retries and stops included
    quint64 retries = 0;
    quint64 timeouts = 0;
    quint64 crcErrors = 0;
    quint64 badReplies = 0; ///< complete but implausible
    quint64 surplusBytes = 0; ///< late or unasked bytes, flushed
    quint64 resyncs = 0;
    quint64 bytesSent = 0; ///< echo left out
    quint64 bytesReceived = 0; ///< echo left out
    quint64 lostLatchReads = 0; ///< 0x84/0x85 replies lost: latched bits may have gone with them
    bool echo = false; ///< the line echoes what is sent
    double roundTripMs = 0.0; ///< smoothed, send to complete reply
    double transactionsPerSecond = 0.0; ///< over the last second
    std::array<double, kPollCount> achievedHertz{}; ///< by PollId, over the last second
    std::array<double, kPollCount> askedHertz{};
    double pollScale = 1.0; ///< below 1: the line is too slow for what the panels ask
};

enum class LinkState : std::uint8_t { Disconnected, Connecting, Connected, Lost, Retrying };
[[nodiscard]] QLatin1StringView keyOf(LinkState state); ///< "disconnected" …, never translated

/// Something that happened on the link thread.
struct LinkEvent {
    enum class Kind : std::uint8_t {
        StateChanged, ///< state, and error when it was one
        Identified, ///< signature
        LatchReadLost, ///< a status or UART byte's reply was lost with its latched bits
        Resynchronised, ///< late or foreign bytes were flushed
        EchoFound,
    };
    Kind kind = Kind::StateChanged;
    LinkState state = LinkState::Disconnected;
    std::optional<Error> error;
    std::optional<Signature> signature;
    Instant time;
};

/// What crosses from the link thread to the façade: values only, at most 60 times a second (at
/// once when an outcome or an event is in it).
struct LinkBatch {
    quint32 generation = 0; ///< of the connection; earlier ones are ignored
    std::vector<PollSample> samples;
    std::vector<Outcome> outcomes;
    std::vector<TransactionRecord> records;
    std::vector<LinkEvent> events;
    LinkStats stats;
    /// One, four times a second: a vector, since an empty one costs nothing.
    std::vector<LinkHealth> health;
};

/// The device number that the controller answers to after this reply: parameter 0x00 acts at once.
[[nodiscard]] std::uint8_t deviceAfter(const Command& command, QByteArrayView payload,
                                       std::uint8_t device);

/// True when no TReX would answer so (length and CRC already checked): values out of the range that
/// the documents give. A wrong reply that passes the length is caught here.
[[nodiscard]] bool isPlausible(const Command& command, QByteArrayView payload);

/// The packets that stop all three motors: set to 0, or both motors at full brake.
[[nodiscard]] std::vector<Command> stopCommands(bool brake);

} // namespace trex
