// SPDX-License-Identifier: GPL-3.0-or-later
// What the buttons of the parameters panel do, and what stands beside them.
#include "protocol/codec/replies.h"
#include "protocol/errortext.h"
#include "protocol/session/controller.h"
#include "widgets/common/eventlog.h"
#include "widgets/common/filedialogs.h"
#include "widgets/common/theme.h"
#include "widgets/parameters/configbackup.h"
#include "widgets/parameters/parameterspanel.h"
#include "widgets/parameters/parametertable.h"

#include <QCoreApplication>
#include <QFileInfo>
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

QString ParametersPanel::pendingText(const TransferPlan& plan) const
{
    if (plan.writes.empty()) {
        return (QStringList(tr("Nothing to write.")) + plan.leftOut).join(u'\n');
    }
    QStringList changes;
    QStringList late;
    QStringList advice;
    for (const auto& write : plan.writes) {
        changes << write.text();
        if (write.row == nullptr) {
            continue;
        }
        if (write.needsReset()) {
            late << write.title();
        }
        for (const auto& remark : m_model.advice(write.row->number)) {
            advice << u"▲ "_s + remark;
        }
    }
    QStringList lines{tr("Will be written: %1.").arg(changes.join(u"; "_s))};
    if (!late.isEmpty()) {
        lines << tr("Needs a power cycle afterwards: %1.").arg(late.join(u", "_s));
    }
    return (lines + advice + plan.leftOut).join(u'\n');
}

void ParametersPanel::refresh()
{
    const auto& controller = context().controller;
    m_model.setAdvice(
        adviceOn(presentConfiguration(controller, context().deviceSettings).parameters,
                 m_model.wanted(), controller.options().line, controller.model()));
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
    m_pending->setText(pendingText(planned));
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
    for (auto* const button : {m_defaults, m_load, m_apply}) {
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
        m_appliesAfterRead = true; // the backup wants everything
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
    m_model.clearRefusals();
    m_isWriting = true;
    const auto planned = plan();
    m_transfer.write(planned);
    refresh();
}

bool ParametersPanel::backUp()
{
    const auto present = presentConfiguration(context().controller, context().deviceSettings);
    const auto path = backUpConfiguration(present, backupFolder(context().settings));
    if (!path) {
        m_mayGoWithoutBackup = true;
        tell(EventLog::Failure,
             tr("Nothing is written to the controller, because the present settings could not be "
                "saved first: %1 Apply once more to write without that copy.")
                 .arg(errorText(path.error())));
        return false;
    }
    m_isBackedUp = true;
    context().log.add(EventLog::Information,
                      tr("The settings as they were are saved in %1.").arg(*path));
    return true;
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
    if (!outcome.error) {
        m_calibrations.clear();
    }
    tell(!outcome.error                                    ? EventLog::Information
             : outcome.error->code == ErrorCode::Cancelled ? EventLog::Warning
                                                           : EventLog::Failure,
         outcome.text());
    refresh();
    if (m_readsAgain && context().controller.state() == LinkState::Connected) {
        readAll();
    }
}

void ParametersPanel::revert()
{
    m_calibrations.clear();
    tell(EventLog::Information, {});
    m_model.revert();
}

void ParametersPanel::fillDefaults()
{
    int guesses = 0;
    for (const auto& row : kParameters) {
        if (!row.isTrigger && m_model.device(row.number)) {
            static_cast<void>(m_model.edit(row.number, row.defaultRaw));
            guesses += isGuess(row.defaultGrade) && m_model.isEdited(row.number) ? 1 : 0;
        }
    }
    QString sentence = tr("The factory defaults are filled in; nothing is written before Apply.");
    if (guesses > 0) {
        sentence += u' '
            + tr("Of the values that would change, %1 are marked ≈: the vendor does not state "
                 "them, "
                 "they are guesses.")
                  .arg(guesses);
    }
    tell(guesses > 0 ? EventLog::Warning : EventLog::Information, sentence);
}

void ParametersPanel::save()
{
    const auto& signature = context().controller.device().signature;
    const QString suggestion =
        u"%1-%2.json"_s.arg(signature ? signature->modelName().remove(u' ').toLower() : u"trex"_s,
                            QDate::currentDate().toString(Qt::ISODate));
    context().fileDialogs.askSave(this, tr("Save the controller's settings"), suggestion,
                                  tr("Configuration (*.json)"),
                                  [this](const QString& path) { saveTo(path); });
}

void ParametersPanel::saveTo(const QString& path)
{
    const auto present = presentConfiguration(context().controller, context().deviceSettings);
    if (!isComplete(present)) {
        tell(EventLog::Failure,
             tr("Nothing is saved: not all settings are read from the controller. Reload, then "
                "save again."));
        return;
    }
    if (const auto saved = saveConfiguration(present, path); !saved) {
        tell(EventLog::Failure, errorText(saved.error()));
        return;
    }
    const QString name = QFileInfo(path).fileName();
    tell(EventLog::Information,
         m_model.edits().empty()
             ? tr("What is in the controller is saved in %1.").arg(name)
             : tr("What is in the controller is saved in %1; edits that are not applied are not in "
                  "it.")
                   .arg(name));
}

void ParametersPanel::load()
{
    context().fileDialogs.askOpen(this, tr("Load settings"), tr("Configuration (*.json)"),
                                  [this](const QString& path) { loadFrom(path); });
}

void ParametersPanel::loadFrom(const QString& path)
{
    const auto configuration = loadConfiguration(path);
    if (!configuration) {
        tell(EventLog::Failure, errorText(configuration.error()));
        return;
    }
    m_model.revert(); // from here on the edits are those of the file
    QStringList absent;
    for (const auto& [number, raw] : configuration->parameters) {
        if (!m_model.device(number)) {
            absent << QCoreApplication::translate("Parameters", findParameter(int{number})->title);
            continue;
        }
        static_cast<void>(m_model.edit(number, raw));
    }
    m_calibrations = configuration->calibrations;
    QStringList sentences{
        plan().writes.empty()
            ? tr("%1 says what is in the controller already.").arg(QFileInfo(path).fileName())
            : tr("%1 is filled in; nothing is written before Apply.")
                  .arg(QFileInfo(path).fileName())};
    if (!absent.isEmpty()) {
        sentences << tr("Left out, since this controller does not have them: %1.")
                         .arg(absent.join(u", "_s));
    }
    if (const QString remark = remarkOn(*configuration); !remark.isEmpty()) {
        sentences << remark;
    }
    tell(sentences.size() > 1 ? EventLog::Warning : EventLog::Information, sentences.join(u' '));
    refresh();
}

} // namespace trex
