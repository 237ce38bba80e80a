// SPDX-License-Identifier: GPL-3.0-or-later
// The report of a bench test that one hands in: one HTML file with its plots in it, light or dark
// as the reader's system is, and fit for printing.
#pragma once

#include "protocol/procedures/benchanalysis.h"

#include <QDateTime>
#include <QSize>

namespace trex {

class Controller;
class DeviceSettings;

/// What the report says beyond the outcome.
struct BenchReport {
    QString program; ///< "TReX Panel 1.4.0"
    QDateTime started; ///< UTC
    QString port;
    QString line; ///< "19200 baud, no error detection"
    QString model; ///< "TReX Jr"; empty: not known
    QString firmware;
    QString mode;
    Configuration settings; ///< as read from the controller; empty: not read
};

/// What is known of a connected controller.
[[nodiscard]] BenchReport reportOn(const Controller& controller, const DeviceSettings& settings,
                                   const QString& program, const QDateTime& started);

/// A plot as SVG of its own, with colours for paper; the report's style replaces them by class.
struct BenchPlot {
    QString title;
    QByteArray svg;
    QSize size;
};
[[nodiscard]] std::vector<BenchPlot> plotsOf(const BenchOutcome& outcome);

/// Label and value, for the head of the report.
[[nodiscard]] std::vector<std::pair<QString, QString>> factsOf(const BenchOutcome& outcome,
                                                               const BenchReport& report);
/// "Acceleration of motor 1", "12 (…)", reason.
struct ProposalText {
    QString title;
    QString value;
    QString reason;
};
/// "500 ms", "off": a parameter's raw value for people.
[[nodiscard]] QString parameterText(const ParameterRow& row, int raw, Model model);
[[nodiscard]] std::vector<ProposalText> proposalsOf(const BenchOutcome& outcome);
[[nodiscard]] QString knowledgeText(); ///< what such a test can know, in a paragraph
/// ✔ ✖ ? ·: so that the colour is not the only sign.
[[nodiscard]] QString signOf(BenchVerdict verdict);
/// Without characters that no text has, so that XML can hold it.
[[nodiscard]] QString printable(const QString& text);

[[nodiscard]] QByteArray reportHtml(const BenchOutcome& outcome, const BenchReport& report);
/// Whole or not at all. Errors: FileUnwritable.
[[nodiscard]] Result<void> saveReport(const QString& path, const BenchOutcome& outcome,
                                      const BenchReport& report);

} // namespace trex
