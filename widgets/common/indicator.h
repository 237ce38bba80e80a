// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>

namespace trex {

/// A lamp with its label and how often it was seen. The state has a shape as well as a colour:
/// filled dot ok, triangle warning, octagon fault, hollow dot off, hatched stale.
class Indicator : public QWidget {
    Q_OBJECT
    Q_PROPERTY(bool active READ isActive)
    Q_PROPERTY(int count READ count)
    Q_PROPERTY(bool stale READ isStale)

public:
    enum class Meaning { Ok, Warning, Fault };
    Indicator(const QString& label, Meaning meaning, QWidget* parent = nullptr);

    void setState(bool active, int count, bool stale);
    void setDetail(const QString& detail); ///< tool tip: first and last time
    [[nodiscard]] bool isActive() const { return m_active; }
    [[nodiscard]] int count() const { return m_count; }
    [[nodiscard]] bool isStale() const { return m_stale; }
    [[nodiscard]] QSize sizeHint() const override;
    [[nodiscard]] QSize minimumSizeHint() const override;

protected:
    void paintEvent(QPaintEvent* event) override;

private:
    QString m_label;
    Meaning m_meaning;
    bool m_active = false;
    bool m_stale = true;
    int m_count = 0;
};

} // namespace trex
