// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "protocol/procedures/benchrun.h"
#include "protocol/procedures/procedure.h"
#include "protocol/session/controller.h"

#include <QPointer>
#include <QTimer>

namespace trex {

/// A bench test on a real controller, through its motor gate. start() is the person's deliberate
/// act: it arms. However it ends (all steps done, a limit, STOP, Esc, disarming, a lost link, an
/// error, this object's end), all three motors are told to stop. Readings are taken from the valid
/// replies of the line with the time of their read, and no other.
///
/// finished() comes when the stop has left; it carries an error when the test could not be started
/// or the link was lost. How the test itself ended is in run().ending().
class BenchTest : public Procedure {
    Q_OBJECT

public:
    /// When the controller goes first, it stops the motors itself.
    BenchTest(Controller& controller, const BenchProfile& profile, QObject* parent = nullptr);
    ~BenchTest() override;

    void start() override;
    void cancel() override; ///< ends as Stopped
    [[nodiscard]] const BenchRun& run() const { return m_run; }

signals:
    void tick(); ///< something may be new to show, at most every 50 ms

private:
    void onTick();
    void onRecords(const std::vector<TransactionRecord>& records);
    void followSilence(const TransactionRecord& record);
    void onState(LinkState state);
    void giveOrders(const BenchOrders& orders);
    void conclude();
    [[nodiscard]] quint64 linkErrors() const;

    QPointer<Controller> m_controller;
    BenchRun m_run;
    QTimer m_timer;
    int m_ticks = 0;
    bool m_isConcluding = false;
    int m_missing = 0; ///< replies that did not come, in a row
    std::optional<Instant> m_lastReply;
    std::optional<Error> m_error;
};

} // namespace trex
