// SPDX-License-Identifier: GPL-3.0-or-later
// How one field of a packet is laid out: enough to encode arguments, decode replies and explain
// either in the packet view, by looping over rows.
#pragma once

#include "protocol/codec/quantities.h"

#include <QString>

#include <span>
#include <string_view>
#include <vector>

namespace trex {

enum class FieldKind : std::uint8_t {
    Byte, ///< one byte, 0 to maximum
    Pair7, ///< two data bytes of a setting: value & 0x7F, value >> 7 (conformance C-35)
    Word, ///< two reply bytes, low first, all eight bits used
    SignMagnitude, ///< remapped value: bit 7 direction, bits 6:0 magnitude
    Bits, ///< a byte whose bits have names
    Ascii, ///< a letter (mode) or text (signature)
    Constant, ///< a format byte: minimum says which
    AnswerCode, ///< 0 done, 1 bad parameter, 2 bad value, 3 not in serial mode
};

struct FieldSpec {
    std::string_view key; ///< stable name, English, lower case
    FieldKind kind = FieldKind::Byte;
    int minimum = 0;
    int maximum = 127;
    std::span<const std::string_view> bitNames{}; ///< bit 0 first
    [[nodiscard]] constexpr int width() const
    {
        return kind == FieldKind::Pair7 || kind == FieldKind::Word ? 2 : 1;
    }
};

struct DecodedField {
    std::string_view key;
    int raw = 0;
    QString text; ///< raw for people: bit names, letters, hex of a constant
};

/// A field's or a bit's key in translated words; the key itself where the list has none.
[[nodiscard]] QString labelOf(std::string_view key);
/// One field read from bytes that are long enough; the caller checks the length.
[[nodiscard]] int rawOf(const FieldSpec& field, const char* bytes);
[[nodiscard]] QString textOf(const FieldSpec& field, int raw);
/// As many fields as the bytes cover, in order. Text that comes last takes all remaining bytes.
[[nodiscard]] std::vector<DecodedField> decodeFields(std::span<const FieldSpec> fields,
                                                     QByteArrayView bytes);

} // namespace trex
