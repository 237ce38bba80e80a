// SPDX-License-Identifier: GPL-3.0-or-later
#include "protocol/codec/replies.h"
#include "protocol/errortext.h"
#include "protocol/storage/configadapt.h"
#include "protocol/storage/configfile.h"
#include "protocol/storage/jsonplaces.h"
#include "protocol/storage/jsonreader.h"

#include <QCoreApplication>
#include <QRegularExpression>

#include <cmath>

using namespace Qt::Literals::StringLiterals;

namespace trex {
namespace {

struct ConfigFile {
    Q_DECLARE_TR_FUNCTIONS(ConfigFile)
};

/// Walks the parsed document and builds the configuration; the first thing that is wrong ends it.
class Reader : private JsonReader {
public:
    using JsonReader::JsonReader;

    Result<Configuration> read(const QJsonObject& root);

private:
    /// Whether other keys than ours may stand for more than a comment.
    enum class Others : std::uint8_t { MayBeAnything, AreComments };
    /// Keeps keys that are not in `known`: whatever they hold in a file of a newer program, else
    /// comments. What looks like a mistyped key of ours is refused.
    Result<void> keepOthers(const Node& node, const QStringList& known, Others others);
    [[nodiscard]] Result<void> checkOther(const Node& node, const QString& key,
                                          const UnknownMember& member, const QStringList& known,
                                          Others others) const;

    Result<void> readHead(const Node& root);
    Result<void> readSaved(const Node& root);
    Result<void> readDevice(const Node& root);
    Result<void> readFirmware(const Node& device);
    Result<void> readParameters(const Node& root);
    Result<void> readParameter(const Node& parameters, const QString& key, const ParameterRow& row);
    Result<void> checkPhysical(const Node& node, const ParameterRow& row, int raw) const;
    Result<void> readCalibrations(const Node& root);
    Result<void> readSet(const Node& calibrations, InputKind input);
    Result<Calibration> readCalibration(const Node& set, const QString& channel);

    Configuration m_configuration;
};

Result<void> Reader::keepOthers(const Node& node, const QStringList& known, Others others)
{
    for (const QString& key : node.object.keys()) {
        if (known.contains(key)) {
            continue;
        }
        const auto place = places().keys.find(node.at(key));
        if (place == places().keys.end()) {
            continue; // every key of ours has its place
        }
        const UnknownMember member{place->second.after, place->second.value};
        if (m_configuration.version <= Configuration::kVersion) {
            if (auto checked = checkOther(node, key, member, known, others); !checked) {
                return checked;
            }
        }
        m_configuration.unknown[{node.path, key}] = member;
    }
    return {};
}

Result<void> Reader::checkOther(const Node& node, const QString& key, const UnknownMember& member,
                                const QStringList& known, Others others) const
{
    if (const auto meant = nearestKey(key, known)) {
        return wrong(node.at(key), ConfigFile::tr("is not known; is %1 meant?").arg(*meant));
    }
    if (others == Others::AreComments && !member.isComment()) {
        return wrong(node.at(key),
                     ConfigFile::tr("is not known here, and no comment, which would be a text"));
    }
    return {};
}

Result<Configuration> Reader::read(const QJsonObject& object)
{
    if (places().duplicate) {
        return fail(ErrorCode::FileMalformed,
                    u"%1, %2"_s.arg(fileName(),
                                    ConfigFile::tr("line %1, %2: stands twice")
                                        .arg(QString::number(places().duplicateLine),
                                             tameText(*places().duplicate))));
    }
    const Node root{object, {}};
    using Step = Result<void> (Reader::*)(const Node&);
    for (const Step step : {&Reader::readHead, &Reader::readSaved, &Reader::readDevice,
                            &Reader::readParameters, &Reader::readCalibrations}) {
        if (auto done = (this->*step)(root); !done) {
            return tl::make_unexpected(done.error());
        }
    }
    return m_configuration;
}

Result<void> Reader::readHead(const Node& root)
{
    const QJsonValue format = root.object.value("format"_L1);
    if (format.toString() != "trexpanel-configuration"_L1) {
        return wrong(
            u"format"_s,
            ConfigFile::tr("must be \"trexpanel-configuration\": this is no configuration file"));
    }
    const auto version = integer(root, u"version"_s, 1, 1'000'000);
    if (!version) {
        return tl::make_unexpected(version.error());
    }
    m_configuration.version = *version;
    if (!root.object.contains("parameters"_L1) && !root.object.contains("calibration"_L1)) {
        return wrong(u"parameters"_s, ConfigFile::tr("is missing, and so is calibration"));
    }
    return keepOthers(
        root,
        {u"format"_s, u"version"_s, u"saved"_s, u"device"_s, u"parameters"_s, u"calibration"_s},
        Others::MayBeAnything);
}

Result<void> Reader::readSaved(const Node& root)
{
    const QJsonValue saved = root.object.value("saved"_L1);
    if (saved.isUndefined()) {
        return {};
    }
    if (!saved.isString()) {
        return wrongType(u"saved"_s, ConfigFile::tr("a time such as 2026-11-22T14:00:00Z"), saved);
    }
    static const QRegularExpression shape(
        u"^\\d{4}-\\d\\d-\\d\\dT\\d\\d:\\d\\d:\\d\\d(\\.\\d{1,9})?(Z|[+-]\\d\\d:\\d\\d)$"_s);
    const QString text = saved.toString();
    auto time = QDateTime::fromString(text, Qt::ISODate).toUTC();
    if (!shape.match(text).hasMatch() || !time.isValid() || time.date().year() < 1
        || time.date().year() > 9999) {
        return wrong(
            u"saved"_s,
            ConfigFile::tr("%1 is no time such as 2026-11-22T14:00:00Z").arg(tameText(text)));
    }
    m_configuration.saved = QDateTime::fromSecsSinceEpoch(time.toSecsSinceEpoch(), Qt::UTC);
    return {};
}

Result<void> Reader::readDevice(const Node& root)
{
    if (!root.object.contains("device"_L1)) {
        return {};
    }
    const auto device = child(root, u"device"_s);
    if (!device) {
        return tl::make_unexpected(device.error());
    }
    const QJsonValue signature = device->object.value("signature"_L1);
    if (!signature.isUndefined() && !signature.isString()) {
        return wrongType(device->at(u"signature"_s), ConfigFile::tr("a text"), signature);
    }
    if (signature.isString() && !parseSignature(signature.toString().toUtf8())) {
        return wrong(device->at(u"signature"_s),
                     ConfigFile::tr("%1 is not the signature of a TReX")
                         .arg(tameText(signature.toString())));
    }
    m_configuration.signature = signature.toString();
    if (auto read = readFirmware(*device); !read) {
        return read;
    }
    if (device->object.contains("number"_L1)) {
        const auto number = integer(*device, u"number"_s, 0, 127);
        if (!number) {
            return tl::make_unexpected(number.error());
        }
        m_configuration.deviceNumber = *number;
    }
    return keepOthers(*device, {u"signature"_s, u"firmware"_s, u"number"_s}, Others::MayBeAnything);
}

/// The signature holds it, too: a hand-edited file may say either, but not both otherwise.
Result<void> Reader::readFirmware(const Node& device)
{
    const QJsonValue firmware = device.object.value("firmware"_L1);
    if (firmware.isUndefined()) {
        return {};
    }
    const QString place = device.at(u"firmware"_s);
    const QString text = firmware.toString();
    static const QRegularExpression shape(u"^\\d\\.\\d$"_s);
    if (!shape.match(text).hasMatch()) {
        return wrong(place, ConfigFile::tr("must be a text such as \"1.2\""));
    }
    const auto signature = parseSignature(m_configuration.signature.toUtf8());
    if (signature && signature->firmware() != text) {
        return wrong(place,
                     ConfigFile::tr("%1 disagrees with the signature, %2")
                         .arg(tameText(text), m_configuration.signature));
    }
    m_configuration.firmware = text;
    return {};
}

Result<void> Reader::readParameters(const Node& root)
{
    if (!root.object.contains("parameters"_L1)) {
        return {};
    }
    const auto parameters = child(root, u"parameters"_s);
    if (!parameters) {
        return tl::make_unexpected(parameters.error());
    }
    QStringList known;
    for (const auto& row : kParameters) {
        const QString key = keyText(row);
        known << key;
        if (!parameters->object.contains(key)) {
            continue;
        }
        if (auto read = readParameter(*parameters, key, row); !read) {
            return read;
        }
    }
    return keepOthers(*parameters, known, Others::AreComments);
}

Result<void> Reader::readParameter(const Node& parameters, const QString& key,
                                   const ParameterRow& row)
{
    if (row.isTrigger) {
        return wrong(parameters.at(key), ConfigFile::tr("is a command and not a setting"));
    }
    const auto node = child(parameters, key);
    if (!node) {
        return tl::make_unexpected(node.error());
    }
    // First, since a slip of a key leaves the key itself missing.
    if (auto kept = keepOthers(*node, {u"raw"_s, u"physical"_s, u"unit"_s}, Others::MayBeAnything);
        !kept) {
        return kept;
    }
    const auto raw = integer(*node, u"raw"_s, row.minimum, row.maximum);
    if (!raw) {
        return tl::make_unexpected(raw.error());
    }
    if (!accepts(row, *raw)) {
        return wrong(node->at(u"raw"_s),
                     ConfigFile::tr("%1 is no value of this parameter").arg(*raw));
    }
    if (auto checked = checkPhysical(*node, row, *raw); !checked) {
        return checked;
    }
    m_configuration.parameters[row.number] = *raw;
    return {};
}

Result<void> Reader::checkPhysical(const Node& node, const ParameterRow& row, int raw) const
{
    const auto unit = QString::fromLatin1(row.unit);
    const QJsonValue saidUnit = node.object.value("unit"_L1);
    if (!saidUnit.isUndefined() && !saidUnit.isString()) {
        return wrongType(node.at(u"unit"_s), ConfigFile::tr("a text"), saidUnit);
    }
    if (saidUnit.isString() && saidUnit.toString() != unit) {
        return wrong(node.at(u"unit"_s),
                     ConfigFile::tr("is \"%1\", but this parameter's unit is \"%2\"")
                         .arg(tameText(saidUnit.toString()), unit));
    }
    const QJsonValue physical = node.object.value("physical"_L1);
    if (physical.isUndefined()) {
        return {};
    }
    if (!physical.isDouble()) {
        return wrongType(node.at(u"physical"_s), ConfigFile::tr("a number"), physical);
    }
    const double expected = physicalFromRaw(row, raw, modelOf(m_configuration.signature));
    const double tolerance = 0.5 * std::pow(10.0, -row.decimals);
    // Files of a TReX were written with the TReX Jr's scale before its own was used.
    const auto differs = [&](double value) {
        return !(std::abs(physical.toDouble() - value) < tolerance);
    };
    if (differs(expected) && differs(physicalFromRaw(row, raw, Model::TrexJr))) {
        return wrong(node.at(u"physical"_s),
                     ConfigFile::tr("%1 disagrees with raw %2, which is %3")
                         .arg(QString::number(physical.toDouble()), QString::number(raw),
                              QString::number(expected, 'f', row.decimals) + u' ' + unit)
                         .trimmed());
    }
    return {};
}

Result<void> Reader::readCalibrations(const Node& root)
{
    if (!root.object.contains("calibration"_L1)) {
        return {};
    }
    const auto calibrations = child(root, u"calibration"_s);
    if (!calibrations) {
        return tl::make_unexpected(calibrations.error());
    }
    QStringList known;
    for (const auto input : {InputKind::Rc, InputKind::Analog}) {
        known << keyOf(input);
        if (!calibrations->object.contains(keyOf(input))) {
            continue;
        }
        if (auto read = readSet(*calibrations, input); !read) {
            return read;
        }
    }
    return keepOthers(*calibrations, known, Others::AreComments);
}

Result<void> Reader::readSet(const Node& calibrations, InputKind input)
{
    const auto set = child(calibrations, keyOf(input));
    if (!set) {
        return tl::make_unexpected(set.error());
    }
    QStringList known;
    for (int channel = 1; channel <= kChannelCount; ++channel) {
        const QString key = QString::number(channel);
        known << key;
        if (!set->object.contains(key)) {
            continue;
        }
        const auto calibration = readCalibration(*set, key);
        if (!calibration) {
            return tl::make_unexpected(calibration.error());
        }
        m_configuration.calibrations[input][channel] = *calibration;
    }
    return keepOthers(*set, known, Others::AreComments);
}

Result<Calibration> Reader::readCalibration(const Node& set, const QString& channel)
{
    const auto node = child(set, channel);
    if (!node) {
        return tl::make_unexpected(node.error());
    }
    Calibration calibration;
    const std::array<std::pair<QString, int*>, 4> fields{{{u"minimum"_s, &calibration.minimum},
                                                          {u"neutral"_s, &calibration.neutral},
                                                          {u"maximum"_s, &calibration.maximum},
                                                          {u"deadband"_s, &calibration.deadband}}};
    QStringList known;
    for (const auto& [key, target] : fields) {
        known << key;
    }
    if (auto kept = keepOthers(*node, known, Others::AreComments); !kept) {
        return tl::make_unexpected(kept.error());
    }
    for (const auto& [key, target] : fields) {
        const auto number = integer(*node, key, 0, kLargestCalibrationValue);
        if (!number) {
            return tl::make_unexpected(number.error());
        }
        *target = *number;
    }
    // Conformance C-36; the sentence names the first of the two that are out of order.
    if (calibration.minimum > calibration.neutral) {
        return wrong(node->at(u"minimum"_s),
                     ConfigFile::tr("%1 is above neutral, %2")
                         .arg(calibration.minimum)
                         .arg(calibration.neutral));
    }
    if (calibration.neutral > calibration.maximum) {
        return wrong(node->at(u"neutral"_s),
                     ConfigFile::tr("%1 is above maximum, %2")
                         .arg(calibration.neutral)
                         .arg(calibration.maximum));
    }
    if (calibration.minimum == calibration.maximum) {
        return wrong(node->at(u"maximum"_s),
                     ConfigFile::tr("%1 equals minimum").arg(calibration.maximum));
    }
    return calibration;
}

} // namespace

Result<Configuration> parseConfiguration(const QByteArray& bytes, const QString& fileName)
{
    if (bytes.size() > kLargestConfigurationBytes) {
        return fail(ErrorCode::FileMalformed,
                    u"%1: %2"_s.arg(
                        fileName, ConfigFile::tr("larger than 1 MiB, which no configuration is")));
    }
    const auto parsed = parseJson(bytes, fileName);
    return parsed ? Reader(parsed->text, fileName).read(parsed->object)
                  : tl::make_unexpected(parsed.error());
}

} // namespace trex
