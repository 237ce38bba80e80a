// SPDX-License-Identifier: GPL-3.0-or-later
// What the buttons of the journal do.
#include "protocol/errortext.h"
#include "protocol/session/controller.h"
#include "widgets/common/eventlog.h"
#include "widgets/common/filedialogs.h"
#include "widgets/common/panel.h"
#include "widgets/common/theme.h"
#include "widgets/journal/journaldialog.h"

#include <QComboBox>
#include <QFileInfo>
#include <QLabel>
#include <QLineEdit>
#include <QPlainTextEdit>
#include <QPushButton>
#include <QTableView>

#include <algorithm>

using namespace Qt::Literals::StringLiterals;

namespace trex {
namespace {

void fitColumns(QTableView& table)
{
    constexpr int kGap = 16;
    constexpr int kWidest = 260; // the rest of a long one: its tool tip, or a wider column
    table.resizeColumnsToContents();
    for (int column = 0; column + 1 < table.model()->columnCount(); ++column) {
        if (!table.isColumnHidden(column)) {
            table.setColumnWidth(column, std::min(table.columnWidth(column) + kGap, kWidest));
        }
    }
}

} // namespace

void JournalDialog::reload()
{
    const bool isConnected = m_context.controller.state() == LinkState::Connected;
    const bool isAll = m_which->currentIndex() > 0;
    std::optional<ControllerIdentity> who;
    if (!isAll) {
        who = isConnected ? m_audit.controller() : ControllerIdentity{};
    }
    const auto* const chosen = chosenEntry();
    const qint64 number = chosen != nullptr ? chosen->number : 0;
    const auto entries = m_audit.journal().entries({.controller = who, .setting = {}});
    const auto checkpoints = m_audit.journal().checkpoints(who);
    if (!entries || !checkpoints) {
        tell(EventLog::Failure, errorText(entries ? checkpoints.error() : entries.error()), false);
    }
    m_entries.show(entries.value_or(std::vector<JournalEntry>()));
    m_checkpoints.show(checkpoints.value_or(std::vector<Checkpoint>()));
    m_table->setColumnHidden(JournalModel::ControllerColumn, !isAll);
    m_checkpointTable->setColumnHidden(CheckpointModel::ControllerColumn, !isAll);
    fitColumns(*m_table);
    fitColumns(*m_checkpointTable);
    if (const int row = m_entries.rowOf(number); row >= 0) {
        m_table->setCurrentIndex(m_shown.mapFromSource(m_entries.index(row, 0)));
    }
    refresh();
}

QString JournalDialog::blockReason() const
{
    const auto& controller = m_context.controller;
    if (controller.state() != LinkState::Connected) {
        return m_which->currentIndex() == 0
            ? tr("Not connected. Choose \"All controllers\" to read the journal.")
            : tr("Not connected: the journal can be read, but nothing can be written.");
    }
    const auto mode = controller.device().mode;
    if (!mode) {
        return tr("Waiting for the controller to tell its mode.");
    }
    return isSerial(*mode) ? QString()
                           : tr("▲ Nothing can be written: the controller is in %1 mode. Switch "
                                "its power off, take the mode jumper off, and switch it on again.")
                                 .arg(*mode == Mode::Rc ? tr("RC") : tr("analog"));
}

const JournalEntry* JournalDialog::chosenEntry() const
{
    const QModelIndex index = m_shown.mapToSource(m_table->currentIndex());
    return index.isValid() ? &m_entries.at(index.row()) : nullptr;
}

const Checkpoint* JournalDialog::chosenCheckpoint() const
{
    const QModelIndex index = m_checkpointTable->currentIndex();
    return index.isValid() ? &m_checkpoints.at(index.row()) : nullptr;
}

bool JournalDialog::isHere(const ControllerIdentity& controller) const
{
    const ControllerIdentity present = m_audit.controller();
    return m_which->currentIndex() == 0
        || (controller.port == present.port && controller.signature == present.signature
            && (controller.device == present.device || controller.device < 0));
}

void JournalDialog::refresh()
{
    const QString reason = blockReason();
    const bool isConnected = m_context.controller.state() == LinkState::Connected;
    const bool isIdle = !m_transfer.isBusy();
    const auto* const entry = chosenEntry();
    const auto* const checkpoint = chosenCheckpoint();
    m_reason->setText(reason);
    m_reason->setVisible(!reason.isEmpty());
    theme::setTextColour(*m_reason,
                         reason.startsWith(u'▲') ? ColourRole::Warning : ColourRole::DimText);
    m_revert->setEnabled(reason.isEmpty() && isIdle && entry != nullptr
                         && isHere(entry->controller));
    m_restore->setEnabled(reason.isEmpty() && isIdle && checkpoint != nullptr
                          && isHere(checkpoint->controller));
    m_save->setEnabled(isConnected && isIdle && !m_name->text().simplified().isEmpty());
    m_remove->setEnabled(checkpoint != nullptr && !checkpoint->name.isEmpty());
    m_export->setEnabled(checkpoint != nullptr);
    m_write->setEnabled(reason.isEmpty() && isIdle && !m_plan.writes.empty());
}

void JournalDialog::planRevert()
{
    const auto* const entry = chosenEntry();
    if (entry == nullptr) {
        return;
    }
    readThenPlan([this, chosen = *entry] { return m_audit.planRevert(chosen); },
                 tr("To hold what it held before %1 (%2), the controller needs:")
                     .arg(timeText(entry->time), titleOf(entry->intent.setting)));
}

void JournalDialog::planRestore()
{
    const auto* const checkpoint = chosenCheckpoint();
    if (checkpoint == nullptr) {
        return;
    }
    readThenPlan(
        [this, wanted = checkpoint->configuration]() -> Result<TransferPlan> {
            return m_audit.planRestore(wanted);
        },
        tr("To hold the configuration of %1, the controller needs:")
            .arg(timeText(checkpoint->time)));
}

void JournalDialog::readThenPlan(std::function<Result<TransferPlan>()> make, const QString& title)
{
    if (m_transfer.isBusy()) {
        return;
    }
    dropPlan();
    m_makePlan = std::move(make);
    m_planTitle->setText(title);
    tell(EventLog::Information, tr("Reading everything from the controller."), false);
    m_transfer.read();
    refresh();
}

void JournalDialog::onRead(const Result<Configuration>& read)
{
    const auto make = std::exchange(m_makePlan, {});
    const auto plan = read.and_then([&make](const Configuration&) { return make(); });
    if (plan) {
        tell(EventLog::Information, {}, false);
        showPlan(*plan);
    } else {
        tell(EventLog::Failure, errorText(plan.error()));
    }
    refresh();
}

void JournalDialog::showPlan(const TransferPlan& plan)
{
    m_plan = plan;
    QStringList lines;
    for (const auto& write : plan.writes) {
        lines << (write.needsReset() ? tr("%1 (acts after a power cycle)").arg(write.text())
                                     : write.text());
    }
    if (lines.isEmpty()) {
        lines << tr("Nothing: it holds all of that already.");
    }
    m_planText->setPlainText((lines + plan.leftOut).join(u'\n'));
    m_planBox->show();
    m_write->setFocus();
}

void JournalDialog::dropPlan()
{
    m_plan = {};
    m_planBox->hide();
    refresh();
}

void JournalDialog::write()
{
    if (m_transfer.isBusy() || !blockReason().isEmpty() || m_plan.writes.empty()) {
        return;
    }
    tell(EventLog::Information, tr("Writing to the controller."), false);
    m_transfer.write(m_plan);
    refresh();
}

void JournalDialog::onFinished(const TransferOutcome& outcome)
{
    if (!outcome.error) {
        m_plan = {};
        m_planBox->hide();
    }
    tell(outcome.error ? EventLog::Failure : EventLog::Information, outcome.text());
    reload();
}

void JournalDialog::saveCheckpoint()
{
    const QString name = m_name->text().simplified();
    m_audit.saveCheckpoint(name, this, [this, name](const Result<qint64>& saved) {
        if (saved) {
            m_name->clear();
        }
        tell(saved ? EventLog::Information : EventLog::Failure,
             saved ? tr("The configuration is kept as %1.").arg(name) : errorText(saved.error()));
        reload();
    });
}

void JournalDialog::removeCheckpoint()
{
    const auto* const checkpoint = chosenCheckpoint();
    if (checkpoint == nullptr || checkpoint->name.isEmpty()) {
        return; // what was saved by itself is never thrown away
    }
    const QString name = checkpoint->name;
    const auto removed = m_audit.journal().removeCheckpoint(checkpoint->number);
    tell(removed ? EventLog::Information : EventLog::Failure,
         removed ? tr("The checkpoint %1 is deleted.").arg(name) : errorText(removed.error()));
    reload();
}

void JournalDialog::exportCheckpoint()
{
    const auto* const checkpoint = chosenCheckpoint();
    if (checkpoint == nullptr) {
        return;
    }
    const QString suggestion =
        u"%1-%2.json"_s.arg(checkpoint->name.isEmpty() ? u"trex"_s : checkpoint->name,
                            checkpoint->time.toLocalTime().date().toString(Qt::ISODate));
    m_context.fileDialogs.askSave(
        this, tr("Export the checkpoint"), suggestion, tr("Configuration (*.json)"),
        [this, configuration = checkpoint->configuration](const QString& path) {
            const auto saved = saveConfiguration(configuration, path);
            tell(saved ? EventLog::Information : EventLog::Failure,
                 saved ? tr("The checkpoint is saved in %1.").arg(QFileInfo(path).fileName())
                       : errorText(saved.error()));
        });
}

void JournalDialog::tell(int severity, const QString& sentence, bool alsoLog)
{
    const bool isBad = severity != EventLog::Information;
    const QString text = isBad && !sentence.startsWith(u'▲') ? u"▲ "_s + sentence : sentence;
    m_message->setText(text);
    m_message->setVisible(!sentence.isEmpty());
    m_severity = severity;
    theme::setTextColour(*m_message, isBad ? ColourRole::Fault : ColourRole::Text);
    if (alsoLog && !sentence.isEmpty()) {
        m_context.log.add(severity, sentence);
    }
}

} // namespace trex
