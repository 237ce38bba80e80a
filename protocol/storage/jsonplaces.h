// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QByteArray>
#include <QString>

#include <map>
#include <optional>

namespace trex {

/// Where the keys of a JSON text stand, which QJsonDocument does not tell, and whether one stands
/// twice in an object, which it takes in silence. Pure.
struct JsonPlaces {
    std::map<QString, int> lines; ///< by key path ("device.number"), from 1
    std::optional<QString> duplicate; ///< path of the first key that stands twice
    int duplicateLine = 0;
};

/// `json` must be well formed: QJsonDocument has taken it.
[[nodiscard]] JsonPlaces findPlaces(const QByteArray& json);

/// "line 3, column 12" of a byte offset into the text.
[[nodiscard]] QString placeText(const QByteArray& json, qsizetype offset);

/// A text from a file, made fit to stand in a sentence: without control characters, not too long.
[[nodiscard]] QString tameText(const QString& text);

} // namespace trex
