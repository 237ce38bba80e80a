// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "protocol/telemetry/trigger.h"
#include "widgets/plots/plotlayout.h"

#include <QWidget>

class QCheckBox;
class QComboBox;
class QDoubleSpinBox;
class QHBoxLayout;
class QLabel;
class QSpinBox;
class QToolButton;

namespace trex {

class PlotTimeline;

/// The threshold trigger of the plots: its controls, and its engine, which goes on while nobody
/// looks. What it catches is what the plots show while they follow. GUI thread.
class TriggerBar : public QWidget {
    Q_OBJECT

public:
    explicit TriggerBar(PlotTimeline& timeline, QWidget* parent = nullptr);

    /// Looks at what is new; to be called once a tick.
    void advance(double amperesPerCount);
    void setSources(const std::vector<CurveSpec>& curves); ///< those that can be chosen
    void setLevel(double physical); ///< by dragging

    [[nodiscard]] bool isOn() const;
    [[nodiscard]] QString source() const; ///< a stream's key; "": there is none to choose
    [[nodiscard]] const TriggerSettings& settings() const { return m_trigger.settings(); }
    [[nodiscard]] ValueScale scale() const;
    [[nodiscard]] std::optional<double> level() const; ///< none: switched off
    [[nodiscard]] std::optional<Instant> crossing() const;
    void setOn(bool on);

signals:
    void changed(); ///< settings, state or crossing

private:
    void build();
    void apply(); ///< the controls, into the engine
    void arm();
    void showCapture();
    void showState();

    PlotTimeline& m_timeline;
    Trigger m_trigger;
    double m_amperesPerCount;
    int m_clears = 0;
    QCheckBox* m_on;
    QComboBox* m_source;
    QComboBox* m_edge;
    QDoubleSpinBox* m_level;
    QComboBox* m_mode;
    QSpinBox* m_before; ///< per cent of the window
    QToolButton* m_arm;
    QLabel* m_state;
};

} // namespace trex
