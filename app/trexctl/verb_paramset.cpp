// SPDX-License-Identifier: GPL-3.0-or-later
// param set, param reset
#include "app/trexctl/controllertext.h"
#include "app/trexctl/parameterargument.h"
#include "app/trexctl/terminal.h"
#include "app/trexctl/verbs.h"

#include <CLI/CLI.hpp>

using namespace Qt::Literals::StringLiterals;

namespace trex {
namespace {

QString powerCycleText()
{
    return Cli::tr("It acts after the controller's power is switched off and on.");
}

class ParamSetVerb : public Verb {
public:
    [[nodiscard]] bool usesSettings() const override { return true; }
    void declare(CLI::App& app) override
    {
        app.add_option("KEY", m_keyText, Cli::tr("key or number").toStdString())
            ->required()
            ->type_name("");
        app.add_option("VALUE", m_valueText,
                       Cli::tr("raw, or with its unit: 500ms, 2.4A").toStdString())
            ->required()
            ->type_name("");
        app.add_flag("--no-verify", m_isUnverified, Cli::tr("do not read it back").toStdString());
    }

    Checked check(const OpenOptions&) override
    {
        const auto row = parameterFromText(QString::fromStdString(m_keyText));
        if (!row) {
            return tl::make_unexpected(row.error());
        }
        m_row = *row;
        const auto value = valueFromText(*m_row, QString::fromStdString(m_valueText));
        if (!value) {
            return tl::make_unexpected(value.error());
        }
        m_value = *value;
        return {};
    }

    Task run(Session& session) override
    {
        using Write = DeviceSettings::ParameterWrite;
        const ParameterRow& row = *m_row;
        const Write write =
            co_await session.need<Write>([this, &session](const Awaiting<Write>::Handler& handler) {
                session.settings().writeParameter(*m_row, m_value.raw, !m_isUnverified, &session,
                                                  handler);
            });
        const bool isVerified = write.verified && !m_isUnverified;
        session.output().answer(
            QJsonObject{{u"key"_s, latin(row.key)},
                        {u"from"_s, write.from},
                        {u"to"_s, write.to},
                        {u"verified"_s, isVerified},
                        {u"needsReset"_s, row.needsReset}},
            u"%1: %2 → %3%4"_s.arg(latin(row.key), parameterText(row, write.from),
                                   parameterText(row, write.to),
                                   isVerified ? Cli::tr(", verified") : QString()));
        if (m_value.isRounded) {
            session.warn(
                Cli::tr("%1 is between two steps: the nearest is %2.")
                    .arg(QString::fromStdString(m_valueText), parameterText(row, write.to)));
        }
        if (row.needsReset && write.from != write.to) {
            session.warn(powerCycleText());
        }
        session.end();
    }

private:
    std::string m_keyText;
    std::string m_valueText;
    bool m_isUnverified = false;
    const ParameterRow* m_row = nullptr;
    TypedValue m_value;
};

class ParamResetVerb : public Verb {
public:
    [[nodiscard]] bool usesSettings() const override { return true; }
    void declare(CLI::App& app) override
    {
        app.add_flag("--yes", m_isConfirmed, Cli::tr("do not ask").toStdString());
    }

    Checked check(const OpenOptions& options) override
    {
        if (m_isConfirmed) {
            return {};
        }
        if (!isAtTerminal()) {
            return usage(
                Cli::tr("A factory reset needs --yes where nobody can be asked. Nothing was "
                        "sent."));
        }
        if (!confirm(Cli::tr("Reset all parameters of the controller on %1 to factory defaults? "
                             "Calibrations stay.")
                         .arg(options.port))) {
            return usage(Cli::tr("Not confirmed. Nothing was sent."));
        }
        return {};
    }

    Task run(Session& session) override
    {
        co_await session.need<void>([&session](const Awaiting<void>::Handler& handler) {
            session.settings().factoryReset(&session, handler);
        });
        session.output().answer(QJsonObject{{u"reset"_s, true}, {u"needsReset"_s, true}},
                                Cli::tr("All parameters are reset to factory defaults."));
        session.warn(powerCycleText());
        session.end();
    }

private:
    bool m_isConfirmed = false;
};

} // namespace

std::unique_ptr<Verb> makeParamSet()
{
    return std::make_unique<ParamSetVerb>();
}

std::unique_ptr<Verb> makeParamReset()
{
    return std::make_unique<ParamResetVerb>();
}

} // namespace trex
