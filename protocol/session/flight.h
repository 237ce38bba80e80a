// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "protocol/codec/replyparser.h"
#include "protocol/session/transaction.h"

#include <optional>

namespace trex {

/// Identify: a signature. Probe: what may be asked before it (lineProbe()). All but Normal
/// recognise their answer among others.
enum class FlightRole : std::uint8_t { Normal, Identify, Probe, Synchronise };

struct QueuedTransaction {
    Transaction transaction;
    int attempt = 1;
    std::optional<PollId> poll{};
    FlightRole role = FlightRole::Normal;
};

/// The transaction whose reply is due.
struct Flight {
    QueuedTransaction queued;
    ReplyParser parser;
    QByteArray sentBytes;
    QByteArray received; ///< echo left out
    qsizetype heldBefore = 0; ///< of the undecided bytes, those that came before it was sent
    Instant sent;
    Instant expected; ///< the reply is there, by its time on the wire and the controller's own
    Instant deadline;
    Instant limit; ///< no deadline goes beyond it
    Instant lastByte;
    bool isComplete = false; ///< but watched for bytes that would not belong to it
};

} // namespace trex
