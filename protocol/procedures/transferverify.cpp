// SPDX-License-Identifier: GPL-3.0-or-later
// ConfigTransfer's last part: everything is read once more, and what a damaged packet has changed
// is put right.
#include "protocol/procedures/configtransfer.h"
#include "protocol/procedures/settingscheck.h"

#include "protocol/errortext.h"

#include <algorithm>

using namespace Qt::Literals::StringLiterals;

namespace trex {
namespace {

constexpr int kMostRounds = 3; // of reading everything and putting right

std::optional<int> parameterIn(const Configuration& configuration, const ParameterRow& row)
{
    const auto found = configuration.parameters.find(row.number);
    return found == configuration.parameters.end() ? std::nullopt : std::optional(found->second);
}

std::optional<Calibration> calibrationIn(const Configuration& configuration, InputKind input,
                                         int channel)
{
    const auto set = configuration.calibrations.find(input);
    if (set == configuration.calibrations.end() || !set->second.contains(channel)) {
        return std::nullopt;
    }
    return set->second.at(channel);
}

/// Those that are so go from one list to the end of the other; both keep their order. (The one of
/// std::ranges is not used: clang 14 cannot compile libstdc++ 12's.)
template <class F>
void moveIf(std::vector<SettingWrite>& from, std::vector<SettingWrite>& to, F isSo)
{
    const auto found = std::stable_partition(
        from.begin(), from.end(), [&](const SettingWrite& write) { return !isSo(write); });
    to.insert(to.end(), found, from.end());
    from.erase(found, from.end());
}

/// True when the setting of `write` was found to hold its new (or its old) value.
bool holdsNew(const SettingWrite& write, const Configuration& found)
{
    return write.row != nullptr
        ? parameterIn(found, *write.row) == write.rawTo
        : calibrationIn(found, write.input, write.channel) == write.calibrationTo;
}

bool holdsOld(const SettingWrite& write, const Configuration& found)
{
    return write.row != nullptr ? write.rawFrom && parameterIn(found, *write.row) == write.rawFrom
                                : write.calibrationFrom
            && calibrationIn(found, write.input, write.channel) == write.calibrationFrom;
}

bool isSameSetting(const SettingWrite& a, const SettingWrite& b)
{
    return a.row == b.row && a.input == b.input && a.channel == b.channel;
}

bool isIn(const std::vector<SettingWrite>& writes, const SettingWrite& write)
{
    return std::ranges::any_of(writes,
                               [&](const SettingWrite& w) { return isSameSetting(w, write); });
}

} // namespace

void ConfigTransfer::prepare()
{
    m_before = presentConfiguration(m_controller, m_settings);
    for (const SettingWrite& write : m_plan.writes) {
        if (write.row != nullptr && write.rawFrom) {
            m_before.parameters[write.row->number] = *write.rawFrom;
        } else if (write.row == nullptr && write.calibrationFrom) {
            m_before.calibrations[write.input][write.channel] = *write.calibrationFrom;
        }
    }
    m_expected = m_before;
    m_suspects.clear();
    m_strays.clear();
    m_rounds = 0;
    m_isChecked = false;
}

/// Packets under a new device number are the only ones that reach the controller after it.
bool ConfigTransfer::isUnreadable(const SettingWrite& write) const
{
    return write.row == &parameterRow("device-number")
        && m_controller.options().line.form == PacketForm::Pololu;
}

void ConfigTransfer::expect(const SettingWrite& write)
{
    if (write.row != nullptr) {
        m_expected.parameters[write.row->number] = write.rawTo;
    } else {
        m_expected.calibrations[write.input][write.channel] = write.calibrationTo;
    }
}

void ConfigTransfer::verify(void (ConfigTransfer::*then)())
{
    m_then = then;
    const bool isReadable =
        std::ranges::none_of(m_outcome.written, [this](const auto& w) { return isUnreadable(w); });
    const bool hasSent = !m_outcome.written.empty() || !m_outcome.restored.empty()
        || !m_outcome.notRestored.empty() || m_outcome.failed;
    if (!hasSent || !isReadable || m_controller.state() != LinkState::Connected) {
        (this->*m_then)();
        return;
    }
    m_check->read(m_expected, [this](const Result<Configuration>& found) {
        if (found) {
            onFound(*found);
            return;
        }
        m_outcome.notes << tr("The last check of all settings could not be done: %1")
                               .arg(errorText(found.error()));
        (this->*m_then)();
    });
}

void ConfigTransfer::onFound(const Configuration& found)
{
    settleDoubts(found);
    collectStrays(found);
    if (m_strays.empty()) {
        (this->*m_then)();
    } else if (++m_rounds > kMostRounds) {
        std::ranges::move(m_strays, std::back_inserter(m_outcome.notRestored));
        m_outcome.error = m_outcome.error.value_or(Error{ErrorCode::ReadBackDiffers, {}});
        (this->*m_then)();
    } else {
        repairNext();
    }
}

/// What was said to hold either value is known now.
void ConfigTransfer::settleDoubts(const Configuration& found)
{
    if (m_outcome.failed && m_outcome.failedMayHold) {
        if (holdsNew(*m_outcome.failed, found)) {
            m_outcome.failedMayHold = false;
            m_outcome.written.push_back(*m_outcome.failed);
            expect(*m_outcome.failed);
        } else if (holdsOld(*m_outcome.failed, found)) {
            m_outcome.failedMayHold = false;
        }
    }
    moveIf(m_outcome.notRestored, m_outcome.restored,
           [&](const SettingWrite& write) { return holdsOld(write, found); });
}

/// Settings that hold neither what they held before nor what was written to them.
void ConfigTransfer::collectStrays(const Configuration& found)
{
    const auto consider = [this](const SettingWrite& stray, const QString& now) {
        if (isIn(m_plan.writes, stray) || isSuspect(stray)) {
            m_strays.push_back(stray);
        } else if (m_rounds == 0) { // somebody else's doing, or it was misread before
            m_outcome.notes << tr("%1 reads %2 now, though nothing was written to it; it is left "
                                  "as it is.")
                                   .arg(stray.title(), now);
        }
    };
    for (const auto& [number, raw] : found.parameters) {
        const auto expected = m_expected.parameters.find(number);
        if (expected != m_expected.parameters.end() && expected->second != raw) {
            const auto* const row = findParameter(int{number});
            SettingWrite stray;
            stray.row = row;
            stray.rawFrom = raw;
            stray.rawTo = expected->second;
            consider(stray, parameterText(*row, raw));
        }
    }
    for (const auto& [input, channels] : found.calibrations) {
        for (const auto& [channel, now] : channels) {
            const auto expected = calibrationIn(m_expected, input, channel);
            if (expected && *expected != now) {
                SettingWrite stray;
                stray.input = input;
                stray.channel = channel;
                stray.calibrationFrom = now;
                stray.calibrationTo = *expected;
                consider(stray,
                         u"%1/%2/%3 ±%4"_s.arg(now.minimum)
                             .arg(now.neutral)
                             .arg(now.maximum)
                             .arg(now.deadband));
            }
        }
    }
}

/// A packet that went wrong carried the very value that stands here now; or it may have been read
/// as a factory reset (0x7F, 0x7F).
bool ConfigTransfer::isSuspect(const SettingWrite& stray) const
{
    return std::ranges::any_of(m_suspects, [&](const SettingWrite& suspect) {
        if (isSameSetting(stray, suspect)) {
            return false;
        }
        if (stray.row == nullptr || suspect.row == nullptr) {
            return stray.row == suspect.row && stray.calibrationFrom == suspect.calibrationTo;
        }
        return stray.rawFrom == suspect.rawTo || suspect.rawTo == kFactoryResetValue;
    });
}

void ConfigTransfer::repairNext()
{
    if (m_strays.empty()) {
        verify(m_then);
        return;
    }
    const SettingWrite stray = m_strays.back();
    const auto done = [this](const std::optional<Error>& error) { onRepaired(error); };
    if (stray.row == nullptr) {
        performCalibration(stray, done);
    } else {
        m_settings.writeParameter(*stray.row, stray.rawTo, true, this,
                                  [done](const Result<DeviceSettings::ParameterWrite>& result) {
                                      done(result ? std::nullopt : std::optional(result.error()));
                                  });
    }
}

void ConfigTransfer::onRepaired(const std::optional<Error>& error)
{
    const SettingWrite stray = m_strays.back();
    m_strays.pop_back();
    if (error) {
        m_suspects.push_back(stray);
    } else {
        m_outcome.notes << (isSuspect(stray)
                                ? tr("%1 had been changed by a damaged packet; it is put right.")
                                : tr("%1 did not hold what it should; it is put right."))
                               .arg(stray.title());
    }
    if (error && isLoss(error->code) && m_controller.state() != LinkState::Connected) {
        m_outcome.notRestored.push_back(stray);
        std::ranges::move(m_strays, std::back_inserter(m_outcome.notRestored));
        m_strays.clear();
        m_outcome.error = m_outcome.error.value_or(*error);
        (this->*m_then)();
        return;
    }
    repairNext();
}

void ConfigTransfer::examine()
{
    Q_ASSERT(!m_busy);
    m_busy = true;
    m_check->read(m_before, [this](const Result<Configuration>& found) {
        if (found) {
            settleDoubts(*found);
            moveIf(m_outcome.notRestored, m_outcome.written,
                   [&](const SettingWrite& write) { return holdsNew(write, *found); });
        }
        finish();
    });
}

} // namespace trex
