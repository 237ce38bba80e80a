// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QJsonArray>
#include <QString>

#include <vector>

namespace trex::bench {

/// What was measured, one row each: medians of interleaved runs, and ratios where there is
/// something to compare with.
class Results {
public:
    void add(const QString& key, const QString& title, double median, const QString& unit);
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
};

[[nodiscard]] double median(std::vector<double> values);

} // namespace trex::bench
