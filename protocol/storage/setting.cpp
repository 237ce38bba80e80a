// SPDX-License-Identifier: GPL-3.0-or-later
#include "protocol/storage/setting.h"

#include <QDir>
#include <QFile>
#include <QFileInfo>
#include <QSettings>
#include <QStandardPaths>

namespace trex {
namespace {

constexpr qint64 kLargestFile = qint64{4} * 1024 * 1024; // a settings file has some kilobytes

QString ownPath()
{
    return QStandardPaths::writableLocation(QStandardPaths::GenericConfigLocation)
        + QStringLiteral("/trexpanel/trexpanel.ini");
}

bool isIniLine(const QByteArray& line)
{
    const QByteArray text = line.trimmed();
    return text.isEmpty() || text.startsWith(';') || text.startsWith('#') || text.contains('=')
        || (text.startsWith('[') && text.endsWith(']'));
}

/// What is wrong with the file, if anything: a file that is not there is an empty one.
std::optional<Error> examine(const QString& path)
{
    const QFileInfo info(path);
    if (!info.exists() && !info.isSymLink()) {
        return std::nullopt;
    }
    QFile file(path);
    // Only plain files: a pipe or a device could be read for ever.
    if (!info.isFile() || !file.open(QIODevice::ReadOnly)) {
        return Error{ErrorCode::FileUnreadable, path};
    }
    if (file.size() > kLargestFile) {
        return Error{ErrorCode::FileMalformed, path};
    }
    int number = 0;
    const QList<QByteArray> lines = file.readAll().split('\n');
    for (const QByteArray& line : lines) {
        ++number;
        if (line.contains('\0') || !isIniLine(line)) {
            return Error{ErrorCode::FileMalformed,
                         QStringLiteral("%1:%2").arg(path, QString::number(number))};
        }
    }
    return std::nullopt;
}

/// Moves a damaged file to FILE.damaged (or .damaged.2 and so on); true when it is out of the way.
bool keepAside(const QString& path)
{
    constexpr int kMostKept = 100;
    for (int number = 1; number <= kMostKept; ++number) {
        const QString name = number == 1 ? path + QStringLiteral(".damaged")
                                         : path + QStringLiteral(".damaged.%1").arg(number);
        if (!QFileInfo::exists(name)) {
            return QFile::rename(path, name);
        }
    }
    return false;
}

} // namespace

SettingsFile::SettingsFile(const QString& path) : m_path(path.isEmpty() ? ownPath() : path)
{
    m_problem = examine(m_path);
    if (m_problem && (m_problem->code == ErrorCode::FileUnreadable || !keepAside(m_path))) {
        return; // never write over what could not be read
    }
    QDir().mkpath(QFileInfo(m_path).absolutePath());
    m_settings = std::make_unique<QSettings>(m_path, QSettings::IniFormat);
    m_settings->setAtomicSyncRequired(true);
    m_settings->sync();
    if (m_settings->status() == QSettings::FormatError) {
        m_problem = Error{ErrorCode::FileMalformed, m_path};
        m_settings.reset();
        if (keepAside(m_path)) {
            m_settings = std::make_unique<QSettings>(m_path, QSettings::IniFormat);
        }
    }
}

SettingsFile::~SettingsFile() = default;

QString SettingsFile::path() const
{
    return m_path;
}

QVariant SettingsFile::variant(const QString& key, const QVariant& fallback) const
{
    return m_settings ? m_settings->value(key, fallback) : fallback;
}

void SettingsFile::setVariant(const QString& key, const QVariant& value)
{
    if (m_settings && m_settings->value(key) != value) {
        m_settings->setValue(key, value);
    }
}

void SettingsFile::sync()
{
    if (m_settings) {
        m_settings->sync();
    }
}

} // namespace trex
