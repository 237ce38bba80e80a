// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/parameters/parametertable.h"

#include "protocol/errortext.h"
#include "widgets/common/panel.h"
#include "widgets/common/theme.h"
#include "widgets/parameters/parameterfield.h"

#include <QApplication>
#include <QHeaderView>
#include <QResizeEvent>

#include <algorithm>

using namespace Qt::Literals::StringLiterals;

namespace trex {
namespace {

/// Everything a person may search a parameter by.
QString searchText(const ParameterRow& row)
{
    const auto words = [](const char* text) {
        return QCoreApplication::translate("Parameters", text);
    };
    return u"%1 %2 0x%3 %4 %5 %6"_s.arg(
        words(row.title), keyText(row), u"%1"_s.arg(row.number, 2, 16, QLatin1Char('0')),
        QString::number(row.number), words(row.help), words(row.group));
}

bool holdsAll(const QString& text, const QStringList& words)
{
    return std::ranges::all_of(
        words, [&](const QString& word) { return text.contains(word, Qt::CaseInsensitive); });
}

} // namespace

ParameterTable::ParameterTable(ParameterModel& model, QWidget* parent)
    : QTreeView(parent), m_model(model)
{
    setModel(&model);
    setRootIsDecorated(false);
    setItemsExpandable(false);
    setIndentation(0);
    setAllColumnsShowFocus(true);
    setSelectionBehavior(QAbstractItemView::SelectRows);
    setEditTriggers(QAbstractItemView::NoEditTriggers);
    setVerticalScrollMode(QAbstractItemView::ScrollPerPixel);
    setHorizontalScrollMode(QAbstractItemView::ScrollPerPixel);
    setTextElideMode(Qt::ElideRight);
    setFrameShape(QFrame::NoFrame);
    expandAll();
    for (int group = 0; group < model.rowCount(); ++group) {
        setFirstColumnSpanned(group, {}, true);
    }
    addFields();
    usePalette();
    setWidths();
    connect(&model, &ParameterModel::shownChanged, this, &ParameterTable::onShownChanged);
    connect(qApp, &QApplication::focusChanged, this,
            [this](QWidget* /*old*/, QWidget* now) { onFocusChanged(now); });
}

/// A quiet selection: the editors stand on it.
void ParameterTable::usePalette()
{
    QPalette quiet = QApplication::palette(this);
    for (const auto group : {QPalette::Active, QPalette::Inactive, QPalette::Disabled}) {
        quiet.setColor(group, QPalette::Highlight, theme::colour(ColourRole::Grid));
        quiet.setColor(group, QPalette::HighlightedText, theme::colour(ColourRole::Text));
    }
    viewport()->setPalette(quiet);
    setPalette(quiet);
    // The editors inside keep the usual one, whose selected text has to stand out.
    for (const auto& [number, field] : m_fields) {
        field->setPalette(QApplication::palette(field));
    }
}

void ParameterTable::addFields()
{
    for (const auto& row : kParameters) {
        const QModelIndex index = m_model.indexOf(row.number, ParameterModel::ValueColumn);
        if (!index.isValid()) {
            continue;
        }
        auto* const field = named(ParameterField::make(row, viewport()),
                                  u"parameters.%1.editor"_s.arg(keyText(row)),
                                  QCoreApplication::translate("Parameters", row.title));
        field->setEnabled(false);
        m_fields[row.number] = field;
        setIndexWidget(index, field);
        connect(field, &ParameterField::edited, this, [this, field, &row](int raw) {
            if (const auto done = m_model.edit(row.number, raw); !done) {
                field->showRaw(m_model.shown(row.number));
                emit editRejected(row.number, errorText(done.error()));
            }
        });
    }
}

void ParameterTable::setWidths()
{
    header()->setStretchLastSection(true);
    header()->setSectionsMovable(false);
    const auto wide = [this](const QString& sample) {
        constexpr int kMargins = 20;
        return fontMetrics().horizontalAdvance(sample) + kMargins;
    };
    int field = 0;
    for (const auto& [number, each] : m_fields) {
        field = std::max(field, each->sizeHint().width());
    }
    setColumnWidth(ParameterModel::TitleColumn, wide(tr("Auxiliary motor PWM maximum")) + 24);
    setColumnWidth(ParameterModel::ValueColumn, field + wide(u"(00)"_s)); // raw stands beside
    setColumnWidth(ParameterModel::StateColumn, wide(tr("power cycle")));
    setColumnWidth(ParameterModel::DeviceColumn, wide(tr("channels 1, 2, 3 (00)")));
    setColumnWidth(ParameterModel::DefaultColumn, wide(tr("≈ no channel (0)")));
    setColumnWidth(ParameterModel::RangeColumn, wide(tr("channels 1 to 5")));
}

void ParameterTable::resizeEvent(QResizeEvent* event)
{
    // Where there is no room for all, the range goes: the help has it, too.
    int others = 0;
    for (int column = 0; column < ParameterModel::RangeColumn; ++column) {
        others += columnWidth(column);
    }
    constexpr int kRange = 110;
    setColumnHidden(ParameterModel::RangeColumn, event->size().width() < others + kRange);
    QTreeView::resizeEvent(event);
}

void ParameterTable::search(const QString& text)
{
    const auto words = text.split(u' ', Qt::SkipEmptyParts);
    for (int group = 0; group < m_model.rowCount(); ++group) {
        const QModelIndex parent = m_model.index(group, 0);
        bool isAnyShown = false;
        for (int row = 0; row < m_model.rowCount(parent); ++row) {
            const auto* const parameter = ParameterModel::rowAt(m_model.index(row, 0, parent));
            const bool isShown = holdsAll(searchText(*parameter), words);
            setRowHidden(row, parent, !isShown);
            isAnyShown = isAnyShown || isShown;
        }
        setRowHidden(group, {}, !isAnyShown);
    }
}

int ParameterTable::shownRows() const
{
    return static_cast<int>(std::ranges::count_if(kParameters, [this](const ParameterRow& row) {
        const QModelIndex index = m_model.indexOf(row.number);
        return index.isValid() && !isRowHidden(index.row(), index.parent());
    }));
}

void ParameterTable::setEditable(const QString& reason)
{
    m_reason = reason;
    for (const auto& [number, field] : m_fields) {
        const bool isRead = m_model.device(number).has_value();
        field->setEnabled(reason.isEmpty() && isRead);
        field->setToolTip(reason.isEmpty() && !isRead
                              ? tr("This controller did not tell its value of this parameter.")
                              : reason);
    }
}

const ParameterRow* ParameterTable::currentRow() const
{
    return ParameterModel::rowAt(currentIndex());
}

void ParameterTable::currentChanged(const QModelIndex& current, const QModelIndex& previous)
{
    QTreeView::currentChanged(current, previous);
    emit rowChosen();
}

void ParameterTable::onShownChanged(int number)
{
    const auto found = m_fields.find(static_cast<std::uint8_t>(number));
    if (found != m_fields.end()) {
        found->second->showRaw(m_model.shown(found->first));
        found->second->setEnabled(m_reason.isEmpty() && m_model.device(found->first).has_value());
    }
}

void ParameterTable::onFocusChanged(QWidget* now)
{
    for (const auto& [number, field] : m_fields) {
        if (now != nullptr && field->isAncestorOf(now)) {
            setCurrentIndex(m_model.indexOf(number));
        }
    }
}

} // namespace trex
