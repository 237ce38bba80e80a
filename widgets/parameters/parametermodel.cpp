// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/parameters/parametermodel.h"

#include "protocol/errortext.h"

#include <algorithm>

using namespace Qt::Literals::StringLiterals;

namespace trex {

ParameterModel::ParameterModel(QObject* parent) : QAbstractItemModel(parent)
{
    for (const auto& row : kParameters) {
        if (row.isTrigger) {
            continue;
        }
        auto found = std::ranges::find_if(m_groups, [&row](const Group& group) {
            return QLatin1StringView(group.title) == QLatin1StringView(row.group);
        });
        if (found == m_groups.end()) {
            found = m_groups.insert(m_groups.end(), {row.group, {}});
        }
        found->rows.push_back(&row);
    }
}

const ParameterRow* ParameterModel::rowAt(const QModelIndex& index)
{
    if (!index.isValid() || index.internalId() == kGroupId) {
        return nullptr;
    }
    const auto* const model = qobject_cast<const ParameterModel*>(index.model());
    return model == nullptr
        ? nullptr
        : model->m_groups.at(index.internalId() - 1).rows.at(static_cast<std::size_t>(index.row()));
}

QModelIndex ParameterModel::indexOf(std::uint8_t number, int column) const
{
    for (std::size_t group = 0; group < m_groups.size(); ++group) {
        const auto& rows = m_groups[group].rows;
        const auto found = std::ranges::find(rows, number, &ParameterRow::number);
        if (found != rows.end()) {
            return createIndex(static_cast<int>(found - rows.begin()), column, group + 1);
        }
    }
    return {};
}

std::optional<int> ParameterModel::device(std::uint8_t number) const
{
    const auto found = m_device.find(number);
    return found == m_device.end() ? std::nullopt : std::optional(found->second);
}

std::optional<int> ParameterModel::shown(std::uint8_t number) const
{
    const auto found = m_edits.find(number);
    return found == m_edits.end() ? device(number) : std::optional(found->second);
}

bool ParameterModel::isEdited(std::uint8_t number) const
{
    return m_edits.contains(number);
}

ParameterModel::State ParameterModel::state(std::uint8_t number) const
{
    if (m_refusals.contains(number)) {
        return State::Refused;
    }
    if (isEdited(number)) {
        return State::Edited;
    }
    if (!device(number)) {
        return State::Unread;
    }
    if (m_pending.contains(number)) {
        return State::Pending;
    }
    if (std::ranges::any_of(m_advice, [number](const Advice& advice) {
            return advice.parameter == number && !advice.isAboutChange;
        })) {
        return State::Advised;
    }
    return *device(number) == findParameter(int{number})->defaultRaw ? State::AtDefault
                                                                     : State::Differs;
}

bool ParameterModel::matches(std::uint8_t number, Filter filter) const
{
    switch (filter) {
    case Filter::All:
        break;
    case Filter::Changed:
        return isEdited(number) || m_refusals.contains(number);
    case Filter::NotDefault:
        return shown(number) && *shown(number) != findParameter(int{number})->defaultRaw;
    case Filter::PowerCycle:
        return findParameter(int{number})->needsReset || m_pending.contains(number);
    }
    return true;
}

ValueContext ParameterModel::context(const ParameterRow& row) const
{
    const auto* const maximum = pwmMaximumFor(row);
    return {m_controllerModel, maximum == nullptr ? std::nullopt : shown(maximum->number)};
}

ValueContext ParameterModel::deviceContext(const ParameterRow& row) const
{
    const auto* const maximum = pwmMaximumFor(row);
    return {m_controllerModel, maximum == nullptr ? std::nullopt : device(maximum->number)};
}

QStringList ParameterModel::advice(std::uint8_t number) const
{
    QStringList sentences;
    for (const auto& each : m_advice) {
        if (each.parameter == number) {
            sentences << each.text;
        }
    }
    return sentences;
}

QStringList ParameterModel::remarks(std::uint8_t number) const
{
    QStringList remarks;
    if (const auto refusal = m_refusals.find(number); refusal != m_refusals.end()) {
        remarks << refusal->second;
    }
    if (m_pending.contains(number)) {
        remarks << tr("Stored, but not in force before the controller's power is switched off and "
                      "on.");
    }
    remarks += advice(number);
    return remarks;
}

ParameterValues ParameterModel::wanted() const
{
    ParameterValues values = m_edits;
    values.insert(m_device.begin(), m_device.end()); // keeps the edits
    return values;
}

Result<void> ParameterModel::edit(std::uint8_t number, int raw)
{
    const auto* const row = findParameter(int{number});
    if (row == nullptr || row->isTrigger || !accepts(*row, raw)) {
        return row == nullptr ? fail(ErrorCode::BadParameterNumber)
                              : outOfRange(row->key, raw, row->minimum, row->maximum);
    }
    const bool same = device(number) == raw;
    if (same ? m_edits.erase(number) == 0 : shown(number) == raw && isEdited(number)) {
        rowChanged(number);
        return {};
    }
    if (!same) {
        m_edits[number] = raw;
    }
    m_refusals.erase(number);
    rowAndItsPrescalerChanged(number);
    emit editsChanged();
    return {};
}

void ParameterModel::revert(std::uint8_t number)
{
    m_refusals.erase(number);
    if (m_edits.erase(number) > 0) {
        rowAndItsPrescalerChanged(number);
        emit editsChanged();
    }
}

void ParameterModel::revert()
{
    const auto edits = std::exchange(m_edits, {});
    const auto refusals = std::exchange(m_refusals, {});
    for (const auto& [number, raw] : edits) {
        rowAndItsPrescalerChanged(number);
    }
    for (const auto& [number, sentence] : refusals) {
        rowChanged(number);
    }
    emit editsChanged();
}

void ParameterModel::setDevice(std::uint8_t number, std::optional<int> raw)
{
    const auto before = device(number);
    if (raw) {
        m_device[number] = *raw;
    } else {
        m_device.erase(number);
    }
    const auto edit = m_edits.find(number);
    if (edit != m_edits.end() && raw == edit->second) {
        m_edits.erase(edit); // it has arrived
        m_refusals.erase(number);
        emit editsChanged();
    }
    if (before != raw || raw) {
        rowAndItsPrescalerChanged(number);
    }
}

void ParameterModel::setControllerModel(Model model)
{
    if (std::exchange(m_controllerModel, model) != model) {
        refreshAll();
    }
}

void ParameterModel::setPending(std::uint8_t number, bool pending)
{
    if (pending ? m_pending.insert(number).second : m_pending.erase(number) > 0) {
        rowChanged(number);
    }
}

void ParameterModel::setAdvice(const std::vector<Advice>& advice)
{
    if (m_advice == advice) {
        return;
    }
    const auto before = std::exchange(m_advice, advice);
    for (const auto& each : before) {
        rowChanged(each.parameter);
    }
    for (const auto& each : advice) {
        rowChanged(each.parameter);
    }
}

void ParameterModel::setRefusal(std::uint8_t number, const QString& sentence)
{
    m_refusals[number] = sentence;
    rowChanged(number);
}

void ParameterModel::clearRefusals()
{
    for (const auto& [number, sentence] : std::exchange(m_refusals, {})) {
        rowChanged(number);
    }
}

void ParameterModel::refreshAll()
{
    for (const auto& row : kParameters) {
        rowChanged(row.number);
    }
}

void ParameterModel::rowChanged(std::uint8_t number)
{
    const QModelIndex first = indexOf(number, 0);
    if (first.isValid()) {
        emit dataChanged(first, first.siblingAtColumn(ColumnCount - 1));
        emit shownChanged(number);
    }
}

void ParameterModel::rowAndItsPrescalerChanged(std::uint8_t number)
{
    rowChanged(number);
    for (const auto& row : kParameters) {
        const auto* const maximum = pwmMaximumFor(row);
        if (maximum != nullptr && maximum->number == number) {
            rowChanged(row.number); // its frequency is another one
        }
    }
}

} // namespace trex
