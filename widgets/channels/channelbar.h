// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "protocol/codec/command.h"

#include <QWidget>

#include <optional>

namespace trex {

/// One input channel as a bar: the raw value on the scale of its input kind with the calibration's
/// minimum, neutral, deadband and maximum drawn on it, and below it the remapped value around zero.
/// Invalid is hatched with its reason, stale is dimmed; neither looks like zero. GUI thread.
class ChannelBar : public QWidget {
    Q_OBJECT
    Q_PROPERTY(int raw READ raw)
    Q_PROPERTY(int remapped READ remapped)
    Q_PROPERTY(bool valid READ isValid)
    Q_PROPERTY(bool stale READ isStale)

public:
    /// Extremes that the value has visited, in raw units; drawn as a bracket (calibration wizard).
    struct Travel {
        int lowest = 0;
        int highest = 0;
        bool operator==(const Travel&) const = default;
    };

    explicit ChannelBar(int channel, QWidget* parent = nullptr); ///< 1 to 5

    void setInput(InputKind input);
    void setRaw(int raw); ///< as read; kInvalidPulse is an invalid or missing pulse
    void setRemapped(std::optional<int> remapped); ///< −127 to 127; none: not known
    void setStale(bool stale); ///< true: the last value is old, or there never was one
    void setCalibration(const std::optional<Calibration>& calibration); ///< none: not known
    void setTravel(const std::optional<Travel>& travel);
    void setRemappedShown(bool shown); ///< without it the bar has the raw lane only

    [[nodiscard]] int channel() const { return m_channel; }
    [[nodiscard]] int raw() const { return m_raw; } ///< −1: never read; 65535: invalid
    [[nodiscard]] int remapped() const { return m_remapped.value_or(0); }
    [[nodiscard]] bool hasRemapped() const { return m_remapped.has_value(); }
    [[nodiscard]] bool isValid() const; ///< a fresh and valid value
    [[nodiscard]] bool isStale() const { return m_stale; }
    [[nodiscard]] InputKind input() const { return m_input; }
    /// "1.455 ms (3637)", "2.41 V (493)"; invalid or never read: an en dash with the reason.
    [[nodiscard]] QString text() const;
    /// Left and right end of the scale: the widths that the controller accepts (0.5 to 2.5 ms,
    /// facts.md 5.1), or 0 to 5 V.
    [[nodiscard]] static std::pair<int, int> scaleOf(InputKind input);

    [[nodiscard]] QSize sizeHint() const override;
    [[nodiscard]] QSize minimumSizeHint() const override;

protected:
    void paintEvent(QPaintEvent* event) override;
    void changeEvent(QEvent* event) override;

private:
    [[nodiscard]] double xOf(int raw, const QRectF& lane) const;
    void paintRawLane(QPainter& painter, const QRectF& lane) const;
    void paintCalibration(QPainter& painter, const QRectF& lane) const;
    void paintRemappedLane(QPainter& painter, const QRectF& lane) const;
    void updateDescription();

    int m_channel;
    int m_raw = -1;
    std::optional<int> m_remapped;
    InputKind m_input = InputKind::Rc;
    bool m_stale = true;
    bool m_remappedShown = true;
    std::optional<Calibration> m_calibration;
    std::optional<Travel> m_travel;
};

} // namespace trex
