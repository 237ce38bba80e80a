// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/trexctl/awaiting.h"
#include "app/trexctl/failure.h"
#include "app/trexctl/output.h"
#include "app/trexctl/task.h"
#include "protocol/procedures/writeaudit.h"
#include "protocol/session/devicesettings.h"

#include <QTimer>

#include <functional>
#include <memory>

namespace trex {

class Verb;

/// One run of trexctl: opens the line if the verb needs one, runs the verb, closes the line, ends
/// the event loop with the exit code. Main thread.
class Session : public QObject {
    Q_OBJECT
    Q_DISABLE_COPY_MOVE(Session)

public:
    Session(Verb& verb, const OpenOptions& options, bool isJson, const QString& journalPath);
    ~Session() override;

    void start();
    void interrupt(); ///< SIGINT or SIGTERM; the second one ends without closing

    [[nodiscard]] const OpenOptions& options() const { return m_options; }
    [[nodiscard]] Controller& controller() { return m_controller; }
    [[nodiscard]] DeviceSettings& settings() { return m_settings; }
    [[nodiscard]] WriteAudit& audit() { return m_audit; }
    [[nodiscard]] Journal& journal() { return m_journal; }
    [[nodiscard]] Output& output() { return m_output; }
    /// Packets of the motors that have left so far, one after another.
    [[nodiscard]] QByteArray sentMotorBytes() const { return m_sentMotorBytes; }

    // What a verb waits for. ask() ends the session when it fails; attempt() hands the failure on.
    [[nodiscard]] Required<Reply> ask(const Command& command);
    [[nodiscard]] Attempt<Reply> attempt(const Command& command);
    template <class T>
    [[nodiscard]] Required<T> need(typename Awaiting<T>::Begin begin)
    {
        return {std::move(begin), [this](const Error& error) { fail(error); }, isEndedTest()};
    }
    template <class T>
    [[nodiscard]] Attempt<T> attempt(typename Awaiting<T>::Begin begin)
    {
        return {std::move(begin), isEndedTest()};
    }
    [[nodiscard]] Attempt<void> sleepUntil(Instant when);

    // Ends. The first one counts.
    void end(int exitCode = exitcode::kDone);
    void fail(const Error& error);
    void fail(const Failure& failure);
    [[nodiscard]] bool hasEnded() const { return m_exitCode.has_value(); }
    /// On stderr at the end, if it ends well: a failure has one line and no other.
    void warn(const QString& sentence) { m_warnings << sentence; }
    /// On stderr now, for what a person has to do next.
    void tell(const QString& sentence);

signals:
    void connected(); ///< for the first time, before the verb runs
    void finished(int exitCode);

private:
    void onState(LinkState state);
    void begin();
    void finish();
    [[nodiscard]] std::function<bool()> isEndedTest() const;

    Verb& m_verb;
    OpenOptions m_options;
    Output m_output;
    Controller m_controller;
    DeviceSettings m_settings;
    Journal m_journal;
    WriteAudit m_audit;
    QTimer m_watchdog;
    QByteArray m_sentMotorBytes;
    QStringList m_warnings;
    std::optional<int> m_exitCode;
    bool m_isOpen = false;
    bool m_hasBegun = false;
    bool m_isFinished = false;
    Task m_task; ///< last: goes first, while everything it uses is still there
};

} // namespace trex
