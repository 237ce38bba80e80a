// SPDX-License-Identifier: GPL-3.0-or-later
#include "protocol/sim/eeprom.h"

#include "protocol/savefile.h"

#include <QFile>
#include <QJsonArray>
#include <QJsonDocument>

#include <numeric>

namespace trex::sim {

using namespace Qt::Literals::StringLiterals;

namespace {

constexpr auto kFormat = "trexpanel-simulator-eeprom"_L1;
constexpr int kVersion = 1;

} // namespace

void Eeprom::write(int address, std::uint8_t value)
{
    m_bytes[index(address)] = value;
    ++m_writes[index(address)];
    m_dirty = true;
}

CalibrationValues Eeprom::calibration(InputKind kind, int channel) const
{
    const int base = calibrationAddress(kind, channel);
    const auto word = [&](int i) { return at(base + 2 * i) | at(base + 2 * i + 1) << 8; };
    return {word(0), word(1), word(2), word(3)};
}

void Eeprom::writeCalibration(InputKind kind, int channel, const CalibrationValues& values)
{
    int address = calibrationAddress(kind, channel);
    for (const int word : {values.minimum, values.neutral, values.maximum, values.deadband}) {
        write(address++, static_cast<std::uint8_t>(word & 0xFF));
        write(address++, static_cast<std::uint8_t>((word >> 8) & 0xFF));
    }
}

void Eeprom::presetCalibration(InputKind kind, int channel, const CalibrationValues& values)
{
    int address = calibrationAddress(kind, channel);
    for (const int word : {values.minimum, values.neutral, values.maximum, values.deadband}) {
        preset(address++, static_cast<std::uint8_t>(word & 0xFF));
        preset(address++, static_cast<std::uint8_t>((word >> 8) & 0xFF));
    }
}

int Eeprom::totalWrites() const
{
    return std::accumulate(m_writes.begin(), m_writes.end(), 0);
}

QJsonObject Eeprom::toJson() const
{
    const QByteArray bytes(reinterpret_cast<const char*>(m_bytes.data()), kSize);
    QJsonObject writes;
    for (int address = 0; address < kSize; ++address) {
        if (writeCount(address) > 0) {
            writes.insert(QString::number(address), writeCount(address));
        }
    }
    return {{u"bytes"_s, QString::fromLatin1(bytes.toHex())}, {u"writes"_s, writes}};
}

Result<Eeprom> Eeprom::fromJson(const QJsonObject& object)
{
    const QByteArray bytes = QByteArray::fromHex(object.value("bytes"_L1).toString().toLatin1());
    if (bytes.size() != kSize) {
        return fail(ErrorCode::FileMalformed, u"\"bytes\" must be 256 bytes in hex"_s);
    }
    Eeprom result;
    for (int address = 0; address < kSize; ++address) {
        result.preset(address, static_cast<std::uint8_t>(bytes[address]));
    }
    const QJsonObject writes = object.value("writes"_L1).toObject();
    for (auto count = writes.begin(); count != writes.end(); ++count) {
        bool isNumber = false;
        const int address = count.key().toInt(&isNumber);
        if (!isNumber || address < 0 || address >= kSize || !count->isDouble()) {
            return fail(ErrorCode::FileMalformed, u"\"writes\": \"%1\""_s.arg(count.key()));
        }
        result.m_writes[index(address)] = count->toInt();
    }
    return result;
}

Result<std::vector<Eeprom>> loadEeproms(const QString& path)
{
    QFile file(path);
    if (!file.exists()) {
        return std::vector<Eeprom>{};
    }
    if (!file.open(QIODevice::ReadOnly)) {
        return fail(ErrorCode::FileUnreadable, u"%1: %2"_s.arg(path, file.errorString()));
    }
    QJsonParseError problem;
    const QJsonDocument document = QJsonDocument::fromJson(file.readAll(), &problem);
    if (problem.error != QJsonParseError::NoError) {
        return fail(ErrorCode::FileMalformed, u"%1: %2"_s.arg(path, problem.errorString()));
    }
    const QJsonObject root = document.object();
    if (root.value("format"_L1).toString() != kFormat
        || root.value("version"_L1).toInt() != kVersion) {
        return fail(ErrorCode::FileMalformed, u"%1: not a simulator state file"_s.arg(path));
    }
    std::vector<Eeprom> result;
    const QJsonArray controllers = root.value("controllers"_L1).toArray();
    for (const auto& controller : controllers) {
        auto eeprom = Eeprom::fromJson(controller.toObject());
        if (!eeprom) {
            return fail(eeprom.error().code, u"%1: %2"_s.arg(path, eeprom.error().context));
        }
        result.push_back(*eeprom);
    }
    return result;
}

Result<void> saveEeproms(const QString& path, const std::vector<Eeprom>& eeproms)
{
    QJsonArray controllers;
    for (const auto& eeprom : eeproms) {
        controllers.append(eeprom.toJson());
    }
    const QJsonObject root{
        {u"format"_s, kFormat}, {u"version"_s, kVersion}, {u"controllers"_s, controllers}};
    SaveFile file(path);
    const QByteArray text = QJsonDocument(root).toJson();
    if (!file.open(QIODevice::WriteOnly) || file.write(text) != text.size() || !file.commit()) {
        return fail(ErrorCode::FileUnwritable, u"%1: %2"_s.arg(path, file.errorString()));
    }
    return {};
}

} // namespace trex::sim
