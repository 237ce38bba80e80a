// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/parameters/parameterfield.h"

class QComboBox;

namespace trex {

/// A few named values; a prescaler's say the frequency that they give with the PWM maximum in
/// force. GUI thread.
class ChoiceField : public ParameterField {
    Q_OBJECT
    Q_DISABLE_COPY_MOVE(ChoiceField)

public:
    ChoiceField(const ParameterRow& row, QWidget* parent);
    void setContext(const ValueContext& context) override;

    static QComboBox* newBox(QWidget* parent);
    static void choose(QComboBox* box, int data); ///< by the items' data; −1 shows an en dash

protected:
    void display(std::optional<int> raw) override;

private:
    QComboBox* m_box;
    int m_known = 0;
};

} // namespace trex
