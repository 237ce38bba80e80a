// SPDX-License-Identifier: GPL-3.0-or-later
// What a crashing program can still do about the motors: hand the stop packets, prepared while all
// was well, to the line's descriptor. What it cannot do (SIGKILL, a dead computer) is the business
// of the controller's serial timeout.
#pragma once

#include <QByteArray>

namespace trex::laststop {

/// Keeps `bytes` ready for this open descriptor; anything below 0: the line is closed. `owner`
/// tells lines apart. From the thread that owns the line.
void prepare(const void* owner, int descriptor, const QByteArray& bytes);
void withdraw(const void* owner);

/// For every signal that would end the program and that nobody else takes (SIGSEGV and its like,
/// SIGQUIT, SIGUSR1, alarms, limits): sends what is prepared, twice (a controller that is answering
/// hears nothing meanwhile), then lets the signal do what it always does. SIGPIPE and SIGXFSZ are
/// ignored: a write that fails says so itself, and is no reason to leave motors alone. Nothing
/// where there are no Unix signals. Once, early, from main(), before what takes signals itself.
void installCrashHandlers();

/// Nothing of ours may follow the last stop.
[[nodiscard]] bool isCrashing();

} // namespace trex::laststop
