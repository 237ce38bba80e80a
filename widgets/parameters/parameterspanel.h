// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "protocol/procedures/configtransfer.h"
#include "widgets/common/panel.h"
#include "widgets/common/theme.h"
#include "widgets/parameters/parametermodel.h"

class QLabel;
class QLineEdit;
class QProgressBar;
class QPushButton;
class QScrollArea;
class QSplitter;

namespace trex {

class ParameterTable;

/// Every configuration parameter, read when connected, edited here, written when asked: only what
/// differs, each read back, all or nothing. GUI thread.
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
    void buildTable();
    void buildFooter();
    void connectContext();

    void onStateChanged(LinkState state);
    void onForgotten();
    void onDeviceValue(int number);
    void readAll();
    void onRead(const Result<Configuration>& read);
    void refresh(); ///< what may be touched, and why not
    void refreshHelp();
    [[nodiscard]] QString blockReason() const; ///< empty: values may be changed
    [[nodiscard]] QString bannerText() const;
    [[nodiscard]] QString pendingText(const TransferPlan& plan) const;
    [[nodiscard]] TransferPlan plan() const;
    void colourMessage();
    static void colourText(QLabel* label, ColourRole role);
    void fitPending();
    void tell(int severity, const QString& sentence); ///< here and in the log

    void apply();
    void writePlan();
    [[nodiscard]] bool backUp(); ///< false: could not be written, and told
    void onFinished(const TransferOutcome& outcome);
    void revert();
    void fillDefaults();
    void save();
    void saveTo(const QString& path);
    void load();
    void loadFrom(const QString& path);

    ParameterModel m_model;
    ConfigTransfer m_transfer;
    std::map<InputKind, std::map<int, Calibration>> m_calibrations; ///< from a file, to be written
    QLineEdit* m_search;
    QPushButton* m_reload;
    QPushButton* m_defaults;
    QPushButton* m_load;
    QPushButton* m_save;
    QLabel* m_banner;
    QLabel* m_message;
    QSplitter* m_splitter;
    ParameterTable* m_table;
    QLabel* m_help;
    QLabel* m_pending;
    QScrollArea* m_pendingArea;
    QProgressBar* m_progress;
    QPushButton* m_cancel;
    QPushButton* m_revert;
    QPushButton* m_apply;
    int m_severity = 0; ///< of the message
    bool m_isWriting = false;
    bool m_isBackedUp = false; ///< in this connection
    bool m_mayGoWithoutBackup = false; ///< the person was told and asks again
    bool m_appliesAfterRead = false;
    bool m_readsAgain = false; ///< asked for while busy
};

} // namespace trex
