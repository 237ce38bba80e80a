// SPDX-License-Identifier: GPL-3.0-or-later
// config save, config load, config diff
#include "app/trexctl/verbs.h"
#include "protocol/codec/packet.h"
#include "protocol/procedures/configtransfer.h"
#include "protocol/storage/configadapt.h"

#include <QDir>
#include <QFileInfo>

#include <CLI/CLI.hpp>

using namespace Qt::Literals::StringLiterals;

namespace trex {
namespace {

class ConfigVerb : public Verb {
public:
    [[nodiscard]] bool usesSettings() const override { return true; }
    void declare(CLI::App& app) override
    {
        app.add_option(
               "FILE", m_fileText,
               Cli::tr("configuration file (JSON); texts under keys of your own are comments")
                   .toStdString())
            ->required()
            ->type_name("");
    }

protected:
    [[nodiscard]] QString path() const { return QString::fromStdString(m_fileText); }
    void setPath(const std::string& text) { m_fileText = text; }

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
    /// As this controller is to have it, which may be of another model or firmware.
    [[nodiscard]] Configuration wantedFor(Session& session) const
    {
        const auto& signature = session.controller().device().signature;
        if (!signature) {
            return m_wanted;
        }
        const AdaptedConfiguration adapted = adaptedTo(*signature, m_wanted);
        for (const QString& note : adapted.notes) {
            session.warn(note);
        }
        return adapted.configuration;
    }

private:
    Configuration m_wanted;
};

class ConfigDiffVerb : public ConfigFileVerb {
public:
    void declare(CLI::App& app) override
    {
        app.add_option(
               "FILE", m_texts[0],
               Cli::tr("configuration file (JSON); texts under keys of your own are comments")
                   .toStdString())
            ->type_name("");
        app.add_option("FILE2", m_texts[1],
                       Cli::tr("another one: compare the two, without a controller").toStdString())
            ->type_name("");
        app.add_flag("--defaults", m_isAgainstDefaults,
                     Cli::tr("compare the controller with the factory defaults").toStdString());
    }

    Checked check(const OpenOptions& options) override
    {
        if (m_isAgainstDefaults != m_texts[0].empty()) {
            return usage(m_isAgainstDefaults
                             ? Cli::tr("--defaults takes no file.")
                             : Cli::tr("Give a file to compare with, or --defaults."));
        }
        if (m_isAgainstDefaults) {
            return {};
        }
        setPath(m_texts[0]);
        const Checked first = ConfigFileVerb::check(options);
        if (!first || m_texts[1].empty()) {
            return first;
        }
        return checked(loadConfiguration(QString::fromStdString(m_texts[1]))
                           .map([this](const Configuration& second) { m_second = second; }));
    }

    [[nodiscard]] Line line() const override
    {
        return m_texts[1].empty() ? ConfigFileVerb::line() : Line::None;
    }
    [[nodiscard]] bool usesSettings() const override { return m_texts[1].empty(); }

    Task run(Session& session) override
    {
        if (m_second) {
            compareFiles(session);
            co_return;
        }
        const Configuration present = co_await readController(session);
        const Configuration other =
            m_isAgainstDefaults ? defaultConfiguration() : wantedFor(session);
        const TransferPlan plan = planFor(session, present, other);
        session.output().answer(json(plan), text(plan));
        warnAbout(session, plan, other);
        if (m_isAgainstDefaults) {
            warnAboutDefaults(session, plan);
        }
        session.end();
    }

private:
    /// From the first to the second; both input sets, since neither has to be in force.
    void compareFiles(Session& session)
    {
        TransferPlan plan = planTransfer(wanted(), *m_second, InputKind::Rc);
        Configuration analog = *m_second;
        analog.parameters.clear();
        analog.calibrations.erase(InputKind::Rc);
        const TransferPlan rest = planTransfer(wanted(), analog, InputKind::Analog);
        plan.writes.insert(plan.writes.end(), rest.writes.begin(), rest.writes.end());
        QJsonObject document = json(plan);
        QString lines = text(plan);
        QJsonArray only;
        for (const auto& change : differences(*m_second, wanted())) {
            if (!change.from) {
                only.append(change.key);
                lines += u'\n' + Cli::tr("%1: only in %2").arg(change.key, path());
            }
        }
        if (!only.isEmpty()) {
            document.insert(u"onlyInFirst"_s, only);
        }
        session.output().answer(document, lines);
        for (const auto& file : {wanted(), *m_second}) {
            if (const QString remark = remarkOn(file); !remark.isEmpty()) {
                session.warn(remark);
            }
        }
        session.end();
    }

    static void warnAboutDefaults(Session& session, const TransferPlan& plan)
    {
        QStringList guesses;
        for (const auto& write : plan.writes) {
            if (isGuess(write.row->defaultGrade)) {
                guesses << write.key();
            }
        }
        if (!guesses.isEmpty()) {
            session.warn(Cli::tr("The vendor does not state these defaults, they are guesses: %1.")
                             .arg(guesses.join(u", "_s)));
        }
        session.warn(Cli::tr("Calibrations are not compared: their defaults are not documented."));
    }

    std::array<std::string, 2> m_texts;
    bool m_isAgainstDefaults = false;
    std::optional<Configuration> m_second;
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
        const TransferPlan plan = planFor(session, present, wantedFor(session));
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
