// SPDX-License-Identifier: GPL-3.0-or-later
// What writeaudit.h does after an interruption and for the way back.
#include "protocol/errortext.h"
#include "protocol/procedures/writeaudit.h"

#include <QLocale>

#include <algorithm>

namespace trex {

using namespace Qt::Literals::StringLiterals;

WriteConclusion conclusionOf(const JournalEntry& entry, const SettingValue& found)
{
    const WriteResult result = found == entry.intent.after ? WriteResult::New
        : found == entry.intent.before                     ? WriteResult::Old
                                                           : WriteResult::Other;
    return {result, found, entry.conclusion.detail};
}

void WriteAudit::resolveWhenConnected()
{
    m_readsForeignBack = true;
    connect(&m_controller, &Controller::stateChanged, this, [this](LinkState state) {
        if (state == LinkState::Connected) {
            resolve(this, [] {});
        }
    });
}

void WriteAudit::resolve(QObject* context, const std::function<void()>& done)
{
    m_whenResolved.emplace_back(context, done);
    if (!std::exchange(m_isResolving, true)) {
        findOpen();
    }
}

void WriteAudit::findOpen()
{
    m_mustLookAgain = false;
    const ControllerIdentity present = controller();
    const auto all = m_journal.entries({.controller = {}, .setting = {}, .onlyOpen = true});
    tellRemark();
    const bool mayBeHere = all && std::ranges::any_of(*all, [&](const JournalEntry& entry) {
                               return entry.controller.port == present.port
                                   && entry.controller.signature == present.signature;
                           });
    if (!mayBeHere) {
        finishResolving();
        return;
    }
    // Which of them are this controller's: its number says so. And the mode, which calibrations.
    const ParameterRow& row = parameterRow("device-number");
    m_settings.readParameter(row, this, [this](const Result<int>& number) {
        if (!number) {
            finishResolving();
            return;
        }
        m_controller.request(query("get-mode"), this, [this](const Result<Reply>& mode) {
            const auto mine =
                m_journal.entries({.controller = controller(), .setting = {}, .onlyOpen = true});
            if (mode && mine) {
                m_open.assign(mine->begin(), mine->end());
            }
            resolveNext();
        });
    });
}

void WriteAudit::resolveNext()
{
    while (!m_open.empty()) {
        const JournalEntry entry = m_open.back(); // oldest first
        m_open.pop_back();
        const SettingId& setting = entry.intent.setting;
        const auto mode = m_controller.device().mode;
        if (setting.row != nullptr && setting.row->isTrigger) {
            settle(entry, std::nullopt);
            continue;
        }
        if (setting.row == nullptr && (!mode || inputOf(*mode) != setting.input)) {
            continue; // the other set cannot be read now
        }
        readBack(setting, [this, entry](const Result<SettingValue>& found) {
            if (!found && isLoss(found.error().code)) {
                m_open.clear();
            } else if (found) {
                settle(entry, *found);
            }
            resolveNext();
        });
        return;
    }
    if (m_mustLookAgain) {
        findOpen();
    } else {
        finishResolving();
    }
}

void WriteAudit::finishResolving()
{
    m_isResolving = false;
    for (const auto& [context, done] : std::exchange(m_whenResolved, {})) {
        if (context) {
            done();
        }
    }
}

void WriteAudit::readBack(const SettingId& setting,
                          const DeviceSettings::Handler<SettingValue>& handler)
{
    const auto onward = [handler](const auto& read) {
        handler(read.map([](const auto& value) { return SettingValue(value); }));
    };
    if (setting.row != nullptr) {
        m_settings.readParameter(*setting.row, this,
                                 [onward](const Result<int>& raw) { onward(raw); });
    } else {
        m_settings.readCalibration(
            setting.channel, this,
            [onward](const Result<Calibration>& calibration) { onward(calibration); });
    }
}

/// Without a value: it can never be found out (a factory reset acts after a power cycle).
void WriteAudit::settle(const JournalEntry& entry, const std::optional<SettingValue>& found)
{
    const SettingId& setting = entry.intent.setting;
    const WriteConclusion conclusion = found ? conclusionOf(entry, *found) : WriteConclusion{};
    if (const auto kept = m_journal.resolve(entry.number, conclusion); !kept) {
        tellFailure(kept);
        return;
    }
    m_mustLookAgain |= setting.row == &parameterRow("device-number");
    const QString what =
        tr("%1, write of %2 that was interrupted")
            .arg(titleOf(setting),
                 QLocale::system().toString(entry.time.toLocalTime(), QLocale::ShortFormat));
    const QString value = textOf(setting, found);
    switch (conclusion.result) {
    case WriteResult::New:
        emit told(1, tr("%1: the controller holds the new value, %2.").arg(what, value));
        break;
    case WriteResult::Old:
        emit told(1, tr("%1: the controller holds the old value, %2.").arg(what, value));
        break;
    case WriteResult::Other:
        emit told(1, tr("%1: the controller holds another value, %2.").arg(what, value));
        break;
    default:
        emit told(1,
                  tr("%1: whether it took place cannot be read back; look at the parameters after "
                     "the next power cycle.")
                      .arg(what));
        break;
    }
    emit recorded();
}

TransferPlan WriteAudit::planRestore(const Configuration& wanted) const
{
    const auto mode = m_controller.device().mode;
    return planTransfer(presentConfiguration(m_controller, m_settings), wanted,
                        mode ? std::optional(inputOf(*mode)) : std::nullopt);
}

Result<TransferPlan> WriteAudit::planRevert(const JournalEntry& entry)
{
    return m_journal.stateBefore(entry).map(
        [this](const Configuration& wanted) { return planRestore(wanted); });
}

} // namespace trex
