// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/common/theme.h"

#include <QLabel>
#include <QVariant>

#include <optional>

namespace trex {

/// A current in large digits, "2.20 A"; an en dash where there is none. GUI thread.
class CurrentValue : public QLabel {
    Q_OBJECT
    Q_PROPERTY(QVariant amperes READ amperes)
    Q_PROPERTY(bool stale READ isStale)

public:
    explicit CurrentValue(QWidget* parent = nullptr);
    /// `isInferred`: the scale is a guess (TReX); the figure is then marked ≈.
    void setAmperes(std::optional<double> amperes, bool isInferred, bool isStale);
    [[nodiscard]] QVariant amperes() const; ///< invalid: no value
    [[nodiscard]] bool isStale() const { return m_stale; }

private:
    std::optional<double> m_amperes;
    bool m_stale = true;
};

/// One motor's read-outs: the present current, and its peak and mean over the visible time.
class CurrentReadOut : public QWidget {
    Q_OBJECT

public:
    CurrentReadOut(const QString& title, ColourRole colour, const QString& valueName,
                   QWidget* parent = nullptr);

    struct Figures {
        std::optional<double> present;
        std::optional<double> peak;
        std::optional<double> mean;
        bool isInferred = false;
        bool isStale = true;
        QString note; ///< beside the title: the age of a stale value, a reason for none
    };
    void show(const Figures& figures);

protected:
    void changeEvent(QEvent* event) override;
    void paintEvent(QPaintEvent* event) override;

private:
    void applyTheme();

    ColourRole m_colour;
    QString m_titleText;
    QLabel* m_title;
    CurrentValue* m_value;
    QLabel* m_peak;
    QLabel* m_mean;
};

/// "2.20 A", "≈ 8.25 A", "–".
[[nodiscard]] QString ampereText(std::optional<double> amperes, bool isInferred);

} // namespace trex
