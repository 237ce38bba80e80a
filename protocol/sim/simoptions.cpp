// SPDX-License-Identifier: GPL-3.0-or-later
#include "protocol/sim/simoptions.h"

#include "protocol/codec/parametertable.h"
#include "protocol/sim/factory.h"
#include "protocol/sim/parameterkeys.h"

#include <QUrl>

#include <array>
#include <functional>

namespace trex::sim {

using namespace Qt::Literals::StringLiterals;

namespace {

/// THE quirk table: each value of each quirk, and what it sets. The meanings are in the header.
struct QuirkRow {
    QLatin1StringView name;
    QLatin1StringView value;
    void (*store)(Quirks&);
};
constexpr std::array kQuirks{
    QuirkRow{"calibration-bytes"_L1, "7"_L1, [](Quirks& q) { q.calibrationBits = 7; }},
    QuirkRow{"calibration-bytes"_L1, "8"_L1, [](Quirks& q) { q.calibrationBits = 8; }},
    QuirkRow{"invalid-after"_L1, "100"_L1,
             [](Quirks& q) { q.invalidAfter = std::chrono::milliseconds(100); }},
    QuirkRow{"invalid-after"_L1, "150"_L1,
             [](Quirks& q) { q.invalidAfter = std::chrono::milliseconds(150); }},
    QuirkRow{"motor-reply"_L1, "silent"_L1, [](Quirks& q) { q.motorCommandsAnswerFf = false; }},
    QuirkRow{"motor-reply"_L1, "ff"_L1, [](Quirks& q) { q.motorCommandsAnswerFf = true; }},
    QuirkRow{"null-command"_L1, "silent"_L1, [](Quirks& q) { q.nullCommandIsError = false; }},
    QuirkRow{"null-command"_L1, "error"_L1, [](Quirks& q) { q.nullCommandIsError = true; }},
    QuirkRow{"safe-start"_L1, "off"_L1, [](Quirks& q) { q.safeStart = false; }},
    QuirkRow{"safe-start"_L1, "on"_L1, [](Quirks& q) { q.safeStart = true; }},
    QuirkRow{"serial-timeout"_L1, "on"_L1, [](Quirks& q) { q.serialTimeoutActs = true; }},
    QuirkRow{"serial-timeout"_L1, "off"_L1, [](Quirks& q) { q.serialTimeoutActs = false; }},
    QuirkRow{"unknown-parameter"_L1, "silent"_L1,
             [](Quirks& q) { q.unknownParameterAnswersFf = false; }},
    QuirkRow{"unknown-parameter"_L1, "ff"_L1,
             [](Quirks& q) { q.unknownParameterAnswersFf = true; }},
};

tl::unexpected<Error> wrong(const QString& sentence)
{
    return fail(ErrorCode::OutOfRange, sentence);
}

/// NAME=VALUE in two; an error that names the kind of thing otherwise.
Result<std::pair<QString, QString>> split(const QString& assignment, const QString& what)
{
    const auto equals = assignment.indexOf(u'=');
    if (equals < 1 || equals + 1 == assignment.size()) {
        return wrong(u"%1 \"%2\" is not NAME=VALUE"_s.arg(what, assignment));
    }
    return std::pair{assignment.left(equals), assignment.mid(equals + 1)};
}

Result<int> number(const QString& text, const QString& what, int minimum, int maximum)
{
    bool isNumber = false;
    const int value = text.toInt(&isNumber, 0);
    if (!isNumber || value < minimum || value > maximum) {
        return wrong(u"%1: \"%2\" is not a number from %3 to %4"_s.arg(what, text)
                         .arg(minimum)
                         .arg(maximum));
    }
    return value;
}

Result<bool> flag(const QString& text, const QString& what)
{
    return number(text, what, 0, 1).map([](int value) { return value != 0; });
}

/// Hands a good result on, passes a bad one up.
template <class T, class F>
Result<void> into(const Result<T>& result, F&& store)
{
    if (!result) {
        return tl::make_unexpected(result.error());
    }
    store(*result);
    return {};
}

Result<void> applyDetection(SimOptions& options, const QString& text)
{
    const auto detection = errorDetectionFromKey(text);
    if (!detection) {
        return wrong(u"error-detection: \"%1\" is not none, even, odd or crc7"_s.arg(text));
    }
    options.errorDetection = *detection;
    return {};
}

Result<void> applySeed(SimOptions& options, const QString& text)
{
    bool isNumber = false;
    const quint64 seed = text.toULongLong(&isNumber, 0);
    if (!isNumber) {
        return wrong(u"seed: \"%1\" is not a number"_s.arg(text));
    }
    options.seed = seed;
    return {};
}

Result<void> applySpeed(SimOptions& options, const QString& text)
{
    bool isNumber = false;
    const double speed = text.toDouble(&isNumber);
    if (!isNumber) {
        return wrong(u"speed: \"%1\" is not a number"_s.arg(text));
    }
    options.speed = speed;
    return {};
}

Result<void> applyClock(SimOptions& options, const QString& text)
{
    if (text != "real"_L1 && text != "virtual"_L1) {
        return wrong(u"clock: \"%1\" is not real or virtual"_s.arg(text));
    }
    options.jumpsInTime = text == "virtual"_L1;
    return {};
}

/// THE table of the keys of a "sim:" address.
struct UrlKey {
    QLatin1StringView name;
    Result<void> (*apply)(SimOptions&, const QString&);
};
const std::array kUrlKeys{
    UrlKey{"baud"_L1,
           [](SimOptions& o, const QString& v) {
               return into(number(v, u"baud"_s, 1200, 115200), [&o](int x) { o.baud = x; });
           }},
    UrlKey{"clock"_L1, &applyClock},
    UrlKey{"crc-polynomial"_L1,
           [](SimOptions& o, const QString& v) {
               return into(number(v, u"crc-polynomial"_s, 0x80, 0xFF),
                           [&o](int x) { o.polynomial = static_cast<std::uint8_t>(x); });
           }},
    UrlKey{"echo"_L1,
           [](SimOptions& o, const QString& v) {
               return into(flag(v, u"echo"_s), [&o](bool x) { o.echo = x; });
           }},
    UrlKey{"error-detection"_L1, &applyDetection},
    UrlKey{"fault"_L1, [](SimOptions& o, const QString& v) { return o.applyFault(v); }},
    UrlKey{"firmware"_L1, [](SimOptions& o, const QString& v) { return o.applyFirmware(v); }},
    UrlKey{"mix"_L1,
           [](SimOptions& o, const QString& v) {
               return into(flag(v, u"mix"_s), [&o](bool x) { o.mix = x; });
           }},
    UrlKey{"mode"_L1, [](SimOptions& o, const QString& v) { return o.applyMode(v); }},
    UrlKey{"model"_L1, [](SimOptions& o, const QString& v) { return o.applyModel(v); }},
    UrlKey{"pace"_L1,
           [](SimOptions& o, const QString& v) {
               return into(flag(v, u"pace"_s), [&o](bool x) { o.pace = x; });
           }},
    UrlKey{"param"_L1, [](SimOptions& o, const QString& v) { return o.applyParameter(v); }},
    UrlKey{"quirk"_L1, [](SimOptions& o, const QString& v) { return o.applyQuirk(v); }},
    UrlKey{"scenario"_L1, [](SimOptions& o, const QString& v) { return o.loadScenario(v); }},
    UrlKey{"seed"_L1, &applySeed},
    UrlKey{"speed"_L1, &applySpeed},
    UrlKey{"state"_L1,
           [](SimOptions& o, const QString& v) -> Result<void> {
               o.stateFile = v;
               return {};
           }},
    UrlKey{"stop-bits"_L1,
           [](SimOptions& o, const QString& v) {
               return into(number(v, u"stop-bits"_s, 1, 2), [&o](int x) { o.stopBits = x; });
           }},
};

Result<void> applyUrlKey(SimOptions& options, const QString& name, const QString& value)
{
    for (const auto& row : kUrlKeys) {
        if (name == row.name) {
            return row.apply(options, value);
        }
    }
    return wrong(u"sim: address: unknown key \"%1\""_s.arg(name));
}

} // namespace

std::optional<int> parameterNumber(const QString& keyOrNumber)
{
    bool isNumber = false;
    const int number = keyOrNumber.toInt(&isNumber, 0);
    for (const auto& row : kParameters) {
        const auto key = QLatin1StringView(row.key.data(), static_cast<qsizetype>(row.key.size()));
        if (!row.isTrigger && (keyOrNumber == key || (isNumber && number == row.number))) {
            return row.number;
        }
    }
    return std::nullopt;
}

Result<void> SimOptions::applyParameter(const QString& assignment)
{
    const auto parts = split(assignment, u"parameter"_s);
    if (!parts) {
        return tl::make_unexpected(parts.error());
    }
    const auto parameterIndex = parameterNumber(parts->first);
    if (!parameterIndex) {
        return wrong(u"unknown parameter \"%1\""_s.arg(parts->first));
    }
    bool isNumber = false;
    const int raw = parts->second.toInt(&isNumber, 0);
    if (!isNumber || !takesParameter(*parameterIndex, raw)) {
        const ParameterLimits& limits = parameterLimits(*parameterIndex);
        return wrong(u"parameter %1: \"%2\" is not a raw value from %3 to %4"_s
                         .arg(parts->first, parts->second)
                         .arg(limits.minimum)
                         .arg(limits.maximum));
    }
    parameters[*parameterIndex] = raw;
    return {};
}

Result<void> SimOptions::applyQuirk(const QString& assignment)
{
    const auto parts = split(assignment, u"quirk"_s);
    if (!parts) {
        return tl::make_unexpected(parts.error());
    }
    QStringList values;
    QStringList names;
    for (const auto& row : kQuirks) {
        if (parts->first == row.name && parts->second == row.value) {
            row.store(quirks);
            return {};
        }
        if (parts->first == row.name) {
            values.append(row.value);
        }
        if (!names.contains(row.name)) {
            names.append(row.name);
        }
    }
    if (values.isEmpty()) {
        return wrong(
            u"unknown quirk \"%1\"; there are %2"_s.arg(parts->first, names.join(u", "_s)));
    }
    return wrong(
        u"quirk %1: \"%2\" is not %3"_s.arg(parts->first, parts->second, values.join(u" or "_s)));
}

Result<void> SimOptions::applyFault(const QString& assignment)
{
    const auto parts = split(assignment, u"fault"_s);
    if (!parts) {
        return tl::make_unexpected(parts.error());
    }
    bool isNumber = false;
    const double value = parts->second.toDouble(&isNumber);
    if (!isNumber) {
        return wrong(u"fault %1: \"%2\" is not a number"_s.arg(parts->first, parts->second));
    }
    return faults.apply(parts->first, value);
}

Result<void> SimOptions::applyModel(const QString& name)
{
    if (name != "jr"_L1 && name != "trex"_L1) {
        return wrong(u"model: \"%1\" is not jr or trex"_s.arg(name));
    }
    model = name == "jr"_L1 ? Model::TrexJr : Model::Trex;
    return {};
}

Result<void> SimOptions::applyMode(const QString& name)
{
    constexpr std::array kNames{"rc"_L1, "analog"_L1, "serial"_L1};
    for (std::size_t i = 0; i < kNames.size(); ++i) {
        if (name == kNames[i]) {
            mode = static_cast<JumperMode>(i);
            return {};
        }
    }
    return wrong(u"mode: \"%1\" is not rc, analog or serial"_s.arg(name));
}

Result<void> SimOptions::applyFirmware(const QString& version)
{
    for (int minor = 0; minor <= 3; ++minor) {
        if (version == u"1.%1"_s.arg(minor)) {
            firmware = {1, minor};
            return {};
        }
    }
    return wrong(u"firmware: \"%1\" is not 1.0, 1.1, 1.2 or 1.3"_s.arg(version));
}

Result<void> SimOptions::loadScenario(const QString& path)
{
    return into(readScenario(path), [this](const Scenario& read) { scenario = read; });
}

Result<void> SimOptions::validate() const
{
    constexpr double kFastest = 1e6;
    if (baudIndex(baud) < 0) {
        return wrong(u"baud: the controller has no rate %1"_s.arg(baud));
    }
    if ((polynomial & 0x80) == 0) {
        return wrong(u"crc-polynomial: the top bit of 0x%1 is not set"_s.arg(polynomial, 2, 16,
                                                                             QLatin1Char('0')));
    }
    if (stopBits != 1 && stopBits != 2) {
        return wrong(u"stop-bits: %1 is not 1 or 2"_s.arg(stopBits));
    }
    if (!(speed > 0.0 && speed <= kFastest)) {
        return wrong(u"speed: %1 is not above 0 and at most %2"_s.arg(speed).arg(kFastest));
    }
    constexpr std::size_t kMostDevices = 100;
    if (devices.empty() || devices.size() > kMostDevices) {
        return wrong(u"device: there must be 1 to %1 of them"_s.arg(kMostDevices));
    }
    for (const int device : devices) {
        if (device < 0 || device > 127) {
            return wrong(u"device: %1 is not within 0 to 127"_s.arg(device));
        }
    }
    return {};
}

Result<SimOptions> simOptionsFromUrl(const QString& url)
{
    constexpr auto kScheme = "sim:"_L1;
    if (!url.startsWith(kScheme)) {
        return wrong(u"\"%1\" is not a sim: address"_s.arg(url));
    }
    QString rest = url.mid(kScheme.size());
    if (rest.startsWith(u'?')) {
        rest.remove(0, 1);
    } else if (!rest.isEmpty()) {
        return wrong(u"sim: address: only \"?key=value&…\" may follow, not \"%1\""_s.arg(rest));
    }
    SimOptions options;
    std::vector<int> devices;
    for (const QString& part : rest.split(u'&', Qt::SkipEmptyParts)) {
        const auto parts = split(part, u"sim: address: key"_s);
        if (!parts) {
            return tl::make_unexpected(parts.error());
        }
        const QString value = QUrl::fromPercentEncoding(parts->second.toUtf8());
        Result<void> applied;
        if (parts->first == "device"_L1) {
            applied = into(number(value, u"device"_s, 0, 127),
                           [&devices](int device) { devices.push_back(device); });
        } else {
            applied = applyUrlKey(options, parts->first, value);
        }
        if (!applied) {
            return tl::make_unexpected(applied.error());
        }
    }
    if (!devices.empty()) {
        options.devices = devices;
    }
    if (const auto valid = options.validate(); !valid) {
        return tl::make_unexpected(valid.error());
    }
    return options;
}

} // namespace trex::sim
