// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/trexctl/output.h"

#include <QJsonDocument>
#include <QStringList>

#include <algorithm>
#include <cerrno>
#include <cmath>
#include <cstdio>

namespace trex {

void Output::json(const QJsonObject& document)
{
    write(QJsonDocument(document).toJson(QJsonDocument::Compact));
}

void Output::json(const QJsonArray& document)
{
    write(QJsonDocument(document).toJson(QJsonDocument::Compact));
}

void Output::text(const QString& line)
{
    write(line.toUtf8());
}

void Output::answer(const QJsonObject& document, const QString& lines)
{
    m_isJson ? json(document) : text(lines);
}

void Output::answer(const QJsonArray& document, const QString& lines)
{
    m_isJson ? json(document) : text(lines);
}

void Output::write(QByteArray line)
{
    line += '\n';
    const auto size = static_cast<std::size_t>(line.size());
    m_isGood = std::fwrite(line.constData(), 1, size, stdout) == size && std::fflush(stdout) == 0
        && m_isGood;
    m_isReaderGone = m_isReaderGone || (!m_isGood && errno == EPIPE);
}

double rounded(double number, int decimals)
{
    const double factor = std::pow(10.0, decimals);
    return std::round(number * factor) / factor;
}

QString TextTable::text() const
{
    std::vector<qsizetype> widths;
    for (const auto& row : m_rows) {
        widths.resize(std::max(widths.size(), row.size()));
        for (std::size_t column = 0; column < row.size(); ++column) {
            widths[column] = std::max(widths[column], row[column].size());
        }
    }
    QStringList lines;
    for (const auto& row : m_rows) {
        QString line;
        for (std::size_t column = 0; column < row.size(); ++column) {
            const bool isLast = column + 1 == row.size();
            line += isLast ? row[column] : row[column].leftJustified(widths[column] + 2);
        }
        lines << line;
    }
    return lines.join(u'\n');
}

QString labelled(const std::vector<std::pair<QString, QString>>& lines)
{
    qsizetype width = 0;
    for (const auto& [label, value] : lines) {
        width = std::max(width, label.size());
    }
    QStringList texts;
    for (const auto& [label, value] : lines) {
        texts << label.leftJustified(width + 2) + value;
    }
    return texts.join(u'\n');
}

} // namespace trex
