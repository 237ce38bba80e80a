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
/// Ceiling of the session's history in memory, in MiB: half a week of everything.
inline const Setting<int> kHistoryMiB{QStringLiteral("telemetry/memory"), 512};
inline constexpr int kLeastHistoryMiB = 32; ///< hours, and more than the flight recorder keeps
inline const Setting<int> kPlotWindowSeconds{QStringLiteral("currents/window"), 10};
inline const Setting<int> kPlotsWindowSeconds{QStringLiteral("plots/window"), 10};
inline const Setting<QByteArray> kPlotsLayout{QStringLiteral("plots/layout"),
                                              QByteArray()}; ///< JSON, plotlayout.h
inline const Setting<QString> kRecordingFolder{QStringLiteral("recording/folder"),
                                               QString()}; ///< "": among the documents
inline const Setting<bool> kRecordingPackets{QStringLiteral("recording/packets"), false};
inline const Setting<bool> kFlightEnabled{QStringLiteral("flight/enabled"), true};
inline const Setting<QString> kFlightFolder{QStringLiteral("flight/folder"),
                                            QString()}; ///< "": in the data folder
inline const Setting<int> kFlightMinutes{QStringLiteral("flight/minutes"), 5};
// What closes the motor gate, and what the motion limits are (safetysettings.h).
inline const Setting<bool> kDisarmMotorFault{QStringLiteral("safety/motorFault"), true};
inline const Setting<bool> kDisarmOverCurrent{QStringLiteral("safety/overCurrent"), false};
inline const Setting<bool> kDisarmUartError{QStringLiteral("safety/uartError"), false};
inline const Setting<bool> kDisarmSerialTimeout{QStringLiteral("safety/serialTimeout"), true};
inline const Setting<bool> kDisarmHidden{QStringLiteral("safety/hidden"), true};
inline const Setting<bool> kDisarmLocked{QStringLiteral("safety/locked"), true};
inline const Setting<int> kIdleSeconds{QStringLiteral("safety/idleSeconds"), 600}; ///< 0: never
inline const Setting<int> kMaximum1{QStringLiteral("motion/maximum1"), 127};
inline const Setting<int> kMaximum2{QStringLiteral("motion/maximum2"), 127};
inline const Setting<int> kMaximumAux{QStringLiteral("motion/maximumAux"), 127};
inline const Setting<int> kSoftStart{QStringLiteral("motion/softStart"), 0}; ///< steps a second
inline const Setting<int> kSoftStop{QStringLiteral("motion/softStop"), 0};
inline const Setting<int> kStallMilliamperes{QStringLiteral("motion/stallMilliamperes"), 0};
inline const Setting<int> kStallMs{QStringLiteral("motion/stallMs"), 500};
inline const Setting<int> kSliderStep{QStringLiteral("motion/sliderStep"), 8};
inline const Setting<int> kHoldSpeed{QStringLiteral("motion/holdSpeed"), 40}; ///< of held keys
inline const Setting<bool> kHoldToRun{QStringLiteral("motion/holdToRun"), false};
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
