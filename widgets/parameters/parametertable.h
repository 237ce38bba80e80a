// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/parameters/columnfit.h"
#include "widgets/parameters/parameterfield.h"
#include "widgets/parameters/parametermodel.h"

#include <QTreeView>

namespace trex {

/// The parameters by group, an editor always open in each row. Rows are hidden by a search, never
/// taken away, so that every editor can be found at any time. GUI thread.
class ParameterTable : public QTreeView {
    Q_OBJECT
    Q_DISABLE_COPY_MOVE(ParameterTable)

public:
    explicit ParameterTable(ParameterModel& model, QWidget* parent = nullptr);

    /// Shows the rows whose name, key, number (7, 0x07), help or group holds every word of `text`.
    void search(const QString& text);
    /// Of these, only the rows that the filter is for, as they are now and as they become.
    void setFilter(ParameterModel::Filter filter);
    [[nodiscard]] int shownRows() const; ///< parameters that search and filter leave
    /// Rows that were read can be edited when `reason` is empty; else it is every editor's tool
    /// tip.
    void setEditable(const QString& reason);
    [[nodiscard]] const ParameterRow* currentRow() const; ///< null: none
    void usePalette(); ///< of the theme in force

signals:
    void rowChosen(); ///< currentRow() changed
    void shownRowsChanged();
    /// A value that the model does not take, with the sentence for the person.
    void editRejected(int number, const QString& sentence);
    void remarked(const QString& sentence); ///< about what was typed

protected:
    void currentChanged(const QModelIndex& current, const QModelIndex& previous) override;
    void resizeEvent(QResizeEvent* event) override;
    void changeEvent(QEvent* event) override;

private:
    void addFields();
    void hideAndShow();
    void chooseShownRow();
    [[nodiscard]] bool isWanted(const ParameterRow& row) const;
    void measure(); ///< what the columns need, with the font in force
    void fitColumns(int room);
    void onShownChanged(int number);
    void onFocusChanged(QWidget* now);

    ParameterModel& m_model;
    std::map<std::uint8_t, ParameterField*> m_fields;
    QString m_reason;
    QStringList m_words; ///< searched
    ParameterModel::Filter m_filter = ParameterModel::Filter::All;
    std::map<ParameterField::Words, int> m_fieldWidths; ///< of the widest editor
    std::map<int, ColumnNeed> m_needs; ///< of each column but the editors'
    std::optional<ParameterField::Words> m_fieldWords; ///< as the editors have them
};

} // namespace trex
