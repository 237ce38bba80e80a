// SPDX-License-Identifier: GPL-3.0-or-later
#include "protocol/procedures/settingscheck.h"

namespace trex {

SettingsCheck::SettingsCheck(Controller& controller, DeviceSettings& settings, QObject* parent)
    : QObject(parent), m_controller(controller), m_settings(settings)
{
}

void SettingsCheck::read(const Configuration& expected, const Handler& handler)
{
    m_expected = expected;
    m_found = {};
    m_handler = handler;
    m_fields.clear();
    m_next = 0;
    // A reset may have brought another input set into force (0x7C), whose calibrations are others.
    m_controller.request(query("get-mode"), this, [this](const Result<Reply>& reply) {
        const auto mode = reply ? parseMode(reply->payload) : tl::make_unexpected(reply.error());
        if (!keep(mode ? std::nullopt : std::optional(mode.error()))) {
            return;
        }
        m_input = inputOf(*mode);
        for (const auto& [number, raw] : m_expected.parameters) {
            const auto* const row = findParameter(int{number});
            if (row != nullptr && !row->isTrigger) {
                m_fields.push_back({.row = row});
            }
        }
        for (const auto& [channel, calibration] : m_expected.calibrations[m_input]) {
            m_fields.push_back({.channel = channel});
        }
        readNext();
    });
}

void SettingsCheck::readNext()
{
    if (m_next == m_fields.size()) {
        m_handler(m_found);
        return;
    }
    const Field field = m_fields[m_next++];
    if (field.row != nullptr) {
        const auto expected = m_expected.parameters.at(field.row->number);
        m_settings.readSurely(*field.row, expected, this, [this, field](const Result<int>& raw) {
            if (keep(raw ? std::nullopt : std::optional(raw.error()))) {
                m_found.parameters[field.row->number] = *raw;
                readNext();
            }
        });
        return;
    }
    const auto expected = m_expected.calibrations.at(m_input).at(field.channel);
    m_settings.readSurely(
        field.channel, expected, this, [this, field](const Result<Calibration>& calibration) {
            if (keep(calibration ? std::nullopt : std::optional(calibration.error()))) {
                m_found.calibrations[m_input][field.channel] = *calibration;
                readNext();
            }
        });
}

/// False after an error, which has then been told.
bool SettingsCheck::keep(const std::optional<Error>& error)
{
    if (error) {
        m_handler(tl::make_unexpected(*error));
    }
    return !error;
}

} // namespace trex
