// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/calibration/calibrationwizard.h"

#include "protocol/telemetry/telemetrystore.h"
#include "widgets/calibration/calibrationpages.h"
#include "widgets/calibration/calibrationrow.h"
#include "widgets/calibration/statemark.h"
#include "widgets/common/panel.h"
#include "widgets/common/theme.h"

#include <QEvent>
#include <QGridLayout>
#include <QLabel>
#include <QProgressBar>
#include <QPushButton>
#include <QScrollArea>

namespace trex {

using namespace std::chrono_literals;
using namespace Qt::Literals::StringLiterals;

namespace {

using Step = ChannelCalibration::Step;

constexpr auto kStaleAfter = 1s;
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
    , m_countdown(named(new QProgressBar(this), u"calibration.countdown"_s, tr("Countdown")))
{
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(8, 8, 8, 8);
    layout->setSpacing(8);
    m_steps->setTextFormat(Qt::RichText);
    for (QLabel* label : {m_instruction, m_notice}) {
        label->setWordWrap(true);
        label->setTextFormat(Qt::PlainText);
    }
    m_countdown->setRange(0, kProgressSteps);
    m_countdown->setTextVisible(false);
    m_countdown->setFixedHeight(6);
    auto* notice = new QHBoxLayout;
    notice->setSpacing(4);
    notice->addWidget(m_noticeMark, 0, Qt::AlignTop);
    notice->addWidget(m_notice, 1);
    layout->addWidget(m_steps);
    layout->addWidget(m_instruction);
    layout->addLayout(notice);
    layout->addWidget(m_countdown);
    layout->addWidget(makeChannels(), 1);
    layout->addWidget(makeButtons());

    connect(&calibration, &ChannelCalibration::stepChanged, this, &CalibrationWizard::applyStep);
    connect(&calibration, &ChannelCalibration::updated, this, &CalibrationWizard::showButtons);
    applyTheme();
    applyStep();
}

QWidget* CalibrationWizard::makeChannels()
{
    auto* scroll = new QScrollArea(this);
    auto* inside = new QWidget(scroll);
    m_grid = new QGridLayout(inside);
    m_grid->setContentsMargins(0, 0, 0, 0);
    m_grid->setHorizontalSpacing(16);
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
        auto* row = new CalibrationRow(channel, m_grid, channel, inside);
        m_rows.at(static_cast<std::size_t>(channel - 1)) = row;
        connect(row, &CalibrationRow::useToggled, this, [this](int number, bool use) {
            const auto bit = static_cast<std::uint8_t>(1U << (number - 1));
            const std::uint8_t mask = m_calibration.channels();
            m_calibration.setChannels(static_cast<std::uint8_t>(use ? mask | bit : mask & ~bit));
        });
    }
    m_grid->setRowStretch(kChannelCount + 1, 1);
    scroll->setWidget(inside);
    scroll->setWidgetResizable(true);
    scroll->setFrameShape(QFrame::NoFrame);
    scroll->setHorizontalScrollBarPolicy(Qt::ScrollBarAsNeeded);
    return scroll;
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
    m_cancel = named(new QPushButton(tr("Cancel"), bar), u"calibration.cancel"_s,
                     tr("Cancel the calibration"));
    m_back = named(new QPushButton(tr("Back"), bar), u"calibration.back"_s, tr("Back one step"));
    m_next = named(new QPushButton(bar), u"calibration.next"_s);
    layout->addWidget(m_reason, 1);
    layout->addWidget(m_cancel);
    layout->addSpacing(8);
    layout->addWidget(m_back);
    layout->addWidget(m_next);
    connect(m_cancel, &QPushButton::clicked, &m_calibration, &ChannelCalibration::cancel);
    connect(m_back, &QPushButton::clicked, &m_calibration, &ChannelCalibration::back);
    connect(m_next, &QPushButton::clicked, &m_calibration, &ChannelCalibration::next);
    return bar;
}

QString CalibrationWizard::page() const
{
    return m_calibration.stepKey();
}

void CalibrationWizard::applyTheme()
{
    m_instruction->setFont(theme::font(1.5));
    for (QLabel* header : m_headers) {
        theme::setTextColour(*header, ColourRole::DimText);
    }
    theme::setTextColour(*m_steps, ColourRole::DimText);
    theme::setTextColour(*m_reason, ColourRole::DimText);
    for (CalibrationRow* row : m_rows) {
        row->applyTheme();
    }
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

void CalibrationWizard::applyStep()
{
    const Step step = m_calibration.step();
    const bool isNumbers = step != Step::Choose && !m_calibration.isCollecting();
    for (QLabel* header : m_headers) {
        header->setVisible(isNumbers);
    }
    m_grid->setColumnStretch(1, isNumbers ? 0 : 3);
    m_grid->setColumnStretch(CalibrationRow::kColumns - 1, isNumbers ? 3 : 0);
    for (CalibrationRow* row : m_rows) {
        row->applyStep(m_calibration);
    }
    m_countdown->setVisible(step == Step::Neutral);
    m_next->setText(calibrationpages::nextText(m_calibration));
    m_next->setAccessibleName(m_next->text());
    showSteps();
    refresh();
    showButtons();
}

void CalibrationWizard::showSteps()
{
    const QStringList titles = calibrationpages::stepTitles();
    const int present = calibrationpages::stepIndex(m_calibration);
    QStringList parts;
    for (qsizetype i = 0; i < titles.size(); ++i) {
        const QString part = u"%1 %2"_s.arg(i + 1).arg(titles.at(i).toHtmlEscaped());
        parts << (i == present ? u"<b style=\"color:%2\">%1</b>"_s.arg(
                      part, theme::colour(ColourRole::Text).name())
                               : part);
    }
    m_steps->setText(parts.join(u" &nbsp;›&nbsp; "_s));
}

void CalibrationWizard::showButtons()
{
    const Step step = m_calibration.step();
    const QString reason = m_calibration.whyNot();
    m_next->setEnabled(reason.isEmpty());
    m_reason->setText(reason);
    m_back->setEnabled(m_calibration.isCollecting() || step == Step::Review);
    m_cancel->setEnabled(m_calibration.isRunning());
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

void CalibrationWizard::refresh()
{
    m_instruction->setText(calibrationpages::instruction(m_calibration));
    const auto notice = calibrationpages::notice(m_calibration);
    m_notice->setText(notice.text);
    m_notice->setVisible(!notice.text.isEmpty());
    m_noticeMark->setVisible(!notice.text.isEmpty());
    m_noticeMark->setState(notice.shape, {});
    if (m_calibration.step() == Step::Neutral) {
        const auto* learner = m_calibration.learner();
        const double share = std::chrono::duration<double>(learner->neutralRemaining())
            / std::chrono::duration<double>(learner->stillTime());
        m_countdown->setValue(
            static_cast<int>((1.0 - std::clamp(share, 0.0, 1.0)) * kProgressSteps));
    }
    for (int channel = 1; channel <= kChannelCount; ++channel) {
        m_rows.at(static_cast<std::size_t>(channel - 1))
            ->refresh(m_calibration, freshReading(channel));
    }
}

} // namespace trex
