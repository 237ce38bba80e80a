// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

class QString;

namespace trex {

class Controller;

/// One line on stderr, whatever is in the text.
void printMessage(const QString& text);

/// Messages of Qt itself: on stderr from `-v` on, else left out (a warning of a library is not an
/// answer to the person). Critical ones always.
void installLogging(int verbosity);

/// From `-v` on: each packet with its meaning, outcome and time on stderr; from `-vv` on its bytes
/// too. Call it before the line is opened.
void logWire(Controller& controller, int verbosity);

} // namespace trex
