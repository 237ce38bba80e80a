// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/parameters/parameterspanel.h"

#include "protocol/codec/replies.h"
#include "protocol/errortext.h"
#include "protocol/session/controller.h"
#include "widgets/common/eventlog.h"
#include "widgets/common/theme.h"
#include "widgets/parameters/parameterhelp.h"
#include "widgets/parameters/parametertable.h"

#include <QBoxLayout>
#include <QEvent>
#include <QLabel>
#include <QLineEdit>
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

QPushButton* newButton(const QString& part, const QString& icon, const QString& text,
                       const QString& tip, QWidget* parent)
{
    auto* const button =
        named(new QPushButton(theme::icon(icon), text, parent), u"parameters."_s + part);
    button->setToolTip(tip);
    return button;
}

QLabel* newText(const QString& part, const QString& accessibleName, QWidget* parent)
{
    auto* const label = named(new QLabel(parent), u"parameters."_s + part, accessibleName);
    label->setWordWrap(true);
    label->setTextFormat(Qt::PlainText); // sentences hold text from files and controllers
    label->setTextInteractionFlags(Qt::TextSelectableByMouse);
    label->setAlignment(Qt::AlignLeft | Qt::AlignTop);
    return label;
}

QScrollArea* scrolled(QLabel* label, QWidget* parent)
{
    auto* const area = new QScrollArea(parent);
    area->setWidget(label);
    area->setWidgetResizable(true);
    area->setFrameShape(QFrame::NoFrame);
    area->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    area->setFocusPolicy(Qt::TabFocus); // so that long text can be scrolled from the keyboard
    return area;
}

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
    onForgotten();
    onStateChanged(context.controller.state());
}

ParametersPanel::~ParametersPanel()
{
    context().controller.wantNothing(this);
}

void ParametersPanel::buildTools()
{
    m_search = named(new QLineEdit(this), u"parameters.search"_s, tr("Search parameters"));
    m_search->setPlaceholderText(tr("Search name, key, number or help"));
    m_search->setClearButtonEnabled(true);
    m_search->addAction(theme::icon(u"search"_s), QLineEdit::LeadingPosition);
    m_reload = newButton(u"reload"_s, u"refresh"_s, tr("Re&load"),
                         tr("Read everything from the controller again; edits stay"), this);
    m_defaults =
        newButton(u"defaults"_s, u"defaults"_s, tr("&Defaults"),
                  tr("Fill in the factory defaults; nothing is written before Apply"), this);
    m_load = newButton(u"load"_s, u"load"_s, tr("Loa&d…"),
                       tr("Fill in the values of a file; nothing is written before Apply"), this);
    m_save = newButton(u"save"_s, u"save"_s, tr("&Save…"),
                       tr("Save what is in the controller to a file"), this);
    auto* const row = new QHBoxLayout;
    row->setSpacing(4);
    row->addWidget(m_search, 1);
    for (auto* const button : {m_reload, m_defaults, m_load, m_save}) {
        row->addWidget(button);
    }
    static_cast<QVBoxLayout*>(layout())->addLayout(row);
    m_banner = newText(u"banner"_s, tr("State of the parameters"), this);
    layout()->addWidget(m_banner);
    connect(m_reload, &QPushButton::clicked, this, &ParametersPanel::readAll);
    connect(m_defaults, &QPushButton::clicked, this, &ParametersPanel::fillDefaults);
    connect(m_load, &QPushButton::clicked, this, &ParametersPanel::load);
    connect(m_save, &QPushButton::clicked, this, &ParametersPanel::save);
}

void ParametersPanel::buildTable()
{
    m_splitter = new QSplitter(Qt::Vertical, this);
    m_splitter->setChildrenCollapsible(false);
    m_table =
        named(new ParameterTable(m_model, m_splitter), u"parameters.table"_s, tr("Parameters"));
    m_help = newText(u"help"_s, tr("Help on the parameter"), m_splitter);
    m_help->setTextFormat(Qt::RichText);
    m_help->setContentsMargins(8, 2, 8, 2);
    auto* const area = scrolled(m_help, m_splitter);
    area->setMinimumSize(200, 64);
    m_splitter->addWidget(m_table);
    m_splitter->addWidget(area);
    m_splitter->setStretchFactor(0, 1);
    m_splitter->setStretchFactor(1, 0);
    static_cast<QVBoxLayout*>(layout())->addWidget(m_splitter, 1);
    connect(m_search, &QLineEdit::textChanged, m_table, &ParameterTable::search);
    connect(m_table, &ParameterTable::rowChosen, this, &ParametersPanel::refreshHelp);
    connect(m_table, &ParameterTable::editRejected, this,
            [this](int /*number*/, const QString& sentence) { tell(EventLog::Warning, sentence); });
    connect(&m_model, &ParameterModel::shownChanged, this, [this](int number) {
        if (m_table->currentRow() != nullptr && m_table->currentRow()->number == number) {
            refreshHelp();
        }
    });
    connect(&m_model, &ParameterModel::editsChanged, this, &ParametersPanel::refresh);
    m_table->setCurrentIndex(m_model.indexOf(parameterRow("device-number").number));
}

void ParametersPanel::buildFooter()
{
    m_message = newText(u"message"_s, tr("What happened last"), this);
    m_pending = newText(u"pending"_s, tr("What will be written"), this);
    m_pendingArea = scrolled(m_pending, this);
    m_progress = named(new QProgressBar(this), u"parameters.progress"_s, tr("Progress"));
    m_progress->setFixedWidth(140);
    m_cancel = newButton(u"cancel"_s, u"cancel"_s, tr("Cancel"),
                         tr("Stop writing and put back what was written"), this);
    m_revert = newButton(u"revert"_s, u"revert"_s, tr("&Revert"), tr("Drop all edits"), this);
    m_apply = newButton(u"apply"_s, u"apply"_s, tr("&Apply"),
                        tr("Write what differs to the controller now and read it back"), this);
    auto* const row = new QHBoxLayout;
    row->setSpacing(8);
    row->addWidget(m_pendingArea, 1);
    for (QWidget* const widget :
         {static_cast<QWidget*>(m_progress), static_cast<QWidget*>(m_cancel),
          static_cast<QWidget*>(m_revert), static_cast<QWidget*>(m_apply)}) {
        row->addWidget(widget, 0, Qt::AlignBottom);
    }
    layout()->addWidget(m_message);
    static_cast<QVBoxLayout*>(layout())->addLayout(row);
    m_message->hide();
    m_progress->hide();
    m_cancel->hide();
    connect(m_cancel, &QPushButton::clicked, &m_transfer, &ConfigTransfer::cancel);
    connect(m_revert, &QPushButton::clicked, this, &ParametersPanel::revert);
    connect(m_apply, &QPushButton::clicked, this, &ParametersPanel::apply);
}

void ParametersPanel::connectContext()
{
    auto& controller = context().controller;
    auto& settings = context().deviceSettings;
    connect(&controller, &Controller::stateChanged, this, &ParametersPanel::onStateChanged);
    connect(&controller, &Controller::deviceChanged, this, &ParametersPanel::refresh);
    connect(&settings, &DeviceSettings::parameterChanged, this, &ParametersPanel::onDeviceValue);
    connect(&settings, &DeviceSettings::forgotten, this, &ParametersPanel::onForgotten);
    connect(&m_transfer, &ConfigTransfer::progressed, this, [this](int done, int total) {
        m_progress->setRange(0, std::max(total, 1));
        m_progress->setValue(done);
    });
    connect(&m_transfer, &ConfigTransfer::readFinished, this, &ParametersPanel::onRead);
    connect(&m_transfer, &ConfigTransfer::finished, this, &ParametersPanel::onFinished);
}

void ParametersPanel::onStateChanged(LinkState state)
{
    if (state == LinkState::Connected) {
        readAll();
    } else if (state == LinkState::Disconnected) {
        m_isBackedUp = false; // the next connection may be to another controller
        m_mayGoWithoutBackup = false;
    }
    refresh();
}

void ParametersPanel::onForgotten()
{
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
    const bool applies = std::exchange(m_appliesAfterRead, false);
    if (m_readsAgain && context().controller.state() == LinkState::Connected) {
        readAll();
        return;
    }
    if (!read && !isLoss(read.error().code)) { // a loss is the connection's state, told there
        tell(EventLog::Failure, errorText(read.error()));
    } else if (read && applies) {
        apply();
    }
    refresh();
}

void ParametersPanel::tell(int severity, const QString& sentence)
{
    m_message->setText(severity == EventLog::Information ? sentence : u"▲ "_s + sentence);
    m_message->setVisible(!sentence.isEmpty());
    m_severity = severity;
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
    const int most = std::clamp(height() / 8 / line, 3, 8);
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
    const int help = isWide ? 260 : 66;
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
