// SPDX-License-Identifier: GPL-3.0-or-later
#include "protocol/procedures/watchdogproof.h"

#include "protocol/session/devicesettings.h"

#include <cmath>

namespace trex {

using namespace std::chrono_literals;

namespace {

constexpr const ParameterRow& kTimeoutRow = parameterRow("serial-timeout");
constexpr auto kUnit = 100ms; // facts.md 2, 0x07
constexpr auto kSettle = 700ms; // a small motor has its speed by then
constexpr std::uint8_t kTimeoutBit = 0x80; // command documentation, 0x85
constexpr double kLeastCounts = 2.0; // below, a collapse cannot be told from noise
constexpr double kCollapsed = 0.3; // of the running current
constexpr int kMostTrials = 7;
constexpr double kShare = 0.10; // how far from the setting is still the setting
constexpr double kSlackMs = 30.0; // of clocks, and of the controller's own 10 ms work
constexpr double kFineMs = 25.0; // narrow enough

double milliseconds(Duration duration)
{
    return std::chrono::duration<double, std::milli>(duration).count();
}

} // namespace

WatchdogProof::WatchdogProof(Controller& controller, DeviceSettings& settings,
                             const Options& options, QObject* parent)
    : Procedure(parent)
    , m_controller(controller)
    , m_settings(settings)
    , m_options(options)
    , m_wait(this)
{
    m_wait.setSingleShot(true);
    m_wait.setTimerType(Qt::PreciseTimer);
    connect(&controller, &Controller::recordsArrived, this, &WatchdogProof::onRecords);
    connect(&controller, &Controller::armedChanged, this, [this](bool armed) {
        if (!armed) {
            end(fail(ErrorCode::Cancelled)); // whatever closed the gate has stopped the motors
        }
    });
    connect(&controller, &Controller::ordersChanged, this, [this] {
        if (m_hasSpun && !hasOnlyOurOrders()) {
            end(fail(ErrorCode::Cancelled)); // somebody drives
        }
    });
}

std::chrono::milliseconds WatchdogProof::duration(std::chrono::milliseconds timeout)
{
    return (2 * kSettle + timeout * 3 / 2) * kMostTrials;
}

void WatchdogProof::start()
{
    setRunning();
    m_verdict = {};
    m_trial = 0;
    if (!m_controller.isArmed()) {
        finish(fail(ErrorCode::Disarmed));
        return;
    }
    m_settings.readSurely(kTimeoutRow, std::nullopt, this,
                          [this](const Result<int>& raw) { onTimeoutRead(raw); });
}

void WatchdogProof::cancel()
{
    end(fail(ErrorCode::Cancelled));
}

bool WatchdogProof::hasOnlyOurOrders() const
{
    for (const MotorId motor : {MotorId::Motor1, MotorId::Motor2, MotorId::Aux}) {
        const int ours = motor == m_options.motor ? m_options.speed : 0;
        if (m_controller.lastOrder(motor).amount != ours) {
            return false;
        }
    }
    return true;
}

void WatchdogProof::onTimeoutRead(const Result<int>& raw)
{
    if (!isRunning()) {
        return;
    }
    if (!raw) {
        end(tl::make_unexpected(raw.error()));
        return;
    }
    m_verdict.configured = *raw * kUnit;
    if (*raw == 0) {
        conclude(false, tr("the serial timeout is off"));
        return;
    }
    m_silenceMs = static_cast<double>(m_verdict.configured.count()) / 2;
    spin();
}

void WatchdogProof::spin()
{
    emit progressed(
        m_trial, kMostTrials,
        tr("The motor turns; then nothing is sent for %1 ms.").arg(qRound(m_silenceMs)));
    const auto sent =
        m_controller.driveMotor(m_options.motor, {MotorOrder::Action::Set, m_options.speed});
    if (!sent) {
        end(tl::make_unexpected(sent.error()));
        return;
    }
    m_hasSpun = true;
    m_wait.callOnTimeout(this, &WatchdogProof::measureRunning, Qt::SingleShotConnection);
    m_wait.start(kSettle);
}

void WatchdogProof::measureRunning()
{
    ask("get-currents", [this](const Reply& reply) {
        m_running = countsOf(reply);
        m_verdict.amperes = m_running * amperesPerCount(m_controller.model());
        m_verdict.isCurrentSeen = m_running >= kLeastCounts;
        ask("get-uart-errors", [this](const Reply&) { beSilent(); }); // clears what was latched
    });
}

void WatchdogProof::beSilent()
{
    m_sawTimeout = false;
    m_measuredMs = 0.0;
    m_isWatching = true;
    const std::chrono::milliseconds silence(std::lround(m_silenceMs));
    m_controller.beSilentFor(silence);
    m_wait.callOnTimeout(this, &WatchdogProof::look, Qt::SingleShotConnection);
    m_wait.start(silence + 5ms);
}

void WatchdogProof::look()
{
    ask("get-currents", [this](const Reply& currents) {
        ask("get-uart-errors", [this, currents](const Reply& errors) {
            const auto bits = static_cast<std::uint8_t>(errors.payload.front());
            judge(currents, m_sawTimeout || (bits & kTimeoutBit) != 0);
        });
    });
}

void WatchdogProof::judge(const Reply& currents, bool isLatched)
{
    m_isWatching = false;
    m_controller.endSilence();
    if (m_measuredMs == 0.0) {
        m_measuredMs = m_silenceMs;
    }
    const bool isGone = countsOf(currents) <= std::max(1.0, m_running * kCollapsed);
    const bool isStopped = m_verdict.isCurrentSeen ? isGone : isLatched;
    if (isStopped) {
        m_verdict.stoppedMs =
            m_verdict.stoppedMs > 0.0 ? std::min(m_verdict.stoppedMs, m_measuredMs) : m_measuredMs;
        m_verdict.isLatched = m_verdict.isLatched && isLatched;
    } else {
        m_verdict.survivedMs = std::max(m_verdict.survivedMs, m_measuredMs);
    }
    ++m_trial;
    next();
}

void WatchdogProof::next()
{
    const auto configured = static_cast<double>(m_verdict.configured.count());
    const double latest = configured * (1 + kShare) + kSlackMs;
    const double earliest = configured * (1 - kShare) - kSlackMs;
    const auto [survived, stopped] = std::pair(m_verdict.survivedMs, m_verdict.stoppedMs);
    if (stopped == 0.0 && survived >= latest) {
        conclude(false, tr("the motor still ran after %1 ms of silence").arg(survived, 0, 'f', 0));
        return;
    }
    if (stopped > 0.0 && stopped < earliest) {
        conclude(false, tr("the motor had stopped after %1 ms already").arg(stopped, 0, 'f', 0));
        return;
    }
    if (stopped > 0.0 && !m_verdict.isLatched) {
        conclude(false, tr("the motor stopped, but no timeout was latched"));
        return;
    }
    const bool isNarrow =
        stopped > 0.0 && stopped - survived <= std::max(kFineMs, configured * kShare / 2);
    if (isNarrow || (m_trial >= kMostTrials && stopped > 0.0)) {
        conclude(survived <= latest && stopped >= earliest,
                 tr("it stopped between %1 and %2 ms of silence")
                     .arg(survived, 0, 'f', 0)
                     .arg(stopped, 0, 'f', 0));
        return;
    }
    if (m_trial >= kMostTrials) {
        conclude(false, tr("it did not stop in %1 silences").arg(m_trial));
        return;
    }
    m_silenceMs = stopped > 0.0 ? (survived + stopped) / 2 : latest + kSlackMs;
    spin();
}

void WatchdogProof::conclude(bool isPassed, const QString& why)
{
    m_verdict.isPassed = isPassed;
    QString sentence = isPassed
        ? tr("Watchdog proof passed: serial timeout %1 ms, %2.")
        : tr("Watchdog proof FAILED: serial timeout %1 ms, %2. The motors may run on when this "
             "program or its line fails.");
    sentence = sentence.arg(m_verdict.configured.count()).arg(why);
    if (m_trial > 0 && !m_verdict.isCurrentSeen) {
        sentence += u' '
            + tr("The current was too small to see it collapse: only the timeout bit was judged.");
    }
    m_verdict.sentence = sentence;
    emit m_controller.eventLogged(isPassed ? 0 : 2, sentence);
    end({});
}

void WatchdogProof::end(const Result<void>& result)
{
    if (!isRunning() || std::exchange(m_isEnding, true)) {
        return;
    }
    m_wait.stop();
    m_wait.disconnect(this);
    m_isWatching = false;
    m_hasSpun = false;
    m_controller.endSilence();
    m_controller.stop(); // before anybody is told
    m_isEnding = false;
    finish(result);
}

/// The silence as it was on the line, and a bit that some poll took.
void WatchdogProof::onRecords(const std::vector<TransactionRecord>& records)
{
    if (!isRunning()) {
        return;
    }
    for (const TransactionRecord& record : records) {
        if (m_lastByte && m_isWatching && m_measuredMs == 0.0) {
            const double gap = milliseconds(record.sent - *m_lastByte);
            if (gap >= m_silenceMs * 0.8) {
                m_measuredMs = gap;
            }
        }
        const auto bytes = static_cast<int>(record.sentBytes.size());
        m_lastByte = record.sent + m_controller.options().line.timeOf(bytes);
        const bool isErrors = !record.isRaw && !record.error && !record.receivedBytes.isEmpty()
            && record.command == query("get-uart-errors");
        if (m_isWatching && isErrors
            && (static_cast<std::uint8_t>(record.receivedBytes.front()) & kTimeoutBit) != 0) {
            m_sawTimeout = true;
        }
    }
}

double WatchdogProof::countsOf(const Reply& currents) const
{
    const qsizetype place = m_options.motor == MotorId::Motor2 ? 1 : 0;
    return static_cast<std::uint8_t>(currents.payload.at(place));
}

void WatchdogProof::ask(std::string_view key, const std::function<void(const Reply&)>& then)
{
    m_controller.request(query(key), this, [this, then](const Result<Reply>& reply) {
        if (!isRunning()) {
            return;
        }
        if (!reply) {
            end(tl::make_unexpected(reply.error()));
            return;
        }
        then(*reply);
    });
}

} // namespace trex
