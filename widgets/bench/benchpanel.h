// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "protocol/procedures/benchdryrun.h"
#include "protocol/procedures/benchreport.h"
#include "protocol/procedures/benchtest.h"
#include "widgets/bench/benchresultmodel.h"
#include "widgets/bench/benchstepmodel.h"
#include "widgets/common/panel.h"

#include <memory>

class QFrame;
class QLabel;
class QListWidget;
class QProgressBar;
class QPushButton;
class QTableView;
class QTabWidget;
class QToolButton;

namespace trex {

class BenchLimitsForm;
class BenchChart;
class BenchStepForm;

/// Bench tests: chosen, edited, tried on the simulator, run on the motors after one deliberate
/// confirmation, and reported. Nothing moves by choosing, opening or editing. GUI thread.
class BenchPanel : public Panel {
    Q_OBJECT
    Q_DISABLE_COPY_MOVE(BenchPanel)
    /// "idle", "confirm", "running", "dry-run": for scripts
    Q_PROPERTY(QString state READ state)

public:
    explicit BenchPanel(PanelContext& context, QWidget* parent = nullptr);
    ~BenchPanel() override;
    [[nodiscard]] QString state() const;

protected:
    void changeEvent(QEvent* event) override;

private:
    struct Entry {
        BenchProfile profile; ///< with the person's edits
        BenchProfile original; ///< as it was opened
        QString path; ///< empty: a ready one
        std::optional<BenchOutcome> outcome; ///< of the latest run or dry run
        BenchReport report; ///< of that run
        BenchTrace prediction; ///< of the latest dry run
    };
    void buildList(QLayout& layout);
    QWidget* buildPlotTab();
    QWidget* buildStepsTab();
    QWidget* buildResultsTab();
    void buildFooter(QLayout& layout);
    void buildConfirmation(QLayout& layout);
    QPushButton* addButton(QLayout& layout, const QString& name, const QString& text,
                           const QString& icon);
    void connectContext();

    [[nodiscard]] Entry& entry() { return m_entries.at(m_current); }
    [[nodiscard]] const Entry& entry() const { return m_entries.at(m_current); }
    void addEntry(const BenchProfile& profile, const QString& path);
    void choose(int row);
    void showEntry();
    void showOutcome();
    void onEdited(); ///< the profile's steps or limits, by the person
    void readMotorMode(); ///< once a connection: in joint mode there is nothing to measure
    void refresh(); ///< what may be touched now
    void refreshTitles();
    void tell(int severity, const QString& sentence);
    [[nodiscard]] QString motionText() const; ///< which motors will move, and how fast
    [[nodiscard]] QString blockReason() const; ///< empty: it may be started

    void openFile();
    void saveFile();
    void revert();
    void startDryRun();
    void sliceOfDryRun();
    void askToStart();
    void start();
    void cancel();
    void onTick();
    void onFinished(const Result<void>& result);
    void saveReportAs(bool isPdf);
    void saveProposals();
    void addStep();
    void selectStep(int row);

    std::vector<Entry> m_entries;
    std::size_t m_current = 0;
    std::unique_ptr<BenchTest> m_test;
    std::unique_ptr<BenchDryRun> m_dryRun;
    BenchReport m_report; ///< of the test under way
    QTimer m_slice;
    bool m_isConfirming = false;
    QString m_told; ///< what became of the last test or file, until the person goes on
    bool m_isFilling = false;
    BenchStepModel m_steps;
    BenchResultModel m_results;
    QListWidget* m_list;
    QTabWidget* m_tabs;
    QLabel* m_description;
    BenchChart* m_plot;
    QTableView* m_stepTable;
    BenchStepForm* m_stepForm;
    BenchLimitsForm* m_limits;
    QLabel* m_verdict;
    QTableView* m_resultTable;
    QLabel* m_proposals;
    QPushButton* m_saveProposals;
    QPushButton* m_revert;
    QFrame* m_confirmation;
    QLabel* m_confirmText;
    QPushButton* m_confirm;
    QLabel* m_status;
    QProgressBar* m_progress;
    QPushButton* m_dry;
    QPushButton* m_start;
    QPushButton* m_html;
    QPushButton* m_pdf;
};

} // namespace trex
