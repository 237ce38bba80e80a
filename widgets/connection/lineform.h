// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "protocol/codec/linesettings.h"

#include <QWidget>

class QComboBox;
class QFormLayout;
class QSpinBox;

namespace trex {

/// The fields that say how the line is set: speed, error detection, packet form and, in a second
/// group, what hardly ever changes. Always holds settings that are in range. GUI thread.
class LineForm : public QWidget {
    Q_OBJECT
    Q_DISABLE_COPY_MOVE(LineForm)

public:
    explicit LineForm(QWidget* parent = nullptr);

    [[nodiscard]] LineSettings settings() const;
    void setSettings(const LineSettings& settings);

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    void addMainFields(QFormLayout& form);
    void addRareFields(QFormLayout& form);
    QComboBox* addCombo(QFormLayout& form, const QString& title, const QString& name);
    QSpinBox* addSpin(QFormLayout& form, const QString& title, const QString& name, int minimum,
                      int maximum);
    void addRow(QFormLayout& form, const QString& title, QWidget* field);
    void updateEnabled();

    QComboBox* m_baud = nullptr;
    QComboBox* m_errorDetection = nullptr;
    QComboBox* m_form = nullptr;
    QSpinBox* m_device = nullptr;
    QComboBox* m_stopBits = nullptr;
    QSpinBox* m_polynomial = nullptr;
    QComboBox* m_echo = nullptr;
    QSpinBox* m_timeout = nullptr;
};

} // namespace trex
