// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "protocol/result.h"

#include <QString>
#include <QVariant>

#include <memory>
#include <optional>

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
/// silently.
class SettingsFile {
public:
    explicit SettingsFile(const QString& path = {}); ///< "": the person's own file
    ~SettingsFile();
    Q_DISABLE_COPY_MOVE(SettingsFile)

    [[nodiscard]] std::optional<Error> problem() const { return m_problem; }
    [[nodiscard]] QString path() const;
    [[nodiscard]] QVariant variant(const QString& key, const QVariant& fallback) const;
    void setVariant(const QString& key, const QVariant& value);
    void sync();

    template <class T>
    [[nodiscard]] T value(const Setting<T>& setting) const
    {
        const QVariant stored = variant(setting.key, QVariant::fromValue(setting.fallback));
        return stored.canConvert<T>() ? stored.value<T>() : setting.fallback;
    }
    template <class T>
    void set(const Setting<T>& setting, const T& value)
    {
        setVariant(setting.key, QVariant::fromValue(value));
    }

private:
    QString m_path;
    std::unique_ptr<QSettings> m_settings; ///< null: neither read nor written
    std::optional<Error> m_problem;
};

} // namespace trex
