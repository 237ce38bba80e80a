// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "protocol/session/flight.h"
#include "protocol/session/lineguard.h"
#include "protocol/session/linkrates.h"
#include "protocol/session/pollplan.h"
#include "protocol/session/stopagain.h"

#include <deque>
#include <optional>

namespace trex {

/// The rules of one line, pure: bytes and time in, bytes and values out. One transaction in flight;
/// nothing is sent while a reply is due, but stop once it is overdue; stop before motor before user
/// before poll; queries are asked again as their row allows, writes never; echo is taken off; late
/// and surplus bytes are flushed and the line is synchronised before the next reply is believed.
///
/// The driver (LinkWorker, or a test with a virtual clock) calls next() and does what it says.
class LinkEngine {
public:
    struct Action {
        enum class Kind : std::uint8_t {
            Idle, ///< nothing to do until something is submitted or received
            Wait, ///< call again at `until`, or when bytes came
            Send, ///< hand `bytes` to the line now, then call again
        };
        Kind kind = Kind::Idle;
        Instant until;
        QByteArray bytes;
        std::optional<LineSettings> line{}; ///< set the line so before
    };

    /// `identify`: believe in a controller only after its signature. `reconnect`: keep asking after
    /// a loss; else the state ends as Disconnected. `canSetLine`: Action::line can be done.
    /// `stopsInDoubt`: stop follows a question that may have been heard as an order.
    LinkEngine(const LineSettings& settings, bool identify, bool reconnect, bool canSetLine = true,
               bool stopsInDoubt = true);

    void opened(Instant now, const AdapterFacts& adapter = {});
    /// The port is gone: whatever waited has failed; the driver opens it again.
    void lineFailed(const Error& error, Instant now);
    void received(QByteArrayView bytes, Instant at);
    void submit(const Transaction& transaction);
    /// Throws queued motor orders away; these packets go before everything else, and once more a
    /// little later where it is doubtful whether they were heard (StopAgain).
    void stop(const std::vector<Transaction>& packets, Instant now);
    void setWishes(const PollWishes& wishes, Instant now);
    /// Fails everything that waits; nothing more is sent but stop packets and lineClearing().
    void shutDown();
    void resetHealth(Instant now) { m_rates.health.reset(now); } ///< counts from now

    [[nodiscard]] Action next(Instant now);
    [[nodiscard]] bool isReplyDue() const { return m_flight.has_value(); }
    /// The reply has had all the time that it should need: waiting longer is mere hope.
    [[nodiscard]] bool isReplyOverdue(Instant now) const { return m_flight && now >= overdueAt(); }
    [[nodiscard]] Instant overdueAt() const; ///< while a reply is due
    /// Or about to be, for the first time again.
    [[nodiscard]] bool isStopQueued() const
    {
        return !m_stops.empty() || (m_again.at && !m_again.isRepeating);
    }
    [[nodiscard]] bool isClearing() const { return m_guard.isBusy(); }
    [[nodiscard]] Instant lineFreeAt() const { return m_lineFreeAt; }
    [[nodiscard]] LinkState state() const { return m_state; }
    [[nodiscard]] bool hasNews() const; ///< an outcome or an event waits in the batch
    [[nodiscard]] LinkBatch takeBatch(Instant now);
    static constexpr int kMostAttempts = 3;
    static constexpr std::chrono::milliseconds kMostSlack{250}; ///< waited for late replies

private:
    using Role = FlightRole;
    using Queued = QueuedTransaction;
    enum class Echo : std::uint8_t { Unknown, Yes, No };

    [[nodiscard]] Action decide(Instant now);
    [[nodiscard]] std::optional<Action> waitForFlight(Instant now);
    [[nodiscard]] std::optional<Queued> choose(Instant now);
    [[nodiscard]] Action send(const Queued& queued, Instant now);
    [[nodiscard]] Action sendPiece(Instant now);
    [[nodiscard]] std::optional<Queued> chooseIdentify(Instant now);
    [[nodiscard]] QByteArray probeBytes(Instant now);
    [[nodiscard]] std::optional<Instant> nextWake() const;
    void deliver(QByteArrayView bytes, Instant at);
    void deliverRaw(Instant at);
    void deliverIdentify(Instant at);
    void deliverProbe(Instant at);
    [[nodiscard]] bool isProbeAnswered() const;
    void onProbeAnswered(Instant at);
    void judgeNormal(qsizetype surplus, Instant at);
    void settleUndecided(Instant now);
    [[nodiscard]] QByteArrayView stripEcho(QByteArrayView bytes);
    void complete(const QByteArray& payload, Instant at);
    void failFlight(ErrorCode code, Instant now);
    void onDeadline(Instant now);
    void record(const Flight& flight, Instant ended, std::optional<ErrorCode> error);
    void finish(const Queued& queued, const Result<Reply>& result);
    void synchronised(Instant at);
    void flushed(qsizetype bytes, Instant at);
    [[nodiscard]] Duration quietGap() const;
    void noteLateness();
    void setState(LinkState state, const std::optional<Error>& error, Instant now);
    void loseLink(const Error& error, Instant now);
    void queueStopForLoss();
    void overtake(Instant now);
    void doubtStop();
    void stopOnceMore(Instant now);
    [[nodiscard]] Duration usualOverhead() const;
    void stopAfterWrite();
    [[nodiscard]] Error identifyFailure() const;
    void noteMotion(const Transaction& transaction);

    LineSettings m_settings;
    bool m_identify;
    bool m_reconnect;
    bool m_canSetLine;
    bool m_stopsInDoubt;
    bool m_shutDown = false;
    LinkState m_state = LinkState::Disconnected;
    std::deque<Queued> m_stops;
    StopAgain m_again;
    std::array<std::optional<Transaction>, 4> m_motors; ///< 1, 2, both, aux: latest wins
    std::deque<std::size_t> m_motorOrder;
    std::deque<Queued> m_users;
    std::optional<Queued> m_retry;
    std::optional<Flight> m_flight;
    PollPlan m_plan;
    Echo m_echo = Echo::Unknown;
    QByteArray m_pendingEcho; ///< sent, not yet seen coming back
    QByteArray m_undecided; ///< received while the echo is unknown
    bool m_needsSync = false;
    bool m_open = false;
    bool m_motionSent = false; ///< an order other than neutral left since the last stop
    bool m_maybeMisheard = false; ///< a packet without an answer may have been taken for an order
    Instant m_lineFreeAt;
    Instant m_quietUntil;
    std::optional<Instant> m_noisySince; ///< bytes that nobody asked for keep coming
    Instant m_lastValid;
    Duration m_slack{0}; ///< waited beyond the timeout, once replies were seen to come later
    int m_failures = 0; ///< transactions without a valid reply in a row
    LineGuard m_guard;
    int m_syncFailures = 0;
    bool m_wasConnected = false;
    double m_overheadNs = 300'000.0;
    LinkBatch m_batch;
    LinkRates m_rates;
};

} // namespace trex
