// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/script/scriptactions.h"

#include "app/script/condition.h"
#include "app/script/objectfinder.h"
#include "app/script/screenshots.h"
#include "app/script/scriptinput.h"
#include "widgets/common/filedialogs.h"

#include <QApplication>
#include <QDialog>
#include <QDir>
#include <QJsonObject>
#include <QKeySequence>
#include <QMessageBox>
#include <QWidget>

#include <array>

namespace trex {

using namespace Qt::Literals::StringLiterals;

namespace {

constexpr qint64 kForwardMs = 1000; ///< how long a panel may take to come forward
constexpr qint64 kAskMs = 1000; ///< how long an action may take to ask for a file

StepResult failed(const QString& message)
{
    return {Verdict::Failed, message};
}

// ---- what makes an argument wrong, found before the first step is played ----

QString missingText(const QJsonValue& argument, QLatin1StringView field)
{
    return argument[field].isString() && !argument[field].toString().isEmpty()
        ? QString()
        : u"\"%1\" is missing or no text"_s.arg(field);
}

QString unknownField(const QJsonValue& argument, std::initializer_list<QLatin1StringView> known)
{
    if (!argument.isObject()) {
        return u"not an object"_s;
    }
    const QStringList fields = argument.toObject().keys();
    for (const QString& field : fields) {
        if (std::find(known.begin(), known.end(), field) == known.end()) {
            return u"there is no field \"%1\""_s.arg(field);
        }
    }
    return {};
}

QString checkName(const QJsonValue& argument)
{
    return argument.isString() && !argument.toString().isEmpty() ? QString()
                                                                 : u"not an object's name"_s;
}

QString checkSet(const QJsonValue& argument)
{
    if (QString problem = unknownField(argument, {"object"_L1, "value"_L1, "property"_L1});
        !problem.isEmpty()) {
        return problem;
    }
    const QJsonValue value = argument["value"_L1];
    if (!value.isBool() && !value.isDouble() && !value.isString()) {
        return u"\"value\" is neither a number, a text, true nor false"_s;
    }
    return missingText(argument, "object"_L1);
}

QString checkKey(const QJsonValue& argument)
{
    if (QString problem = unknownField(argument, {"object"_L1, "sequence"_L1});
        !problem.isEmpty()) {
        return problem;
    }
    for (const auto field : {"object"_L1, "sequence"_L1}) {
        if (QString problem = missingText(argument, field); !problem.isEmpty()) {
            return problem;
        }
    }
    const QString text = argument["sequence"_L1].toString();
    const QKeySequence keys = QKeySequence::fromString(text, QKeySequence::PortableText);
    return keys.isEmpty() || keys[0].key() == Qt::Key_unknown
        ? u"there is no key \"%1\""_s.arg(text)
        : QString();
}

QString checkCondition(const QJsonValue& argument)
{
    return conditionProblem(argument);
}

QString checkSleep(const QJsonValue& argument)
{
    const double milliseconds = argument.toDouble(-1);
    return milliseconds >= 0 && milliseconds <= 24.0 * 3600 * 1000
        ? QString()
        : u"not a number of milliseconds"_s;
}

QString checkRepeat(const QJsonValue& argument)
{
    if (QString problem = unknownField(argument, {"until"_L1, "max"_L1, "steps"_L1});
        !problem.isEmpty()) {
        return problem;
    }
    if (argument["max"_L1].toInt(0) < 1) {
        return u"\"max\" is not a number of rounds"_s;
    }
    if (!argument["steps"_L1].isArray()) {
        return u"\"steps\" is not a list"_s;
    }
    const QString problem = conditionProblem(argument["until"_L1]);
    return problem.isEmpty() ? QString() : u"until: "_s + problem;
}

QString checkTrue(const QJsonValue& argument)
{
    return argument.isBool() && argument.toBool() ? QString() : u"only true makes sense"_s;
}

QString checkWindow(const QJsonValue& argument)
{
    return argument == "minimise"_L1 || argument == "restore"_L1
        ? QString()
        : u"neither \"minimise\" nor \"restore\""_s;
}

QString checkScreenshot(const QJsonValue& argument)
{
    if (QString problem = unknownField(argument, {"object"_L1, "file"_L1, "everyPanel"_L1});
        !problem.isEmpty()) {
        return problem;
    }
    if (argument["everyPanel"_L1].isBool()) {
        return {};
    }
    for (const auto field : {"object"_L1, "file"_L1}) {
        if (QString problem = missingText(argument, field); !problem.isEmpty()) {
            return problem;
        }
    }
    return {};
}

QString checkDialog(const QJsonValue& argument)
{
    return argument == "accept"_L1 || argument == "reject"_L1
        ? QString()
        : u"neither \"accept\" nor \"reject\""_s;
}

QString checkFile(const QJsonValue& argument)
{
    if (QString problem = unknownField(argument, {"object"_L1, "path"_L1}); !problem.isEmpty()) {
        return problem;
    }
    const QString problem = missingText(argument, "object"_L1);
    return problem.isEmpty() ? missingText(argument, "path"_L1) : problem;
}

// ---- what they do ----

struct Target {
    QObject* object = nullptr;
    std::optional<StepResult> notYet{}; ///< the step's result instead
};

/// The object, once it is where a person could reach it and can be used; what stands in the way for
/// the whole of the step's time ends the step.
Target reach(StepContext& context, const QString& name)
{
    const Found found = findObject(name);
    if (found.object == nullptr) {
        return {.notYet = failed(found.problem)};
    }
    if (auto* widget = qobject_cast<QWidget*>(found.object);
        widget != nullptr && !bringForward(widget)) {
        if (context.elapsedMs < kForwardMs) {
            return {.notYet = StepResult{Verdict::Pending, {}}};
        }
        return {.notYet = failed(u"\"%1\" cannot be brought into view."_s.arg(name))};
    }
    if (const QString obstacle = obstacleOf(found.object); !obstacle.isEmpty()) {
        return {.notYet = context.elapsedMs < context.timeoutMs ? StepResult{Verdict::Pending, {}}
                                                                : failed(obstacle)};
    }
    return {.object = found.object};
}

StepResult resultOf(const QString& problem)
{
    return problem.isEmpty() ? StepResult{} : failed(problem);
}

StepResult runClick(StepContext& context, const ScriptStep& step)
{
    const Target target = reach(context, step.argument.toString());
    return target.notYet ? *target.notYet : resultOf(input::click(*target.object));
}

StepResult runSet(StepContext& context, const ScriptStep& step)
{
    const Target target = reach(context, step.argument["object"_L1].toString());
    return target.notYet
        ? *target.notYet
        : resultOf(input::set(*target.object, step.argument["property"_L1].toString(),
                              step.argument["value"_L1].toVariant()));
}

StepResult runKey(StepContext& context, const ScriptStep& step)
{
    const Target target = reach(context, step.argument["object"_L1].toString());
    return target.notYet
        ? *target.notYet
        : resultOf(input::press(*target.object, step.argument["sequence"_L1].toString()));
}

StepResult runExpect(StepContext& /*context*/, const ScriptStep& step)
{
    return resultOf(unmetCondition(step.argument));
}

StepResult runWaitFor(StepContext& context, const ScriptStep& step)
{
    const QString unmet = unmetCondition(step.argument);
    if (unmet.isEmpty()) {
        return {};
    }
    return context.elapsedMs < context.timeoutMs
        ? StepResult{Verdict::Pending, unmet}
        : failed(u"Not within %1 ms: %2"_s.arg(context.timeoutMs).arg(unmet));
}

StepResult runSleep(StepContext& context, const ScriptStep& step)
{
    return context.elapsedMs < step.argument.toInteger() ? StepResult{Verdict::Pending, {}}
                                                         : StepResult{};
}

StepResult runRepeat(StepContext& context, const ScriptStep& step)
{
    const QString unmet = unmetCondition(step.argument["until"_L1]);
    if (unmet.isEmpty()) {
        return {};
    }
    const int rounds = context.phase;
    if (rounds >= step.argument["max"_L1].toInt()) {
        return failed(u"Not after %1 rounds: %2"_s.arg(rounds).arg(unmet));
    }
    if (step.timeoutMs && context.elapsedMs >= *step.timeoutMs) {
        return failed(u"Not within %1 ms: %2"_s.arg(*step.timeoutMs).arg(unmet));
    }
    ++context.phase;
    return {Verdict::Enter, {}};
}

StepResult runQuit(StepContext& /*context*/, const ScriptStep& /*step*/)
{
    const Found found = findObject(u"mainWindow"_s);
    auto* window = qobject_cast<QWidget*>(found.object);
    if (window == nullptr) {
        return failed(found.problem);
    }
    window->close();
    return {Verdict::Quit, {}};
}

StepResult runWindow(StepContext& /*context*/, const ScriptStep& step)
{
    const QWidgetList windows = QApplication::topLevelWidgets();
    for (QWidget* window : windows) {
        if (window->isVisible()) {
            step.argument == "minimise"_L1 ? window->showMinimized() : window->showNormal();
        }
    }
    return {};
}

StepResult runScreenshot(StepContext& context, const ScriptStep& step)
{
    if (step.argument["everyPanel"_L1].toBool()) {
        return screenshotEveryPanel(context);
    }
    const Found found = findObject(step.argument["object"_L1].toString());
    auto* widget = qobject_cast<QWidget*>(found.object);
    if (widget == nullptr) {
        return failed(found.object == nullptr ? found.problem : u"It has no picture."_s);
    }
    return screenshot(context, *widget, step.argument["file"_L1].toString());
}

QDialog* openDialog()
{
    if (auto* modal = qobject_cast<QDialog*>(QApplication::activeModalWidget())) {
        return modal;
    }
    QDialog* last = nullptr;
    const QWidgetList windows = QApplication::topLevelWidgets();
    for (QWidget* window : windows) {
        auto* dialog = qobject_cast<QDialog*>(window);
        if (dialog != nullptr && dialog->isVisible()
            && (last == nullptr || dialog->isActiveWindow())) {
            last = dialog;
        }
    }
    return last;
}

StepResult runDialog(StepContext& context, const ScriptStep& step)
{
    QDialog* dialog = openDialog();
    if (dialog == nullptr) {
        return context.elapsedMs < context.timeoutMs ? StepResult{Verdict::Pending, {}}
                                                     : failed(u"No dialog is open."_s);
    }
    return resultOf(input::answer(*dialog, step.argument == "accept"_L1));
}

StepResult runFile(StepContext& context, const ScriptStep& step)
{
    if (context.phase == 0) {
        const Target target = reach(context, step.argument["object"_L1].toString());
        if (target.notYet) {
            return *target.notYet;
        }
        QString path = step.argument["path"_L1].toString();
        path.replace(u"{screenshots}"_s, context.folder);
        if (path.startsWith(context.folder)) {
            QDir().mkpath(context.folder);
        }
        context.fileDialogs.answerNext(path);
        context.phase = 1;
        context.phaseBeganMs = context.elapsedMs;
        if (const QString problem = input::click(*target.object); !problem.isEmpty()) {
            context.fileDialogs.takeAnswerBack();
            return failed(problem);
        }
    }
    if (!context.fileDialogs.isAnswerWaiting()) {
        return {};
    }
    if (context.elapsedMs - context.phaseBeganMs < kAskMs) {
        return {Verdict::Pending, {}};
    }
    context.fileDialogs.takeAnswerBack();
    return failed(u"It did not ask for a file."_s);
}

constexpr std::array kActions{
    ActionRow{"click", checkName, runClick},
    ActionRow{"set", checkSet, runSet},
    ActionRow{"key", checkKey, runKey},
    ActionRow{"waitFor", checkCondition, runWaitFor},
    ActionRow{"expect", checkCondition, runExpect},
    ActionRow{"sleepMs", checkSleep, runSleep},
    ActionRow{"repeat", checkRepeat, runRepeat},
    ActionRow{"quit", checkTrue, runQuit},
    ActionRow{"window", checkWindow, runWindow},
    ActionRow{"screenshot", checkScreenshot, runScreenshot},
    ActionRow{"dialog", checkDialog, runDialog},
    ActionRow{"file", checkFile, runFile},
};

} // namespace

const ActionRow* findAction(QStringView name)
{
    const auto row =
        std::find_if(kActions.begin(), kActions.end(), [name](const ActionRow& candidate) {
            return name
                == QLatin1StringView(candidate.name.data(),
                                     static_cast<qsizetype>(candidate.name.size()));
        });
    return row == kActions.end() ? nullptr : &*row;
}

} // namespace trex
