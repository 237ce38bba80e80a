// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "protocol/codec/lineprobe.h"
#include "protocol/codec/replies.h"

#include <QByteArray>

#include <deque>
#include <optional>
#include <vector>

namespace trex {

struct LineSearchOptions {
    LineSettings given{}; ///< tried early; its polynomial and device number hold for every try
    std::vector<LineSettings> remembered{}; ///< that worked here before: tried first
    std::vector<LineSettings> only{}; ///< not empty: just these, in this order
    bool isNetwork = false; ///< speed and parity are a serial server's: only CRC-7 can differ
};

struct LineFound {
    LineSettings line; ///< speed, error detection and polynomial as found; the rest as given
    Signature signature;
    bool echo = false;
    std::uint8_t status = 0; ///< bits that the question has read and so cleared; mostly none
};

/// What came back from a line on which nothing was found, the most telling of it.
enum class LineAnswer : std::uint8_t { Silence, EchoOnly, Zeros, Garbage };

/// The order in which unknown line settings are tried, and what is sent for it. Pure: the driver
/// (Scan, or a test with a simulated line) asks what to send, sends it on a freshly opened line and
/// tells what came back.
///
/// Each try is a question of lineProbe(), and lineClearing() after it, so that no receiver has a
/// packet open when the next one comes: the order is free, and a search may end after any try.
/// get-signature (0x81) and get-serial-control (0x83) are asked only where the question was
/// answered: at a wrong speed it never reads as a query, so that nobody answers there.
/// No Pololu form: it carries data bytes, and controllers answer the compact form at any time
/// (conformance C-04). Equal answers of several controllers, joined, are one good answer.
class LineSearch {
public:
    struct Ask {
        LineSettings line;
        QByteArray bytes;
        int replyBytes = 0; ///< to wait for, an echo included; 0: send, rest (kWireRest), go on
        bool isTry = false; ///< begins one of total()
    };

    explicit LineSearch(const LineSearchOptions& options);

    /// What to send next; none: found(), or nothing is left.
    [[nodiscard]] std::optional<Ask> next();
    /// All that came back on the latest one, echo and all.
    void answer(QByteArrayView received);
    [[nodiscard]] const std::optional<LineFound>& found() const { return m_found; }
    /// After a find: look for others on the same port.
    void resume();
    /// No further tries: only what still has to be cleared on the line is sent.
    void giveUp();

    [[nodiscard]] int done() const { return m_done; }
    [[nodiscard]] int total() const; ///< tries done and left
    [[nodiscard]] LineAnswer heard() const { return m_heard; }
    /// Settings that are not tried, since their question could be heard as an order elsewhere.
    [[nodiscard]] const std::vector<LineSettings>& leftOut() const { return m_leftOut; }

    static constexpr std::chrono::milliseconds kReplyTimeout{60};

private:
    enum class Stage : std::uint8_t { Probe, Signature, Parity };
    void plan(const LineSearchOptions& options);
    void planCrc(const std::vector<LineSettings>& known);
    void addTry(const LineSettings& line);
    [[nodiscard]] bool isPlanned(const LineSettings& line) const;
    [[nodiscard]] Ask ask(const char* query, int payload) const;
    void beginTry();
    void clearLine();
    [[nodiscard]] QByteArrayView withoutEcho(QByteArrayView received);
    void onProbe(QByteArrayView reply);
    void onSignature(QByteArrayView reply);
    void tryOddParity();
    void accept();

    LineSearchOptions m_options;
    std::deque<LineSettings> m_steps;
    std::deque<Ask> m_pieces; ///< of the try under way, or of the clearing after it
    Stage m_stage = Stage::Probe;
    LineSettings m_current;
    Command m_query; ///< of the try
    Ask m_latest;
    bool m_isUnclear = false; ///< a question went out and the line was not cleared since
    LineFound m_candidate;
    std::optional<LineFound> m_found;
    LineAnswer m_heard = LineAnswer::Silence;
    int m_done = 0;
    std::vector<LineSettings> m_leftOut;
};

/// The signature in bytes that may begin with foreign ones, or end with them.
[[nodiscard]] std::optional<Signature> signatureIn(QByteArrayView bytes, const LineSettings& line);

} // namespace trex
