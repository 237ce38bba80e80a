// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/parameters/differencesdialog.h"

#include "protocol/session/controller.h"
#include "widgets/common/fitting.h"
#include "widgets/common/panel.h"
#include "widgets/common/stopbutton.h"
#include "widgets/common/theme.h"

#include <QBoxLayout>
#include <QCheckBox>
#include <QDialogButtonBox>
#include <QHeaderView>
#include <QLabel>
#include <QPushButton>
#include <QTreeWidget>

#include <algorithm>

using namespace Qt::Literals::StringLiterals;

namespace trex {
namespace {

QPushButton* newButton(const QString& part, const QString& text, QWidget* parent)
{
    auto* const button = named(new QPushButton(text, parent), u"parameters.differences."_s + part);
    button->setAutoDefault(false);
    return button;
}

} // namespace

DifferencesDialog::DifferencesDialog(Controller& controller, const QString& fileName,
                                     const QStringList& remarks,
                                     const std::vector<FileDifference>& differences,
                                     QWidget* parent)
    : QDialog(parent), m_count(named(new QLabel(this), u"parameters.differences.count"_s))
{
    setObjectName(u"parameters.differences"_s);
    setWindowTitle(tr("Differences in %1").arg(fileName));
    setAttribute(Qt::WA_DeleteOnClose);
    auto* const text = named(
        new QLabel(tr("Leave out what should stay as it is in the controller. Nothing is written "
                      "before Apply."),
                   this),
        u"parameters.differences.text"_s);
    text->setWordWrap(true);
    auto* const table =
        named(new QTreeWidget(this), u"parameters.differences.table"_s, tr("Differences"));
    table->setRootIsDecorated(false);
    table->setSelectionMode(QAbstractItemView::NoSelection); // the boxes are what is chosen
    table->setFocusPolicy(Qt::NoFocus);
    table->setHeaderLabels({tr("Take"), tr("Setting"), tr("In controller"), tr("In the file")});
    for (const auto& each : differences) {
        auto* const item = new QTreeWidgetItem(
            table, QStringList{QString(), each.title, each.inController, each.inFile});
        auto* const box = named(new QCheckBox(each.key, table),
                                u"parameters.differences."_s + each.key, each.title);
        box->setChecked(true);
        table->setItemWidget(item, 0, box);
        const int index = static_cast<int>(m_boxes.size());
        m_boxes.push_back(box);
        connect(box, &QCheckBox::toggled, this, [this, index](bool isTaken) {
            emit taken(index, isTaken);
            refreshCount();
        });
    }
    for (int column = 0; column < table->columnCount(); ++column) {
        constexpr int kGap = 16;
        table->resizeColumnToContents(column);
        table->setColumnWidth(column, table->columnWidth(column) + kGap);
    }
    auto* const all = newButton(u"all"_s, tr("Take &all"), this);
    auto* const none = newButton(u"none"_s, tr("Take &none"), this);
    auto* const buttons =
        new QDialogButtonBox(QDialogButtonBox::Ok | QDialogButtonBox::Cancel, this);
    buttons->button(QDialogButtonBox::Ok)->setText(tr("&Keep these as edits"));
    buttons->button(QDialogButtonBox::Cancel)->setText(tr("&Leave all"));
    buttons->addButton(all, QDialogButtonBox::ActionRole);
    buttons->addButton(none, QDialogButtonBox::ActionRole);

    auto* const top = new QHBoxLayout;
    top->addWidget(text, 1);
    top->addWidget(named(new StopButton(controller, this), u"parameters.differences.stop"_s));
    auto* const layout = new QVBoxLayout(this);
    layout->addLayout(top);
    layout->addWidget(table, 1);
    if (!remarks.isEmpty()) {
        auto* const said = named(new QLabel(u"▲ "_s + remarks.join(u"\n▲ "_s), this),
                                 u"parameters.differences.remarks"_s);
        said->setTextFormat(Qt::PlainText);
        said->setWordWrap(true);
        theme::setTextColour(*said, ColourRole::Warning);
        layout->addWidget(said);
    }
    layout->addWidget(m_count);
    layout->addWidget(buttons);
    constexpr int kAround = 48; // margins, and a scroll bar
    resizeToFit(*this, {std::clamp(table->header()->length() + kAround, 720, 1100), 440});
    connect(all, &QPushButton::clicked, this, [this] { takeAll(true); });
    connect(none, &QPushButton::clicked, this, [this] { takeAll(false); });
    connect(buttons, &QDialogButtonBox::accepted, this, &QDialog::accept);
    connect(buttons, &QDialogButtonBox::rejected, this, [this] {
        takeAll(false);
        reject();
    });
    refreshCount();
}

void DifferencesDialog::takeAll(bool isTaken)
{
    for (auto* const box : m_boxes) {
        box->setChecked(isTaken);
    }
}

void DifferencesDialog::refreshCount()
{
    const auto taken = std::ranges::count_if(m_boxes, &QCheckBox::isChecked);
    m_count->setText(tr("%1 of %2 are taken.").arg(taken).arg(m_boxes.size()));
}

} // namespace trex
