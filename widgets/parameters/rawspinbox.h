// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "protocol/codec/parametertable.h"

#include <QSpinBox>

namespace trex {

/// A spin box whose value is the raw number and whose text is the physical one, in its unit (or the
/// CRC polynomial in hex). One step is one raw step. GUI thread.
class RawSpinBox : public QSpinBox {
    Q_OBJECT
    Q_DISABLE_COPY_MOVE(RawSpinBox)

public:
    RawSpinBox(const ParameterRow& row, QWidget* parent);

    void showRaw(std::optional<int> raw); ///< without signals; none: an en dash

protected:
    QString textFromValue(int raw) const override;
    int valueFromText(const QString& text) const override;
    QValidator::State validate(QString& text, int& position) const override;

private:
    [[nodiscard]] std::optional<int> parsed(const QString& text) const;
    const ParameterRow& m_row;
};

} // namespace trex
