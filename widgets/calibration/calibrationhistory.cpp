// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/calibration/calibrationhistory.h"

#include "protocol/errortext.h"
#include "protocol/procedures/calibrationtext.h"
#include "protocol/procedures/channelcalibration.h"
#include "protocol/procedures/writeaudit.h"
#include "widgets/common/panel.h"
#include "widgets/common/stopbutton.h"
#include "widgets/common/theme.h"

#include <QDialogButtonBox>
#include <QHeaderView>
#include <QLabel>
#include <QLocale>
#include <QPushButton>
#include <QTreeWidget>
#include <QVBoxLayout>

#include <algorithm>

namespace trex {

using namespace Qt::Literals::StringLiterals;

namespace {

enum Column { DateColumn, ChannelColumn, BeforeColumn, AfterColumn, ResultColumn, ColumnCount };

QString numbersText(const std::optional<Calibration>& calibration, InputKind input)
{
    return calibration ? u"%1 / %2 / %3, ±%4"_s.arg(
               readingText(calibration->minimum, input), readingText(calibration->neutral, input),
               readingText(calibration->maximum, input), spanText(calibration->deadband, input))
                       : CalibrationHistory::tr("not known");
}

QString rawText(const std::optional<Calibration>& c)
{
    return c ? CalibrationHistory::tr("Raw: minimum %1, neutral %2, maximum %3, deadband %4")
                   .arg(c->minimum)
                   .arg(c->neutral)
                   .arg(c->maximum)
                   .arg(c->deadband)
             : QString();
}

} // namespace

CalibrationHistory::CalibrationHistory(Controller& controller, DeviceSettings& settings,
                                       WriteAudit& audit, const ChannelCalibration& calibration,
                                       QWidget* parent)
    : QDialog(parent)
    , m_controller(controller)
    , m_settings(settings)
    , m_audit(audit)
    , m_calibration(calibration)
{
    setObjectName(u"calibration.historyDialog"_s);
    setWindowTitle(tr("Calibration history"));
    setAttribute(Qt::WA_DeleteOnClose);
    build();
    connect(m_list, &QTreeWidget::currentItemChanged, this, &CalibrationHistory::refresh);
    connect(m_before, &QPushButton::clicked, this, [this] { restore(true); });
    connect(m_after, &QPushButton::clicked, this, [this] { restore(false); });
    connect(&audit, &WriteAudit::recorded, this, &CalibrationHistory::load);
    connect(&controller, &Controller::deviceChanged, this, &CalibrationHistory::load);
    connect(&calibration, &ChannelCalibration::stepChanged, this, &CalibrationHistory::refresh);
    load();
}

void CalibrationHistory::build()
{
    m_title = named(new QLabel(this), u"calibration.history.title"_s);
    m_title->setFont(theme::font(1.25));
    m_title->setWordWrap(true);
    m_list = named(new QTreeWidget(this), u"calibration.history.list"_s,
                   tr("Calibrations written before, newest first"));
    m_list->setColumnCount(ColumnCount);
    m_list->setHeaderLabels({tr("Date"), tr("Channel"), tr("Before"), tr("Written"), tr("Result")});
    m_list->setRootIsDecorated(false);
    m_list->setUniformRowHeights(true);
    m_list->setAlternatingRowColors(true);
    m_list->header()->setStretchLastSection(true);
    m_text = named(new QLabel(this), u"calibration.history.text"_s, tr("What can be restored"));
    m_text->setWordWrap(true);
    m_text->setTextFormat(Qt::PlainText);
    m_before = named(new QPushButton(tr("Restore the numbers before"), this),
                     u"calibration.history.restoreBefore"_s);
    m_after = named(new QPushButton(tr("Restore the written numbers"), this),
                    u"calibration.history.restore"_s);
    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Close, this);
    buttons->addButton(m_before, QDialogButtonBox::ActionRole);
    buttons->addButton(m_after, QDialogButtonBox::ActionRole);
    for (QPushButton* button : {m_before, m_after}) {
        button->setAutoDefault(false);
    }
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    auto* top = new QHBoxLayout;
    top->addWidget(m_title, 1);
    top->addWidget(named(new StopButton(m_controller, this), u"calibration.history.stop"_s), 0,
                   Qt::AlignTop);
    auto* layout = new QVBoxLayout(this);
    layout->addLayout(top);
    layout->addWidget(m_list, 1);
    layout->addWidget(m_text);
    layout->addWidget(buttons);
    resize(860, 420);
}

void CalibrationHistory::load()
{
    const qint64 before = chosen() != nullptr ? chosen()->number : 0;
    m_entries.clear();
    m_list->clear();
    const ControllerIdentity identity = m_audit.controller();
    const InputKind input = m_calibration.input();
    QString problem;
    for (int channel = 1; channel <= kChannelCount && m_controller.device().mode; ++channel) {
        const auto entries = m_audit.journal().calibrationHistory(identity, input, channel);
        if (!entries) {
            problem = errorText(entries.error());
            break;
        }
        m_entries.insert(m_entries.end(), entries->begin(), entries->end());
    }
    std::ranges::sort(m_entries, std::greater{}, &JournalEntry::number);
    for (const JournalEntry& entry : m_entries) {
        addEntry(entry);
    }
    for (int column = 0; column < ColumnCount - 1; ++column) {
        m_list->resizeColumnToContents(column);
    }
    const auto same = std::ranges::find(m_entries, before, &JournalEntry::number);
    const auto row = same == m_entries.end() ? 0 : same - m_entries.begin();
    m_list->setCurrentItem(m_list->topLevelItem(static_cast<int>(row)));
    const QString kind = input == InputKind::Rc ? tr("RC") : tr("analog");
    m_title->setText(!problem.isEmpty() ? problem
                         : m_entries.empty()
                         ? tr("No %1 calibration was written to this controller "
                              "by this program yet.")
                               .arg(kind)
                         : tr("%1 calibrations written to %2, device %3")
                               .arg(kind, identity.signature)
                               .arg(identity.device));
    refresh();
}

void CalibrationHistory::addEntry(const JournalEntry& entry)
{
    const InputKind input = entry.intent.setting.input;
    const auto before = valuesOf(entry, true);
    const auto after = valuesOf(entry, false);
    auto* item = new QTreeWidgetItem(m_list);
    item->setSizeHint(DateColumn, {0, m_list->fontMetrics().height() + 8});
    item->setText(DateColumn,
                  QLocale().toString(entry.time.toLocalTime(), u"yyyy-MM-dd HH:mm:ss"_s));
    item->setToolTip(DateColumn, tr("By %1, on %2").arg(entry.program, entry.controller.port));
    item->setText(ChannelColumn, QString::number(entry.intent.setting.channel));
    item->setText(BeforeColumn, numbersText(before, input));
    item->setToolTip(BeforeColumn, rawText(before));
    item->setText(AfterColumn, numbersText(after, input));
    item->setToolTip(AfterColumn, rawText(after));
    item->setText(ResultColumn, resultText(entry));
}

const JournalEntry* CalibrationHistory::chosen() const
{
    const auto row = m_list->indexOfTopLevelItem(m_list->currentItem());
    return row >= 0 && static_cast<std::size_t>(row) < m_entries.size()
        ? &m_entries.at(static_cast<std::size_t>(row))
        : nullptr;
}

std::optional<Calibration> CalibrationHistory::valuesOf(const JournalEntry& entry, bool isBefore)
{
    const auto value = isBefore ? entry.intent.before : entry.valueAfter();
    const auto* calibration = value ? std::get_if<Calibration>(&*value) : nullptr;
    return calibration != nullptr ? std::optional(*calibration) : std::nullopt;
}

QString CalibrationHistory::whyNot() const
{
    const auto& mode = m_controller.device().mode;
    if (m_controller.state() != LinkState::Connected || !mode) {
        return tr("Connect to the controller to restore.");
    }
    if (!isSerial(*mode)) {
        return tr("Settings can be written in serial mode only.");
    }
    return m_calibration.isRunning() ? tr("A calibration is running.") : QString();
}

void CalibrationHistory::refresh()
{
    const JournalEntry* entry = chosen();
    const QString reason = m_isRestoring ? tr("Writing, and reading back…") : whyNot();
    const bool isPossible = entry != nullptr && reason.isEmpty();
    m_before->setEnabled(isPossible && valuesOf(*entry, true).has_value());
    m_after->setEnabled(isPossible && valuesOf(*entry, false).has_value());
    m_text->setText(!reason.isEmpty()          ? reason
                        : !m_outcome.isEmpty() ? m_outcome
                                               : tr("Restoring writes the numbers of the chosen "
                                                    "line to its channel, and reads them back."));
}

void CalibrationHistory::restore(bool isBefore)
{
    const JournalEntry* entry = chosen();
    const auto values = entry != nullptr ? valuesOf(*entry, isBefore) : std::nullopt;
    if (!values || !whyNot().isEmpty()) {
        return;
    }
    const int channel = entry->intent.setting.channel;
    m_isRestoring = true;
    refresh();
    m_settings.writeCalibration(
        channel, *values, this,
        [this, channel](const Result<DeviceSettings::CalibrationWrite>& result) {
            onRestored(channel, result);
        });
}

void CalibrationHistory::onRestored(int channel,
                                    const Result<DeviceSettings::CalibrationWrite>& result)
{
    m_isRestoring = false;
    const QString numbers =
        result ? numbersText(result->readBack, m_calibration.input()) : QString();
    m_outcome = !result ? errorText(result.error())
        : result->verified
        ? tr("Channel %1 holds %2 again, read back.").arg(channel).arg(numbers)
        : tr("Channel %1 holds %2, the nearest that this controller can take, read back.")
              .arg(channel)
              .arg(numbers);
    refresh();
    emit restored(m_outcome);
}

} // namespace trex
