// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/trexctl/failure.h"
#include "app/trexctl/session.h"
#include "app/trexctl/task.h"

namespace CLI {
class App;
}

namespace trex {

/// One command of trexctl: its options, their check, and what it does.
class Verb {
public:
    enum class Line {
        None, ///< needs no controller
        Open, ///< the verb's own bytes are the first on the line
        Identified, ///< the signature is asked for first; what is no TReX is refused
    };
    Verb() = default;
    virtual ~Verb() = default;
    Q_DISABLE_COPY_MOVE(Verb)

    virtual void declare(CLI::App&) { } ///< options and arguments; bound to members
    /// After parsing, before anything is opened. A failure here means that nothing was sent.
    [[nodiscard]] virtual Checked check(const OpenOptions&) { return {}; }
    [[nodiscard]] virtual Line line() const { return Line::Identified; }
    /// True when --port means something; else it is not even looked at.
    [[nodiscard]] virtual bool usesPort() const { return true; }
    /// True for streams: a controller that falls silent for a moment does not end them.
    [[nodiscard]] virtual bool ridesOverLoss() const { return false; }
    /// Runs until session.end() or session.fail().
    /// True: what an interrupted write left unknown in the controller is read back first.
    [[nodiscard]] virtual bool usesSettings() const { return false; }
    /// True: however it ends, the motors are told to stop. Else they are left as they were.
    [[nodiscard]] virtual bool stopsOnClose() const { return false; }
    virtual Task run(Session& session) = 0;
    virtual void interrupted(Session& session) { session.end(exitcode::kInterrupted); }
    virtual void powerCycle() { } ///< SIGUSR1; only the simulator takes notice
};

} // namespace trex
