// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/parameters/parametervalue.h"

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
    void setModel(Model model); ///< amperes are counted in its steps
    void fixup(QString& text) const override; ///< says why the text is not taken

signals:
    /// A sentence: why what was typed is not taken, or how it was understood.
    void remarked(const QString& sentence) const;

protected:
    QString textFromValue(int raw) const override;
    int valueFromText(const QString& text) const override;
    QValidator::State validate(QString& text, int& position) const override;

private:
    void usePhysicalUnit();
    void onEditingFinished();
    /// What the person typed: the unit that always stands behind it does not count.
    [[nodiscard]] QString typedIn(const QString& text) const;
    [[nodiscard]] std::optional<int> parsedPolynomial(const QString& text) const; ///< as typed
    [[nodiscard]] std::optional<double> parsedPhysical(const QString& text) const;
    [[nodiscard]] std::optional<int> parsed(const QString& text) const; ///< raw
    [[nodiscard]] bool isPolynomial() const { return m_row.editor == ParameterEditor::Polynomial; }

    const ParameterRow& m_row;
    DisplayUnit m_unit;
    QString m_typed; ///< by the person, not yet finished
    std::optional<int> m_before; ///< the value when the typing began
};

} // namespace trex
