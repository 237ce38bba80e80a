// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "protocol/procedures/linesearch.h"
#include "protocol/procedures/procedure.h"
#include "protocol/session/controller.h"

#include <QElapsedTimer>

#include <deque>

namespace trex {

struct ScanOptions {
    QString port; ///< see makeTransport()
    LineSettings line; ///< tried early; its polynomial and device number hold for every try
    bool all = false; ///< go on after the first, and ask every device number on lines that answer
    std::vector<LineSettings> remembered{}; ///< that worked on this port before: tried first
    std::vector<LineSettings> only{}; ///< not empty: just these
};

struct ScanHit {
    int baud = 19200;
    ErrorDetection errorDetection = ErrorDetection::None;
    int stopBits = 1; ///< as the controller's UART settings say, else as given
    std::uint8_t device = kDefaultDeviceNumber;
    Signature signature;
    bool echo = false;
    std::uint8_t polynomial = kDefaultPolynomial; ///< with which CRC-7 was answered
    std::uint8_t status = 0; ///< of the status byte, which the probe has read and so cleared
    [[nodiscard]] LineSettings line(const LineSettings& base) const;
};

/// Finds the controllers on a port, in the order and with the bytes of LineSearch: nothing that it
/// sends to a line at the wrong speed is a motor command there. Uses a connection of its own, so
/// the port must be free. Ends with an error when the port fails or nothing answers.
class Scan : public Procedure {
    Q_OBJECT

public:
    explicit Scan(ScanOptions options, QObject* parent = nullptr);

    void start() override;
    void cancel() override;
    [[nodiscard]] const std::vector<ScanHit>& hits() const { return m_hits; }
    /// Until every try is done, from the time that those so far took; 0 before the first.
    [[nodiscard]] Duration estimatedRemaining() const;
    /// What came back where nothing was found.
    [[nodiscard]] LineAnswer heard() const { return m_search.heard(); }
    /// Settings that could not be tried safely, see LineSearch.
    [[nodiscard]] const std::vector<LineSettings>& leftOut() const { return m_search.leftOut(); }

signals:
    void found(const trex::ScanHit& hit);

private:
    void next();
    void tell();
    void openFor(const LineSettings& line);
    void onState(LinkState state);
    void onConnected();
    void onAnswer();
    void onFound();
    void askStopBits();
    void askDeviceNumber();
    void sweepDevices();
    void endSweep();
    void onSwept();
    void addHit();
    void end(const Result<void>& result);
    void onClosed();
    [[nodiscard]] bool isOver() const { return !isRunning() || m_ending.has_value(); }

    enum class Step : std::uint8_t { Search, Details, Sweep };
    ScanOptions m_options;
    LineSearch m_search;
    Controller m_controller;
    Step m_step = Step::Search;
    LineSearch::Ask m_ask;
    std::deque<std::uint8_t> m_sweep; ///< device numbers yet to ask on the line of m_hit
    ScanHit m_hit; ///< being completed
    bool m_sweptAny = false;
    std::vector<ScanHit> m_hits;
    QByteArray m_received; ///< what came back on the latest question
    int m_swept = 0;
    bool m_isCancelled = false; ///< clears the line, then ends
    bool m_isAsking = false; ///< opened or opening for a question
    std::optional<Result<void>> m_ending; ///< told when the port is free again
    QElapsedTimer m_elapsed;
};

} // namespace trex
