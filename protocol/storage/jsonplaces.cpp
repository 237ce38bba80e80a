// SPDX-License-Identifier: GPL-3.0-or-later
#include "protocol/storage/jsonplaces.h"

#include <QCoreApplication>
#include <QJsonArray>
#include <QJsonDocument>
#include <QSet>

#include <algorithm>
#include <limits>
#include <numeric>
#include <vector>

namespace trex {
namespace {

// Paths of what lies deeper, or is longer than any of ours, could fill the memory.
constexpr qsizetype kLongestPath = 400;

struct Level {
    bool isObject = false;
    bool expectsKey = false;
    QString path;
    QString key; ///< the latest key, whose value comes next; in a list the value's number
    int index = 0; ///< in a list: of the value that comes next
    QSet<QString> keys{};
    JsonPlace* place = nullptr; ///< of the latest key, when it is kept
    qsizetype valueStart = 0;
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

class Scanner {
public:
    Scanner(const QByteArray& json, std::size_t deepest) : m_json(json), m_deepest(deepest) { }

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
                endValue(at);
                m_levels.pop_back();
            }
            break;
        case ':':
            if (!m_levels.empty()) {
                m_levels.back().valueStart = at + 1;
            }
            break;
        case ',':
            if (!m_levels.empty()) {
                endValue(at);
                m_levels.back().expectsKey = m_levels.back().isObject;
                ++m_levels.back().index;
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
        const bool isDeep = m_levels.size() >= m_deepest;
        QString path;
        if (!m_levels.empty() && !isDeep) {
            const Level& above = m_levels.back();
            path = pathOf(above.path, above.isObject ? above.key : QString::number(above.index));
            if (!above.isObject && above.path.size() <= kLongestPath) {
                m_places.keys[path] = {m_line, {}, {}}; // for what its object lacks
            }
        }
        m_levels.push_back({.isObject = isObject, .expectsKey = isObject, .path = path, .key = {}});
    }

    void endValue(qsizetype at)
    {
        auto& level = m_levels.back();
        if (JsonPlace* place = std::exchange(level.place, nullptr)) {
            place->value = m_json.mid(level.valueStart, at - level.valueStart).trimmed();
        }
    }

    qsizetype text(qsizetype at)
    {
        const qsizetype end = stringEnd(m_json, at);
        if (m_levels.empty() || !m_levels.back().expectsKey) {
            return end;
        }
        auto& level = m_levels.back();
        level.expectsKey = false;
        const QString before = std::exchange(level.key, decoded(m_json.mid(at, end - at)));
        const QString path = pathOf(level.path, level.key);
        if (level.keys.contains(level.key) && !m_places.duplicate) {
            m_places.duplicate = path;
            m_places.duplicateLine = m_line;
        }
        level.keys.insert(level.key);
        if (m_levels.size() <= m_deepest && level.path.size() <= kLongestPath) {
            level.place = &m_places.keys[path];
            *level.place = {m_line, before, {}};
        }
        return end;
    }

    const QByteArray& m_json;
    std::size_t m_deepest;
    std::vector<Level> m_levels;
    JsonPlaces m_places;
    int m_line = 1;
};

/// Levenshtein's: letters added, left out or changed.
int distance(const QString& a, const QString& b)
{
    std::vector<int> row(static_cast<std::size_t>(b.size()) + 1);
    std::iota(row.begin(), row.end(), 0);
    for (const QChar letter : a) {
        int diagonal = row.front()++;
        for (std::size_t i = 1; i < row.size(); ++i) {
            const int same = diagonal + (letter == b[static_cast<qsizetype>(i) - 1] ? 0 : 1);
            diagonal = row[i];
            row[i] = std::min({same, row[i] + 1, row[i - 1] + 1});
        }
    }
    return row.back();
}

} // namespace

std::optional<QString> nearestKey(const QString& key, const QStringList& known)
{
    constexpr qsizetype kLongest = 40;
    constexpr qsizetype kShort = 6; // one letter off a short word is another word soon enough
    const QString lower = key.left(kLongest).toLower();
    std::optional<QString> nearest;
    int least = std::numeric_limits<int>::max();
    for (const QString& each : known) {
        const int most = each.size() < 3 ? 0 : each.size() < kShort ? 1 : 2;
        const int letters = distance(lower, each);
        if (letters <= most && letters < least) {
            nearest = each;
            least = letters;
        }
    }
    return nearest;
}

QString pathOf(const QString& object, const QString& key)
{
    QString escaped = key;
    escaped.replace(u'\\', QLatin1StringView("\\\\")).replace(u'.', QLatin1StringView("\\."));
    return object.isEmpty() ? escaped : object + QLatin1Char('.') + escaped;
}

JsonPlaces findPlaces(const QByteArray& json, std::size_t deepest)
{
    return Scanner(json, deepest).scan();
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
