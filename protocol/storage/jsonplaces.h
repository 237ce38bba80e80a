// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QByteArray>
#include <QString>
#include <QStringList>

#include <map>
#include <optional>

namespace trex {

/// Where one key of a JSON text stands, and its value as it is written there.
struct JsonPlace {
    int line = 0; ///< from 1
    QString after; ///< the key before it in its object; empty: it is the first
    QByteArray value;
};

/// Where the keys of a JSON text stand, which QJsonDocument does not tell, and whether one stands
/// twice in an object, which it takes in silence. Pure.
struct JsonPlaces {
    std::map<QString, JsonPlace> keys; ///< by path; not those deeper than any of ours
    std::optional<QString> duplicate; ///< path of the first key that stands twice
    int duplicateLine = 0;
};

/// `json` must be well formed: QJsonDocument has taken it.
/// `deepest`: objects and lists within each other whose keys are kept; the default is enough for
/// calibration.rc.1.minimum.
[[nodiscard]] JsonPlaces findPlaces(const QByteArray& json, std::size_t deepest = 6);

/// "device" and "number" are "device.number"; a dot within a key is "\.". What stands in a list has
/// its number, from 0, for a key: "steps.0.speed".
[[nodiscard]] QString pathOf(const QString& object, const QString& key);

/// "line 3, column 12" of a byte offset into the text.
[[nodiscard]] QString placeText(const QByteArray& json, qsizetype offset);

/// The known key that an unknown one is probably a slip of: another case, or a letter or two off.
[[nodiscard]] std::optional<QString> nearestKey(const QString& key, const QStringList& known);

/// A text from a file, made fit to stand in a sentence: without control characters, not too long.
[[nodiscard]] QString tameText(const QString& text);

} // namespace trex
