// SPDX-License-Identifier: GPL-3.0-or-later
// What the parameters panel is made of.
#include "widgets/common/eventlog.h"
#include "widgets/common/theme.h"
#include "widgets/journal/journaldialog.h"
#include "widgets/parameters/comparedialog.h"
#include "widgets/parameters/parameterspanel.h"
#include "widgets/parameters/parametertable.h"
#include "widgets/parameters/restartline.h"

#include <QBoxLayout>
#include <QComboBox>
#include <QLabel>
#include <QLineEdit>
#include <QMenu>
#include <QProgressBar>
#include <QPushButton>
#include <QScrollArea>
#include <QSplitter>

using namespace Qt::Literals::StringLiterals;

namespace trex {
namespace {

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
    m_filter = named(new QComboBox(this), u"parameters.filter"_s, tr("Which parameters"));
    m_filter->addItem(tr("All"), u"all"_s);
    m_filter->addItem(tr("Changed"), u"changed"_s);
    m_filter->addItem(tr("Not default"), u"notDefault"_s);
    m_filter->addItem(tr("Power cycle"), u"powerCycle"_s);
    m_filter->setToolTip(
        tr("Which parameters are shown: all, those with edits, those that are not as from "
           "the factory, or those that need a power cycle"));
    m_filter->setSizeAdjustPolicy(QComboBox::AdjustToContents);
    m_filter->setMinimumWidth(90); // in a narrow window its longest words are cut, not the window
    m_filter->setSizePolicy(QSizePolicy::Preferred, QSizePolicy::Fixed);
    auto* const row = new QHBoxLayout;
    row->setSpacing(4);
    row->addWidget(m_search, 1);
    row->addWidget(m_filter);
    for (auto* const button : {m_reload, m_defaults, m_load, m_save}) {
        row->addWidget(button);
    }
    buildMore();
    auto* const more =
        newButton(u"more"_s, u"settings"_s, tr("&More"), tr("What is not needed every day"), this);
    more->setMenu(m_more);
    row->addWidget(more);
    static_cast<QVBoxLayout*>(layout())->addLayout(row);
    m_restart = new RestartLine(this);
    layout()->addWidget(m_restart);
    m_banner = newText(u"banner"_s, tr("State of the parameters"), this);
    layout()->addWidget(m_banner);
    connect(m_reload, &QPushButton::clicked, this, &ParametersPanel::readAll);
    connect(m_defaults, &QPushButton::clicked, this, &ParametersPanel::fillDefaults);
    connect(m_load, &QPushButton::clicked, this, &ParametersPanel::load);
    connect(m_save, &QPushButton::clicked, this, &ParametersPanel::save);
}

/// Actions that are not needed every day: the row of tools stays short.
void ParametersPanel::buildMore()
{
    m_more = named(new QMenu(this), u"parameters.moreMenu"_s);
    auto* const compare = m_more->addAction(theme::icon(u"copy"_s), tr("&Compare settings…"));
    compare->setObjectName(u"parameters.compare"_s);
    m_factoryReset = m_more->addAction(theme::icon(u"zero"_s), tr("Reset to &factory defaults…"));
    m_factoryReset->setObjectName(u"parameters.factoryReset"_s);
    connect(compare, &QAction::triggered, this,
            [this] { (new CompareDialog(context(), this))->show(); });
    connect(m_factoryReset, &QAction::triggered, this, &ParametersPanel::askFactoryReset);
    if (context().audit != nullptr) {
        auto* const journal = m_more->addAction(theme::icon(u"log"_s), tr("&Journal of writes…"));
        journal->setObjectName(u"parameters.journal"_s);
        connect(journal, &QAction::triggered, this,
                [this] { JournalDialog::bringForward(context(), window()); });
    }
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
    area->setMinimumSize(200, 64); // four lines
    m_splitter->addWidget(m_table);
    m_splitter->addWidget(area);
    m_splitter->setStretchFactor(0, 1);
    m_splitter->setStretchFactor(1, 0);
    static_cast<QVBoxLayout*>(layout())->addWidget(m_splitter, 1);
    m_noRows = newText(u"noRows"_s, tr("No parameter is shown"), this);
    m_noRows->hide();
    layout()->addWidget(m_noRows);
    connect(m_search, &QLineEdit::textChanged, m_table, &ParameterTable::search);
    connect(m_filter, &QComboBox::currentIndexChanged, this, [this](int index) {
        m_table->setFilter(static_cast<ParameterModel::Filter>(index)); // in the filters' order
    });
    connect(m_table, &ParameterTable::shownRowsChanged, this, [this] {
        m_noRows->setText(m_filter->currentIndex() == 0
                              ? tr("No parameter is found. Clear the search to see all.")
                              : tr("No parameter is found: \"%1\" is chosen beside the search.")
                                    .arg(m_filter->currentText()));
        m_noRows->setVisible(m_table->shownRows() == 0);
    });
    connect(m_table, &ParameterTable::remarked, this,
            [this](const QString& sentence) { tell(EventLog::Warning, sentence); });
    connect(m_table, &ParameterTable::rowChosen, this, &ParametersPanel::refreshHelp);
    connect(m_table, &ParameterTable::editRejected, this,
            [this](int /*number*/, const QString& sentence) { tell(EventLog::Warning, sentence); });
    connect(&m_model, &ParameterModel::shownChanged, this, [this](int number) {
        if (m_table->currentRow() != nullptr && m_table->currentRow()->number == number) {
            refreshHelp();
        }
    });
    connect(&m_model, &ParameterModel::editsChanged, this, [this] {
        if (m_severity == EventLog::Information && !m_transfer.isBusy()) {
            m_message->hide(); // about something before; the log has it
        }
        refresh();
    });
    m_table->setCurrentIndex(m_model.indexOf(parameterRow("device-number").number));
}

void ParametersPanel::buildFooter()
{
    m_message = newText(u"message"_s, tr("What happened last"), this);
    m_pending = newText(u"pending"_s, tr("What will be written"), this);
    m_pendingArea = scrolled(m_pending, this);
    m_progress = named(new QProgressBar(this), u"parameters.progress"_s, tr("Progress"));
    m_progress->setFixedWidth(140);
    m_progress->setFormat(tr("%v of %m"));
    m_cancel = newButton(u"cancel"_s, u"cancel"_s, tr("Cancel"),
                         tr("Stop writing after the setting that is being written now"), this);
    m_rollback = newButton(u"rollback"_s, u"back"_s, {},
                           tr("Write the values back that the controller had before"), this);
    m_keep = newButton(u"keep"_s, u"ok"_s, tr("&Keep them"),
                       tr("Leave what was written as it is in the controller"), this);
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
    auto* const told = new QHBoxLayout;
    told->setSpacing(8);
    told->addWidget(m_message, 1);
    told->addWidget(m_rollback, 0, Qt::AlignTop);
    told->addWidget(m_keep, 0, Qt::AlignTop);
    static_cast<QVBoxLayout*>(layout())->addLayout(told);
    static_cast<QVBoxLayout*>(layout())->addLayout(row);
    m_message->hide();
    m_rollback->hide();
    m_keep->hide();
    m_progress->hide();
    m_cancel->hide();
    connect(m_cancel, &QPushButton::clicked, &m_transfer, &ConfigTransfer::cancel);
    connect(m_rollback, &QPushButton::clicked, this, &ParametersPanel::putBack);
    connect(m_keep, &QPushButton::clicked, this, [this] {
        offerToPutBack({});
        tell(EventLog::Information, tr("What was written stays in the controller."));
    });
    connect(m_revert, &QPushButton::clicked, this, &ParametersPanel::revert);
    connect(m_apply, &QPushButton::clicked, this, &ParametersPanel::apply);
}

} // namespace trex
