// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/motors/safetydialog.h"

#include "protocol/codec/quantities.h"
#include "widgets/common/fitting.h"
#include "widgets/common/stopbutton.h"
#include "widgets/common/theme.h"
#include "widgets/common/uisettings.h"

#include <QBoxLayout>
#include <QCheckBox>
#include <QDialogButtonBox>
#include <QEvent>
#include <QFormLayout>
#include <QGroupBox>
#include <QLabel>
#include <QPushButton>
#include <QScrollArea>
#include <QSpinBox>

namespace trex {

using namespace Qt::Literals::StringLiterals;

namespace {

constexpr int kMostRamp = 2000; ///< speed steps a second: 64 ms to full speed
constexpr int kWidth = 440;
constexpr int kMargins = 24; ///< of the dialog, left and right together
constexpr int kMostIdleMinutes = 24 * 60;

} // namespace

SafetyDialog::SafetyDialog(PanelContext& context, QWidget* parent)
    : QDialog(parent), m_context(context)
{
    setObjectName(u"motors.safetyDialog"_s);
    setWindowTitle(tr("Safety and limits"));
    setAttribute(Qt::WA_DeleteOnClose);
    auto* title = new QLabel(tr("Safety and limits of the motors"), this);
    title->setFont(theme::font(1.25));
    auto* top = new QHBoxLayout;
    top->addWidget(title, 1);
    top->addWidget(named(new StopButton(context.controller, this), u"motors.safety.stop"_s));
    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Close, this);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::close);
    buttons->button(QDialogButtonBox::Close)->setText(tr("Close"));
    auto* layout = new QVBoxLayout(this);
    layout->setSpacing(16);
    layout->addLayout(top);
    auto* content = new QWidget;
    auto* groups = new QVBoxLayout(content);
    groups->setContentsMargins(0, 0, 0, 0);
    groups->setSpacing(16);
    groups->addWidget(makeDisarming());
    groups->addWidget(makeLimits());
    groups->addWidget(makeHolding());
    auto* area = new QScrollArea(this);
    area->setFrameShape(QFrame::NoFrame);
    area->setWidgetResizable(true);
    area->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    area->setWidget(content);
    layout->addWidget(area, 1);
    layout->addWidget(buttons);
    for (auto* box : content->findChildren<QSpinBox*>()) {
        box->setFocusPolicy(Qt::StrongFocus);
        box->installEventFilter(this);
    }
    // As high as its wrapped texts are at its width (a layout alone would cut them), where the
    // screen is: else the groups are scrolled, and STOP and Close stay in view.
    const int wide = std::max(
        {content->sizeHint().width() + kMargins, layout->totalMinimumSize().width(), kWidth});
    const int around = layout->totalSizeHint().height() - area->sizeHint().height();
    const int high =
        std::max(groups->totalHeightForWidth(wide - kMargins), groups->totalSizeHint().height());
    setMinimumWidth(wide);
    resizeToFit(*this, {wide, high + around});
}

/// Scrolling past a number is no change of it.
bool SafetyDialog::eventFilter(QObject* watched, QEvent* event)
{
    if (event->type() == QEvent::Wheel && !static_cast<QWidget*>(watched)->hasFocus()) {
        event->ignore();
        return true;
    }
    return QDialog::eventFilter(watched, event);
}

QCheckBox* SafetyDialog::addCheck(QLayout& layout, const Setting<bool>& setting,
                                  const QString& name, const QString& text, const QString& tip)
{
    auto* check = named(new QCheckBox(text, this), u"motors.safety."_s + name);
    check->setToolTip(tip);
    check->setChecked(m_context.settings.value(setting));
    layout.addWidget(check);
    connect(check, &QCheckBox::toggled, this,
            [this, &setting](bool on) { m_context.settings.set(setting, on); });
    return check;
}

QSpinBox* SafetyDialog::addNumber(QFormLayout& form, const Setting<int>& setting,
                                  const QString& name, const QString& label,
                                  std::pair<int, int> range, const QString& suffix,
                                  const QString& atLeast)
{
    auto* box = named(new QSpinBox(this), u"motors.safety."_s + name, label);
    box->setRange(range.first, range.second);
    box->setSuffix(suffix);
    box->setSpecialValueText(atLeast);
    box->setValue(m_context.settings.value(setting));
    box->setKeyboardTracking(false); // "5" on the way to "500" is no setting
    form.addRow(label, box);
    connect(box, &QSpinBox::valueChanged, this,
            [this, &setting](int value) { m_context.settings.set(setting, value); });
    return box;
}

QWidget* SafetyDialog::makeDisarming()
{
    auto* group = new QGroupBox(tr("Stop and disarm by itself"), this);
    auto* layout = new QVBoxLayout(group);
    auto* always = new QLabel(tr("Always: a lost link, a restarted controller, disconnecting, "
                                 "quitting, a crash or standstill of this program. Also:"),
                              group);
    always->setWordWrap(true);
    layout->addWidget(always);
    addCheck(*layout, settings::kDisarmMotorFault, u"motorFault"_s, tr("A motor driver's fault"),
             tr("Status bits 4 and 6: short circuit, heat, too low a supply."));
    addCheck(*layout, settings::kDisarmOverCurrent, u"overCurrent"_s, tr("Over-current"),
             tr("Status bits 5 and 7. A current limit that does its work lights them, too."));
    addCheck(*layout, settings::kDisarmUartError, u"uartError"_s, tr("An error on the line"),
             tr("Any bit of the UART error byte but the timeout."));
    addCheck(*layout, settings::kDisarmSerialTimeout, u"serialTimeout"_s,
             tr("The controller's serial timeout"),
             tr("It has stopped the motors by itself; the next order would start them again."));
    addCheck(*layout, settings::kDisarmLocked, u"locked"_s, tr("Screen locked, computer to sleep"),
             tr("As the desktop tells it, where it does."));
    addCheck(*layout, settings::kDisarmHidden, u"hidden"_s, tr("All windows hidden or minimised"),
             tr("STOP would be out of reach."));
    auto* form = new QFormLayout;
    auto* idle = named(new QSpinBox(this), u"motors.safety.idle"_s, tr("Idle time"));
    idle->setRange(0, kMostIdleMinutes);
    idle->setSuffix(tr(" min"));
    idle->setSpecialValueText(tr("never"));
    idle->setValue(m_context.settings.value(settings::kIdleSeconds) / 60);
    idle->setToolTip(tr("All motors at zero, and no order given for so long. A motor that runs is "
                        "not idle."));
    form->addRow(tr("No order for"), idle);
    layout->addLayout(form);
    connect(idle, &QSpinBox::valueChanged, this,
            [this](int minutes) { m_context.settings.set(settings::kIdleSeconds, minutes * 60); });
    return group;
}

QWidget* SafetyDialog::makeLimits()
{
    auto* group = new QGroupBox(tr("Limits and ramps"), this);
    auto* form = new QFormLayout(group);
    const std::pair speeds{1, kFullSpeed};
    const QString of = tr(" of 127");
    addNumber(*form, settings::kMaximum1, u"maximum1"_s, tr("Motor 1 at most"), speeds, of);
    addNumber(*form, settings::kMaximum2, u"maximum2"_s, tr("Motor 2 at most"), speeds, of);
    addNumber(*form, settings::kMaximumAux, u"maximumAux"_s, tr("Auxiliary at most"), speeds, of);
    addNumber(*form, settings::kSliderStep, u"sliderStep"_s, tr("Slider step at most"), speeds,
              QString());
    const QString rate = tr(" a second");
    auto* start = addNumber(*form, settings::kSoftStart, u"softStart"_s, tr("Soft start"),
                            {0, kMostRamp}, rate, tr("at once"));
    auto* stop = addNumber(*form, settings::kSoftStop, u"softStop"_s, tr("Soft stop"),
                           {0, kMostRamp}, rate, tr("at once"));
    const QString tip =
        tr("Speed steps a second, for orders that are set at once. Accelerate is the "
           "controller's own. STOP never ramps.");
    start->setToolTip(tip);
    stop->setToolTip(tip);
    auto* amperes = named(new QDoubleSpinBox(this), u"motors.safety.stallAmperes"_s,
                          tr("Stall guard, current"));
    amperes->setRange(0.0, 40.0);
    amperes->setSingleStep(0.1);
    amperes->setSuffix(tr(" A"));
    amperes->setSpecialValueText(tr("off"));
    amperes->setKeyboardTracking(false);
    amperes->setValue(m_context.settings.value(settings::kStallMilliamperes) / 1000.0);
    amperes->setToolTip(
        tr("As much for as long: all motors are led to zero, then disarmed. In "
           "joint mode the controller reports no current, and nothing is guarded."));
    form->addRow(tr("Stall guard from"), amperes);
    connect(amperes, &QDoubleSpinBox::valueChanged, this, [this](double value) {
        m_context.settings.set(settings::kStallMilliamperes, qRound(value * 1000.0));
    });
    addNumber(*form, settings::kStallMs, u"stallMs"_s, tr("for"), {10, 60'000}, tr(" ms"));
    return group;
}

QWidget* SafetyDialog::makeHolding()
{
    auto* group = new QGroupBox(tr("Hold to run"), this);
    auto* form = new QFormLayout(group);
    addNumber(*form, settings::kHoldSpeed, u"holdSpeed"_s, tr("Speed of keys and buttons"),
              {1, kFullSpeed}, tr(" of 127"));
    return group;
}

} // namespace trex
