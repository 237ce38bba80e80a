// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "protocol/session/devicesettings.h"
#include "protocol/storage/journal.h"

#include <QDialog>

#include <vector>

class QLabel;
class QPushButton;
class QTreeWidget;

namespace trex {

class ChannelCalibration;
class WriteAudit;

/// What was ever written as a calibration to this controller's input set, from the journal, and a
/// way back to it: written, read back and journalled like any other. Not modal, with a STOP of its
/// own. GUI thread.
class CalibrationHistory : public QDialog {
    Q_OBJECT
    Q_DISABLE_COPY_MOVE(CalibrationHistory)

public:
    CalibrationHistory(Controller& controller, DeviceSettings& settings, WriteAudit& audit,
                       const ChannelCalibration& calibration, QWidget* parent = nullptr);

signals:
    void restored(const QString& sentence); ///< for the log

private:
    void build();
    void load(); ///< from the journal, anew
    void addEntry(const JournalEntry& entry);
    void refresh();
    void restore(bool isBefore);
    void onRestored(int channel, const Result<DeviceSettings::CalibrationWrite>& result);
    [[nodiscard]] QString whyNot() const; ///< why nothing can be restored now
    [[nodiscard]] const JournalEntry* chosen() const;
    /// The values of an entry that a button writes; none: not known.
    [[nodiscard]] static std::optional<Calibration> valuesOf(const JournalEntry& entry,
                                                             bool isBefore);

    Controller& m_controller;
    DeviceSettings& m_settings;
    WriteAudit& m_audit;
    const ChannelCalibration& m_calibration;
    std::vector<JournalEntry> m_entries; ///< as listed, newest first
    QLabel* m_title = nullptr;
    QTreeWidget* m_list = nullptr;
    QLabel* m_text = nullptr;
    QPushButton* m_before = nullptr;
    QPushButton* m_after = nullptr;
    QString m_outcome; ///< of the latest restoring
    bool m_isRestoring = false;
};

} // namespace trex
