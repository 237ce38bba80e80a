// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/parameters/parameterfield.h"

#include "widgets/common/theme.h"
#include "widgets/parameters/channelbitsfield.h"
#include "widgets/parameters/choicefield.h"
#include "widgets/parameters/rawspinbox.h"
#include "widgets/parameters/uartfield.h"

#include <QCoreApplication>
#include <QHBoxLayout>
#include <QLabel>
#include <QWheelEvent>

using namespace Qt::Literals::StringLiterals;

namespace trex {
namespace {

/// The mouse wheel scrolls the table; it turns a control only when that has the focus.
class WheelGuard : public QObject {
public:
    using QObject::QObject;
    bool eventFilter(QObject* watched, QEvent* event) override
    {
        const auto* const widget = qobject_cast<QWidget*>(watched);
        if (event->type() == QEvent::Wheel && widget != nullptr && !widget->hasFocus()) {
            event->ignore();
            return true;
        }
        return QObject::eventFilter(watched, event);
    }
};

/// A number in its unit, or the CRC polynomial.
class NumberField : public ParameterField {
public:
    NumberField(const ParameterRow& row, QWidget* parent)
        : ParameterField(row, parent), m_box(new RawSpinBox(row, this))
    {
        addPart(m_box, {});
        connect(m_box, &QSpinBox::valueChanged, this, &ParameterField::edited);
        connect(m_box, &RawSpinBox::remarked, this, &ParameterField::remarked);
    }
    void setContext(const ValueContext& context) override { m_box->setModel(context.model); }

protected:
    void display(std::optional<int> raw) override { m_box->showRaw(raw); }
    QString storedText(int raw) const override
    {
        // The full polynomial is shown, without its top bit it is stored (facts.md 2, 0x7D).
        return row().editor == ParameterEditor::Polynomial
            ? QCoreApplication::translate("ParameterField", "stored %1").arg(hexText(raw))
            : ParameterField::storedText(raw);
    }

private:
    RawSpinBox* m_box;
};

} // namespace

ParameterField* ParameterField::make(const ParameterRow& row, QWidget* parent)
{
    switch (row.editor) {
    case ParameterEditor::ChannelBits:
        return new ChannelBitsField(row, parent);
    case ParameterEditor::Toggle:
    case ParameterEditor::Choice:
    case ParameterEditor::Prescaler:
        return new ChoiceField(row, parent);
    case ParameterEditor::UartSettings:
        return new UartField(row, parent);
    case ParameterEditor::Number:
    case ParameterEditor::Polynomial:
    case ParameterEditor::Trigger:
        break;
    }
    return new NumberField(row, parent);
}

ParameterField::ParameterField(const ParameterRow& row, QWidget* parent)
    : QWidget(parent), m_row(row), m_stored(new QLabel(this))
{
    auto* const layout = new QHBoxLayout(this);
    layout->setContentsMargins(4, 1, 4, 1);
    layout->setSpacing(4);
    layout->addWidget(m_stored);
    layout->addStretch();
    m_stored->setForegroundRole(QPalette::PlaceholderText);
    m_stored->setFont(theme::font(1.0, true));
    m_stored->setToolTip(QCoreApplication::translate(
        "ParameterField", "The number as the controller stores it (raw)"));
}

void ParameterField::addPart(QWidget* part, const QString& accessibleName)
{
    const QString title = QCoreApplication::translate("Parameters", m_row.title);
    part->setAccessibleName(accessibleName.isEmpty() ? title
                                                     : u"%1, %2"_s.arg(title, accessibleName));
    part->setFocusPolicy(Qt::StrongFocus);
    part->installEventFilter(new WheelGuard(part));
    if (focusProxy() == nullptr) {
        setFocusProxy(part);
    }
    auto* const box = static_cast<QHBoxLayout*>(layout());
    box->insertWidget(box->count() - 2, part);
}

QString ParameterField::storedText(int raw) const
{
    const QString number = QString::number(raw);
    return valueText(m_row, raw, {}) == number ? QString() : u"(%1)"_s.arg(number);
}

void ParameterField::refreshStored()
{
    m_stored->setText(m_raw < 0 ? QString() : storedText(m_raw));
}

void ParameterField::useWords(Words words)
{
    setWords(words);
    layout()->invalidate(); // a control that was never shown does not ask for it
    layout()->update();
}

int ParameterField::widestHint()
{
    const QString stored = m_stored->text();
    m_stored->setText(storedText(m_row.maximum));
    layout()->invalidate();
    const int width = layout()->sizeHint().width();
    m_stored->setText(stored);
    return width;
}

void ParameterField::showRaw(std::optional<int> raw)
{
    const bool isOther = m_raw != raw.value_or(-1);
    m_raw = raw.value_or(-1);
    display(raw);
    refreshStored();
    if (isOther) {
        emit rawChanged(m_raw);
    }
}

} // namespace trex
