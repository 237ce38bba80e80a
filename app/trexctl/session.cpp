// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/trexctl/session.h"

#include "app/common/logging.h"
#include "app/trexctl/verb.h"

namespace trex {
namespace {

using namespace std::chrono_literals;

// Opening and identifying are bounded by the transport and the engine; this is for what nobody
// thought of, so that nothing ever hangs. The engine asks up to six times.
constexpr auto kLongestOpen = 15s;
constexpr int kMostOpenTimeouts = 8;
constexpr auto kLongestClose = 3s;

OpenOptions optionsFor(const Verb& verb, OpenOptions options)
{
    options.identify = verb.line() == Verb::Line::Identified;
    options.stopOnClose = verb.stopsOnClose(); // a motor command leaves the motor as told
    options.reconnect = verb.ridesOverLoss();
    return options;
}

/// A loss that is the port's and not the controller's silence.
bool isPortLoss(const Error& error)
{
    return exitCodeOf(error.code) == exitcode::kPort;
}

} // namespace

Session::Session(Verb& verb, const OpenOptions& options, bool isJson, const QString& journalPath)
    : m_verb(verb)
    , m_options(optionsFor(verb, options))
    , m_output(isJson)
    , m_controller(nullptr, nullptr)
    , m_settings(m_controller)
    , m_journal(journalPath)
    , m_audit(m_controller, m_settings, m_journal, WriteAudit::WhenUnsaved::GoOn)
{
    m_watchdog.setSingleShot(true);
    connect(&m_controller, &Controller::stateChanged, this, &Session::onState);
    connect(&m_controller, &Controller::closed, this, &Session::finish);
    connect(&m_audit, &WriteAudit::told, this,
            [this](int /*severity*/, const QString& sentence) { warn(sentence); });
    connect(&m_controller, &Controller::recordsArrived, this,
            [this](const std::vector<TransactionRecord>& records) {
                for (const auto& record : records) {
                    if (record.priority <= Priority::Motor && !record.isRaw) {
                        m_sentMotorBytes += record.sentBytes;
                    }
                }
            });
}

Session::~Session() = default;

void Session::start()
{
    if (m_verb.line() == Verb::Line::None) {
        begin();
        return;
    }
    m_isOpen = true;
    connect(&m_watchdog, &QTimer::timeout, this, [this] {
        fail(Error{ErrorCode::NoReply, m_options.port});
    });
    m_watchdog.start(kLongestOpen + kMostOpenTimeouts * m_options.line.timeout);
    m_controller.open(m_options);
}

void Session::onState(LinkState state)
{
    if (hasEnded()) {
        return;
    }
    if (state == LinkState::Connected) {
        if (!m_hasBegun) {
            emit connected();
            begin();
        }
        return;
    }
    const auto error = m_controller.lastError();
    if (state != LinkState::Connecting && error && (!m_hasBegun || isPortLoss(*error))) {
        fail(*error);
    }
}

void Session::begin()
{
    m_hasBegun = true;
    m_watchdog.stop();
    m_watchdog.disconnect();
    if (!m_verb.usesSettings()) {
        m_task = m_verb.run(*this);
        return;
    }
    m_audit.resolve(this, [this] {
        if (!hasEnded()) {
            m_task = m_verb.run(*this);
        }
    });
}

Required<Reply> Session::ask(const Command& command)
{
    return need<Reply>([this, command](const Awaiting<Reply>::Handler& handler) {
        m_controller.request(command, this, handler);
    });
}

Attempt<Reply> Session::attempt(const Command& command)
{
    return attempt<Reply>([this, command](const Awaiting<Reply>::Handler& handler) {
        m_controller.request(command, this, handler);
    });
}

Attempt<void> Session::sleepUntil(Instant when)
{
    return attempt<void>([this, when](const Awaiting<void>::Handler& handler) {
        const auto rest =
            std::chrono::ceil<std::chrono::milliseconds>(when - std::chrono::steady_clock::now());
        QTimer::singleShot(std::max(rest, 0ms), Qt::PreciseTimer, this,
                           [handler] { handler(Result<void>()); });
    });
}

void Session::interrupt()
{
    if (hasEnded()) {
        emit finished(*m_exitCode);
        return;
    }
    m_verb.interrupted(*this);
}

void Session::end(int exitCode)
{
    if (hasEnded()) {
        return;
    }
    if (exitCode == exitcode::kDone && m_output.isReaderGone()) {
        exitCode = exitcode::kPipeClosed; // as of a program that SIGPIPE has ended: without a word
    } else if (exitCode == exitcode::kDone && !m_output.isGood()) {
        fail(Error{ErrorCode::FileUnwritable, Cli::tr("the answer to standard output")});
        return;
    }
    m_exitCode = exitCode;
    if (exitCode == exitcode::kDone) {
        for (const QString& warning : std::as_const(m_warnings)) {
            printMessage(warning);
        }
    }
    if (!m_isOpen) {
        // Not from within the coroutine that is ending.
        QMetaObject::invokeMethod(this, &Session::finish, Qt::QueuedConnection);
        return;
    }
    m_watchdog.disconnect();
    connect(&m_watchdog, &QTimer::timeout, this, &Session::finish);
    m_watchdog.start(kLongestClose);
    m_controller.close();
}

void Session::fail(const Error& error)
{
    const auto lost = m_controller.lastError();
    if (error.code == ErrorCode::NotConnected && lost) {
        fail(toFailure(*lost));
    } else {
        fail(toFailure(error));
    }
}

void Session::fail(const Failure& failure)
{
    if (!hasEnded()) {
        tell(failure.text);
        end(failure.exitCode);
    }
}

void Session::tell(const QString& sentence)
{
    printMessage(sentence);
}

void Session::finish()
{
    if (hasEnded() && !m_isFinished) {
        m_isFinished = true;
        emit finished(*m_exitCode);
    }
}

std::function<bool()> Session::isEndedTest() const
{
    return [this] { return hasEnded(); };
}

} // namespace trex
