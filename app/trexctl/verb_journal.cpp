// SPDX-License-Identifier: GPL-3.0-or-later
// journal, journal revert
#include "app/common/numbers.h"
#include "app/trexctl/restoreverb.h"
#include "app/trexctl/verbs.h"
#include "protocol/codec/packet.h"

#include <CLI/CLI.hpp>

#include <algorithm>

using namespace Qt::Literals::StringLiterals;

namespace trex {
namespace {

/// Raw, as the configuration file has it: a number, or the four of a calibration.
QJsonValue json(const std::optional<SettingValue>& value)
{
    if (!value) {
        return {};
    }
    if (const auto* const raw = std::get_if<int>(&*value)) {
        return *raw;
    }
    const auto& calibration = std::get<Calibration>(*value);
    return QJsonObject{{u"minimum"_s, calibration.minimum},
                       {u"neutral"_s, calibration.neutral},
                       {u"maximum"_s, calibration.maximum},
                       {u"deadband"_s, calibration.deadband}};
}

QJsonObject json(const JournalEntry& entry)
{
    return {{u"number"_s, entry.number},
            {u"time"_s, entry.time.toString(Qt::ISODateWithMs)},
            {u"port"_s, entry.controller.port},
            {u"signature"_s, entry.controller.signature},
            {u"device"_s,
             entry.controller.device < 0 ? QJsonValue() : QJsonValue(entry.controller.device)},
            {u"program"_s, entry.program},
            {u"key"_s, keyOf(entry.intent.setting)},
            {u"from"_s, json(entry.intent.before)},
            {u"to"_s, json(entry.intent.after)},
            {u"found"_s, json(entry.conclusion.found)},
            {u"packet"_s, toHex(entry.intent.packet)},
            {u"result"_s, keyOf(entry.conclusion.result)}};
}

class JournalVerb : public Verb {
public:
    void declare(CLI::App& app) override
    {
        app.add_flag("--all", m_isAll, Cli::tr("of all ports, not only of --port").toStdString());
    }
    [[nodiscard]] Line line() const override { return Line::None; }

    Task run(Session& session) override
    {
        auto entries = session.journal().entries({});
        if (!entries) {
            session.fail(entries.error());
            co_return;
        }
        if (!m_isAll) {
            std::erase_if(*entries, [&session](const JournalEntry& entry) {
                return entry.controller.port != session.options().port;
            });
        }
        std::ranges::reverse(*entries); // the newest where the eye is in a terminal
        QJsonArray document;
        TextTable table({Cli::tr("No."), Cli::tr("Time"), Cli::tr("Port"), Cli::tr("Setting"),
                         Cli::tr("Change"), Cli::tr("Result")});
        for (const JournalEntry& entry : *entries) {
            document.append(json(entry));
            table.add({QString::number(entry.number),
                       entry.time.toLocalTime().toString(u"yyyy-MM-dd HH:mm:ss"_s),
                       entry.controller.port, titleOf(entry.intent.setting), changeText(entry),
                       resultText(entry)});
        }
        session.output().answer(document,
                                entries->empty() ? Cli::tr("Nothing was written.") : table.text());
        if (const QString remark = session.journal().takeRemark(); !remark.isEmpty()) {
            session.warn(remark);
        }
        session.end();
        co_return;
    }

private:
    bool m_isAll = false;
};

class JournalRevertVerb : public RestoreVerb {
public:
    void declare(CLI::App& app) override
    {
        app.add_option("N", m_numberText,
                       Cli::tr("the entry; it and all after it are undone").toStdString())
            ->required()
            ->type_name("");
        RestoreVerb::declare(app);
    }

    Checked check(const OpenOptions&) override
    {
        return checked(numberInRange("N", QString::fromStdString(m_numberText), 1,
                                     std::numeric_limits<int>::max())
                           .map([this](int number) { m_number = number; }));
    }

protected:
    Result<Configuration> wanted(Session& session) override
    {
        return session.journal()
            .entries({.controller = session.audit().controller(), .setting = {}, .from = m_number})
            .and_then([&](const std::vector<JournalEntry>& mine) -> Result<Configuration> {
                if (mine.empty() || mine.back().number != m_number) {
                    return fail(ErrorCode::OutOfRange,
                                Cli::tr("journal entry %1 of this controller").arg(m_number));
                }
                return session.journal().stateBefore(mine.back());
            });
    }

private:
    std::string m_numberText;
    int m_number = 0;
};

} // namespace

std::unique_ptr<Verb> makeJournal()
{
    return std::make_unique<JournalVerb>();
}

std::unique_ptr<Verb> makeJournalRevert()
{
    return std::make_unique<JournalRevertVerb>();
}

} // namespace trex
