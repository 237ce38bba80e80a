// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "protocol/codec/linesettings.h"
#include "protocol/result.h"
#include "protocol/transport/adapterfacts.h"

#include <QByteArray>
#include <QObject>

namespace trex {

/// A way for bytes to and from a controller. Lives on the link thread and is used from it only.
/// Implementations: serial port, raw TCP, the simulator in process.
class Transport : public QObject {
    Q_OBJECT
    Q_DISABLE_COPY_MOVE(Transport)

public:
    explicit Transport(QObject* parent = nullptr) : QObject(parent) { }
    ~Transport() override = default;

    /// Ends in opened() or failed(), now or later; never blocks for longer than the port's own
    /// open.
    virtual void open(const LineSettings& settings) = 0;
    virtual void close() = 0;
    /// Sets the open line to another speed, parity and stop bits; what was written before has left.
    /// False: not possible here, and nothing changed.
    virtual bool setLine([[maybe_unused]] const LineSettings& settings) { return false; }
    /// Whether setLine() works at all. Over a network the line is the serial server's.
    [[nodiscard]] virtual bool canSetLine() const { return false; }
    /// Hands all bytes to the line at once; a failure comes as failed().
    virtual void write(const QByteArray& bytes) = 0;
    /// Waits on the link thread until bytes came (received() was emitted: true), the line failed,
    /// or the time is over (false). Used for the reply in flight only: nothing may be sent before
    /// it.
    virtual bool waitForBytes(Duration longest) = 0;
    /// What received() is stamped with. Simulated time may run ahead of the clock on the wall.
    [[nodiscard]] virtual Instant now() const { return std::chrono::steady_clock::now(); }
    /// False: time passes in waitForBytes() only, which then takes none.
    [[nodiscard]] virtual bool isRealTime() const { return true; }
    /// Of the open line, for what a crashing program can still do; −1: there is none.
    [[nodiscard]] virtual int descriptor() const { return -1; }
    /// Of the open line: what is known of the adapter, and what it was asked for.
    [[nodiscard]] virtual AdapterFacts adapter() const { return {}; }
    /// The simulator only: switches the controller off and on again. False: not possible here.
    virtual bool powerCycle() { return false; }

signals:
    void opened();
    /// Bytes as read, with the steady-clock time of the read.
    void received(const QByteArray& bytes, trex::Instant at);
    /// The line cannot be opened or is gone; it is closed when this is emitted.
    void failed(const trex::Error& error);
};

} // namespace trex
