// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/bench/benchresult.h"

#include <QDateTime>
#include <QFile>
#include <QJsonDocument>
#include <QJsonObject>
#include <QSysInfo>
#include <QThread>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <ctime>

namespace trex::bench {

using namespace Qt::Literals::StringLiterals;

namespace {

QString processor()
{
    QFile file(u"/proc/cpuinfo"_s);
    if (file.open(QIODevice::ReadOnly)) {
        const QList<QByteArray> lines = file.readAll().split('\n');
        for (const QByteArray& line : lines) {
            if (line.startsWith("model name")) {
                return QString::fromUtf8(line.mid(line.indexOf(':') + 1).trimmed());
            }
        }
    }
    return QSysInfo::currentCpuArchitecture();
}

QString figure(double value)
{
    const double size = std::abs(value);
    return QString::number(value, 'f', size >= 100 ? 0 : (size >= 10 ? 1 : (size >= 1 ? 2 : 3)));
}

} // namespace

double median(std::vector<double> values)
{
    if (values.empty()) {
        return std::nan("");
    }
    std::sort(values.begin(), values.end());
    return values[values.size() / 2];
}

double ThreadTimer::nowNs()
{
    timespec time{};
    ::clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
    return double(time.tv_sec) * 1e9 + double(time.tv_nsec);
}

double systemLoad()
{
    std::array<double, 1> load{};
    return ::getloadavg(load.data(), 1) == 1 ? load[0] : std::nan("");
}

void Results::note(const QString& sentence)
{
    m_notes << sentence;
}

void Results::add(const QString& key, const QString& title, double value, const QString& unit)
{
    m_rows.push_back({key, title, value, unit});
}

QString Results::table() const
{
    constexpr int kTitleWidth = 68;
    QString text;
    for (const Row& row : m_rows) {
        text +=
            u"%1 %2 %3\n"_s.arg(row.title, -kTitleWidth).arg(figure(row.median), 10).arg(row.unit);
    }
    text += u"%1 %2\n"_s.arg(u"load of the machine at the end"_s, -kTitleWidth)
                .arg(figure(systemLoad()), 10);
    for (const QString& sentence : m_notes) {
        text += sentence + u'\n';
    }
    return text;
}

QByteArray Results::json() const
{
    QJsonArray rows;
    for (const Row& row : m_rows) {
        rows.append(QJsonObject{
            {u"key"_s, row.key},
            {u"title"_s, row.title},
            {u"median"_s, std::isfinite(row.median) ? QJsonValue(row.median) : QJsonValue()},
            {u"unit"_s, row.unit}});
    }
    return QJsonDocument(
               QJsonObject{{u"date"_s, QDateTime::currentDateTimeUtc().toString(Qt::ISODate)},
                           {u"processor"_s, processor()},
                           {u"cores"_s, QThread::idealThreadCount()},
                           {u"system"_s, QSysInfo::prettyProductName()},
                           {u"load"_s, systemLoad()},
                           {u"notes"_s, QJsonArray::fromStringList(m_notes)},
                           {u"results"_s, rows}})
        .toJson();
}

} // namespace trex::bench
