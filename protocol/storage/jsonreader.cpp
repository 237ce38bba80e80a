// SPDX-License-Identifier: GPL-3.0-or-later
#include "protocol/storage/jsonreader.h"

#include <QCoreApplication>
#include <QJsonDocument>

#include <algorithm>
#include <cmath>

using namespace Qt::Literals::StringLiterals;

namespace trex {
namespace {

struct ConfigFile {
    Q_DECLARE_TR_FUNCTIONS(ConfigFile)
};

QString typeText(const QJsonValue& value)
{
    switch (value.type()) {
    case QJsonValue::Null:
        return ConfigFile::tr("null");
    case QJsonValue::Bool:
        return ConfigFile::tr("true or false");
    case QJsonValue::Double:
        return ConfigFile::tr("a number");
    case QJsonValue::String:
        return ConfigFile::tr("a text");
    case QJsonValue::Array:
        return ConfigFile::tr("a list");
    case QJsonValue::Object:
        return ConfigFile::tr("an object");
    case QJsonValue::Undefined:
        break;
    }
    return ConfigFile::tr("nothing");
}

constexpr QByteArrayView kByteOrderMark("\xEF\xBB\xBF");

/// Empty when it can be UTF-8.
QString encodingProblem(const QByteArray& json)
{
    if (json.startsWith("\xFF\xFE") || json.startsWith("\xFE\xFF")) {
        return ConfigFile::tr("the file is UTF-16; save it as UTF-8");
    }
    return json.contains('\0') ? ConfigFile::tr("there is a NUL byte, which no text has")
                               : QString();
}

/// Where the first line begins that is no UTF-8; no letter's bytes have a line's end in them.
qsizetype firstLineOfOthers(const QByteArray& json)
{
    qsizetype start = 0;
    for (qsizetype end = json.indexOf('\n');
         end >= 0 && QByteArrayView(json).sliced(start, end - start).isValidUtf8();
         end = json.indexOf('\n', start)) {
        start = end + 1;
    }
    return start;
}

/// What the JSON parser says, and more where a person's habit is plain to see.
QString syntaxText(const QJsonParseError& problem, const QByteArray& json)
{
    const auto here =
        QByteArrayView(json).sliced(std::clamp<qsizetype>(problem.offset - 1, 0, json.size()));
    const auto text = here.first(std::min<qsizetype>(here.size(), 3)).trimmed();
    if (text.startsWith('/') || text.startsWith('#')) {
        return ConfigFile::tr("JSON has no comments; write a text under a key of its own, such as "
                              "\"comment\"");
    }
    return problem.errorString();
}

} // namespace

Result<ParsedJson> parseJson(const QByteArray& bytes, const QString& fileName)
{
    // Windows editors begin UTF-8 with a byte order mark.
    const QByteArray json = bytes.startsWith(kByteOrderMark) ? bytes.sliced(3) : bytes;
    const auto wrong = [&](qsizetype offset, const QString& reason) {
        return fail(ErrorCode::FileMalformed,
                    u"%1, %2: %3"_s.arg(fileName, placeText(json, offset), reason));
    };
    if (const QString problem = encodingProblem(json); !problem.isEmpty()) {
        return wrong(json.indexOf('\0'), problem);
    }
    if (json.trimmed().isEmpty()) {
        return wrong(0, ConfigFile::tr("the file is empty"));
    }
    QJsonParseError problem;
    const auto document = QJsonDocument::fromJson(json, &problem);
    if (problem.error != QJsonParseError::NoError) {
        return wrong(problem.offset, syntaxText(problem, json));
    }
    // The parser lets a backslash before any byte pass, and what we wrote of that it would not
    // read.
    if (!json.isValidUtf8()) {
        return wrong(firstLineOfOthers(json),
                     ConfigFile::tr("there are bytes that are no UTF-8; save it as UTF-8"));
    }
    if (!document.isObject()) {
        return wrong(0, ConfigFile::tr("must be an object in braces"));
    }
    return ParsedJson{json, document.object()};
}

JsonReader::JsonReader(const QByteArray& json, QString fileName, std::size_t deepest)
    : m_places(findPlaces(json, deepest)), m_fileName(std::move(fileName))
{
}

QString JsonReader::Node::at(const QString& key) const
{
    return pathOf(path, key);
}

tl::unexpected<Error> JsonReader::wrong(const QString& path, const QString& reason) const
{
    auto found = m_places.keys.find(path);
    // What is missing has no line of its own: that of the object which lacks it.
    for (QString above = path; found == m_places.keys.end() && above.contains(u'.');) {
        above.truncate(above.lastIndexOf(u'.'));
        found = m_places.keys.find(above);
    }
    const QString place = found == m_places.keys.end()
        ? tameText(path)
        : ConfigFile::tr("line %1, %2").arg(QString::number(found->second.line), tameText(path));
    return fail(ErrorCode::FileMalformed, u"%1, %2: %3"_s.arg(m_fileName, place, reason));
}

tl::unexpected<Error> JsonReader::wrongType(const QString& path, const QString& wanted,
                                            const QJsonValue& found) const
{
    return wrong(path, ConfigFile::tr("must be %1, but is %2").arg(wanted, typeText(found)));
}

Result<JsonReader::Node> JsonReader::child(const Node& parent, const QString& key) const
{
    const QJsonValue value = parent.object.value(key);
    if (!value.isObject()) {
        return wrongType(parent.at(key), ConfigFile::tr("an object"), value);
    }
    return Node{value.toObject(), parent.at(key)};
}

Result<double> JsonReader::number(const Node& node, const QString& key, double minimum,
                                  double maximum) const
{
    const QJsonValue value = node.object.value(key);
    if (value.isUndefined()) {
        return wrong(node.at(key), ConfigFile::tr("is missing"));
    }
    if (!value.isDouble()) {
        return wrongType(node.at(key), ConfigFile::tr("a number"), value);
    }
    const double found = value.toDouble();
    if (!(found >= minimum && found <= maximum)) {
        return wrong(
            node.at(key),
            ConfigFile::tr("%1 is out of range (%2…%3)").arg(found).arg(minimum).arg(maximum));
    }
    return found;
}

Result<int> JsonReader::integer(const Node& node, const QString& key, int minimum,
                                int maximum) const
{
    const QJsonValue value = node.object.value(key);
    if (value.isUndefined()) {
        return wrong(node.at(key), ConfigFile::tr("is missing"));
    }
    if (!value.isDouble()) {
        return wrongType(node.at(key), ConfigFile::tr("a whole number"), value);
    }
    const double number = value.toDouble();
    if (number != std::floor(number)) {
        return wrong(node.at(key), ConfigFile::tr("must be a whole number, but is %1").arg(number));
    }
    if (!(number >= minimum && number <= maximum)) { // compared before narrowing
        return wrong(
            node.at(key),
            ConfigFile::tr("%1 is out of range (%2…%3)").arg(number).arg(minimum).arg(maximum));
    }
    return static_cast<int>(number);
}

} // namespace trex
