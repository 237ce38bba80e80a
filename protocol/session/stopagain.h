// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "protocol/session/transaction.h"

#include <optional>
#include <vector>

namespace trex {

/// What LinkEngine remembers about a stop that may not have been heard: one that overtook a reply
/// (the controller is deaf while it sends, C-11), or one on a line that has lost bytes of late. It
/// is sent once more, when the controller must be listening, and then each second until the line
/// has been without an error for as long, or somebody orders motion.
struct StopAgain {
    std::vector<Transaction> packets{}; ///< of the latest stop
    std::optional<Instant> at{}; ///< when to send them again
    Instant latest{}; ///< the reply that was overtaken may come until then
    bool isRepeating = false; ///< they have been sent again at least once
    Instant lastFailure{}; ///< of any transaction
};

} // namespace trex
