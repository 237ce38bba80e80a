// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/parameters/choicefield.h"

#include <QComboBox>
#include <QSignalBlocker>

using namespace Qt::Literals::StringLiterals;

namespace trex {
namespace {

/// QComboBox keeps the least width that its first texts needed, and does not shrink with them.
class FittingBox : public QComboBox {
public:
    using QComboBox::QComboBox;
    QSize minimumSizeHint() const override { return sizeHint(); }
};

} // namespace

QComboBox* ChoiceField::newBox(QWidget* parent)
{
    auto* const box = new FittingBox(parent);
    box->setPlaceholderText(u"–"_s);
    box->setSizeAdjustPolicy(QComboBox::AdjustToContents);
    constexpr int kWidest = 250;
    box->setMaximumWidth(kWidest);
    return box;
}

void ChoiceField::choose(QComboBox* box, int data)
{
    const QSignalBlocker blocker(box);
    box->setCurrentIndex(box->findData(data));
}

ChoiceField::ChoiceField(const ParameterRow& row, QWidget* parent)
    : ParameterField(row, parent), m_box(newBox(this))
{
    for (int raw = row.minimum; raw <= row.maximum; ++raw) {
        m_box->addItem(parameterText(row, raw), raw);
    }
    m_known = m_box->count();
    addPart(m_box, {});
    connect(m_box, &QComboBox::activated, this,
            [this] { emit edited(m_box->currentData().toInt()); });
}

void ChoiceField::setContext(const ValueContext& context)
{
    for (int i = 0; i < m_known; ++i) {
        m_box->setItemText(i, valueText(row(), m_box->itemData(i).toInt(), context));
    }
}

void ChoiceField::display(std::optional<int> raw)
{
    // What a controller says beyond the table is shown as it is (conformance C-59).
    while (m_box->count() > m_known) {
        m_box->removeItem(m_known);
    }
    if (raw && m_box->findData(*raw) < 0) {
        m_box->addItem(QString::number(*raw), *raw);
    }
    choose(m_box, raw.value_or(-1));
}

} // namespace trex
