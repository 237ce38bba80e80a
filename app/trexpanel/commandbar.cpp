// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/trexpanel/commandbar.h"

#include "protocol/errortext.h"
#include "protocol/session/controller.h"
#include "protocol/storage/linesettingsstore.h"
#include "widgets/common/eventlog.h"
#include "widgets/common/stopbutton.h"
#include "widgets/common/theme.h"
#include "widgets/common/uisettings.h"

#include <QAction>
#include <QHBoxLayout>
#include <QLabel>
#include <QToolButton>

namespace trex {

using namespace Qt::Literals::StringLiterals;

namespace {

constexpr int kGapBeforeStop = 24; ///< a hand that misses Arm does not hit STOP, nor the reverse
constexpr int kButtonIcon = 20;

QString modeText(Mode mode)
{
    switch (mode) {
    case Mode::Rc:
        return CommandBar::tr("RC mode");
    case Mode::Analog:
        return CommandBar::tr("analog mode");
    case Mode::SerialRc:
        return CommandBar::tr("serial mode (RC inputs)");
    case Mode::SerialAnalog:
        return CommandBar::tr("serial mode (analog inputs)");
    }
    return {};
}

/// "ttyUSB0" of "/dev/ttyUSB0"; the simulator by its name.
QString portText(const QString& port)
{
    if (port.startsWith("sim:"_L1)) {
        return CommandBar::tr("simulated controller");
    }
    return port.contains("://"_L1) ? port : port.section(u'/', -1);
}

QToolButton* buttonFor(QAction* action, const QString& name, QWidget* parent)
{
    auto* button = named(new QToolButton(parent), name);
    button->setDefaultAction(action);
    button->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
    button->setIconSize({kButtonIcon, kButtonIcon});
    button->setFocusPolicy(Qt::TabFocus);
    return button;
}

/// As wide as its longest text, so that nothing beside it moves.
void reserveWidth(QToolButton* button, const QStringList& texts)
{
    int width = 0;
    for (const QString& text : texts) {
        width = std::max(width, button->fontMetrics().horizontalAdvance(text));
    }
    button->setMinimumWidth(width + kButtonIcon + 28);
}

} // namespace

CommandBar::CommandBar(PanelContext& context, QWidget* parent) : QWidget(parent), m_context(context)
{
    makeActions();
    makeRow();
    m_lockout.setSingleShot(true);
    m_lockout.setTimerType(Qt::PreciseTimer); // a coarse one may end before the lockout does
    Controller& controller = context.controller;
    connect(&m_lockout, &QTimer::timeout, this, &CommandBar::refresh);
    connect(&controller, &Controller::lockedOut, this, [this] {
        m_lockout.start(Controller::kStopLockout);
        refresh();
    });
    connect(&controller, &Controller::stateChanged, this, &CommandBar::refresh);
    connect(&controller, &Controller::armedChanged, this, &CommandBar::refresh);
    connect(&controller, &Controller::deviceChanged, this, &CommandBar::refreshIdentity);
    refresh();
}

void CommandBar::makeActions()
{
    const auto make = [this](const QString& text, const QString& icon, const QString& name) {
        QAction* action = new QAction(theme::icon(icon), text, this);
        action->setObjectName(name);
        return action;
    };
    m_connect = make(tr("Connect"), u"connect"_s, u"action.connect"_s);
    m_connect->setToolTip(tr("Connects to the port used last."));
    m_disconnect = make(tr("Disconnect"), u"disconnect"_s, u"action.disconnect"_s);
    m_disconnect->setToolTip(tr("Stops all motors and closes the line."));
    m_arm = make(tr("Arm"), u"arm"_s, u"action.arm"_s);
    m_arm->setCheckable(true);
    m_stop = make(tr("Stop all motors"), u"stop"_s, u"action.stop"_s);
    // Shown in the menu only: the key itself is taken from every window by the main window.
    m_stop->setText(tr("Stop all motors\tEsc"));
    connect(m_connect, &QAction::triggered, this, &CommandBar::connectToLast);
    connect(m_disconnect, &QAction::triggered, &m_context.controller, &Controller::close);
    connect(m_arm, &QAction::triggered, this, &CommandBar::onArmTriggered);
    connect(m_stop, &QAction::triggered, &m_context.controller,
            [&controller = m_context.controller] { controller.stop(); });
}

void CommandBar::makeRow()
{
    QToolButton* connectButton = buttonFor(m_connect, u"mainWindow.connect"_s, this);
    QToolButton* disconnectButton = buttonFor(m_disconnect, u"mainWindow.disconnect"_s, this);
    QToolButton* armButton = buttonFor(m_arm, u"mainWindow.arm"_s, this);
    for (QToolButton* button : {connectButton, disconnectButton}) {
        reserveWidth(button, {tr("Connect"), tr("Disconnect")});
    }
    reserveWidth(armButton, {tr("Arm"), tr("Disarm")});
    m_connectButton = connectButton;
    m_disconnectButton = disconnectButton;
    m_identity = named(new QLabel(this), u"mainWindow.identity"_s, tr("What is connected"));
    m_identity->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Preferred);
    m_identity->setTextFormat(Qt::PlainText);
    m_identity->setFont(theme::font(1.25));
    auto* stop = named(new StopButton(m_context.controller, this), u"mainWindow.stop"_s,
                       tr("Stop all motors"));

    m_row = new QHBoxLayout(this);
    m_row->setContentsMargins(8, 4, 8, 4);
    m_row->setSpacing(8);
    m_row->addWidget(connectButton);
    m_row->addWidget(disconnectButton);
    m_row->addSpacing(8);
    m_row->addWidget(m_identity, 1);
    m_row->addWidget(armButton);
    m_row->addSpacing(kGapBeforeStop - 8);
    m_row->addWidget(stop);
}

void CommandBar::addAction(QAction* action)
{
    const QString part = action->objectName().section(u'.', -1);
    QToolButton* button = buttonFor(action, u"mainWindow."_s + part, this);
    m_row->insertWidget(m_row->indexOf(m_identity) + 1, button);
}

QList<QAction*> CommandBar::actionsForMenu() const
{
    return {m_connect, m_disconnect, m_arm, m_stop};
}

void CommandBar::connectToLast()
{
    OpenOptions options = m_context.controller.options();
    if (options.port.isEmpty()) {
        const LineSettingsStore store(m_context.settings.file());
        options.port = store.lastPort();
        const auto line = store.lastGood(options.port);
        if (!line) {
            emit connectionWanted();
            return;
        }
        options.line = *line;
    }
    m_context.controller.open(options);
}

void CommandBar::onArmTriggered(bool armed)
{
    if (!armed) {
        m_context.controller.disarm();
    } else if (const Result<void> result = m_context.controller.arm(); !result) {
        m_context.log.add(EventLog::Warning, errorText(result.error()));
    }
    refresh();
}

void CommandBar::refresh()
{
    const LinkState state = m_context.controller.state();
    const bool isArmed = m_context.controller.isArmed();
    const bool isOff = state == LinkState::Disconnected;
    m_connect->setEnabled(isOff);
    m_disconnect->setEnabled(!isOff);
    m_connectButton->setVisible(isOff);
    m_disconnectButton->setVisible(!isOff);
    m_arm->setEnabled(state == LinkState::Connected && !m_lockout.isActive());
    m_arm->setChecked(isArmed);
    m_arm->setText(isArmed ? tr("Disarm") : tr("Arm"));
    m_arm->setIcon(isArmed ? theme::icon(u"disarm"_s, ColourRole::Warning) : theme::icon(u"arm"_s));
    m_arm->setToolTip(isArmed ? tr("Stops all motors and takes no more orders for them.")
                              : tr("Lets the sliders drive the motors."));
    refreshIdentity();
}

void CommandBar::refreshIdentity()
{
    const Controller& controller = m_context.controller;
    QStringList parts;
    if (controller.state() != LinkState::Disconnected) {
        parts << portText(controller.options().port)
              << QString::number(controller.options().line.baud);
        if (const auto& signature = controller.device().signature) {
            parts << u"%1 %2"_s.arg(signature->modelName(), signature->firmware());
        }
        if (const auto& mode = controller.device().mode) {
            parts << modeText(*mode);
        }
    } else {
        parts << tr("No controller connected");
    }
    m_identity->setText(parts.join(u" · "_s));
    m_identity->setToolTip(m_identity->text());
}

} // namespace trex
