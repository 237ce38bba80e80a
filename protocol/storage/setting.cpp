// SPDX-License-Identifier: GPL-3.0-or-later
#include "protocol/storage/setting.h"

#include "protocol/errortext.h"

#include <QCoreApplication>
#include <QDir>
#include <QEvent>
#include <QFile>
#include <QFileInfo>
#include <QObject>
#include <QSettings>
#include <QStandardPaths>
#include <QTemporaryFile>

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

/// Moves a damaged file to FILE.damaged (or .damaged.2 and so on); its name when it is out of the
/// way, else empty.
QString keepAside(const QString& path)
{
    constexpr int kMostKept = 100;
    for (int number = 1; number <= kMostKept; ++number) {
        const QString name = number == 1 ? path + QStringLiteral(".damaged")
                                         : path + QStringLiteral(".damaged.%1").arg(number);
        if (!QFileInfo::exists(name)) {
            return QFile::rename(path, name) ? name : QString();
        }
    }
    return {};
}

/// QSettings has QSaveFile's fault (savefile.h): it empties the file on a full disk. So room is
/// looked for before it may write.
bool hasRoom(const QString& path)
{
    constexpr qint64 kMore = qint64{64} * 1024; // longer than what a session adds
    QTemporaryFile probe(QFileInfo(path).absolutePath() + QStringLiteral("/.room-XXXXXX"));
    const QByteArray zeros(QFileInfo(path).size() + kMore, '\0');
    return probe.open() && probe.write(zeros) == zeros.size() && probe.flush();
}

/// Keeps QSettings from writing when it likes: only after a look whether there is room.
class WriteGuard : public QObject {
public:
    explicit WriteGuard(SettingsFile& file) : m_file(file) { }
    bool eventFilter(QObject* watched, QEvent* event) override
    {
        if (event->type() != QEvent::UpdateRequest) {
            return QObject::eventFilter(watched, event);
        }
        m_file.sync();
        return true;
    }

private:
    SettingsFile& m_file;
};

} // namespace

SettingsFile::SettingsFile(const QString& path) : m_path(path.isEmpty() ? ownPath() : path)
{
    m_problem = examine(m_path);
    if (m_problem && m_problem->code == ErrorCode::FileMalformed) {
        m_keptAs = keepAside(m_path);
    }
    if (m_problem && m_keptAs.isEmpty()) {
        return; // never write over what could not be read
    }
    const QString folder = QFileInfo(m_path).absolutePath();
    if (!m_problem && (!QDir().mkpath(folder) || !QFileInfo(folder).isWritable())) {
        m_problem = Error{ErrorCode::FileUnwritable, m_path};
    }
    m_settings = std::make_unique<QSettings>(m_path, QSettings::IniFormat);
    m_settings->setAtomicSyncRequired(true);
    m_settings->sync();
    if (m_settings->status() == QSettings::FormatError) {
        m_problem = Error{ErrorCode::FileMalformed, m_path};
        m_settings.reset();
        m_keptAs = keepAside(m_path);
        if (!m_keptAs.isEmpty()) {
            m_settings = std::make_unique<QSettings>(m_path, QSettings::IniFormat);
        }
    }
    if (m_settings) {
        m_guard = std::make_unique<WriteGuard>(*this);
        m_settings->installEventFilter(m_guard.get());
    }
}

SettingsFile::~SettingsFile()
{
    if (m_isChanged && !sync()) { // its destructor would write: what has no room is let go
        QCoreApplication::removePostedEvents(m_settings.get());
        static_cast<void>(m_settings.release());
    }
}

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
        m_isChanged = true;
        m_settings->setValue(key, value);
    }
}

bool SettingsFile::sync()
{
    if (!m_settings) {
        return false;
    }
    if (!m_isChanged) {
        return true;
    }
    if (hasRoom(m_path)) {
        m_settings->sync();
        if (m_settings->status() != QSettings::AccessError) {
            m_isChanged = false;
            return true;
        }
    }
    m_problem = Error{ErrorCode::FileUnwritable, m_path};
    return false;
}

bool SettingsFile::isSound(QVariant& stored, QMetaType type)
{
    if (type.id() == QMetaType::Bool && stored.typeId() != QMetaType::Bool) {
        const QString text = stored.toString();
        const bool isTrue = text == u"true" || text == u"1";
        const bool isKnown = isTrue || text == u"false" || text == u"0";
        stored = isTrue;
        return isKnown;
    }
    return stored.convert(type);
}

QString SettingsFile::problemText() const
{
    if (!m_problem) {
        return {};
    }
    const auto text = [](const char* words) {
        return QCoreApplication::translate("Settings", words);
    };
    if (!m_keptAs.isEmpty()) {
        return text(QT_TRANSLATE_NOOP("Settings",
                                      "The settings file makes no sense (%1). It is kept as %2, "
                                      "and the settings begin anew."))
            .arg(m_problem->context, m_keptAs);
    }
    return errorText(*m_problem) + u' '
        + text(QT_TRANSLATE_NOOP("Settings", "Settings of this session are not kept."));
}

} // namespace trex
