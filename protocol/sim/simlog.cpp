// SPDX-License-Identifier: GPL-3.0-or-later
#include "protocol/sim/simlog.h"

#include <QDateTime>
#include <QJsonDocument>
#include <QJsonObject>

#include <algorithm>

namespace trex::sim {

using namespace Qt::Literals::StringLiterals;

namespace {

QLatin1StringView nameOf(PacketKind kind)
{
    constexpr std::array kNames{"query"_L1, "setting"_L1,    "motor"_L1,
                                "null"_L1,  "bad-format"_L1, "bad-crc"_L1};
    return kNames[static_cast<std::size_t>(kind)];
}

} // namespace

SimLog::SimLog(Instant start, double speed)
    : m_start(start)
    , m_startEpochMs(static_cast<double>(QDateTime::currentMSecsSinceEpoch()))
    , m_speed(speed)
{
}

Result<void> SimLog::open(const QString& path)
{
    m_file.setFileName(path);
    if (!m_file.open(QIODevice::WriteOnly | QIODevice::Truncate)) {
        return fail(ErrorCode::FileUnwritable, u"%1: %2"_s.arg(path, m_file.errorString()));
    }
    return {};
}

void SimLog::note(Instant at, const char* event)
{
    write(at, {{u"event"_s, QLatin1StringView(event)}});
}

void SimLog::collect(SimulatedLine& line)
{
    std::vector<std::pair<Instant, QJsonObject>> entries;
    for (std::size_t i = 0; i < line.deviceCount(); ++i) {
        Device& device = line.device(i);
        const int number = device.parameterInForce(0x00);
        if (m_file.isOpen()) {
            for (const auto& packet : device.heard()) {
                entries.push_back(
                    {packet.time,
                     {{u"device"_s, number},
                      {u"event"_s, u"packet"_s},
                      {u"kind"_s, nameOf(packet.kind)},
                      {u"bytes"_s, QString::fromLatin1(packet.bytes.toHex()).toUpper()}}});
            }
            for (const auto& change : device.outputChanges()) {
                entries.push_back({change.time,
                                   {{u"device"_s, number},
                                    {u"event"_s, u"output"_s},
                                    {u"motor"_s, static_cast<int>(change.motor) + 1},
                                    {u"speed"_s, change.output.speed},
                                    {u"brake"_s, change.output.brake}}});
            }
        }
        m_eepromWrites.resize(line.deviceCount());
        const int writes = device.eeprom().totalWrites();
        if (m_file.isOpen() && writes != m_eepromWrites[i]) {
            const Instant last = device.heard().empty() ? m_start : device.heard().back().time;
            entries.push_back({last,
                               {{u"device"_s, number},
                                {u"event"_s, u"eeprom"_s},
                                {u"writes"_s, writes - m_eepromWrites[i]},
                                {u"total"_s, writes}}});
        }
        m_eepromWrites[i] = writes;
        device.clearHeard();
        device.clearOutputChanges();
    }
    std::stable_sort(entries.begin(), entries.end(),
                     [](const auto& a, const auto& b) { return a.first < b.first; });
    for (auto& [at, entry] : entries) {
        write(at, std::move(entry));
    }
}

void SimLog::write(Instant at, QJsonObject entry)
{
    if (!m_file.isOpen()) {
        return;
    }
    const double ms = std::chrono::duration<double, std::milli>(at - m_start).count();
    entry.insert(u"ms"_s, ms);
    entry.insert(u"epochMs"_s, m_startEpochMs + ms / m_speed);
    m_file.write(QJsonDocument(entry).toJson(QJsonDocument::Compact) + '\n');
    m_file.flush();
}

} // namespace trex::sim
