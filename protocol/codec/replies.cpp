// SPDX-License-Identifier: GPL-3.0-or-later
#include "protocol/codec/replies.h"

#include "protocol/codec/packet.h"

namespace trex {
namespace {

struct ModeRow {
    char letter;
    std::string_view key;
};
// By Mode; command documentation, 0x82.
constexpr std::array<ModeRow, 4> kModes{
    {{'R', "rc"}, {'A', "analog"}, {'r', "serial-rc"}, {'a', "serial-analog"}}};

constexpr QByteArrayView kTrexName("TReX");
constexpr QByteArrayView kJrName("TReXJr");
constexpr int kVersionBytes = 3; // major byte, '.', minor byte (command documentation, 0x81)

bool isDigit(char letter)
{
    return letter >= '0' && letter <= '9';
}

} // namespace

QString Signature::text() const
{
    return QString::fromLatin1(model == Model::TrexJr ? kJrName : kTrexName) + firmware();
}

QString Signature::modelName() const
{
    return model == Model::TrexJr ? QStringLiteral("TReX Jr") : QStringLiteral("TReX");
}

QString Signature::firmware() const
{
    return QStringLiteral("%1.%2").arg(major).arg(minor);
}

Result<Signature> parseSignature(QByteArrayView payload)
{
    if (!payload.startsWith(kTrexName)) {
        return fail(ErrorCode::NotATrex, toHex(payload));
    }
    const Model model = payload.startsWith(kJrName) ? Model::TrexJr : Model::Trex;
    const auto version = payload.sliced(model == Model::TrexJr ? kJrName.size() : kTrexName.size());
    if (version.size() != kVersionBytes || !isDigit(version[0]) || version[1] != '.'
        || !isDigit(version[2])) {
        return fail(ErrorCode::BadReply, toHex(payload));
    }
    return Signature{model, version[0] - '0', version[2] - '0'};
}

Result<Mode> parseMode(QByteArrayView payload)
{
    if (payload.size() == 1) {
        const auto* const row = std::ranges::find(kModes, payload[0], &ModeRow::letter);
        if (row != kModes.end()) {
            return static_cast<Mode>(row - kModes.begin());
        }
    }
    return fail(ErrorCode::BadReply, toHex(payload));
}

char letterOf(Mode mode)
{
    return kModes[static_cast<std::size_t>(mode)].letter;
}

std::string_view keyOf(Mode mode)
{
    return kModes[static_cast<std::size_t>(mode)].key;
}

Calibration parseCalibration(QByteArrayView payload)
{
    const auto& fields = commandRow("get-calibration").reply;
    std::array<int, 4> values{};
    for (std::size_t i = 0; i < values.size(); ++i) {
        const auto place = static_cast<qsizetype>(i) * 2;
        if (place + 2 <= payload.size()) {
            values[i] = rawOf(fields[i], payload.data() + place);
        }
    }
    return {values[0], values[1], values[2], values[3]};
}

Result<void> parseAnswer(QByteArrayView payload)
{
    if (payload.size() != 1) {
        return fail(ErrorCode::BadReply, toHex(payload));
    }
    switch (static_cast<std::uint8_t>(payload[0])) { // command documentation, 0xA0 and 0xAF
    case 0:
        return {};
    case 1:
        return fail(ErrorCode::BadParameterNumber);
    case 2:
        return fail(ErrorCode::BadValue);
    case 3:
        return fail(ErrorCode::NotInSerialMode);
    default:
        return fail(ErrorCode::UnknownAnswer, toHex(payload));
    }
}

} // namespace trex
