// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "protocol/procedures/channelcalibration.h"

#include <QObject>

#include <array>

class QCheckBox;
class QGridLayout;
class QLabel;
class QPushButton;
class QWidget;

namespace trex {

class ChannelBar;
class StateMark;

/// One channel's line of the wizard: its choice, live bar, state, and its numbers, new over old.
/// GUI thread.
class CalibrationRow : public QObject {
    Q_OBJECT

public:
    static constexpr int kColumns = 8; ///< use, bar, four numbers, state, detail
    static constexpr int kFirstNumber = 2;

    /// Places its widgets in row `line` of the grid; the widgets are children of `parent`.
    CalibrationRow(int channel, QGridLayout* grid, int line, QWidget* parent);

    void applyTheme();
    /// Bars or numbers, and what can be chosen.
    void applyStep(const ChannelCalibration& calibration);
    /// `raw`: the fresh reading; none: stale.
    void refresh(const ChannelCalibration& calibration, std::optional<int> raw);
    [[nodiscard]] QCheckBox* use() const { return m_use; }

signals:
    void useToggled(int channel, bool use);
    void reverseToggled(int channel, bool reverse);
    void againAsked(int channel); ///< its direction is to be found once more

private:
    struct Number {
        QWidget* cell = nullptr;
        QLabel* now = nullptr;
        QLabel* before = nullptr;
    };
    void addNumbers(QGridLayout* grid, int line, QWidget* parent);
    void showNumbers(const ChannelCalibration& calibration);
    void showBar(const ChannelCalibration& calibration, std::optional<int> raw);
    void showDirection(const ChannelCalibration& calibration);

    int m_channel;
    QCheckBox* m_use;
    ChannelBar* m_bar;
    std::array<Number, 4> m_numbers;
    StateMark* m_state;
    QCheckBox* m_reverse;
    QPushButton* m_again;
    QLabel* m_detail;
};

} // namespace trex
