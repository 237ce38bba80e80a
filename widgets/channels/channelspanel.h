// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "protocol/codec/polltable.h"
#include "widgets/common/panel.h"

#include <array>

class QGridLayout;
class QLabel;
class QPushButton;

namespace trex {

class ChannelBar;

/// The five input channels, live: raw and remapped values over their calibration. Asks for channels
/// while it is visible. GUI thread.
class ChannelsPanel : public Panel {
    Q_OBJECT

public:
    static constexpr double kHertz =
        50.0; ///< the controller's own rate (command documentation, 0x86)

    explicit ChannelsPanel(PanelContext& panelContext, QWidget* parent = nullptr);
    ~ChannelsPanel() override;
    Q_DISABLE_COPY_MOVE(ChannelsPanel)

protected:
    void showEvent(QShowEvent* event) override;
    void hideEvent(QHideEvent* event) override;
    void changeEvent(QEvent* event) override;

private:
    struct Row {
        QLabel* number = nullptr;
        QLabel* role = nullptr;
        QLabel* learned = nullptr;
        QLabel* text = nullptr;
        ChannelBar* bar = nullptr;
        QLabel* remapped = nullptr;
    };
    void addRow(QGridLayout* grid, int channel);
    void applyTheme();
    void updateWish();
    void updateDevice(); ///< input kind, learned marks, calibrations
    void readCalibrations();
    void updateValues();
    void updateRow(int channel, const PollSample* raw, const PollSample* remapped);

    std::array<Row, kChannelCount> m_rows;
    QLabel* m_input;
    QPushButton* m_calibrate;
    int m_readsPending = 0;
    quint64 m_shownRevision = 0;
    bool m_wasFresh = false;
};

} // namespace trex
