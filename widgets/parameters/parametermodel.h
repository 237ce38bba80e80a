// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "protocol/storage/configfile.h"
#include "protocol/storage/settingsadvice.h"
#include "widgets/parameters/parametervalue.h"

#include <QAbstractItemModel>

#include <set>

namespace trex {

/// Every parameter by group, with three values each: the table's default, what the controller was
/// last read to hold, and what the person made of it. GUI thread.
class ParameterModel : public QAbstractItemModel {
    Q_OBJECT
    Q_DISABLE_COPY_MOVE(ParameterModel)

public:
    enum Column {
        TitleColumn,
        ValueColumn,
        StateColumn,
        DeviceColumn,
        DefaultColumn,
        RangeColumn,
        SourceColumn,
        ColumnCount
    };
    /// What stands out about a row, the most urgent that holds.
    enum class State { AtDefault, Unread, Differs, Advised, Pending, Edited, Refused };
    enum class Filter { All, Changed, NotDefault, PowerCycle };

    explicit ParameterModel(QObject* parent = nullptr);

    [[nodiscard]] static const ParameterRow* rowAt(const QModelIndex& index); ///< null: a group
    [[nodiscard]] QModelIndex indexOf(std::uint8_t number, int column = TitleColumn) const;

    [[nodiscard]] std::optional<int> device(std::uint8_t number) const; ///< none: not read
    [[nodiscard]] std::optional<int> shown(std::uint8_t number) const; ///< edited, else device
    [[nodiscard]] bool isEdited(std::uint8_t number) const; ///< not (known to be) in the controller
    [[nodiscard]] State state(std::uint8_t number) const;
    [[nodiscard]] QString stateText(std::uint8_t number) const; ///< a word, or two
    [[nodiscard]] bool matches(std::uint8_t number, Filter filter) const;
    [[nodiscard]] QStringList advice(std::uint8_t number) const;
    /// Sentences about the row as it is: a refusal, advice, what waits for a power cycle.
    [[nodiscard]] QStringList remarks(std::uint8_t number) const;
    /// What the row's value goes with, as edited.
    [[nodiscard]] ValueContext context(const ParameterRow& row) const;
    [[nodiscard]] ValueContext deviceContext(const ParameterRow& row) const; ///< as read
    [[nodiscard]] Model controllerModel() const { return m_controllerModel; }
    [[nodiscard]] const std::set<std::uint8_t>& pending() const { return m_pending; }
    [[nodiscard]] const ParameterValues& edits() const { return m_edits; }
    [[nodiscard]] ParameterValues
    wanted() const; ///< the controller's values with the edits in them

    /// The one way in for values that a person chose. Errors: OutOfRange, and nothing changes.
    Result<void> edit(std::uint8_t number, int raw);
    void revert();
    void revert(std::uint8_t number); ///< one row only
    void setControllerModel(Model model);
    void setDevice(std::uint8_t number, std::optional<int> raw);
    void setPending(std::uint8_t number, bool pending);
    void setAdvice(const std::vector<Advice>& advice);
    void setRefusal(std::uint8_t number, const QString& sentence);
    void clearRefusals();
    void refreshAll(); ///< colours changed

    QModelIndex index(int row, int column, const QModelIndex& parent = {}) const override;
    QModelIndex parent(const QModelIndex& child) const override;
    int rowCount(const QModelIndex& parent = {}) const override;
    int columnCount(const QModelIndex& parent = {}) const override;
    Qt::ItemFlags flags(const QModelIndex& index) const override;
    QVariant data(const QModelIndex& index, int role) const override;
    bool setData(const QModelIndex& index, const QVariant& value, int role) override;
    QVariant headerData(int section, Qt::Orientation orientation, int role) const override;

signals:
    void shownChanged(int number); ///< shown() or what stands beside it
    void editsChanged();

private:
    /// Internal id of a group's index; a parameter has its group's row + 1.
    static constexpr quintptr kGroupId = 0;
    struct Group {
        const char* title;
        std::vector<const ParameterRow*> rows;
    };
    [[nodiscard]] QString text(const ParameterRow& row, int column) const;
    [[nodiscard]] QString toolTip(const ParameterRow& row) const;
    void rowChanged(std::uint8_t number);
    void rowAndItsPrescalerChanged(std::uint8_t number);

    std::vector<Group> m_groups;
    ParameterValues m_device;
    ParameterValues m_edits;
    std::set<std::uint8_t> m_pending;
    std::map<std::uint8_t, QString> m_refusals;
    std::vector<Advice> m_advice;
    Model m_controllerModel = Model::TrexJr;
};

} // namespace trex
