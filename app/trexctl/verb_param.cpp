// SPDX-License-Identifier: GPL-3.0-or-later
// param list, param get
#include "app/trexctl/controllertext.h"
#include "app/trexctl/parameterargument.h"
#include "app/trexctl/verbs.h"

#include <CLI/CLI.hpp>

using namespace Qt::Literals::StringLiterals;

namespace trex {
namespace {

constexpr int kPhysicalDecimals = 4; // more than any scale has

QString title(const ParameterRow& row)
{
    return QCoreApplication::translate("Parameters", row.title);
}

QString defaultText(const ParameterRow& row)
{
    const QString text = parameterText(row, row.defaultRaw);
    // No source gives some defaults: what stands in the table then is a guess (conformance C-63).
    return isGuess(row.defaultGrade) ? Cli::tr("%1 (a guess)").arg(text) : text;
}

QString hexNumber(const ParameterRow& row)
{
    return u"0x"_s + u"%1"_s.arg(row.number, 2, 16, QLatin1Char('0')).toUpper();
}

QJsonObject json(const ParameterRow& row, int raw, bool isPending)
{
    return {{u"number"_s, row.number},
            {u"key"_s, latin(row.key)},
            {u"name"_s, title(row)},
            {u"value"_s, raw},
            {u"default"_s, row.defaultRaw},
            {u"defaultIsGuess"_s, isGuess(row.defaultGrade)},
            {u"unit"_s, latin(row.unit)},
            {u"physical"_s, rounded(physicalFromRaw(row, raw), kPhysicalDecimals)},
            {u"needsReset"_s, row.needsReset},
            {u"pending"_s, isPending}};
}

/// Firmware before 1.2 has no 0x17 (facts.md 2) and does not answer.
bool hasParameter(const Signature& signature, const ParameterRow& row)
{
    const bool isOld = signature.major == 1 && signature.minor < 2;
    return !isOld || row.number != parameterRow("uart-response-delay").number;
}

Required<int> read(Session& session, const ParameterRow& row)
{
    return session.need<int>([&session, &row](const Awaiting<int>::Handler& handler) {
        session.settings().readParameter(row, &session, handler);
    });
}

class ParamListVerb : public Verb {
public:
    [[nodiscard]] bool usesSettings() const override { return true; }
    Task run(Session& session) override
    {
        // The mode shows which channel input source is in force.
        co_await session.ask(query("get-mode"));
        const Signature signature = *session.controller().device().signature;
        QJsonArray array;
        TextTable table({Cli::tr("Number"), Cli::tr("Key"), Cli::tr("Raw"), Cli::tr("Value"),
                         Cli::tr("Default")});
        for (const ParameterRow& row : kParameters) {
            if (row.isTrigger || !hasParameter(signature, row)) {
                continue;
            }
            const int raw = co_await read(session, row);
            const bool isPending = session.settings().isPending(row.number);
            array.append(json(row, raw, isPending));
            const QString text = parameterText(row, raw);
            table.add({hexNumber(row), latin(row.key), QString::number(raw),
                       isPending ? Cli::tr("%1, after a power cycle").arg(text) : text,
                       defaultText(row)});
        }
        session.output().answer(array, table.text());
        session.end();
    }
};

class ParamGetVerb : public Verb {
public:
    [[nodiscard]] bool usesSettings() const override { return true; }
    void declare(CLI::App& app) override
    {
        app.add_option("KEY", m_keyText, Cli::tr("key or number").toStdString())
            ->required()
            ->type_name("");
    }

    Checked check(const OpenOptions&) override
    {
        const auto row = parameterFromText(QString::fromStdString(m_keyText));
        if (!row) {
            return tl::make_unexpected(row.error());
        }
        m_row = *row;
        return {};
    }

    Task run(Session& session) override
    {
        co_await session.ask(query("get-mode"));
        const ParameterRow& row = *m_row;
        const int raw = co_await read(session, row);
        const bool isPending = session.settings().isPending(row.number);
        std::vector<std::pair<QString, QString>> lines{
            {Cli::tr("Parameter"),
             u"%1 (%2, %3)"_s.arg(title(row), latin(row.key), hexNumber(row))},
            {Cli::tr("Value"), Cli::tr("%1 (raw %2)").arg(parameterText(row, raw)).arg(raw)},
            {Cli::tr("Default"), defaultText(row)}};
        if (row.needsReset) {
            lines.emplace_back(Cli::tr("Acts"),
                               isPending ? Cli::tr("after the next power cycle: not in force yet")
                                         : Cli::tr("after a power cycle"));
        }
        session.output().answer(json(row, raw, isPending), labelled(lines));
        session.end();
    }

private:
    std::string m_keyText;
    const ParameterRow* m_row = nullptr;
};

} // namespace

std::unique_ptr<Verb> makeParamList()
{
    return std::make_unique<ParamListVerb>();
}

std::unique_ptr<Verb> makeParamGet()
{
    return std::make_unique<ParamGetVerb>();
}

} // namespace trex
