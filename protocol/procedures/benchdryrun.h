// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "protocol/procedures/benchrun.h"
#include "protocol/storage/configfile.h"

#include <memory>

namespace trex {

class LinkEngine;
namespace sim {
class SimulatedLine;
}

/// What the simulated controller is like.
struct BenchDryRunOptions {
    Model model = Model::TrexJr;
    ParameterValues parameters; ///< raw, by number: as read from the real one
    std::array<double, 2> load{}; ///< of motor 1 and 2, 0 free to 1 heavy
    std::array<bool, 2> isHeld{}; ///< the shaft held fast
};

/// A bench test on a private simulated controller with its own motors, as fast as the computer can:
/// the same BenchRun, the rules of the line and the controller's firmware, but no port and no real
/// motor. Pure; call advance() until it says that it has ended.
class BenchDryRun {
public:
    explicit BenchDryRun(const BenchProfile& profile, const BenchDryRunOptions& options = {});
    ~BenchDryRun();
    BenchDryRun(const BenchDryRun&) = delete;
    BenchDryRun& operator=(const BenchDryRun&) = delete;

    /// So much of the simulation's own time. False: it has ended, and its motors have been stopped.
    bool advance(Duration simulated);
    void cancel();
    [[nodiscard]] const BenchRun& run() const { return m_run; }
    /// The controller and its motors, for whoever wants to compare.
    [[nodiscard]] sim::SimulatedLine& line() { return *m_line; }
    [[nodiscard]] Instant now() const { return m_now; }

private:
    void step(Instant end);
    void takeBatch();
    void giveOrders(const BenchOrders& orders);
    void submit(const Result<Command>& command);

    Instant m_now;
    std::unique_ptr<sim::SimulatedLine> m_line;
    std::unique_ptr<LinkEngine> m_engine;
    BenchRun m_run;
    Instant m_nextCall;
    std::optional<Instant> m_stopAt; ///< when the stop has had its time
    bool m_isStarted = false;
};

} // namespace trex
