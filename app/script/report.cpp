// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/script/report.h"

#include "app/script/metrics.h"
#include "app/script/processclock.h"
#include "app/script/scriptplayer.h"
#include "protocol/savefile.h"

#include <QDir>
#include <QFileInfo>
#include <QJsonArray>
#include <QJsonDocument>

#include <cmath>

namespace trex {

using namespace Qt::Literals::StringLiterals;

namespace {

double rounded(double value)
{
    return std::round(value * 1000.0) / 1000.0;
}

QJsonArray stepsOf(const ScriptPlayer& player)
{
    QJsonArray steps;
    for (const StepRecord& record : player.records()) {
        steps.append(QJsonObject{{u"index"_s, record.index},
                                 {u"action"_s, record.action},
                                 {u"ok"_s, record.ok},
                                 {u"startMs"_s, rounded(record.startMs)},
                                 {u"ms"_s, rounded(record.milliseconds)},
                                 {u"message"_s, record.message}});
    }
    return steps;
}

} // namespace

QJsonObject reportOf(const ScriptPlayer& player, const Metrics& metrics)
{
    const std::optional<int> failed = player.failedStep();
    return {{u"passed"_s, player.isPassed()},
            {u"failedStep"_s, failed ? QJsonValue(*failed) : QJsonValue()},
            {u"startupEpochMs"_s, processclock::startEpochMs()},
            {u"steps"_s, stepsOf(player)},
            {u"screenshots"_s, QJsonArray::fromStringList(player.screenshots())},
            {u"metrics"_s, metrics.toJson()}};
}

Result<void> writeReport(const QString& path, const QJsonObject& report)
{
    SaveFile file(path);
    QDir().mkpath(QFileInfo(path).absolutePath());
    const QByteArray json = QJsonDocument(report).toJson();
    if (!file.open(QIODevice::WriteOnly) || file.write(json) != json.size() || !file.commit()) {
        return fail(ErrorCode::FileUnwritable, u"%1: %2"_s.arg(path, file.errorString()));
    }
    return {};
}

} // namespace trex
