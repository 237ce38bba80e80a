// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/connection/lineform.h"

#include "widgets/common/panel.h"

#include <QComboBox>
#include <QEvent>
#include <QFormLayout>
#include <QLabel>
#include <QSpinBox>

#include <array>

namespace trex {

using namespace Qt::Literals::StringLiterals;

namespace {

constexpr int kLongestTimeoutMs = 60'000;
constexpr std::array kEchoKeys{"auto"_L1, "on"_L1, "off"_L1}; // in the order of EchoMode

QString fromKey(std::string_view key)
{
    return QString::fromLatin1(key.data(), static_cast<qsizetype>(key.size()));
}

/// Digits as the device documents write a polynomial: 0x89.
class HexSpinBox : public QSpinBox {
public:
    explicit HexSpinBox(QWidget* parent) : QSpinBox(parent)
    {
        setDisplayIntegerBase(16);
        setPrefix(u"0x"_s);
    }

protected:
    QString textFromValue(int value) const override { return QString::number(value, 16).toUpper(); }
};

void choose(QComboBox* combo, const QVariant& data)
{
    combo->setCurrentIndex(combo->findData(data));
}

} // namespace

LineForm::LineForm(QWidget* parent) : QWidget(parent)
{
    auto* form = new QFormLayout(this);
    form->setContentsMargins(0, 0, 0, 0);
    form->setRowWrapPolicy(QFormLayout::WrapLongRows);
    form->setFieldGrowthPolicy(QFormLayout::AllNonFixedFieldsGrow);
    form->setHorizontalSpacing(8);
    form->setVerticalSpacing(4);
    addMainFields(*form);
    auto* heading = new QLabel(tr("Rarely changed"), this);
    heading->setForegroundRole(QPalette::PlaceholderText);
    heading->setContentsMargins(0, 8, 0, 0);
    form->addRow(heading);
    addRareFields(*form);

    connect(m_errorDetection, &QComboBox::currentIndexChanged, this, &LineForm::updateEnabled);
    connect(m_form, &QComboBox::currentIndexChanged, this, &LineForm::updateEnabled);
    setSettings({});
    updateEnabled();
}

void LineForm::addMainFields(QFormLayout& form)
{
    m_baud = addCombo(form, tr("&Baud rate"), u"connection.baud"_s);
    for (const int baud : kBaudRates) {
        m_baud->addItem(QString::number(baud), baud);
    }
    m_baud->setToolTip(tr("As set in the controller; it leaves the factory with 19200."));

    m_errorDetection = addCombo(form, tr("&Error detection"), u"connection.errorDetection"_s);
    for (const auto& [detection, text] : {std::pair{ErrorDetection::None, tr("None")},
                                          {ErrorDetection::Even, tr("Even parity")},
                                          {ErrorDetection::Odd, tr("Odd parity")},
                                          {ErrorDetection::Crc7, tr("CRC-7")}}) {
        m_errorDetection->addItem(text, fromKey(keyOf(detection)));
    }
    m_errorDetection->setToolTip(tr("As set in the controller; it leaves the factory with none."));

    m_form = addCombo(form, tr("Packet &form"), u"connection.protocol"_s);
    m_form->addItem(tr("Compact"), fromKey(keyOf(PacketForm::Compact)));
    m_form->addItem(tr("Pololu"), fromKey(keyOf(PacketForm::Pololu)));
    m_form->setToolTip(tr("The controller understands both. Pololu packets name the device, for "
                          "several on one line."));

    m_device = addSpin(form, tr("Device &number"), u"connection.device"_s, 0, 127);
    m_device->setToolTip(tr("Only packets in the Pololu form carry it."));
}

void LineForm::addRareFields(QFormLayout& form)
{
    m_polynomial = new HexSpinBox(this);
    m_polynomial->setObjectName(u"connection.polynomial"_s);
    m_polynomial->setRange(0x80, 0xFF);
    m_polynomial->setToolTip(tr("Of CRC-7, most significant bit set; 0x89 unless changed."));
    addRow(form, tr("CRC &polynomial"), m_polynomial);

    m_stopBits = addCombo(form, tr("St&op bits"), u"connection.stopBits"_s);
    m_stopBits->addItem(u"1"_s, 1);
    m_stopBits->addItem(u"2"_s, 2);

    m_echo = addCombo(form, tr("Ec&ho"), u"connection.echo"_s);
    m_echo->addItem(tr("Found out"), kEchoKeys.at(0));
    m_echo->addItem(tr("Line echoes"), kEchoKeys.at(1));
    m_echo->addItem(tr("No echo"), kEchoKeys.at(2));
    m_echo->setToolTip(tr("RS-232 wiring brings back what is sent; those bytes are dropped."));

    m_timeout = addSpin(form, tr("Reply &timeout"), u"connection.timeout"_s, 1, kLongestTimeoutMs);
    m_timeout->setSuffix(tr(" ms"));
    m_timeout->setToolTip(tr("How long to wait for a reply, above its time on the wire."));
}

QComboBox* LineForm::addCombo(QFormLayout& form, const QString& title, const QString& name)
{
    auto* combo = new QComboBox(this);
    combo->setObjectName(name);
    combo->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
    combo->setMinimumContentsLength(8);
    addRow(form, title, combo);
    return combo;
}

QSpinBox* LineForm::addSpin(QFormLayout& form, const QString& title, const QString& name,
                            int minimum, int maximum)
{
    auto* spin = new QSpinBox(this);
    spin->setObjectName(name);
    spin->setRange(minimum, maximum);
    addRow(form, title, spin);
    return spin;
}

void LineForm::addRow(QFormLayout& form, const QString& title, QWidget* field)
{
    QString spoken = title;
    field->setAccessibleName(spoken.remove(u'&'));
    field->setFocusPolicy(Qt::StrongFocus);
    field->installEventFilter(this);
    form.addRow(title, field);
}

LineSettings LineForm::settings() const
{
    LineSettings line;
    line.baud = m_baud->currentData().toInt();
    line.errorDetection = errorDetectionFromKey(m_errorDetection->currentData().toString())
                              .value_or(ErrorDetection::None);
    line.form = packetFormFromKey(m_form->currentData().toString()).value_or(PacketForm::Compact);
    line.device = static_cast<std::uint8_t>(m_device->value());
    line.polynomial = static_cast<std::uint8_t>(m_polynomial->value());
    line.stopBits = m_stopBits->currentData().toInt();
    line.echo = static_cast<EchoMode>(m_echo->currentIndex());
    line.timeout = std::chrono::milliseconds(m_timeout->value());
    return line;
}

void LineForm::setSettings(const LineSettings& settings)
{
    choose(m_baud, settings.baud);
    choose(m_errorDetection, fromKey(keyOf(settings.errorDetection)));
    choose(m_form, fromKey(keyOf(settings.form)));
    m_device->setValue(settings.device);
    m_polynomial->setValue(settings.polynomial);
    choose(m_stopBits, settings.stopBits);
    m_echo->setCurrentIndex(static_cast<int>(settings.echo));
    m_timeout->setValue(static_cast<int>(settings.timeout.count()));
}

void LineForm::updateEnabled()
{
    const LineSettings line = settings();
    m_device->setEnabled(line.form == PacketForm::Pololu);
    m_polynomial->setEnabled(line.hasCrc());
}

/// A wheel that scrolls the panel must not change a field that it passes over.
bool LineForm::eventFilter(QObject* watched, QEvent* event)
{
    const auto* field = qobject_cast<QWidget*>(watched);
    if (event->type() == QEvent::Wheel && field != nullptr && !field->hasFocus()) {
        event->ignore();
        return true;
    }
    return QWidget::eventFilter(watched, event);
}

} // namespace trex
