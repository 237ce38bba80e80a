// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "protocol/storage/benchprofile.h"

#include <span>
#include <string_view>

namespace trex {

/// A bench test that comes with the program (resources/profiles/KEY.json).
struct ReadyProfileRow {
    std::string_view key; ///< "step-response"
    const char* title; ///< QT_TRANSLATE_NOOP("Bench", …)
    const char* description;
};

[[nodiscard]] std::span<const ReadyProfileRow> readyProfiles();
/// With its title and description in the language in force. Errors: FileUnreadable for a key that
/// there is none of.
[[nodiscard]] Result<BenchProfile> readyProfile(std::string_view key);

} // namespace trex
