// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "protocol/codec/linesettings.h"
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
    std::uint8_t status = 0; ///< the probe has read it, so that its bits are clear there now
};

/// What came back from a line on which nothing was found, the most telling of it.
enum class LineAnswer : std::uint8_t { Silence, EchoOnly, Zeros, Garbage };

/// The order in which unknown line settings are tried, and what is sent for it. Pure: the driver
/// (Scan, or a test with a simulated line) asks what to send, sends it on a freshly opened line and
/// tells what came back.
///
/// A controller at another speed hears a probe as other bytes, and some of them are motor commands:
/// 0x81 at 19200 baud is 0xE0 at 115200, and `81 48` at 9600 is a complete order at 4800. What is
/// sent here was chosen with a model of the wire, bit by bit, for all pairs of speeds, parities and
/// tolerable clock errors (tests/procedures/tst_linebits.cpp shows that none is heard):
/// - The probe is get-status (0x84) with two stop bits. Alone it is never a whole motor command,
///   whatever a receiver does with bytes that failed their frame or parity check, and what it may
///   leave open at three quarters or two thirds of its speed is closed by the same byte there. So
///   speeds are tried downwards. Of all queries without data it is the only one of which that
///   holds. An odd parity bit of it is 1, as a stop bit is: one try asks both.
/// - Even parity and CRC-7 have other waves. After each such try, and after each that is out of the
///   order, the clean byte goes out downwards once more, not waiting for answers (clearing lines).
/// - A CRC byte can make it unclean to faster receivers (isCleanCrcProbe). These tries come last,
///   when such a receiver would have answered, and not at all once one has.
/// - get-signature (0x81) and get-serial-control (0x83) are sent only where the probe was answered:
///   at a wrong speed it never reads as a query, so that nobody answers there.
/// - No Pololu form: it carries data bytes, and controllers answer the compact form at any time
///   (conformance C-04). Equal answers of several controllers, joined, are one good answer.
class LineSearch {
public:
    struct Ask {
        LineSettings line;
        QByteArray bytes;
        int replyBytes = 0; ///< to wait for, an echo included; 0: send, rest, go on
        bool isTry = false; ///< counts as one of total()
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
    /// Tries not made because of what had answered.
    [[nodiscard]] int leftOut() const { return m_leftOut; }

    static constexpr std::chrono::milliseconds kReplyTimeout{60};
    /// After a packet that is not waited for, so that the slowest receiver is done with it: eleven
    /// bits at 1200 baud.
    static constexpr std::chrono::milliseconds kRest{12};

private:
    enum class Stage : std::uint8_t { Probe, Signature, Parity };
    struct Step {
        LineSettings line;
        bool isClearing = false;
    };
    void plan(const LineSearchOptions& options);
    void planCrc(const std::vector<LineSettings>& known, bool clean);
    void addTry(const LineSettings& line, bool clear);
    void addClearing(std::deque<Step>& steps) const;
    [[nodiscard]] bool isPlanned(const LineSettings& line) const;
    [[nodiscard]] Ask ask(const char* query, int payload) const;
    [[nodiscard]] QByteArrayView withoutEcho(QByteArrayView received);
    void onProbe(QByteArrayView reply);
    void onSignature(QByteArrayView reply);
    void tryOddParity();
    void accept();

    LineSearchOptions m_options;
    std::deque<Step> m_steps;
    Stage m_stage = Stage::Probe;
    Step m_current;
    LineFound m_candidate;
    std::optional<LineFound> m_found;
    LineAnswer m_heard = LineAnswer::Silence;
    int m_done = 0;
    int m_leftOut = 0;
};

/// True when no receiver at another speed makes a motor command of get-status with this CRC byte.
[[nodiscard]] bool isCleanCrcProbe(int baud, std::uint8_t crcByte);
/// The signature in bytes that may begin with foreign ones, or end with them.
[[nodiscard]] std::optional<Signature> signatureIn(QByteArrayView bytes, const LineSettings& line);

} // namespace trex
