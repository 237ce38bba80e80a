// SPDX-License-Identifier: GPL-3.0-or-later
#include "protocol/sim/scenario.h"

#include "protocol/sim/factory.h"
#include "protocol/sim/parameterkeys.h"

#include <QFile>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>

#include <algorithm>

namespace trex::sim {

using namespace Qt::Literals::StringLiterals;

namespace {

constexpr qsizetype kLongestProblem = 200;

/// Takes a JSON object apart key by key. The first thing that is wrong is kept, with its path; a
/// key that nobody asked for is wrong too.
class ObjectReader {
public:
    ObjectReader(const QJsonValue& value, QString path, QString& problem)
        : m_object(value.toObject()), m_path(std::move(path)), m_problem(problem)
    {
        if (!value.isObject()) {
            complain({}, u"must be an object"_s);
        }
    }

    [[nodiscard]] bool has(const QString& key)
    {
        m_known.append(key);
        return m_object.contains(key);
    }
    [[nodiscard]] QJsonValue value(const QString& key) const { return m_object.value(key); }
    [[nodiscard]] QString path(const QString& key) const
    {
        return m_path.isEmpty() || key.isEmpty() ? m_path + key : m_path + u'.' + key;
    }
    [[nodiscard]] QStringList keys() const { return m_object.keys(); }

    void number(const QString& key, double minimum, double maximum, auto&& store)
    {
        if (!has(key)) {
            return;
        }
        const double number = value(key).toDouble(Faults::kNever);
        if (!value(key).isDouble() || number < minimum || number > maximum) {
            complain(key, u"must be a number from %1 to %2"_s.arg(minimum).arg(maximum));
            return;
        }
        store(number);
    }
    void boolean(const QString& key, auto&& store)
    {
        if (has(key)) {
            if (!value(key).isBool()) {
                complain(key, u"must be true or false"_s);
                return;
            }
            store(value(key).toBool());
        }
    }
    template <class T>
    void choice(const QString& key, const std::vector<std::pair<QString, T>>& choices, auto&& store)
    {
        if (!has(key)) {
            return;
        }
        QStringList names;
        for (const auto& [name, choice] : choices) {
            if (value(key).toString() == name) {
                store(choice);
                return;
            }
            names.append(name);
        }
        complain(key, u"must be one of %1"_s.arg(names.join(u", "_s)));
    }
    template <class F>
    void list(const QString& key, F&& each)
    {
        if (!has(key)) {
            return;
        }
        if (!value(key).isArray()) {
            complain(key, u"must be a list"_s);
        }
        const QJsonArray array = value(key).toArray();
        for (int i = 0; i < array.size(); ++i) {
            each(array.at(i), u"%1[%2]"_s.arg(path(key)).arg(i));
        }
    }
    void requireKey(const QString& key)
    {
        if (!has(key)) {
            complain(key, u"is missing"_s);
        }
    }
    void complain(const QString& key, const QString& what)
    {
        if (m_problem.isEmpty()) {
            const QString where = path(key);
            m_problem = where.isEmpty() ? what : u"\"%1\" %2"_s.arg(where, what);
        }
    }
    void noOtherKeys()
    {
        for (const QString& key : m_object.keys()) {
            if (!m_known.contains(key)) {
                complain(key, u"is not a known key"_s);
            }
        }
    }

private:
    QJsonObject m_object;
    QString m_path;
    QString& m_problem;
    QStringList m_known;
};

constexpr double kLongest = 1e9; // s
constexpr double kLargestRaw = 65535;

ChannelWave channelFrom(const QJsonValue& value, const QString& path, QString& problem)
{
    static const std::vector<std::pair<QString, Wave>> kWaves{
        {u"sine"_s, Wave::Sine},  {u"square"_s, Wave::Square}, {u"hold"_s, Wave::Hold},
        {u"ramp"_s, Wave::Ramp},  {u"noise"_s, Wave::Noise},   {u"missing"_s, Wave::Missing},
        {u"stick"_s, Wave::Stick}};
    ObjectReader reader(value, path, problem);
    ChannelWave row;
    reader.requireKey(u"channel"_s);
    reader.number(u"channel"_s, 1, kChannelCount, [&](double v) {
        row.channel = static_cast<int>(v);
        if (row.channel != v) {
            reader.complain(u"channel"_s, u"must be a whole number"_s);
        }
    });
    reader.requireKey(u"wave"_s);
    reader.choice<Wave>(u"wave"_s, kWaves, [&](Wave v) { row.wave = v; });
    reader.number(u"minimum"_s, 0, kLargestRaw, [&](double v) { row.minimum = v; });
    reader.number(u"maximum"_s, 0, kLargestRaw, [&](double v) { row.maximum = v; });
    reader.number(u"value"_s, 0, kLargestRaw, [&](double v) { row.value = v; });
    reader.number(u"period"_s, 0.001, kLongest, [&](double v) { row.period = v; });
    reader.number(u"from"_s, 0, kLongest, [&](double v) { row.from = v; });
    reader.number(u"to"_s, 0, kLongest, [&](double v) { row.to = v; });
    reader.number(u"jitter"_s, 0, kLargestRaw, [&](double v) { row.jitter = v; });
    reader.number(u"missing"_s, 0, 1, [&](double v) { row.missing = v; });
    if (row.minimum && row.maximum && *row.minimum > *row.maximum) {
        reader.complain(u"minimum"_s, u"is above the maximum"_s);
    }
    reader.noOtherKeys();
    return row;
}

void readParameters(const QJsonValue& value, const QString& path, QString& problem,
                    ScenarioEvent& event)
{
    ObjectReader reader(value, path, problem);
    for (const QString& key : reader.keys()) {
        const auto number = parameterNumber(key);
        if (!number) {
            reader.complain(key, u"is not a parameter"_s);
            continue;
        }
        reader.number(key, 0, kFullSpeed, [&](double v) {
            const int raw = static_cast<int>(v);
            if (raw != v || !takesParameter(*number, raw)) {
                reader.complain(key, u"has a value that the parameter cannot take"_s);
            }
            event.parameters[*number] = raw;
        });
    }
}

void readSettings(const QJsonValue& value, const QString& path, QString& problem,
                  ScenarioEvent& event)
{
    static const std::vector<std::pair<QString, JumperMode>> kModes{
        {u"rc"_s, JumperMode::Rc},
        {u"analog"_s, JumperMode::Analog},
        {u"serial"_s, JumperMode::Serial}};
    ObjectReader reader(value, path, problem);
    for (std::size_t i = 0; i < 2; ++i) {
        const QString motor = QString::number(i + 1);
        reader.number(u"load"_s + motor, 0, 1, [&](double v) { event.load[i] = v; });
        reader.boolean(u"stall"_s + motor, [&](bool v) { event.stall[i] = v; });
        reader.boolean(u"fault"_s + motor, [&](bool v) { event.driverFault[i] = v; });
    }
    reader.choice<JumperMode>(u"mode"_s, kModes, [&](JumperMode v) { event.mode = v; });
    reader.boolean(u"mix"_s, [&](bool v) { event.mix = v; });
    reader.boolean(u"powerCycle"_s, [&](bool v) { event.powerCycle = v; });
    if (reader.has(u"parameter"_s)) {
        readParameters(reader.value(u"parameter"_s), reader.path(u"parameter"_s), problem, event);
    }
    reader.noOtherKeys();
}

ScenarioEvent eventFrom(const QJsonValue& value, const QString& path, QString& problem)
{
    ObjectReader reader(value, path, problem);
    ScenarioEvent event;
    reader.requireKey(u"t"_s);
    reader.number(u"t"_s, 0, kLongest, [&](double v) { event.at = v; });
    if (reader.has(u"set"_s)) {
        readSettings(reader.value(u"set"_s), reader.path(u"set"_s), problem, event);
    }
    if (reader.has(u"fault"_s)) {
        ObjectReader faults(reader.value(u"fault"_s), reader.path(u"fault"_s), problem);
        for (const QString& name : faults.keys()) {
            faults.number(name, 0, kLongest, [&](double v) {
                Faults probe;
                if (const auto applied = probe.apply(name, v); !applied) {
                    faults.complain(name, u": "_s + applied.error().context);
                }
                event.faults.emplace_back(name, v);
            });
        }
    }
    reader.noOtherKeys();
    return event;
}

} // namespace

std::optional<std::uint16_t> Trace::at(double seconds) const
{
    const auto next = std::upper_bound(points.begin(), points.end(), seconds,
                                       [](double s, const auto& point) { return s < point.first; });
    return next == points.begin() ? std::nullopt : std::optional(std::prev(next)->second);
}

Result<Scenario> parseScenario(const QByteArray& json, const QString& name)
{
    QJsonParseError error;
    const QJsonDocument document = QJsonDocument::fromJson(json, &error);
    if (error.error != QJsonParseError::NoError) {
        const auto line = json.left(error.offset).count('\n') + 1;
        return fail(ErrorCode::FileMalformed,
                    u"%1, line %2: %3"_s.arg(name, QString::number(line), error.errorString()));
    }
    QString problem;
    Scenario scenario;
    ObjectReader root(document.isObject() ? QJsonValue(document.object()) : QJsonValue(), {},
                      problem);
    root.list(u"channels"_s, [&](const QJsonValue& value, const QString& path) {
        scenario.channels.push_back(channelFrom(value, path, problem));
    });
    root.list(u"events"_s, [&](const QJsonValue& value, const QString& path) {
        scenario.events.push_back(eventFrom(value, path, problem));
    });
    if (root.has(u"stick"_s)) {
        ObjectReader stick(root.value(u"stick"_s), u"stick"_s, problem);
        StickPlan plan;
        stick.number(u"neutralSeconds"_s, 0, kLongest, [&](double v) { plan.neutralSeconds = v; });
        stick.number(u"sweepSeconds"_s, 0.1, kLongest, [&](double v) { plan.sweepSeconds = v; });
        stick.noOtherKeys();
        scenario.stick = plan;
    }
    root.noOtherKeys();
    if (!problem.isEmpty()) {
        // It may hold keys out of the file, which may be of any length.
        const QString told =
            problem.size() > kLongestProblem ? problem.left(kLongestProblem) + u'…' : problem;
        return fail(ErrorCode::FileMalformed, u"%1: %2"_s.arg(name, told));
    }
    std::stable_sort(scenario.events.begin(), scenario.events.end(),
                     [](const auto& a, const auto& b) { return a.at < b.at; });
    return scenario;
}

Result<Scenario> readScenario(const QString& path)
{
    QFile file(path);
    if (!file.open(QIODevice::ReadOnly)) {
        return fail(ErrorCode::FileUnreadable, u"%1: %2"_s.arg(path, file.errorString()));
    }
    return parseScenario(file.readAll(), path);
}

} // namespace trex::sim
