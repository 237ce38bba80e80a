// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "protocol/codec/command.h"
#include "protocol/codec/parametertable.h"
#include "protocol/result.h"

#include <QDateTime>

#include <map>

namespace trex {

using ParameterValues = std::map<std::uint8_t, int>; ///< raw, by parameter number

/// A member of the file that is none of ours: a comment, or what a newer program wrote.
struct UnknownMember {
    QString after; ///< the key before it in its object; empty: it is the first
    QByteArray json; ///< its value, as it stands in the file
    bool operator==(const UnknownMember&) const = default;
    /// JSON has no comments: a text (or a list of texts) under a key of one's own is one.
    [[nodiscard]] bool isComment() const;
};

/// A controller's settings as a configuration file holds them: some or all parameters and
/// calibrations. Calibrations are by input set and channel (1 to 5).
struct Configuration {
    static constexpr int kVersion = 1;
    int version = kVersion; ///< of the file; newer ones are read as far as they are understood
    QDateTime saved; ///< UTC, whole seconds; invalid: not said
    QString signature; ///< as the controller sent it, "TReXJr1.2"; empty: not said
    QString firmware; ///< "1.2", as the signature says; empty: not said, as in older files
    std::optional<int> deviceNumber;
    ParameterValues parameters;
    std::map<InputKind, std::map<int, Calibration>> calibrations;
    /// What the file holds beyond that, by the path of its object and its key; written back where
    /// it stood, byte for byte.
    std::map<std::pair<QString, QString>, UnknownMember> unknown;
    bool operator==(const Configuration&) const = default;
};

inline constexpr qint64 kLargestConfigurationBytes = qint64(1024) * 1024;

/// All or nothing. Errors: FileMalformed, with `fileName`, the place (line, column, key) and the
/// reason. `raw` decides; a `physical` or `unit` that disagrees with it is refused.
[[nodiscard]] Result<Configuration> parseConfiguration(const QByteArray& json,
                                                       const QString& fileName);
/// Indented JSON whose order depends on the values only: the same configuration gives the same
/// bytes, and what was written is read back as the same configuration.
[[nodiscard]] QByteArray writeConfiguration(const Configuration& configuration);

/// Errors: FileUnreadable (also for what is no ordinary file), FileMalformed.
[[nodiscard]] Result<Configuration> loadConfiguration(const QString& path);
/// Whole or not at all: a file that was there stays as it was until the new one is complete. The
/// comments of a configuration that it replaces are kept. Errors: FileUnwritable.
[[nodiscard]] Result<void> saveConfiguration(const Configuration& configuration,
                                             const QString& path);

/// What to tell of a file written by a newer program, or with members that are neither ours nor
/// comments; empty when there is nothing to tell.
[[nodiscard]] QString remarkOn(const Configuration& configuration);

/// "serial-timeout": the row's key as a QString.
[[nodiscard]] QString keyText(const ParameterRow& row);
[[nodiscard]] QLatin1StringView keyOf(InputKind input); ///< "rc", "analog"

} // namespace trex
