// SPDX-License-Identifier: GPL-3.0-or-later
// What the bench panel does: edits, dry run, the test itself.
#include "protocol/errortext.h"
#include "protocol/procedures/benchpreview.h"
#include "protocol/procedures/configtransfer.h"
#include "widgets/bench/benchchart.h"
#include "widgets/bench/benchlimitsform.h"
#include "widgets/bench/benchpanel.h"
#include "widgets/common/eventlog.h"
#include "widgets/common/theme.h"

#include <QCoreApplication>
#include <QElapsedTimer>
#include <QLabel>
#include <QListWidget>
#include <QProgressBar>
#include <QPushButton>
#include <QTabWidget>
#include <QTableView>

namespace trex {

using namespace std::chrono_literals;
using namespace Qt::Literals::StringLiterals;

namespace {

constexpr int kResultsTab = 2;
constexpr qint64 kSliceMs = 12; // of computing, between two looks at the person
constexpr int kJointMode = 1;
constexpr double kProgressSteps = 1000.0;

} // namespace

QString BenchPanel::state() const
{
    return m_test        ? u"running"_s
        : m_dryRun       ? u"dry-run"_s
        : m_isConfirming ? u"confirm"_s
                         : u"idle"_s;
}

void BenchPanel::tell(int severity, const QString& sentence)
{
    m_told = sentence;
    m_status->setText(sentence);
    context().log.add(severity, sentence);
}

QString BenchPanel::blockReason() const
{
    const Controller& controller = context().controller;
    if (controller.state() != LinkState::Connected) {
        return tr("Not connected.");
    }
    if (controller.gate().isLockedOut(std::chrono::steady_clock::now())) {
        return tr("Just stopped: no orders for half a second.");
    }
    if (controller.device().serialControls == false) {
        return tr("Serial does not control the motors (mode jumper, channel 5).");
    }
    const ParameterRow& mode = parameterRow("motor-mode");
    if (!context().deviceSettings.parameter(mode.number)) {
        return tr("The motor mode has not been read yet.");
    }
    if (context().deviceSettings.parameter(mode.number) == kJointMode
        && !context().deviceSettings.isPending(mode.number)) {
        return tr("In joint mode the controller measures no currents.");
    }
    if (const auto sound = validate(entry().profile); !sound) {
        return tr("This test cannot be run: %1.").arg(sound.error().context);
    }
    return {};
}

QString BenchPanel::motionText() const
{
    QStringList parts;
    for (const auto& [motor, title] :
         {std::pair{MotorId::Motor1, tr("Motor 1")}, std::pair{MotorId::Motor2, tr("Motor 2")},
          std::pair{MotorId::Aux, tr("The auxiliary motor")}}) {
        if (const int speed = highestSpeed(entry().profile, motor); speed > 0) {
            parts << tr("%1 up to speed %2 (%3 %)")
                         .arg(title)
                         .arg(speed)
                         .arg(speed * 100.0 / kFullSpeed, 0, 'f', 0);
        }
    }
    return parts.isEmpty() ? tr("No motor is driven") : parts.join(u", "_s);
}

void BenchPanel::refresh()
{
    if (m_entries.empty()) {
        return;
    }
    const QString reason = blockReason();
    const bool isBusy = m_test || m_dryRun;
    const bool hasOutcome = entry().outcome.has_value();
    m_isConfirming = m_isConfirming && reason.isEmpty() && !isBusy;
    // Not disabled, which would hide which test it is.
    m_list->setAttribute(Qt::WA_TransparentForMouseEvents, m_test != nullptr);
    m_list->setFocusPolicy(m_test ? Qt::NoFocus : Qt::StrongFocus);
    m_tabs->widget(1)->setEnabled(!isBusy);
    m_dry->setEnabled(!m_test && !m_isConfirming && validate(entry().profile));
    m_dry->setText(m_dryRun ? tr("Cancel") : tr("Dry run"));
    m_start->setEnabled(!isBusy && !m_isConfirming && reason.isEmpty());
    m_start->setToolTip(reason.isEmpty() ? tr("Runs the test on the motors, after a question")
                                         : reason);
    m_confirmation->setVisible(m_isConfirming);
    m_progress->setVisible(isBusy);
    m_html->setEnabled(hasOutcome && !isBusy);
    m_pdf->setEnabled(hasOutcome && !isBusy);
    m_revert->setEnabled(!isBusy && entry().profile != entry().original);
    if (!isBusy && !m_isConfirming) {
        const double seconds = plannedSeconds(entry().profile);
        m_status->setText(!reason.isEmpty() ? reason
                              : !m_told.isEmpty()
                              ? m_told
                              : tr("%1; %2 s.").arg(motionText()).arg(seconds, 0, 'f', 1));
    }
}

void BenchPanel::refreshTitles()
{
    for (std::size_t i = 0; i < m_entries.size(); ++i) {
        const Entry& one = m_entries[i];
        const bool isEdited = one.profile != one.original;
        m_list->item(int(i))->setText(one.profile.name + (isEdited ? tr(" (edited)") : QString()));
    }
}

void BenchPanel::showOutcome()
{
    const Entry& one = entry();
    m_description->setText(one.profile.description);
    m_description->setVisible(!one.profile.description.isEmpty());
    m_results.setOutcome(one.outcome);
    m_plot->setPrediction(one.prediction);
    const bool isMeasured = one.outcome && !one.outcome->isDryRun;
    m_plot->setMeasured(isMeasured ? &one.outcome->trace : nullptr);
    m_saveProposals->setVisible(one.outcome && !one.outcome->proposals.empty());
    if (!one.outcome) {
        m_verdict->setText(tr("No results yet: try a dry run, or start the test."));
        theme::setTextColour(*m_verdict, ColourRole::DimText);
        m_proposals->clear();
        return;
    }
    const BenchVerdict verdict = one.outcome->verdict();
    QString text = signOf(verdict) + u' ' + one.outcome->verdictText();
    if (one.outcome->isDryRun) {
        text += u' ' + tr("(Dry run: a prediction.)");
    }
    m_verdict->setText(text);
    theme::setTextColour(*m_verdict,
                         verdict == BenchVerdict::Passed       ? ColourRole::Ok
                             : verdict == BenchVerdict::Failed ? ColourRole::Fault
                                                               : ColourRole::Text);
    QStringList proposals;
    for (const ProposalText& proposal : proposalsOf(*one.outcome)) {
        proposals
            << tr("Proposed: %1: %2. %3").arg(proposal.title, proposal.value, proposal.reason);
    }
    m_proposals->setText(proposals.join(u'\n'));
}

void BenchPanel::onEdited()
{
    if (m_isFilling) {
        return;
    }
    entry().profile.steps = m_steps.steps();
    entry().profile = m_limits->applied(entry().profile);
    entry().prediction = {}; // of another test
    m_isConfirming = false;
    m_told.clear();
    m_plot->setPlan(previewOf(entry().profile));
    m_plot->setPrediction({});
    refreshTitles();
    refresh();
}

void BenchPanel::addStep()
{
    BenchStep step;
    const int row = m_stepTable->currentIndex().row();
    step.motor = entry().profile.motor;
    step.seconds = 1.0;
    selectStep(m_steps.insert(row, step));
}

void BenchPanel::revert()
{
    entry().profile = entry().original;
    entry().prediction = {};
    showEntry();
}

// ---- dry run

void BenchPanel::startDryRun()
{
    if (m_dryRun) {
        m_dryRun.reset();
        m_slice.stop();
        tell(EventLog::Information, tr("Dry run cancelled."));
        refresh();
        return;
    }
    BenchDryRunOptions options;
    options.model = context().controller.model();
    options.parameters =
        presentConfiguration(context().controller, context().deviceSettings).parameters;
    m_dryRun = std::make_unique<BenchDryRun>(entry().profile, options);
    m_report = reportOn(context().controller, context().deviceSettings,
                        u"TReX Panel "_s + QCoreApplication::applicationVersion(),
                        QDateTime::currentDateTimeUtc());
    m_slice.start();
    refresh();
}

void BenchPanel::sliceOfDryRun()
{
    if (!m_dryRun) {
        m_slice.stop();
        return;
    }
    QElapsedTimer clock;
    clock.start();
    bool goesOn = true;
    while (goesOn && clock.elapsed() < kSliceMs) {
        goesOn = m_dryRun->advance(500ms);
    }
    const double part = m_dryRun->run().seconds() / std::max(plannedSeconds(entry().profile), 0.1);
    m_progress->setValue(int(part * kProgressSteps));
    m_status->setText(tr("Dry run: %1 s simulated.").arg(m_dryRun->run().seconds(), 0, 'f', 0));
    if (goesOn) {
        return;
    }
    m_slice.stop();
    const auto dryRun = std::move(m_dryRun);
    Entry& one = entry();
    const BenchOutcome outcome = evaluate(dryRun->run(), true);
    one.prediction = outcome.trace;
    // What was measured is not thrown away for a prediction.
    if (!one.outcome || one.outcome->isDryRun) {
        one.outcome = outcome;
        one.report = m_report;
    }
    showOutcome();
    refresh();
    tell(EventLog::Information,
         tr("Dry run of \"%1\": %2").arg(one.profile.name, outcome.verdictText()));
}

// ---- the test itself

void BenchPanel::askToStart()
{
    if (!blockReason().isEmpty()) {
        refresh();
        return;
    }
    m_isConfirming = true;
    m_told.clear();
    const double seconds = plannedSeconds(entry().profile);
    m_confirmText->setText(
        tr("%1, for %2 s. Is the machine held fast or its wheels off the ground, and is everybody "
           "clear of it? STOP and Esc end it at once.")
            .arg(motionText())
            .arg(seconds, 0, 'f', 0));
    refresh();
    m_status->setText(tr("Waiting for your word."));
    m_confirmation->setFocus();
}

void BenchPanel::start()
{
    if (!m_isConfirming || m_test || !blockReason().isEmpty()) {
        return;
    }
    m_isConfirming = false;
    m_report = reportOn(context().controller, context().deviceSettings,
                        u"TReX Panel "_s + QCoreApplication::applicationVersion(),
                        QDateTime::currentDateTimeUtc());
    m_test = std::make_unique<BenchTest>(context().controller, entry().profile);
    connect(m_test.get(), &BenchTest::tick, this, &BenchPanel::onTick);
    // Later: what has just ended is not destroyed while it tells so.
    connect(m_test.get(), &Procedure::finished, this, &BenchPanel::onFinished,
            Qt::QueuedConnection);
    m_tabs->setCurrentIndex(0);
    m_plot->setMeasured(&m_test->run().trace());
    tell(EventLog::Information,
         tr("Bench test \"%1\" started: %2.").arg(entry().profile.name, motionText()));
    m_test->start();
    refresh();
}

void BenchPanel::cancel()
{
    if (m_test) {
        m_test->cancel();
    }
}

void BenchPanel::onTick()
{
    if (!m_test) {
        return;
    }
    const BenchRun& run = m_test->run();
    const double seconds = run.seconds();
    m_progress->setValue(
        int(seconds / std::max(plannedSeconds(run.profile()), 0.1) * kProgressSteps));
    m_status->setText(
        run.hasStarted() ? tr("Running: %1 s, step %2.").arg(seconds, 0, 'f', 0).arg(run.position())
                         : tr("Waiting for fresh readings."));
    m_plot->setNow(seconds);
}

void BenchPanel::onFinished(const Result<void>& result)
{
    if (!m_test) {
        return;
    }
    const auto test = std::move(m_test);
    m_plot->setMeasured(nullptr);
    m_plot->setNow(-1.0);
    QString sentence;
    int severity = EventLog::Information;
    if (test->run().hasEnded()) {
        const BenchOutcome outcome = evaluate(test->run(), false);
        sentence = outcome.verdictText();
        severity =
            outcome.ending.end == BenchEnd::Completed ? EventLog::Information : EventLog::Warning;
        if (test->run().hasStarted()) {
            entry().outcome = outcome;
            entry().report = m_report;
            m_tabs->setCurrentIndex(kResultsTab);
        }
    }
    if (!result) {
        sentence = errorText(result.error());
        severity = EventLog::Failure;
    }
    showOutcome();
    refresh();
    tell(severity, tr("Bench test \"%1\": %2").arg(entry().profile.name, sentence));
}

} // namespace trex
