// SPDX-License-Identifier: GPL-3.0-or-later
// config save, config load, config diff
#include "app/trexctl/verbs.h"
#include "protocol/codec/packet.h"
#include "protocol/procedures/configtransfer.h"

#include <QDir>
#include <QFileInfo>

#include <CLI/CLI.hpp>

using namespace Qt::Literals::StringLiterals;

namespace trex {
namespace {

class ConfigVerb : public Verb {
public:
    void declare(CLI::App& app) override
    {
        app.add_option("FILE", m_fileText, Cli::tr("configuration file (JSON)").toStdString())
            ->required()
            ->type_name("");
    }

protected:
    [[nodiscard]] QString path() const { return QString::fromStdString(m_fileText); }

    /// Everything that the controller holds.
    Required<Configuration> readController(Session& session)
    {
        m_transfer = std::make_unique<ConfigTransfer>(session.controller(), session.settings());
        return session.need<Configuration>([this, &session](
                                               const Awaiting<Configuration>::Handler& handler) {
            QObject::connect(m_transfer.get(), &ConfigTransfer::readFinished, &session, handler);
            m_transfer->read();
        });
    }

    static TransferPlan planFor(Session& session, const Configuration& present,
                                const Configuration& wanted)
    {
        const auto mode = session.controller().device().mode;
        return planTransfer(present, wanted, mode ? std::optional(inputOf(*mode)) : std::nullopt);
    }

    static QJsonObject json(const TransferPlan& plan)
    {
        QJsonArray changed;
        for (const auto& change : plan.changes()) {
            changed.append(
                QJsonObject{{u"key"_s, change.key},
                            {u"from"_s, change.from ? QJsonValue(*change.from) : QJsonValue()},
                            {u"to"_s, change.to}});
        }
        return {{u"changed"_s, changed}, {u"needsReset"_s, plan.needsReset()}};
    }

    static QString text(const TransferPlan& plan)
    {
        QStringList lines;
        for (const auto& write : plan.writes) {
            lines << write.text();
        }
        return lines.isEmpty() ? Cli::tr("Nothing differs.") : lines.join(u'\n');
    }

    static void warnAbout(Session& session, const TransferPlan& plan, const Configuration& file)
    {
        for (const QString& sentence : plan.leftOut) {
            session.warn(sentence);
        }
        if (const QString remark = remarkOn(file); !remark.isEmpty()) {
            session.warn(remark);
        }
    }

    [[nodiscard]] ConfigTransfer& transfer() { return *m_transfer; }

private:
    std::string m_fileText;
    std::unique_ptr<ConfigTransfer> m_transfer;
};

class ConfigSaveVerb : public ConfigVerb {
public:
    Checked check(const OpenOptions&) override
    {
        const QFileInfo info(path());
        if (path().isEmpty() || info.isDir() || !info.absoluteDir().exists()
            || (info.exists() && !info.isWritable())) {
            return checked(Result<void>(fail(ErrorCode::FileUnwritable, path())));
        }
        return {};
    }

    Task run(Session& session) override
    {
        const Configuration present = co_await readController(session);
        const auto saved = saveConfiguration(present, path());
        if (!saved) {
            session.fail(saved.error());
            co_return;
        }
        const auto parameters = static_cast<int>(present.parameters.size());
        session.output().answer(QJsonObject{{u"file"_s, path()}, {u"parameters"_s, parameters}},
                                Cli::tr("%1 parameters and the calibrations in force are saved to "
                                        "%2.")
                                    .arg(parameters)
                                    .arg(path()));
        session.end();
    }
};

class ConfigFileVerb : public ConfigVerb {
public:
    Checked check(const OpenOptions&) override
    {
        return checked(loadConfiguration(path()).map(
            [this](const Configuration& configuration) { m_wanted = configuration; }));
    }

protected:
    [[nodiscard]] const Configuration& wanted() const { return m_wanted; }

private:
    Configuration m_wanted;
};

class ConfigDiffVerb : public ConfigFileVerb {
public:
    Task run(Session& session) override
    {
        const Configuration present = co_await readController(session);
        const TransferPlan plan = planFor(session, present, wanted());
        session.output().answer(json(plan), text(plan));
        warnAbout(session, plan, wanted());
        session.end();
    }
};

class ConfigLoadVerb : public ConfigFileVerb {
public:
    void declare(CLI::App& app) override
    {
        ConfigFileVerb::declare(app);
        app.add_flag("--dry-run", m_isDryRun,
                     Cli::tr("write nothing; show the changes and their packets").toStdString());
    }

    Task run(Session& session) override
    {
        const Configuration present = co_await readController(session);
        const TransferPlan plan = planFor(session, present, wanted());
        if (m_isDryRun) {
            showPackets(session, plan);
        } else if (!plan.writes.empty()) {
            m_isWriting = true;
            const TransferOutcome outcome = co_await session.need<TransferOutcome>(
                [this, &session, &plan](const Awaiting<TransferOutcome>::Handler& handler) {
                    QObject::connect(&transfer(), &ConfigTransfer::finished, &session, handler);
                    transfer().write(plan);
                });
            if (outcome.error) {
                session.fail(Failure{exitCodeOf(outcome.error->code), outcome.text()});
                co_return;
            }
            session.output().answer(json(plan), text(plan));
            for (const QString& note : outcome.notes) {
                session.warn(note);
            }
        } else {
            session.output().answer(json(plan), text(plan));
        }
        warnAbout(session, plan, wanted());
        if (plan.needsReset() && !m_isDryRun) {
            session.warn(Cli::tr("Some of it acts after the controller's power is switched off and "
                                 "on."));
        }
        session.end();
    }

    void interrupted(Session& session) override
    {
        if (m_isWriting) {
            transfer().cancel(); // puts back what was written, then ends with Cancelled
        } else {
            ConfigFileVerb::interrupted(session);
        }
    }

private:
    static void showPackets(Session& session, const TransferPlan& plan)
    {
        QJsonArray packets;
        QString lines = text(plan);
        for (const Command& command : plan.commands()) {
            const QString hex = toHex(encode(command, session.options().line));
            packets.append(hex);
            lines += u"\n  %1  %2"_s.arg(hex, describe(command));
        }
        QJsonObject document = json(plan);
        document.insert(u"packets"_s, packets);
        session.output().answer(document, lines);
    }

    bool m_isDryRun = false;
    bool m_isWriting = false;
};

} // namespace

std::unique_ptr<Verb> makeConfigSave()
{
    return std::make_unique<ConfigSaveVerb>();
}

std::unique_ptr<Verb> makeConfigLoad()
{
    return std::make_unique<ConfigLoadVerb>();
}

std::unique_ptr<Verb> makeConfigDiff()
{
    return std::make_unique<ConfigDiffVerb>();
}

} // namespace trex
