// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "protocol/codec/replies.h"
#include "protocol/storage/configfile.h"

#include <QStringList>

namespace trex {

/// A file's configuration as it is to be written to another controller, and what became different.
struct AdaptedConfiguration {
    Configuration configuration;
    QStringList notes; ///< sentences
};

/// Made fit for this controller. Without a signature in the file nothing is known to adapt.
[[nodiscard]] AdaptedConfiguration adaptedTo(const Signature& controller,
                                             const Configuration& file);

/// TReX Jr when the signature says nothing else.
[[nodiscard]] Model modelOf(const QString& signature);
/// In the row's unit. The current limits count in steps of twice the current reading, which differs
/// by model (facts.md 2, 0x13); the TReX's is inferred.
[[nodiscard]] double physicalFromRaw(const ParameterRow& row, int raw, Model model);

/// The table's defaults of all parameters, for what is not written in any device document a guess.
/// Of calibrations none is stated anywhere.
[[nodiscard]] Configuration defaultConfiguration();

} // namespace trex
