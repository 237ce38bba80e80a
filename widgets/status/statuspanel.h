// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "protocol/codec/replies.h"
#include "protocol/telemetry/statuslatch.h"
#include "widgets/common/panel.h"

#include <QTimer>

#include <vector>

class QGridLayout;
class QLabel;

namespace trex {

class Indicator;

/// Who is on the line, who drives the motors and why, and the latched bits of both bytes with how
/// often each was seen. GUI thread.
class StatusPanel : public Panel {
    Q_OBJECT

public:
    explicit StatusPanel(PanelContext& context, QWidget* parent = nullptr);

private:
    struct Lamp {
        StatusLatch::Byte byte;
        int bit;
        Indicator* indicator;
    };
    QLabel* addFact(QGridLayout& grid, const QString& title, const QString& name);
    void addLamps(QGridLayout& grid, int row);
    void refreshFacts();
    void refreshLamps();
    [[nodiscard]] QString controlText() const;

    QLabel* m_signature = nullptr;
    QLabel* m_firmware = nullptr;
    QLabel* m_mode = nullptr;
    QLabel* m_control = nullptr;
    QLabel* m_learned = nullptr;
    std::vector<Lamp> m_lamps;
    QTimer m_fade; ///< a lamp that was lit stays so for a moment: reads come ten times a second
};

/// "RC", "Analog", "Serial (RC)", "Serial (analog)".
[[nodiscard]] QString modeText(Mode mode);

} // namespace trex
