// SPDX-License-Identifier: GPL-3.0-or-later
#include "protocol/codec/fieldspec.h"

#include <QCoreApplication>
#include <QStringList>

namespace trex {
namespace {

struct Label {
    std::string_view key;
    const char* text;
};

// clang-format off
constexpr auto kLabels = std::to_array<Label>({
    {"answer", QT_TRANSLATE_NOOP("Packets", "answer")},
    {"channel1", QT_TRANSLATE_NOOP("Packets", "channel 1")},
    {"channel2", QT_TRANSLATE_NOOP("Packets", "channel 2")},
    {"channel3", QT_TRANSLATE_NOOP("Packets", "channel 3")},
    {"channel4", QT_TRANSLATE_NOOP("Packets", "channel 4")},
    {"channel5", QT_TRANSLATE_NOOP("Packets", "channel 5")},
    {"crc", QT_TRANSLATE_NOOP("Packets", "CRC error")},
    {"deadband", QT_TRANSLATE_NOOP("Packets", "deadband")},
    {"device", QT_TRANSLATE_NOOP("Packets", "device number")},
    {"format", QT_TRANSLATE_NOOP("Packets", "format error")},
    {"format1", QT_TRANSLATE_NOOP("Packets", "format byte 1")},
    {"format2", QT_TRANSLATE_NOOP("Packets", "format byte 2")},
    {"frame", QT_TRANSLATE_NOOP("Packets", "frame error")},
    {"learned", QT_TRANSLATE_NOOP("Packets", "learned")},
    {"mask", QT_TRANSLATE_NOOP("Packets", "channels")},
    {"maximum", QT_TRANSLATE_NOOP("Packets", "maximum")},
    {"minimum", QT_TRANSLATE_NOOP("Packets", "minimum")},
    {"mode", QT_TRANSLATE_NOOP("Packets", "mode")},
    {"motor1-current", QT_TRANSLATE_NOOP("Packets", "motor 1")},
    {"motor1-fault", QT_TRANSLATE_NOOP("Packets", "motor 1 fault")},
    {"motor1-over-current", QT_TRANSLATE_NOOP("Packets", "motor 1 over current limit")},
    {"motor1-speed", QT_TRANSLATE_NOOP("Packets", "motor 1 speed")},
    {"motor2-current", QT_TRANSLATE_NOOP("Packets", "motor 2")},
    {"motor2-fault", QT_TRANSLATE_NOOP("Packets", "motor 2 fault")},
    {"motor2-over-current", QT_TRANSLATE_NOOP("Packets", "motor 2 over current limit")},
    {"motor2-speed", QT_TRANSLATE_NOOP("Packets", "motor 2 speed")},
    {"neutral", QT_TRANSLATE_NOOP("Packets", "neutral")},
    {"overrun", QT_TRANSLATE_NOOP("Packets", "data overrun")},
    {"parameter", QT_TRANSLATE_NOOP("Packets", "parameter")},
    {"parity", QT_TRANSLATE_NOOP("Packets", "parity error")},
    {"raw", QT_TRANSLATE_NOOP("Packets", "raw")},
    {"read-buffer-overrun", QT_TRANSLATE_NOOP("Packets", "read buffer overrun")},
    {"remapped", QT_TRANSLATE_NOOP("Packets", "remapped")},
    {"send-buffer-overrun", QT_TRANSLATE_NOOP("Packets", "send buffer overrun")},
    {"serial-controls", QT_TRANSLATE_NOOP("Packets", "serial controls the motors")},
    {"signature", QT_TRANSLATE_NOOP("Packets", "signature")},
    {"speed", QT_TRANSLATE_NOOP("Packets", "speed")},
    {"status", QT_TRANSLATE_NOOP("Packets", "status")},
    {"timeout", QT_TRANSLATE_NOOP("Packets", "timeout")},
    {"uart-error", QT_TRANSLATE_NOOP("Packets", "UART error")},
    {"uart-errors", QT_TRANSLATE_NOOP("Packets", "UART errors")},
    {"value", QT_TRANSLATE_NOOP("Packets", "value")},
});
// clang-format on

QString hexByte(int raw)
{
    return QStringLiteral("0x%1").arg(QString::number(raw, 16).toUpper(), 2, QLatin1Char('0'));
}

QString bitsText(const FieldSpec& field, int raw)
{
    QStringList names;
    for (int bit = 0; bit < 8; ++bit) {
        if ((raw >> bit & 1) == 0) {
            continue;
        }
        const auto place = static_cast<std::size_t>(bit);
        const bool hasName = place < field.bitNames.size() && !field.bitNames[place].empty();
        names << (hasName ? labelOf(field.bitNames[place])
                          : QCoreApplication::translate("Packets", "bit %1").arg(bit));
    }
    return names.isEmpty() ? QCoreApplication::translate("Packets", "none")
                           : names.join(QStringLiteral(", "));
}

QString answerText(int raw)
{
    switch (raw) { // command documentation, 0xA0 and 0xAF
    case 0:
        return QCoreApplication::translate("Packets", "done");
    case 1:
        return QCoreApplication::translate("Packets", "refused: bad parameter number");
    case 2:
        return QCoreApplication::translate("Packets", "refused: bad value");
    case 3:
        return QCoreApplication::translate("Packets", "refused: not in serial mode");
    default:
        return QCoreApplication::translate("Packets", "unknown answer %1").arg(raw);
    }
}

QString asciiText(QByteArrayView bytes)
{
    QString text;
    for (const char byte : bytes) {
        const auto code = static_cast<std::uint8_t>(byte);
        text += code >= 0x20 && code < 0x7F ? QString(QLatin1Char(byte)) : hexByte(code);
    }
    return text;
}

} // namespace

QString labelOf(std::string_view key)
{
    const auto* const label = std::ranges::find(kLabels, key, &Label::key);
    return label == kLabels.end() ? QString::fromLatin1(key)
                                  : QCoreApplication::translate("Packets", label->text);
}

int rawOf(const FieldSpec& field, const char* bytes)
{
    const auto first = static_cast<std::uint8_t>(bytes[0]);
    switch (field.kind) {
    case FieldKind::Pair7:
        return first | static_cast<std::uint8_t>(bytes[1]) << 7;
    case FieldKind::Word:
        return first | static_cast<std::uint8_t>(bytes[1]) << 8;
    case FieldKind::SignMagnitude:
        return signedFromRemapped(first);
    case FieldKind::Byte:
    case FieldKind::Bits:
    case FieldKind::Ascii:
    case FieldKind::Constant:
    case FieldKind::AnswerCode:
        break;
    }
    return first;
}

QString textOf(const FieldSpec& field, int raw)
{
    switch (field.kind) {
    case FieldKind::Bits:
        return bitsText(field, raw);
    case FieldKind::Ascii: {
        const char letter = static_cast<char>(raw);
        return asciiText(QByteArrayView(&letter, 1));
    }
    case FieldKind::Constant:
        return hexByte(raw);
    case FieldKind::AnswerCode:
        return answerText(raw);
    case FieldKind::Byte:
    case FieldKind::Pair7:
    case FieldKind::Word:
    case FieldKind::SignMagnitude:
        break;
    }
    return QString::number(raw);
}

std::vector<DecodedField> decodeFields(std::span<const FieldSpec> fields, QByteArrayView bytes)
{
    std::vector<DecodedField> decoded;
    decoded.reserve(fields.size());
    for (const auto& field : fields) {
        if (bytes.size() < field.width()) {
            break;
        }
        const int raw = rawOf(field, bytes.data());
        // Text runs to the end of the reply: the signature's length depends on the model.
        const bool isText = field.kind == FieldKind::Ascii && &field == &fields.back();
        decoded.push_back({field.key, raw, isText ? asciiText(bytes) : textOf(field, raw)});
        bytes = bytes.sliced(isText ? bytes.size() : field.width());
    }
    return decoded;
}

} // namespace trex
