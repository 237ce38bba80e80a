// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "protocol/session/motionreason.h"
#include "widgets/common/stateshape.h"

#include <QElapsedTimer>
#include <QTimer>
#include <QWidget>

class QLabel;
class QPushButton;

namespace trex {

struct PanelContext;

/// One sentence that says why the motors do or do not move, and one button that is the next thing
/// to do about it. Gathers what is known; motionreason.cpp makes the sentence. GUI thread.
class WhyLine : public QWidget {
    Q_OBJECT
    Q_DISABLE_COPY_MOVE(WhyLine)
    Q_PROPERTY(QString text READ text)

public:
    explicit WhyLine(PanelContext& context, QWidget* parent = nullptr);
    [[nodiscard]] QString text() const;

signals:
    void connectRequested();
    void panelRequested(const QString& id);

protected:
    void paintEvent(QPaintEvent* event) override;

private:
    [[nodiscard]] MotionFacts facts() const;
    void addDeviceFacts(MotionFacts& facts) const;
    void listen();
    void refresh();
    void doubtStop(bool doubtful);
    void onRemedy();

    PanelContext& m_context;
    QLabel* m_text;
    QPushButton* m_remedy;
    QTimer m_stoppedFor; ///< runs while "stopped just now" is worth telling
    QTimer m_lockout; ///< runs while arming would be refused
    QTimer m_look; ///< what comes in samples is looked at a few times a second
    QElapsedTimer m_sinceOrder;
    MotionReason m_reason;
    bool m_wasConnected = false; ///< on this line
    bool m_isStopDoubtful = false; ///< a stop failed, and none has been sent since
};

} // namespace trex
