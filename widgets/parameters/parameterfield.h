// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/parameters/parametervalue.h"

#include <QWidget>

#include <memory>

class QLabel;

namespace trex {

/// The editor of one parameter, in the form that fits its meaning. What a person does and what is
/// written to `raw` take the same path: edited(), and whoever listens decides and shows the result
/// with showRaw(). GUI thread.
class ParameterField : public QWidget {
    Q_OBJECT
    Q_DISABLE_COPY_MOVE(ParameterField)
    Q_PROPERTY(int raw READ raw WRITE setRaw NOTIFY rawChanged)

public:
    static ParameterField* make(const ParameterRow& row, QWidget* parent);

    [[nodiscard]] int raw() const { return m_raw; } ///< −1: not known
    void setRaw(int raw) { emit edited(raw); }
    void showRaw(std::optional<int> raw); ///< without edited(); none: an en dash
    /// What the value's text depends on beside it.
    virtual void setContext(const ValueContext& /*context*/) { }
    /// How much the words beside the controls may say, where there is less and less room.
    enum class Words : std::uint8_t { Whole, Short, Shortest };
    void useWords(Words words);
    [[nodiscard]] int widestHint(); ///< pixels, with the longest number behind the editor

signals:
    void edited(int raw);
    void rawChanged(int raw);
    /// A sentence about what was typed: why it is not taken, or how it was understood.
    void remarked(const QString& sentence);

protected:
    ParameterField(const ParameterRow& row, QWidget* parent);
    [[nodiscard]] const ParameterRow& row() const { return m_row; }
    virtual void display(std::optional<int> raw) = 0;
    virtual void setWords(Words /*words*/) { }
    /// The number as stored, for the label behind the editor; empty where the editor says it.
    [[nodiscard]] virtual QString storedText(int raw) const;
    void refreshStored(); ///< storedText() is another one
    void addPart(QWidget* part, const QString& accessibleName);

private:
    const ParameterRow& m_row;
    QLabel* m_stored;
    int m_raw = -1;
};

} // namespace trex
