// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "protocol/storage/benchprofile.h"
#include "protocol/storage/benchtext.h"
#include "protocol/storage/jsonreader.h"

#include <QStringList>

namespace trex {

template <class Value>
[[nodiscard]] QStringList keysOf(std::initializer_list<Value> values)
{
    QStringList keys;
    for (const Value value : values) {
        keys << keyOf(value);
    }
    return keys;
}

/// Walks the parsed document; the first thing that is wrong ends it.
class BenchProfileReader : private JsonReader {
public:
    static constexpr std::size_t kDeepest = 12; ///< three repetitions, and limits in them
    static constexpr double kLongestStep = 24.0 * 3600.0;
    static constexpr double kMostAmperes = 60.0; ///< of 8 bits at 150 mA, rounded up

    BenchProfileReader(const QByteArray& json, const QString& fileName)
        : JsonReader(json, fileName, kDeepest)
    {
    }
    Result<BenchProfile> read(const QJsonObject& object);

private:
    [[nodiscard]] Result<void> readHead(const Node& root);
    [[nodiscard]] Result<void> readNumbers(const Node& root);
    [[nodiscard]] Result<void> readExpect(const Node& root);
    Result<BenchExpectation> readExpectation(const Node& expect, const QString& key);
    Result<std::vector<BenchStep>> readSteps(const Node& parent, int depth);
    Result<BenchStep> readStep(const Node& node, int depth);
    [[nodiscard]] Result<void> readAmounts(const Node& node, BenchStep& step);
    [[nodiscard]] Result<void> readCondition(const Node& node, BenchStep& step);
    Result<BenchLimits> readLimits(const Node& parent);
    Result<BenchComments> comments(const Node& node, const QStringList& known) const;
    Result<QString> text(const Node& node, const QString& key) const;
    /// One of the keys; its place in the list.
    Result<int> choice(const Node& node, const QString& key, const QStringList& choices) const;
    Result<BenchMotor> motor(const Node& node, BenchMotor otherwise) const;
    template <class T>
    Result<void> into(T& target, const Result<T>& read) const
    {
        if (!read) {
            return tl::make_unexpected(read.error());
        }
        target = *read;
        return {};
    }
    /// A number that may be left out.
    Result<void> into(std::optional<double>& target, const Node& node, const QString& key,
                      double minimum, double maximum) const
    {
        if (!node.object.contains(key)) {
            return {};
        }
        const auto read = number(node, key, minimum, maximum);
        if (!read) {
            return tl::make_unexpected(read.error());
        }
        target = *read;
        return {};
    }

    BenchProfile m_profile;
};

} // namespace trex
