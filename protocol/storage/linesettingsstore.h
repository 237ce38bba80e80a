// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "protocol/codec/linesettings.h"
#include "protocol/storage/setting.h"

#include <optional>
#include <set>

namespace trex {

/// The port used last, and for each port the settings that last found a controller there. Both
/// programs share it. What is stored and makes no sense counts as not stored.
class LineSettingsStore {
public:
    explicit LineSettingsStore(SettingsFile& file) : m_file(file) { }

    [[nodiscard]] QString lastPort() const; ///< "sim:" when there is none
    [[nodiscard]] std::optional<LineSettings> lastGood(const QString& port) const;
    /// After a controller answered: this port and these settings, written to the file at once.
    void remember(const QString& port, const LineSettings& settings);
    /// The device numbers that the latest search of all of them found on this port.
    [[nodiscard]] std::set<int> numbersInUse(const QString& port) const;
    void rememberNumbers(const QString& port, const std::set<int>& numbers);

private:
    SettingsFile& m_file;
};

} // namespace trex
