// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "protocol/procedures/watchdogproof.h"
#include "widgets/common/panel.h"

#include <QDialog>

class QComboBox;
class QLabel;
class QProgressBar;
class QPushButton;
class QSpinBox;

namespace trex {

/// Lets a person try on purpose whether the controller stops when it hears nothing: which motor,
/// how fast, Start, and the verdict. Not modal, with a STOP of its own; closing it ends the proof
/// in a stop. GUI thread.
class WatchdogDialog : public QDialog {
    Q_OBJECT
    Q_DISABLE_COPY_MOVE(WatchdogDialog)

public:
    explicit WatchdogDialog(PanelContext& context, QWidget* parent = nullptr);
    ~WatchdogDialog() override;

private:
    void makeParts();
    void refresh();
    void fit();
    void onStart();
    void onFinished(const Result<void>& result);

    PanelContext& m_context;
    std::unique_ptr<WatchdogProof> m_proof;
    QComboBox* m_motor = nullptr;
    QSpinBox* m_speed = nullptr;
    QLabel* m_text = nullptr;
    QLabel* m_result = nullptr;
    QProgressBar* m_progress = nullptr;
    QPushButton* m_start = nullptr;
};

} // namespace trex
