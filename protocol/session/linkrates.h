// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "protocol/session/linkhealth.h"
#include "protocol/session/transaction.h"

namespace trex {

/// Transactions and samples a second, counted over a second each, and how well the line does.
struct LinkRates {
    Instant start{};
    quint64 transactions = 0;
    std::array<quint64, kPollCount> samples{};
    LinkHealthMeter health{};
    void into(LinkStats& stats, Instant now); ///< when the second is over
};

} // namespace trex
