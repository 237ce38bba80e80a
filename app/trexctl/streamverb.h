// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/trexctl/verb.h"

#include <QTimer>

namespace trex {

/// A verb that gives one sample, or with --watch a stream of them: 20 a second unless told
/// otherwise. A sample that fails is skipped and counted; 2 s without one end the stream, as does a
/// lost port.
class StreamVerb : public Verb {
public:
    static constexpr double kUsualHertz = 20.0;
    static constexpr double kMostHertz = 1000.0;
    static constexpr double kLongestSeconds = 366.0 * 86400.0;
    static constexpr std::chrono::seconds kLongestSilence{2};

    enum class Kind { Sample, Stream }; ///< one sample unless --watch, or always a stream
    explicit StreamVerb(Kind kind = Kind::Sample) : m_kind(kind) { }

    void declare(CLI::App& app) override;
    [[nodiscard]] Checked check(const OpenOptions& options) override;
    [[nodiscard]] bool ridesOverLoss() const override { return m_isWatching; }
    Task run(Session& session) final;
    void interrupted(Session& session) final;

protected:
    using FinishHandler = std::function<void(const Result<void>&)>;
    [[nodiscard]] bool isWatching() const { return m_isWatching; }
    /// Asked once, before the samples.
    [[nodiscard]] virtual Command firstQuestion() const = 0;
    /// False: there is nothing to sample; the verb has said so and the session goes on to its end.
    virtual bool begin(Session& session, const Reply& answer) = 0;
    [[nodiscard]] virtual std::vector<Command> questions() const = 0;
    /// Prints one sample; `seconds` since the first.
    virtual void print(Session& session, double seconds, const std::vector<Reply>& replies) = 0;
    /// Asked for before the first sample, whatever comes of it.
    virtual Attempt<void> prepare(Session& session);
    /// Whatever has to be flushed; `done` is called once it is.
    virtual void finish(const FinishHandler& done) { done({}); }
    virtual void answer(Session&) { } ///< what a stream says when it is done
    [[nodiscard]] qint64 skipped() const { return m_skipped; }

private:
    void conclude(Session& session, int exitCode);
    void endBySilence(Session& session);
    void onSample(Session& session, const std::vector<Reply>& replies);

    Kind m_kind;
    bool m_isWatching = m_kind == Kind::Stream;
    bool m_isConcluding = false;
    QString m_rateText;
    QString m_durationText;
    double m_hertz = kUsualHertz;
    std::optional<double> m_duration;
    std::optional<Instant> m_start; ///< read time of the first sample
    qint64 m_skipped = 0;
    QTimer m_silence;
    Error m_lastError{ErrorCode::NoReply, {}};
};

} // namespace trex
