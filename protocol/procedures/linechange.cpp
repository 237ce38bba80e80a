// SPDX-License-Identifier: GPL-3.0-or-later
#include "protocol/procedures/linechange.h"

#include "protocol/codec/parametertable.h"
#include "protocol/errortext.h"
#include "protocol/procedures/linetext.h"

#include <utility>

namespace trex {
namespace {

using namespace Qt::Literals::StringLiterals;

/// The same to both ends: two stop bits are heard as one, and only CRC-7 has a polynomial.
bool isSameLine(const LineSettings& a, const LineSettings& b)
{
    return a.baud == b.baud && a.errorDetection == b.errorDetection
        && (!a.hasCrc() || a.polynomial == b.polynomial)
        && (a.form == PacketForm::Compact || a.device == b.device);
}

} // namespace

LineChange::LineChange(Controller& controller, DeviceSettings& settings, QObject* parent)
    : QObject(parent), m_controller(controller), m_settings(settings)
{
    m_next.setSingleShot(true);
    m_patience.setSingleShot(true);
    connect(&settings, &DeviceSettings::parameterChanged, this, &LineChange::onSettings);
    connect(&controller, &Controller::stateChanged, this, &LineChange::onState);
    connect(&controller, &Controller::closed, this, [this] {
        if (std::exchange(m_isClosing, false) && m_phase == Phase::Reconnecting) {
            attempt();
        } else if (m_phase == Phase::Recovering && m_scan == nullptr && !m_isOpening) {
            recover();
        }
    });
    connect(&m_next, &QTimer::timeout, this, &LineChange::attempt);
}

bool LineChange::isBusy() const
{
    return m_phase == Phase::Reconnecting || m_phase == Phase::Recovering;
}

bool LineChange::isSimulator() const
{
    return m_port.startsWith("sim:"_L1);
}

/// The line after the next power cycle, as far as it was read.
LineSettings LineChange::storedLine() const
{
    LineSettings line = m_controller.options().line;
    if (m_controller.options().port.startsWith("tcp:"_L1)) {
        return line; // a serial server's: nothing here can follow it
    }
    if (const auto raw = m_settings.parameter(parameterRow("uart-settings").number)) {
        if (const auto uart = UartSettings::fromRaw(*raw)) {
            line.baud = kBaudRates.at(static_cast<std::size_t>(uart->baudIndex));
            line.errorDetection = uart->errorDetection;
            line.stopBits = uart->stopBits;
        }
    }
    if (const auto raw = m_settings.parameter(parameterRow("crc7-polynomial").number);
        raw && line.hasCrc()) {
        line.polynomial = static_cast<std::uint8_t>(0x80 | *raw); // top bit always 1 (facts.md 2)
    }
    if (const auto raw = m_settings.parameter(parameterRow("device-number").number)) {
        line.device = static_cast<std::uint8_t>(*raw);
    }
    return line;
}

/// Only a value that changed in this connection counts: what a controller stores is read by
/// inferred rules (facts.md 2.3), and one that has always been so is no change.
void LineChange::onSettings(int number)
{
    const bool isLine = number == parameterRow("uart-settings").number
        || number == parameterRow("crc7-polynomial").number;
    if (!isLine || m_controller.state() != LinkState::Connected || isBusy() || m_isChecking) {
        return;
    }
    const auto key = static_cast<std::uint8_t>(number);
    const int raw = m_settings.parameter(key).value_or(-1);
    const auto [first, isNew] = m_first.try_emplace(key, raw);
    if (isNew || (first->second == raw && m_phase == Phase::None)) {
        return;
    }
    // A damaged byte would be a change too: it counts when it is read again.
    m_isChecking = true;
    m_settings.readSurely(*findParameter(number), raw, this, [this](const Result<int>& read) {
        m_isChecking = false;
        if (read) {
            notice();
        }
    });
}

void LineChange::notice()
{
    if (m_controller.state() != LinkState::Connected || isBusy()) {
        return;
    }
    const LineSettings stored = storedLine();
    const LineSettings& now = m_controller.options().line;
    if (isSameLine(stored, now) && stored.stopBits == now.stopBits) {
        if (m_phase == Phase::Waiting) {
            end(0, {}); // taken back
        }
        return;
    }
    if (m_phase == Phase::Waiting && stored == m_wanted) {
        return;
    }
    m_port = m_controller.options().port;
    m_old = now;
    m_wanted = stored;
    if (m_controller.isArmed()) {
        m_controller.disarm(); // what follows loses the line
    }
    enter(Phase::Waiting,
          tr("Waiting for the power cycle: switch the controller off and on. From then on it "
             "answers with %1; the connection follows by itself.")
              .arg(lineText(m_wanted)));
}

void LineChange::onState(LinkState state)
{
    if (state != LinkState::Connected) {
        m_first.clear();
        m_isChecking = false;
    }
    if (m_phase == Phase::None) {
        if (state == LinkState::Connecting || state == LinkState::Disconnected) {
            cancel(); // how the last change ended is of the past
        }
        return;
    }
    if (state == LinkState::Connected && m_isOpening) {
        m_isOpening = false;
        onConnected();
    } else if (state == LinkState::Lost && m_phase == Phase::Waiting) {
        begin();
    } else if (state == LinkState::Connecting && !m_isOpening) {
        cancel(); // somebody else connects
    } else if (state == LinkState::Disconnected && m_phase == Phase::Waiting && !m_isClosing) {
        end(0,
            tr("The line settings change at the next power cycle, to %1.").arg(lineText(m_wanted)));
    }
}

void LineChange::begin()
{
    m_patience.start(m_times.patience);
    m_triedOld = false;
    enter(Phase::Reconnecting,
          tr("The controller is silent. Looking for it with %1…").arg(lineText(m_wanted)));
    if (isSimulator()) {
        trySimulator(m_wanted); // it lives in this very connection
        return;
    }
    if (m_controller.state() == LinkState::Disconnected) {
        attempt();
        return;
    }
    m_isClosing = true;
    m_controller.closeQuietly(); // the settings are in doubt: say nothing more with these
}

void LineChange::trySimulator(const LineSettings& line)
{
    openLine(line);
    QTimer::singleShot(m_times.simulator, this, [this] {
        if (m_phase != Phase::Reconnecting || m_controller.state() == LinkState::Connected) {
            return;
        }
        if (std::exchange(m_triedOld, true)) {
            end(2, tr("The controller answers neither with the new settings nor with the old."));
        } else {
            trySimulator(m_old);
        }
    });
}

void LineChange::attempt()
{
    if (m_phase != Phase::Reconnecting || m_scan != nullptr) {
        return;
    }
    if (isSimulator()) {
        trySimulator(m_wanted);
        return;
    }
    // The old first: while they still answer, nothing is sent with the new.
    std::vector<LineSettings> only{m_old, m_wanted};
    if (isSameLine(m_old, m_wanted)) {
        only.erase(only.begin());
    }
    startScan({.port = m_port, .line = m_wanted, .only = only}, &LineChange::onAttempt);
}

void LineChange::startScan(const ScanOptions& options,
                           void (LineChange::*ended)(const Result<void>&))
{
    m_scan = new Scan(options, this);
    connect(m_scan, &Scan::finished, this, ended);
    if (m_phase == Phase::Recovering) {
        connect(m_scan, &Scan::progressed, this, [this](int done, int total, const QString& text) {
            enter(m_phase, tr("Searching: %1 (%2 of %3).").arg(text).arg(done + 1).arg(total));
        });
    }
    m_scan->start();
}

void LineChange::dropScan()
{
    if (Scan* scan = std::exchange(m_scan, nullptr)) {
        disconnect(scan, nullptr, this, nullptr);
        connect(scan, &Scan::finished, scan, &QObject::deleteLater);
        scan->cancel();
    }
}

void LineChange::onAttempt(const Result<void>& result)
{
    const auto hits = m_scan->hits();
    std::exchange(m_scan, nullptr)->deleteLater(); // it is the sender
    if (m_phase != Phase::Reconnecting) {
        return;
    }
    if (!hits.empty()) {
        const LineSettings line = hits.front().line(m_wanted);
        openLine(isSameLine(line, m_old) && !isSameLine(m_old, m_wanted) ? m_old : m_wanted);
    } else if (!m_patience.isActive()) {
        recover();
    } else {
        m_next.start(m_times.pause);
    }
    Q_UNUSED(result)
}

void LineChange::recover()
{
    enter(Phase::Recovering,
          tr("The controller answers neither with %1 nor with %2. Searching for it…")
              .arg(lineText(m_wanted), lineText(m_old)));
    startScan({.port = m_port, .line = m_wanted, .remembered = {m_wanted, m_old}},
              &LineChange::onRecovered);
}

void LineChange::onRecovered(const Result<void>& result)
{
    const auto hits = m_scan->hits();
    const QString advice =
        (wiringAdvice(m_scan->heard()) + u' ' + leftOutText(m_scan->leftOut())).trimmed();
    std::exchange(m_scan, nullptr)->deleteLater(); // it is the sender
    if (m_phase != Phase::Recovering) {
        return;
    }
    if (!hits.empty()) {
        openLine(hits.front().line(m_wanted));
    } else if (!result && result.error().code != ErrorCode::NoReply) {
        end(2, errorText(result.error()));
    } else {
        end(2,
            tr("No controller was found after the change of its line settings. %1 %2")
                .arg(advice, vendorResetText()));
    }
}

void LineChange::openLine(const LineSettings& line)
{
    m_isOpening = true;
    m_controller.open({.port = m_port, .line = line});
}

void LineChange::onConnected()
{
    m_next.stop();
    const LineSettings& line = m_controller.options().line;
    const QString answers = tr("The controller answers with %1.").arg(lineText(line));
    if (isSameLine(line, m_old) && !isSameLine(m_old, m_wanted)) {
        enter(Phase::Waiting,
              tr("The controller still answers with the old settings, %1. Switch it off and on; "
                 "from then on it answers with %2.")
                  .arg(lineText(m_old), lineText(m_wanted)));
        return;
    }
    m_controller.noteRestart(tr("its new line settings are in force"));
    if (isSameLine(line, m_wanted)) {
        end(0, answers);
    } else {
        end(1, tr("%1 It was asked to use %2.").arg(answers, lineText(m_wanted)));
    }
}

void LineChange::reconnectNow()
{
    if (m_phase == Phase::Waiting) {
        begin();
    }
}

void LineChange::recoverNow()
{
    if (m_phase != Phase::Waiting && m_phase != Phase::Reconnecting) {
        return;
    }
    dropScan();
    m_next.stop();
    m_phase = Phase::Recovering;
    m_isClosing = false;
    if (m_controller.state() == LinkState::Disconnected) {
        recover();
    } else {
        m_isOpening = false;
        m_controller.closeQuietly();
    }
}

void LineChange::cancel()
{
    if (m_phase != Phase::None || !m_text.isEmpty()) {
        end(0, {});
    }
}

void LineChange::enter(Phase phase, const QString& text)
{
    const bool isNew = phase != m_phase;
    m_phase = phase;
    m_text = text;
    if (isNew) {
        emit said(0, text);
    }
    emit changed();
}

void LineChange::end(int severity, const QString& text)
{
    dropScan();
    m_next.stop();
    m_patience.stop();
    m_isOpening = false;
    m_isClosing = false;
    m_phase = Phase::None;
    m_text = text;
    if (!text.isEmpty()) {
        emit said(severity, text);
    }
    emit changed();
}

} // namespace trex
