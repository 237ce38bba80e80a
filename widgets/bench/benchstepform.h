// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "protocol/storage/benchprofile.h"

#include <QWidget>

class QCheckBox;
class QComboBox;
class QDoubleSpinBox;
class QFormLayout;
class QLineEdit;
class QSpinBox;

namespace trex {

/// One step of a bench test, to be edited; shows the fields that its kind has. GUI thread.
class BenchStepForm : public QWidget {
    Q_OBJECT
    Q_DISABLE_COPY_MOVE(BenchStepForm)

public:
    explicit BenchStepForm(QWidget* parent = nullptr);
    void setStep(const BenchStep& step);

signals:
    void edited(const trex::BenchStep& step); ///< by the person

private:
    QSpinBox* addSpeed(const QString& name, const QString& title, int minimum);
    QDoubleSpinBox* addNumber(const QString& name, const QString& title, const QString& unit,
                              double minimum, double maximum, int decimals);
    void addChoices();
    void showFields();
    void take(); ///< from the fields, and tells

    BenchStep m_step;
    bool m_isFilling = false;
    QFormLayout* m_form;
    QComboBox* m_action;
    QComboBox* m_motor;
    QSpinBox* m_from;
    QSpinBox* m_speed;
    QSpinBox* m_duty;
    QSpinBox* m_amplitude;
    QDoubleSpinBox* m_period;
    QComboBox* m_condition;
    QComboBox* m_bit;
    QSpinBox* m_channel;
    QDoubleSpinBox* m_threshold;
    QDoubleSpinBox* m_seconds;
    QSpinBox* m_times;
    QCheckBox* m_mustHappen;
    QDoubleSpinBox* m_amperes;
    QLineEdit* m_label;
};

} // namespace trex
