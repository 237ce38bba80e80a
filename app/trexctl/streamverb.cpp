// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/trexctl/streamverb.h"

#include "app/common/numbers.h"

#include <CLI/CLI.hpp>

namespace trex {
namespace {

Instant clockNow()
{
    return std::chrono::steady_clock::now();
}

Duration secondsToDuration(double seconds)
{
    return std::chrono::duration_cast<Duration>(std::chrono::duration<double>(seconds));
}

} // namespace

void StreamVerb::declare(CLI::App& app)
{
    const bool isStream = m_kind == Kind::Stream;
    if (!isStream) {
        app.add_flag("--watch", m_isWatching,
                     Cli::tr("a stream until SIGINT (Ctrl+C) or --duration").toStdString());
    }
    const auto addText = [&app](const char* name, const char* unit, QString& target,
                                const QString& help) {
        app.add_option_function<std::string>(
               name, [&target](const std::string& text) { target = QString::fromStdString(text); },
               help.toStdString())
            ->type_name(unit);
    };
    addText("--rate", "HZ", m_rateText,
            isStream ? Cli::tr("samples a second, default 20")
                     : Cli::tr("samples a second, default 20; implies --watch"));
    addText("--duration", "S", m_durationText,
            isStream ? Cli::tr("seconds; without it until SIGINT (Ctrl+C)")
                     : Cli::tr("seconds to watch; implies --watch"));
}

Checked StreamVerb::check(const OpenOptions&)
{
    if (!m_rateText.isNull()) {
        const auto hertz = positiveNumber("--rate", m_rateText, kMostHertz);
        if (!hertz) {
            return checked(hertz);
        }
        m_hertz = *hertz;
        m_isWatching = true;
    }
    if (!m_durationText.isNull()) {
        const auto duration = positiveNumber("--duration", m_durationText, kLongestSeconds);
        if (!duration) {
            return checked(duration);
        }
        m_duration = *duration;
        m_isWatching = true;
    }
    return {};
}

Task StreamVerb::run(Session& session)
{
    const Reply answer = co_await session.ask(firstQuestion());
    if (!begin(session, answer)) {
        conclude(session, exitcode::kDone);
        co_return;
    }
    static_cast<void>(co_await prepare(session));
    m_silence.setSingleShot(true);
    m_silence.callOnTimeout(&session, [this, &session] { endBySilence(session); });
    const Duration period = secondsToDuration(1.0 / m_hertz);
    const Instant first = clockNow();
    const Instant end = m_duration ? first + secondsToDuration(*m_duration) : Instant::max();
    Instant due = first;
    while (!session.hasEnded() && !m_isConcluding) {
        if (!m_silence.isActive()) {
            m_silence.start(kLongestSilence);
        }
        std::vector<Reply> replies;
        const std::vector<Command> asked = questions();
        for (const Command& command : asked) {
            Result<Reply> reply = co_await session.attempt(command);
            if (!reply) {
                m_lastError = reply.error();
                break;
            }
            replies.push_back(std::move(*reply));
        }
        if (m_isConcluding) {
            break;
        }
        if (replies.size() == asked.size()) {
            m_silence.stop();
            onSample(session, replies);
        } else if (m_isWatching) {
            ++m_skipped;
        } else {
            session.fail(m_lastError);
        }
        due = std::max(due + period, clockNow());
        if (!m_isWatching || due >= end) {
            break;
        }
        co_await session.sleepUntil(due);
    }
    if (m_isWatching && !session.hasEnded() && !m_isConcluding) {
        co_await session.sleepUntil(end);
    }
    if (!m_isConcluding) {
        conclude(session, exitcode::kDone);
    }
}

Attempt<void> StreamVerb::prepare(Session& session)
{
    return session.attempt<void>([](const Awaiting<void>::Handler& handler) { handler({}); });
}

void StreamVerb::endBySilence(Session& session)
{
    if (!std::exchange(m_isConcluding, true)) {
        finish([this, &session](const Result<void>&) { session.fail(m_lastError); });
    }
}

void StreamVerb::onSample(Session& session, const std::vector<Reply>& replies)
{
    const Instant time = replies.front().received;
    if (!m_start) {
        m_start = time;
    }
    print(session, std::chrono::duration<double>(time - *m_start).count(), replies);
    if (!session.output().isGood()) {
        conclude(session, exitcode::kDone); // nobody reads any more (a closed pipe)
    }
}

void StreamVerb::interrupted(Session& session)
{
    // A stream without --duration is done when the person says so (contracts/cli.md).
    const bool isDone = m_isWatching && !m_duration && m_start;
    conclude(session, isDone ? exitcode::kDone : exitcode::kInterrupted);
}

void StreamVerb::conclude(Session& session, int exitCode)
{
    m_silence.stop();
    if (std::exchange(m_isConcluding, true)) {
        session.end(exitCode); // interrupted again: not even the flushing is waited for
        return;
    }
    if (m_skipped > 0) {
        session.warn(Cli::tr("%1 samples failed and are left out.").arg(m_skipped));
    }
    finish([this, &session, exitCode](const Result<void>& flushed) {
        if (!flushed) {
            session.fail(flushed.error());
            return;
        }
        if (exitCode == exitcode::kDone && !session.hasEnded()) {
            answer(session);
        }
        session.end(exitCode);
    });
}

} // namespace trex
