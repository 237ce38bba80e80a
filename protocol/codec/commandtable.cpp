// SPDX-License-Identifier: GPL-3.0-or-later
#include "protocol/codec/commandtable.h"

namespace trex {

const CommandRow* findCommand(std::string_view key)
{
    for (const auto& row : kCommands) {
        if (row.key == key) {
            return &row;
        }
    }
    return nullptr;
}

} // namespace trex
