// SPDX-License-Identifier: GPL-3.0-or-later
// checkpoint save, checkpoint list, checkpoint restore, checkpoint delete
#include "app/trexctl/restoreverb.h"
#include "app/trexctl/verbs.h"

#include <CLI/CLI.hpp>

#include <algorithm>

using namespace Qt::Literals::StringLiterals;

namespace trex {
namespace {

void declareName(CLI::App& app, std::string& text)
{
    app.add_option("NAME", text, Cli::tr("of the checkpoint").toStdString())
        ->required()
        ->type_name("");
}

/// Of the port that was given, newest first.
Result<std::vector<Checkpoint>> checkpointsOf(Session& session)
{
    auto all = session.journal().checkpoints(std::nullopt);
    if (all) {
        std::erase_if(*all, [&session](const Checkpoint& each) {
            return each.controller.port != session.options().port;
        });
    }
    return all;
}

class CheckpointSaveVerb : public Verb {
public:
    void declare(CLI::App& app) override { declareName(app, m_nameText); }
    [[nodiscard]] bool usesSettings() const override { return true; }

    Checked check(const OpenOptions&) override
    {
        m_name = QString::fromStdString(m_nameText).simplified();
        return m_name.isEmpty() ? Checked(usage(Cli::tr("A checkpoint needs a name. Nothing was "
                                                        "sent.")))
                                : Checked();
    }

    Task run(Session& session) override
    {
        co_await session.need<qint64>([&](const Awaiting<qint64>::Handler& handler) {
            session.audit().saveCheckpoint(m_name, &session, handler);
        });
        session.output().answer(
            QJsonObject{{u"name"_s, m_name}, {u"saved"_s, true}},
            Cli::tr("The whole configuration is kept as checkpoint %1.").arg(m_name));
        session.end();
    }

private:
    std::string m_nameText;
    QString m_name;
};

class CheckpointListVerb : public Verb {
public:
    [[nodiscard]] Line line() const override { return Line::None; }

    Task run(Session& session) override
    {
        const auto all = checkpointsOf(session);
        if (!all) {
            session.fail(all.error());
            co_return;
        }
        QJsonArray document;
        TextTable table({Cli::tr("Time"), Cli::tr("Controller"), Cli::tr("Name")});
        for (const Checkpoint& each : *all) {
            document.append(QJsonObject{
                {u"name"_s, each.name},
                {u"automatic"_s, each.name.isEmpty()},
                {u"time"_s, each.time.toString(Qt::ISODateWithMs)},
                {u"port"_s, each.controller.port},
                {u"signature"_s, each.controller.signature},
                {u"device"_s,
                 each.controller.device < 0 ? QJsonValue() : QJsonValue(each.controller.device)},
                {u"lastEntry"_s, each.lastEntry}});
            table.add({each.time.toLocalTime().toString(u"yyyy-MM-dd HH:mm:ss"_s),
                       u"%1 %2"_s.arg(each.controller.signature).arg(each.controller.device),
                       each.name.isEmpty() ? Cli::tr("(before a first write)") : each.name});
        }
        session.output().answer(document,
                                all->empty() ? Cli::tr("There is no checkpoint.") : table.text());
        session.end();
    }
};

class CheckpointRestoreVerb : public RestoreVerb {
public:
    void declare(CLI::App& app) override
    {
        declareName(app, m_nameText);
        RestoreVerb::declare(app);
    }

protected:
    Result<Configuration> wanted(Session& session) override
    {
        return session.journal()
            .checkpoint(session.audit().controller(), QString::fromStdString(m_nameText))
            .map([](const Checkpoint& found) { return found.configuration; });
    }

private:
    std::string m_nameText;
};

class CheckpointDeleteVerb : public Verb {
public:
    void declare(CLI::App& app) override { declareName(app, m_nameText); }
    [[nodiscard]] Line line() const override { return Line::None; }

    Task run(Session& session) override
    {
        const QString name = QString::fromStdString(m_nameText);
        const auto all = checkpointsOf(session);
        if (!all) {
            session.fail(all.error());
            co_return;
        }
        const auto isMeant = [&name](const Checkpoint& each) {
            return !name.isEmpty() && each.name == name;
        };
        const auto found = std::ranges::find_if(*all, isMeant);
        const auto howMany = std::ranges::count_if(*all, isMeant);
        if (howMany != 1) {
            session.fail(Failure{
                exitcode::kUsage,
                howMany == 0
                    ? Cli::tr("There is no checkpoint %1 on %2. See: trexctl checkpoint list")
                          .arg(name, session.options().port)
                    : Cli::tr("%1 controllers on %2 have a checkpoint %3: delete it in the window.")
                          .arg(howMany)
                          .arg(session.options().port, name)});
            co_return;
        }
        if (const auto removed = session.journal().removeCheckpoint(found->number); !removed) {
            session.fail(removed.error());
            co_return;
        }
        session.output().answer(QJsonObject{{u"name"_s, name}, {u"deleted"_s, true}},
                                Cli::tr("The checkpoint %1 is deleted.").arg(name));
        session.end();
    }

private:
    std::string m_nameText;
};

} // namespace

std::unique_ptr<Verb> makeCheckpointSave()
{
    return std::make_unique<CheckpointSaveVerb>();
}

std::unique_ptr<Verb> makeCheckpointList()
{
    return std::make_unique<CheckpointListVerb>();
}

std::unique_ptr<Verb> makeCheckpointRestore()
{
    return std::make_unique<CheckpointRestoreVerb>();
}

std::unique_ptr<Verb> makeCheckpointDelete()
{
    return std::make_unique<CheckpointDeleteVerb>();
}

} // namespace trex
