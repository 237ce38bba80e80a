// SPDX-License-Identifier: GPL-3.0-or-later
// What the buttons of the parameters panel do, and what stands beside them.
#include "protocol/codec/replies.h"
#include "protocol/errortext.h"
#include "protocol/procedures/writeaudit.h"
#include "protocol/session/controller.h"
#include "protocol/storage/linesettingsstore.h"
#include "widgets/common/eventlog.h"
#include "widgets/common/theme.h"
#include "widgets/common/uisettings.h"
#include "widgets/parameters/configbackup.h"
#include "widgets/parameters/parameterspanel.h"
#include "widgets/parameters/parametertable.h"
#include "widgets/parameters/writepreview.h"

#include <QAction>
#include <QCoreApplication>
#include <QLabel>
#include <QProgressBar>
#include <QPushButton>

using namespace Qt::Literals::StringLiterals;

namespace trex {

QString ParametersPanel::blockReason() const
{
    const auto& controller = context().controller;
    if (controller.state() == LinkState::Lost || controller.state() == LinkState::Retrying) {
        return tr("The connection is lost: values are unknown until it is back. Your edits are "
                  "kept.");
    }
    if (controller.state() != LinkState::Connected) {
        return tr("Not connected. Connect to read the controller's parameters.");
    }
    if (controller.isRecording()) {
        return tr("These are the settings as they were read during the recording; they cannot be "
                  "changed here. Save them to a file, and load that file into a controller.");
    }
    if (m_isWriting) {
        return tr("Writing to the controller.");
    }
    if (m_transfer.isBusy()) {
        return tr("Reading all parameters from the controller.");
    }
    const auto mode = controller.device().mode;
    if (!mode) {
        return tr("Waiting for the controller to tell its mode.");
    }
    return isSerial(*mode)
        ? QString()
        : tr("These can be read but not changed: the controller is in %1 mode. Switch its power "
             "off, take the mode jumper off, and switch it on again.")
              .arg(*mode == Mode::Rc ? tr("RC") : tr("analog"));
}

QString ParametersPanel::bannerText() const
{
    QStringList sentences;
    if (const QString reason = blockReason(); !reason.isEmpty()) {
        const bool isConnected = context().controller.state() == LinkState::Connected;
        sentences << (isConnected && !m_transfer.isBusy() ? u"▲ "_s + reason : reason);
    }
    QStringList waiting;
    for (const auto& row : kParameters) {
        if (context().deviceSettings.isPending(row.number)) {
            waiting << QCoreApplication::translate("Parameters", row.title);
        }
    }
    if (!waiting.isEmpty()) {
        sentences << u"▲ "_s
                + tr("Needs a power cycle: switch the controller off and on to put in force: %1.")
                      .arg(waiting.join(u", "_s));
    }
    return sentences.join(u'\n');
}

TransferPlan ParametersPanel::plan() const
{
    const auto& device = context().controller.device();
    Configuration wanted;
    wanted.parameters = m_model.edits();
    wanted.calibrations = m_calibrations;
    return planTransfer(presentConfiguration(context().controller, context().deviceSettings),
                        wanted, device.mode ? std::optional(inputOf(*device.mode)) : std::nullopt);
}

void ParametersPanel::refresh()
{
    keepDraft();
    const auto& controller = context().controller;
    m_model.setAdvice(adviceOn(
        presentConfiguration(controller, context().deviceSettings).parameters, m_model.wanted(),
        controller.options().line, controller.model(),
        LineSettingsStore(context().settings.file()).numbersInUse(controller.options().port)));
    m_model.setControllerModel(controller.model());
    for (const auto& row : kParameters) {
        m_model.setPending(row.number, context().deviceSettings.isPending(row.number));
    }
    const QString reason = blockReason();
    m_table->setEditable(reason);
    const QString banner = bannerText();
    m_banner->setText(banner);
    m_banner->setVisible(!banner.isEmpty());
    colourText(m_banner, banner.contains(u'▲') ? ColourRole::Warning : ColourRole::Text);
    const auto planned = plan();
    m_pending->setText(writePreview(planned, m_model, controller.options().line));
    fitPending();
    const bool isIdle = !m_transfer.isBusy();
    const bool isRead = isIdle && controller.state() == LinkState::Connected;
    const bool hasEdits = !m_model.edits().empty() || !m_calibrations.empty();
    m_progress->setVisible(!isIdle);
    m_cancel->setVisible(m_isWriting);
    m_reload->setEnabled(isRead);
    m_save->setEnabled(isRead);
    m_defaults->setEnabled(reason.isEmpty());
    m_load->setEnabled(reason.isEmpty());
    m_revert->setEnabled(hasEdits && isIdle);
    m_apply->setEnabled(reason.isEmpty() && !planned.writes.empty());
    m_factoryReset->setEnabled(reason.isEmpty());
    m_rollback->setEnabled(reason.isEmpty());
    for (auto* const button : {m_defaults, m_load, m_apply, m_rollback}) {
        button->setAccessibleDescription(reason);
    }
}

void ParametersPanel::apply()
{
    if (!blockReason().isEmpty() || plan().writes.empty()) {
        refresh();
        return;
    }
    const auto present = presentConfiguration(context().controller, context().deviceSettings);
    if (!m_isBackedUp && !m_mayGoWithoutBackup && !isComplete(present)) {
        m_afterRead = [this] { apply(); }; // the backup wants everything
        readAll();
        return;
    }
    if (m_isBackedUp || m_mayGoWithoutBackup || backUp()) {
        writePlan();
    }
}

void ParametersPanel::writePlan()
{
    tell(EventLog::Information, {});
    closeDifferences();
    offerToPutBack({});
    m_model.clearRefusals();
    m_isWriting = true;
    m_transfer.write(plan(), ConfigTransfer::OnFailure::Stop);
    refresh();
}

void ParametersPanel::offerToPutBack(const std::vector<SettingWrite>& written)
{
    m_toPutBack = written;
    m_rollback->setText(written.size() == 1 ? tr("Put &back 1 value")
                                            : tr("Put &back %1 values").arg(written.size()));
    m_rollback->setVisible(!written.empty());
    m_keep->setVisible(!written.empty());
}

void ParametersPanel::putBack()
{
    if (!blockReason().isEmpty() || m_toPutBack.empty()) {
        refresh();
        return;
    }
    const auto written = m_toPutBack;
    offerToPutBack({});
    m_isWriting = true;
    m_transfer.putBack(written);
    refresh();
}

Result<QString> ParametersPanel::backUpNow()
{
    const auto present = presentConfiguration(context().controller, context().deviceSettings);
    auto path = backUpConfiguration(present, backupFolder(context().settings));
    if (path) {
        m_isBackedUp = true;
        context().log.add(EventLog::Information,
                          tr("The settings as they were are saved in %1.").arg(*path));
    }
    return path;
}

bool ParametersPanel::backUp()
{
    const auto path = backUpNow();
    if (!path) {
        m_mayGoWithoutBackup = true;
        // What stops the one most often stops the other: one question for both.
        WriteAudit* const audit = context().audit;
        const bool isJournalled = audit == nullptr || audit->journal().ready();
        if (!isJournalled) {
            audit->goWithout();
        }
        const QString text = isJournalled
            ? tr("Nothing is written to the controller, because the present settings could not be "
                 "saved first: %1 Apply once more to write without that copy.")
            : tr("Nothing is written to the controller, because the present settings could not be "
                 "saved first, and the journal cannot be written: %1 Apply once more to write "
                 "without that copy and without the journal.");
        tell(EventLog::Failure, text.arg(errorText(path.error())));
    }
    return path.has_value();
}

void ParametersPanel::onFinished(const TransferOutcome& outcome)
{
    m_isWriting = false;
    // What was put back, or may not be in the controller, is still what the person wants.
    for (const auto* const writes : {&outcome.restored, &outcome.notRestored}) {
        for (const auto& write : *writes) {
            if (write.row != nullptr) {
                static_cast<void>(m_model.edit(write.row->number, write.rawTo));
            }
        }
    }
    if (outcome.failed && outcome.failed->row != nullptr) {
        m_model.setRefusal(outcome.failed->row->number, errorText(*outcome.error));
        m_table->setCurrentIndex(m_model.indexOf(outcome.failed->row->number));
    }
    const bool wasPuttingBack = !outcome.restored.empty() || !outcome.notRestored.empty();
    if (!outcome.error && !wasPuttingBack) {
        m_calibrations.clear();
    }
    QString text = outcome.text();
    if (!outcome.error && !outcome.restored.empty()) {
        text += u' ' + tr("What you wanted stands as an edit again.");
    }
    if (outcome.error && !outcome.toPutBack().empty()) {
        text += u' ' + tr("Put it back, or keep it?");
    }
    m_isInDoubt = outcome.failedMayHold || !outcome.notRestored.empty();
    offerToPutBack(outcome.error ? outcome.toPutBack() : std::vector<SettingWrite>{});
    const bool isWarning = outcome.error ? outcome.error->code == ErrorCode::Cancelled : false;
    tell(isWarning                                           ? EventLog::Warning
             : outcome.error || !outcome.notRestored.empty() ? EventLog::Failure
                                                             : EventLog::Information,
         text);
    refresh();
    if (m_readsAgain && context().controller.state() == LinkState::Connected) {
        readAll();
    }
}

void ParametersPanel::revert()
{
    m_calibrations.clear();
    closeDifferences();
    tell(EventLog::Information, {});
    m_model.revert();
    refresh(); // calibrations are no edits of the model
}

} // namespace trex
