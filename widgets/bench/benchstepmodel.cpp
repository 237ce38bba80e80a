// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/bench/benchstepmodel.h"

#include <QCoreApplication>

namespace trex {

using namespace Qt::Literals::StringLiterals;

namespace {

struct BenchSteps {
    Q_DECLARE_TR_FUNCTIONS(BenchSteps)
};

QString conditionText(const BenchStep& step)
{
    switch (step.condition) {
    case BenchCondition::CurrentAbove:
        return BenchSteps::tr("until the current is above %1 A").arg(step.threshold);
    case BenchCondition::CurrentBelow:
        return BenchSteps::tr("until the current is below %1 A").arg(step.threshold);
    case BenchCondition::Status:
        return BenchSteps::tr("until the status shows %1").arg(statusBitKey(step.number));
    case BenchCondition::ChannelAbove:
        return BenchSteps::tr("until channel %1 is above %2").arg(step.number).arg(step.threshold);
    case BenchCondition::ChannelBelow:
        return BenchSteps::tr("until channel %1 is below %2").arg(step.number).arg(step.threshold);
    case BenchCondition::Time:
        return BenchSteps::tr("until %1 s since the start").arg(step.threshold);
    }
    return {};
}

bool hasMotor(const BenchStep& step)
{
    return step.action != BenchAction::Hold && step.action != BenchAction::Repeat
        && (step.action != BenchAction::Wait || step.condition == BenchCondition::CurrentAbove
            || step.condition == BenchCondition::CurrentBelow);
}

} // namespace

QString titleOf(BenchAction action)
{
    switch (action) {
    case BenchAction::Set:
        return BenchSteps::tr("Set");
    case BenchAction::Accelerate:
        return BenchSteps::tr("Accelerate");
    case BenchAction::Ramp:
        return BenchSteps::tr("Ramp");
    case BenchAction::Step:
        return BenchSteps::tr("Step and back");
    case BenchAction::Sine:
        return BenchSteps::tr("Sine");
    case BenchAction::Hold:
        return BenchSteps::tr("Hold");
    case BenchAction::Brake:
        return BenchSteps::tr("Brake");
    case BenchAction::Wait:
        return BenchSteps::tr("Wait");
    case BenchAction::Repeat:
        return BenchSteps::tr("Repeat");
    }
    return {};
}

QString titleOf(BenchMotor motor)
{
    switch (motor) {
    case BenchMotor::Motor1:
        return BenchSteps::tr("Motor 1");
    case BenchMotor::Motor2:
        return BenchSteps::tr("Motor 2");
    case BenchMotor::Both:
        return BenchSteps::tr("Both");
    case BenchMotor::Aux:
        return BenchSteps::tr("Aux");
    }
    return {};
}

QString titleOf(BenchCondition condition)
{
    switch (condition) {
    case BenchCondition::CurrentAbove:
        return BenchSteps::tr("Current above");
    case BenchCondition::CurrentBelow:
        return BenchSteps::tr("Current below");
    case BenchCondition::Status:
        return BenchSteps::tr("Status bit");
    case BenchCondition::ChannelAbove:
        return BenchSteps::tr("Channel above");
    case BenchCondition::ChannelBelow:
        return BenchSteps::tr("Channel below");
    case BenchCondition::Time:
        return BenchSteps::tr("Time since start");
    }
    return {};
}

QString textOf(const BenchStep& step)
{
    switch (step.action) {
    case BenchAction::Set:
    case BenchAction::Accelerate:
    case BenchAction::Step:
        return BenchSteps::tr("to %1").arg(step.speed);
    case BenchAction::Ramp:
        return step.from ? BenchSteps::tr("from %1 to %2").arg(*step.from).arg(step.speed)
                         : BenchSteps::tr("to %1").arg(step.speed);
    case BenchAction::Sine:
        return BenchSteps::tr("%1 ± %2, every %3 s")
            .arg(step.speed)
            .arg(step.amplitude)
            .arg(step.period);
    case BenchAction::Hold:
        return {};
    case BenchAction::Brake:
        return BenchSteps::tr("duty %1").arg(step.speed);
    case BenchAction::Wait:
        return conditionText(step);
    case BenchAction::Repeat:
        return BenchSteps::tr("%1 ×").arg(step.times);
    }
    return {};
}

BenchStepModel::BenchStepModel(QObject* parent) : QAbstractTableModel(parent) { }

void BenchStepModel::enlist(const std::vector<BenchStep>& steps, const Path& before)
{
    for (std::size_t i = 0; i < steps.size(); ++i) {
        Path path = before;
        path.push_back(i);
        m_rows.push_back(path);
        enlist(steps[i].steps, path);
    }
}

void BenchStepModel::rebuild()
{
    m_rows.clear();
    enlist(m_steps, {});
}

void BenchStepModel::setSteps(const std::vector<BenchStep>& steps)
{
    beginResetModel();
    m_steps = steps;
    rebuild();
    endResetModel();
}

std::vector<BenchStep>& BenchStepModel::listOf(const Path& path)
{
    std::vector<BenchStep>* list = &m_steps;
    for (std::size_t i = 0; i + 1 < path.size(); ++i) {
        list = &(*list)[path[i]].steps;
    }
    return *list;
}

const BenchStep& BenchStepModel::step(int row) const
{
    const Path& path = m_rows.at(static_cast<std::size_t>(row));
    const std::vector<BenchStep>* list = &m_steps;
    for (std::size_t i = 0; i + 1 < path.size(); ++i) {
        list = &(*list)[path[i]].steps;
    }
    return (*list)[path.back()];
}

int BenchStepModel::rowOf(const Path& path) const
{
    const auto found = std::ranges::find(m_rows, path);
    return found == m_rows.end() ? -1 : static_cast<int>(found - m_rows.begin());
}

void BenchStepModel::replace(int row, const BenchStep& step)
{
    const Path path = m_rows.at(static_cast<std::size_t>(row));
    BenchStep& old = listOf(path)[path.back()];
    const bool repeats = old.action == BenchAction::Repeat && step.action == BenchAction::Repeat;
    BenchStep fresh = step;
    fresh.steps = repeats ? old.steps : std::vector<BenchStep>();
    if (step.action == BenchAction::Repeat && !repeats) {
        fresh.steps.push_back({.action = BenchAction::Hold, .motor = step.motor, .seconds = 1.0});
    }
    if (old == fresh) {
        return;
    }
    const bool isSameShape = old.steps.size() == fresh.steps.size();
    if (isSameShape) {
        old = fresh;
        emit dataChanged(createIndex(row, 0), createIndex(row, ColumnCount - 1));
    } else {
        beginResetModel();
        old = fresh;
        rebuild();
        endResetModel();
    }
    emit edited();
}

int BenchStepModel::insert(int row, const BenchStep& step)
{
    beginResetModel();
    Path path{m_steps.size()};
    if (row >= 0) {
        path = m_rows.at(static_cast<std::size_t>(row));
        ++path.back();
    }
    auto& list = listOf(path);
    list.insert(list.begin() + static_cast<std::ptrdiff_t>(path.back()), step);
    rebuild();
    endResetModel();
    emit edited();
    return rowOf(path);
}

void BenchStepModel::remove(int row)
{
    const Path path = m_rows.at(static_cast<std::size_t>(row));
    if (listOf(path).size() == 1 && path.size() > 1) {
        return; // a repetition of nothing is none: remove the repetition itself
    }
    beginResetModel();
    auto& list = listOf(path);
    list.erase(list.begin() + static_cast<std::ptrdiff_t>(path.back()));
    rebuild();
    endResetModel();
    emit edited();
}

int BenchStepModel::move(int row, int by)
{
    Path path = m_rows.at(static_cast<std::size_t>(row));
    auto& list = listOf(path);
    const auto to = static_cast<std::ptrdiff_t>(path.back()) + by;
    if (to < 0 || to >= std::ssize(list)) {
        return row;
    }
    beginResetModel();
    std::swap(list[path.back()], list[static_cast<std::size_t>(to)]);
    path.back() = static_cast<std::size_t>(to);
    rebuild();
    endResetModel();
    emit edited();
    return rowOf(path);
}

int BenchStepModel::rowCount(const QModelIndex& parent) const
{
    return parent.isValid() ? 0 : static_cast<int>(m_rows.size());
}

int BenchStepModel::columnCount(const QModelIndex& parent) const
{
    return parent.isValid() ? 0 : ColumnCount;
}

QVariant BenchStepModel::data(const QModelIndex& index, int role) const
{
    if (!checkIndex(index, CheckIndexOption::IndexIsValid)) {
        return {};
    }
    const BenchStep& one = step(index.row());
    const Path& path = m_rows.at(static_cast<std::size_t>(index.row()));
    if (role == Qt::TextAlignmentRole && index.column() == TimeColumn) {
        return int(Qt::AlignRight | Qt::AlignVCenter);
    }
    if (role != Qt::DisplayRole) {
        return {};
    }
    switch (index.column()) {
    case NumberColumn: {
        QStringList numbers;
        for (const std::size_t place : path) {
            numbers << QString::number(place + 1);
        }
        return numbers.join(u'.');
    }
    case StepColumn:
        return QString(static_cast<qsizetype>(path.size() - 1) * 3, QChar::Nbsp)
            + titleOf(one.action);
    case MotorColumn:
        return hasMotor(one) ? titleOf(one.motor) : QString();
    case WhatColumn:
        return one.label.isEmpty()  ? textOf(one)
            : textOf(one).isEmpty() ? u"“%1”"_s.arg(one.label)
                                    : u"%1 “%2”"_s.arg(textOf(one), one.label);
    case TimeColumn: {
        const double seconds = plannedSeconds(one);
        return seconds > 0.0 ? tr("%1 s").arg(seconds, 0, 'g', 6) : QString();
    }
    default:
        return {};
    }
}

QVariant BenchStepModel::headerData(int section, Qt::Orientation orientation, int role) const
{
    if (orientation != Qt::Horizontal || role != Qt::DisplayRole) {
        return {};
    }
    switch (section) {
    case NumberColumn:
        return tr("No.");
    case StepColumn:
        return tr("Step");
    case MotorColumn:
        return tr("Motor");
    case WhatColumn:
        return tr("What");
    case TimeColumn:
        return tr("Time");
    default:
        return {};
    }
}

} // namespace trex
