// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "protocol/session/controller.h"
#include "widgets/common/panel.h"

#include <QTimer>

#include <array>

class QCheckBox;
class QComboBox;
class QLabel;
class QPushButton;

namespace trex {

class DrivePad;
class Gamepad;
class MotorRow;

/// Drives the motors. Disarmed at start; arming is one deliberate act, and every way out of it
/// stops all three motors. GUI thread.
class MotorsPanel : public Panel {
    Q_OBJECT

public:
    explicit MotorsPanel(PanelContext& context, QWidget* parent = nullptr);

private:
    void makeControls();
    void makeOptions();
    void makePad();
    void makeRows();
    void listen();
    void onArmClicked(bool wanted);
    void onSpeed(MotorId motor, int speed);
    void onBrake(MotorId motor, int duty);
    void onPad(int forward, int turn);
    void onPadShown(bool shown);
    void refreshGamepad();
    void followSettings();
    void openSafety();
    void openProof();
    void refresh();
    void refreshHint();
    void showOrders();
    void report(const Result<void>& result);
    [[nodiscard]] MotorOrder orderFor(int speed) const;
    [[nodiscard]] bool isJoint() const;
    [[nodiscard]] MotorRow& row(MotorId motor) const;

    QPushButton* m_arm = nullptr;
    QComboBox* m_mode = nullptr;
    QCheckBox* m_link = nullptr;
    QCheckBox* m_hold = nullptr;
    QPushButton* m_padShown = nullptr;
    DrivePad* m_pad = nullptr;
    Gamepad* m_gamepad = nullptr;
    QLabel* m_gamepadText = nullptr;
    QLabel* m_hint = nullptr;
    std::array<MotorRow*, 3> m_rows{};
    QTimer m_lockout; ///< arming is refused just after a stop
};

} // namespace trex
