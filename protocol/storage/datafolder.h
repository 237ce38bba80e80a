// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

namespace trex {

/// Where copies and the journal are kept, for both programs: beside the settings file when one was
/// given by --settings, else in the person's data folder. The folder may not be there yet.
[[nodiscard]] QString dataFolder(const QString& settingsPath);
[[nodiscard]] QString journalPath(const QString& settingsPath);

} // namespace trex
