// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/plots/comparelist.h"

#include "widgets/common/panel.h"
#include "widgets/common/theme.h"

#include <QCheckBox>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QLineEdit>
#include <QPainter>
#include <QScrollArea>
#include <QToolButton>
#include <QVBoxLayout>

namespace trex {

using namespace Qt::Literals::StringLiterals;

namespace {

struct AlignmentRow {
    Alignment alignment;
    const char* title;
};
// clang-format off
constexpr std::array kAlignments{
    AlignmentRow{Alignment::View,    QT_TRANSLATE_NOOP("trex::CompareList", "fixed in the view")},
    AlignmentRow{Alignment::Start,   QT_TRANSLATE_NOOP("trex::CompareList", "by time, start on start")},
    AlignmentRow{Alignment::Trigger, QT_TRANSLATE_NOOP("trex::CompareList", "by the trigger")},
    AlignmentRow{Alignment::Command, QT_TRANSLATE_NOOP("trex::CompareList", "by the command step")},
};
// clang-format on

constexpr double kMostSeconds = 1e6;

/// As PlotView draws the run's curves: the first dashed, the second dotted, the third both.
class DashSample : public QWidget {
public:
    DashSample(std::size_t run, QWidget* parent) : QWidget(parent), m_run(run)
    {
        setFixedSize(30, 16);
    }

protected:
    void paintEvent(QPaintEvent*) override
    {
        static const std::array<QList<qreal>, 3> kDashes{
            QList<qreal>{3.5, 2.0}, QList<qreal>{1.0, 1.5}, QList<qreal>{4.5, 1.5, 1.0, 1.5}};
        QPainter painter(this);
        QPen pen(theme::colour(ColourRole::Text), 2.0, Qt::CustomDashLine, Qt::FlatCap);
        pen.setDashPattern(kDashes.at(m_run % kDashes.size()));
        painter.setPen(pen);
        painter.drawLine(1, height() / 2, width() - 1, height() / 2);
    }

private:
    std::size_t m_run;
};

} // namespace

CompareList::CompareList(PlotReferences& references, QWidget* parent)
    : QWidget(parent)
    , m_references(references)
    , m_alignment(named(new QComboBox(this), u"plots.compare.alignment"_s, tr("Alignment")))
    , m_empty(new QLabel(tr("Nothing to compare with. Freeze what the plots show now, or open a "
                            "recording."),
                         this))
    , m_list(new QVBoxLayout)
{
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(4, 4, 4, 4);
    layout->setSpacing(6);
    auto* freeze = named(new QToolButton(this), u"plots.compare.freeze"_s, tr("Freeze the view"));
    freeze->setText(tr("Freeze the view"));
    freeze->setIcon(theme::icon(u"pause"_s));
    freeze->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
    freeze->setToolTip(tr("Keep what the plots show now as a reference behind the curves"));
    connect(freeze, &QToolButton::clicked, this, &CompareList::freezeRequested);
    layout->addWidget(freeze, 0, Qt::AlignLeft);
    auto* row = new QHBoxLayout;
    row->addWidget(new QLabel(tr("Align"), this));
    for (const AlignmentRow& each : kAlignments) {
        m_alignment->addItem(tr(each.title), int(each.alignment));
    }
    row->addWidget(m_alignment, 1);
    layout->addLayout(row);
    m_empty->setWordWrap(true);
    theme::setTextColour(*m_empty, ColourRole::DimText);
    layout->addWidget(m_empty);
    m_list->setSpacing(8);
    layout->addLayout(m_list);
    layout->addStretch(1);
    connect(m_alignment, &QComboBox::activated, this,
            [this] { m_references.setAlignment(Alignment(m_alignment->currentData().toInt())); });
    connect(&references, &PlotReferences::changed, this, &CompareList::refresh);
    connect(&references, &PlotReferences::moved, this, &CompareList::refresh);
    rebuild();
}

QWidget* CompareList::makeRow(std::size_t index)
{
    const PlotReferences::Run& run = m_references.runs()[index];
    const int id = run.id;
    const QString name = u"plots.compare.run%1"_s.arg(id);
    auto* widget = new QWidget(this);
    auto* layout = new QVBoxLayout(widget);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(2);
    auto* first = new QHBoxLayout;
    first->setSpacing(4);
    auto* shown = named(new QCheckBox(widget), name + u".shown"_s, tr("Show %1").arg(run.name));
    shown->setChecked(run.isVisible);
    auto* title = named(new QLineEdit(run.name, widget), name + u".name"_s, tr("Name of the run"));
    title->setFrame(false);
    auto* remove =
        named(new QToolButton(widget), name + u".remove"_s, tr("Remove %1").arg(run.name));
    remove->setIcon(theme::icon(u"cancel"_s));
    remove->setAutoRaise(true);
    remove->setToolTip(tr("No longer compare with it"));
    first->addWidget(shown);
    first->addWidget(new DashSample(index, widget));
    first->addWidget(title, 1);
    first->addWidget(remove);
    auto* second = new QHBoxLayout;
    auto* offset =
        named(new QDoubleSpinBox(widget), name + u".offset"_s, tr("Shift of %1").arg(run.name));
    offset->setRange(-kMostSeconds, kMostSeconds);
    offset->setDecimals(3);
    offset->setSingleStep(0.01);
    offset->setSuffix(u" s"_s);
    offset->setValue(std::chrono::duration<double>(run.offset).count());
    auto* note = new QLabel(widget);
    theme::setTextColour(*note, ColourRole::DimText);
    second->addWidget(new QLabel(tr("Shift"), widget));
    second->addWidget(offset);
    second->addWidget(note, 1);
    layout->addLayout(first);
    layout->addLayout(second);
    connect(shown, &QCheckBox::toggled, this,
            [this, id](bool isShown) { m_references.setVisible(id, isShown); });
    connect(title, &QLineEdit::editingFinished, this,
            [this, id, title] { m_references.rename(id, title->text()); });
    connect(remove, &QToolButton::clicked, this, [this, id] { m_references.remove(id); });
    connect(offset, &QDoubleSpinBox::valueChanged, this, [this, id](double seconds) {
        m_references.setOffset(
            id, std::chrono::duration_cast<Duration>(std::chrono::duration<double>(seconds)));
    });
    m_rows.push_back({id, widget, note});
    return widget;
}

void CompareList::rebuild()
{
    for (const Row& row : m_rows) {
        row.widget->hide();
        row.widget->deleteLater(); // one of its buttons may be what asked
    }
    m_rows.clear();
    for (std::size_t i = 0; i < m_references.runs().size(); ++i) {
        m_list->addWidget(makeRow(i));
    }
    m_empty->setVisible(m_rows.empty());
    refresh();
}

void CompareList::refresh()
{
    m_alignment->setCurrentIndex(m_alignment->findData(int(m_references.alignment())));
    const auto& runs = m_references.runs();
    bool isSame = runs.size() == m_rows.size();
    for (std::size_t i = 0; isSame && i < runs.size(); ++i) {
        isSame = runs[i].id == m_rows[i].id;
    }
    if (!isSame) {
        rebuild();
        return;
    }
    for (std::size_t i = 0; i < runs.size(); ++i) {
        m_rows[i].note->setText(
            m_references.shiftOf(runs[i]) ? QString() : tr("cannot be aligned: no such moment"));
    }
}

} // namespace trex
