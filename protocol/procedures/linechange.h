// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "protocol/procedures/scan.h"
#include "protocol/session/devicesettings.h"

#include <QTimer>

#include <map>

namespace trex {

/// A change of the line itself: 0x7E, 0x7D, or a factory reset is stored, and in force after the
/// next power cycle. Watches the settings, says what to do, waits until the controller falls
/// silent, connects with the new settings, else with the old ones, else searches. It never arms.
/// A device number (0x00) acts at once and needs none of this: the link follows it by itself.
/// Main thread.
class LineChange : public QObject {
    Q_OBJECT
    Q_DISABLE_COPY_MOVE(LineChange)

public:
    enum class Phase : std::uint8_t {
        None,
        Waiting, ///< for the power cycle; the old line still works
        Reconnecting, ///< trying the new settings and the old
        Recovering, ///< neither answered: searching
    };
    struct Times {
        std::chrono::milliseconds pause{500}; ///< between two attempts
        std::chrono::milliseconds patience{30'000}; ///< of attempts before the search
        std::chrono::milliseconds simulator{3'000}; ///< for one of the simulator's connections
    };

    LineChange(Controller& controller, DeviceSettings& settings, QObject* parent = nullptr);

    [[nodiscard]] Phase phase() const { return m_phase; }
    [[nodiscard]] const LineSettings& wanted() const { return m_wanted; }
    /// What goes on, or how it ended, for people; "" when there is nothing to say.
    [[nodiscard]] QString text() const { return m_text; }
    /// True while it uses the port without the controller being connected.
    [[nodiscard]] bool isBusy() const;
    void setTimes(const Times& times) { m_times = times; }

public slots:
    void reconnectNow(); ///< does not wait for the silence
    void recoverNow(); ///< does not wait for the attempts
    void cancel(); ///< stays where it is, says nothing; nothing more happens by itself

signals:
    void changed(); ///< phase or text
    /// For the log. `severity` as in Controller::eventLogged().
    void said(int severity, const QString& text);

private:
    void onSettings(int number);
    void notice();
    void onState(LinkState state);
    void onConnected();
    void begin();
    void attempt();
    void trySimulator(const LineSettings& line);
    void onAttempt(const Result<void>& result);
    void recover();
    void onRecovered(const Result<void>& result);
    void openLine(const LineSettings& line);
    void startScan(const ScanOptions& options, void (LineChange::*ended)(const Result<void>&));
    void dropScan();
    void enter(Phase phase, const QString& text);
    void end(int severity, const QString& text);
    [[nodiscard]] LineSettings storedLine() const;
    [[nodiscard]] bool isSimulator() const;

    Controller& m_controller;
    DeviceSettings& m_settings;
    Times m_times;
    Phase m_phase = Phase::None;
    QString m_text;
    QString m_port;
    LineSettings m_old;
    LineSettings m_wanted;
    std::map<std::uint8_t, int> m_first; ///< as first read in this connection
    bool m_isChecking = false; ///< a changed value is read once more
    Scan* m_scan = nullptr; ///< a child while it runs
    QTimer m_next; ///< of the attempts
    QTimer m_patience;
    bool m_isOpening = false; ///< the connection being made is ours
    bool m_isClosing = false; ///< the one being closed was closed by us
    bool m_triedOld = false; ///< of the simulator
};

} // namespace trex
