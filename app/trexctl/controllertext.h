// SPDX-License-Identifier: GPL-3.0-or-later
// What a controller said, in words and in JSON fields that several verbs share.
#pragma once

#include "protocol/codec/replies.h"

#include <QJsonObject>
#include <QString>

namespace trex {

[[nodiscard]] QString modeText(Mode mode); ///< "serial mode, RC inputs"
[[nodiscard]] QString channelList(std::uint8_t mask); ///< "1, 3", or "none"
[[nodiscard]] QString latin(std::string_view text);
[[nodiscard]] QString yesNo(bool yes);
/// {"raw":55,"amperes":2.2}
[[nodiscard]] QJsonObject currentJson(int raw, Model model);
/// "2.20 A", or "about 8.25 A" where the scale is a guess (facts.md 1)
[[nodiscard]] QString currentText(int raw, Model model);

} // namespace trex
