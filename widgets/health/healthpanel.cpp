// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/health/healthpanel.h"

#include "protocol/session/controller.h"
#include "protocol/session/linkadvice.h"
#include "protocol/session/linkfigures.h"
#include "widgets/common/frameticker.h"
#include "widgets/common/theme.h"
#include "widgets/health/advicelist.h"
#include "widgets/health/latencyview.h"

#include <QApplication>
#include <QClipboard>
#include <QGridLayout>
#include <QLabel>
#include <QPushButton>
#include <QScrollArea>
#include <QSplitter>
#include <QStyle>
#include <QVBoxLayout>

namespace trex {

using namespace Qt::Literals::StringLiterals;

namespace {

constexpr int kTicksBetween = 15; ///< half a second: figures that can be read
constexpr QSize kSmallest{260, 160};
constexpr int kNarrowestAdvice = 170;
constexpr int kWide = 740; ///< from here on the three parts stand side by side

/// A list of several stands one under the other.
QString inLines(QString text)
{
    return text.replace(u", "_s, u"\n"_s);
}

QScrollArea* scrolled(QWidget* content, QWidget* parent)
{
    auto* area = new QScrollArea(parent);
    area->setWidget(content);
    area->setWidgetResizable(true);
    area->setFrameShape(QFrame::NoFrame);
    content->setAutoFillBackground(false);
    area->viewport()->setAutoFillBackground(false);
    return area;
}

} // namespace

HealthPanel::HealthPanel(PanelContext& context, QWidget* parent)
    : Panel(context, parent)
    , m_splitter(new QSplitter(this))
    , m_advice(named(new AdviceList(this), u"health.advice"_s, tr("Advice about the line")))
    , m_view(named(new LatencyView(this), u"health.histogram"_s))
{
    m_view->setAccessibleName(tr("How long answers took in the last minute"));
    m_splitter->addWidget(makeAdvice());
    m_splitter->addWidget(m_view);
    m_splitter->addWidget(makeFigures());
    m_splitter->setChildrenCollapsible(false);
    m_splitter->setHandleWidth(8);
    for (int i = 0; i < m_splitter->count(); ++i) {
        m_splitter->setStretchFactor(i, m_splitter->widget(i) == m_view ? 3 : 1);
    }
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(8, 8, 8, 8);
    layout->addWidget(m_splitter);
    setMinimumSize(kSmallest); // less than its parts side by side need: they stand upright then
    connect(m_advice, &AdviceList::panelRequested, this, &Panel::panelRequested);
    connect(&context.ticker, &FrameTicker::tick, this, [this] {
        if (++m_ticks >= kTicksBetween && isVisible()) {
            refresh();
        }
    });
    connect(&context.controller, &Controller::stateChanged, this, &HealthPanel::refresh);
    refresh();
}

QWidget* HealthPanel::makeAdvice()
{
    auto* box = new QWidget(this);
    auto* layout = new QVBoxLayout(box);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(8);
    QScrollArea* advice = scrolled(m_advice, box);
    advice->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff); // sentences wrap
    layout->addWidget(advice, 1);
    auto* buttons = new QHBoxLayout;
    auto* reset = named(new QPushButton(theme::icon(u"clear"_s), tr("Count anew"), box),
                        u"health.reset"_s, tr("Count the figures of the line anew"));
    reset->setToolTip(tr("Forgets the figures so far; what is counted begins now."));
    auto* copy = named(new QPushButton(theme::icon(u"copy"_s), tr("Copy"), box), u"health.copy"_s,
                       tr("Copy figures and advice as text"));
    connect(reset, &QPushButton::clicked, this, [this] {
        context().controller.resetHealth();
        refresh();
    });
    connect(copy, &QPushButton::clicked, this,
            [this] { QApplication::clipboard()->setText(linkReport(facts())); });
    buttons->addWidget(reset);
    buttons->addWidget(copy);
    buttons->addStretch();
    layout->addLayout(buttons);
    box->setMinimumWidth(std::max(kNarrowestAdvice, buttons->minimumSize().width()));
    return box;
}

QWidget* HealthPanel::makeFigures()
{
    auto* content = named(new QWidget(this), u"health.figures"_s, tr("Figures of the line"));
    m_grid = new QGridLayout(content);
    m_grid->setContentsMargins(0, 0, 8, 0);
    m_grid->setHorizontalSpacing(12);
    m_grid->setVerticalSpacing(2);
    m_grid->setColumnStretch(0, 1);
    auto* recent = new QLabel(tr("last minute"), content);
    m_since = named(new QLabel(content), u"health.since"_s, tr("Counted since"));
    int column = 1;
    for (QLabel* heading : {recent, m_since}) {
        heading->setForegroundRole(QPalette::PlaceholderText);
        m_grid->addWidget(heading, 0, column++, Qt::AlignRight);
    }
    m_figures = scrolled(content, this);
    return m_figures;
}

HealthPanel::FigureRow& HealthPanel::rowOf(const QString& key, const QString& title, bool isCounted)
{
    const auto found = m_rows.find(key);
    if (found != m_rows.end()) {
        return found->second;
    }
    const auto label = [this, &title](const QString& name) {
        auto* made = named(new QLabel(m_grid->parentWidget()), name, title);
        made->setFont(theme::font(1.0, true));
        made->setTextFormat(Qt::PlainText);
        made->setTextInteractionFlags(Qt::TextSelectableByMouse);
        made->setAlignment(Qt::AlignRight | Qt::AlignTop);
        return made;
    };
    const int line = m_grid->rowCount();
    auto* caption = new QLabel(title, m_grid->parentWidget());
    m_grid->addWidget(caption, line, 0, Qt::AlignTop);
    FigureRow row{caption, label(u"health."_s + key), nullptr};
    if (isCounted) {
        row.total = label(u"health.%1.total"_s.arg(key));
        m_grid->addWidget(row.recent, line, 1);
        m_grid->addWidget(row.total, line, 2);
    } else {
        row.recent->setWordWrap(true);
        m_grid->addWidget(row.recent, line, 1, 1, 2);
    }
    return m_rows.emplace(key, row).first->second;
}

LinkFacts HealthPanel::facts() const
{
    const Controller& controller = context().controller;
    return {controller.state(), controller.options().line, controller.stats(), controller.health()};
}

void HealthPanel::refresh()
{
    m_ticks = 0;
    const LinkFacts now = facts();
    m_view->show(now.health.recent);
    m_advice->show(linkAdvice(now));
    refreshFigures(now);
}

void HealthPanel::refreshFigures(const LinkFacts& facts)
{
    const auto seconds =
        std::chrono::duration_cast<std::chrono::seconds>(facts.health.total.covered).count();
    m_since->setText(seconds < 120 ? tr("in %1 s").arg(seconds)
                                   : tr("in %1 min").arg(seconds / 60));
    const auto mark = [](QLabel* label, bool isTrouble) {
        theme::setTextColour(*label, isTrouble ? ColourRole::Warning : ColourRole::Text);
    };
    for (const CountedFigure& figure : countedFigures(facts)) {
        FigureRow& row = rowOf(figure.key, figure.title, true);
        // Colour is not the only sign: what is wrong stands in the advice beside.
        mark(row.recent, figure.isTrouble);
        row.recent->setText(inLines(figure.recent));
        row.total->setText(inLines(figure.total));
    }
    std::vector<QString> shown;
    for (const LineFigure& figure : lineFigures(facts)) {
        FigureRow& row = rowOf(figure.key, figure.title, false);
        mark(row.recent, figure.isTrouble);
        row.recent->setText(figure.text);
        shown.push_back(figure.key);
    }
    const bool isBeside = m_isArranged && m_splitter->orientation() == Qt::Horizontal;
    if (isBeside && figuresWidth() > m_figures->minimumWidth()) {
        arrange(); // a figure has grown
    }
    for (auto& [key, row] : m_rows) { // rates that nobody asks for any more
        const bool isShown =
            row.total != nullptr || std::find(shown.begin(), shown.end(), key) != shown.end();
        row.title->setVisible(isShown);
        row.recent->setVisible(isShown);
    }
}

void HealthPanel::resizeEvent(QResizeEvent* event)
{
    Panel::resizeEvent(event);
    const auto wanted = width() >= kWide ? Qt::Horizontal : Qt::Vertical;
    if (m_splitter->orientation() != wanted || !m_isArranged) {
        m_isArranged = true;
        m_splitter->setOrientation(wanted);
        arrange();
    }
}

int HealthPanel::figuresWidth() const
{
    return m_grid->minimumSize().width() + style()->pixelMetric(QStyle::PM_ScrollBarExtent);
}

/// The figures as wide as they are, where they stand beside the rest; sentences wrap.
void HealthPanel::arrange()
{
    const bool isBeside = m_splitter->orientation() == Qt::Horizontal;
    const int figures = figuresWidth();
    m_figures->setMinimumWidth(isBeside ? figures : 0);
    if (isBeside) {
        const int advice = std::clamp(width() / 4, m_splitter->widget(0)->minimumWidth(), 400);
        m_splitter->setSizes({advice, std::max(width() - advice - figures, 180), figures});
    } else {
        m_splitter->setSizes({height() / 4, height() / 3, height() * 5 / 12});
    }
}

void HealthPanel::showEvent(QShowEvent* event)
{
    Panel::showEvent(event);
    refresh();
}

} // namespace trex
