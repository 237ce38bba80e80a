// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/common/measurementview.h"

#include "protocol/telemetry/streamtable.h"
#include "widgets/common/frameticker.h"
#include "widgets/common/panel.h"
#include "widgets/common/plotview.h"

#include <QClipboard>
#include <QCoreApplication>
#include <QGuiApplication>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QLabel>
#include <QTableView>
#include <QToolButton>
#include <QVBoxLayout>

#include <algorithm>
#include <cmath>

namespace trex {

using namespace Qt::Literals::StringLiterals;

namespace {

constexpr int kTicksBetween = 3; ///< digits that change faster cannot be read
constexpr int kMostRows = 6; ///< without scrolling
constexpr int kFewestRows = 2;
constexpr double kMostHeight = 0.3; ///< of the panel: the plots are what one looks at

// clang-format off
constexpr std::array kHeaders{
    QT_TRANSLATE_NOOP("trex::MeasurementModel", "Curve"),   QT_TRANSLATE_NOOP("trex::MeasurementModel", "A"),
    QT_TRANSLATE_NOOP("trex::MeasurementModel", "B"),       QT_TRANSLATE_NOOP("trex::MeasurementModel", "B − A"),
    QT_TRANSLATE_NOOP("trex::MeasurementModel", "Min"), QT_TRANSLATE_NOOP("trex::MeasurementModel", "Mean"),
    QT_TRANSLATE_NOOP("trex::MeasurementModel", "RMS"),     QT_TRANSLATE_NOOP("trex::MeasurementModel", "Max"),
    QT_TRANSLATE_NOOP("trex::MeasurementModel", "Charge"),  QT_TRANSLATE_NOOP("trex::MeasurementModel", "Samples"),
};
// clang-format on
static_assert(kHeaders.size() == MeasurementModel::Columns);

double secondsOf(Duration duration)
{
    return std::chrono::duration<double>(duration).count();
}

} // namespace

MeasurementModel::Row MeasurementModel::rowOf(const PlotFrame::Curve& curve,
                                              const PlotTimeline& timeline)
{
    Row row;
    row.stream = curve.stream;
    row.colour = curve.colour;
    const StreamRow& stream = streams()[static_cast<std::size_t>(curve.stream)];
    row.texts[Curve] = QCoreApplication::translate("Streams", stream.title);
    if (stream.source == Source(PollId::Currents)) {
        row.texts[Curve] = QCoreApplication::translate("Plots", "%1 current").arg(row.texts[Curve]);
    }
    const auto text = [&](double physical, int extra) {
        return valueText(physical, curve.decimals + extra, curve.unit);
    };
    std::array<std::optional<double>, 2> values;
    for (std::size_t i = 0; i < values.size(); ++i) {
        const auto cursor = timeline.cursor(static_cast<int>(i));
        const auto sample =
            cursor ? sampleAt(*curve.series, *cursor) : std::optional<std::size_t>();
        if (sample) {
            values.at(i) = curve.scale.physical(curve.series->value(*sample));
        }
        row.texts.at(AtA + i) = values.at(i) ? text(*values.at(i), 0) : cursor ? u"–"_s : QString();
    }
    if (values[0] && values[1]) {
        row.texts[Difference] = text(*values[1] - *values[0], 0);
    }
    const auto range = timeline.measured();
    const auto found = range ? trex::measure(*curve.series, curve.scale, range->from, range->to)
                             : std::optional<Measurement>();
    if (found) {
        // One decimal more than a sample has: a mean is finer than what it is made of.
        row.texts[Minimum] = text(found->minimum, 0);
        row.texts[Mean] = text(found->mean, 1);
        row.texts[Rms] = text(found->rms, 1);
        row.texts[Maximum] = text(found->maximum, 0);
        row.texts[Samples] = QString::number(found->samples);
        if (found->integral && curve.unit == u'A') {
            row.texts[Charge] = valueText(milliampereHours(*found->integral), 3, u"mAh"_s);
        }
    }
    return row;
}

void MeasurementModel::measure(const PlotTimeline& timeline,
                               const std::vector<const PlotView*>& plots)
{
    std::vector<Row> rows;
    for (const PlotView* plot : plots) {
        for (const PlotFrame::Curve& curve : plot->frame().curves) {
            const bool isThere = std::any_of(rows.begin(), rows.end(), [&](const Row& row) {
                return row.stream == curve.stream;
            });
            if (curve.isVisible && !isThere) {
                rows.push_back(rowOf(curve, timeline));
            }
        }
    }
    if (rows.size() != m_rows.size()) {
        beginResetModel();
        m_rows = std::move(rows);
        endResetModel();
    } else if (rows != m_rows) {
        m_rows = std::move(rows);
        emit dataChanged(index(0, 0), index(rowCount() - 1, Columns - 1));
    }
}

int MeasurementModel::rowCount(const QModelIndex& parent) const
{
    return parent.isValid() ? 0 : static_cast<int>(m_rows.size());
}

int MeasurementModel::columnCount(const QModelIndex& parent) const
{
    return parent.isValid() ? 0 : Columns;
}

QVariant MeasurementModel::data(const QModelIndex& index, int role) const
{
    if (!index.isValid()) {
        return {};
    }
    const Row& row = m_rows.at(static_cast<std::size_t>(index.row()));
    switch (role) {
    case Qt::DisplayRole:
        return row.texts.at(static_cast<std::size_t>(index.column()));
    case Qt::TextAlignmentRole:
        return QVariant(Qt::AlignVCenter
                        | (index.column() == Curve ? Qt::AlignLeft : Qt::AlignRight));
    case Qt::ForegroundRole:
        return index.column() == Curve ? QVariant(row.colour) : QVariant();
    default:
        return {};
    }
}

QVariant MeasurementModel::headerData(int section, Qt::Orientation orientation, int role) const
{
    if (orientation != Qt::Horizontal) {
        return {};
    }
    if (role == Qt::TextAlignmentRole) {
        return QVariant(Qt::AlignVCenter | (section == Curve ? Qt::AlignLeft : Qt::AlignRight));
    }
    return role == Qt::DisplayRole ? QVariant(tr(kHeaders.at(static_cast<std::size_t>(section))))
                                   : QVariant();
}

QString MeasurementModel::asText() const
{
    QStringList lines;
    QStringList header;
    for (int column = 0; column < Columns; ++column) {
        header += headerData(column, Qt::Horizontal, Qt::DisplayRole).toString();
    }
    lines += header.join(u'\t');
    for (const Row& row : m_rows) {
        lines += QStringList(row.texts.begin(), row.texts.end()).join(u'\t');
    }
    return lines.join(u'\n') + u'\n';
}

MeasurementView::MeasurementView(PlotTimeline& timeline, FrameTicker& ticker, const QString& name,
                                 QWidget* parent)
    : QWidget(parent)
    , m_timeline(timeline)
    , m_model(new MeasurementModel(this))
    , m_times(named(new QLabel(this), name + u".times"_s, tr("Times of the cursors")))
    , m_table(named(new QTableView(this), name + u".table"_s, tr("Values at the cursors")))
{
    setObjectName(name);
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(2);
    auto* head = new QHBoxLayout;
    head->setContentsMargins(8, 2, 0, 0);
    head->addWidget(m_times, 1);
    auto* copyButton = named(new QToolButton(this), name + u".copy"_s, tr("Copy table"));
    copyButton->setIcon(theme::icon(u"copy"_s));
    copyButton->setAutoRaise(true);
    copyButton->setToolTip(tr("Copy the table, for a spreadsheet"));
    connect(copyButton, &QToolButton::clicked, this, &MeasurementView::copy);
    auto* clear = named(new QToolButton(this), name + u".clear"_s, tr("Remove the cursors"));
    clear->setIcon(theme::icon(u"cancel"_s));
    clear->setAutoRaise(true);
    clear->setToolTip(tr("Remove the cursors"));
    connect(clear, &QToolButton::clicked, &timeline, &PlotTimeline::clearCursors);
    head->addWidget(copyButton);
    head->addWidget(clear);
    layout->addLayout(head);
    layout->addWidget(m_table);
    m_table->setModel(m_model);
    m_table->setFrameShape(QFrame::NoFrame);
    m_table->setShowGrid(false);
    m_table->setSelectionMode(QAbstractItemView::NoSelection);
    m_table->setFocusPolicy(Qt::TabFocus);
    m_table->verticalHeader()->hide();
    m_table->horizontalHeader()->setSectionResizeMode(QHeaderView::ResizeToContents);
    m_table->horizontalHeader()->setSectionResizeMode(0, QHeaderView::Stretch);
    m_table->horizontalHeader()->setHighlightSections(false);
    m_table->setVerticalScrollMode(QAbstractItemView::ScrollPerPixel);
    applyTheme();
    hide();
    connect(&timeline, &PlotTimeline::cursorsChanged, this, &MeasurementView::update);
    connect(&ticker, &FrameTicker::tick, this, [this] {
        if (isVisible() && ++m_ticks % kTicksBetween == 0
            && m_timeline.store().revision() != m_revision) {
            update();
        }
    });
}

void MeasurementView::setPlots(std::vector<const PlotView*> plots)
{
    m_plots = std::move(plots);
    update();
}

void MeasurementView::applyTheme()
{
    m_times->setFont(theme::font(1.0, true));
    m_table->setFont(theme::font(1.0, true));
    const int row = m_table->fontMetrics().height() + 4;
    m_table->verticalHeader()->setDefaultSectionSize(row);
    m_table->verticalHeader()->setMinimumSectionSize(row);
}

void MeasurementView::update()
{
    m_revision = m_timeline.store().revision();
    const auto first = m_timeline.cursor(0);
    const auto second = m_timeline.cursor(1);
    setVisible(first.has_value() || second.has_value());
    if (!isVisibleTo(parentWidget())) {
        return;
    }
    QStringList times;
    const auto add = [&](const QString& name, const std::optional<Instant>& time) {
        if (time) {
            times += name + u' '
                + ticks::timeLabel(std::round(secondsOf(*time - m_timeline.origin()) * 1000) / 1000,
                                   0.001);
        }
    };
    add(u"A"_s, first);
    add(u"B"_s, second);
    if (const auto range = m_timeline.measured()) {
        const double seconds = secondsOf(range->to - range->from);
        times += u"Δt %1 s"_s.arg(seconds, 0, 'f', 3);
        if (seconds > 0.0) {
            times += u"1/Δt %1 Hz"_s.arg(1.0 / seconds, 0, 'f', seconds < 1.0 ? 2 : 4);
        }
    }
    m_times->setText(times.join(u"    "_s));
    m_model->measure(m_timeline, m_plots);
    const double room = kMostHeight * parentWidget()->height();
    const int fitting =
        std::clamp(static_cast<int>(room / m_table->verticalHeader()->defaultSectionSize()),
                   kFewestRows, kMostRows);
    const int rows = std::min(m_model->rowCount(), fitting);
    m_table->setFixedHeight(m_table->horizontalHeader()->sizeHint().height()
                            + rows * m_table->verticalHeader()->defaultSectionSize() + 2);
}

void MeasurementView::copy() const
{
    QGuiApplication::clipboard()->setText(m_times->text() + u'\n' + m_model->asText());
}

} // namespace trex
