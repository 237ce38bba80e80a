// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/common/filedialogs.h"

#include <QFileDialog>
#include <QFileInfo>

namespace trex {

void FileDialogs::answerNext(const QString& path)
{
    m_answer = path;
}

bool FileDialogs::takeAnswerBack()
{
    const bool wasThere = m_answer.has_value();
    m_answer.reset();
    return wasThere;
}

void FileDialogs::askSave(QWidget* parent, const QString& title, const QString& suggestion,
                          const QString& filter, const Handler& handler)
{
    ask(parent, title, suggestion, filter, true, handler);
}

void FileDialogs::askOpen(QWidget* parent, const QString& title, const QString& filter,
                          const Handler& handler)
{
    ask(parent, title, {}, filter, false, handler);
}

void FileDialogs::askFolder(QWidget* parent, const QString& title, const QString& folder,
                            const Handler& handler)
{
    if (takeAnswer(parent, handler)) {
        return;
    }
    auto* dialog = new QFileDialog(parent, title, folder);
    dialog->setObjectName(QStringLiteral("dialog.folder"));
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    dialog->setOption(QFileDialog::DontUseNativeDialog);
    dialog->setFileMode(QFileDialog::Directory);
    connect(dialog, &QFileDialog::fileSelected, parent, handler);
    dialog->show();
}

/// Later, as a person's answer would come, and not at all when the asker is gone by then.
bool FileDialogs::takeAnswer(QWidget* parent, const Handler& handler)
{
    if (!m_answer) {
        return false;
    }
    QMetaObject::invokeMethod(
        parent, [handler, path = *m_answer] { handler(path); }, Qt::QueuedConnection);
    m_answer.reset();
    return true;
}

void FileDialogs::ask(QWidget* parent, const QString& title, const QString& suggestion,
                      const QString& filter, bool save, const Handler& handler)
{
    if (takeAnswer(parent, handler)) {
        return;
    }
    auto* dialog = new QFileDialog(parent, title, {}, filter);
    dialog->setObjectName(save ? QStringLiteral("dialog.save") : QStringLiteral("dialog.open"));
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    dialog->setOption(QFileDialog::DontUseNativeDialog); // Esc is seen, and scripts find it
    dialog->setAcceptMode(save ? QFileDialog::AcceptSave : QFileDialog::AcceptOpen);
    dialog->setFileMode(save ? QFileDialog::AnyFile : QFileDialog::ExistingFile);
    if (save) {
        dialog->setDefaultSuffix(QFileInfo(suggestion).suffix());
        dialog->selectFile(suggestion);
    }
    connect(dialog, &QFileDialog::fileSelected, parent, handler);
    dialog->show(); // not modal: STOP in the window behind stays within reach
}

} // namespace trex
