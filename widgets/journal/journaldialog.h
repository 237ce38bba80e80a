// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "protocol/procedures/writeaudit.h"
#include "widgets/journal/checkpointmodel.h"
#include "widgets/journal/journalmodel.h"

#include <QDialog>
#include <QSortFilterProxyModel>

class QBoxLayout;
class QComboBox;
class QLabel;
class QLineEdit;
class QPlainTextEdit;
class QPushButton;
class QTableView;
class QTabWidget;

namespace trex {

struct PanelContext;

/// Every write that went through us and every configuration that was kept, and the way back to any
/// of them: first the list of what would be written, then the writing, each value read back. Not
/// modal, with a STOP of its own. GUI thread.
class JournalDialog : public QDialog {
    Q_OBJECT
    Q_DISABLE_COPY_MOVE(JournalDialog)

public:
    /// `context.audit` must be there.
    explicit JournalDialog(PanelContext& context, QWidget* parent = nullptr);
    /// The dialog of that window, made when there is none yet, in front.
    static void bringForward(PanelContext& context, QWidget* window);

protected:
    void changeEvent(QEvent* event) override;

private:
    void buildTop(QBoxLayout& layout);
    [[nodiscard]] QWidget* newWritesPage();
    [[nodiscard]] QWidget* newCheckpointsPage();
    void buildPlan(QBoxLayout& layout);
    void connectContext();

    void reload();
    void refresh(); ///< what may be touched, and why not
    [[nodiscard]] QString blockReason() const; ///< empty: the controller can be written
    [[nodiscard]] const JournalEntry* chosenEntry() const;
    [[nodiscard]] const Checkpoint* chosenCheckpoint() const;
    [[nodiscard]] bool isHere(const ControllerIdentity& controller) const;

    void planRevert();
    void planRestore();
    void readThenPlan(std::function<Result<TransferPlan>()> make, const QString& title);
    void onRead(const Result<Configuration>& read);
    void showPlan(const TransferPlan& plan);
    void dropPlan();
    void write();
    void onFinished(const TransferOutcome& outcome);
    void saveCheckpoint();
    void removeCheckpoint();
    void exportCheckpoint();
    void tell(int severity, const QString& sentence, bool alsoLog = true);

    PanelContext& m_context;
    WriteAudit& m_audit;
    ConfigTransfer m_transfer;
    JournalModel m_entries;
    CheckpointModel m_checkpoints;
    QSortFilterProxyModel m_shown; ///< entries that the search leaves
    std::function<Result<TransferPlan>()> m_makePlan; ///< when everything is read
    TransferPlan m_plan;
    QTabWidget* m_tabs;
    QComboBox* m_which;
    QLineEdit* m_search;
    QTableView* m_table;
    QTableView* m_checkpointTable;
    QPushButton* m_revert;
    QLineEdit* m_name;
    QPushButton* m_save;
    QPushButton* m_restore;
    QPushButton* m_remove;
    QPushButton* m_export;
    QWidget* m_planBox;
    QLabel* m_planTitle;
    QPlainTextEdit* m_planText;
    QPushButton* m_write;
    QLabel* m_reason;
    QLabel* m_message = nullptr;
    int m_severity = 0; ///< of the message
};

} // namespace trex
