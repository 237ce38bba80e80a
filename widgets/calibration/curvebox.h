// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "protocol/procedures/channelcalibration.h"

#include <QWidget>

class QComboBox;
class QLabel;

namespace trex {

class ResponseCurveView;

/// The response of one channel beside the bars, and how sure one may be of it. The person chooses
/// the channel; while directions are asked for it follows. GUI thread.
class CurveBox : public QWidget {
    Q_OBJECT
    Q_DISABLE_COPY_MOVE(CurveBox)

public:
    explicit CurveBox(QWidget* parent = nullptr);

    void applyTheme();
    void applyStep(const ChannelCalibration& calibration);
    [[nodiscard]] int channel() const;
    /// `raw`: the fresh reading of channel(); none: stale.
    void refresh(const ChannelCalibration& calibration, std::optional<int> raw);

signals:
    void channelChanged();

private:
    QComboBox* m_channel;
    ResponseCurveView* m_curve;
    QLabel* m_figures;
    int m_followed = 0; ///< channel of the direction step that was last shown
};

} // namespace trex
