// SPDX-License-Identifier: GPL-3.0-or-later
// The parameters panel's dealings with files, with the factory's values, and with a panel that
// takes its place.
#include "protocol/errortext.h"
#include "protocol/session/controller.h"
#include "protocol/storage/configadapt.h"
#include "widgets/common/eventlog.h"
#include "widgets/common/filedialogs.h"
#include "widgets/parameters/comparison.h"
#include "widgets/parameters/differencesdialog.h"
#include "widgets/parameters/factoryresetdialog.h"
#include "widgets/parameters/parameterspanel.h"

#include <QCoreApplication>
#include <QFileInfo>

#include <algorithm>

using namespace Qt::Literals::StringLiterals;

namespace trex {
namespace {

constexpr auto kDraft = "parametersDraft"; ///< dynamic property: unapplied edits, a configuration

} // namespace

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
    const auto loaded = loadConfiguration(path);
    if (!loaded) {
        tell(EventLog::Failure, errorText(loaded.error()));
        return;
    }
    const auto& signature = context().controller.device().signature;
    const auto [configuration, notes] =
        signature ? adaptedTo(*signature, *loaded) : AdaptedConfiguration{*loaded, {}};
    closeDifferences();
    m_model.revert(); // from here on the edits are those of the file
    QStringList absent;
    for (const auto& [number, raw] : configuration.parameters) {
        if (!m_model.device(number)) {
            absent << QCoreApplication::translate("Parameters", findParameter(int{number})->title);
            continue;
        }
        static_cast<void>(m_model.edit(number, raw));
    }
    takeCalibrations(configuration.calibrations);
    const QString name = QFileInfo(path).fileName();
    QStringList remarks;
    if (!absent.isEmpty()) {
        remarks << tr("Left out, since this controller does not have them: %1.")
                       .arg(absent.join(u", "_s));
    }
    remarks << notes;
    if (const QString remark = remarkOn(configuration); !remark.isEmpty()) {
        remarks << remark;
    }
    const auto planned = plan();
    const QString sentence = planned.writes.empty()
        ? tr("%1 says what is in the controller already.").arg(name)
        : tr("%1 is filled in; nothing is written before Apply.").arg(name);
    tell(remarks.isEmpty() ? EventLog::Information : EventLog::Warning,
         (QStringList(sentence) + remarks).join(u' '));
    refresh();
    if (!planned.writes.empty()) {
        showDifferences(name, remarks + planned.leftOut);
    }
}

/// Those that the controller is not known to hold already.
void ParametersPanel::takeCalibrations(std::map<InputKind, std::map<int, Calibration>> calibrations)
{
    for (auto& [input, channels] : calibrations) {
        std::erase_if(channels, [this, input = input](const auto& each) {
            return context().deviceSettings.calibration(input, each.first) == each.second;
        });
    }
    std::erase_if(calibrations, [](const auto& set) { return set.second.empty(); });
    m_calibrations = std::move(calibrations);
}

void ParametersPanel::showDifferences(const QString& fileName, const QStringList& remarks)
{
    const auto writes = plan().writes;
    std::vector<FileDifference> differences;
    for (const auto& write : writes) {
        FileDifference difference{write.key(), write.title(), {}, {}};
        if (write.row != nullptr) {
            difference.inController = write.rawFrom
                ? valueWithRaw(*write.row, *write.rawFrom, m_model.deviceContext(*write.row))
                : u"–"_s;
            difference.inFile = valueWithRaw(*write.row, write.rawTo, m_model.context(*write.row));
        } else {
            difference.inController =
                write.calibrationFrom ? calibrationText(*write.calibrationFrom) : u"–"_s;
            difference.inFile = calibrationText(write.calibrationTo);
        }
        differences.push_back(difference);
    }
    auto* const dialog =
        new DifferencesDialog(context().controller, fileName, remarks, differences, this);
    connect(dialog, &DifferencesDialog::taken, this, [this, writes](int index, bool isTaken) {
        takeDifference(writes.at(static_cast<std::size_t>(index)), isTaken);
    });
    dialog->show();
}

void ParametersPanel::takeDifference(const SettingWrite& difference, bool isTaken)
{
    if (difference.row != nullptr && isTaken) {
        static_cast<void>(m_model.edit(difference.row->number, difference.rawTo));
    } else if (difference.row != nullptr) {
        m_model.revert(difference.row->number);
    } else if (isTaken) {
        m_calibrations[difference.input][difference.channel] = difference.calibrationTo;
    } else {
        auto& channels = m_calibrations[difference.input];
        channels.erase(difference.channel);
        if (channels.empty()) {
            m_calibrations.erase(difference.input);
        }
    }
    refresh();
}

void ParametersPanel::closeDifferences()
{
    if (auto* const dialog = findChild<DifferencesDialog*>()) {
        dialog->setObjectName({}); // until it is gone, the name is free for another
        dialog->accept();
    }
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

void ParametersPanel::askFactoryReset()
{
    const auto open = findChildren<FactoryResetDialog*>();
    if (std::ranges::any_of(open, &QWidget::isVisible)) {
        return;
    }
    auto* const dialog = new FactoryResetDialog(context().controller, this);
    connect(dialog, &QDialog::accepted, this, &ParametersPanel::factoryReset);
    dialog->show();
}

void ParametersPanel::factoryReset()
{
    if (const QString reason = blockReason(); !reason.isEmpty()) {
        tell(EventLog::Failure, tr("Nothing is reset. %1").arg(reason));
        return;
    }
    if (!isComplete(presentConfiguration(context().controller, context().deviceSettings))) {
        m_afterRead = [this] { factoryReset(); };
        readAll();
        return;
    }
    const auto backup = backUpNow();
    if (!backup) {
        tell(EventLog::Failure,
             tr("Nothing is reset, because the present settings could not be saved first: %1")
                 .arg(errorText(backup.error())));
        return;
    }
    context().deviceSettings.factoryReset(
        this, [this, path = *backup](const Result<void>& reset) { onFactoryReset(reset, path); });
}

void ParametersPanel::onFactoryReset(const Result<void>& reset, const QString& backup)
{
    if (!reset) {
        tell(EventLog::Failure,
             tr("Resetting all parameters: %1 The settings are saved in %2.")
                 .arg(errorText(reset.error()), backup));
        return;
    }
    offerToPutBack({});
    tell(EventLog::Warning,
         tr("The controller has taken the order to reset all parameters. Switch its power off and "
            "on; then it answers at 19200 baud without error detection, device number 7. The "
            "settings before are saved in %1.")
             .arg(backup));
    m_afterPowerCycle = tr("All parameters were ordered to be reset before the restart; the table "
                           "shows what the controller holds now. The settings before are saved in "
                           "%1.")
                            .arg(backup);
}

/// A change of language makes the window anew over the same settings, before the old one is gone:
/// edits go with it.
void ParametersPanel::keepDraft()
{
    Configuration draft;
    draft.parameters = m_model.edits();
    draft.calibrations = m_calibrations;
    if (draft == m_draft) {
        return;
    }
    m_draft = draft;
    context().deviceSettings.setProperty(
        kDraft, draft == Configuration{} ? QVariant() : writeConfiguration(draft));
}

void ParametersPanel::takeDraft()
{
    const QByteArray kept = context().deviceSettings.property(kDraft).toByteArray();
    if (kept.isEmpty()) {
        return;
    }
    const auto draft = parseConfiguration(kept, QString::fromLatin1(kDraft));
    if (!draft) {
        return; // not of our making: nothing to take
    }
    for (const auto& [number, raw] : draft->parameters) {
        static_cast<void>(m_model.edit(number, raw));
    }
    m_calibrations = draft->calibrations;
}

} // namespace trex
