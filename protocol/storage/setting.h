// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "protocol/result.h"

#include <QString>
#include <QVariant>

#include <memory>
#include <optional>

class QObject;
class QSettings;

namespace trex {

/// One stored value: its key and what holds when nothing is stored.
template <class T>
struct Setting {
    QString key;
    T fallback;
};

/// The settings file of a person, or the one given by --settings. A damaged or unreadable file is
/// told (problem()) and treated as empty; it is kept aside as FILE.damaged and never overwritten
/// silently. A value of the wrong type is as if it were not there; what is not known is kept.
class SettingsFile {
public:
    explicit SettingsFile(const QString& path = {}); ///< "": the person's own file
    ~SettingsFile();
    Q_DISABLE_COPY_MOVE(SettingsFile)

    [[nodiscard]] std::optional<Error> problem() const { return m_problem; }
    [[nodiscard]] QString path() const;
    [[nodiscard]] QVariant variant(const QString& key, const QVariant& fallback) const;
    void setVariant(const QString& key, const QVariant& value);
    bool sync(); ///< false, and a problem: it cannot be written
    /// The problem, what holds now, and where the damaged file is; empty: there is none.
    [[nodiscard]] QString problemText() const;

    template <class T>
    [[nodiscard]] T value(const Setting<T>& setting) const
    {
        QVariant stored = variant(setting.key, QVariant::fromValue(setting.fallback));
        return isSound(stored, QMetaType::fromType<T>()) ? stored.value<T>() : setting.fallback;
    }
    template <class T>
    void set(const Setting<T>& setting, const T& value)
    {
        setVariant(setting.key, QVariant::fromValue(value));
    }

private:
    /// Converts it. "abc" is no number, and "perhaps" neither true nor false.
    [[nodiscard]] static bool isSound(QVariant& stored, QMetaType type);

    QString m_path;
    QString m_keptAs; ///< the damaged file's new name
    std::unique_ptr<QSettings> m_settings; ///< null: neither read nor written
    std::optional<Error> m_problem;
    std::unique_ptr<QObject> m_guard; ///< of m_settings: it goes first, and is told no more
    bool m_isChanged = false;
};

} // namespace trex
