// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/calibration/calibrationrow.h"

#include "protocol/procedures/calibrationtext.h"
#include "widgets/calibration/calibrationpages.h"
#include "widgets/calibration/statemark.h"
#include "widgets/channels/channelbar.h"
#include "widgets/common/panel.h"
#include "widgets/common/theme.h"

#include <QCheckBox>
#include <QGridLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QRegularExpression>
#include <QSignalBlocker>
#include <QVBoxLayout>

namespace trex {

using namespace Qt::Literals::StringLiterals;

namespace {

using Step = ChannelCalibration::Step;

constexpr int kBarHeight = 28; // legible from an arm's length
// So that nothing jumps when words and figures change, in characters.
constexpr int kStateWidth = 16;
constexpr int kDetailWidth = 26;
constexpr int kDirectionDetailWidth = 22; // beside a box and a button

constexpr std::array<QLatin1StringView, 4> kNumberNames{"minimum"_L1, "neutral"_L1, "maximum"_L1,
                                                        "deadband"_L1};

std::array<int, 4> numbersOf(const Calibration& calibration)
{
    return {calibration.minimum, calibration.neutral, calibration.maximum, calibration.deadband};
}

bool hasNumbers(Step step)
{
    return step == Step::Review || step == Step::Writing || step == Step::Done
        || step == Step::Stopped;
}

std::optional<int> usable(std::optional<int> raw)
{
    return raw && *raw != kInvalidPulse ? raw : std::nullopt;
}

/// A figure and its unit stay on one line.
QString withItsUnits(QString text)
{
    static const QRegularExpression gap(u"(?<=\\d) (?=(µs|ms|V|%)(\\W|$))|(?<=σ) "_s);
    return text.replace(gap, QString(QChar::Nbsp));
}

void setColour(QWidget* widget, ColourRole role)
{
    theme::setTextColour(*widget, role);
}

/// The numbers to show: what is in the controller, as far as is known; while reviewing and writing,
/// what was learned for it.
std::optional<Calibration> present(const ChannelCalibration& calibration, int channel)
{
    using WriteState = ChannelCalibration::WriteState;
    if (const auto readBack = calibration.readBack(channel)) {
        return readBack;
    }
    if (calibration.writeState(channel) == WriteState::Failed) {
        return std::nullopt; // old or new, nobody knows
    }
    const bool isPlanned = calibration.step() == Step::Review
        || (calibration.step() == Step::Writing && calibration.isChosen(channel));
    const auto planned = calibration.planned(channel);
    return isPlanned && planned ? planned : calibration.before(channel);
}

} // namespace

CalibrationRow::CalibrationRow(int channel, QGridLayout* grid, int line, QWidget* parent)
    : QObject(parent)
    , m_channel(channel)
    , m_use(named(new QCheckBox(tr("Channel %1").arg(channel), parent),
                  u"calibration.%1.use"_s.arg(channel), tr("Use channel %1").arg(channel)))
    , m_bar(named(new ChannelBar(channel, parent), u"calibration.%1.bar"_s.arg(channel)))
    , m_state(named(new StateMark(parent), u"calibration.%1.state"_s.arg(channel),
                    tr("State of channel %1").arg(channel)))
    , m_reverse(named(new QCheckBox(tr("Reverse"), parent),
                      u"calibration.%1.reversed"_s.arg(channel),
                      tr("Reverse channel %1").arg(channel)))
    , m_again(named(new QPushButton(theme::icon(u"refresh"_s), {}, parent),
                    u"calibration.%1.again"_s.arg(channel),
                    tr("Find the direction of channel %1 again").arg(channel)))
    , m_detail(named(new QLabel(parent), u"calibration.%1.detail"_s.arg(channel),
                     tr("Details of channel %1").arg(channel)))
{
    m_bar->setRemappedShown(false);
    m_bar->setFixedHeight(kBarHeight);
    m_detail->setTextFormat(Qt::PlainText);
    m_detail->setWordWrap(true);
    grid->addWidget(m_use, line, 0);
    grid->addWidget(m_bar, line, 1);
    addNumbers(grid, line, parent);
    auto* state = new QVBoxLayout;
    state->setSpacing(0);
    state->addStretch(1);
    state->addWidget(m_state);
    auto* direction = new QHBoxLayout; // side by side: there is no room for a column of its own
    direction->setSpacing(4);
    direction->addWidget(m_reverse, 1);
    direction->addWidget(m_again);
    state->addLayout(direction);
    state->addStretch(1);
    grid->addLayout(state, line, kColumns - 2);
    grid->addWidget(m_detail, line, kColumns - 1);
    m_reverse->setToolTip(
        tr("Parameter 0x03: forward and reverse change places on this channel. Only its own bit "
           "is written."));
    m_again->setFixedSize(26, 22);
    m_again->setToolTip(tr("Push this channel forward once more."));
    connect(m_use, &QCheckBox::toggled, this,
            [this](bool use) { emit useToggled(m_channel, use); });
    connect(m_reverse, &QCheckBox::toggled, this,
            [this](bool reverse) { emit reverseToggled(m_channel, reverse); });
    connect(m_again, &QPushButton::clicked, this, [this] { emit againAsked(m_channel); });
}

void CalibrationRow::addNumbers(QGridLayout* grid, int line, QWidget* parent)
{
    const std::array<QString, 4> titles{tr("Minimum"), tr("Neutral"), tr("Maximum"),
                                        tr("Deadband")};
    for (std::size_t i = 0; i < m_numbers.size(); ++i) {
        Number& number = m_numbers.at(i);
        number.cell = new QWidget(parent);
        auto* layout = new QVBoxLayout(number.cell);
        layout->setContentsMargins(0, 0, 0, 0);
        layout->setSpacing(0);
        layout->addStretch(1);
        number.now = named(new QLabel(number.cell),
                           u"calibration.%1.%2"_s.arg(m_channel).arg(kNumberNames.at(i)),
                           tr("%1 of channel %2").arg(titles.at(i)).arg(m_channel));
        number.before = new QLabel(number.cell);
        number.before->setAccessibleName(
            tr("%1 of channel %2 before").arg(titles.at(i)).arg(m_channel));
        for (QLabel* label : {number.now, number.before}) {
            label->setAlignment(Qt::AlignRight | Qt::AlignVCenter);
            layout->addWidget(label);
        }
        layout->addStretch(1);
        grid->addWidget(number.cell, line, kFirstNumber + static_cast<int>(i));
    }
}

void CalibrationRow::applyTheme()
{
    for (const Number& number : m_numbers) {
        number.now->setFont(theme::font(1.0, true));
        number.before->setFont(theme::font(0.85, true));
        setColour(number.before, ColourRole::DimText);
    }
    m_detail->setFont(theme::font(1.0, true));
    setColour(m_detail, ColourRole::DimText);
}

void CalibrationRow::applyStep(const ChannelCalibration& calibration)
{
    const Step step = calibration.step();
    const bool isNumbers = hasNumbers(step);
    m_bar->setVisible(!isNumbers);
    m_bar->setMinimumWidth(step == Step::Direction ? 80 : 120); // there is more beside it
    for (const Number& number : m_numbers) {
        number.cell->setVisible(isNumbers);
    }
    const int digit = m_detail->fontMetrics().averageCharWidth();
    m_detail->setMinimumWidth(digit
                              * (step == Step::Direction ? kDirectionDetailWidth : kDetailWidth));
    showDirection(calibration);
    m_state->setLeastWidth(digit * kStateWidth);
    if (isNumbers) {
        showNumbers(calibration);
    }
}

void CalibrationRow::showNumbers(const ChannelCalibration& calibration)
{
    const InputKind input = calibration.input();
    const auto now = present(calibration, m_channel);
    const auto before = calibration.before(m_channel);
    for (std::size_t i = 0; i < m_numbers.size(); ++i) {
        const bool isSpan = i == 3;
        const auto text = [&](const std::optional<Calibration>& from) {
            if (!from) {
                return u"–"_s;
            }
            const int raw = numbersOf(*from).at(i);
            return isSpan ? u"±"_s + spanText(raw, input) : readingText(raw, input);
        };
        const Number& number = m_numbers.at(i);
        number.now->setText(text(now));
        number.now->setProperty("raw", now ? numbersOf(*now).at(i) : -1);
        number.now->setToolTip(now ? tr("Raw value %1").arg(numbersOf(*now).at(i)) : QString());
        const bool isSame = !now || !before || *now == *before;
        number.before->setText(isSame ? QString() : tr("was %1").arg(text(before)));
        number.before->setVisible(!isSame);
        const bool isChanged = now && before && numbersOf(*now).at(i) != numbersOf(*before).at(i);
        QFont font = theme::font(1.0, true);
        font.setBold(isChanged);
        number.now->setFont(font);
    }
}

void CalibrationRow::showDirection(const ChannelCalibration& calibration)
{
    const Step step = calibration.step();
    const bool hasDirection = ChannelCalibration::hasDirection(m_channel);
    const bool isLearned = calibration.planned(m_channel).has_value();
    const bool isAsked = step == Step::Direction && calibration.isChosen(m_channel);
    m_reverse->setVisible(hasDirection && isLearned && (isAsked || step == Step::Review));
    m_reverse->setEnabled(isAsked || calibration.isChosen(m_channel));
    const QSignalBlocker blocker(m_reverse);
    m_reverse->setChecked(calibration.isReversed(m_channel));
    const bool isChanged = calibration.isReversed(m_channel) != calibration.wasReversed(m_channel);
    QFont font = m_reverse->font();
    font.setBold(isChanged);
    m_reverse->setFont(font);
    m_again->setVisible(hasDirection && isAsked && calibration.direction(m_channel).has_value());
}

void CalibrationRow::showBar(const ChannelCalibration& calibration, std::optional<int> raw)
{
    m_bar->setInput(calibration.input());
    const bool isTrying = calibration.step() == Step::Verify;
    m_bar->setCalibration(isTrying && calibration.planned(m_channel)
                              ? calibration.planned(m_channel)
                              : calibration.before(m_channel));
    if (raw) {
        m_bar->setRaw(*raw);
    }
    m_bar->setStale(!raw);
    std::optional<ChannelBar::Travel> travel;
    if (calibration.step() == Step::Extremes && calibration.isChosen(m_channel)) {
        const auto& learner = calibration.learner()->channel(m_channel);
        const int neutral = static_cast<int>(learner.neutral());
        travel = {neutral - learner.lowTravel(), neutral + learner.highTravel()};
    }
    m_bar->setTravel(travel);
}

void CalibrationRow::refresh(const ChannelCalibration& calibration, std::optional<int> raw)
{
    const Step step = calibration.step();
    const bool isAcceptable = calibration.planned(m_channel).has_value();
    {
        const QSignalBlocker blocker(m_use);
        m_use->setChecked(calibration.isChosen(m_channel));
    }
    m_use->setEnabled((step == Step::Choose && !calibration.isPreparing())
                      || (step == Step::Review && isAcceptable));
    showDirection(calibration);
    if (!hasNumbers(step)) {
        showBar(calibration, raw);
    } else if (step != Step::Review) {
        showNumbers(calibration); // as they are read back
    }
    auto state = calibrationpages::channelState(calibration, m_channel, usable(raw));
    if (step == Step::Choose) {
        state.detail = m_bar->text();
    }
    m_state->setState(state.shape, state.word);
    m_state->setToolTip(state.figures);
    m_detail->setText(withItsUnits(state.detail));
    m_detail->setToolTip(state.figures);
}

} // namespace trex
