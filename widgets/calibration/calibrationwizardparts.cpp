// SPDX-License-Identifier: GPL-3.0-or-later
// How the wizard is built.
#include "widgets/calibration/calibrationrow.h"
#include "widgets/calibration/calibrationwizard.h"
#include "widgets/calibration/curvebox.h"
#include "widgets/calibration/statemark.h"
#include "widgets/common/panel.h"

#include <QCheckBox>
#include <QGridLayout>
#include <QLabel>
#include <QProgressBar>
#include <QPushButton>
#include <QScrollArea>

namespace trex {

using namespace Qt::Literals::StringLiterals;

namespace {

constexpr int kProgressSteps = 1000;

} // namespace

CalibrationWizard::CalibrationWizard(ChannelCalibration& calibration, const TelemetryStore& store,
                                     QWidget* parent)
    : QWidget(parent)
    , m_calibration(calibration)
    , m_store(store)
    , m_steps(named(new QLabel(this), u"calibration.steps"_s, tr("Steps")))
    , m_instruction(named(new QLabel(this), u"calibration.instruction"_s, tr("What to do now")))
    , m_noticeMark(new StateMark(this))
    , m_notice(named(new QLabel(this), u"calibration.notice"_s, tr("Notice")))
    , m_motorPowerOff(named(new QCheckBox(tr("Motor power is off"), this),
                            u"calibration.motorPowerOff"_s, tr("Motor power is off")))
    , m_countdown(named(new QProgressBar(this), u"calibration.countdown"_s, tr("Countdown")))
    , m_curve(new CurveBox(this))
{
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(8, 8, 8, 8);
    layout->setSpacing(8);
    m_steps->setTextFormat(Qt::RichText);
    for (QLabel* label : {m_instruction, m_notice}) {
        label->setTextFormat(Qt::PlainText);
    }
    for (QLabel* label : {m_steps, m_instruction, m_notice}) {
        label->setWordWrap(true);
    }
    m_countdown->setRange(0, kProgressSteps);
    m_countdown->setTextVisible(false);
    m_countdown->setFixedHeight(6);
    m_motorPowerOff->setToolTip(
        tr("The controller drives the motors by the sticks in this mode. Tick this when their "
           "power is off, so that nothing can move."));
    auto* notice = new QHBoxLayout;
    notice->setSpacing(4);
    notice->addWidget(m_noticeMark, 0, Qt::AlignTop);
    notice->addWidget(m_notice, 1);
    notice->addWidget(m_motorPowerOff, 0, Qt::AlignTop);
    m_content = new QBoxLayout(QBoxLayout::LeftToRight);
    m_content->setSpacing(16);
    m_content->addWidget(makeChannels(), 1);
    m_content->addWidget(m_curve);
    layout->addWidget(m_steps);
    layout->addWidget(m_instruction);
    layout->addLayout(notice);
    layout->addWidget(m_countdown);
    layout->addLayout(m_content, 1);
    layout->addWidget(makeButtons());

    connect(m_motorPowerOff, &QCheckBox::toggled, &calibration,
            &ChannelCalibration::setMotorPowerOff);
    connect(m_curve, &CurveBox::channelChanged, this, &CalibrationWizard::refresh);
    connect(&calibration, &ChannelCalibration::stepChanged, this, &CalibrationWizard::applyStep);
    connect(&calibration, &ChannelCalibration::updated, this, &CalibrationWizard::showButtons);
    applyTheme();
    applyStep();
}

void CalibrationWizard::setHistoryOffered(bool offered)
{
    m_history->setVisible(offered);
}

QWidget* CalibrationWizard::makeChannels()
{
    m_scroll = new QScrollArea(this);
    auto* inside = new QWidget(m_scroll);
    m_grid = new QGridLayout(inside);
    m_grid->setContentsMargins(0, 0, 0, 0);
    m_grid->setHorizontalSpacing(12);
    m_grid->setVerticalSpacing(12);
    const std::array<QString, 4> titles{tr("Minimum"), tr("Neutral"), tr("Maximum"),
                                        tr("Deadband")};
    for (std::size_t i = 0; i < titles.size(); ++i) {
        auto* header = new QLabel(titles.at(i), inside);
        header->setAlignment(Qt::AlignRight);
        m_grid->addWidget(header, 0, CalibrationRow::kFirstNumber + static_cast<int>(i));
        m_headers.push_back(header);
    }
    for (int channel = 1; channel <= kChannelCount; ++channel) {
        addRow(channel, inside);
    }
    m_grid->setRowStretch(kChannelCount + 1, 1);
    m_scroll->setWidget(inside);
    m_scroll->setWidgetResizable(true);
    m_scroll->setFrameShape(QFrame::NoFrame);
    m_scroll->setHorizontalScrollBarPolicy(Qt::ScrollBarAsNeeded);
    return m_scroll;
}

void CalibrationWizard::addRow(int channel, QWidget* inside)
{
    auto* row = new CalibrationRow(channel, m_grid, channel, inside);
    m_rows.at(static_cast<std::size_t>(channel - 1)) = row;
    connect(row, &CalibrationRow::useToggled, this, [this](int number, bool use) {
        const auto bit = static_cast<std::uint8_t>(1U << (number - 1));
        const std::uint8_t mask = m_calibration.channels();
        m_calibration.setChannels(static_cast<std::uint8_t>(use ? mask | bit : mask & ~bit));
    });
    connect(row, &CalibrationRow::reverseToggled, &m_calibration, &ChannelCalibration::setReversed);
    connect(row, &CalibrationRow::againAsked, &m_calibration, &ChannelCalibration::selectDirection);
}

QWidget* CalibrationWizard::makeButtons()
{
    auto* bar = new QWidget(this);
    auto* layout = new QHBoxLayout(bar);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(8);
    m_reason = named(new QLabel(bar), u"calibration.reason"_s, tr("Why it cannot go on yet"));
    m_reason->setWordWrap(true);
    m_reason->setTextFormat(Qt::PlainText);
    m_history = named(new QPushButton(tr("History…"), bar), u"calibration.history"_s,
                      tr("Calibrations of before"));
    m_curveShown = named(new QPushButton(tr("Curve"), bar), u"calibration.curveShown"_s,
                         tr("Show the response curve"));
    m_curveShown->setCheckable(true);
    m_undo = named(new QPushButton(tr("Undo"), bar), u"calibration.undo"_s,
                   tr("Put the former values back"));
    m_undo->setToolTip(tr("Writes the values of before this calibration, and reads them back."));
    m_cancel = named(new QPushButton(tr("Cancel"), bar), u"calibration.cancel"_s,
                     tr("Cancel the calibration"));
    m_back = named(new QPushButton(tr("Back"), bar), u"calibration.back"_s, tr("Back one step"));
    m_next = named(new QPushButton(bar), u"calibration.next"_s);
    layout->addWidget(m_history);
    layout->addWidget(m_curveShown);
    layout->addWidget(m_reason, 1);
    layout->addWidget(m_cancel);
    layout->addSpacing(8);
    layout->addWidget(m_undo);
    layout->addWidget(m_back);
    layout->addWidget(m_next);
    connect(m_history, &QPushButton::clicked, this, &CalibrationWizard::historyAsked);
    connect(m_curveShown, &QPushButton::toggled, this, [this](bool isShown) {
        m_isCurveWanted = isShown;
        placeCurve();
    });
    connect(m_undo, &QPushButton::clicked, &m_calibration, &ChannelCalibration::undo);
    connect(m_cancel, &QPushButton::clicked, &m_calibration, &ChannelCalibration::cancel);
    connect(m_back, &QPushButton::clicked, &m_calibration, &ChannelCalibration::back);
    connect(m_next, &QPushButton::clicked, &m_calibration, &ChannelCalibration::next);
    return bar;
}

} // namespace trex
