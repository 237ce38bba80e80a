// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "protocol/storage/setting.h"

#include <QByteArray>
#include <QObject>

namespace trex {

namespace settings {
// One line a stored value of the panel. The last line used is shared with trexctl:
// linesettingsstore.h.
inline const Setting<QString> kTheme{QStringLiteral("ui/theme"), QStringLiteral("system")};
inline const Setting<QString> kLanguage{QStringLiteral("ui/language"),
                                        QString()}; ///< "": the system's
inline const Setting<int> kScalePercent{QStringLiteral("ui/scale"), 0}; ///< 0: the system's
inline const Setting<QByteArray> kGeometry{QStringLiteral("ui/geometry"), QByteArray()};
inline const Setting<QByteArray> kLayout{QStringLiteral("ui/layout"), QByteArray()};
inline const Setting<int> kPlotWindowSeconds{QStringLiteral("currents/window"), 10};
inline const Setting<int> kPlotsWindowSeconds{QStringLiteral("plots/window"), 10};
inline const Setting<QByteArray> kPlotsLayout{QStringLiteral("plots/layout"),
                                              QByteArray()}; ///< JSON, plotlayout.h
} // namespace settings

/// The panel's stored settings. GUI thread.
class UiSettings : public QObject {
    Q_OBJECT
    Q_DISABLE_COPY_MOVE(UiSettings)

public:
    explicit UiSettings(SettingsFile& file, QObject* parent = nullptr)
        : QObject(parent), m_file(file)
    {
    }
    template <class T>
    [[nodiscard]] T value(const Setting<T>& setting) const
    {
        return m_file.value(setting);
    }
    template <class T>
    void set(const Setting<T>& setting, const T& value)
    {
        m_file.set(setting, value);
        emit changed(setting.key);
    }
    [[nodiscard]] SettingsFile& file() { return m_file; }

signals:
    void changed(const QString& key);

private:
    SettingsFile& m_file;
};

} // namespace trex
