// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/parameters/parameterspanel.h"

#include "protocol/codec/replies.h"
#include "protocol/errortext.h"
#include "protocol/session/controller.h"
#include "widgets/common/eventlog.h"
#include "widgets/common/theme.h"
#include "widgets/parameters/parameterhelp.h"
#include "widgets/parameters/parametertable.h"
#include "widgets/parameters/restartline.h"

#include <QBoxLayout>
#include <QCoreApplication>
#include <QEvent>
#include <QLabel>
#include <QProgressBar>
#include <QPushButton>
#include <QResizeEvent>
#include <QScrollArea>
#include <QSplitter>

using namespace Qt::Literals::StringLiterals;

namespace trex {
namespace {

constexpr int kWideEnough = 1150; ///< pixels: the help stands beside the table, else below
constexpr double kModeHertz = 1.0; ///< the mode only changes with the controller's power

} // namespace

ParametersPanel::ParametersPanel(PanelContext& context, QWidget* parent)
    : Panel(context, parent), m_transfer(context.controller, context.deviceSettings)
{
    auto* const layout = new QVBoxLayout(this);
    layout->setContentsMargins(8, 8, 8, 8);
    layout->setSpacing(8);
    buildTools();
    buildTable();
    buildFooter();
    connectContext();
    takeDraft();
    onForgotten();
    onStateChanged(context.controller.state());
}

ParametersPanel::~ParametersPanel()
{
    context().controller.wantNothing(this);
}

void ParametersPanel::connectContext()
{
    auto& controller = context().controller;
    auto& settings = context().deviceSettings;
    connect(&controller, &Controller::stateChanged, this, &ParametersPanel::onStateChanged);
    connect(&controller, &Controller::deviceChanged, this, &ParametersPanel::refresh);
    connect(&settings, &DeviceSettings::parameterChanged, this, &ParametersPanel::onDeviceValue);
    connect(&settings, &DeviceSettings::forgotten, this, &ParametersPanel::onForgotten);
    connect(&controller, &Controller::restarted, this, &ParametersPanel::onRestarted);
    connect(&m_transfer, &ConfigTransfer::progressed, this, [this](int done, int total) {
        m_progress->setRange(0, std::max(total, 1));
        m_progress->setValue(done);
    });
    connect(&m_transfer, &ConfigTransfer::readFinished, this, &ParametersPanel::onRead);
    connect(&m_transfer, &ConfigTransfer::finished, this, &ParametersPanel::onFinished);
}

void ParametersPanel::onStateChanged(LinkState state)
{
    const bool wasLost =
        std::exchange(m_isLost, state == LinkState::Lost || state == LinkState::Retrying);
    m_isBack = wasLost && state == LinkState::Connected;
    if (m_isBack) { // whether it was restarted is told before anything else happens
        QMetaObject::invokeMethod(
            this, [this] { m_isBack = false; }, Qt::QueuedConnection);
    }
    if (state == LinkState::Connected) {
        readAll();
    } else if (state == LinkState::Disconnected) {
        m_restart->dismiss(); // it was about another connection
        m_isBackedUp = false; // the next connection may be to another controller
        m_mayGoWithoutBackup = false;
        offerToPutBack({});
        m_isInDoubt = false;
    }
    refresh();
}

void ParametersPanel::onForgotten()
{
    if (!m_model.pending().empty()) { // a lost line and then the restart: all is forgotten twice
        m_waited.clear();
    }
    for (const auto number : m_model.pending()) {
        m_waited << QCoreApplication::translate("Parameters", findParameter(int{number})->title);
    }
    for (const auto& row : kParameters) {
        if (!row.isTrigger) {
            onDeviceValue(row.number);
        }
    }
    refresh();
    if (context().controller.state() == LinkState::Connected && !m_isWriting) {
        readAll();
    }
}

/// All is forgotten, and asked for, already.
void ParametersPanel::onRestarted()
{
    m_restart->tell(m_isBack ? RestartLine::Kind::Perhaps : RestartLine::Kind::Sure,
                    QTime::currentTime(), std::exchange(m_waited, {}));
    if (const QString after = m_afterPowerCycle; !after.isEmpty()) {
        if (m_message->text() != after) {
            tell(EventLog::Information, after);
            m_afterPowerCycle = after; // a restart may be told twice
        }
    } else if (!m_isWriting && m_severity == EventLog::Information) {
        m_message->hide(); // it may ask for the power cycle that has been
    }
}

void ParametersPanel::onDeviceValue(int number)
{
    const auto& settings = context().deviceSettings;
    const auto which = static_cast<std::uint8_t>(number);
    m_model.setDevice(which, settings.parameter(which));
    for (const auto& row : kParameters) {
        m_model.setPending(row.number, settings.isPending(row.number));
    }
}

void ParametersPanel::readAll()
{
    if (m_transfer.isBusy()) {
        m_readsAgain = true;
        return;
    }
    m_readsAgain = false;
    m_transfer.read();
    refresh();
}

void ParametersPanel::onRead(const Result<Configuration>& read)
{
    const auto then = std::exchange(m_afterRead, {});
    if (m_readsAgain && context().controller.state() == LinkState::Connected) {
        m_afterRead = then;
        readAll();
        return;
    }
    if (read) {
        m_waited.clear(); // what is pending now, the table says
    }
    m_restart->setReading(read ? RestartLine::Reading::Done : RestartLine::Reading::Failed);
    if (!read && !isLoss(read.error().code)) { // a loss is the connection's state, told there
        tell(EventLog::Failure, errorText(read.error()));
    } else if (read && std::exchange(m_isInDoubt, false)) {
        m_isWriting = true; // nothing may change meanwhile
        m_transfer.examine();
    } else if (read && then) {
        then();
    }
    refresh();
}

void ParametersPanel::tell(int severity, const QString& sentence)
{
    m_message->setText(severity == EventLog::Information ? sentence : u"▲ "_s + sentence);
    m_message->setVisible(!sentence.isEmpty());
    m_severity = severity;
    m_afterPowerCycle.clear();
    colourMessage();
    if (!sentence.isEmpty()) {
        context().log.add(severity, sentence);
    }
}

void ParametersPanel::colourMessage()
{
    colourText(m_message,
               m_severity == EventLog::Failure       ? ColourRole::Fault
                   : m_severity == EventLog::Warning ? ColourRole::Warning
                                                     : ColourRole::Text);
}

void ParametersPanel::colourText(QLabel* label, ColourRole role)
{
    theme::setTextColour(*label, role);
}

void ParametersPanel::fitPending()
{
    // As high as its text, within bounds that leave the table its room; longer text scrolls.
    const int line = m_pending->fontMetrics().lineSpacing();
    const int most = std::clamp(height() / 6 / line, 3, 8);
    const int wanted = m_pending->heightForWidth(m_pendingArea->viewport()->width());
    m_pendingArea->setFixedHeight(std::clamp(wanted, line, most * line));
}

void ParametersPanel::refreshHelp()
{
    const auto* const row = m_table->currentRow();
    m_help->setText(row == nullptr ? QString() : parameterHelp(m_model, *row));
}

void ParametersPanel::showEvent(QShowEvent* event)
{
    context().controller.want(this, PollId::Mode, kModeHertz);
    Panel::showEvent(event);
}

void ParametersPanel::hideEvent(QHideEvent* event)
{
    context().controller.wantNothing(this);
    Panel::hideEvent(event);
}

void ParametersPanel::resizeEvent(QResizeEvent* event)
{
    const bool isWide = event->size().width() >= kWideEnough;
    m_splitter->setOrientation(isWide ? Qt::Horizontal : Qt::Vertical);
    const int room = isWide ? m_splitter->width() : m_splitter->height();
    constexpr int kHelpLines = 5;
    const int lines = kHelpLines * m_help->fontMetrics().lineSpacing()
        + m_help->contentsMargins().top() + m_help->contentsMargins().bottom();
    const int help = isWide ? 260 : std::clamp(room / 3, 66, lines);
    m_splitter->setSizes({std::max(room - help, 1), help});
    fitPending();
    Panel::resizeEvent(event);
}

void ParametersPanel::changeEvent(QEvent* event)
{
    Panel::changeEvent(event);
    if (event->type() == QEvent::PaletteChange) {
        m_table->usePalette();
        colourMessage();
        m_model.refreshAll();
        refresh();
        refreshHelp();
    }
}

} // namespace trex
