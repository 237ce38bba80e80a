// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>

class QObject;
class QString;

namespace trex {

/// True when a person can be asked: both the keyboard and the message side are a terminal.
[[nodiscard]] bool isAtTerminal();
/// Asks on stderr and waits for a line; true for yes. Only before the event loop runs.
[[nodiscard]] bool confirm(const QString& question);
/// The same in the event loop; the handler runs once, unless `context` dies before.
void confirmLater(const QString& question, QObject* context, std::function<void(bool)> handler);

} // namespace trex
