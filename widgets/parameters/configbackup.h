// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "protocol/storage/configfile.h"

namespace trex {

class UiSettings;

/// Where copies go before the controller is changed: beside the settings file when one was given by
/// --settings, else in the person's data folder.
[[nodiscard]] QString backupFolder(UiSettings& settings);

/// Saves a copy under a name of its own (controller and time) and returns its path. Nothing is ever
/// overwritten. Errors: FileUnwritable.
[[nodiscard]] Result<QString> backUpConfiguration(const Configuration& configuration,
                                                  const QString& folder);

} // namespace trex
