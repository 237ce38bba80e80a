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
    return QStringList{words(row.title), keyText(row), words(row.help), words(row.group)}.join(
        u' ');
}

/// A number is meant as a parameter's number, in decimal or hex; else a word that may stand
/// anywhere.
bool isFound(const ParameterRow& row, const QString& word)
{
    bool isNumber = false;
    const bool isHex = word.startsWith("0x"_L1, Qt::CaseInsensitive);
    const int number = (isHex ? word.mid(2) : word).toInt(&isNumber, isHex ? 16 : 10);
    return (isNumber && number == row.number)
        || (isHex && hexText(row.number).startsWith(word, Qt::CaseInsensitive))
        || searchText(row).contains(word, Qt::CaseInsensitive);
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
    // A window that closes moves the focus once more, when the panel's model is gone already.
    connect(&model, &QObject::destroyed, this, [this] { qApp->disconnect(this); });
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
        connect(field, &ParameterField::remarked, this, &ParameterTable::remarked);
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
        const int margins = m_isCompact ? 8 : 20;
        return fontMetrics().horizontalAdvance(sample) + margins;
    };
    int field = 0;
    for (const auto& [number, each] : m_fields) {
        field = std::max(field, each->sizeHint().width());
    }
    const int sign = 2 * fontMetrics().averageCharWidth() + 8;
    setColumnWidth(ParameterModel::TitleColumn, wide(tr("Auxiliary PWM maximum ≈")) + sign);
    setColumnWidth(ParameterModel::ValueColumn, field + (m_isCompact ? 0 : wide(u"(00)"_s)));
    setColumnWidth(ParameterModel::StateColumn, wide(tr("power cycle")));
    setColumnWidth(ParameterModel::DeviceColumn,
                   wide(m_isCompact ? tr("no channel (0)") : tr("channels 1, 2, 3 (00)")));
    // The last one takes what is left; where that is little, its tool tip has the whole.
    setColumnWidth(ParameterModel::DefaultColumn,
                   wide(m_isCompact ? tr("≈ off (0)") : tr("≈ no channel (0)")));
    setColumnWidth(ParameterModel::RangeColumn, wide(tr("channels 1 to 5")));
    setColumnWidth(ParameterModel::SourceColumn, wide(tr("≈ inferred, quite sure")));
}

/// Where there is no room for all, words get shorter, and range and source go: the help and the
/// tool tips have them, too, and a ≈ stays at what is not sure.
void ParameterTable::resizeEvent(QResizeEvent* event)
{
    const int room = event->size().width();
    constexpr int kRoomForNames = 1380;
    if (const bool isCompact = room < kRoomForNames; isCompact != m_isCompact) {
        m_isCompact = isCompact;
        for (const auto& [number, field] : m_fields) {
            field->setCompact(isCompact);
        }
        setWidths();
    }
    int used = 0;
    for (int column = 0; column < ParameterModel::RangeColumn; ++column) {
        used += columnWidth(column);
    }
    constexpr int kRange = 110;
    constexpr int kSource = 150;
    setColumnHidden(ParameterModel::SourceColumn, room < used + kSource);
    setColumnHidden(ParameterModel::RangeColumn, room < used + kSource + kRange);
    QTreeView::resizeEvent(event);
}

void ParameterTable::search(const QString& text)
{
    m_words = text.split(u' ', Qt::SkipEmptyParts);
    hideAndShow();
}

void ParameterTable::setFilter(ParameterModel::Filter filter)
{
    m_filter = filter;
    hideAndShow();
}

bool ParameterTable::isWanted(const ParameterRow& row) const
{
    // The row that is being typed in stays, whatever its value is on the way.
    const auto found = m_fields.find(row.number);
    const auto* const focus = QApplication::focusWidget();
    const bool isInUse =
        found != m_fields.end() && focus != nullptr && found->second->isAncestorOf(focus);
    return (isInUse || m_model.matches(row.number, m_filter))
        && std::ranges::all_of(m_words, [&row](const QString& word) { return isFound(row, word); });
}

void ParameterTable::hideAndShow()
{
    for (int group = 0; group < m_model.rowCount(); ++group) {
        const QModelIndex parent = m_model.index(group, 0);
        bool isAnyShown = false;
        for (int row = 0; row < m_model.rowCount(parent); ++row) {
            const bool isShown = isWanted(*ParameterModel::rowAt(m_model.index(row, 0, parent)));
            if (isRowHidden(row, parent) == isShown) {
                setRowHidden(row, parent, !isShown);
            }
            isAnyShown = isAnyShown || isShown;
        }
        if (isRowHidden(group, {}) == isAnyShown) {
            setRowHidden(group, {}, !isAnyShown);
        }
    }
    chooseShownRow();
    emit shownRowsChanged();
}

/// The help is on a row that is there to be seen.
void ParameterTable::chooseShownRow()
{
    const auto isShown = [this](const QModelIndex& index) {
        return index.isValid() && !isRowHidden(index.row(), index.parent());
    };
    if (const ParameterRow* row = currentRow();
        row != nullptr && isShown(m_model.indexOf(row->number))) {
        return;
    }
    for (int group = 0; group < m_model.rowCount(); ++group) {
        const QModelIndex parent = m_model.index(group, 0);
        for (int row = 0; row < m_model.rowCount(parent); ++row) {
            if (const QModelIndex index = m_model.index(row, 0, parent); isShown(index)) {
                setCurrentIndex(index);
                return;
            }
        }
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
        found->second->setContext(m_model.context(*findParameter(number)));
        found->second->showRaw(m_model.shown(found->first));
        found->second->setEnabled(m_reason.isEmpty() && m_model.device(found->first).has_value());
    }
    if (m_filter != ParameterModel::Filter::All) {
        hideAndShow();
    }
}

void ParameterTable::onFocusChanged(QWidget* now)
{
    for (const auto& [number, field] : m_fields) {
        if (now != nullptr && field->isAncestorOf(now)) {
            setCurrentIndex(m_model.indexOf(number));
        }
    }
    if (m_filter != ParameterModel::Filter::All) {
        hideAndShow(); // the row that was kept for typing may go now
    }
}

} // namespace trex
