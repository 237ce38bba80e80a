// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/script/scriptactions.h"
#include "app/script/scriptfile.h"

#include <QBasicTimer>
#include <QElapsedTimer>
#include <QObject>

namespace trex {

/// What became of one step at the top of the script.
struct StepRecord {
    int index = 0;
    QString action;
    bool ok = false;
    double startMs = 0.0; ///< since the process began
    double milliseconds = 0.0;
    QString message;
};

/// Plays a script step by step on a timer, so that the program runs as it always does meanwhile.
/// Stops at the first step that fails. GUI thread.
class ScriptPlayer : public QObject {
    Q_OBJECT
    Q_DISABLE_COPY_MOVE(ScriptPlayer)

public:
    ScriptPlayer(Script script, FileDialogs& fileDialogs, QString screenshotFolder,
                 QObject* parent = nullptr);
    void start();

    [[nodiscard]] bool isPassed() const { return !m_failedStep; }
    [[nodiscard]] std::optional<int> failedStep() const { return m_failedStep; }
    [[nodiscard]] const std::vector<StepRecord>& records() const { return m_records; }
    [[nodiscard]] const QStringList& screenshots() const { return m_screenshots; }
    [[nodiscard]] const QString& screenshotFolder() const { return m_folder; }

signals:
    void finished(); ///< all steps passed, one failed, or the script quit

protected:
    void timerEvent(QTimerEvent* event) override;

private:
    struct Block { ///< a list of steps that is being played
        const std::vector<ScriptStep>* steps = nullptr;
        std::size_t index = 0;
        StepContext context; ///< of the step at index
        QElapsedTimer began{};
    };
    [[nodiscard]] StepContext freshContext(const ScriptStep& step);
    void enter(const std::vector<ScriptStep>& steps);
    void beginStep();
    void playStep();
    void endStep();
    void failStep(const QString& message);
    void finish();
    void record(bool ok, const QString& message);

    Script m_script;
    FileDialogs& m_fileDialogs;
    QString m_folder;
    QStringList m_screenshots;
    std::vector<Block> m_blocks; ///< the script, then the repeats that are open within it
    std::vector<StepRecord> m_records;
    std::optional<int> m_failedStep;
    double m_stepStartMs = 0.0;
    QBasicTimer m_timer;
};

} // namespace trex
