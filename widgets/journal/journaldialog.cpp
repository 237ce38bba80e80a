// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/journal/journaldialog.h"

#include "protocol/session/controller.h"
#include "widgets/common/eventlog.h"
#include "widgets/common/fitting.h"
#include "widgets/common/panel.h"
#include "widgets/common/stopbutton.h"
#include "widgets/common/theme.h"

#include <QComboBox>
#include <QDialogButtonBox>
#include <QEvent>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QLabel>
#include <QLineEdit>
#include <QPlainTextEdit>
#include <QPushButton>
#include <QTabWidget>
#include <QTableView>

using namespace Qt::Literals::StringLiterals;

namespace trex {
namespace {

enum Which { ThisController, AllControllers };

QPushButton* newButton(const QString& part, const QString& icon, const QString& text,
                       const QString& toolTip, QWidget* parent)
{
    auto* const button =
        named(new QPushButton(theme::icon(icon), text, parent), u"journal."_s + part, toolTip);
    button->setToolTip(toolTip);
    button->setAutoDefault(false); // Enter in the search writes nothing
    return button;
}

QTableView* newTable(const QString& name, const QString& accessibleName, QAbstractItemModel* model,
                     QWidget* parent)
{
    auto* const table = named(new QTableView(parent), name, accessibleName);
    table->setModel(model);
    table->setShowGrid(false);
    table->setSelectionBehavior(QAbstractItemView::SelectRows);
    table->setSelectionMode(QAbstractItemView::SingleSelection);
    table->setTabKeyNavigation(false);
    table->setTextElideMode(Qt::ElideRight);
    table->setWordWrap(false);
    table->verticalHeader()->hide();
    table->verticalHeader()->setSectionResizeMode(QHeaderView::Fixed);
    table->verticalHeader()->setDefaultSectionSize(table->fontMetrics().height() + 8);
    table->horizontalHeader()->setHighlightSections(false);
    table->horizontalHeader()->setDefaultAlignment(Qt::AlignLeft | Qt::AlignVCenter);
    table->horizontalHeader()->setStretchLastSection(true);
    return table;
}

QLabel* newText(const QString& part, const QString& accessibleName, QWidget* parent)
{
    auto* const label = named(new QLabel(parent), u"journal."_s + part, accessibleName);
    label->setWordWrap(true);
    label->setTextFormat(Qt::PlainText);
    label->setTextInteractionFlags(Qt::TextSelectableByMouse);
    return label;
}

} // namespace

JournalDialog::JournalDialog(PanelContext& context, QWidget* parent)
    : QDialog(parent)
    , m_context(context)
    , m_audit(*context.audit)
    , m_transfer(context.controller, context.deviceSettings)
{
    setObjectName(u"journal"_s);
    setWindowTitle(tr("Journal"));
    setAttribute(Qt::WA_DeleteOnClose);
    m_shown.setSourceModel(&m_entries);
    m_shown.setFilterKeyColumn(-1);
    m_shown.setFilterCaseSensitivity(Qt::CaseInsensitive);
    auto* const layout = new QVBoxLayout(this);
    layout->setSpacing(8);
    buildTop(*layout);
    m_tabs = named(new QTabWidget(this), u"journal.tabs"_s);
    m_tabs->addTab(newWritesPage(), tr("&Writes"));
    m_tabs->addTab(newCheckpointsPage(), tr("&Checkpoints"));
    layout->addWidget(m_tabs, 1);
    m_reason = newText(u"reason"_s, tr("Why nothing can be written now"), this);
    layout->addWidget(m_reason);
    buildPlan(*layout);
    m_message = newText(u"message"_s, tr("What happened last"), this);
    m_message->hide();
    layout->addWidget(m_message);
    auto* const buttons = new QDialogButtonBox(QDialogButtonBox::Close, this);
    auto* const close = named(buttons->button(QDialogButtonBox::Close), u"journal.close"_s);
    close->setAutoDefault(false);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    layout->addWidget(buttons);
    resizeToFit(*this, {860, 560});
    connectContext();
    reload();
    m_search->setFocus(); // a table with the focus would choose its first row
}

void JournalDialog::bringForward(PanelContext& context, QWidget* window)
{
    auto* dialog = window->findChild<JournalDialog*>(QString(), Qt::FindDirectChildrenOnly);
    if (dialog == nullptr) {
        dialog = new JournalDialog(context, window);
    }
    dialog->show();
    dialog->raise();
    dialog->activateWindow();
}

void JournalDialog::buildTop(QBoxLayout& layout)
{
    m_search = named(new QLineEdit(this), u"journal.search"_s, tr("Search the journal"));
    m_search->setPlaceholderText(tr("Search setting, value, result or time"));
    m_search->setClearButtonEnabled(true);
    m_search->addAction(theme::icon(u"search"_s), QLineEdit::LeadingPosition);
    m_which = named(new QComboBox(this), u"journal.which"_s, tr("Whose entries"));
    m_which->addItem(tr("This controller"), ThisController);
    m_which->addItem(tr("All controllers"), AllControllers);
    m_which->setCurrentIndex(m_context.controller.state() == LinkState::Connected ? ThisController
                                                                                  : AllControllers);
    auto* const row = new QHBoxLayout;
    row->setSpacing(8);
    row->addWidget(m_search, 1);
    row->addWidget(m_which);
    row->addSpacing(8);
    row->addWidget(named(new StopButton(m_context.controller, this), u"journal.stop"_s));
    layout.addLayout(row);
    connect(m_search, &QLineEdit::textChanged, &m_shown,
            &QSortFilterProxyModel::setFilterFixedString);
    connect(m_which, &QComboBox::currentIndexChanged, this, &JournalDialog::reload);
}

QWidget* JournalDialog::newWritesPage()
{
    auto* const page = new QWidget(this);
    m_table = newTable(u"journal.table"_s, tr("Writes, the newest first"), &m_shown, page);
    m_revert = newButton(u"revert"_s, u"revert"_s, tr("&Revert to before this…"),
                         tr("List what has to be written so that the controller holds what it "
                            "held before the chosen write"),
                         page);
    auto* const row = new QHBoxLayout;
    row->addStretch();
    row->addWidget(m_revert);
    auto* const layout = new QVBoxLayout(page);
    layout->addWidget(m_table, 1);
    layout->addLayout(row);
    connect(m_revert, &QPushButton::clicked, this, &JournalDialog::planRevert);
    return page;
}

QWidget* JournalDialog::newCheckpointsPage()
{
    auto* const page = new QWidget(this);
    m_checkpointTable = newTable(u"journal.checkpoints"_s, tr("Configurations that were kept"),
                                 &m_checkpoints, page);
    m_name = named(new QLineEdit(page), u"journal.checkpointName"_s, tr("Name of the checkpoint"));
    m_name->setPlaceholderText(tr("Name"));
    m_save = newButton(u"checkpoint"_s, u"save"_s, tr("&Keep as it is"),
                       tr("Keep the controller's whole configuration under this name"), page);
    m_restore =
        newButton(u"restore"_s, u"revert"_s, tr("Re&store…"),
                  tr("List what has to be written so that the controller holds this"), page);
    m_remove =
        newButton(u"delete"_s, u"clear"_s, tr("&Delete"), tr("Forget this checkpoint"), page);
    m_export = newButton(u"export"_s, u"export"_s, tr("&Export…"),
                         tr("Save this checkpoint as a configuration file"), page);
    auto* const row = new QHBoxLayout;
    row->setSpacing(8);
    row->addWidget(m_name, 1);
    row->addWidget(m_save);
    row->addSpacing(16);
    for (auto* const button : {m_export, m_remove, m_restore}) {
        row->addWidget(button);
    }
    auto* const layout = new QVBoxLayout(page);
    layout->addWidget(m_checkpointTable, 1);
    layout->addLayout(row);
    connect(m_name, &QLineEdit::textChanged, this, &JournalDialog::refresh);
    connect(m_save, &QPushButton::clicked, this, &JournalDialog::saveCheckpoint);
    connect(m_restore, &QPushButton::clicked, this, &JournalDialog::planRestore);
    connect(m_remove, &QPushButton::clicked, this, &JournalDialog::removeCheckpoint);
    connect(m_export, &QPushButton::clicked, this, &JournalDialog::exportCheckpoint);
    return page;
}

void JournalDialog::buildPlan(QBoxLayout& layout)
{
    m_planBox = new QWidget(this);
    m_planTitle = newText(u"planTitle"_s, tr("What would be written"), m_planBox);
    m_planText = named(new QPlainTextEdit(m_planBox), u"journal.plan"_s,
                       tr("What will be written to the controller"));
    m_planText->setReadOnly(true);
    m_planText->setTabChangesFocus(true);
    m_planText->setMaximumHeight(8 * fontMetrics().lineSpacing());
    m_write = newButton(u"write"_s, u"apply"_s, tr("W&rite these"),
                        tr("Write the list to the controller and read each value back"), m_planBox);
    auto* const drop =
        newButton(u"dismiss"_s, u"cancel"_s, tr("Write &nothing"), tr("Drop the list"), m_planBox);
    auto* const row = new QHBoxLayout;
    row->setSpacing(8);
    row->addStretch();
    row->addWidget(drop);
    row->addWidget(m_write);
    auto* const box = new QVBoxLayout(m_planBox);
    box->setContentsMargins(0, 0, 0, 0);
    box->addWidget(m_planTitle);
    box->addWidget(m_planText);
    box->addLayout(row);
    layout.addWidget(m_planBox);
    m_planBox->hide();
    connect(m_write, &QPushButton::clicked, this, &JournalDialog::write);
    connect(drop, &QPushButton::clicked, this, &JournalDialog::dropPlan);
}

void JournalDialog::connectContext()
{
    for (auto* const table : {m_table, m_checkpointTable}) {
        connect(table->selectionModel(), &QItemSelectionModel::currentRowChanged, this,
                [this, table](const QModelIndex& current) {
                    table->selectRow(current.row()); // from the keyboard, too
                    refresh();
                });
    }
    const auto onState = [this] {
        dropPlan();
        reload();
    };
    connect(&m_context.controller, &Controller::stateChanged, this, onState);
    connect(&m_context.controller, &Controller::deviceChanged, this, &JournalDialog::refresh);
    connect(&m_audit, &WriteAudit::recorded, this, &JournalDialog::reload);
    connect(&m_transfer, &ConfigTransfer::readFinished, this, &JournalDialog::onRead);
    connect(&m_transfer, &ConfigTransfer::finished, this, &JournalDialog::onFinished);
}

void JournalDialog::changeEvent(QEvent* event)
{
    QDialog::changeEvent(event);
    if (event->type() == QEvent::PaletteChange && m_message != nullptr) {
        tell(m_severity, m_message->text(), false);
        refresh();
    }
}

} // namespace trex
