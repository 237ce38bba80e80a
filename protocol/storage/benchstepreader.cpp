// SPDX-License-Identifier: GPL-3.0-or-later
#include "protocol/storage/benchprofilereader.h"

#include <QJsonArray>

using namespace Qt::Literals::StringLiterals;

namespace trex {
namespace {

constexpr qsizetype kMostSteps = 2000; // in one list
constexpr int kBits = 8;

/// What a step of each kind may hold beside do, motor, label and limits.
QStringList keysOfStep(BenchAction action)
{
    switch (action) {
    case BenchAction::Set:
    case BenchAction::Accelerate:
        return {u"speed"_s};
    case BenchAction::Ramp:
        return {u"from"_s, u"to"_s, u"seconds"_s};
    case BenchAction::Step:
        return {u"speed"_s, u"seconds"_s};
    case BenchAction::Sine:
        return {u"middle"_s, u"amplitude"_s, u"period"_s, u"seconds"_s};
    case BenchAction::Hold:
        return {u"seconds"_s};
    case BenchAction::Brake:
        return {u"duty"_s};
    case BenchAction::Wait:
        return {u"for"_s, u"amperes"_s, u"bit"_s,     u"channel"_s,
                u"raw"_s, u"at"_s,      u"seconds"_s, u"otherwise"_s};
    case BenchAction::Repeat:
        return {u"times"_s, u"steps"_s};
    }
    return {};
}

} // namespace

Result<std::vector<BenchStep>> BenchProfileReader::readSteps(const Node& parent, int depth)
{
    const QJsonValue value = parent.object.value("steps"_L1);
    if (!value.isArray()) {
        return wrongType(parent.at(u"steps"_s), Bench::tr("a list of steps"), value);
    }
    const QJsonArray list = value.toArray();
    if (list.size() > kMostSteps) {
        return wrong(parent.at(u"steps"_s), Bench::tr("has more than 2000 steps; use repeat"));
    }
    std::vector<BenchStep> steps;
    for (qsizetype i = 0; i < list.size(); ++i) {
        const QString path = pathOf(parent.at(u"steps"_s), QString::number(i));
        if (!list.at(i).isObject()) {
            return wrongType(path, Bench::tr("an object"), list.at(i));
        }
        auto step = readStep({list.at(i).toObject(), path}, depth);
        if (!step) {
            return tl::make_unexpected(step.error());
        }
        steps.push_back(std::move(*step));
    }
    return steps;
}

Result<BenchStep> BenchProfileReader::readStep(const Node& node, int depth)
{
    BenchStep step;
    const auto action =
        choice(node, u"do"_s,
               keysOf({BenchAction::Set, BenchAction::Accelerate, BenchAction::Ramp,
                       BenchAction::Step, BenchAction::Sine, BenchAction::Hold, BenchAction::Brake,
                       BenchAction::Wait, BenchAction::Repeat}));
    if (!action) {
        return tl::make_unexpected(action.error());
    }
    step.action = static_cast<BenchAction>(*action);
    const QStringList known =
        QStringList{u"do"_s, u"motor"_s, u"label"_s, u"limits"_s} + keysOfStep(step.action);
    Result<void> done = into(step.comments, comments(node, known));
    done = done.and_then([&] { return into(step.motor, motor(node, m_profile.motor)); });
    done = done.and_then([&] { return into(step.label, text(node, u"label"_s)); });
    done = done.and_then([&] { return into(step.limits, readLimits(node)); });
    done = done.and_then([&] { return readAmounts(node, step); });
    if (done && step.action == BenchAction::Repeat) {
        if (depth >= BenchProfile::kDeepestRepeat) {
            return wrong(node.at(u"steps"_s),
                         Bench::tr("repetitions stand in each other at most three deep"));
        }
        done = into(step.steps, readSteps(node, depth + 1));
    }
    if (!done) {
        return tl::make_unexpected(done.error());
    }
    return step;
}

Result<void> BenchProfileReader::readAmounts(const Node& node, BenchStep& step)
{
    const auto speed = [&](const char* key) {
        return into(step.speed, integer(node, QString::fromLatin1(key), -kFullSpeed, kFullSpeed));
    };
    const auto seconds = [&](double least) {
        return into(step.seconds, number(node, u"seconds"_s, least, kLongestStep));
    };
    constexpr double kShortest = 0.02;
    switch (step.action) {
    case BenchAction::Set:
    case BenchAction::Accelerate:
        return speed("speed");
    case BenchAction::Ramp:
        if (node.object.contains("from"_L1)) {
            const auto from = integer(node, u"from"_s, -kFullSpeed, kFullSpeed);
            if (!from) {
                return tl::make_unexpected(from.error());
            }
            step.from = *from;
        }
        return speed("to").and_then([&] { return seconds(kShortest); });
    case BenchAction::Step:
        return speed("speed").and_then([&] { return seconds(kShortest); });
    case BenchAction::Sine:
        return speed("middle")
            .and_then(
                [&] { return into(step.amplitude, integer(node, u"amplitude"_s, 1, kFullSpeed)); })
            .and_then([&] { return into(step.period, number(node, u"period"_s, 0.1, 3600.0)); })
            .and_then([&] { return seconds(kShortest); });
    case BenchAction::Hold:
        return seconds(kShortest);
    case BenchAction::Brake:
        return into(step.speed, integer(node, u"duty"_s, 0, kFullSpeed));
    case BenchAction::Wait:
        return readCondition(node, step);
    case BenchAction::Repeat:
        return into(step.times, integer(node, u"times"_s, 1, 100'000));
    }
    return {};
}

Result<void> BenchProfileReader::readCondition(const Node& node, BenchStep& step)
{
    const auto condition = choice(
        node, u"for"_s,
        keysOf({BenchCondition::CurrentAbove, BenchCondition::CurrentBelow, BenchCondition::Status,
                BenchCondition::ChannelAbove, BenchCondition::ChannelBelow, BenchCondition::Time}));
    if (!condition) {
        return tl::make_unexpected(condition.error());
    }
    step.condition = static_cast<BenchCondition>(*condition);
    Result<void> done = into(step.seconds, number(node, u"seconds"_s, 0.02, kLongestStep));
    if (done && node.object.contains("otherwise"_L1)) {
        const auto otherwise = choice(node, u"otherwise"_s, {u"stop"_s, u"go-on"_s});
        if (!otherwise) {
            return tl::make_unexpected(otherwise.error());
        }
        step.mustHappen = *otherwise == 0;
    }
    if (!done) {
        return done;
    }
    switch (step.condition) {
    case BenchCondition::CurrentAbove:
    case BenchCondition::CurrentBelow:
        if (step.motor == BenchMotor::Aux) {
            return wrong(node.at(u"motor"_s),
                         Bench::tr("the current of the auxiliary motor is not measured"));
        }
        return into(step.threshold, number(node, u"amperes"_s, 0.0, kMostAmperes));
    case BenchCondition::Status: {
        QStringList keys;
        std::vector<int> bits;
        for (int bit = 0; bit < kBits; ++bit) {
            if (!statusBitKey(bit).isEmpty()) {
                keys << statusBitKey(bit);
                bits.push_back(bit);
            }
        }
        return into(step.number, choice(node, u"bit"_s, keys).map([&](int index) {
            return bits.at(std::size_t(index));
        }));
    }
    case BenchCondition::ChannelAbove:
    case BenchCondition::ChannelBelow:
        return into(step.number, integer(node, u"channel"_s, 1, kChannelCount)).and_then([&] {
            return into(step.threshold, number(node, u"raw"_s, 0, kInvalidPulse - 1));
        });
    case BenchCondition::Time:
        return into(step.threshold, number(node, u"at"_s, 0.0, kLongestStep));
    }
    return {};
}

} // namespace trex
