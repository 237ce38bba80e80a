// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/script/scriptfile.h"

#include "app/script/scriptactions.h"

#include <QFile>
#include <QFileInfo>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>

namespace trex {

using namespace Qt::Literals::StringLiterals;

namespace {

constexpr qint64 kLargestScript = qint64{4} * 1024 * 1024;
constexpr int kDeepestRepeat = 8;
constexpr qsizetype kLongestReason = 200;
constexpr int kLongestTimeoutMs = 24 * 3600 * 1000;

/// "line 3, column 7" of a byte offset.
QString placeOf(const QByteArray& json, qsizetype offset)
{
    const QByteArray before = json.left(offset);
    const qsizetype line = before.count('\n') + 1;
    const qsizetype column = offset - (before.lastIndexOf('\n') + 1) + 1;
    return u"line %1, column %2"_s.arg(line).arg(column);
}

/// Reads steps; where they stand ("step 4, step 2") goes in front of what is wrong.
class StepReader {
public:
    explicit StepReader(QString file) : m_file(std::move(file)) { }

    Result<std::vector<ScriptStep>> readSteps(const QJsonValue& json, const QString& place,
                                              int depth)
    {
        if (!json.isArray()) {
            return wrong(place, u"\"steps\" is not a list"_s);
        }
        if (depth > kDeepestRepeat) {
            return wrong(place, u"repeats are nested too deeply"_s);
        }
        std::vector<ScriptStep> steps;
        const QJsonArray array = json.toArray();
        for (qsizetype i = 0; i < array.size(); ++i) {
            const QString here =
                (place.isEmpty() ? QString() : place + u", "_s) + u"step %1"_s.arg(i);
            Result<ScriptStep> step = readStep(array.at(i), here, depth);
            if (!step) {
                return tl::make_unexpected(step.error());
            }
            steps.push_back(std::move(*step));
        }
        return steps;
    }

    /// What is wrong may hold names out of the file, which may be of any length.
    [[nodiscard]] tl::unexpected<Error> wrong(const QString& place, const QString& what) const
    {
        const QString told = what.size() > kLongestReason ? what.left(kLongestReason) + u'…' : what;
        return fail(ErrorCode::FileMalformed,
                    place.isEmpty() ? u"%1: %2"_s.arg(m_file, told)
                                    : u"%1, %2: %3"_s.arg(m_file, place, told));
    }

private:
    Result<ScriptStep> readStep(const QJsonValue& json, const QString& place, int depth)
    {
        if (!json.isObject()) {
            return wrong(place, u"not an object"_s);
        }
        ScriptStep step;
        const QJsonObject object = json.toObject();
        for (auto field = object.begin(); field != object.end(); ++field) {
            if (field.key() == "note"_L1) {
                step.note = field->toString();
            } else if (field.key() == "timeoutMs"_L1) {
                const double timeout = field->toDouble(-1);
                if (timeout < 0 || timeout > kLongestTimeoutMs) {
                    return wrong(place, u"\"timeoutMs\" is not a number of milliseconds"_s);
                }
                step.timeoutMs = static_cast<int>(timeout);
            } else if (step.action != nullptr) {
                return wrong(
                    place, u"more than one action, or the unknown field \"%1\""_s.arg(field.key()));
            } else if (step.action = findAction(field.key()); step.action != nullptr) {
                step.argument = field.value();
            } else {
                return wrong(place, u"there is no action \"%1\""_s.arg(field.key()));
            }
        }
        if (step.action == nullptr) {
            return wrong(place, u"no action"_s);
        }
        const QString problem = step.action->check(step.argument);
        if (!problem.isEmpty()) {
            return wrong(place,
                         u"%1: %2"_s.arg(QLatin1StringView(step.action->name.data()), problem));
        }
        if (const QJsonValue inner = step.argument["steps"_L1]; !inner.isUndefined()) {
            Result<std::vector<ScriptStep>> steps = readSteps(inner, place, depth + 1);
            if (!steps) {
                return tl::make_unexpected(steps.error());
            }
            step.steps = std::move(*steps);
        }
        return step;
    }

    QString m_file;
};

} // namespace

Result<Script> parseScript(const QByteArray& json, const QString& name)
{
    StepReader reader(name);
    QJsonParseError error{};
    const QJsonDocument document = QJsonDocument::fromJson(json, &error);
    if (error.error != QJsonParseError::NoError) {
        return reader.wrong(placeOf(json, error.offset), error.errorString());
    }
    if (!document.isObject() || !document.object().contains("steps"_L1)) {
        return reader.wrong({}, u"no \"steps\" at the top"_s);
    }
    Result<std::vector<ScriptStep>> steps =
        reader.readSteps(document.object().value("steps"_L1), {}, 0);
    if (!steps) {
        return tl::make_unexpected(steps.error());
    }
    return Script{.steps = std::move(*steps)};
}

Result<Script> readScript(const QString& path)
{
    QFile file(path);
    if (QFileInfo(path).isDir()) {
        return fail(ErrorCode::FileUnreadable, u"%1: it is a folder"_s.arg(path));
    }
    if (!file.open(QIODevice::ReadOnly)) {
        return fail(ErrorCode::FileUnreadable, u"%1: %2"_s.arg(path, file.errorString()));
    }
    // One byte more than is allowed tells a file that is too large, endless devices included.
    const QByteArray json = file.read(kLargestScript + 1);
    if (json.size() > kLargestScript) {
        return fail(ErrorCode::FileMalformed, u"%1: larger than 4 MiB"_s.arg(path));
    }
    return parseScript(json, path);
}

} // namespace trex
