// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "protocol/storage/setting.h"
#include "widgets/common/panel.h"

class QAction;
class QMenu;

namespace trex {

class Recordings;

/// The actions around recordings, for the menu and the command bar: record, record to a file of
/// one's choice, keep the last minutes, what is recorded, and where. GUI thread.
class RecordingActions : public QObject {
    Q_OBJECT
    Q_DISABLE_COPY_MOVE(RecordingActions)

public:
    RecordingActions(PanelContext& context, Recordings& recordings, QWidget* window);
    void addTo(QMenu& menu) const;
    [[nodiscard]] QAction* record() const { return m_record; }

signals:
    void openRequested(const QString& path);
    void compareRequested(const QString& path);

private:
    QAction* make(const QString& part, const QString& text, const QString& icon);
    void makeRecording();
    void makeFiles();
    void makeChoices();
    void makeLength();
    void makeFolder(const QString& part, const QString& text, const Setting<QString>& setting,
                    QString (Recordings::*folder)() const);
    void refresh();
    void askOpen(const QString& title, void (RecordingActions::*chosen)(const QString&));

    PanelContext& m_context;
    Recordings& m_recordings;
    QWidget* m_window;
    QAction* m_record = nullptr;
    QList<QAction*> m_actions; ///< of the menu; null: a separator
};

/// What file dialogs offer: recordings, and everything.
[[nodiscard]] QString recordingFilter();

} // namespace trex
