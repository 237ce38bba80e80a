// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "protocol/procedures/procedure.h"
#include "protocol/session/controller.h"

#include <QElapsedTimer>

#include <deque>

namespace trex {

struct ScanOptions {
    QString port; ///< see makeTransport()
    LineSettings line; ///< tried first; its polynomial, stop bits and echo hold for every try
    bool all = false; ///< go on after the first, and ask every device number on lines that answer
};

struct ScanHit {
    int baud = 19200;
    ErrorDetection errorDetection = ErrorDetection::None;
    int stopBits = 1;
    std::uint8_t device = kDefaultDeviceNumber;
    Signature signature;
    bool echo = false;
    [[nodiscard]] LineSettings line(const LineSettings& base) const;
};

/// One way to ask: line settings and packet form.
struct ScanTry {
    LineSettings line;
    bool isSweep = false; ///< one of all device numbers, on a line that has answered
};

/// The tries in the order of their likelihood: the given line, then without error detection, CRC-7,
/// even, odd, each at the rates people use most; last the same in the Pololu form, which finds one
/// of several controllers whose compact answers collide.
[[nodiscard]] std::vector<ScanTry> scanPlan(const LineSettings& given);

/// Finds the controllers on a port. Sends get-signature (0x81) and nothing else to a line that has
/// not answered it yet: a controller at another speed hears it as garbage. Uses a connection of its
/// own, so the port must be free. Ends with an error when the port fails or nothing answers.
class Scan : public Procedure {
    Q_OBJECT

public:
    explicit Scan(ScanOptions options, QObject* parent = nullptr);

    void start() override;
    void cancel() override;
    [[nodiscard]] const std::vector<ScanHit>& hits() const { return m_hits; }
    /// Until every try is done, from the time that those so far took; 0 before the first.
    [[nodiscard]] Duration estimatedRemaining() const;

    static constexpr std::chrono::milliseconds kReplyTimeout{60};

signals:
    void found(const trex::ScanHit& hit);

private:
    void next();
    void onState(LinkState state);
    void probe();
    void onAnswer();
    [[nodiscard]] std::optional<Signature> signatureIn(const QByteArray& bytes) const;
    [[nodiscard]] ScanHit hitFor(std::uint8_t device, const Signature& signature) const;
    void addHit(std::uint8_t device, const Signature& signature);
    void confirm(const Signature& signature);
    void accept(const Signature& signature);
    void askDeviceNumber(const Signature& signature);
    void sweepDevices();
    void endSweep();
    void end(const Result<void>& result);
    void onClosed();

    ScanOptions m_options;
    Controller m_controller;
    std::deque<ScanTry> m_tries;
    ScanTry m_current;
    std::vector<ScanHit> m_hits;
    std::optional<ScanHit> m_answered; ///< of the line being swept, until a number of it answers
    QByteArray m_received; ///< what came back on the latest probe
    int m_done = 0;
    bool m_isProbing = false; ///< opened or opening for m_current
    std::optional<Result<void>> m_ending; ///< told when the port is free again
    QElapsedTimer m_elapsed;
};

} // namespace trex
