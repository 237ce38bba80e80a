// SPDX-License-Identifier: GPL-3.0-or-later
// Does to widgets what a person's hands would, so that the same signals fire. Each function
// returns a sentence when that cannot be done; empty: done.
#pragma once

#include <QString>
#include <QVariant>

class QDialog;
class QObject;

namespace trex::input {

[[nodiscard]] QString click(QObject& object);
/// `property` empty: through the widget's own user path.
[[nodiscard]] QString set(QObject& object, const QString& property, const QVariant& value);
[[nodiscard]] QString press(QObject& object, const QString& sequence);
[[nodiscard]] QString answer(QDialog& dialog, bool accept);

} // namespace trex::input
