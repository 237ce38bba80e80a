// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/bench/benchstepform.h"

#include "widgets/bench/benchstepmodel.h"
#include "widgets/common/panel.h"

#include <QCheckBox>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QFormLayout>
#include <QLabel>
#include <QLineEdit>
#include <QSpinBox>

namespace trex {

using namespace Qt::Literals::StringLiterals;

namespace {

constexpr int kActions = 9;
constexpr int kConditions = 6;
constexpr int kBits = 8;
constexpr int kNoFrom = -kFullSpeed - 1; ///< shown as "where it is"
constexpr double kDay = 86'400.0;

} // namespace

BenchStepForm::BenchStepForm(QWidget* parent) : QWidget(parent), m_form(new QFormLayout(this))
{
    m_form->setContentsMargins(8, 4, 4, 4);
    m_form->setVerticalSpacing(4);
    m_form->setFieldGrowthPolicy(QFormLayout::AllNonFixedFieldsGrow);
    addChoices();
    m_from = addSpeed(u"from"_s, tr("From"), kNoFrom);
    m_from->setSpecialValueText(tr("where it is"));
    m_speed = addSpeed(u"speed"_s, tr("Speed"), -kFullSpeed);
    m_duty = addSpeed(u"duty"_s, tr("Braking duty"), 0);
    m_amplitude = addSpeed(u"amplitude"_s, tr("Amplitude"), 1);
    m_period = addNumber(u"period"_s, tr("Period"), tr(" s"), 0.1, 3600.0, 2);
    m_form->addRow(tr("Until"), m_condition);
    m_form->addRow(tr("Bit"), m_bit);
    m_channel = addSpeed(u"channel"_s, tr("Channel"), 1);
    m_channel->setMaximum(kChannelCount);
    m_threshold = addNumber(u"threshold"_s, tr("Value"), QString(), 0.0, kDay, 2);
    m_seconds = addNumber(u"seconds"_s, tr("Time"), tr(" s"), 0.02, kDay, 2);
    m_times = addSpeed(u"times"_s, tr("Times"), 1);
    m_times->setMaximum(100'000);
    m_mustHappen = named(new QCheckBox(tr("or the test has failed"), this), u"bench.step.must"_s);
    m_form->addRow(QString(), m_mustHappen);
    m_amperes = addNumber(u"amperes"_s, tr("Stop above"), tr(" A"), 0.0, 60.0, 2);
    m_amperes->setSpecialValueText(tr("as the test"));
    m_amperes->setToolTip(tr("A current limit of this step's own"));
    m_label = named(new QLineEdit(this), u"bench.step.label"_s, tr("Label"));
    m_label->setPlaceholderText(tr("shown in the plot"));
    m_form->addRow(tr("Label"), m_label);
    connect(m_mustHappen, &QCheckBox::toggled, this, &BenchStepForm::take);
    connect(m_label, &QLineEdit::textEdited, this, &BenchStepForm::take);
    setStep({});
}

void BenchStepForm::addChoices()
{
    m_action = named(new QComboBox(this), u"bench.step.action"_s, tr("What the step does"));
    for (int i = 0; i < kActions; ++i) {
        const auto action = static_cast<BenchAction>(i);
        m_action->addItem(titleOf(action), QString(keyOf(action)));
    }
    m_motor = named(new QComboBox(this), u"bench.step.motor"_s, tr("Motor"));
    for (const BenchMotor motor :
         {BenchMotor::Motor1, BenchMotor::Motor2, BenchMotor::Both, BenchMotor::Aux}) {
        m_motor->addItem(titleOf(motor), QString(keyOf(motor)));
    }
    m_condition = named(new QComboBox(this), u"bench.step.condition"_s, tr("What it waits for"));
    for (int i = 0; i < kConditions; ++i) {
        const auto condition = static_cast<BenchCondition>(i);
        m_condition->addItem(titleOf(condition), QString(keyOf(condition)));
    }
    m_bit = named(new QComboBox(this), u"bench.step.bit"_s, tr("Status bit"));
    for (int bit = 0; bit < kBits; ++bit) {
        if (!statusBitKey(bit).isEmpty()) {
            m_bit->addItem(statusBitKey(bit), bit);
        }
    }
    m_form->addRow(tr("Do"), m_action);
    m_form->addRow(tr("Motor"), m_motor);
    for (QComboBox* box : {m_action, m_motor, m_condition, m_bit}) {
        connect(box, &QComboBox::currentIndexChanged, this, &BenchStepForm::take);
    }
}

QSpinBox* BenchStepForm::addSpeed(const QString& name, const QString& title, int minimum)
{
    auto* box = named(new QSpinBox(this), u"bench.step."_s + name, title);
    box->setRange(minimum, kFullSpeed);
    m_form->addRow(title, box);
    connect(box, &QSpinBox::valueChanged, this, &BenchStepForm::take);
    return box;
}

QDoubleSpinBox* BenchStepForm::addNumber(const QString& name, const QString& title,
                                         const QString& unit, double minimum, double maximum,
                                         int decimals)
{
    auto* box = named(new QDoubleSpinBox(this), u"bench.step."_s + name, title);
    box->setRange(minimum, maximum);
    box->setDecimals(decimals);
    box->setSuffix(unit);
    m_form->addRow(title, box);
    connect(box, &QDoubleSpinBox::valueChanged, this, &BenchStepForm::take);
    return box;
}

void BenchStepForm::setStep(const BenchStep& step)
{
    if (step == m_step && !m_label->text().isNull()) {
        return;
    }
    m_isFilling = true;
    m_step = step;
    m_action->setCurrentIndex(int(step.action));
    m_motor->setCurrentIndex(int(step.motor));
    m_from->setValue(step.from.value_or(kNoFrom));
    m_speed->setValue(step.speed);
    m_duty->setValue(step.speed);
    m_amplitude->setValue(step.amplitude);
    m_period->setValue(step.period);
    m_condition->setCurrentIndex(int(step.condition));
    m_bit->setCurrentIndex(std::max(0, m_bit->findData(step.number)));
    m_channel->setValue(step.number);
    m_threshold->setValue(step.threshold);
    m_seconds->setValue(step.seconds);
    m_times->setValue(step.times);
    m_mustHappen->setChecked(step.mustHappen);
    m_amperes->setValue(step.limits.amperes.value_or(0.0));
    m_label->setText(step.label);
    showFields();
    m_isFilling = false;
}

void BenchStepForm::showFields()
{
    const auto action = static_cast<BenchAction>(m_action->currentIndex());
    const auto condition = static_cast<BenchCondition>(m_condition->currentIndex());
    const auto is = [action](std::initializer_list<BenchAction> actions) {
        return std::ranges::find(actions, action) != actions.end();
    };
    const bool waits = action == BenchAction::Wait;
    const bool waitsForCurrent = waits
        && (condition == BenchCondition::CurrentAbove || condition == BenchCondition::CurrentBelow);
    const bool waitsForBit = waits && condition == BenchCondition::Status;
    const bool waitsForChannel = waits
        && (condition == BenchCondition::ChannelAbove || condition == BenchCondition::ChannelBelow);
    const auto show = [this](QWidget* field, bool isShown) {
        m_form->setRowVisible(field, isShown);
    };
    show(m_motor,
         waitsForCurrent || !is({BenchAction::Hold, BenchAction::Wait, BenchAction::Repeat}));
    show(m_from, action == BenchAction::Ramp);
    show(m_speed,
         is({BenchAction::Set, BenchAction::Accelerate, BenchAction::Ramp, BenchAction::Step,
             BenchAction::Sine}));
    show(m_duty, action == BenchAction::Brake);
    show(m_amplitude, action == BenchAction::Sine);
    show(m_period, action == BenchAction::Sine);
    show(m_condition, waits);
    show(m_bit, waitsForBit);
    show(m_channel, waitsForChannel);
    show(m_threshold, waits && !waitsForBit);
    show(m_mustHappen, waits);
    show(m_times, action == BenchAction::Repeat);
    const bool hasTime = is({BenchAction::Ramp, BenchAction::Step, BenchAction::Sine,
                             BenchAction::Hold, BenchAction::Wait});
    show(m_seconds, hasTime);
    show(m_amperes, hasTime || action == BenchAction::Repeat);
    m_threshold->setSuffix(waitsForCurrent ? tr(" A") : waitsForChannel ? QString() : tr(" s"));
    m_threshold->setDecimals(waitsForChannel ? 0 : 2);
    const auto titleFor = [this](QWidget* field, const QString& title) {
        if (auto* label = qobject_cast<QLabel*>(m_form->labelForField(field))) {
            label->setText(title);
        }
    };
    titleFor(m_speed,
             action == BenchAction::Ramp       ? tr("To")
                 : action == BenchAction::Sine ? tr("Middle")
                                               : tr("Speed"));
    titleFor(m_seconds, waits ? tr("At most") : tr("Time"));
}

void BenchStepForm::take()
{
    if (m_isFilling) {
        return;
    }
    BenchStep step = m_step;
    step.action = static_cast<BenchAction>(m_action->currentIndex());
    step.motor = static_cast<BenchMotor>(m_motor->currentIndex());
    step.from.reset();
    if (step.action == BenchAction::Ramp && m_from->value() != kNoFrom) {
        step.from = m_from->value();
    }
    step.speed = step.action == BenchAction::Brake ? m_duty->value() : m_speed->value();
    step.amplitude = step.action == BenchAction::Sine ? m_amplitude->value() : 0;
    step.period = m_period->value();
    step.condition = static_cast<BenchCondition>(m_condition->currentIndex());
    step.threshold = m_threshold->value();
    step.number = step.condition == BenchCondition::Status ? m_bit->currentData().toInt()
                                                           : m_channel->value();
    step.seconds = m_seconds->value();
    step.times = m_times->value();
    step.mustHappen = m_mustHappen->isChecked();
    step.limits.amperes.reset();
    if (m_amperes->value() > 0.0) {
        step.limits.amperes = m_amperes->value();
    }
    step.label = m_label->text();
    m_step = step;
    showFields();
    emit edited(step);
}

} // namespace trex
