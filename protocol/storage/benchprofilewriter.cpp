// SPDX-License-Identifier: GPL-3.0-or-later
#include "protocol/storage/benchprofile.h"

#include <QJsonArray>
#include <QJsonDocument>
#include <QStringList>

#include <algorithm>

using namespace Qt::Literals::StringLiterals;

namespace trex {
namespace {

QString jsonText(const QJsonValue& value)
{
    const auto list = QJsonDocument(QJsonArray{value}).toJson(QJsonDocument::Compact);
    return QString::fromUtf8(list.mid(1, list.size() - 2));
}

/// The members of one object in the order of the format, with the person's own where they stood.
class Members {
public:
    template <class T>
    void add(const char* key, const T& value)
    {
        addRaw(key, jsonText(QJsonValue(value)));
    }
    template <class T>
    void add(const char* key, const std::optional<T>& value)
    {
        if (value) {
            add(key, *value);
        }
    }
    void addRaw(const char* key, const QString& json)
    {
        m_members.push_back({QLatin1StringView(key), json});
    }
    /// Each goes behind the key that it stood behind, which may be another one of the person's.
    void addComments(BenchComments waiting)
    {
        const auto place = [this](const BenchComment& comment) {
            return std::ranges::find(m_members, comment.after, &Member::key);
        };
        while (!waiting.empty()) {
            auto next = std::ranges::find_if(waiting, [&](const BenchComment& comment) {
                return comment.after.isEmpty() || place(comment) != m_members.end();
            });
            const bool isLost = next == waiting.end(); // its neighbour is no longer there
            next = isLost ? waiting.begin() : next;
            const auto at = isLost      ? m_members.end()
                : next->after.isEmpty() ? m_members.begin()
                                        : place(*next) + 1;
            m_members.insert(at, {next->key, QString::fromUtf8(next->json)});
            waiting.erase(next);
        }
    }
    [[nodiscard]] bool isEmpty() const { return m_members.empty(); }
    [[nodiscard]] QString onOneLine() const
    {
        return isEmpty() ? u"{}"_s : u"{ "_s + texts().join(u", "_s) + u" }"_s;
    }
    [[nodiscard]] QString onLines(const QString& indent) const
    {
        return u"{\n"_s + indent + u"    "_s + texts().join(u",\n"_s + indent + u"    "_s) + u'\n'
            + indent + u'}';
    }

private:
    struct Member {
        QString key;
        QString json;
    };
    [[nodiscard]] QStringList texts() const
    {
        QStringList all;
        for (const Member& member : m_members) {
            all << jsonText(member.key) + u": "_s + member.json;
        }
        return all;
    }
    std::vector<Member> m_members;
};

Members limitsMembers(const BenchLimits& limits)
{
    Members members;
    members.add("seconds", limits.seconds);
    members.add("amperes", limits.amperes);
    if (limits.forSeconds > 0.0) {
        members.add("forSeconds", limits.forSeconds);
    }
    members.add("ampereSeconds", limits.ampereSeconds);
    members.add("linkErrors", limits.linkErrors);
    members.add("staleSeconds", limits.staleSeconds);
    if (!limits.overCurrentStops) {
        members.add("overCurrent", false);
    }
    members.addComments(limits.comments);
    return members;
}

QString stepsJson(const std::vector<BenchStep>& steps, const BenchProfile& profile,
                  const QString& indent);

void addCondition(Members& members, const BenchStep& step)
{
    members.add("for", keyOf(step.condition));
    switch (step.condition) {
    case BenchCondition::CurrentAbove:
    case BenchCondition::CurrentBelow:
        members.add("amperes", step.threshold);
        break;
    case BenchCondition::Status:
        members.add("bit", statusBitKey(step.number));
        break;
    case BenchCondition::ChannelAbove:
    case BenchCondition::ChannelBelow:
        members.add("channel", step.number);
        members.add("raw", step.threshold);
        break;
    case BenchCondition::Time:
        members.add("at", step.threshold);
        break;
    }
    members.add("seconds", step.seconds);
    if (!step.mustHappen) {
        members.add("otherwise", u"go-on"_s);
    }
}

QString stepJson(const BenchStep& step, const BenchProfile& profile, const QString& indent)
{
    Members members;
    members.add("do", keyOf(step.action));
    if (step.motor != profile.motor) {
        members.add("motor", keyOf(step.motor));
    }
    switch (step.action) {
    case BenchAction::Set:
    case BenchAction::Accelerate:
        members.add("speed", step.speed);
        break;
    case BenchAction::Ramp:
        members.add("from", step.from);
        members.add("to", step.speed);
        members.add("seconds", step.seconds);
        break;
    case BenchAction::Step:
        members.add("speed", step.speed);
        members.add("seconds", step.seconds);
        break;
    case BenchAction::Sine:
        members.add("middle", step.speed);
        members.add("amplitude", step.amplitude);
        members.add("period", step.period);
        members.add("seconds", step.seconds);
        break;
    case BenchAction::Hold:
        members.add("seconds", step.seconds);
        break;
    case BenchAction::Brake:
        members.add("duty", step.speed);
        break;
    case BenchAction::Wait:
        addCondition(members, step);
        break;
    case BenchAction::Repeat:
        members.add("times", step.times);
        break;
    }
    if (!step.label.isEmpty()) {
        members.add("label", step.label);
    }
    if (const Members limits = limitsMembers(step.limits); !limits.isEmpty()) {
        members.addRaw("limits", limits.onOneLine());
    }
    if (step.action == BenchAction::Repeat) {
        members.addRaw("steps", stepsJson(step.steps, profile, indent));
    }
    members.addComments(step.comments);
    return members.onOneLine();
}

QString stepsJson(const std::vector<BenchStep>& steps, const BenchProfile& profile,
                  const QString& indent)
{
    const QString inner = indent + u"    "_s;
    QStringList all;
    for (const BenchStep& step : steps) {
        all << inner + stepJson(step, profile, inner);
    }
    return steps.empty() ? u"[]"_s : u"[\n"_s + all.join(u",\n"_s) + u'\n' + indent + u']';
}

QString expectJson(const BenchProfile& profile)
{
    QStringList all;
    for (const auto& [key, expectation] : profile.expect) {
        Members members;
        members.add("minimum", expectation.minimum);
        members.add("maximum", expectation.maximum);
        all << u"        %1: %2"_s.arg(jsonText(key), members.onOneLine());
    }
    return u"{\n"_s + all.join(u",\n"_s) + u"\n    }"_s;
}

} // namespace

QByteArray writeBenchProfile(const BenchProfile& profile)
{
    Members members;
    members.add("format", u"trexpanel-bench-profile"_s);
    members.add("version", BenchProfile::kVersion);
    members.add("name", profile.name);
    if (!profile.description.isEmpty()) {
        members.add("description", profile.description);
    }
    members.add("analysis", keyOf(profile.analysis));
    members.add("motor", keyOf(profile.motor));
    members.add("supplyVolts", profile.supplyVolts);
    if (profile.stopWithinSeconds != BenchProfile().stopWithinSeconds) {
        members.add("stopWithinSeconds", profile.stopWithinSeconds);
    }
    if (const Members limits = limitsMembers(profile.limits); !limits.isEmpty()) {
        members.addRaw("limits", limits.onOneLine());
    }
    if (!profile.expect.empty()) {
        members.addRaw("expect", expectJson(profile));
    }
    members.addRaw("steps", stepsJson(profile.steps, profile, u"    "_s));
    members.addComments(profile.comments);
    return members.onLines(QString()).toUtf8() + '\n';
}

} // namespace trex
