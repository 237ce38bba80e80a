// SPDX-License-Identifier: GPL-3.0-or-later
// run
#include "app/common/version.h"
#include "app/trexctl/terminal.h"
#include "app/trexctl/verbs.h"
#include "protocol/procedures/benchreport.h"
#include "protocol/procedures/benchtest.h"
#include "protocol/procedures/configtransfer.h"
#include "protocol/storage/readyprofiles.h"
#include "protocol/storage/sessionrecorder.h"
#include "protocol/telemetry/telemetrystore.h"

#include <QFileInfo>

#include <CLI/CLI.hpp>

#include <iostream>

using namespace Qt::Literals::StringLiterals;

namespace trex {
namespace {

constexpr int kJointMode = 1; // parameter 0x7B (facts.md 2)
constexpr double kProgressSeconds = 1.0;
constexpr double kProgressSecondsInLog = 10.0;

class RunVerb : public Verb {
public:
    void declare(CLI::App& app) override
    {
        const auto add = [&app](const char* name, QString& target, const QString& help) {
            return app.add_option_function<std::string>(
                name, [&target](const std::string& text) { target = QString::fromStdString(text); },
                help.toStdString());
        };
        QStringList keys;
        for (const ReadyProfileRow& row : readyProfiles()) {
            keys << QString::fromLatin1(row.key.data(), qsizetype(row.key.size()));
        }
        add("PROFILE", m_path,
            Cli::tr("a bench test: a JSON file, or a ready one: %1").arg(keys.join(u", "_s)))
            ->required();
        add("--record", m_recordPath, Cli::tr("everything into a recording; a new file"))
            ->type_name("FILE");
        add("--report", m_reportPath, Cli::tr("a report with plots; a new file"))
            ->type_name("FILE.html");
        app.add_flag("--force", m_isForced, Cli::tr("replace files that are there").toStdString());
    }

    Checked check(const OpenOptions&) override
    {
        const bool isKey = !QFileInfo::exists(m_path)
            && std::ranges::any_of(readyProfiles(), [this](const ReadyProfileRow& row) {
                   return m_path == QLatin1StringView(row.key.data(), qsizetype(row.key.size()));
               });
        const auto profile = isKey ? readyProfile(m_path.toStdString()) : loadBenchProfile(m_path);
        if (!profile) {
            return checked(profile);
        }
        m_profile = *profile;
        for (const QString& path : {m_recordPath, m_reportPath}) {
            const QFileInfo info(path);
            if (path.isEmpty()) {
                continue;
            }
            if (info.exists() && (!info.isFile() || !m_isForced)) {
                return usage(Cli::tr("There is already a file %1; give another name, or --force to "
                                     "replace it. Nothing was sent.")
                                 .arg(path));
            }
            if (!QFileInfo(info.absolutePath()).isWritable()) {
                const Result<void> unwritable = trex::fail(ErrorCode::FileUnwritable, path);
                return checked(unwritable);
            }
        }
        return {};
    }

    [[nodiscard]] bool stopsOnClose() const override { return true; }

    Task run(Session& session) override
    {
        const Reply mode = co_await session.ask(readParameter(parameterRow("motor-mode").number));
        if (mode.payload.front() == kJointMode) {
            session.fail(Error{ErrorCode::JointMode, Cli::tr("motor currents")});
            co_return;
        }
        static_cast<void>(co_await session.attempt(query("get-mode")));
        if (!m_recordPath.isEmpty() || !m_reportPath.isEmpty()) {
            // What cannot be read is no reason not to test; the report says so.
            static_cast<void>(
                co_await session.attempt<void>([&session](const Awaiting<void>::Handler& handler) {
                    session.settings().readAll(&session, {}, handler);
                }));
        }
        if (!m_recordPath.isEmpty()) {
            co_await session.need<void>([this, &session](const Awaiting<void>::Handler& handler) {
                startRecorder(session, handler);
            });
        }
        m_started = QDateTime::currentDateTimeUtc();
        const Result<void> done = co_await session.attempt<void>(
            [this, &session](const Awaiting<void>::Handler& handler) {
                startTest(session, handler);
            });
        endProgress();
        const BenchOutcome outcome =
            m_test->run().hasEnded() ? evaluate(m_test->run(), false) : BenchOutcome{};
        if (m_recorder) {
            co_await session.need<void>([this, &session](const Awaiting<void>::Handler& handler) {
                QObject::connect(m_recorder.get(), &SessionRecorder::finished, &session,
                                 [handler] { handler({}); });
                m_recordingFailed = handler;
                m_recorder->stop();
            });
        }
        if (!m_reportPath.isEmpty() && m_test->run().hasStarted()) {
            if (const auto saved = saveReport(m_reportPath, outcome, report(session)); !saved) {
                session.fail(saved.error());
                co_return;
            }
        }
        conclude(session, done, outcome);
    }

    void interrupted(Session& session) override
    {
        if (m_test && m_test->isRunning() && !std::exchange(m_isInterrupted, true)) {
            m_test->cancel(); // run() goes on when the stop has left
        } else {
            session.end(exitcode::kInterrupted);
        }
    }

private:
    void startRecorder(Session& session, const Awaiting<void>::Handler& handler)
    {
        m_recorder = std::make_unique<SessionRecorder>(session.controller(), m_store);
        m_recordingFailed = handler;
        QObject::connect(m_recorder.get(), &SessionRecorder::failed, &session,
                         [this](const Error& error) {
                             if (const auto failed = std::exchange(m_recordingFailed, {})) {
                                 failed(tl::make_unexpected(error));
                             } else if (m_test && m_test->isRunning()) {
                                 m_recordingError = error; // told once the motors have stopped
                                 m_test->cancel();
                             }
                         });
        QObject::connect(m_recorder.get(), &SessionRecorder::started, &session, [this, handler] {
            m_recordingFailed = {};
            handler({});
        });
        QObject::connect(&session.controller(), &Controller::recordsArrived, m_recorder.get(),
                         [this](const std::vector<TransactionRecord>& records) { keep(records); });
        RecordingPlan plan{.path = m_recordPath};
        plan.polls.fill(true);
        plan.facts[QString::fromLatin1(recordingfact::kProgram)] = u"trexctl"_s;
        plan.facts[QString::fromLatin1(recordingfact::kProgramVersion)] =
            QLatin1StringView(kVersion);
        m_recorder->start(plan);
        m_recorder->addConfiguration(
            presentConfiguration(session.controller(), session.settings()));
    }

    void keep(const std::vector<TransactionRecord>& records)
    {
        for (const TransactionRecord& record : records) {
            for (const PollRow& row : kPolls) {
                if (!record.error && !record.isRaw && record.command == pollCommand(row.id)
                    && record.receivedBytes.size() >= row.values) {
                    m_store.append(decodePoll(row.id, record.receivedBytes, record.ended));
                }
            }
        }
        m_recorder->pull();
    }

    void startTest(Session& session, const Awaiting<void>::Handler& handler)
    {
        m_test = std::make_unique<BenchTest>(session.controller(), m_profile);
        QObject::connect(m_test.get(), &Procedure::finished, &session,
                         [handler](const Result<void>& result) { handler(result); });
        QObject::connect(m_test.get(), &BenchTest::tick, &session, [this] { showProgress(); });
        if (m_recorder) {
            m_recorder->addEvent(0, u"log"_s, Cli::tr("Bench test: %1").arg(m_profile.name));
        }
        m_test->start();
    }

    void conclude(Session& session, const Result<void>& done, const BenchOutcome& outcome)
    {
        if (m_recordingError) {
            session.fail(*m_recordingError);
            return;
        }
        if (m_isInterrupted) {
            session.tell(Cli::tr("Interrupted; the motors were told to stop."));
            session.end(exitcode::kInterrupted);
            return;
        }
        if (!done) {
            session.fail(done.error());
            return;
        }
        switch (outcome.ending.end) {
        case BenchEnd::Completed:
        case BenchEnd::Limit:
        case BenchEnd::NotMet:
            break;
        case BenchEnd::Stale:
        case BenchEnd::LinkLost:
            session.fail(Failure{exitcode::kNoReply, outcome.verdictText()});
            return;
        case BenchEnd::NotInControl:
        case BenchEnd::Stopped:
        case BenchEnd::Failed:
            session.fail(Failure{exitcode::kRefused, outcome.verdictText()});
            return;
        }
        session.output().answer(json(outcome), text(outcome));
        if (outcome.hasPassed()) {
            session.end();
        } else {
            session.fail(Failure{exitcode::kDiffers, outcome.verdictText()});
        }
    }

    static QJsonObject json(const BenchOutcome& outcome)
    {
        QJsonArray results;
        for (const BenchResult& result : outcome.results) {
            const int decimals = result.decimals + 2;
            QJsonObject object{{u"key"_s, result.key},
                               {u"title"_s, result.title},
                               {u"value"_s, QJsonValue::Null},
                               {u"unit"_s, result.unit},
                               {u"verdict"_s, keyOf(result.verdict)}};
            if (result.value) {
                object[u"value"_s] = rounded(*result.value, decimals);
                object[u"uncertainty"_s] = rounded(result.uncertainty, decimals);
            }
            for (const auto& [key, bound] : {std::pair{u"minimum"_s, result.expected.minimum},
                                             std::pair{u"maximum"_s, result.expected.maximum}}) {
                if (bound) {
                    object[key] = *bound;
                }
            }
            if (!result.note.isEmpty()) {
                object[u"note"_s] = result.note;
            }
            results.append(object);
        }
        QJsonArray proposals;
        for (const BenchProposal& proposal : outcome.proposals) {
            proposals.append(QJsonObject{{u"key"_s, keyText(*findParameter(proposal.parameter))},
                                         {u"raw"_s, proposal.raw},
                                         {u"reason"_s, proposal.reason}});
        }
        return {{u"passed"_s, outcome.hasPassed()},
                {u"ended"_s, keyOf(outcome.ending.end)},
                {u"reason"_s, outcome.ending.reason},
                {u"seconds"_s, rounded(outcome.trace.seconds, 3)},
                {u"results"_s, results},
                {u"proposals"_s, proposals}};
    }

    static QString text(const BenchOutcome& outcome)
    {
        TextTable table(
            {Cli::tr("Result"), Cli::tr("Value"), Cli::tr("Expected"), Cli::tr("Verdict")});
        for (const BenchResult& result : outcome.results) {
            table.add(
                {result.key, valueText(result), expectedText(result), textOf(result.verdict)});
        }
        QString all = table.text();
        for (const ProposalText& proposal : proposalsOf(outcome)) {
            all += u'\n'
                + Cli::tr("Proposed: %1 %2 (%3)")
                      .arg(proposal.title, proposal.value, proposal.reason);
        }
        return outcome.hasPassed() ? all + u'\n' + outcome.verdictText() : all;
    }

    BenchReport report(Session& session) const
    {
        return reportOn(session.controller(), session.settings(),
                        u"trexctl "_s + QLatin1StringView(kVersion), m_started);
    }

    void showProgress()
    {
        const bool isTerminal = isAtTerminal();
        const double now = m_test->run().seconds();
        if (now < m_nextProgress || !m_test->isRunning()) {
            return;
        }
        m_nextProgress = now + (isTerminal ? kProgressSeconds : kProgressSecondsInLog);
        std::cerr << (isTerminal ? "\r" : "")
                  << Cli::tr("%1 of %2 s, step %3")
                         .arg(now, 0, 'f', 0)
                         .arg(plannedSeconds(m_profile), 0, 'f', 0)
                         .arg(m_test->run().position())
                         .toStdString()
                  << (isTerminal ? "   " : "\n") << std::flush;
        m_isLineOpen = isTerminal;
    }

    void endProgress()
    {
        if (std::exchange(m_isLineOpen, false)) {
            std::cerr << std::endl;
        }
    }

    QString m_path;
    QString m_recordPath;
    QString m_reportPath;
    bool m_isForced = false;
    BenchProfile m_profile;
    TelemetryStore m_store;
    std::unique_ptr<SessionRecorder> m_recorder;
    std::unique_ptr<BenchTest> m_test;
    Awaiting<void>::Handler m_recordingFailed;
    std::optional<Error> m_recordingError;
    QDateTime m_started;
    double m_nextProgress = kProgressSeconds;
    bool m_isLineOpen = false;
    bool m_isInterrupted = false;
};

} // namespace

std::unique_ptr<Verb> makeRun()
{
    return std::make_unique<RunVerb>();
}

} // namespace trex
