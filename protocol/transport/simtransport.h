// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "protocol/sim/simulatedline.h"
#include "protocol/transport/transport.h"

#include <QTimer>

#include <memory>

namespace trex {

/// The simulated controller in process (`sim:`), in real time (or jumping from byte to byte), paced
/// like a wire. It keeps its power while the line is closed; powerCycle() switches it off and on.
class SimTransport : public Transport {
    Q_OBJECT

public:
    explicit SimTransport(const sim::SimOptions& options, QObject* parent = nullptr);

    void open(const LineSettings& settings) override;
    void close() override;
    bool setLine(const LineSettings& settings) override;
    [[nodiscard]] bool canSetLine() const override { return true; }
    void write(const QByteArray& bytes) override;
    bool waitForBytes(Duration longest) override;
    [[nodiscard]] Instant now() const override;
    [[nodiscard]] bool isRealTime() const override { return !m_virtualNow; }
    [[nodiscard]] AdapterFacts adapter() const override
    {
        return {.kind = AdapterFacts::Kind::Simulator};
    }
    bool powerCycle() override;

private:
    bool take(Instant now); ///< emits what has arrived; true: something had, or the line failed
    void schedule(Instant now);

    std::optional<Instant> m_virtualNow; ///< none: the clock on the wall counts
    sim::SimulatedLine m_line;
    QTimer m_timer;
    bool m_isOpen = false;
};

} // namespace trex
