// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/parameters/uartfield.h"

#include "protocol/codec/linesettings.h"
#include "widgets/parameters/choicefield.h"

#include <QComboBox>
#include <QCoreApplication>

using namespace Qt::Literals::StringLiterals;

namespace trex {

UartField::UartField(const ParameterRow& row, QWidget* parent)
    : ParameterField(row, parent)
    , m_baud(ChoiceField::newBox(this))
    , m_detection(ChoiceField::newBox(this))
    , m_stopBits(ChoiceField::newBox(this))
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

void UartField::setWords(Words words)
{
    m_detection->setItemText(m_detection->findData(static_cast<int>(ErrorDetection::None)),
                             words == Words::Shortest
                                 ? QCoreApplication::translate("ParameterField", "none")
                                 : QCoreApplication::translate("ParameterField", "no check"));
}

void UartField::display(std::optional<int> raw)
{
    const auto settings = raw ? UartSettings::fromRaw(*raw) : std::nullopt;
    ChoiceField::choose(m_baud, settings ? settings->baudIndex : -1);
    ChoiceField::choose(m_detection, settings ? static_cast<int>(settings->errorDetection) : -1);
    ChoiceField::choose(m_stopBits, settings ? settings->stopBits : -1);
}

QString UartField::storedText(int raw) const
{
    return u"= %1"_s.arg(hexText(raw));
}

void UartField::onActivated()
{
    UartSettings settings; // parts that are not known yet start from the factory's
    if (m_baud->currentIndex() >= 0) {
        settings.baudIndex = m_baud->currentData().toInt();
    }
    if (m_detection->currentIndex() >= 0) {
        settings.errorDetection = static_cast<ErrorDetection>(m_detection->currentData().toInt());
    }
    if (m_stopBits->currentIndex() >= 0) {
        settings.stopBits = m_stopBits->currentData().toInt();
    }
    emit edited(settings.toRaw());
}

} // namespace trex
