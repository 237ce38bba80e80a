// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "protocol/result.h"
#include "protocol/storage/jsonplaces.h"

#include <QJsonObject>

namespace trex {

struct ParsedJson {
    QByteArray text; ///< without a byte order mark
    QJsonObject object;
};
/// A whole JSON file. FileMalformed: no UTF-8, no JSON, no object; with line, column and reason.
[[nodiscard]] Result<ParsedJson> parseJson(const QByteArray& bytes, const QString& fileName);

/// Takes values out of a parsed JSON file; each error is FileMalformed and says file, line, key and
/// reason. Pure.
class JsonReader {
public:
    /// An object of the file and where it stands.
    struct Node {
        QJsonObject object;
        QString path;
        [[nodiscard]] QString at(const QString& key) const;
    };

    /// `json` must be well formed. `deepest`: as findPlaces().
    JsonReader(const QByteArray& json, QString fileName, std::size_t deepest = 6);

    [[nodiscard]] const JsonPlaces& places() const { return m_places; }
    [[nodiscard]] const QString& fileName() const { return m_fileName; }
    [[nodiscard]] tl::unexpected<Error> wrong(const QString& path, const QString& reason) const;
    [[nodiscard]] tl::unexpected<Error> wrongType(const QString& path, const QString& wanted,
                                                  const QJsonValue& found) const;
    [[nodiscard]] Result<Node> child(const Node& parent, const QString& key) const;
    [[nodiscard]] Result<int> integer(const Node& node, const QString& key, int minimum,
                                      int maximum) const;
    [[nodiscard]] Result<double> number(const Node& node, const QString& key, double minimum,
                                        double maximum) const;

private:
    JsonPlaces m_places;
    QString m_fileName;
};

} // namespace trex
