// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/parameters/parametertable.h"

#include "protocol/errortext.h"
#include "widgets/common/panel.h"
#include "widgets/common/theme.h"
#include "widgets/parameters/parametersign.h"

#include <QApplication>
#include <QHeaderView>
#include <QResizeEvent>
#include <QStyledItemDelegate>

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

/// A name that is cut keeps its end, too: there stands which motor.
class CellDelegate : public QStyledItemDelegate {
public:
    using QStyledItemDelegate::QStyledItemDelegate;

protected:
    void initStyleOption(QStyleOptionViewItem* option, const QModelIndex& index) const override
    {
        QStyledItemDelegate::initStyleOption(option, index);
        if (index.column() == ParameterModel::TitleColumn) {
            option->textElideMode = Qt::ElideMiddle;
        }
    }
};

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
    header()->setStretchLastSection(true);
    header()->setSectionsMovable(false);
    setItemDelegate(new CellDelegate(this));
    measure();
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

void ParameterTable::measure()
{
    using Words = ParameterField::Words;
    for (const auto words : {Words::Whole, Words::Short, Words::Shortest}) {
        int widest = 0;
        for (const auto& [number, field] : m_fields) {
            field->useWords(words);
            widest = std::max(widest, field->widestHint());
        }
        m_fieldWidths[words] = widest;
    }
    m_fieldWords = Words::Shortest;

    constexpr int kMargins = 10;
    constexpr int kHeaderMargins = 4;
    const auto wide = [this](const QString& sample) {
        return fontMetrics().horizontalAdvance(sample) + kMargins;
    };
    const auto header = [&](int column) {
        return kHeaderMargins
            + wide(m_model.headerData(column, Qt::Horizontal, Qt::DisplayRole).toString());
    };
    const auto widest = [&](int column) {
        int width = header(column);
        for (const auto& row : kParameters) {
            width = std::max(width, wide(m_model.indexOf(row.number, column).data().toString()));
        }
        return width;
    };
    const int letter = fontMetrics().averageCharWidth();
    const int sign = 2 * letter + 8;
    const int value = wide(tr("channels 1, 2, 3 (00)"));
    int title = 0; // edited ones are bold
    for (const auto& row : kParameters) {
        const auto text = m_model.indexOf(row.number).data().toString();
        title = std::max(title, QFontMetrics(boldFont()).horizontalAdvance(text) + kMargins);
    }
    title += sign;
    const int sure = widest(ParameterModel::SourceColumn);
    m_needs = {{ParameterModel::TitleColumn, {std::min(title, 22 * letter + sign), title}},
               {ParameterModel::StateColumn, {wide(tr("power cycle")), wide(tr("power cycle"))}},
               {ParameterModel::DeviceColumn, {header(ParameterModel::DeviceColumn), value}},
               {ParameterModel::DefaultColumn, {std::min(value, 12 * letter), value}},
               {ParameterModel::RangeColumn,
                {wide(tr("channels 1 to 5")), widest(ParameterModel::RangeColumn)}},
               {ParameterModel::SourceColumn, {sure, sure}}};
}

/// Where there is no room for all, words get shorter, and first the range goes, then the state's
/// word: its sign stands before the name, and the help and the tool tips have both. Then what is
/// long is cut; its tool tip has the whole.
void ParameterTable::fitColumns(int room)
{
    using Words = ParameterField::Words;
    std::vector<int> shown{ParameterModel::TitleColumn, ParameterModel::DeviceColumn,
                           ParameterModel::DefaultColumn, ParameterModel::SourceColumn};
    const auto needOf = [this](int column) { return m_needs.at(column); };
    const auto comfortable = [&](int column) {
        return (needOf(column).least + needOf(column).wanted) / 2;
    };
    int used = 0;
    for (const int column : shown) {
        used += comfortable(column);
    }
    auto words = Words::Whole;
    for (const auto shorter : {Words::Short, Words::Shortest}) {
        if (used + m_fieldWidths.at(words) > room) {
            words = shorter;
        }
    }
    used += m_fieldWidths.at(words);
    for (const int column : {ParameterModel::StateColumn, ParameterModel::RangeColumn}) {
        const bool hasRoom = used + needOf(column).least <= room
            && (column == ParameterModel::StateColumn || shown.size() > 4);
        setColumnHidden(column, !hasRoom);
        if (hasRoom) {
            used += needOf(column).least;
            shown.push_back(column);
        }
    }
    if (m_fieldWords != words) {
        m_fieldWords = words;
        for (const auto& [number, field] : m_fields) {
            field->useWords(words);
        }
    }
    std::vector<ColumnNeed> needs;
    std::ranges::transform(shown, std::back_inserter(needs), needOf);
    const auto widths = fittedWidths(needs, room - m_fieldWidths.at(words));
    for (std::size_t i = 0; i < shown.size(); ++i) {
        setColumnWidth(shown[i], widths[i]);
    }
    setColumnWidth(ParameterModel::ValueColumn, m_fieldWidths.at(words));
}

void ParameterTable::resizeEvent(QResizeEvent* event)
{
    fitColumns(event->size().width());
    QTreeView::resizeEvent(event);
}

void ParameterTable::changeEvent(QEvent* event)
{
    QTreeView::changeEvent(event);
    if (event->type() == QEvent::FontChange || event->type() == QEvent::StyleChange) {
        measure();
        fitColumns(viewport()->width());
    }
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
