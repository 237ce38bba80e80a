// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/plots/eventlist.h"

#include "widgets/common/frameticker.h"
#include "widgets/common/panel.h"
#include "widgets/common/plotticks.h"
#include "widgets/common/plottimeline.h"
#include "widgets/common/theme.h"

#include <QHBoxLayout>
#include <QHeaderView>
#include <QTableView>
#include <QToolButton>
#include <QVBoxLayout>

namespace trex {

using namespace Qt::Literals::StringLiterals;

namespace {

ColourRole roleOf(MarkWeight weight)
{
    switch (weight) {
    case MarkWeight::Quiet:
        return ColourRole::DimText;
    case MarkWeight::Action:
        return ColourRole::Accent;
    case MarkWeight::Warning:
        return ColourRole::Warning;
    case MarkWeight::Fault:
        break;
    }
    return ColourRole::Fault;
}

} // namespace

EventModel::EventModel(const MarkTrack* track, const PlotTimeline& timeline, QObject* parent)
    : QAbstractTableModel(parent), m_track(track), m_timeline(timeline)
{
    refresh();
}

void EventModel::refresh()
{
    if (m_track == nullptr || m_track->revision() == m_revision) {
        return;
    }
    const std::vector<Mark>& marks = m_track->marks();
    const std::size_t before = m_marks.size();
    const bool isAppended = marks.size() - before == m_track->revision() - m_revision
        && marks.size() > before
        && (before == 0
            || (marks[before - 1].time == m_marks.back().time
                && marks[before - 1].kind == m_marks.back().kind));
    m_revision = m_track->revision();
    if (isAppended) {
        beginInsertRows({}, static_cast<int>(before), static_cast<int>(marks.size()) - 1);
        m_marks.insert(m_marks.end(), marks.begin() + static_cast<std::ptrdiff_t>(before),
                       marks.end());
        endInsertRows();
    } else {
        beginResetModel();
        m_marks = marks;
        endResetModel();
    }
}

const Mark& EventModel::mark(int row) const
{
    return m_marks.at(static_cast<std::size_t>(row));
}

int EventModel::rowCount(const QModelIndex& parent) const
{
    return parent.isValid() ? 0 : static_cast<int>(m_marks.size());
}

int EventModel::columnCount(const QModelIndex& parent) const
{
    return parent.isValid() ? 0 : Columns;
}

QVariant EventModel::data(const QModelIndex& index, int role) const
{
    if (!index.isValid()) {
        return {};
    }
    const Mark& shown = mark(index.row());
    const bool isTime = index.column() == Time;
    switch (role) {
    case Qt::DisplayRole: {
        const std::chrono::duration<double> since = shown.time - m_timeline.origin();
        return isTime ? ticks::timeLabel(since.count(), 0.01)
                      : QString::fromUtf8(markRow(shown.kind).sign) + u"  "_s + markText(shown);
    }
    case Qt::ToolTipRole:
        return markText(shown);
    case Qt::ForegroundRole:
        return theme::colour(isTime ? ColourRole::DimText : roleOf(markRow(shown.kind).weight));
    default:
        return {};
    }
}

QVariant EventModel::headerData(int section, Qt::Orientation orientation, int role) const
{
    if (orientation != Qt::Horizontal || role != Qt::DisplayRole) {
        return {};
    }
    return section == Time ? tr("Time") : tr("Event");
}

EventList::EventList(const MarkTrack* track, PlotTimeline& timeline, FrameTicker& ticker,
                     QWidget* parent)
    : QWidget(parent)
    , m_timeline(timeline)
    , m_model(new EventModel(track, timeline, this))
    , m_view(named(new QTableView(this), u"plots.events.list"_s, tr("Events")))
{
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 4, 0, 0);
    layout->setSpacing(4);
    auto* row = new QHBoxLayout;
    const auto add = [&](const QString& name, const QString& icon, const QString& text,
                         const QString& key, void (PlotTimeline::*go)()) {
        auto* button = named(new QToolButton(this), name, text);
        button->setIcon(theme::icon(icon));
        button->setText(text);
        button->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
        button->setAutoRaise(true);
        button->setToolTip(tr("%1 (%2 in a plot)").arg(text, key));
        connect(button, &QToolButton::clicked, &timeline, go);
        row->addWidget(button);
    };
    add(u"plots.events.previous"_s, u"back"_s, tr("Previous event"), tr("Shift+N"),
        &PlotTimeline::showPreviousMark);
    add(u"plots.events.next"_s, u"next"_s, tr("Next event"), tr("N"), &PlotTimeline::showNextMark);
    row->addStretch(1);
    layout->addLayout(row);
    layout->addWidget(m_view, 1);
    m_view->setModel(m_model);
    m_view->setFrameShape(QFrame::NoFrame);
    m_view->setShowGrid(false);
    m_view->setSelectionBehavior(QAbstractItemView::SelectRows);
    m_view->setSelectionMode(QAbstractItemView::SingleSelection);
    m_view->setTabKeyNavigation(false);
    m_view->setWordWrap(false);
    m_view->verticalHeader()->hide();
    m_view->verticalHeader()->setDefaultSectionSize(m_view->fontMetrics().height() + 6);
    m_view->horizontalHeader()->setSectionResizeMode(EventModel::Time,
                                                     QHeaderView::ResizeToContents);
    m_view->horizontalHeader()->setSectionResizeMode(EventModel::Event, QHeaderView::Stretch);
    m_view->horizontalHeader()->setDefaultAlignment(Qt::AlignLeft | Qt::AlignVCenter);
    const auto go = [this](const QModelIndex& index) {
        if (index.isValid()) {
            m_timeline.showMark(m_model->mark(index.row()).time);
        }
    };
    connect(m_view, &QTableView::clicked, this, go);
    connect(m_view, &QTableView::activated, this, go);
    connect(&ticker, &FrameTicker::tick, this, [this] {
        if (isVisible()) {
            m_model->refresh();
        }
    });
}

void EventList::showEvent(QShowEvent* event)
{
    QWidget::showEvent(event);
    m_model->refresh();
    m_view->scrollToBottom();
}

} // namespace trex
