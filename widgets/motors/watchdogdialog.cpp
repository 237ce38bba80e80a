// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/motors/watchdogdialog.h"

#include "protocol/errortext.h"
#include "protocol/session/controller.h"
#include "protocol/session/serialtimeoutwatch.h"
#include "widgets/common/stopbutton.h"
#include "widgets/common/theme.h"

#include <QBoxLayout>
#include <QComboBox>
#include <QDialogButtonBox>
#include <QFormLayout>
#include <QLabel>
#include <QProgressBar>
#include <QPushButton>
#include <QSpinBox>

namespace trex {

using namespace Qt::Literals::StringLiterals;

namespace {

constexpr int kFastest = 64; ///< half speed: a proof is no race
constexpr int kWidth = 460;

} // namespace

WatchdogDialog::WatchdogDialog(PanelContext& context, QWidget* parent)
    : QDialog(parent), m_context(context)
{
    setObjectName(u"motors.proofDialog"_s);
    setWindowTitle(tr("Watchdog proof"));
    setAttribute(Qt::WA_DeleteOnClose);
    makeParts();
    connect(&context.controller, &Controller::armedChanged, this, &WatchdogDialog::refresh);
    connect(&context.controller, &Controller::stateChanged, this, &WatchdogDialog::refresh);
    if (context.timeoutWatch != nullptr) {
        connect(context.timeoutWatch, &SerialTimeoutWatch::changed, this, &WatchdogDialog::refresh);
    }
    refresh();
}

WatchdogDialog::~WatchdogDialog()
{
    if (m_proof && m_proof->isRunning()) {
        disconnect(m_proof.get(), nullptr, this, nullptr);
        m_proof->cancel();
    }
}

void WatchdogDialog::makeParts()
{
    auto* title = new QLabel(tr("Does the controller stop when it hears nothing?"), this);
    title->setFont(theme::font(1.25));
    title->setWordWrap(true);
    m_text = named(new QLabel(this), u"motors.proof.text"_s, tr("What will happen"));
    m_text->setWordWrap(true);
    m_motor = named(new QComboBox(this), u"motors.proof.motor"_s, tr("Motor for the proof"));
    m_motor->addItem(tr("Motor 1"), static_cast<int>(MotorId::Motor1));
    m_motor->addItem(tr("Motor 2"), static_cast<int>(MotorId::Motor2));
    m_speed = named(new QSpinBox(this), u"motors.proof.speed"_s, tr("Speed for the proof"));
    m_speed->setRange(1, kFastest);
    m_speed->setValue(WatchdogProof::Options{}.speed);
    m_speed->setSuffix(tr(" of 127"));
    m_result = named(new QLabel(this), u"motors.proof.result"_s, tr("Result of the proof"));
    m_result->setWordWrap(true);
    m_progress = named(new QProgressBar(this), u"motors.proof.progress"_s, tr("Progress"));
    m_progress->setVisible(false);
    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Close, this);
    m_start =
        named(buttons->addButton(tr("Turn the motor and prove"), QDialogButtonBox::ActionRole),
              u"motors.proof.start"_s);
    m_start->setAutoDefault(false);
    connect(m_start, &QPushButton::clicked, this, &WatchdogDialog::onStart);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::close);

    auto* top = new QHBoxLayout;
    top->addWidget(title, 1);
    top->addWidget(named(new StopButton(m_context.controller, this), u"motors.proof.stop"_s));
    auto* form = new QFormLayout;
    form->addRow(tr("Motor"), m_motor);
    form->addRow(tr("Speed"), m_speed);
    auto* layout = new QVBoxLayout(this);
    layout->setSpacing(8);
    layout->addLayout(top);
    layout->addWidget(m_text);
    layout->addLayout(form);
    layout->addWidget(m_progress);
    layout->addWidget(m_result);
    layout->addStretch();
    layout->addWidget(buttons);
}

void WatchdogDialog::refresh()
{
    const bool runs = m_proof && m_proof->isRunning();
    const Controller& controller = m_context.controller;
    const auto timeout = m_context.timeoutWatch != nullptr ? m_context.timeoutWatch->timeout()
                                                           : std::chrono::milliseconds(0);
    QString text = tr("The motor turns slowly; then this program sends nothing on purpose, and "
                      "looks afterwards whether the motor has stopped and the timeout is latched. "
                      "Esc stops at any time, and the proof ends in a stop.");
    if (controller.state() != LinkState::Connected) {
        text = tr("Not connected.");
    } else if (timeout.count() == 0) {
        text += u' ' + tr("The serial timeout is off or not known: set it first.");
    } else {
        const auto longest =
            std::chrono::ceil<std::chrono::seconds>(WatchdogProof::duration(timeout));
        text += u' '
            + tr("Serial timeout: %1 ms. It takes %2 s at most.")
                  .arg(timeout.count())
                  .arg(longest.count());
    }
    if (!controller.isArmed() && controller.state() == LinkState::Connected && !runs) {
        text += u' ' + tr("Arm the motors to start it.");
    }
    m_text->setText(text);
    m_start->setEnabled(controller.isArmed() && !runs && timeout.count() > 0);
    m_motor->setEnabled(!runs);
    m_speed->setEnabled(!runs);
    m_progress->setVisible(runs);
    fit();
}

/// As high as its wrapped texts are at its width; a layout alone would cut them.
void WatchdogDialog::fit()
{
    const int wide = std::max(width(), kWidth);
    setMinimumSize(kWidth, layout()->totalHeightForWidth(wide));
    resize(wide, minimumHeight());
}

void WatchdogDialog::onStart()
{
    m_proof = std::make_unique<WatchdogProof>(
        m_context.controller, m_context.deviceSettings,
        WatchdogProof::Options{static_cast<MotorId>(m_motor->currentData().toInt()),
                               m_speed->value()});
    connect(m_proof.get(), &Procedure::progressed, this,
            [this](int done, int total, const QString& text) {
                m_progress->setRange(0, total);
                m_progress->setValue(done);
                m_result->setText(text);
            });
    connect(m_proof.get(), &Procedure::finished, this, &WatchdogDialog::onFinished);
    m_result->clear();
    theme::setTextColour(*m_result, ColourRole::Text);
    m_proof->start();
    refresh();
}

void WatchdogDialog::onFinished(const Result<void>& result)
{
    if (!result) {
        m_result->setText(result.error().code == ErrorCode::Cancelled
                              ? tr("Ended before it was done; all motors were told to stop.")
                              : errorText(result.error()));
    } else {
        const WatchdogVerdict& verdict = m_proof->verdict();
        theme::setTextColour(*m_result, verdict.isPassed ? ColourRole::Ok : ColourRole::Fault);
        m_result->setText(verdict.sentence);
    }
    refresh();
}

} // namespace trex
