// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/parameters/parameterfield.h"

#include "protocol/codec/linesettings.h"
#include "widgets/common/theme.h"
#include "widgets/parameters/rawspinbox.h"

#include <QCheckBox>
#include <QComboBox>
#include <QCoreApplication>
#include <QHBoxLayout>
#include <QLabel>
#include <QSignalBlocker>
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

class NumberField : public ParameterField {
public:
    NumberField(const ParameterRow& row, QWidget* parent)
        : ParameterField(row, parent), m_box(new RawSpinBox(row, this))
    {
        addPart(m_box, {});
        connect(m_box, &QSpinBox::valueChanged, this, &ParameterField::edited);
    }

protected:
    void display(std::optional<int> raw) override { m_box->showRaw(raw); }

private:
    RawSpinBox* m_box;
};

/// Chooses by the items' data; −1 shows an en dash.
void choose(QComboBox* box, int data)
{
    const QSignalBlocker blocker(box);
    box->setCurrentIndex(box->findData(data));
}

QComboBox* newChoice(QWidget* parent)
{
    auto* const box = new QComboBox(parent);
    box->setPlaceholderText(u"–"_s);
    box->setSizeAdjustPolicy(QComboBox::AdjustToContents);
    constexpr int kWidest = 210;
    box->setMaximumWidth(kWidest);
    return box;
}

class ChoiceField : public ParameterField {
public:
    ChoiceField(const ParameterRow& row, QWidget* parent)
        : ParameterField(row, parent), m_box(newChoice(this))
    {
        for (int raw = row.minimum; raw <= row.maximum; ++raw) {
            m_box->addItem(parameterText(row, raw), raw);
        }
        m_known = m_box->count();
        addPart(m_box, {});
        connect(m_box, &QComboBox::activated, this,
                [this] { emit edited(m_box->currentData().toInt()); });
    }

protected:
    void display(std::optional<int> raw) override
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

private:
    QComboBox* m_box;
    int m_known = 0;
};

class BitsField : public ParameterField {
public:
    BitsField(const ParameterRow& row, QWidget* parent) : ParameterField(row, parent)
    {
        for (int channel = 1; channel <= kChannelCount; ++channel) {
            auto* const box = new QCheckBox(QString::number(channel), this);
            addPart(box, QCoreApplication::translate("ParameterField", "channel %1").arg(channel));
            connect(box, &QCheckBox::clicked, this, &BitsField::onClicked);
            m_boxes.push_back(box);
        }
    }

protected:
    void display(std::optional<int> raw) override
    {
        for (std::size_t i = 0; i < m_boxes.size(); ++i) {
            m_boxes[i]->setTristate(!raw);
            m_boxes[i]->setCheckState(!raw                       ? Qt::PartiallyChecked
                                          : (*raw >> i & 1) != 0 ? Qt::Checked
                                                                 : Qt::Unchecked);
        }
    }

private:
    void onClicked()
    {
        int mask = 0;
        for (std::size_t i = 0; i < m_boxes.size(); ++i) {
            mask |= m_boxes[i]->isChecked() ? 1 << i : 0;
        }
        emit edited(mask);
    }
    std::vector<QCheckBox*> m_boxes;
};

/// Parameter 0x7E, composed of its three parts (facts.md 2.3).
class UartField : public ParameterField {
public:
    UartField(const ParameterRow& row, QWidget* parent)
        : ParameterField(row, parent)
        , m_baud(newChoice(this))
        , m_detection(newChoice(this))
        , m_stopBits(newChoice(this))
    {
        for (const int baud : kBaudRates) {
            m_baud->addItem(QString::number(baud), baudIndex(baud));
        }
        const std::pair<ErrorDetection, QString> kinds[] = {
            {ErrorDetection::None, QCoreApplication::translate("ParameterField", "no check")},
            {ErrorDetection::Even, QCoreApplication::translate("ParameterField", "even")},
            {ErrorDetection::Odd, QCoreApplication::translate("ParameterField", "odd")},
            {ErrorDetection::Crc7, QCoreApplication::translate("ParameterField", "CRC-7")}};
        for (const auto& [kind, title] : kinds) {
            m_detection->addItem(title, static_cast<int>(kind));
        }
        m_stopBits->addItem(QCoreApplication::translate("ParameterField", "1 stop"), 1);
        m_stopBits->addItem(QCoreApplication::translate("ParameterField", "2 stop"), 2);
        addPart(m_baud, QCoreApplication::translate("ParameterField", "baud rate"));
        addPart(m_detection, QCoreApplication::translate("ParameterField", "error detection"));
        addPart(m_stopBits, QCoreApplication::translate("ParameterField", "stop bits"));
        for (auto* const box : {m_baud, m_detection, m_stopBits}) {
            connect(box, &QComboBox::activated, this, &UartField::onActivated);
        }
    }

protected:
    void display(std::optional<int> raw) override
    {
        const auto settings = raw ? UartSettings::fromRaw(*raw) : std::nullopt;
        choose(m_baud, settings ? settings->baudIndex : -1);
        choose(m_detection, settings ? static_cast<int>(settings->errorDetection) : -1);
        choose(m_stopBits, settings ? settings->stopBits : -1);
    }

private:
    void onActivated()
    {
        UartSettings settings; // parts that are not known yet start from the factory's
        if (m_baud->currentIndex() >= 0) {
            settings.baudIndex = m_baud->currentData().toInt();
        }
        if (m_detection->currentIndex() >= 0) {
            settings.errorDetection =
                static_cast<ErrorDetection>(m_detection->currentData().toInt());
        }
        if (m_stopBits->currentIndex() >= 0) {
            settings.stopBits = m_stopBits->currentData().toInt();
        }
        emit edited(settings.toRaw());
    }
    QComboBox* m_baud;
    QComboBox* m_detection;
    QComboBox* m_stopBits;
};

} // namespace

ParameterField* ParameterField::make(const ParameterRow& row, QWidget* parent)
{
    switch (row.editor) {
    case ParameterEditor::ChannelBits:
        return new BitsField(row, parent);
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
    : QWidget(parent), m_row(row), m_rawText(new QLabel(this))
{
    auto* const layout = new QHBoxLayout(this);
    layout->setContentsMargins(4, 1, 4, 1);
    layout->setSpacing(4);
    layout->addWidget(m_rawText);
    layout->addStretch();
    m_rawText->setForegroundRole(QPalette::PlaceholderText);
    m_rawText->setFont(theme::font(1.0, true));
    m_rawText->setToolTip(QCoreApplication::translate(
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

void ParameterField::showRaw(std::optional<int> raw)
{
    display(raw);
    const QString number = QString::number(raw.value_or(-1));
    const bool saysMore = raw && parameterText(m_row, *raw) != number;
    m_rawText->setText(saysMore ? u"(%1)"_s.arg(number) : QString());
    if (m_raw != raw.value_or(-1)) {
        m_raw = raw.value_or(-1);
        emit rawChanged(m_raw);
    }
}

} // namespace trex
