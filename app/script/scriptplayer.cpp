// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/script/scriptplayer.h"

#include "app/script/processclock.h"

#include <QTimerEvent>

namespace trex {

using namespace Qt::Literals::StringLiterals;

namespace {

constexpr int kPendingMs = 5; ///< between two looks at what a step waits for

QString nameOf(const ScriptStep& step)
{
    return QString::fromUtf8(step.action->name.data(),
                             static_cast<qsizetype>(step.action->name.size()));
}

} // namespace

ScriptPlayer::ScriptPlayer(Script script, FileDialogs& fileDialogs, QString screenshotFolder,
                           QObject* parent)
    : QObject(parent)
    , m_script(std::move(script))
    , m_fileDialogs(fileDialogs)
    , m_folder(std::move(screenshotFolder))
{
}

void ScriptPlayer::start()
{
    enter(m_script.steps);
    m_timer.start(0, this);
}

StepContext ScriptPlayer::freshContext(const ScriptStep& step)
{
    return {.fileDialogs = m_fileDialogs,
            .folder = m_folder,
            .screenshots = m_screenshots,
            .timeoutMs = step.timeoutMs.value_or(kDefaultStepTimeoutMs)};
}

void ScriptPlayer::enter(const std::vector<ScriptStep>& steps)
{
    if (steps.empty()) {
        return;
    }
    m_blocks.push_back({.steps = &steps, .index = 0, .context = freshContext(steps.front())});
    beginStep();
}

void ScriptPlayer::beginStep()
{
    m_blocks.back().began.start();
    if (m_blocks.size() == 1) {
        m_stepStartMs = processclock::sinceStartMs();
    }
}

void ScriptPlayer::timerEvent(QTimerEvent* event)
{
    if (event->timerId() == m_timer.timerId()) {
        m_timer.start(0, this); // each step sees what the event loop made of the one before
        playStep();
    }
}

void ScriptPlayer::playStep()
{
    if (m_blocks.empty()) {
        finish();
        return;
    }
    Block& block = m_blocks.back();
    const ScriptStep& step = (*block.steps)[block.index];
    block.context.elapsedMs = block.began.elapsed();
    const StepResult result = step.action->run(block.context, step);
    switch (result.verdict) {
    case Verdict::Done:
        endStep();
        break;
    case Verdict::Pending:
        m_timer.start(kPendingMs, this);
        break;
    case Verdict::Enter:
        enter(step.steps);
        break; // `block` and `step` may have moved from here
    case Verdict::Failed:
        failStep(result.message);
        break;
    case Verdict::Quit:
        record(true, {});
        finish();
        break;
    }
}

void ScriptPlayer::endStep()
{
    if (m_blocks.size() == 1) {
        record(true, {});
    }
    const std::vector<ScriptStep>* steps = m_blocks.back().steps;
    const std::size_t next = m_blocks.back().index + 1;
    m_blocks.pop_back();
    if (next == steps->size()) {
        return; // the repeat that it belongs to looks again
    }
    m_blocks.push_back({.steps = steps, .index = next, .context = freshContext((*steps)[next])});
    beginStep();
}

void ScriptPlayer::failStep(const QString& message)
{
    QString where;
    for (std::size_t i = 1; i < m_blocks.size(); ++i) {
        const Block& block = m_blocks[i];
        where += u"round %1, step %2 (%3): "_s.arg(m_blocks[i - 1].context.phase)
                     .arg(block.index)
                     .arg(nameOf((*block.steps)[block.index]));
    }
    m_failedStep = static_cast<int>(m_blocks.front().index);
    record(false, where + message);
    finish();
}

void ScriptPlayer::record(bool ok, const QString& message)
{
    const Block& top = m_blocks.front();
    m_records.push_back({.index = static_cast<int>(top.index),
                         .action = nameOf((*top.steps)[top.index]),
                         .ok = ok,
                         .startMs = m_stepStartMs,
                         .milliseconds = processclock::sinceStartMs() - m_stepStartMs,
                         .message = message});
}

void ScriptPlayer::finish()
{
    m_timer.stop();
    m_blocks.clear();
    emit finished();
}

} // namespace trex
