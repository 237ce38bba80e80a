// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/bench/benchpanel.h"

#include "protocol/procedures/benchpreview.h"
#include "protocol/session/devicesettings.h"
#include "protocol/storage/readyprofiles.h"
#include "widgets/bench/benchchart.h"
#include "widgets/bench/benchlimitsform.h"
#include "widgets/bench/benchstepform.h"
#include "widgets/common/stopbutton.h"
#include "widgets/common/theme.h"

#include <QEvent>
#include <QFrame>
#include <QHeaderView>
#include <QLabel>
#include <QListWidget>
#include <QProgressBar>
#include <QPushButton>
#include <QScrollArea>
#include <QSplitter>
#include <QTabWidget>
#include <QTableView>
#include <QVBoxLayout>

#include <array>

namespace trex {

using namespace Qt::Literals::StringLiterals;

namespace {

constexpr int kListWidth = 150;
constexpr int kLeastListWidth = 110;
constexpr int kFormWidth = 260;

QLabel* wrapped(QLabel* label)
{
    label->setWordWrap(true);
    label->setTextFormat(Qt::PlainText); // names and notes come from files
    return label;
}

QTableView* table(QAbstractItemModel& model, const QString& name, const QString& title,
                  QWidget* parent)
{
    auto* view = named(new QTableView(parent), name, title);
    view->setModel(&model);
    view->setSelectionBehavior(QAbstractItemView::SelectRows);
    view->setSelectionMode(QAbstractItemView::SingleSelection);
    view->setShowGrid(false);
    view->setTabKeyNavigation(false);
    view->verticalHeader()->hide();
    view->verticalHeader()->setSectionResizeMode(QHeaderView::ResizeToContents);
    view->horizontalHeader()->setHighlightSections(false);
    view->horizontalHeader()->setDefaultAlignment(Qt::AlignLeft | Qt::AlignVCenter);
    view->horizontalHeader()->setSectionResizeMode(QHeaderView::ResizeToContents);
    return view;
}

QScrollArea* scrolled(QWidget* content)
{
    auto* area = new QScrollArea;
    area->setWidget(content);
    area->setWidgetResizable(true);
    area->setFrameShape(QFrame::NoFrame);
    area->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    return area;
}

} // namespace

BenchPanel::BenchPanel(PanelContext& context, QWidget* parent) : Panel(context, parent)
{
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(8, 8, 8, 8);
    layout->setSpacing(8);
    auto* middle = new QHBoxLayout;
    middle->setSpacing(12);
    buildList(*middle);
    m_tabs = named(new QTabWidget(this), u"bench.tabs"_s, tr("Parts of the bench test"));
    m_tabs->setDocumentMode(true);
    m_tabs->addTab(buildPlotTab(), tr("Test"));
    QScrollArea* steps = scrolled(buildStepsTab());
    steps->setHorizontalScrollBarPolicy(Qt::ScrollBarAsNeeded);
    m_tabs->addTab(steps, tr("Steps and limits")); // in a narrow window it is scrolled
    m_tabs->addTab(buildResultsTab(), tr("Results"));
    middle->addWidget(m_tabs, 1);
    layout->addLayout(middle, 1);
    buildConfirmation(*layout);
    buildFooter(*layout);
    connectContext();
    for (const ReadyProfileRow& row : readyProfiles()) {
        if (const auto profile = readyProfile(row.key)) {
            addEntry(*profile, {});
        }
    }
    m_list->setCurrentRow(0);
    readMotorMode();
}

BenchPanel::~BenchPanel() = default;

QPushButton* BenchPanel::addButton(QLayout& layout, const QString& name, const QString& text,
                                   const QString& icon)
{
    auto* button = named(new QPushButton(text, this), u"bench."_s + name, text);
    if (!icon.isEmpty()) {
        button->setIcon(theme::icon(icon));
    }
    button->setProperty("icon-name", icon);
    layout.addWidget(button);
    return button;
}

void BenchPanel::buildList(QLayout& layout)
{
    auto* column = new QVBoxLayout;
    column->setSpacing(4);
    m_list = named(new QListWidget(this), u"bench.list"_s, tr("Bench tests"));
    m_list->setWordWrap(true);
    m_list->setResizeMode(QListView::Adjust);
    m_list->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    m_list->setMinimumWidth(kLeastListWidth);
    m_list->setMaximumWidth(kListWidth);
    column->addWidget(m_list, 1);
    auto* buttons = new QVBoxLayout; // one above the other: the column may get narrow
    buttons->setSpacing(4);
    auto* open = addButton(*buttons, u"open"_s, tr("Open…"), u"load"_s);
    auto* save = addButton(*buttons, u"save"_s, tr("Save…"), u"save"_s);
    column->addLayout(buttons);
    static_cast<QHBoxLayout&>(layout).addLayout(column);
    connect(m_list, &QListWidget::currentRowChanged, this, &BenchPanel::choose);
    connect(open, &QPushButton::clicked, this, &BenchPanel::openFile);
    connect(save, &QPushButton::clicked, this, &BenchPanel::saveFile);
}

QWidget* BenchPanel::buildPlotTab()
{
    auto* tab = new QWidget(this);
    auto* layout = new QVBoxLayout(tab);
    layout->setContentsMargins(0, 8, 0, 0);
    m_description = wrapped(named(new QLabel(tab), u"bench.description"_s));
    m_plot = named(new BenchChart(tab), u"bench.plot"_s, tr("Speeds and currents of the test"));
    layout->addWidget(m_description);
    layout->addWidget(m_plot, 1);
    return tab;
}

QWidget* BenchPanel::buildStepsTab()
{
    auto* tab = new QWidget(this);
    auto* layout = new QHBoxLayout(tab);
    layout->setContentsMargins(0, 8, 0, 0);
    auto* left = new QVBoxLayout;
    m_stepTable = table(m_steps, u"bench.steps"_s, tr("Steps"), tab);
    m_stepTable->horizontalHeader()->setSectionResizeMode(BenchStepModel::WhatColumn,
                                                          QHeaderView::Stretch);
    left->addWidget(m_stepTable, 1);
    std::array<QHBoxLayout*, 2> rows{new QHBoxLayout, new QHBoxLayout}; // one would be too wide
    auto* add = addButton(*rows[0], u"add"_s, tr("Add"), {});
    auto* remove = addButton(*rows[0], u"remove"_s, tr("Remove"), {});
    m_revert = addButton(*rows[0], u"revert"_s, tr("Revert"), u"revert"_s);
    auto* up = addButton(*rows[1], u"up"_s, tr("Up"), {});
    auto* down = addButton(*rows[1], u"down"_s, tr("Down"), {});
    for (QHBoxLayout* row : rows) {
        row->setSpacing(4);
        row->addStretch();
        left->addLayout(row);
    }
    layout->addLayout(left, 1);
    m_stepForm = new BenchStepForm(tab);
    m_limits = new BenchLimitsForm(tab);
    auto* forms = named(new QTabWidget(tab), u"bench.forms"_s, tr("Step or limits"));
    forms->setDocumentMode(true);
    forms->addTab(scrolled(m_stepForm), tr("Step"));
    forms->addTab(scrolled(m_limits), tr("Whole test"));
    forms->setFixedWidth(kFormWidth); // the table takes the rest
    layout->addWidget(forms);

    const auto row = [this] { return m_stepTable->currentIndex().row(); };
    connect(add, &QPushButton::clicked, this, &BenchPanel::addStep);
    connect(remove, &QPushButton::clicked, this, [this, row] {
        if (row() >= 0) {
            const int at = row();
            m_steps.remove(at);
            selectStep(std::min(at, m_steps.rowCount() - 1));
        }
    });
    for (const auto& [button, by] : {std::pair{up, -1}, std::pair{down, 1}}) {
        connect(button, &QPushButton::clicked, this, [this, row, by = by] {
            if (row() >= 0) {
                selectStep(m_steps.move(row(), by));
            }
        });
    }
    connect(m_revert, &QPushButton::clicked, this, &BenchPanel::revert);
    connect(m_stepTable->selectionModel(), &QItemSelectionModel::currentRowChanged, this,
            [this](const QModelIndex& index) {
                m_stepForm->setEnabled(index.isValid());
                if (index.isValid()) {
                    m_stepForm->setStep(m_steps.step(index.row()));
                }
            });
    connect(m_stepForm, &BenchStepForm::edited, this, [this, row](const BenchStep& step) {
        const int at = row();
        if (at >= 0) {
            m_steps.replace(at, step);
            selectStep(at);
        }
    });
    connect(&m_steps, &BenchStepModel::edited, this, &BenchPanel::onEdited);
    connect(m_limits, &BenchLimitsForm::edited, this, &BenchPanel::onEdited);
    return tab;
}

QWidget* BenchPanel::buildResultsTab()
{
    auto* tab = new QWidget(this);
    auto* layout = new QVBoxLayout(tab);
    layout->setContentsMargins(0, 8, 0, 0);
    layout->setSpacing(8);
    m_verdict = wrapped(named(new QLabel(tab), u"bench.verdict"_s, tr("Verdict")));
    m_verdict->setFont(theme::font(1.25));
    layout->addWidget(m_verdict);
    m_resultTable = table(m_results, u"bench.results"_s, tr("Results"), tab);
    m_resultTable->horizontalHeader()->setSectionResizeMode(BenchResultModel::TitleColumn,
                                                            QHeaderView::Stretch);
    layout->addWidget(m_resultTable, 1);
    auto* row = new QHBoxLayout;
    m_proposals = wrapped(named(new QLabel(tab), u"bench.proposals"_s, tr("Proposed settings")));
    row->addWidget(m_proposals, 1);
    m_saveProposals =
        addButton(*row, u"saveProposals"_s, tr("To a configuration file…"), u"parameters"_s);
    layout->addLayout(row);
    connect(m_saveProposals, &QPushButton::clicked, this, &BenchPanel::saveProposals);
    connect(&m_results, &BenchResultModel::expectationChanged, this,
            [this](const QString& key, const BenchExpectation& expectation) {
                const bool isAny = expectation.minimum || expectation.maximum;
                isAny ? void(entry().profile.expect[key] = expectation)
                      : void(entry().profile.expect.erase(key));
                entry().outcome = m_results.outcome();
                showOutcome();
                refreshTitles();
            });
    return tab;
}

void BenchPanel::buildConfirmation(QLayout& layout)
{
    m_confirmation = named(new QFrame(this), u"bench.confirmation"_s);
    m_confirmation->setFrameShape(QFrame::StyledPanel);
    auto* row = new QHBoxLayout(m_confirmation);
    row->setSpacing(16);
    m_confirmText =
        wrapped(named(new QLabel(m_confirmation), u"bench.confirmText"_s, tr("What will happen")));
    row->addWidget(m_confirmText, 1);
    m_confirm = addButton(*row, u"confirm"_s, tr("Arm and start"), u"arm"_s);
    auto* back = addButton(*row, u"back"_s, tr("Do not start"), u"cancel"_s);
    layout.addWidget(m_confirmation);
    connect(m_confirm, &QPushButton::clicked, this, &BenchPanel::start);
    connect(back, &QPushButton::clicked, this, [this] {
        m_isConfirming = false;
        refresh();
    });
}

void BenchPanel::buildFooter(QLayout& layout)
{
    auto* state = new QHBoxLayout;
    state->setSpacing(8);
    m_status = wrapped(named(new QLabel(this), u"bench.status"_s, tr("State of the test")));
    state->addWidget(m_status, 1);
    m_progress = named(new QProgressBar(this), u"bench.progress"_s, tr("Progress"));
    m_progress->setRange(0, 1000);
    m_progress->setTextVisible(false);
    m_progress->setFixedWidth(120);
    state->addWidget(m_progress);
    static_cast<QVBoxLayout&>(layout).addLayout(state);
    auto* row = new QHBoxLayout;
    row->setSpacing(8);
    m_dry = addButton(*row, u"dryRun"_s, tr("Dry run"), u"simulate"_s);
    m_dry->setToolTip(tr("Runs the test on a private simulated controller: no motor moves"));
    m_start = addButton(*row, u"start"_s, tr("Start…"), u"play"_s);
    m_html = addButton(*row, u"html"_s, tr("HTML…"), u"export"_s);
    m_html->setAccessibleName(tr("Report as HTML"));
    m_pdf = addButton(*row, u"pdf"_s, tr("PDF…"), u"export"_s);
    m_pdf->setAccessibleName(tr("Report as PDF"));
    row->addStretch(1); // Start does not sit beside STOP by accident
    row->addWidget(
        named(new StopButton(context().controller, this), u"bench.stop"_s, tr("Stop all motors")));
    static_cast<QVBoxLayout&>(layout).addLayout(row);
    connect(m_dry, &QPushButton::clicked, this, &BenchPanel::startDryRun);
    connect(m_start, &QPushButton::clicked, this, &BenchPanel::askToStart);
    connect(m_html, &QPushButton::clicked, this, [this] { saveReportAs(false); });
    connect(m_pdf, &QPushButton::clicked, this, [this] { saveReportAs(true); });
    m_slice.setInterval(0);
    connect(&m_slice, &QTimer::timeout, this, &BenchPanel::sliceOfDryRun);
}

void BenchPanel::connectContext()
{
    connect(&context().controller, &Controller::stateChanged, this, [this](LinkState state) {
        if (state == LinkState::Connected) {
            readMotorMode();
        }
        refresh();
    });
    connect(&context().deviceSettings, &DeviceSettings::forgotten, this,
            &BenchPanel::readMotorMode);
    connect(&context().controller, &Controller::deviceChanged, this, &BenchPanel::refresh);
    connect(&context().controller, &Controller::lockedOut, this, [this] {
        m_isConfirming = false; // STOP answers the question, too
        QMetaObject::invokeMethod(this, &BenchPanel::cancel, Qt::QueuedConnection);
        // Not a moment before the gate opens.
        QTimer::singleShot(Controller::kStopLockout + std::chrono::milliseconds(5),
                           Qt::PreciseTimer, this, &BenchPanel::refresh);
        refresh();
    });
    connect(&context().deviceSettings, &DeviceSettings::parameterChanged, this,
            &BenchPanel::refresh);
}

void BenchPanel::readMotorMode()
{
    if (context().controller.state() == LinkState::Connected) {
        context().deviceSettings.readParameter(parameterRow("motor-mode"), this,
                                               [this](const Result<int>&) { refresh(); });
    }
    refresh();
}

void BenchPanel::changeEvent(QEvent* event)
{
    Panel::changeEvent(event);
    if (event->type() == QEvent::PaletteChange) {
        for (auto* button : findChildren<QPushButton*>()) {
            if (const QString icon = button->property("icon-name").toString(); !icon.isEmpty()) {
                button->setIcon(theme::icon(icon));
            }
        }
        if (!m_entries.empty()) {
            showOutcome();
        }
    }
}

void BenchPanel::addEntry(const BenchProfile& profile, const QString& path)
{
    m_entries.push_back({profile, profile, path, {}, {}, {}});
    m_list->addItem(profile.name);
    m_list->item(m_list->count() - 1)
        ->setToolTip(path.isEmpty() ? tr("Comes with the program") : path);
}

void BenchPanel::choose(int row)
{
    if (row < 0 || row >= int(m_entries.size()) || m_test) {
        return;
    }
    m_dryRun.reset();
    m_slice.stop();
    m_isConfirming = false;
    m_current = std::size_t(row);
    showEntry();
}

void BenchPanel::showEntry()
{
    m_isFilling = true;
    m_told.clear();
    m_steps.setSteps(entry().profile.steps);
    m_limits->show(entry().profile);
    selectStep(0);
    m_isFilling = false;
    m_plot->setPlan(previewOf(entry().profile));
    m_plot->setNow(-1.0);
    showOutcome();
    refreshTitles();
    refresh();
}

void BenchPanel::selectStep(int row)
{
    m_stepTable->selectRow(row);
    m_stepForm->setEnabled(row >= 0 && row < m_steps.rowCount());
    if (row >= 0 && row < m_steps.rowCount()) {
        m_stepForm->setStep(m_steps.step(row));
    }
}

} // namespace trex
