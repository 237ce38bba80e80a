// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QDialog>

class QCheckBox;
class QLabel;
class QTreeWidget;

namespace trex {

class Controller;

/// One setting of a file that says otherwise than the controller.
struct FileDifference {
    QString key; ///< "serial-timeout", "calibration.rc.1"
    QString title;
    QString inController;
    QString inFile;
};

/// What a loaded file would change, each to be taken or left. All are taken when it opens; leaving
/// one is told at once, so that nothing waits for this window. Not modal, with a STOP of its own.
/// Closing it (by Esc, too, which also stops the motors) keeps what is taken. GUI thread.
class DifferencesDialog : public QDialog {
    Q_OBJECT
    Q_DISABLE_COPY_MOVE(DifferencesDialog)

public:
    /// `remarks`: sentences about what of the file was adapted, unknown or left out.
    DifferencesDialog(Controller& controller, const QString& fileName, const QStringList& remarks,
                      const std::vector<FileDifference>& differences, QWidget* parent = nullptr);

signals:
    void taken(int index, bool isTaken); ///< place in `differences`

private:
    void takeAll(bool isTaken);
    void refreshCount();

    std::vector<QCheckBox*> m_boxes;
    QLabel* m_count;
};

} // namespace trex
