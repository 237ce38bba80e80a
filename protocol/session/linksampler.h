// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "protocol/session/transaction.h"
#include "protocol/telemetry/source.h"

namespace trex {

class TelemetryStore;

/// Samples of what is known on our side of the line, out of what the link thread reports: what each
/// motor was last told, and how the line does. Pure: all times are the batches'.
class LinkSampler {
public:
    explicit LinkSampler(TelemetryStore& store) : m_store(store) { }

    /// Orders are sampled as they leave, each with what was in force until then right before it, so
    /// that curves are steps; and again every kHeartbeat while anything is known.
    void take(const LinkBatch& batch, const LineSettings& line);
    void restart(); ///< another connection
    /// The controller has forgotten its orders, or may have: no curve goes on.
    void forgetOrders();

    static constexpr std::chrono::milliseconds kHeartbeat{250};
    static constexpr std::chrono::seconds kHealthInterval{1};

private:
    /// Stored numbers: motor 1, motor 2, aux.
    using Orders = std::array<std::uint16_t, 3>;
    void onEvent(const LinkEvent& event);
    void onRecord(const TransactionRecord& record, const LineSettings& line);
    void setOrders(const Orders& orders, Instant time);
    void countHealth(const LinkStats& stats, Instant now);
    void restartHealth();

    TelemetryStore& m_store;
    Orders m_orders{kUnknown, kUnknown, kUnknown};
    std::optional<Instant> m_lastOrder; ///< time of the latest sample; none: nothing is known
    bool m_isConnected = false;
    std::vector<std::uint16_t> m_latencies; ///< of this second, in 10 µs
    std::optional<Instant> m_healthStart;
    LinkStats m_healthBefore;

    static constexpr std::uint16_t kUnknown = 0xFF;
};

} // namespace trex
