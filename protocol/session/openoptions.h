// SPDX-License-Identifier: GPL-3.0-or-later
// What a connection is opened with, and what it finds out about the controller. Plain values.
#pragma once

#include "protocol/codec/linesettings.h"
#include "protocol/codec/replies.h"

#include <QString>

#include <optional>

namespace trex {

struct OpenOptions {
    QString port; ///< see makeTransport()
    LineSettings line;
    bool identify = true; ///< ask for the signature first; off for `trexctl raw` and motor verbs
    bool stopOnClose = true; ///< neutral to all three motors before the line is closed
    bool reconnect = true; ///< try again by itself when the line is lost
};

/// What is known of the controller, each with the time of the reply that said so; nothing is kept
/// when the link is lost.
struct DeviceInfo {
    std::optional<Signature> signature;
    std::optional<Mode> mode;
    std::optional<bool> serialControls;
    std::optional<std::uint8_t> learnedMask;
};

} // namespace trex
