// SPDX-License-Identifier: GPL-3.0-or-later
#include "protocol/storage/benchprofilereader.h"

using namespace Qt::Literals::StringLiterals;

namespace trex {
namespace {

constexpr qsizetype kLongestText = 4000;

} // namespace

Result<QString> BenchProfileReader::text(const Node& node, const QString& key) const
{
    const QJsonValue value = node.object.value(key);
    if (value.isUndefined()) {
        return QString();
    }
    if (!value.isString()) {
        return wrongType(node.at(key), Bench::tr("a text"), value);
    }
    if (value.toString().size() > kLongestText) {
        return wrong(node.at(key), Bench::tr("is longer than 4000 characters"));
    }
    return value.toString();
}

Result<int> BenchProfileReader::choice(const Node& node, const QString& key,
                                       const QStringList& choices) const
{
    const QJsonValue value = node.object.value(key);
    if (value.isUndefined()) {
        return wrong(node.at(key), Bench::tr("is missing; give %1").arg(choices.join(u", "_s)));
    }
    if (!value.isString()) {
        return wrongType(node.at(key), Bench::tr("one of %1").arg(choices.join(u", "_s)), value);
    }
    const auto found = choices.indexOf(value.toString());
    if (found < 0) {
        return wrong(node.at(key),
                     Bench::tr("%1 is not known; give %2")
                         .arg(tameText(value.toString()), choices.join(u", "_s)));
    }
    return static_cast<int>(found);
}

Result<BenchMotor> BenchProfileReader::motor(const Node& node, BenchMotor otherwise) const
{
    if (!node.object.contains(u"motor"_s)) {
        return otherwise;
    }
    const auto which =
        choice(node, u"motor"_s,
               keysOf({BenchMotor::Motor1, BenchMotor::Motor2, BenchMotor::Both, BenchMotor::Aux}));
    return which.map([](int index) { return static_cast<BenchMotor>(index); });
}

Result<BenchComments> BenchProfileReader::comments(const Node& node, const QStringList& known) const
{
    BenchComments kept;
    for (const QString& key : node.object.keys()) {
        if (known.contains(key)) {
            continue;
        }
        if (const auto meant = nearestKey(key, known)) {
            return wrong(node.at(key), Bench::tr("is not known; is %1 meant?").arg(*meant));
        }
        if (!node.object.value(key).isString()) {
            return wrong(node.at(key),
                         Bench::tr("is not known here, and no comment, which would be a text"));
        }
        const auto place = places().keys.find(node.at(key));
        if (place != places().keys.end()) {
            kept.push_back({key, place->second.after, place->second.value});
        }
    }
    return kept;
}

Result<BenchProfile> BenchProfileReader::read(const QJsonObject& object)
{
    if (places().duplicate) {
        return fail(ErrorCode::FileMalformed,
                    u"%1, %2"_s.arg(fileName(),
                                    Bench::tr("line %1, %2: stands twice")
                                        .arg(QString::number(places().duplicateLine),
                                             tameText(*places().duplicate))));
    }
    const Node root{object, {}};
    using Part = Result<void> (BenchProfileReader::*)(const Node&);
    for (const Part part : {&BenchProfileReader::readHead, &BenchProfileReader::readNumbers,
                            &BenchProfileReader::readExpect}) {
        if (auto done = (this->*part)(root); !done) {
            return tl::make_unexpected(done.error());
        }
    }
    auto steps = readSteps(root, 0);
    if (!steps) {
        return tl::make_unexpected(steps.error());
    }
    m_profile.steps = std::move(*steps);
    if (const auto sound = validate(m_profile); !sound) {
        return wrong(u"steps"_s, sound.error().context);
    }
    return m_profile;
}

Result<void> BenchProfileReader::readHead(const Node& root)
{
    if (root.object.value("format"_L1).toString() != "trexpanel-bench-profile"_L1) {
        return wrong(u"format"_s,
                     Bench::tr("must be \"trexpanel-bench-profile\": this is no bench test"));
    }
    const auto version = integer(root, u"version"_s, 1, 1'000'000);
    if (!version) {
        return tl::make_unexpected(version.error());
    }
    if (*version > BenchProfile::kVersion) {
        // What a motor is to do is never guessed.
        return wrong(u"version"_s, Bench::tr("%1 is newer than this program").arg(*version));
    }
    if (!root.object.contains("name"_L1)) {
        return wrong(u"name"_s, Bench::tr("is missing"));
    }
    if (auto done = into(m_profile.name, text(root, u"name"_s)); !done) {
        return done;
    }
    if (auto done = into(m_profile.description, text(root, u"description"_s)); !done) {
        return done;
    }
    if (root.object.contains("analysis"_L1)) {
        const auto analysis = choice(
            root, u"analysis"_s,
            keysOf({BenchAnalysis::General, BenchAnalysis::StepResponse, BenchAnalysis::SlowRamp,
                    BenchAnalysis::CurrentSpeed, BenchAnalysis::LeftRight, BenchAnalysis::Braking,
                    BenchAnalysis::Endurance}));
        if (!analysis) {
            return tl::make_unexpected(analysis.error());
        }
        m_profile.analysis = static_cast<BenchAnalysis>(*analysis);
    }
    if (auto done = into(m_profile.motor, motor(root, BenchMotor::Both)); !done) {
        return done;
    }
    return into(
        m_profile.comments,
        comments(root,
                 {u"format"_s, u"version"_s, u"name"_s, u"description"_s, u"analysis"_s, u"motor"_s,
                  u"supplyVolts"_s, u"stopWithinSeconds"_s, u"limits"_s, u"expect"_s, u"steps"_s}));
}

Result<void> BenchProfileReader::readNumbers(const Node& root)
{
    if (auto done = into(m_profile.supplyVolts, root, u"supplyVolts"_s, 1.0, 60.0); !done) {
        return done;
    }
    std::optional<double> stopWithin;
    if (auto done = into(stopWithin, root, u"stopWithinSeconds"_s, 0.01, 60.0); !done) {
        return done;
    }
    m_profile.stopWithinSeconds = stopWithin.value_or(m_profile.stopWithinSeconds);
    return into(m_profile.limits, readLimits(root));
}

Result<BenchLimits> BenchProfileReader::readLimits(const Node& parent)
{
    BenchLimits limits;
    if (!parent.object.contains(u"limits"_s)) {
        return limits;
    }
    const auto found = child(parent, u"limits"_s);
    if (!found) {
        return tl::make_unexpected(found.error());
    }
    const Node& node = *found;
    const QJsonValue overCurrent = node.object.value("overCurrent"_L1);
    if (!overCurrent.isUndefined() && !overCurrent.isBool()) {
        return wrongType(node.at(u"overCurrent"_s), Bench::tr("true or false"), overCurrent);
    }
    limits.overCurrentStops = overCurrent.toBool(true);
    if (node.object.contains(u"linkErrors"_s)) {
        const auto errors = integer(node, u"linkErrors"_s, 0, 1'000'000);
        if (!errors) {
            return tl::make_unexpected(errors.error());
        }
        limits.linkErrors = *errors;
    }
    std::optional<double> forSeconds;
    struct Row {
        QString key;
        std::optional<double>& target;
        double minimum;
        double maximum;
    };
    for (const Row& row : {Row{u"seconds"_s, limits.seconds, 0.1, kLongestStep},
                           Row{u"amperes"_s, limits.amperes, 0.0, kMostAmperes},
                           Row{u"forSeconds"_s, forSeconds, 0.0, 3600.0},
                           Row{u"ampereSeconds"_s, limits.ampereSeconds, 0.0, 1e7},
                           Row{u"staleSeconds"_s, limits.staleSeconds, 0.1, 5.0}}) {
        if (auto done = into(row.target, node, row.key, row.minimum, row.maximum); !done) {
            return tl::make_unexpected(done.error());
        }
    }
    if (forSeconds && !limits.amperes) {
        return wrong(node.at(u"forSeconds"_s), Bench::tr("says how long, but amperes is missing"));
    }
    limits.forSeconds = forSeconds.value_or(0.0);
    if (auto done = into(limits.comments,
                         comments(node,
                                  {u"seconds"_s, u"amperes"_s, u"forSeconds"_s, u"ampereSeconds"_s,
                                   u"linkErrors"_s, u"staleSeconds"_s, u"overCurrent"_s}));
        !done) {
        return tl::make_unexpected(done.error());
    }
    return limits;
}

Result<void> BenchProfileReader::readExpect(const Node& root)
{
    if (!root.object.contains("expect"_L1)) {
        return {};
    }
    const auto expect = child(root, u"expect"_s);
    if (!expect) {
        return tl::make_unexpected(expect.error());
    }
    for (const QString& key : expect->object.keys()) {
        const auto expectation = readExpectation(*expect, key);
        if (!expectation) {
            return tl::make_unexpected(expectation.error());
        }
        m_profile.expect[key] = *expectation;
    }
    return {};
}

Result<BenchExpectation> BenchProfileReader::readExpectation(const Node& expect, const QString& key)
{
    const auto node = child(expect, key);
    if (!node) {
        return tl::make_unexpected(node.error());
    }
    BenchExpectation expectation;
    constexpr double kAny = 1e9;
    for (auto [name, target] : {std::pair{u"minimum"_s, &expectation.minimum},
                                std::pair{u"maximum"_s, &expectation.maximum}}) {
        if (auto done = into(*target, *node, name, -kAny, kAny); !done) {
            return tl::make_unexpected(done.error());
        }
    }
    const auto others = comments(*node, {u"minimum"_s, u"maximum"_s});
    if (!others) {
        return tl::make_unexpected(others.error());
    }
    if (!expectation.minimum && !expectation.maximum) {
        return wrong(expect.at(key), Bench::tr("needs minimum, maximum or both"));
    }
    if (expectation.minimum > expectation.maximum && expectation.maximum) {
        return wrong(node->at(u"minimum"_s), Bench::tr("is above maximum"));
    }
    return expectation;
}

Result<BenchProfile> parseBenchProfile(const QByteArray& bytes, const QString& fileName)
{
    if (bytes.size() > kLargestProfileBytes) {
        return fail(
            ErrorCode::FileMalformed,
            u"%1: %2"_s.arg(fileName, Bench::tr("larger than 256 KiB, which no bench test is")));
    }
    const auto parsed = parseJson(bytes, fileName);
    return parsed ? BenchProfileReader(parsed->text, fileName).read(parsed->object)
                  : tl::make_unexpected(parsed.error());
}

} // namespace trex
