// SPDX-License-Identifier: GPL-3.0-or-later
#include "protocol/storage/jsonreader.h"

#include <QCoreApplication>

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

} // namespace

JsonReader::JsonReader(const QByteArray& json, QString fileName)
    : m_places(findPlaces(json)), m_fileName(std::move(fileName))
{
}

QString JsonReader::Node::at(const QString& key) const
{
    return path.isEmpty() ? key : path + u'.' + key;
}

tl::unexpected<Error> JsonReader::wrong(const QString& path, const QString& reason) const
{
    const auto line = m_places.lines.find(path);
    const QString place = line == m_places.lines.end()
        ? tameText(path)
        : ConfigFile::tr("line %1, %2").arg(QString::number(line->second), tameText(path));
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
