// SPDX-License-Identifier: GPL-3.0-or-later
#include "protocol/storage/jsonplaces.h"

#include <QCoreApplication>
#include <QJsonArray>
#include <QJsonDocument>
#include <QSet>

#include <algorithm>
#include <vector>

namespace trex {
namespace {

struct Level {
    bool isObject = false;
    bool expectsKey = false;
    QString path;
    QString key; ///< the latest key, whose value comes next
    QSet<QString> keys{};
};

/// The index after the closing quote of the string that opens at `start`.
qsizetype stringEnd(const QByteArray& json, qsizetype start)
{
    qsizetype at = start + 1;
    while (at < json.size() && json.at(at) != '"') {
        at += json.at(at) == '\\' ? 2 : 1;
    }
    return std::min(at + 1, json.size());
}

/// Escapes are QJsonDocument's business: the string goes through it alone.
QString decoded(const QByteArray& quoted)
{
    return QJsonDocument::fromJson('[' + quoted + ']').array().at(0).toString();
}

QString joined(const Level& level)
{
    return level.path.isEmpty() ? level.key : level.path + QLatin1Char('.') + level.key;
}

class Scanner {
public:
    explicit Scanner(const QByteArray& json) : m_json(json) { }

    JsonPlaces scan()
    {
        qsizetype at = 0;
        while (at < m_json.size()) {
            at = step(at);
        }
        return m_places;
    }

private:
    qsizetype step(qsizetype at)
    {
        switch (m_json.at(at)) {
        case '\n':
            ++m_line;
            break;
        case '{':
        case '[':
            enter(m_json.at(at) == '{');
            break;
        case '}':
        case ']':
            if (!m_levels.empty()) {
                m_levels.pop_back();
            }
            break;
        case ',':
            if (!m_levels.empty()) {
                m_levels.back().expectsKey = m_levels.back().isObject;
            }
            break;
        case '"':
            return text(at);
        default:
            break;
        }
        return at + 1;
    }

    void enter(bool isObject)
    {
        const QString path = m_levels.empty() ? QString() : joined(m_levels.back());
        m_levels.push_back({.isObject = isObject, .expectsKey = isObject, .path = path, .key = {}});
    }

    qsizetype text(qsizetype at)
    {
        const qsizetype end = stringEnd(m_json, at);
        if (m_levels.empty() || !m_levels.back().expectsKey) {
            return end;
        }
        auto& level = m_levels.back();
        level.expectsKey = false;
        level.key = decoded(m_json.mid(at, end - at));
        const QString path = joined(level);
        if (level.keys.contains(level.key) && !m_places.duplicate) {
            m_places.duplicate = path;
            m_places.duplicateLine = m_line;
        }
        level.keys.insert(level.key);
        m_places.lines.emplace(path, m_line);
        return end;
    }

    const QByteArray& m_json;
    std::vector<Level> m_levels;
    JsonPlaces m_places;
    int m_line = 1;
};

} // namespace

JsonPlaces findPlaces(const QByteArray& json)
{
    return Scanner(json).scan();
}

QString placeText(const QByteArray& json, qsizetype offset)
{
    const auto before = QByteArrayView(json).first(std::clamp<qsizetype>(offset, 0, json.size()));
    const qsizetype lineStart = before.lastIndexOf('\n') + 1;
    return QCoreApplication::translate("ConfigFile", "line %1, column %2")
        .arg(before.count('\n') + 1)
        .arg(QString::fromUtf8(before.sliced(lineStart)).size() + 1);
}

QString tameText(const QString& text)
{
    constexpr qsizetype kLongest = 60;
    QString tame = text.left(kLongest);
    for (auto& character : tame) {
        if (!character.isPrint() && !character.isSurrogate()) {
            character = QChar::ReplacementCharacter;
        }
    }
    if (!tame.isEmpty() && tame.back().isHighSurrogate()) {
        tame.chop(1);
    }
    return text.size() > kLongest ? tame + QStringLiteral("…") : tame;
}

} // namespace trex
