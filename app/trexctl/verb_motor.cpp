// SPDX-License-Identifier: GPL-3.0-or-later
// motor, stop
#include "app/common/numbers.h"
#include "app/trexctl/controllertext.h"
#include "app/trexctl/verbs.h"
#include "protocol/codec/packet.h"
#include "protocol/errortext.h"
#include "protocol/session/serialtimeoutwatch.h"

#include <CLI/CLI.hpp>

using namespace Qt::Literals::StringLiterals;

namespace trex {
namespace {

struct MotorRow {
    MotorId id;
    const char* key; ///< in JSON
    const char* title; ///< QT_TRANSLATE_NOOP("Cli", …)
};
constexpr auto kMotors = std::to_array<MotorRow>({
    {MotorId::Motor1, "motor1", QT_TRANSLATE_NOOP("Cli", "Motor 1")},
    {MotorId::Motor2, "motor2", QT_TRANSLATE_NOOP("Cli", "Motor 2")},
    {MotorId::Aux, "aux", QT_TRANSLATE_NOOP("Cli", "Aux")},
});

struct ActionRow {
    MotorOrder::Action action;
    const char* key;
};
constexpr auto kActions = std::to_array<ActionRow>({
    {MotorOrder::Action::Set, "set"},
    {MotorOrder::Action::Accelerate, "accelerate"},
    {MotorOrder::Action::Brake, "brake"},
});

constexpr std::chrono::milliseconds kSettle{10};
constexpr std::chrono::milliseconds kLook{20}; // how often a drive with an end is looked at
constexpr double kLongestSeconds = 3600.0;

using Orders = std::vector<std::pair<MotorId, MotorOrder>>;

QLatin1StringView keyOf(MotorOrder::Action action)
{
    return QLatin1StringView(kActions.at(static_cast<std::size_t>(action)).key);
}

QJsonObject motorsJson(const Orders& orders)
{
    QJsonObject motors;
    for (const auto& [motor, order] : orders) {
        const bool isBrake = order.action == MotorOrder::Action::Brake;
        motors.insert(QLatin1StringView(kMotors.at(static_cast<std::size_t>(motor)).key),
                      QJsonObject{{u"action"_s, keyOf(order.action)},
                                  {isBrake ? u"duty"_s : u"speed"_s, order.amount}});
    }
    return motors;
}

QString motorsText(const Orders& orders)
{
    std::vector<std::pair<QString, QString>> lines;
    for (const auto& [motor, order] : orders) {
        const QString percent = QString::number(order.amount * 100.0 / kFullSpeed, 'f', 0);
        lines.emplace_back(
            Cli::tr(kMotors.at(static_cast<std::size_t>(motor)).title),
            u"%1 %2 (%3 %)"_s.arg(keyOf(order.action)).arg(order.amount).arg(percent));
    }
    return labelled(lines);
}

/// What motor and stop have in common: packets out, then 0x83 asked.
class DriveVerb : public Verb {
public:
    [[nodiscard]] Line line() const override { return Line::Open; }

    Task run(Session& session) override
    {
        co_await session.need<Reply>([this, &session](const Awaiting<Reply>::Handler& handler) {
            const auto sent = send(session, handler);
            if (!sent) {
                handler(tl::make_unexpected(sent.error()));
            }
        });
        // One user saw 0xFF after motor commands (facts.md 4, F-13311): such a byte is to be here,
        // and flushed, before it could be taken for the answer.
        const auto sentBytes = static_cast<int>(session.sentMotorBytes().size());
        co_await session.sleepUntil(std::chrono::steady_clock::now() + kSettle
                                    + session.options().line.timeOf(sentBytes + 1));
        const Result<Reply> control = co_await session.attempt(query("get-serial-control"));
        if (!control) {
            const Failure failure = toFailure(control.error());
            session.fail(Failure{
                failure.exitCode,
                Cli::tr("The command was sent, but nobody confirms it: %1").arg(failure.text)});
            co_return;
        }
        const bool isPending = control->payload.front() == 0;
        if (const auto seconds = duration()) {
            if (isPending) {
                session.fail(Failure{exitcode::kRefused,
                                     Cli::tr("Serial does not control the motors now, and a drive "
                                             "with --duration does not wait for it.")});
                co_return;
            }
            const Instant end = std::chrono::steady_clock::now()
                + std::chrono::duration_cast<Duration>(std::chrono::duration<double>(*seconds));
            while (session.controller().isArmed() && std::chrono::steady_clock::now() < end) {
                co_await session.sleepUntil(
                    std::min(end, std::chrono::steady_clock::now() + kLook));
            }
            if (const QString reason = endedEarly(session); !reason.isEmpty()) {
                session.fail(Failure{exitcode::kNoReply, reason});
                co_return;
            }
            co_await session.need<Reply>([&session](const Awaiting<Reply>::Handler& handler) {
                session.controller().stop(Controller::StopKind::Coast, &session, handler);
            });
        }
        const QString sent = toHex(session.sentMotorBytes());
        QJsonObject answer{
            {u"sent"_s, sent}, {u"motors"_s, motorsJson(orders())}, {u"pending"_s, isPending}};
        if (const auto seconds = duration()) {
            answer[u"seconds"_s] = *seconds;
        }
        session.output().answer(answer, motorsText(orders()));
        if (isPending) {
            session.warn(pendingText());
        }
        session.end();
    }

protected:
    /// How long the orders are to hold, in seconds; none: they are left standing.
    [[nodiscard]] virtual std::optional<double> duration() const { return std::nullopt; }
    [[nodiscard]] virtual Orders orders() const = 0;
    virtual Result<void> send(Session& session, const Awaiting<Reply>::Handler& handler) = 0;
    [[nodiscard]] virtual QString pendingText() const = 0;

private:
    /// Why a drive with an end is over before it; empty: it is not.
    static QString endedEarly(Session& session)
    {
        const Controller& controller = session.controller();
        if (controller.isArmed()) {
            return {};
        }
        const QString why = controller.lastError()
            ? errorText(*controller.lastError())
            : disarmText(controller.gate().lastDisarming().reason);
        return Cli::tr("The drive has ended before its time: %1").arg(why);
    }
};

class MotorVerb : public DriveVerb {
public:
    void declare(CLI::App& app) override
    {
        const auto text = [](const QString& words) { return words.toStdString(); };
        app.add_option("M", m_motorText, text(Cli::tr("1, 2, both or aux")))
            ->required()
            ->type_name("");
        app.add_option("ACTION", m_actionText, text(Cli::tr("set, accelerate or brake")))
            ->required()
            ->type_name("");
        app.add_option(
               "SPEED", m_amountTexts,
               text(Cli::tr("-127 to 127 (aux 0 to 127); braking duty 0 to 127; both: one for "
                            "both, or two")))
            ->required()
            ->expected(1, 2)
            ->type_name("");
        app.add_option_function<std::string>(
               "--duration",
               [this](const std::string& given) { m_durationText = QString::fromStdString(given); },
               text(Cli::tr("stop all motors after this many seconds, and when interrupted; "
                            "without it the motors are left as told")))
            ->type_name("S");
    }

    [[nodiscard]] Line line() const override { return m_duration ? Line::Identified : Line::Open; }
    [[nodiscard]] bool stopsOnClose() const override { return m_duration.has_value(); }

    Checked check(const OpenOptions&) override
    {
        return readMotors()
            .and_then([this] { return readAction(); })
            .and_then([this] { return readAmounts(); })
            .and_then([this]() -> Checked {
                if (m_durationText.isNull()) {
                    return {};
                }
                return checked(positiveNumber("--duration", m_durationText, kLongestSeconds)
                                   .map([this](double seconds) { m_duration = seconds; }));
            });
    }

    /// Whoever interrupts an order no longer wants it.
    void interrupted(Session& session) override
    {
        if (m_isInterrupted || !m_isSent) {
            session.end(exitcode::kInterrupted);
            return;
        }
        m_isInterrupted = true;
        session.controller().stop(
            Controller::StopKind::Coast, &session, [&session](const Result<Reply>& stopped) {
                session.tell(stopped ? Cli::tr("Interrupted; the motors were told to stop.")
                                     : Cli::tr("Interrupted; stop could not be sent: %1")
                                           .arg(errorText(stopped.error())));
                session.end(exitcode::kInterrupted);
            });
    }

protected:
    [[nodiscard]] std::optional<double> duration() const override { return m_duration; }

    Orders orders() const override
    {
        Orders all;
        for (std::size_t i = 0; i < m_motors.size(); ++i) {
            all.emplace_back(m_motors[i], m_orders[i]);
        }
        return all;
    }

    Result<void> send(Session& session, const Awaiting<Reply>::Handler& handler) override
    {
        Controller& controller = session.controller();
        if (m_duration) {
            m_timeoutWatch = std::make_unique<SerialTimeoutWatch>(controller, session.settings());
        }
        m_isSent = true;
        return controller.arm().and_then([&] {
            return m_motors.size() == 2
                ? controller.driveBoth(m_orders[0], m_orders[1], &session, handler)
                : controller.driveMotor(m_motors[0], m_orders[0], &session, handler);
        });
    }

    QString pendingText() const override
    {
        return Cli::tr(
            "Serial does not control the motors now: the command waits in the controller "
            "and acts as soon as serial override begins.");
    }

private:
    Checked readMotors()
    {
        if (m_motorText == "both") {
            m_motors = {MotorId::Motor1, MotorId::Motor2};
        } else if (m_motorText == "aux") {
            m_motors = {MotorId::Aux};
        } else {
            const auto number = numberFromText(QString::fromStdString(m_motorText));
            if (!number || *number < 1 || *number > 2) {
                return usage(Cli::tr("There is no motor '%1': give 1, 2, both or aux. Nothing was "
                                     "sent.")
                                 .arg(QString::fromStdString(m_motorText)));
            }
            m_motors = {*number == 1 ? MotorId::Motor1 : MotorId::Motor2};
        }
        return {};
    }

    Checked readAction()
    {
        for (const auto& row : kActions) {
            if (m_actionText == row.key) {
                m_action = row.action;
                if (m_action == MotorOrder::Action::Brake && m_motors[0] == MotorId::Aux) {
                    return usage(Cli::tr("The auxiliary motor cannot brake: set it to 0 instead. "
                                         "Nothing was sent."));
                }
                return {};
            }
        }
        return usage(
            Cli::tr("A motor cannot '%1': give set, accelerate or brake. Nothing was sent.")
                .arg(QString::fromStdString(m_actionText)));
    }

    Checked readAmounts()
    {
        if (m_amountTexts.size() > m_motors.size()) {
            return usage(Cli::tr("Two numbers are for 'motor both' only. Nothing was sent."));
        }
        const bool isBrake = m_action == MotorOrder::Action::Brake;
        const bool isOneWay = isBrake || m_motors[0] == MotorId::Aux;
        for (std::size_t i = 0; i < m_motors.size(); ++i) {
            const auto& text = m_amountTexts.at(std::min(i, m_amountTexts.size() - 1));
            const auto amount =
                numberInRange(isBrake ? "duty" : "speed", QString::fromStdString(text),
                              isOneWay ? 0 : -kFullSpeed, kFullSpeed);
            if (!amount) {
                return checked(amount);
            }
            m_orders.push_back({m_action, *amount});
        }
        return {};
    }

    std::string m_motorText;
    std::string m_actionText;
    std::vector<std::string> m_amountTexts;
    std::vector<MotorId> m_motors;
    MotorOrder::Action m_action = MotorOrder::Action::Set;
    std::vector<MotorOrder> m_orders;
    QString m_durationText;
    std::optional<double> m_duration;
    std::unique_ptr<SerialTimeoutWatch> m_timeoutWatch; ///< keeps the serial timeout from acting
    bool m_isSent = false;
    bool m_isInterrupted = false;
};

class StopVerb : public DriveVerb {
public:
    void declare(CLI::App& app) override
    {
        app.add_flag(
            "--brake", m_isBrake,
            Cli::tr("motors 1 and 2 at full brake duty instead of coasting").toStdString());
    }

protected:
    Orders orders() const override
    {
        const MotorOrder order = m_isBrake ? MotorOrder{MotorOrder::Action::Brake, kFullSpeed}
                                           : MotorOrder{MotorOrder::Action::Set, 0};
        return {{MotorId::Motor1, order},
                {MotorId::Motor2, order},
                {MotorId::Aux, {MotorOrder::Action::Set, 0}}};
    }

    Result<void> send(Session& session, const Awaiting<Reply>::Handler& handler) override
    {
        session.controller().stop(m_isBrake ? Controller::StopKind::Brake
                                            : Controller::StopKind::Coast,
                                  &session, handler);
        return {};
    }

    QString pendingText() const override
    {
        return Cli::tr("Serial does not control the motors now: the channels may still drive them. "
                       "The stop acts as soon as serial override begins.");
    }

private:
    bool m_isBrake = false;
};

} // namespace

std::unique_ptr<Verb> makeMotor()
{
    return std::make_unique<MotorVerb>();
}

std::unique_ptr<Verb> makeStop()
{
    return std::make_unique<StopVerb>();
}

} // namespace trex
