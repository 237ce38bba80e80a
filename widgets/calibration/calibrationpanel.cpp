// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/calibration/calibrationpanel.h"

#include "protocol/procedures/writeaudit.h"
#include "widgets/calibration/calibrationhistory.h"
#include "widgets/calibration/calibrationwizard.h"
#include "widgets/common/eventlog.h"
#include "widgets/common/frameticker.h"

#include <QHideEvent>
#include <QVBoxLayout>

namespace trex {

using namespace Qt::Literals::StringLiterals;

namespace {

constexpr double kHertz = 50.0; // as pulses come (command documentation, 0x86)

} // namespace

CalibrationPanel::CalibrationPanel(PanelContext& panelContext, QWidget* parent)
    : Panel(panelContext, parent)
    , m_calibration(panelContext.controller, panelContext.deviceSettings)
    , m_feed(panelContext.controller, panelContext.store, m_calibration)
    , m_wizard(named(new CalibrationWizard(m_calibration, panelContext.store, this),
                     u"calibration.wizard"_s, tr("Calibration wizard")))
{
    setObjectName(u"calibration"_s);
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->addWidget(m_wizard);
    connect(&panelContext.ticker, &FrameTicker::tick, this, &CalibrationPanel::refresh);
    connect(&m_calibration, &Procedure::finished, this, &CalibrationPanel::onFinished);
    connect(&m_calibration, &ChannelCalibration::noted, this, [this](const QString& sentence) {
        context().log.add(EventLog::Information, tr("Calibration: %1").arg(sentence));
    });
    connect(m_wizard, &CalibrationWizard::historyAsked, this, &CalibrationPanel::showHistory);
    m_wizard->setHistoryOffered(panelContext.audit != nullptr);
}

CalibrationPanel::~CalibrationPanel()
{
    context().controller.wantNothing(this);
}

void CalibrationPanel::refresh()
{
    if (isVisible()) {
        m_wizard->refresh();
    }
}

void CalibrationPanel::onFinished(const Result<void>& result)
{
    context().log.add(result ? EventLog::Information : EventLog::Warning,
                      tr("Calibration: %1").arg(m_calibration.outcomeText()));
}

void CalibrationPanel::showHistory()
{
    auto* open = findChild<CalibrationHistory*>();
    if (open == nullptr) {
        open = new CalibrationHistory(context().controller, context().deviceSettings,
                                      *context().audit, m_calibration, this);
        connect(open, &CalibrationHistory::restored, this, [this](const QString& sentence) {
            context().log.add(EventLog::Information, tr("Calibration: %1").arg(sentence));
        });
    }
    open->show();
    open->raise();
    open->activateWindow();
}

void CalibrationPanel::showEvent(QShowEvent* event)
{
    Panel::showEvent(event);
    updateWish();
}

void CalibrationPanel::hideEvent(QHideEvent* event)
{
    Panel::hideEvent(event);
    updateWish();
    // Closed, or in a closed window: nobody sees what is asked for. A panel behind a tab is not
    // hidden by anyone, nor is a minimised window.
    const QWidget* dock = parentWidget();
    const bool isClosed = isHidden() || (dock != nullptr && dock->isHidden());
    if (!event->spontaneous() && isClosed) {
        m_calibration.interrupt(tr("The calibration's panel was closed."));
    }
}

void CalibrationPanel::updateWish()
{
    context().controller.want(this, PollId::RawChannels, isVisible() ? kHertz : 0.0);
}

} // namespace trex
