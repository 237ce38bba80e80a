// SPDX-License-Identifier: GPL-3.0-or-later
// record
#include "app/common/version.h"
#include "app/trexctl/controllertext.h"
#include "app/trexctl/streamverb.h"
#include "app/trexctl/terminal.h"
#include "app/trexctl/verbs.h"
#include "protocol/errortext.h"
#include "protocol/storage/sessionrecorder.h"

#include <QFile>
#include <QFileInfo>

#include <CLI/CLI.hpp>

#include <iostream>

using namespace Qt::Literals::StringLiterals;

namespace trex {
namespace {

constexpr int kJointMode = 1; // parameter 0x7B (facts.md 2)
constexpr std::size_t kHistoryBytes = 64U
    << 20U; // samples leave the memory once they are in the file
constexpr std::chrono::seconds kProgressInterval{1};
constexpr std::chrono::seconds kProgressIntervalInLog{10};

class RecordVerb : public StreamVerb {
public:
    RecordVerb() : StreamVerb(Kind::Stream) { }

    ~RecordVerb() override
    {
        m_recorder.reset();
        if (m_isNewFile && QFileInfo(m_path).size() == 0) {
            QFile::remove(m_path); // the line could not be opened: leave no empty file behind
        }
    }

    void declare(CLI::App& app) override
    {
        app.add_option_function<std::string>(
               "FILE", [this](const std::string& text) { m_path = QString::fromStdString(text); },
               Cli::tr("the recording; a new file").toStdString())
            ->required();
        StreamVerb::declare(app);
        app.add_option_function<std::string>(
               "--streams",
               [this](const std::string& text) { m_streams = QString::fromStdString(text); },
               Cli::tr("some of currents,channels,status; default all").toStdString())
            ->type_name("LIST");
        app.add_flag("--packets", m_hasPackets,
                     Cli::tr("every packet and its reply, too").toStdString());
        app.add_flag("--force", m_isForced, Cli::tr("replace a file that is there").toStdString());
    }

    Checked check(const OpenOptions& options) override
    {
        for (const QString& name : m_streams.split(u',')) {
            const auto polls = pollsOfStreamName(name.trimmed());
            if (!polls) {
                return usage(Cli::tr("--streams: '%1' is none of currents, channels, status; "
                                     "nothing was sent.")
                                 .arg(name));
            }
            for (const PollId poll : *polls) {
                m_wanted[std::size_t(poll)] = true;
            }
        }
        const QFileInfo info(m_path);
        if (info.exists() && (!info.isFile() || info.size() > 0) && !m_isForced) {
            return usage(Cli::tr("There is already a file %1; give another name, or --force to "
                                 "replace it. Nothing was sent.")
                             .arg(m_path));
        }
        // Opened now, so that a wrong name is told before anything is sent.
        m_isNewFile = !info.exists();
        QFile file(m_path);
        if (!file.open(QIODevice::ReadWrite)) {
            m_isNewFile = false;
            const Result<void> unwritable =
                trex::fail(ErrorCode::FileUnwritable, u"%1: %2"_s.arg(m_path, file.errorString()));
            return checked(unwritable);
        }
        return StreamVerb::check(options);
    }

protected:
    Command firstQuestion() const override
    {
        return readParameter(parameterRow("motor-mode").number);
    }

    bool begin(Session& session, const Reply& answer) override
    {
        if (answer.payload.front() == kJointMode && m_wanted[std::size_t(PollId::Currents)]) {
            // conformance C-31: in joint mode there is no current, and no number is kept.
            m_wanted[std::size_t(PollId::Currents)] = false;
            if (std::none_of(m_wanted.begin(), m_wanted.end(), [](bool is) { return is; })) {
                session.fail(Error{ErrorCode::JointMode, Cli::tr("motor currents")});
                return false;
            }
            session.warn(Cli::tr("Joint motor mode: the controller measures no currents, so they "
                                 "are left out."));
        }
        m_store.setMemoryLimit(kHistoryBytes);
        m_recorder = std::make_unique<SessionRecorder>(session.controller(), m_store);
        QObject::connect(m_recorder.get(), &SessionRecorder::failed, &session,
                         [this, &session](const Error& error) {
                             endProgress();
                             m_finished ? m_finished(tl::make_unexpected(error))
                                        : session.fail(error);
                         });
        QObject::connect(m_recorder.get(), &SessionRecorder::finished, &session, [this] {
            if (m_finished) {
                m_finished({});
            }
        });
        QObject::connect(&session.controller(), &Controller::stateChanged, m_recorder.get(),
                         [this](LinkState state) {
                             if (state != LinkState::Connected) {
                                 m_store.markGap(std::chrono::steady_clock::now());
                             }
                         });
        return true;
    }

    /// The settings go to the head of the file; what cannot be read is no reason not to record.
    Attempt<void> prepare(Session& session) override
    {
        return session.attempt<void>([this, &session](const Awaiting<void>::Handler& handler) {
            const auto started = [this, &session, handler](const Result<void>& read) {
                // The first sample is asked for when there is a file to keep it.
                QObject::connect(m_recorder.get(), &SessionRecorder::started, &session,
                                 [handler] { handler({}); });
                startRecorder(session, read);
            };
            const auto readSettings = [&session, started](const Result<Reply>&) {
                session.settings().readAll(&session, {}, started);
            };
            session.controller().request(query("get-mode"), &session, readSettings);
        });
    }

    std::vector<Command> questions() const override
    {
        std::vector<Command> commands;
        for (const PollId poll : polls()) {
            commands.push_back(pollCommand(poll));
        }
        return commands;
    }

    void print(Session&, double seconds, const std::vector<Reply>& replies) override
    {
        const auto ids = polls();
        for (std::size_t i = 0; i < ids.size(); ++i) {
            m_store.append(decodePoll(ids[i], replies[i].payload, replies[i].received));
        }
        m_recorder->pull();
        showProgress(seconds);
    }

    void finish(const FinishHandler& done) override
    {
        endProgress();
        if (!m_recorder || !m_recorder->isRecording()) {
            done({});
            return;
        }
        m_finished = done;
        m_recorder->stop();
    }

    void answer(Session& session) override
    {
        const double seconds = std::chrono::duration<double>(m_recorder->length()).count();
        const auto samples = static_cast<qint64>(m_recorder->samples());
        const auto lost = skipped() + static_cast<qint64>(m_recorder->dropped());
        session.output().answer(QJsonObject{{u"file"_s, m_path},
                                            {u"samples"_s, samples},
                                            {u"seconds"_s, rounded(seconds, 3)},
                                            {u"lost"_s, lost}},
                                u"%1: %2"_s.arg(m_path, summary(samples, seconds, lost)));
    }

private:
    std::vector<PollId> polls() const
    {
        std::vector<PollId> ids;
        for (const PollRow& row : kPolls) {
            if (m_wanted[std::size_t(row.id)]) {
                ids.push_back(row.id);
            }
        }
        return ids;
    }

    void startRecorder(Session& session, const Result<void>& read)
    {
        if (session.hasEnded()) {
            return;
        }
        RecordingPlan plan{.path = m_path, .polls = m_wanted, .hasPackets = m_hasPackets};
        plan.facts[QString::fromLatin1(recordingfact::kProgram)] = u"trexctl"_s;
        plan.facts[QString::fromLatin1(recordingfact::kProgramVersion)] =
            QLatin1StringView(kVersion);
        m_recorder->start(plan);
        m_recorder->addConfiguration(known(session));
        if (!read) {
            m_recorder->addEvent(1, u"log"_s, errorText(read.error()));
        }
    }

    static Configuration known(Session& session)
    {
        Configuration configuration;
        configuration.saved =
            QDateTime::fromSecsSinceEpoch(QDateTime::currentSecsSinceEpoch(), Qt::UTC);
        if (const auto& signature = session.controller().device().signature) {
            configuration.signature = signature->text();
            configuration.firmware = signature->firmware();
        }
        for (const ParameterRow& row : kParameters) {
            if (const auto raw = session.settings().parameter(row.number); raw && !row.isTrigger) {
                configuration.parameters[row.number] = *raw;
            }
        }
        for (const InputKind input : {InputKind::Rc, InputKind::Analog}) {
            for (int channel = 1; channel <= kChannelCount; ++channel) {
                if (const auto values = session.settings().calibration(input, channel)) {
                    configuration.calibrations[input][channel] = *values;
                }
            }
        }
        return configuration;
    }

    QString summary(qint64 samples, double seconds, qint64 lost) const
    {
        return Cli::tr("%1 samples, %2 s, %3 lost").arg(samples).arg(seconds, 0, 'f', 1).arg(lost);
    }

    void showProgress(double seconds)
    {
        const std::chrono::duration<double> now(seconds);
        if (now < m_nextProgress) {
            return;
        }
        const bool isTerminal = isAtTerminal();
        m_nextProgress = now + (isTerminal ? kProgressInterval : kProgressIntervalInLog);
        const auto samples = static_cast<qint64>(m_recorder->samples());
        const auto lost = skipped() + static_cast<qint64>(m_recorder->dropped());
        std::cerr << (isTerminal ? "\r" : "") << summary(samples, seconds, lost).toStdString()
                  << (isTerminal ? "  " : "\n") << std::flush;
        m_isLineOpen = isTerminal;
    }

    void endProgress()
    {
        if (std::exchange(m_isLineOpen, false)) {
            std::cerr << std::endl;
        }
    }

    QString m_path;
    QString m_streams = u"currents,channels,status"_s;
    bool m_hasPackets = false;
    bool m_isForced = false;
    bool m_isNewFile = false;
    SampleTap::Wanted m_wanted{};
    TelemetryStore m_store;
    std::unique_ptr<SessionRecorder> m_recorder;
    FinishHandler m_finished;
    std::chrono::duration<double> m_nextProgress{kProgressInterval};
    bool m_isLineOpen = false;
};

} // namespace

std::unique_ptr<Verb> makeRecord()
{
    return std::make_unique<RecordVerb>();
}

} // namespace trex
