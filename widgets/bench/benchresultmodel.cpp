// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/bench/benchresultmodel.h"

#include "protocol/procedures/benchreport.h"
#include "widgets/common/theme.h"

#include <QColor>
#include <QLocale>

namespace trex {

using namespace Qt::Literals::StringLiterals;

namespace {

ColourRole roleOf(BenchVerdict verdict)
{
    switch (verdict) {
    case BenchVerdict::Passed:
        return ColourRole::Ok;
    case BenchVerdict::Failed:
        return ColourRole::Fault;
    case BenchVerdict::NotMeasured:
        return ColourRole::Warning;
    case BenchVerdict::NotJudged:
        break;
    }
    return ColourRole::DimText;
}

} // namespace

BenchResultModel::BenchResultModel(QObject* parent) : QAbstractTableModel(parent) { }

void BenchResultModel::setOutcome(const std::optional<BenchOutcome>& outcome)
{
    beginResetModel();
    m_outcome = outcome;
    endResetModel();
}

int BenchResultModel::rowCount(const QModelIndex& parent) const
{
    return parent.isValid() || !m_outcome ? 0 : static_cast<int>(m_outcome->results.size());
}

int BenchResultModel::columnCount(const QModelIndex& parent) const
{
    return parent.isValid() ? 0 : ColumnCount;
}

QVariant BenchResultModel::textOf(const BenchResult& result, int column) const
{
    const auto bound = [](const std::optional<double>& value) {
        return value ? QVariant(*value) : QVariant();
    };
    switch (column) {
    case TitleColumn:
        return result.title;
    case ValueColumn:
        return valueText(result);
    case MinimumColumn:
        return bound(result.expected.minimum);
    case MaximumColumn:
        return bound(result.expected.maximum);
    case VerdictColumn:
        return signOf(result.verdict) + u' ' + trex::textOf(result.verdict);
    default:
        return {};
    }
}

QVariant BenchResultModel::data(const QModelIndex& index, int role) const
{
    if (!checkIndex(index, CheckIndexOption::IndexIsValid)) {
        return {};
    }
    const BenchResult& result = m_outcome->results.at(static_cast<std::size_t>(index.row()));
    const bool isNumber = index.column() >= ValueColumn && index.column() <= MaximumColumn;
    switch (role) {
    case Qt::DisplayRole:
    case Qt::EditRole:
        return textOf(result, index.column());
    case Qt::ToolTipRole:
        return result.note.isEmpty() ? result.key : result.key + u'\n' + result.note;
    case Qt::TextAlignmentRole:
        return int((isNumber ? Qt::AlignRight : Qt::AlignLeft) | Qt::AlignVCenter);
    case Qt::ForegroundRole:
        return index.column() == VerdictColumn ? QVariant(theme::colour(roleOf(result.verdict)))
                                               : QVariant();
    default:
        return {};
    }
}

bool BenchResultModel::setData(const QModelIndex& index, const QVariant& value, int role)
{
    if (role != Qt::EditRole || !checkIndex(index, CheckIndexOption::IndexIsValid)) {
        return false;
    }
    const QString text = value.toString().trimmed();
    bool isNumber = false;
    double number = QLocale().toDouble(text, &isNumber);
    if (!isNumber) {
        number = text.toDouble(&isNumber);
    }
    if (!text.isEmpty() && !isNumber) {
        return false;
    }
    const QString key = m_outcome->results.at(static_cast<std::size_t>(index.row())).key;
    BenchExpectation expectation;
    if (const auto found = m_outcome->profile.expect.find(key);
        found != m_outcome->profile.expect.end()) {
        expectation = found->second;
    }
    auto& bound = index.column() == MinimumColumn ? expectation.minimum : expectation.maximum;
    bound = text.isEmpty() ? std::nullopt : std::optional(number);
    if (expectation.minimum && expectation.maximum && *expectation.minimum > *expectation.maximum) {
        return false;
    }
    if (expectation.minimum || expectation.maximum) {
        m_outcome->profile.expect[key] = expectation;
    } else {
        m_outcome->profile.expect.erase(key);
    }
    judge(*m_outcome);
    emit dataChanged(this->index(index.row(), 0), this->index(index.row(), ColumnCount - 1));
    emit expectationChanged(key, expectation);
    return true;
}

Qt::ItemFlags BenchResultModel::flags(const QModelIndex& index) const
{
    const bool isBound = index.column() == MinimumColumn || index.column() == MaximumColumn;
    return QAbstractTableModel::flags(index) | (isBound ? Qt::ItemIsEditable : Qt::NoItemFlags);
}

QVariant BenchResultModel::headerData(int section, Qt::Orientation orientation, int role) const
{
    if (orientation != Qt::Horizontal) {
        return {};
    }
    const bool isBound = section == MinimumColumn || section == MaximumColumn;
    if (role == Qt::ToolTipRole && isBound) {
        return tr("What you expect, in the result's unit; empty: nothing. It is kept with the "
                  "test.");
    }
    if (role == Qt::TextAlignmentRole) {
        return int((isBound || section == ValueColumn ? Qt::AlignRight : Qt::AlignLeft)
                   | Qt::AlignVCenter);
    }
    if (role != Qt::DisplayRole) {
        return {};
    }
    switch (section) {
    case TitleColumn:
        return tr("Result");
    case ValueColumn:
        return tr("Value");
    case MinimumColumn:
        return tr("At least");
    case MaximumColumn:
        return tr("At most");
    case VerdictColumn:
        return tr("Verdict");
    default:
        return {};
    }
}

} // namespace trex
