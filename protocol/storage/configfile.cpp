// SPDX-License-Identifier: GPL-3.0-or-later
#include "protocol/storage/configfile.h"

#include "protocol/savefile.h"
#include "protocol/storage/configadapt.h"
#include "protocol/storage/jsonplaces.h"

#include <QCoreApplication>
#include <QFile>
#include <QFileInfo>
#include <QJsonArray>
#include <QJsonDocument>

#include <algorithm>

using namespace Qt::Literals::StringLiterals;

namespace trex {
namespace {

/// Any value as JSON on one line.
QString jsonText(const QJsonValue& value)
{
    const auto list = QJsonDocument(QJsonArray{value}).toJson(QJsonDocument::Compact);
    return QString::fromUtf8(list.mid(1, list.size() - 2));
}

/// The members of one object in the order of the format, which QJsonObject does not keep.
class Members {
public:
    Members(const Configuration& configuration, QString path)
        : m_path(std::move(path)), m_unknown(configuration.unknown)
    {
    }

    void add(const QString& key, const QString& json)
    {
        m_members.push_back({key, u"%1: %2"_s.arg(jsonText(key), json)});
    }
    /// Whether members that are none of ours belong here.
    [[nodiscard]] bool hasOthers() const { return !unknownHere().empty(); }
    [[nodiscard]] QString onOneLine() const
    {
        const auto members = texts();
        return members.isEmpty() ? u"{}"_s : u"{ "_s + members.join(u", "_s) + u" }"_s;
    }
    [[nodiscard]] QString onLines(int depth) const
    {
        const auto members = texts();
        const QString indent(qsizetype(4) * depth, u' ');
        const QString separator = u",\n"_s + indent + u"    "_s;
        return members.isEmpty()
            ? u"{}"_s
            : u"{\n"_s + indent + u"    "_s + members.join(separator) + u'\n' + indent + u'}';
    }

private:
    struct Member {
        QString key;
        QString text;
    };
    /// Each unknown member goes behind the one that it stood behind; that may be unknown, too.
    [[nodiscard]] QStringList texts() const
    {
        auto members = m_members;
        auto waiting = unknownHere();
        while (!waiting.empty()) {
            const auto placed = std::ranges::find_if(waiting, [&](const auto& each) {
                return each.second.isEmpty() || indexOf(members, each.second) >= 0;
            });
            const bool isLost = placed == waiting.end(); // its neighbour is no longer there
            const auto next = isLost ? waiting.begin() : placed;
            const auto place = isLost ? std::ssize(members) : indexOf(members, next->second) + 1;
            members.insert(members.begin() + place, next->first);
            waiting.erase(next);
        }
        QStringList all;
        for (const auto& member : members) {
            all << member.text;
        }
        return all;
    }
    /// With the key that each stood behind.
    [[nodiscard]] std::vector<std::pair<Member, QString>> unknownHere() const
    {
        std::vector<std::pair<Member, QString>> here;
        for (auto it = m_unknown.lower_bound({m_path, {}});
             it != m_unknown.end() && it->first.first == m_path; ++it) {
            const QString& key = it->first.second;
            here.push_back({{key, jsonText(key) + u": "_s + QString::fromUtf8(it->second.json)},
                            it->second.after});
        }
        return here;
    }
    /// −1: not there, also for no key at all.
    static std::ptrdiff_t indexOf(const std::vector<Member>& members, const QString& key)
    {
        const auto found = std::ranges::find(members, key, &Member::key);
        return key.isEmpty() || found == members.end() ? -1 : found - members.begin();
    }
    QString m_path;
    const std::map<std::pair<QString, QString>, UnknownMember>& m_unknown;
    std::vector<Member> m_members;
};

/// "500", "2.4": as many decimals as the unit has, without zeros that say nothing.
QString physicalText(const ParameterRow& row, int raw, Model model)
{
    QString text = QString::number(physicalFromRaw(row, raw, model), 'f', row.decimals);
    while (text.contains(u'.') && (text.endsWith(u'0') || text.endsWith(u'.'))) {
        text.chop(1);
    }
    return text;
}

QString parametersJson(const Configuration& configuration)
{
    Members parameters(configuration, u"parameters"_s);
    for (const auto& [number, raw] : configuration.parameters) {
        const auto* const row = findParameter(number);
        // What a controller gave for a parameter that it does not have (conformance C-59) is no
        // setting: the file could not be read again.
        if (row == nullptr || row->isTrigger || !accepts(*row, raw)) {
            continue;
        }
        Members members(configuration, u"parameters."_s + keyText(*row));
        members.add(u"raw"_s, QString::number(raw));
        members.add(u"physical"_s, physicalText(*row, raw, modelOf(configuration.signature)));
        members.add(u"unit"_s, jsonText(QString::fromLatin1(row->unit)));
        parameters.add(keyText(*row), members.onOneLine());
    }
    return parameters.onLines(1);
}

QString calibrationJson(const Configuration& configuration, const Calibration& calibration,
                        const QString& path)
{
    Members members(configuration, path);
    members.add(u"minimum"_s, QString::number(calibration.minimum));
    members.add(u"neutral"_s, QString::number(calibration.neutral));
    members.add(u"maximum"_s, QString::number(calibration.maximum));
    members.add(u"deadband"_s, QString::number(calibration.deadband));
    return members.onOneLine();
}

QString calibrationsJson(const Configuration& configuration)
{
    Members sets(configuration, u"calibration"_s);
    for (const InputKind input : {InputKind::Rc, InputKind::Analog}) {
        const QString path = u"calibration."_s + keyOf(input);
        Members members(configuration, path);
        const auto set = configuration.calibrations.find(input);
        if (set != configuration.calibrations.end()) {
            for (const auto& [channel, calibration] : set->second) {
                const QString place = u"%1.%2"_s.arg(path).arg(channel);
                members.add(QString::number(channel),
                            calibrationJson(configuration, calibration, place));
            }
        } else if (!members.hasOthers()) {
            continue; // with a comment, or what a newer program knows, the set is there
        }
        sets.add(keyOf(input), members.onLines(2));
    }
    return sets.onLines(1);
}

/// With the comments of the file that it is about to replace, if that is a configuration.
Configuration withCommentsOf(const Configuration& configuration, const QString& path)
{
    Configuration all = configuration;
    const auto former =
        QFileInfo(path).isFile() ? loadConfiguration(path) : fail(ErrorCode::FileUnreadable);
    if (former) {
        for (const auto& [place, member] : former->unknown) {
            if (member.isComment()) {
                all.unknown.try_emplace(place, member);
            }
        }
    }
    return all;
}

} // namespace

QByteArray writeConfiguration(const Configuration& configuration)
{
    Members root(configuration, {});
    root.add(u"format"_s, jsonText(u"trexpanel-configuration"_s));
    root.add(u"version"_s, QString::number(configuration.version));
    if (configuration.saved.isValid()) {
        root.add(u"saved"_s, jsonText(configuration.saved.toUTC().toString(Qt::ISODate)));
    }
    Members device(configuration, u"device"_s);
    if (!configuration.signature.isEmpty()) {
        device.add(u"signature"_s, jsonText(configuration.signature));
    }
    if (!configuration.firmware.isEmpty()) {
        device.add(u"firmware"_s, jsonText(configuration.firmware));
    }
    if (configuration.deviceNumber) {
        device.add(u"number"_s, QString::number(*configuration.deviceNumber));
    }
    root.add(u"device"_s, device.onOneLine());
    root.add(u"parameters"_s, parametersJson(configuration));
    root.add(u"calibration"_s, calibrationsJson(configuration));
    return root.onLines(0).toUtf8() + '\n';
}

Result<Configuration> loadConfiguration(const QString& path)
{
    // A pipe or a device could keep us waiting for ever: only what has a size is opened.
    const QFileInfo info(path);
    if (info.exists() && !info.isFile()) {
        return fail(ErrorCode::FileUnreadable,
                    QCoreApplication::translate("ConfigFile", "%1 (no ordinary file)").arg(path));
    }
    QFile file(path);
    if (!file.open(QIODevice::ReadOnly)) {
        return fail(ErrorCode::FileUnreadable, u"%1 (%2)"_s.arg(path, file.errorString()));
    }
    const QByteArray json = file.read(kLargestConfigurationBytes + 1);
    if (file.error() != QFileDevice::NoError) {
        return fail(ErrorCode::FileUnreadable, u"%1 (%2)"_s.arg(path, file.errorString()));
    }
    return parseConfiguration(json, path);
}

bool UnknownMember::isComment() const
{
    const auto value = QJsonDocument::fromJson('[' + json + ']').array().at(0);
    const auto list = value.toArray();
    return value.isString()
        || (!list.isEmpty()
            && std::ranges::all_of(list, [](const QJsonValue& each) { return each.isString(); }));
}

Result<void> saveConfiguration(const Configuration& configuration, const QString& path)
{
    const QByteArray json = writeConfiguration(withCommentsOf(configuration, path));
    SaveFile file(path);
    if (!file.open(QIODevice::WriteOnly) || file.write(json) != json.size() || !file.commit()) {
        return fail(ErrorCode::FileUnwritable, u"%1 (%2)"_s.arg(path, file.errorString()));
    }
    return {};
}

QString remarkOn(const Configuration& configuration)
{
    const bool isNewer = configuration.version > Configuration::kVersion;
    QStringList keys;
    for (const auto& [place, member] : configuration.unknown) {
        if (isNewer || !member.isComment()) {
            keys << tameText(pathOf(place.first, place.second));
        }
    }
    if (!isNewer) {
        return keys.isEmpty() ? QString()
                              : QCoreApplication::translate(
                                    "ConfigFile", "Not understood and left alone in the file: %1.")
                                    .arg(keys.join(u", "_s));
    }
    if (keys.isEmpty()) {
        return QCoreApplication::translate("ConfigFile",
                                           "The file was written by a newer program (version %1).")
            .arg(configuration.version);
    }
    return QCoreApplication::translate("ConfigFile",
                                       "The file was written by a newer program (version %1); not "
                                       "understood and left out: %2.")
        .arg(QString::number(configuration.version), keys.join(u", "_s));
}

QString keyText(const ParameterRow& row)
{
    return QString::fromLatin1(row.key.data(), static_cast<qsizetype>(row.key.size()));
}

QLatin1StringView keyOf(InputKind input)
{
    return input == InputKind::Rc ? "rc"_L1 : "analog"_L1;
}

} // namespace trex
