// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "protocol/codec/replyparser.h"
#include "protocol/session/pollplan.h"
#include "protocol/session/transaction.h"

#include <deque>
#include <optional>

namespace trex {

/// The rules of one line, pure: bytes and time in, bytes and values out. One transaction in flight;
/// nothing is sent while a reply is due; stop before motor before user before poll; queries are
/// asked again as their row allows, writes never; echo is taken off; late and surplus bytes are
/// flushed and the line is synchronised before the next reply is believed.
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
    };

    /// `identify`: believe in a controller only after its signature. `reconnect`: keep asking after
    /// a loss; else the state ends as Disconnected with the reason.
    LinkEngine(const LineSettings& settings, bool identify, bool reconnect);

    void opened(Instant now);
    /// The port is gone: whatever waited has failed; the driver opens it again.
    void lineFailed(const Error& error, Instant now);
    void received(QByteArrayView bytes, Instant at);
    void submit(const Transaction& transaction);
    /// Throws queued motor orders away and puts these packets before everything else.
    void stop(const std::vector<Transaction>& packets, Instant now);
    void setWishes(const PollWishes& wishes, Instant now);
    /// Fails everything that waits; nothing more is sent but stop packets.
    void shutDown();

    [[nodiscard]] Action next(Instant now);
    [[nodiscard]] bool isReplyDue() const { return m_flight.has_value(); }
    [[nodiscard]] bool isStopQueued() const { return !m_stops.empty(); }
    [[nodiscard]] Instant lineFreeAt() const { return m_lineFreeAt; }
    [[nodiscard]] LinkState state() const { return m_state; }
    [[nodiscard]] bool hasNews() const; ///< an outcome or an event waits in the batch
    [[nodiscard]] LinkBatch takeBatch(Instant now);

    static constexpr int kMostAttempts = 3;

private:
    enum class Role : std::uint8_t { Normal, Identify, Synchronise };
    struct Queued {
        Transaction transaction;
        int attempt = 1;
        std::optional<PollId> poll{};
        Role role = Role::Normal;
    };
    struct Flight {
        Queued queued;
        ReplyParser parser;
        QByteArray sentBytes;
        QByteArray received; ///< echo left out
        Instant sent;
        Instant deadline;
        Instant limit; ///< no deadline goes beyond it
        Instant lastByte;
    };
    enum class Echo : std::uint8_t { Unknown, Yes, No };

    // choosing
    [[nodiscard]] std::optional<Queued> choose(Instant now);
    [[nodiscard]] Action send(const Queued& queued, Instant now);
    [[nodiscard]] std::optional<Instant> nextWake() const;
    // receiving
    void deliver(QByteArrayView bytes, Instant at);
    void deliverRaw(Instant at);
    void deliverIdentify(Instant at);
    void judgeNormal(qsizetype surplus, Instant at);
    void settleUndecided(Instant now);
    [[nodiscard]] QByteArrayView stripEcho(QByteArrayView bytes);
    // ending
    void complete(const QByteArray& payload, Instant at);
    void failFlight(ErrorCode code, Instant now);
    void onDeadline(Instant now);
    void record(const Flight& flight, Instant ended, std::optional<ErrorCode> error);
    void finish(const Queued& queued, const Result<Reply>& result);
    void synchronised(Instant at);
    void flushed(qsizetype bytes, Instant at);
    [[nodiscard]] Duration quietGap() const;
    void noteLateness();
    // state
    void setState(LinkState state, const std::optional<Error>& error, Instant now);
    void loseLink(const Error& error, Instant now);
    void queueStopForLoss();
    [[nodiscard]] Error identifyFailure() const;
    void countRates(Instant now);
    void noteMotion(const Transaction& transaction);

    LineSettings m_settings;
    bool m_identify;
    bool m_reconnect;
    bool m_shutDown = false;
    LinkState m_state = LinkState::Disconnected;
    std::deque<Queued> m_stops;
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
    Instant m_lineFreeAt;
    Instant m_quietUntil;
    std::optional<Instant> m_noisySince; ///< bytes that nobody asked for keep coming
    Instant m_nextIdentify;
    Instant m_lastValid;
    Duration m_slack{0}; ///< waited beyond the timeout, once replies were seen to come later
    int m_failures = 0; ///< transactions without a valid reply in a row
    int m_identifyTries = 0;
    int m_syncFailures = 0;
    bool m_wasConnected = false;
    QByteArray m_identifyBytes; ///< what came instead of a signature
    bool m_sawEchoOnly = false;
    double m_overheadNs = 300'000.0;
    LinkBatch m_batch;
    Instant m_rateStart;
    quint64 m_rateTransactions = 0;
    std::array<quint64, kPollCount> m_rateSamples{};
};

/// True when no TReX would answer so (length and CRC already checked): values out of the range that
/// the documents give. A wrong reply that passes the length is caught here.
[[nodiscard]] bool isPlausible(const Command& command, QByteArrayView payload);

/// The packets that stop all three motors: set to 0, or both motors at full brake.
[[nodiscard]] std::vector<Command> stopCommands(bool brake);

} // namespace trex
