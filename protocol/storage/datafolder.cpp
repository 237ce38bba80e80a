// SPDX-License-Identifier: GPL-3.0-or-later
#include "protocol/storage/datafolder.h"

#include <QFileInfo>
#include <QStandardPaths>

using namespace Qt::Literals::StringLiterals;

namespace trex {

QString dataFolder(const QString& settingsPath)
{
    const QString folder = QFileInfo(settingsPath).absolutePath();
    const QString own = QStandardPaths::writableLocation(QStandardPaths::GenericConfigLocation);
    const bool isOwn = own.isEmpty() || folder == own || folder.startsWith(own + u'/');
    // Not the application's own location: trexpanel and trexctl share it.
    return isOwn
        ? QStandardPaths::writableLocation(QStandardPaths::GenericDataLocation) + u"/trexpanel"_s
        : folder;
}

QString journalPath(const QString& settingsPath)
{
    return dataFolder(settingsPath) + u"/journal.sqlite"_s;
}

} // namespace trex
