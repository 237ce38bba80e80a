// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QJsonArray>
#include <QJsonObject>
#include <QString>

#include <utility>
#include <vector>

namespace trex {

/// The answer on stdout: text for people, or JSON with one document a line.
class Output {
public:
    explicit Output(bool isJson) : m_isJson(isJson) { }

    [[nodiscard]] bool isJson() const { return m_isJson; }
    void json(const QJsonObject& document);
    void json(const QJsonArray& document);
    void text(const QString& line);
    /// Whichever was asked for.
    void answer(const QJsonObject& document, const QString& lines);
    void answer(const QJsonArray& document, const QString& lines);
    /// False when stdout has taken something badly (a full disk, a closed pipe).
    [[nodiscard]] bool isGood() const { return m_isGood; }
    /// The other end of the pipe has been closed (`| head`): no failure, and nobody to tell.
    [[nodiscard]] bool isReaderGone() const { return m_isReaderGone; }

private:
    void write(QByteArray line);
    bool m_isJson;
    bool m_isGood = true;
    bool m_isReaderGone = false;
};

/// A number for JSON without digits that nobody measured: 2.2, never 2.2000000000000002.
[[nodiscard]] double rounded(double number, int decimals);

/// Rows of cells under a header, as text whose columns line up.
class TextTable {
public:
    explicit TextTable(std::vector<QString> header) { m_rows.push_back(std::move(header)); }
    void add(std::vector<QString> row) { m_rows.push_back(std::move(row)); }
    [[nodiscard]] QString text() const; ///< no line feed at the end

private:
    std::vector<std::vector<QString>> m_rows;
};

/// "Label      value" lines, values lined up.
[[nodiscard]] QString labelled(const std::vector<std::pair<QString, QString>>& lines);

} // namespace trex
