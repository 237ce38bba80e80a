// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/parameters/parameterfield.h"

class QComboBox;

namespace trex {

/// Parameter 0x7E, composed of its three parts, with the byte that they make (facts.md 2.3). GUI
/// thread.
class UartField : public ParameterField {
    Q_OBJECT
    Q_DISABLE_COPY_MOVE(UartField)

public:
    UartField(const ParameterRow& row, QWidget* parent);

protected:
    void display(std::optional<int> raw) override;
    void setWords(Words words) override;
    [[nodiscard]] QString storedText(int raw) const override;

private:
    void onActivated();

    QComboBox* m_baud;
    QComboBox* m_detection;
    QComboBox* m_stopBits;
};

} // namespace trex
