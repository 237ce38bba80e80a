// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "protocol/procedures/channelcalibration.h"

#include <QWidget>

#include <array>
#include <vector>

class QBoxLayout;
class QCheckBox;
class QGridLayout;
class QLabel;
class QProgressBar;
class QPushButton;
class QScrollArea;

namespace trex {

class CalibrationRow;
class CurveBox;
class StateMark;
class TelemetryStore;

/// The view of a guided calibration: what to do, five live channels, and Back, Next, Cancel. All
/// rules are in ChannelCalibration. GUI thread.
class CalibrationWizard : public QWidget {
    Q_OBJECT
    Q_DISABLE_COPY_MOVE(CalibrationWizard)
    Q_PROPERTY(QString page READ page)

public:
    CalibrationWizard(ChannelCalibration& calibration, const TelemetryStore& store,
                      QWidget* parent = nullptr);
    [[nodiscard]] QString page() const;

    void setHistoryOffered(bool offered);
    void refresh(); ///< pulls what is new; called at frame rate

signals:
    void historyAsked();

protected:
    void resizeEvent(QResizeEvent* event) override;
    void changeEvent(QEvent* event) override;

private:
    [[nodiscard]] QWidget* makeChannels();
    void addRow(int channel, QWidget* inside);
    [[nodiscard]] QWidget* makeButtons();
    void placeCurve();
    void showNotice();
    void applyTheme();
    void applyStep();
    void showSteps();
    void showButtons();
    [[nodiscard]] std::optional<int> freshReading(int channel) const;

    ChannelCalibration& m_calibration;
    const TelemetryStore& m_store;
    QLabel* m_steps;
    QLabel* m_instruction;
    StateMark* m_noticeMark;
    QLabel* m_notice;
    QCheckBox* m_motorPowerOff;
    QProgressBar* m_countdown;
    QBoxLayout* m_content = nullptr; ///< the channels, and the curve beside or below them
    QScrollArea* m_scroll = nullptr;
    CurveBox* m_curve;
    QPushButton* m_curveShown = nullptr;
    std::optional<bool> m_isCurveWanted; ///< none: where there is room
    QGridLayout* m_grid = nullptr;
    std::vector<QLabel*> m_headers;
    std::array<CalibrationRow*, kChannelCount> m_rows{};
    QLabel* m_reason = nullptr;
    QPushButton* m_back = nullptr;
    QPushButton* m_next = nullptr;
    QPushButton* m_cancel = nullptr;
    QPushButton* m_undo = nullptr;
    QPushButton* m_history = nullptr;
};

} // namespace trex
