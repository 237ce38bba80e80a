// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/connection/connectionpanel.h"

#include "protocol/errortext.h"
#include "protocol/procedures/linetext.h"
#include "protocol/session/controller.h"
#include "protocol/storage/linesettingsstore.h"
#include "protocol/telemetry/statuslatch.h"
#include "widgets/common/eventlog.h"
#include "widgets/common/theme.h"
#include "widgets/common/uisettings.h"
#include "widgets/connection/linechangebox.h"
#include "widgets/connection/lineform.h"
#include "widgets/connection/linkstatelabel.h"
#include "widgets/connection/portbox.h"

#include <QGridLayout>
#include <QLabel>
#include <QPushButton>
#include <QScrollArea>
#include <QVBoxLayout>

namespace trex {

using namespace Qt::Literals::StringLiterals;

namespace {

constexpr QLatin1StringView kNetwork = "tcp://"_L1;

bool isSimulator(const QString& address)
{
    return address.startsWith("sim:"_L1);
}

} // namespace

ConnectionPanel::ConnectionPanel(PanelContext& context, QWidget* parent)
    : Panel(context, parent), m_change(context.controller, context.deviceSettings)
{
    auto* scroll = new QScrollArea(this);
    scroll->setFrameShape(QFrame::NoFrame);
    scroll->setWidgetResizable(true);
    scroll->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    auto* page = new QWidget(scroll);
    auto* layout = new QVBoxLayout(page);
    layout->setContentsMargins(8, 8, 8, 8);
    layout->setSpacing(8);
    m_state = named(new LinkStateLabel(page), u"connection.state"_s, tr("State of the link"));
    layout->addWidget(m_state);
    buildFields(*layout);
    buildButtons(*layout);
    m_advice = named(new QLabel(page), u"connection.advice"_s, tr("What to do next"));
    m_advice->setWordWrap(true);
    m_advice->setTextFormat(Qt::PlainText);
    m_advice->setTextInteractionFlags(Qt::TextSelectableByMouse | Qt::TextSelectableByKeyboard);
    layout->addWidget(new LineChangeBox(m_change, *this, page));
    layout->addWidget(m_advice);
    layout->addWidget(m_line);
    layout->addStretch(1);
    scroll->setWidget(page);
    scroll->setMinimumWidth(page->minimumSizeHint().width());
    auto* outer = new QVBoxLayout(this);
    outer->setContentsMargins(0, 0, 0, 0);
    outer->addWidget(scroll);

    setInitialValues();
    connect(&context.controller, &Controller::stateChanged, this, &ConnectionPanel::onStateChanged);
    connect(&context.controller, &Controller::deviceChanged, this, &ConnectionPanel::refresh);
    connect(&m_change, &LineChange::changed, this, &ConnectionPanel::refresh);
    connect(&m_change, &LineChange::said, &context.log, &EventLog::add);
    connect(m_port, &PortBox::portsChanged, this, &ConnectionPanel::refresh);
    connect(m_port, &PortBox::addressEdited, this, [this](const QString& address) {
        m_notice.clear();
        fillFrom(address);
        refresh();
    });
    refresh();
}

void ConnectionPanel::buildFields(QVBoxLayout& layout)
{
    m_port = named(new PortBox(this), u"connection.port"_s, tr("Port"));
    m_port->setToolTip(tr("A serial port, tcp://HOST:PORT of a serial server, or the simulator."));
    auto* title = new QLabel(tr("Po&rt"), this);
    title->setBuddy(m_port);
    auto* row = new QHBoxLayout;
    row->setSpacing(8);
    row->addWidget(title);
    row->addWidget(m_port, 1);
    layout.addLayout(row);
    m_line = new LineForm(this);
}

QPushButton* ConnectionPanel::addButton(const QString& icon, const QString& text,
                                        const QString& name)
{
    auto* button = named(new QPushButton(theme::icon(icon), text, this), name);
    button->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
    return button;
}

void ConnectionPanel::buildButtons(QVBoxLayout& layout)
{
    m_connect = addButton(u"connect"_s, tr("&Connect"), u"connection.connect"_s);
    m_disconnect = addButton(u"disconnect"_s, tr("&Disconnect"), u"connection.disconnect"_s);
    m_scanButton = addButton(u"scan"_s, tr("&Scan"), u"connection.scan"_s);
    m_recover = addButton(u"search"_s, tr("&Recover"), u"connection.recover"_s);
    m_powerCycle = addButton(u"refresh"_s, tr("Power c&ycle"), u"connection.powerCycle"_s);
    m_disconnect->setToolTip(tr("Stops all three motors, then closes the port."));
    m_scanButton->setToolTip(tr("Tries every baud rate and error detection on this port, the most "
                                "likely first, until a controller answers."));
    m_recover->setToolTip(
        tr("Finds a lost controller: tries the settings that worked last, then every other, and "
           "connects with those that answer. The questions are chosen so that no controller at "
           "another speed takes one for a motor order, as far as its receiver works as its data "
           "sheet says; to be quite sure, switch the motor power off first."));
    m_powerCycle->setToolTip(tr("Switches the simulated controller off and on again."));
    connect(m_connect, &QPushButton::clicked, this, &ConnectionPanel::openLine);
    connect(m_disconnect, &QPushButton::clicked, &context().controller, &Controller::close);
    connect(m_scanButton, &QPushButton::clicked, this, &ConnectionPanel::toggleScan);
    connect(m_recover, &QPushButton::clicked, this, &ConnectionPanel::toggleRecover);
    connect(m_powerCycle, &QPushButton::clicked, &context().controller,
            &Controller::powerCycleSimulator);
    auto* grid = new QGridLayout;
    grid->setSpacing(8);
    grid->addWidget(m_connect, 0, 0);
    grid->addWidget(m_disconnect, 0, 1);
    grid->addWidget(m_scanButton, 1, 0);
    grid->addWidget(m_recover, 1, 1);
    grid->addWidget(m_powerCycle, 2, 0);
    grid->setColumnStretch(0, 1);
    grid->setColumnStretch(1, 1);
    layout.addLayout(grid);
}

void ConnectionPanel::setInitialValues()
{
    const LineSettingsStore store(context().settings.file());
    const QString last = store.lastPort();
    if (last.startsWith(kNetwork)) {
        m_port->setNetworkAddress(last);
    }
    m_port->refresh();
    const OpenOptions& open = context().controller.options();
    if (!open.port.isEmpty()) {
        m_port->setAddress(open.port);
        m_line->setSettings(open.line);
        return;
    }
    // "sim:" is what the store says when nothing was used yet: then an adapter that is plugged in
    // is what the person came for.
    const bool isFirst = last == "sim:"_L1;
    const QString adapter = m_port->firstAdapter();
    m_port->setAddress(!isFirst ? last : adapter.isEmpty() ? simulatorAddress() : adapter);
    fillFrom(m_port->address());
}

void ConnectionPanel::fillFrom(const QString& port)
{
    const LineSettingsStore store(context().settings.file());
    if (const auto line = store.lastGood(port)) {
        m_line->setSettings(*line);
    }
}

bool ConnectionPanel::checkPort()
{
    const Result<void> checked = checkAddress(m_port->address());
    m_notice = checked ? QString() : errorText(checked.error());
    refresh();
    return checked.has_value();
}

void ConnectionPanel::openLine()
{
    if (checkPort()) {
        context().controller.open({.port = m_port->address(), .line = m_line->settings()});
    }
}

void ConnectionPanel::toggleScan()
{
    if (isScanning()) {
        m_scan->cancel();
    } else if (checkPort()) {
        m_isRecovering = false;
        startScan();
    }
}

void ConnectionPanel::toggleRecover()
{
    if (isScanning()) {
        m_scan->cancel();
        return;
    }
    if (!checkPort()) {
        return;
    }
    m_isRecovering = true;
    Controller& controller = context().controller;
    if (controller.state() == LinkState::Disconnected) {
        startScan();
        return;
    }
    connect(&controller, &Controller::closed, this, &ConnectionPanel::startScan,
            Qt::SingleShotConnection);
    controller.closeQuietly(); // its settings are in doubt: nothing more is said with them
}

void ConnectionPanel::startScan()
{
    m_change.cancel();
    const LineSettingsStore store(context().settings.file());
    std::vector<LineSettings> remembered;
    if (const auto line = store.lastGood(m_port->address())) {
        remembered.push_back(*line);
    }
    m_scan = new Scan(
        {.port = m_port->address(), .line = m_line->settings(), .remembered = remembered}, this);
    connect(m_scan, &Scan::progressed, this, &ConnectionPanel::showScan);
    connect(m_scan, &Scan::finished, this, &ConnectionPanel::onScanFinished);
    m_scan->start();
    refresh();
}

void ConnectionPanel::showScan(int done, int total, const QString& text)
{
    const auto seconds =
        std::chrono::ceil<std::chrono::seconds>(m_scan->estimatedRemaining()).count();
    m_notice = seconds > 0
        ? tr("%1 (%2 of %3, at most about %4 s more).")
              .arg(text, QString::number(done + 1), QString::number(total),
                   QString::number(seconds))
        : tr("%1 (%2 of %3).").arg(text, QString::number(done + 1), QString::number(total));
    refresh();
}

void ConnectionPanel::onScanFinished(const Result<void>& result)
{
    const std::vector<ScanHit> hits = m_scan->hits();
    const QString failure = failureText(result, *m_scan);
    m_scan->deleteLater(); // it is the sender
    m_scan = nullptr;
    const bool isFree = context().controller.state() == LinkState::Disconnected;
    if (!isFree) {
        m_notice.clear(); // the scan gave way to a connection
    } else if (!hits.empty()) {
        adopt(hits.front());
    } else {
        m_notice = failure;
    }
    refresh();
    if (!hits.empty() && isFree) {
        m_connect->setFocus();
    }
}

void ConnectionPanel::adopt(const ScanHit& hit)
{
    if (hit.status != 0) { // the probe has read and so cleared these bits: keep them
        context().latch.record(StatusLatch::Byte::Status, hit.status,
                               std::chrono::steady_clock::now());
    }
    const LineSettings line = hit.line(m_line->settings());
    m_line->setSettings(line);
    const QString text =
        tr("Found a %1, firmware %2, at %3, device number %4.")
            .arg(hit.signature.modelName(), hit.signature.firmware(), lineText(line))
            .arg(hit.device);
    context().log.add(EventLog::Information, text);
    if (m_isRecovering) {
        context().controller.open({.port = m_port->address(), .line = line});
    } else {
        m_notice = tr("%1 Press Connect.").arg(text);
    }
}

QString ConnectionPanel::failureText(const Result<void>& result, const Scan& scan) const
{
    if (!result && result.error().code == ErrorCode::Cancelled) {
        return tr("Scan cancelled. Nothing was found so far.");
    }
    if (!result && result.error().code != ErrorCode::NoReply) {
        return errorText(result.error());
    }
    QString text = tr("No controller answered on %1 at any speed. %2")
                       .arg(shortPortName(m_port->address()), wiringAdvice(scan.heard()));
    text = (text + u' ' + leftOutText(scan.leftOut())).trimmed();
    return m_isRecovering ? text + u"\n\n"_s + vendorResetText() : text;
}

void ConnectionPanel::onStateChanged()
{
    const Controller& controller = context().controller;
    if (controller.state() != LinkState::Disconnected) {
        if (isScanning()) {
            m_scan->cancel(); // somebody else wants the port
        }
        m_notice.clear();
        const OpenOptions& open = controller.options();
        if (open.port.startsWith(kNetwork)) {
            m_port->setNetworkAddress(open.port);
        }
        if (m_port->address() != open.port) {
            m_port->setAddress(open.port);
        }
        m_line->setSettings(open.line);
    }
    refresh();
}

void ConnectionPanel::refresh()
{
    const Controller& controller = context().controller;
    const bool isClosed = controller.state() == LinkState::Disconnected;
    m_state->setLink(controller.state(), stateText());
    m_port->setEnabled(isClosed && !isScanning());
    m_line->setEnabled(isClosed && !isScanning());
    m_connect->setEnabled(isClosed && !isScanning());
    m_disconnect->setEnabled(!isClosed);
    const bool isRecovering = isScanning() && m_isRecovering;
    m_scanButton->setEnabled(isClosed && !m_change.isBusy() && !isRecovering);
    m_scanButton->setText(isScanning() && !isRecovering ? tr("Cancel &scan") : tr("&Scan"));
    m_recover->setEnabled(controller.state() != LinkState::Connected && !m_change.isBusy()
                          && (!isScanning() || isRecovering));
    m_recover->setText(isRecovering ? tr("Cancel sea&rch") : tr("&Recover"));
    m_powerCycle->setVisible(!isClosed && isSimulator(controller.options().port));
    const QString advice = adviceText();
    m_advice->setText(advice);
    m_advice->setVisible(!advice.isEmpty());
}

/// Begins with the state's own word, as scripts and people know it.
QString ConnectionPanel::stateText() const
{
    const Controller& controller = context().controller;
    const QString port = shortPortName(controller.options().port);
    switch (controller.state()) {
    case LinkState::Disconnected:
        return tr("disconnected");
    case LinkState::Connecting:
        return tr("connecting to %1, %2").arg(port, lineText(controller.options().line));
    case LinkState::Connected: {
        const auto& signature = controller.device().signature;
        return signature ? tr("connected to a %1, firmware %2, on %3")
                               .arg(signature->modelName(), signature->firmware(), port)
                         : tr("connected to %1").arg(port);
    }
    case LinkState::Lost:
        return tr("lost: values are no longer live");
    case LinkState::Retrying:
        return tr("retrying %1").arg(port);
    }
    return {};
}

QString ConnectionPanel::adviceText() const
{
    const Controller& controller = context().controller;
    if (!m_notice.isEmpty()) {
        return m_notice;
    }
    if (const auto error = controller.lastError();
        error && controller.state() != LinkState::Connected) {
        const QString tip = tipFor(*error);
        return tip.isEmpty() ? errorText(*error) : errorText(*error) + u' ' + tip;
    }
    const QString address = m_port->address();
    if (controller.state() == LinkState::Disconnected && !m_port->hasSerialPort()
        && (address.isEmpty() || isSimulator(address))) {
        return tr("No port found. Plug in the adapter, or simulate.");
    }
    return {};
}

/// What this panel knows beyond the error's own advice.
QString ConnectionPanel::tipFor(const Error& error) const
{
    const Controller& controller = context().controller;
    const bool isTrying =
        controller.state() == LinkState::Lost || controller.state() == LinkState::Retrying;
    if (isTrying) {
        return tr("It is tried again by itself until you disconnect. Recover looks for it at every "
                  "speed.");
    }
    const bool isSilent = error.code == ErrorCode::NoReply || error.code == ErrorCode::Garbage
        || error.code == ErrorCode::ShortReply;
    if (isSilent && controller.options().port.startsWith(kNetwork)) {
        return tr("On a network port, speed and parity are those of the serial server.");
    }
    if (isSilent) {
        return tr("A controller fresh from the factory talks at 19200 baud without error "
                  "detection. Recover looks for it at every speed.");
    }
    return {};
}

} // namespace trex
