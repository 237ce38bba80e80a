// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/parameters/channelbitsfield.h"

#include <QCheckBox>
#include <QCoreApplication>

using namespace Qt::Literals::StringLiterals;

namespace trex {
namespace {

/// What the channels do (facts.md 5.4, user guide 4.a).
struct ChannelRole {
    const char* name;
    const char* shortName;
    const char* bareName; ///< without its number, which the order of the boxes tells
    const char* sentence;
};
constexpr std::array<ChannelRole, kChannelCount> kRoles{
    ChannelRole{QT_TRANSLATE_NOOP("ParameterField", "1 motor 1 / turn"),
                QT_TRANSLATE_NOOP("ParameterField", "1 M1"),
                QT_TRANSLATE_NOOP("ParameterField", "M1"),
                QT_TRANSLATE_NOOP("ParameterField",
                                  "Channel 1: motor 1, or turning with the mix jumper on")},
    ChannelRole{QT_TRANSLATE_NOOP("ParameterField", "2 motor 2 / drive"),
                QT_TRANSLATE_NOOP("ParameterField", "2 M2"),
                QT_TRANSLATE_NOOP("ParameterField", "M2"),
                QT_TRANSLATE_NOOP("ParameterField",
                                  "Channel 2: motor 2, or forward and back with the mix jumper "
                                  "on")},
    ChannelRole{QT_TRANSLATE_NOOP("ParameterField", "3 auxiliary"),
                QT_TRANSLATE_NOOP("ParameterField", "3 aux"),
                QT_TRANSLATE_NOOP("ParameterField", "aux"),
                QT_TRANSLATE_NOOP("ParameterField",
                                  "Channel 3: speed of the auxiliary motor, one direction")},
    ChannelRole{
        QT_TRANSLATE_NOOP("ParameterField", "4 flip"),
        QT_TRANSLATE_NOOP("ParameterField", "4 flip"), QT_TRANSLATE_NOOP("ParameterField", "flip"),
        QT_TRANSLATE_NOOP("ParameterField", "Channel 4: flip switch, swaps motors and directions")},
    ChannelRole{QT_TRANSLATE_NOOP("ParameterField", "5 serial override"),
                QT_TRANSLATE_NOOP("ParameterField", "5 serial"),
                QT_TRANSLATE_NOOP("ParameterField", "serial"),
                QT_TRANSLATE_NOOP("ParameterField",
                                  "Channel 5: serial override, hands the motors to the serial "
                                  "line")}};

QString words(const char* text)
{
    return QCoreApplication::translate("ParameterField", text);
}

} // namespace

ChannelBitsField::ChannelBitsField(const ParameterRow& row, QWidget* parent)
    : ParameterField(row, parent)
{
    for (const auto& role : kRoles) {
        auto* const box = new QCheckBox(words(role.name), this);
        addPart(box, words(role.sentence));
        box->setToolTip(words(role.sentence));
        connect(box, &QCheckBox::clicked, this, &ChannelBitsField::onClicked);
        m_boxes.push_back(box);
    }
}

void ChannelBitsField::setWords(Words howMany)
{
    m_hasRawBeside = howMany == Words::Whole;
    for (std::size_t i = 0; i < m_boxes.size(); ++i) {
        m_boxes[i]->setText(words(howMany == Words::Whole       ? kRoles[i].name
                                      : howMany == Words::Short ? kRoles[i].shortName
                                                                : kRoles[i].bareName));
    }
    refreshStored();
}

QString ChannelBitsField::storedText(int raw) const
{
    return m_hasRawBeside ? hexText(raw) : QString();
}

void ChannelBitsField::display(std::optional<int> raw)
{
    for (std::size_t i = 0; i < m_boxes.size(); ++i) {
        m_boxes[i]->setTristate(!raw);
        m_boxes[i]->setCheckState(!raw                       ? Qt::PartiallyChecked
                                      : (*raw >> i & 1) != 0 ? Qt::Checked
                                                             : Qt::Unchecked);
    }
}

void ChannelBitsField::onClicked()
{
    int mask = 0;
    for (std::size_t i = 0; i < m_boxes.size(); ++i) {
        mask |= m_boxes[i]->isChecked() ? 1 << i : 0;
    }
    emit edited(mask);
}

} // namespace trex
