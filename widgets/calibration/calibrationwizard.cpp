// SPDX-License-Identifier: GPL-3.0-or-later
// The wizard's state on the screen. How it is built: calibrationwizardparts.cpp.
#include "widgets/calibration/calibrationwizard.h"

#include "protocol/telemetry/telemetrystore.h"
#include "widgets/calibration/calibrationpages.h"
#include "widgets/calibration/calibrationrow.h"
#include "widgets/calibration/curvebox.h"
#include "widgets/calibration/statemark.h"
#include "widgets/common/theme.h"

#include <QBoxLayout>
#include <QCheckBox>
#include <QEvent>
#include <QGridLayout>
#include <QLabel>
#include <QProgressBar>
#include <QPushButton>
#include <QScrollArea>
#include <QScrollBar>
#include <QSignalBlocker>

namespace trex {

using namespace std::chrono_literals;
using namespace Qt::Literals::StringLiterals;

namespace {

using Step = ChannelCalibration::Step;

constexpr auto kStaleAfter = 1s;

} // namespace

QString CalibrationWizard::page() const
{
    return m_calibration.stepKey();
}

void CalibrationWizard::applyTheme()
{
    for (QLabel* header : m_headers) {
        theme::setTextColour(*header, ColourRole::DimText);
    }
    theme::setTextColour(*m_steps, ColourRole::DimText);
    theme::setTextColour(*m_reason, ColourRole::DimText);
    for (CalibrationRow* row : m_rows) {
        row->applyTheme();
    }
    m_curve->applyTheme();
    m_back->setIcon(theme::icon(u"back"_s));
    m_next->setIcon(theme::icon(u"next"_s));
    m_cancel->setIcon(theme::icon(u"cancel"_s));
}

void CalibrationWizard::changeEvent(QEvent* event)
{
    QWidget::changeEvent(event);
    if (event->type() == QEvent::PaletteChange && m_next != nullptr) {
        applyTheme();
        applyStep();
    }
}

void CalibrationWizard::resizeEvent(QResizeEvent* event)
{
    QWidget::resizeEvent(event);
    placeCurve();
}

/// Beside the channels, or below them, or not at all: bars and numbers come first.
void CalibrationWizard::placeCurve()
{
    const QSize curve = m_curve->minimumSizeHint();
    const int gap = m_content->spacing() + m_scroll->verticalScrollBar()->sizeHint().width();
    const QSize rows = m_scroll->widget()->minimumSizeHint();
    const QRect room = m_content->geometry(); // of channels and curve together, shown or not
    const int beside = room.width() - rows.width() - gap;
    const bool isBeside = beside >= curve.width();
    const bool isBelow = room.height() >= rows.height() + gap + curve.height();
    const bool isFitting = isBeside ? room.height() >= curve.height() : isBelow;
    const bool isStacked = !isBeside && isBelow;
    m_content->setDirection(isStacked ? QBoxLayout::TopToBottom : QBoxLayout::LeftToRight);
    const int most = std::max(curve.width(), m_curve->sizeHint().width() * 3 / 2);
    const int width = std::clamp(beside, curve.width(), most);
    m_curve->setMinimumWidth(isStacked ? 0 : width);
    m_curve->setMaximumWidth(isStacked ? QWIDGETSIZE_MAX : width);
    const bool isShown = m_isCurveWanted.value_or(isFitting);
    m_curve->setVisible(isShown);
    const QSignalBlocker blocker(m_curveShown);
    m_curveShown->setChecked(isShown);
}

void CalibrationWizard::applyStep()
{
    const Step step = m_calibration.step();
    const bool isNumbers = step != Step::Choose && !m_calibration.isCollecting();
    const bool isOver = step == Step::Done || step == Step::Stopped;
    m_instruction->setFont(theme::font(isOver ? 1.15 : 1.5)); // several sentences, or one
    for (QLabel* header : m_headers) {
        header->setVisible(isNumbers);
    }
    m_grid->setColumnStretch(1, isNumbers ? 0 : 3);
    m_grid->setColumnStretch(CalibrationRow::kColumns - 1, isNumbers ? 3 : 2);
    for (CalibrationRow* row : m_rows) {
        row->applyStep(m_calibration);
    }
    m_curve->applyStep(m_calibration);
    m_countdown->setVisible(step == Step::Neutral);
    showSteps();
    refresh();
    showButtons();
    placeCurve();
}

void CalibrationWizard::showSteps()
{
    const QStringList titles = calibrationpages::stepTitles();
    const int present = calibrationpages::stepIndex(m_calibration);
    QStringList parts;
    for (qsizetype i = 0; i < titles.size(); ++i) {
        const QString part = u"%1&nbsp;%2"_s.arg(i + 1).arg(titles.at(i).toHtmlEscaped());
        parts << (i == present ? u"<b style=\"color:%2\">%1</b>"_s.arg(
                      part, theme::colour(ColourRole::Text).name())
                               : part);
    }
    m_steps->setText(parts.join(u" › "_s));
}

void CalibrationWizard::showButtons()
{
    const Step step = m_calibration.step();
    const bool isOver = step == Step::Done || step == Step::Stopped;
    const QString reason = m_calibration.whyNot();
    m_next->setText(calibrationpages::nextText(m_calibration));
    m_next->setAccessibleName(m_next->text());
    m_next->setEnabled(reason.isEmpty());
    m_reason->setText(reason);
    m_back->setVisible(!isOver);
    m_back->setEnabled(m_calibration.isCollecting() || step == Step::Review);
    m_cancel->setVisible(!isOver);
    m_cancel->setEnabled(m_calibration.isRunning());
    m_undo->setVisible(isOver);
    m_undo->setEnabled(m_calibration.canUndo());
    m_history->setEnabled(!m_calibration.isRunning());
}

std::optional<int> CalibrationWizard::freshReading(int channel) const
{
    const PollSample* sample = m_store.latest(PollId::RawChannels);
    const bool isFresh =
        sample != nullptr && std::chrono::steady_clock::now() - sample->time <= kStaleAfter;
    // What a number means, its unit, is known with the mode only.
    return isFresh && m_calibration.mode()
        ? std::optional<int>(sample->raw.at(static_cast<std::size_t>(channel - 1)))
        : std::nullopt;
}

void CalibrationWizard::showNotice()
{
    const auto notice = calibrationpages::notice(m_calibration);
    m_notice->setText(notice.text);
    m_notice->setVisible(!notice.text.isEmpty());
    m_noticeMark->setVisible(!notice.text.isEmpty());
    m_noticeMark->setState(notice.shape, {});
    const bool isAsked = m_calibration.step() == Step::Choose && m_calibration.doSticksDrive();
    m_motorPowerOff->setVisible(isAsked);
    m_motorPowerOff->setEnabled(!m_calibration.isPreparing());
    const QSignalBlocker blocker(m_motorPowerOff);
    m_motorPowerOff->setChecked(m_calibration.isMotorPowerOff());
}

void CalibrationWizard::refresh()
{
    m_instruction->setText(calibrationpages::instruction(m_calibration));
    showNotice();
    if (m_calibration.step() == Step::Neutral) {
        const auto* learner = m_calibration.learner();
        const double share = std::chrono::duration<double>(learner->neutralRemaining())
            / std::chrono::duration<double>(learner->stillTime());
        m_countdown->setValue(
            static_cast<int>((1.0 - std::clamp(share, 0.0, 1.0)) * m_countdown->maximum()));
    }
    for (int channel = 1; channel <= kChannelCount; ++channel) {
        m_rows.at(static_cast<std::size_t>(channel - 1))
            ->refresh(m_calibration, freshReading(channel));
    }
    m_curve->refresh(m_calibration, freshReading(m_curve->channel()));
}

} // namespace trex
