// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/common/stateshape.h"

#include <QTimer>
#include <QWidget>

class QLabel;
class QPushButton;

namespace trex {

class Controller;
class EventLog;

/// One sentence that says why the motors do or do not move, and one button that is the next thing
/// to do about it. GUI thread.
class WhyLine : public QWidget {
    Q_OBJECT
    Q_DISABLE_COPY_MOVE(WhyLine)
    Q_PROPERTY(QString text READ text)

public:
    enum class Remedy { None, Connect, Disconnect, Arm, Disarm };

    WhyLine(Controller& controller, EventLog& log, QWidget* parent = nullptr);
    [[nodiscard]] QString text() const;

signals:
    void connectRequested();

protected:
    void paintEvent(QPaintEvent* event) override;

private:
    struct Reason {
        StateShape shape = StateShape::Off;
        QString sentence;
        Remedy remedy = Remedy::None;
    };
    [[nodiscard]] Reason reason() const;
    [[nodiscard]] Reason unconnectedReason() const;
    [[nodiscard]] Reason armedReason() const;
    [[nodiscard]] QString ordersText() const;
    void refresh();
    void onStopped();
    void onRemedy();

    Controller& m_controller;
    EventLog& m_log;
    QLabel* m_text;
    QPushButton* m_remedy;
    QTimer m_stoppedFor; ///< runs while "stopped just now" is the reason
    QTimer m_lockout; ///< runs while arming would be refused
    Reason m_reason;
    bool m_wasConnected = false; ///< on this line: losing it is another thing than not finding it
};

} // namespace trex
