// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/recording/recordingmenu.h"

#include "widgets/common/filedialogs.h"
#include "widgets/common/theme.h"
#include "widgets/common/uisettings.h"
#include "widgets/recording/recordings.h"

#include <QAction>
#include <QActionGroup>
#include <QDesktopServices>
#include <QDir>
#include <QMenu>
#include <QUrl>

namespace trex {

using namespace Qt::Literals::StringLiterals;

QString recordingFilter()
{
    return RecordingActions::tr("Recordings (*.trexrec);;All files (*)");
}

RecordingActions::RecordingActions(PanelContext& context, Recordings& recordings, QWidget* window)
    : QObject(window), m_context(context), m_recordings(recordings), m_window(window)
{
    makeRecording();
    makeFiles();
    makeChoices();
    connect(&recordings, &Recordings::changed, this, &RecordingActions::refresh);
    connect(&context.settings, &UiSettings::changed, this, &RecordingActions::refresh);
    refresh();
}

QAction* RecordingActions::make(const QString& part, const QString& text, const QString& icon)
{
    auto* action = new QAction(icon.isEmpty() ? QIcon() : theme::icon(icon), text, this);
    action->setObjectName(u"action."_s + part);
    m_actions << action;
    return action;
}

void RecordingActions::makeRecording()
{
    m_record = make(u"record"_s, tr("&Record"), u"record"_s);
    m_record->setCheckable(true);
    m_record->setShortcut(QKeySequence(Qt::CTRL | Qt::Key_R));
    connect(m_record, &QAction::triggered, this, [this](bool wanted) {
        wanted ? m_recordings.start() : m_recordings.stop();
        refresh();
    });
    QAction* recordAs = make(u"recordAs"_s, tr("Record to a &file…"), {});
    connect(recordAs, &QAction::triggered, this, [this] {
        m_context.fileDialogs.askSave(m_window, tr("Record to a file"), u"run.trexrec"_s,
                                      recordingFilter(),
                                      [this](const QString& path) { m_recordings.startAs(path); });
    });
    QAction* keep = make(u"keepLast"_s, tr("&Keep the last minutes"), u"save"_s);
    keep->setToolTip(tr("Writes what was seen in the last minutes to a file of its own, now."));
    connect(keep, &QAction::triggered, &m_recordings, &Recordings::keepLastMinutes);
    m_actions << nullptr;
}

void RecordingActions::askOpen(const QString& title,
                               void (RecordingActions::*chosen)(const QString&))
{
    m_context.fileDialogs.askOpen(
        m_window, title, recordingFilter(),
        [this, chosen](const QString& path) { emit(this->*chosen)(path); });
}

void RecordingActions::makeFiles()
{
    QAction* open = make(u"openRecording"_s, tr("&Open recording…"), u"load"_s);
    open->setShortcut(QKeySequence::Open);
    connect(open, &QAction::triggered, this,
            [this] { askOpen(tr("Open a recording"), &RecordingActions::openRequested); });
    QAction* compare = make(u"compareRecording"_s, tr("&Compare with recording…"), {});
    compare->setToolTip(tr("Draws another recording behind the curves of the plots."));
    connect(compare, &QAction::triggered, this, [this] {
        askOpen(tr("Compare with a recording"), &RecordingActions::compareRequested);
    });
    QAction* show = make(u"showRecordings"_s, tr("Show the folder of &recordings"), {});
    connect(show, &QAction::triggered, this, [this] {
        QDir().mkpath(m_recordings.folder());
        QDesktopServices::openUrl(QUrl::fromLocalFile(m_recordings.folder()));
    });
    m_actions << nullptr;
}

void RecordingActions::makeChoices()
{
    const auto choice = [this](const QString& part, const QString& text,
                               const Setting<bool>& setting) {
        QAction* action = make(part, text, {});
        action->setCheckable(true);
        action->setChecked(m_context.settings.value(setting));
        connect(action, &QAction::toggled, this,
                [this, setting](bool on) { m_context.settings.set(setting, on); });
        return action;
    };
    choice(u"record.packets"_s, tr("Record every &packet, too"), settings::kRecordingPackets);
    choice(u"flightRecorder"_s, tr("Keep the last minutes at a fault, a stop or a lost &link"),
           settings::kFlightEnabled)
        ->setToolTip(tr("The flight recorder: %1")
                         .arg(QDir::toNativeSeparators(m_recordings.flightFolder())));
    makeLength();
    makeFolder(u"recordingFolder"_s, tr("F&older for recordings…"), settings::kRecordingFolder,
               &Recordings::folder);
    makeFolder(u"flightFolder"_s, tr("Folder for the last &minutes…"), settings::kFlightFolder,
               &Recordings::flightFolder);
}

void RecordingActions::makeLength()
{
    constexpr std::array kOffered{1, 2, 5, 10, 20, Recordings::kMostFlightMinutes};
    QAction* action = make(u"flightMinutes"_s, tr("Le&ngth of the last minutes"), {});
    auto* menu = new QMenu(m_window);
    auto* group = new QActionGroup(menu);
    for (const int minutes : kOffered) {
        QAction* choice = menu->addAction(tr("%n minute(s)", nullptr, minutes));
        choice->setObjectName(u"action.flightMinutes.%1"_s.arg(minutes));
        choice->setCheckable(true);
        choice->setChecked(m_recordings.flightMinutes() == minutes);
        group->addAction(choice);
        connect(choice, &QAction::triggered, this,
                [this, minutes] { m_context.settings.set(settings::kFlightMinutes, minutes); });
    }
    action->setMenu(menu);
}

void RecordingActions::makeFolder(const QString& part, const QString& text,
                                  const Setting<QString>& setting,
                                  QString (Recordings::*folder)() const)
{
    QAction* action = make(part, text, {});
    connect(action, &QAction::triggered, this, [this, text, setting, folder] {
        m_context.fileDialogs.askFolder(
            m_window, QString(text).remove(u'&'), (m_recordings.*folder)(),
            [this, setting](const QString& path) { m_context.settings.set(setting, path); });
    });
}

void RecordingActions::addTo(QMenu& menu) const
{
    menu.setToolTipsVisible(true);
    for (QAction* action : m_actions) {
        if (action == nullptr) {
            menu.addSeparator();
        } else {
            menu.addAction(action);
        }
    }
}

void RecordingActions::refresh()
{
    const bool isRecording = m_recordings.isRecording();
    m_record->setChecked(isRecording);
    m_record->setIcon(theme::icon(u"record"_s, isRecording ? ColourRole::Fault : ColourRole::Text));
    m_record->setText(isRecording ? tr("End &recording") : tr("&Record"));
    m_record->setToolTip(
        isRecording
            ? tr("Ends the recording %1.").arg(QDir::toNativeSeparators(m_recordings.path()))
            : tr("Records everything from now on to a file in %1.")
                  .arg(QDir::toNativeSeparators(m_recordings.folder())));
}

} // namespace trex
