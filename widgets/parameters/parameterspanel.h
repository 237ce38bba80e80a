// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "protocol/procedures/configtransfer.h"
#include "widgets/common/panel.h"
#include "widgets/common/theme.h"
#include "widgets/parameters/parametermodel.h"

#include <functional>

class QAction;
class QComboBox;
class QLabel;
class QLineEdit;
class QMenu;
class QProgressBar;
class QPushButton;
class QScrollArea;
class QSplitter;

namespace trex {

class ParameterTable;
class RestartLine;

/// Every configuration parameter, read when connected, edited here, written when asked: only what
/// differs, each read back; at the first failure it stops, and what was written can be put back.
/// GUI thread.
class ParametersPanel : public Panel {
    Q_OBJECT
    Q_DISABLE_COPY_MOVE(ParametersPanel)

public:
    explicit ParametersPanel(PanelContext& context, QWidget* parent = nullptr);
    ~ParametersPanel() override;

protected:
    void showEvent(QShowEvent* event) override;
    void hideEvent(QHideEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;
    void changeEvent(QEvent* event) override;

private:
    void buildTools();
    void buildMore();
    void buildTable();
    void buildFooter();
    void connectContext();

    void onStateChanged(LinkState state);
    void onForgotten();
    void onRestarted();
    void onDeviceValue(int number);
    void readAll();
    void onRead(const Result<Configuration>& read);
    void refresh(); ///< what may be touched, and why not
    void refreshHelp();
    [[nodiscard]] QString blockReason() const; ///< empty: values may be changed
    [[nodiscard]] QString bannerText() const;
    [[nodiscard]] TransferPlan plan() const;
    void colourMessage();
    static void colourText(QLabel* label, ColourRole role);
    void fitPending();
    void tell(int severity, const QString& sentence); ///< here and in the log

    void apply();
    void writePlan();
    [[nodiscard]] bool backUp(); ///< false: could not be written, and told
    /// As backUp(), anew each time. Returns the path.
    [[nodiscard]] Result<QString> backUpNow();
    void onFinished(const TransferOutcome& outcome);
    void offerToPutBack(const std::vector<SettingWrite>& written); ///< nothing: takes it back
    void putBack();
    void revert();
    void fillDefaults();
    void askFactoryReset();
    void factoryReset();
    void onFactoryReset(const Result<void>& reset, const QString& backup);
    void save();
    void saveTo(const QString& path);
    void load();
    void loadFrom(const QString& path);
    void takeCalibrations(std::map<InputKind, std::map<int, Calibration>> calibrations);
    void showDifferences(const QString& fileName, const QStringList& remarks);
    void takeDifference(const SettingWrite& difference, bool isTaken);
    void closeDifferences();
    void keepDraft(); ///< for a panel that is made in this one's place
    void takeDraft();

    ParameterModel m_model;
    ConfigTransfer m_transfer;
    std::map<InputKind, std::map<int, Calibration>> m_calibrations; ///< from a file, to be written
    std::vector<SettingWrite> m_toPutBack; ///< written before a failure, and offered
    Configuration m_draft; ///< edits as last kept
    QLineEdit* m_search;
    QComboBox* m_filter;
    QLabel* m_noRows;
    QMenu* m_more;
    QAction* m_factoryReset;
    QPushButton* m_reload;
    QPushButton* m_defaults;
    QPushButton* m_load;
    QPushButton* m_save;
    RestartLine* m_restart;
    QLabel* m_banner;
    QLabel* m_message;
    QSplitter* m_splitter;
    ParameterTable* m_table;
    QLabel* m_help;
    QLabel* m_pending;
    QScrollArea* m_pendingArea;
    QProgressBar* m_progress;
    QPushButton* m_cancel;
    QPushButton* m_rollback;
    QPushButton* m_keep;
    QPushButton* m_revert;
    QPushButton* m_apply;
    int m_severity = 0; ///< of the message
    QString m_afterPowerCycle; ///< what to tell then, when the message asks for one; else empty
    QStringList m_waited; ///< titles of what waited for a power cycle, when all was forgotten last
    bool m_isLost = false;
    bool m_isBack = false; ///< just now, after the line was lost
    bool m_isWriting = false;
    bool m_isBackedUp = false; ///< in this connection
    bool m_mayGoWithoutBackup = false; ///< the person was told and asks again
    bool m_isInDoubt = false; ///< the line was lost while writing: to be read back
    std::function<void()> m_afterRead; ///< what waits for everything to be read
    bool m_readsAgain = false; ///< asked for while busy
};

} // namespace trex
