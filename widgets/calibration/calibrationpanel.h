// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "protocol/procedures/calibrationfeed.h"
#include "widgets/common/panel.h"

namespace trex {

class CalibrationWizard;

/// Guided calibration of the five input channels. Has the raw channels polled while it is visible
/// or collects. GUI thread.
class CalibrationPanel : public Panel {
    Q_OBJECT

public:
    explicit CalibrationPanel(PanelContext& panelContext, QWidget* parent = nullptr);
    ~CalibrationPanel() override;
    Q_DISABLE_COPY_MOVE(CalibrationPanel)

protected:
    void showEvent(QShowEvent* event) override;
    void hideEvent(QHideEvent* event) override;

private:
    void updateWish();
    void refresh();
    void onFinished(const Result<void>& result);
    void showHistory();

    ChannelCalibration m_calibration;
    StoreFeed m_feed;
    CalibrationWizard* m_wizard;
};

} // namespace trex
