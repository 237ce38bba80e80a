// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "protocol/storage/benchprofile.h"

#include <QWidget>

class QCheckBox;
class QDoubleSpinBox;
class QFormLayout;
class QLineEdit;
class QSpinBox;

namespace trex {

/// Name, limits and facts of a bench test, to be edited. GUI thread.
class BenchLimitsForm : public QWidget {
    Q_OBJECT
    Q_DISABLE_COPY_MOVE(BenchLimitsForm)

public:
    explicit BenchLimitsForm(QWidget* parent = nullptr);
    void show(const BenchProfile& profile);
    /// The profile with what stands in the fields.
    [[nodiscard]] BenchProfile applied(BenchProfile profile) const;

signals:
    void edited(); ///< by the person

private:
    QDoubleSpinBox* add(const QString& name, const QString& title, const QString& unit,
                        double maximum, const QString& none, const QString& help);
    void tell();

    bool m_isFilling = false;
    QFormLayout* m_form;
    QLineEdit* m_name;
    QDoubleSpinBox* m_amperes;
    QDoubleSpinBox* m_forSeconds;
    QDoubleSpinBox* m_ampereSeconds;
    QDoubleSpinBox* m_seconds;
    QDoubleSpinBox* m_stale;
    QSpinBox* m_linkErrors;
    QCheckBox* m_overCurrent;
    QDoubleSpinBox* m_volts;
};

} // namespace trex
