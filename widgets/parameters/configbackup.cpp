// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/parameters/configbackup.h"

#include "widgets/common/uisettings.h"

#include <QDir>
#include <QFileInfo>
#include <QStandardPaths>

using namespace Qt::Literals::StringLiterals;

namespace trex {

QString backupFolder(UiSettings& settings)
{
    const QString folder = QFileInfo(settings.file().path()).absolutePath();
    const QString own = QStandardPaths::writableLocation(QStandardPaths::GenericConfigLocation);
    const bool isOwn = own.isEmpty() || folder == own || folder.startsWith(own + u'/');
    return isOwn ? QStandardPaths::writableLocation(QStandardPaths::AppDataLocation) + u"/backups"_s
                 : folder + u"/backups"_s;
}

Result<QString> backUpConfiguration(const Configuration& configuration, const QString& folder)
{
    if (!QDir().mkpath(folder)) {
        return fail(ErrorCode::FileUnwritable, folder);
    }
    const QString stem = u"%1/%2-%3"_s.arg(
        folder, configuration.signature.isEmpty() ? u"trex"_s : configuration.signature,
        configuration.saved.toUTC().toString(u"yyyy-MM-dd'T'HHmmss'Z'"_s));
    QString path = stem + u".json"_s;
    for (int i = 2; QFileInfo::exists(path); ++i) {
        path = u"%1-%2.json"_s.arg(stem).arg(i);
    }
    if (const auto saved = saveConfiguration(configuration, path); !saved) {
        return tl::make_unexpected(saved.error());
    }
    return path;
}

} // namespace trex
