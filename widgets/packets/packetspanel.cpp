// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/packets/packetspanel.h"

#include "protocol/session/controller.h"
#include "widgets/common/frameticker.h"
#include "widgets/common/theme.h"
#include "widgets/packets/packetcomposer.h"

#include <QComboBox>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QLabel>
#include <QLineEdit>
#include <QLocale>
#include <QScrollBar>
#include <QTableView>
#include <QToolButton>
#include <QVBoxLayout>

namespace trex {

using namespace Qt::Literals::StringLiterals;
using namespace std::chrono_literals;

namespace {

constexpr auto kTypingRests = 200ms;

struct ClassRow {
    PacketClass kind;
    QLatin1StringView key;
    const char* title;
};

// clang-format off
constexpr std::array kClasses {
    ClassRow {PacketClass::All,      "all"_L1,      QT_TRANSLATE_NOOP("trex::PacketsPanel", "All packets")},
    ClassRow {PacketClass::Motors,   "motors"_L1,   QT_TRANSLATE_NOOP("trex::PacketsPanel", "Motor commands")},
    ClassRow {PacketClass::Settings, "settings"_L1, QT_TRANSLATE_NOOP("trex::PacketsPanel", "Settings")},
    ClassRow {PacketClass::Queries,  "queries"_L1,  QT_TRANSLATE_NOOP("trex::PacketsPanel", "Queries asked for")},
    ClassRow {PacketClass::Polls,    "polls"_L1,    QT_TRANSLATE_NOOP("trex::PacketsPanel", "Polls")},
    ClassRow {PacketClass::Errors,   "errors"_L1,   QT_TRANSLATE_NOOP("trex::PacketsPanel", "Errors")},
};
// clang-format on

} // namespace

PacketsPanel::PacketsPanel(PanelContext& context, QWidget* parent)
    : Panel(context, parent), m_model(this), m_filterDelay(this)
{
    auto* bar = new QHBoxLayout;
    bar->setSpacing(8);
    buildBar(*bar);
    buildView();
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(8, 8, 8, 8);
    layout->setSpacing(8);
    layout->addLayout(bar);
    layout->addWidget(m_view, 1);
    layout->addWidget(m_counts);
    layout->addWidget(new PacketComposer(context.controller, this));

    m_filterDelay.setSingleShot(true);
    m_filterDelay.setInterval(kTypingRests);
    connect(&m_filterDelay, &QTimer::timeout, this, &PacketsPanel::applyFilter);
    connect(m_filter, &QLineEdit::textChanged, &m_filterDelay, qOverload<>(&QTimer::start));
    connect(m_class, &QComboBox::currentIndexChanged, this, &PacketsPanel::applyFilter);
    connect(&context.controller, &Controller::stateChanged, this, &PacketsPanel::onStateChanged);
    connect(&context.controller, &Controller::recordsArrived, &m_model, &PacketModel::add);
    connect(&context.controller, &Controller::recordsForgotten, &m_model, &PacketModel::clear);
    m_model.startConnection(context.controller.options().line, std::nullopt);
    showCounts();
}

void PacketsPanel::buildBar(QHBoxLayout& bar)
{
    m_filter = named(new QLineEdit(this), u"packets.filter"_s, tr("Filter the packets"));
    m_filter->setPlaceholderText(tr("Filter by meaning, hex or key"));
    m_filter->setClearButtonEnabled(true);
    m_class = named(new QComboBox(this), u"packets.class"_s, tr("Kind of packets shown"));
    for (const ClassRow& row : kClasses) {
        m_class->addItem(tr(row.title), QString(row.key));
    }
    m_pause = named(new QToolButton(this), u"packets.pause"_s, tr("Pause the list"));
    m_pause->setIcon(theme::icon(u"pause"_s));
    m_pause->setText(tr("Pause"));
    m_pause->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
    m_pause->setCheckable(true);
    m_pause->setToolTip(tr("Hold the list still; recording goes on behind"));
    connect(m_pause, &QToolButton::toggled, this, [this](bool paused) {
        m_model.setPaused(paused);
        showCounts();
    });
    auto* clear = named(new QToolButton(this), u"packets.clear"_s, tr("Clear the list"));
    clear->setIcon(theme::icon(u"clear"_s));
    clear->setText(tr("Clear"));
    clear->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
    connect(clear, &QToolButton::clicked, this, [this] {
        m_model.clear();
        showCounts();
    });
    bar.addWidget(m_filter, 1);
    bar.addWidget(m_class);
    bar.addWidget(m_pause);
    bar.addWidget(clear);
}

void PacketsPanel::buildView()
{
    m_view = named(new QTableView(this), u"packets.view"_s, tr("Packets"));
    m_view->setModel(&m_model);
    m_view->setShowGrid(false);
    m_view->setWordWrap(false);
    m_view->setSelectionBehavior(QAbstractItemView::SelectRows);
    m_view->setTabKeyNavigation(false);
    m_view->setTextElideMode(Qt::ElideRight);
    m_view->verticalHeader()->hide();
    // Fixed heights: measuring the contents of thousands of rows would cost more than all else.
    m_view->verticalHeader()->setSectionResizeMode(QHeaderView::Fixed);
    m_view->verticalHeader()->setDefaultSectionSize(m_view->fontMetrics().height() + 6);
    m_view->horizontalHeader()->setHighlightSections(false);
    setColumnWidths();

    m_counts = named(new QLabel(this), u"packets.counts"_s, tr("Counts of packets"));
    m_counts->setForegroundRole(QPalette::PlaceholderText);
    // What a person reads stays where it is when the oldest rows go.
    connect(&m_model, &QAbstractItemModel::rowsRemoved, this,
            [this](const QModelIndex&, int first, int last) {
                QScrollBar* scroll = m_view->verticalScrollBar();
                scroll->setValue(scroll->value() - (last - first + 1));
            });
}

void PacketsPanel::setColumnWidths()
{
    const QFontMetrics digits(theme::font(1.0, true));
    const QFontMetrics header(m_view->horizontalHeader()->font());
    constexpr int kPadding = 20;
    const auto width = [&](PacketModel::Column column, const QString& longest) {
        const QString title = m_model.headerData(column, Qt::Horizontal).toString();
        m_view->setColumnWidth(
            column,
            kPadding
                + std::max(digits.horizontalAdvance(longest), header.horizontalAdvance(title)));
    };
    width(PacketModel::TimeColumn, u"00000.000"_s);
    width(PacketModel::SentColumn, u"00 00 00 00"_s);
    width(PacketModel::ReceivedColumn, u"00 00 00 00"_s);
    width(PacketModel::RoundTripColumn, u"0000.0"_s);
    m_view->horizontalHeader()->setSectionResizeMode(PacketModel::MeaningColumn,
                                                     QHeaderView::Stretch);
    width(PacketModel::NoteColumn, u"0000000000000000"_s);
}

void PacketsPanel::showEvent(QShowEvent* event)
{
    Panel::showEvent(event);
    m_ticking = connect(&context().ticker, &FrameTicker::tick, this, &PacketsPanel::refresh);
    refresh();
}

void PacketsPanel::hideEvent(QHideEvent* event)
{
    disconnect(m_ticking);
    Panel::hideEvent(event);
}

bool PacketsPanel::isAtEnd() const
{
    const QScrollBar* scroll = m_view->verticalScrollBar();
    return scroll->value() >= scroll->maximum();
}

void PacketsPanel::refresh()
{
    if (m_model.waitingCount() == 0) {
        return;
    }
    const bool follows = isAtEnd(); // unless the person has scrolled up to read
    m_model.flush();
    if (follows && !m_model.isPaused()) {
        m_view->scrollToBottom();
    }
    showCounts();
}

void PacketsPanel::applyFilter()
{
    m_filterDelay.stop();
    const auto row = static_cast<std::size_t>(std::max(m_class->currentIndex(), 0));
    m_model.setFilter(m_filter->text(), kClasses.at(row).kind);
    m_view->scrollToBottom();
    showCounts();
}

void PacketsPanel::onStateChanged()
{
    const Controller& controller = context().controller;
    if (controller.state() == LinkState::Connecting) {
        m_model.startConnection(controller.options().line, std::chrono::steady_clock::now());
    }
}

void PacketsPanel::showCounts()
{
    const QLocale locale;
    QStringList parts;
    parts.append(
        tr("%1 of %2 packets shown")
            .arg(locale.toString(m_model.rowCount()), locale.toString(m_model.recordCount())));
    if (m_model.isPaused()) {
        parts.append(tr("paused, %1 more recorded").arg(locale.toString(m_model.waitingCount())));
    }
    if (m_model.droppedCount() > 0) {
        parts.append(tr("the oldest %1 were dropped").arg(locale.toString(m_model.droppedCount())));
    }
    m_counts->setText(parts.join(u" · "_s));
}

} // namespace trex
