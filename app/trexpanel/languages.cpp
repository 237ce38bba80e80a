// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/trexpanel/languages.h"

#include <QCoreApplication>
#include <QDir>
#include <QLibraryInfo>
#include <QLocale>

namespace trex {

using namespace Qt::Literals::StringLiterals;

namespace {

constexpr QLatin1StringView kEnglish = "en"_L1;

/// The first language of the system's list that there is.
QString systemChoice()
{
    const QStringList wishes = QLocale::system().uiLanguages();
    for (const QString& wish : wishes) {
        QString code = wish.section(u'-', 0, 0);
        if (Languages::isAvailable(code)) {
            return code;
        }
    }
    return kEnglish;
}

} // namespace

QList<Languages::Language> Languages::available()
{
    QList<Language> languages{{kEnglish, u"English"_s}};
    const QStringList files =
        QDir(u":/i18n"_s).entryList({u"trex_*.qm"_s}, QDir::Files, QDir::Name);
    for (const QString& file : files) {
        const QString code = file.section(u'_', 1).section(u'.', 0, 0);
        if (code == kEnglish) {
            continue;
        }
        QString name = QLocale(code).nativeLanguageName();
        if (!name.isEmpty()) {
            name[0] = name[0].toUpper();
        }
        languages.append({code, name.isEmpty() ? code : name});
    }
    return languages;
}

bool Languages::isAvailable(const QString& code)
{
    const QList<Language> languages = available();
    return std::any_of(languages.begin(), languages.end(),
                       [&code](const Language& language) { return language.first == code; });
}

void Languages::use(const QString& code)
{
    QCoreApplication::removeTranslator(&m_ours);
    QCoreApplication::removeTranslator(&m_qt);
    m_inUse = code.isEmpty() || !isAvailable(code) ? systemChoice() : code;
    if (m_qt.load(u"qtbase_"_s + m_inUse, QLibraryInfo::path(QLibraryInfo::TranslationsPath))
        || m_qt.load(u":/i18n/qtbase_"_s + m_inUse)) {
        QCoreApplication::installTranslator(&m_qt);
    }
    if (m_ours.load(u":/i18n/trex_"_s + m_inUse)) {
        QCoreApplication::installTranslator(&m_ours);
    }
}

} // namespace trex
