// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QJsonArray>
#include <QString>
#include <QStringList>

#include <vector>

namespace trex::bench {

/// What was measured, one row each: medians of interleaved runs, and ratios where there is
/// something to compare with.
class Results {
public:
    void add(const QString& key, const QString& title, double median, const QString& unit);
    void note(const QString& sentence); ///< what a reader has to know, under the table
    [[nodiscard]] QString table() const;
    [[nodiscard]] QByteArray json() const; ///< with date and machine

private:
    struct Row {
        QString key;
        QString title;
        double median = 0.0;
        QString unit;
    };
    std::vector<Row> m_rows;
    QStringList m_notes;
};

[[nodiscard]] double median(std::vector<double> values);
/// Processor time of this thread: what something costs, however busy the machine is with others.
class ThreadTimer {
public:
    ThreadTimer() : m_start(nowNs()) { }
    void restart() { m_start = nowNs(); }
    [[nodiscard]] double ns() const { return nowNs() - m_start; }

private:
    [[nodiscard]] static double nowNs();
    double m_start;
};
/// Processes that wanted a processor, on average of the last minute: how noisy the times are.
[[nodiscard]] double systemLoad();

} // namespace trex::bench
