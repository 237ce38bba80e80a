// SPDX-License-Identifier: GPL-3.0-or-later
#include "protocol/session/linkadvice.h"

#include "protocol/session/linkfacts.h"

#include <QCoreApplication>
#include <QStringList>

namespace trex {

namespace {

using namespace Qt::Literals::StringLiterals;
using namespace linkfacts;
using Look = LinkAdvice::Look;
using Facts = const LinkFacts&;

QString words(const char* text)
{
    return QCoreApplication::translate("LinkAdvice", text);
}

template <std::uint8_t mask>
bool hasUartErrors(Facts f)
{
    // Without CRC-7 a damaged answer may say anything about the controller.
    return uartCount(f, mask) > 0 && (f.line.hasCrc() || !isDamaged(f));
}

template <std::uint8_t mask>
QStringList uartWords(Facts f)
{
    return {number(uartCount(f, mask))};
}

struct AdviceRow {
    LinkAdviceKind kind;
    QLatin1StringView key;
    bool (*holds)(Facts);
    Look look;
    const char* text; ///< QT_TRANSLATE_NOOP("LinkAdvice", …)
    QStringList (*arguments)(Facts) = nullptr;
    QLatin1StringView panel{};
    QLatin1StringView control{};
    QString (*command)(Facts) = nullptr;
    bool isAlone = false; ///< nothing after it is looked at
    bool isGuess = false;
};

constexpr QLatin1StringView kConnection("connection");
constexpr QLatin1StringView kParameters("parameters");
constexpr QLatin1StringView kUartSettings("parameters.uart-settings.editor");

constexpr std::array kRows{
    AdviceRow{.kind = LinkAdviceKind::NotConnected,
              .key = QLatin1StringView("notConnected"),
              .holds = [](Facts f) { return f.state != LinkState::Connected; },
              .look = Look::Off,
              .text = QT_TRANSLATE_NOOP("LinkAdvice",
                                        "Not connected: there is nothing to judge. What figures "
                                        "there are stem from the time before."),
              .panel = kConnection,
              .isAlone = true},
    AdviceRow{.kind = LinkAdviceKind::TooEarly,
              .key = QLatin1StringView("tooEarly"),
              .holds = [](Facts f) { return recent(f).answersDue() < kEnough; },
              .look = Look::Off,
              .text = QT_TRANSLATE_NOOP("LinkAdvice",
                                        "Too early to judge: %1 of at least %2 answers so far."),
              .arguments =
                  [](Facts f) {
                      return QStringList{number(recent(f).answersDue()), number(kEnough)};
                  },
              .isAlone = true},
    AdviceRow{.kind = LinkAdviceKind::LineLost,
              .key = QLatin1StringView("lineLost"),
              .holds = [](Facts f) { return f.health.total.losses > 0; },
              .look = Look::Warning,
              .text = QT_TRANSLATE_NOOP(
                  "LinkAdvice",
                  "Times that the line was lost since the counting began: %1. A loose plug, a "
                  "controller that browns out or an adapter without power does that: check plugs "
                  "and supply. The log has the moments."),
              .arguments = [](Facts f) { return QStringList{number(f.health.total.losses)}; },
              .panel = QLatin1StringView("log")},
    AdviceRow{
        .kind = LinkAdviceKind::ForeignTraffic,
        .key = QLatin1StringView("foreignTraffic"),
        .holds =
            [](Facts f) {
                return recent(f).unaskedBursts >= kFewest
                    && 2 * recent(f).unaskedBursts > recent(f).damaged();
            },
        .look = Look::Fault,
        .text = QT_TRANSLATE_NOOP(
            "LinkAdvice",
            "Bytes that nobody had asked for came %1 times in the last minute (%2 bytes): "
            "another master talks on this line, or a second controller answers (inferred). "
            "Take the other master off; give each controller a number of its own and choose "
            "the Pololu protocol with that number."),
        .arguments =
            [](Facts f) {
                return QStringList{number(recent(f).unaskedBursts), number(recent(f).unaskedBytes)};
            },
        .panel = kConnection,
        .control = QLatin1StringView("connection.protocol"),
        .isGuess = true},
    AdviceRow{.kind = LinkAdviceKind::DamagedWithoutCrc,
              .key = QLatin1StringView("damagedWithoutCrc"),
              .holds = [](Facts f) { return isDamaged(f) && !f.line.hasCrc(); },
              .look = Look::Fault,
              .text = QT_TRANSLATE_NOOP(
                  "LinkAdvice",
                  "%1 of %2 answers came damaged in the last minute (%3 %). Without CRC-7 a "
                  "damaged value of the right length goes unnoticed. Set error detection to CRC-7 "
                  "in the UART settings, apply, and switch the controller off and on; the program "
                  "follows. Then look for the cause: motor wires beside the cable, a missing "
                  "ground."),
              .arguments = damagedWords,
              .panel = kParameters,
              .control = kUartSettings},
    AdviceRow{.kind = LinkAdviceKind::DamagedDespiteCrc,
              .key = QLatin1StringView("damagedDespiteCrc"),
              .holds = [](Facts f) { return isDamaged(f) && f.line.hasCrc(); },
              .look = Look::Warning,
              .text = QT_TRANSLATE_NOOP(
                  "LinkAdvice",
                  "%1 of %2 answers came damaged in the last minute (%3 %); CRC-7 found them, and "
                  "they were asked for again. Lead the cable away from the motor wires, connect "
                  "the grounds, or choose a lower baud rate in the UART settings."),
              .arguments = damagedWords,
              .panel = kParameters,
              .control = kUartSettings},
    AdviceRow{.kind = LinkAdviceKind::NoAnswers,
              .key = QLatin1StringView("noAnswers"),
              .holds =
                  [](Facts f) {
                      return recent(f).timeouts >= kFewest
                          && shareOf(recent(f).timeouts, f) >= kSilentShare;
                  },
              .look = Look::Warning,
              .text = QT_TRANSLATE_NOOP(
                  "LinkAdvice",
                  "%1 of %2 questions got no answer within %3 ms in the last minute (%4 %): bytes "
                  "are lost on the way, or the controller is off for moments. Check plugs, ground "
                  "and supply. If answers only come later than that, give a longer reply timeout."),
              .arguments =
                  [](Facts f) {
                      const auto wait = f.line.timeout + f.health.patience;
                      return QStringList{number(recent(f).timeouts), number(recent(f).answersDue()),
                                         milliseconds(wait),
                                         percent(shareOf(recent(f).timeouts, f))};
                  },
              .panel = kConnection,
              .control = QLatin1StringView("connection.timeout")},
    AdviceRow{.kind = LinkAdviceKind::ControllerFrame,
              .key = QLatin1StringView("controllerFrame"),
              .holds = hasUartErrors<kFrameBits>,
              .look = Look::Warning,
              .text = QT_TRANSLATE_NOOP(
                  "LinkAdvice",
                  "The controller reported a frame or parity error %1 times in the last minute: "
                  "noise on the wire to it, or its speed, parity or stop bits are not quite ours."),
              .arguments = uartWords<kFrameBits>,
              .panel = kConnection,
              .control = QLatin1StringView("connection.baud")},
    AdviceRow{.kind = LinkAdviceKind::ControllerOverrun,
              .key = QLatin1StringView("controllerOverrun"),
              .holds = hasUartErrors<kOverrunBits>,
              .look = Look::Warning,
              .text = QT_TRANSLATE_NOOP(
                  "LinkAdvice",
                  "The controller could not take bytes as fast as they came, %1 times in the last "
                  "minute: set two stop bits or a lower baud rate in the UART settings."),
              .arguments = uartWords<kOverrunBits>,
              .panel = kParameters,
              .control = kUartSettings},
    AdviceRow{.kind = LinkAdviceKind::ControllerFormat,
              .key = QLatin1StringView("controllerFormat"),
              .holds = hasUartErrors<kFormatBits>,
              .look = Look::Warning,
              .text = QT_TRANSLATE_NOOP(
                  "LinkAdvice",
                  "The controller got packets that it could not read or whose CRC was wrong, %1 "
                  "times in the last minute: bytes are damaged on the way to it, or another master "
                  "talks between ours."),
              .arguments = uartWords<kFormatBits>,
              .panel = QLatin1StringView("packets")},
    AdviceRow{.kind = LinkAdviceKind::ControllerSendBuffer,
              .key = QLatin1StringView("controllerSendBuffer"),
              .holds = hasUartErrors<uartbit::kSendBufferOverrun>,
              .look = Look::Warning,
              .text = QT_TRANSLATE_NOOP(
                  "LinkAdvice",
                  "The controller's answers piled up %1 times in the last minute. This program "
                  "waits for each answer before it asks again: another master asks, too."),
              .arguments = uartWords<uartbit::kSendBufferOverrun>,
              .panel = QLatin1StringView("status")},
    AdviceRow{.kind = LinkAdviceKind::ControllerTimeout,
              .key = QLatin1StringView("controllerTimeout"),
              .holds = hasUartErrors<uartbit::kTimeout>,
              .look = Look::Warning,
              .text = QT_TRANSLATE_NOOP(
                  "LinkAdvice",
                  "The controller's serial timeout passed %1 times in the last minute: for that "
                  "long nothing it could read reached it. If the line is otherwise well, give a "
                  "longer serial timeout."),
              .arguments = uartWords<uartbit::kTimeout>,
              .panel = kParameters,
              .control = QLatin1StringView("parameters.serial-timeout.editor")},
    AdviceRow{
        .kind = LinkAdviceKind::LateAnswers,
        .key = QLatin1StringView("lateAnswers"),
        .holds = [](Facts f) { return recent(f).lateReplies > 0 && !isDamaged(f); }, // else noise
        .look = Look::Warning,
        .text = QT_TRANSLATE_NOOP(
            "LinkAdvice",
            "Answers came after the %1 ms that are waited for them, %2 times in the last "
            "minute; %3 ms are waited now. Give a reply timeout of at least %3 ms, or find "
            "what holds them back: a slow network, a busy computer, a wireless adapter."),
        .arguments =
            [](Facts f) {
                const Duration timeout = f.line.timeout;
                return QStringList{milliseconds(timeout), number(recent(f).lateReplies),
                                   milliseconds(timeout + f.health.patience)};
            },
        .panel = kConnection,
        .control = QLatin1StringView("connection.timeout")},
    AdviceRow{
        .kind = LinkAdviceKind::LatencyTimer,
        .key = QLatin1StringView("latencyTimer"),
        .holds = hasSlowTimer,
        .look = Look::Warning,
        .text = QT_TRANSLATE_NOOP(
            "LinkAdvice",
            "The adapter gathers bytes for up to %4 ms before it hands them on (its latency "
            "timer): half of the answers take more than %1 ms, where the wire needs %2 ms. "
            "This program may not set it. The command below sets 1 ms until the adapter is "
            "plugged in again; the udev rule 60-trexpanel.rules sets it for good."),
        .arguments =
            [](Facts f) {
                return answerWords(f)
                    << number(static_cast<quint64>(*f.health.adapter.latencyTimerMs));
            },
        .command =
            [](Facts f) { return u"echo 1 | sudo tee %1"_s.arg(f.health.adapter.timerFile); }},
    AdviceRow{
        .kind = LinkAdviceKind::HeldBack,
        .key = QLatin1StringView("heldBack"),
        .holds = [](Facts f) { return medianOf(recent(f).extra) >= kHeldBack && !hasSlowTimer(f); },
        .look = Look::Warning,
        .text = QT_TRANSLATE_NOOP(
            "LinkAdvice",
            "Half of the answers take more than %1 ms, where the wire needs %2 ms: something "
            "holds them back for %3 ms. A USB adapter whose latency timer stands at 16 ms "
            "does that (inferred), so does a network or a busy computer: set the timer to 1 "
            "ms where the adapter is plugged in."),
        .arguments = answerWords,
        .isGuess = true},
    AdviceRow{.kind = LinkAdviceKind::LineTooSlow,
              .key = QLatin1StringView("lineTooSlow"),
              .holds = [](Facts f) { return isTooSlow(f) && sufficientBaud(f).has_value(); },
              .look = Look::Warning,
              .text = QT_TRANSLATE_NOOP(
                  "LinkAdvice",
                  "The panels ask for more than %1 baud carry: they get %2 % of their rates, and "
                  "the wire is busy %3 % of the time. Set %4 baud in the UART settings, apply, and "
                  "switch the controller off and on; the program follows."),
              .arguments =
                  [](Facts f) {
                      return QStringList{QString::number(f.line.baud), percent(f.stats.pollScale),
                                         percent(f.health.now.wireShare()),
                                         QString::number(*sufficientBaud(f))};
                  },
              .panel = kParameters,
              .control = kUartSettings},
    AdviceRow{
        .kind = LinkAdviceKind::WaitingTooLong,
        .key = QLatin1StringView("waitingTooLong"),
        .holds = [](Facts f) { return isTooSlow(f) && !sufficientBaud(f); },
        .look = Look::Warning,
        .text = QT_TRANSLATE_NOOP(
            "LinkAdvice",
            "The panels get %1 % of the rates that they ask for. The wire is busy %2 % of "
            "the time, the rest is waiting for the adapter, the controller or a busy "
            "computer: no higher baud rate would help much. Close panels that you do not "
            "need."),
        .arguments =
            [](Facts f) {
                return QStringList{percent(f.stats.pollScale), percent(f.health.now.wireShare())};
            }},
    AdviceRow{.kind = LinkAdviceKind::Echo,
              .key = QLatin1StringView("echo"),
              .holds = [](Facts f) { return f.stats.echo; },
              .look = Look::Note,
              .text = QT_TRANSLATE_NOOP("LinkAdvice",
                                        "The line echoes what is sent (RS-232 wiring). The echo is "
                                        "recognised and dropped; nothing needs to be done."),
              .panel = kConnection,
              .control = QLatin1StringView("connection.echo")},
    AdviceRow{.kind = LinkAdviceKind::Well,
              .key = QLatin1StringView("well"),
              .holds = [](Facts) { return true; },
              .look = Look::Ok,
              .text = QT_TRANSLATE_NOOP(
                  "LinkAdvice",
                  "The line is well: %1 answers in the last minute, %2 damaged or missing; half of "
                  "them within %3 ms, 99 of 100 within %4 ms. The wire alone needs %5 ms."),
              .arguments =
                  [](Facts f) {
                      const HealthCounts& counts = recent(f);
                      return QStringList{
                          number(counts.replies), number(counts.timeouts + counts.damaged()),
                          milliseconds(medianOf(counts.trips)),
                          milliseconds(counts.trips.quantile(0.99).value_or(Duration(0))),
                          milliseconds(medianOf(counts.ideal))};
                  }},
};
static_assert(kRows.size() == kLinkAdviceCount);
static_assert([] {
    for (std::size_t i = 0; i < kRows.size(); ++i) {
        if (static_cast<std::size_t>(kRows[i].kind) != i) {
            return false;
        }
    }
    return true;
}());

LinkAdvice made(const AdviceRow& row, Facts facts)
{
    QString sentence = words(row.text);
    const QStringList arguments = row.arguments != nullptr ? row.arguments(facts) : QStringList{};
    for (qsizetype i = 0; i < arguments.size(); ++i) {
        sentence.replace(u'%' + QString::number(i + 1), arguments.at(i));
    }
    return {row.kind,   row.look,    sentence,
            row.panel,  row.control, row.command != nullptr ? row.command(facts) : QString(),
            row.isGuess};
}

} // namespace

QLatin1StringView keyOf(LinkAdviceKind kind)
{
    return kRows.at(static_cast<std::size_t>(kind)).key;
}

std::vector<LinkAdvice> linkAdvice(const LinkFacts& facts)
{
    std::vector<LinkAdvice> advice;
    bool isWell = true;
    for (const AdviceRow& row : kRows) {
        if (!row.holds(facts) || (row.kind == LinkAdviceKind::Well && !isWell)) {
            continue;
        }
        advice.push_back(made(row, facts));
        isWell = isWell && row.look == Look::Note;
        if (row.isAlone) {
            break;
        }
    }
    return advice;
}

} // namespace trex
