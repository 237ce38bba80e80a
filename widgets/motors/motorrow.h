// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "protocol/codec/quantities.h"

#include <QWidget>

class QLabel;
class QPushButton;
class QSpinBox;

namespace trex {

class HoldButton;
class MotorSlider;

/// One motor: title, slider, commanded speed raw and in percent, zero, and a brake with its duty.
class MotorRow : public QWidget {
    Q_OBJECT

public:
    MotorRow(MotorId motor, const QString& title, const QString& namePrefix,
             QWidget* parent = nullptr);

    [[nodiscard]] int speed() const;
    void setSpeed(int speed); ///< shown, not reported
    void setBraking(int duty); ///< shown in place of the speed until the next order
    void setReached(int speed); ///< marked on the slider while a ramp runs
    void setUsable(bool usable);
    void setLimit(int maximum, int step); ///< the slider's ends, and its largest step
    /// Hold to run: the slider springs back, and buttons run it at this speed while they are held.
    void setHold(bool holds, int speed);

signals:
    void speedWanted(int speed);
    void brakeWanted(int duty);

private:
    void showSpeed(int speed);
    [[nodiscard]] QWidget* makeHolds(MotorId motor, const QString& title, const QString& prefix);
    MotorSlider* m_slider;
    QLabel* m_value;
    QPushButton* m_zero;
    QList<HoldButton*> m_holds; ///< shown with hold to run; reverse is none for the auxiliary motor
    int m_holdSpeed = 0;
    QPushButton* m_brake = nullptr; ///< none for the auxiliary motor: it has no brake
    QSpinBox* m_duty = nullptr;
};

} // namespace trex
