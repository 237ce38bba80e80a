// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "protocol/codec/parametertable.h"

namespace trex {

/// What the meaning of a value depends on, beside the value and its row.
struct ValueContext {
    Model model = Model::TrexJr;
    std::optional<int> pwmMaximum; ///< raw, of the same motor: a prescaler's frequency needs it
    bool operator==(const ValueContext&) const = default;
};

/// How a row's quantity is shown: physical = raw × scale, in a unit that fits the size of it.
struct DisplayUnit {
    QString unit; ///< "" for plain numbers
    double scale = 1.0;
    int decimals = 0;
    bool isGuess = false; ///< the scale is inferred: shown with ≈
};
[[nodiscard]] DisplayUnit displayUnit(const ParameterRow& row, Model model);

/// The row of the PWM maximum that a prescaler goes with; null for every other row.
[[nodiscard]] const ParameterRow* pwmMaximumFor(const ParameterRow& row);

/// "0.5 s", "≈ 9.00 A", "1: 2.44 kHz", "2: ≈ 610 Hz", "off": as the panel shows it.
[[nodiscard]] QString valueText(const ParameterRow& row, int raw, const ValueContext& context);
/// "0.5 s (5)": with the raw number beside it, once where both are the same.
[[nodiscard]] QString valueWithRaw(const ParameterRow& row, int raw,
                                   const ValueContext& context = {});
struct ValueInContext {
    int raw = 0;
    ValueContext context;
};
/// "off → 0.5 s", "0.2 → 0.5 s": the unit once, when both sides carry it. No `from`: an en dash.
[[nodiscard]] QString changeText(const ParameterRow& row, const std::optional<ValueInContext>& from,
                                 const ValueInContext& to);
/// "0 to 12.7 s": what the controller takes.
[[nodiscard]] QString rangeText(const ParameterRow& row, Model model = Model::TrexJr);
/// The default with a sign when it is a guess: "≈ off (0)".
[[nodiscard]] QString defaultText(const ParameterRow& row, const ValueContext& context = {});

/// "documented", "observed", "inferred": how sure the table is.
[[nodiscard]] QString gradeText(Grade grade);
/// The less sure one of a row's meaning and its default.
[[nodiscard]] Grade weakestGrade(const ParameterRow& row);
/// "✓ documented", "○ observed on controllers", "≈ inferred, unsure": a sign of its own for each.
[[nodiscard]] QString gradeWithSign(Grade grade);
/// "✓ documented", "○ observed", "≈ unsure": the same in a column's width.
[[nodiscard]] QString gradeInShort(Grade grade);

/// "0x07": a parameter's number as the documents write it.
[[nodiscard]] QString hexText(int number);

} // namespace trex
