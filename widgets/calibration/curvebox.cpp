// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/calibration/curvebox.h"

#include "widgets/calibration/calibrationpages.h"
#include "widgets/calibration/responsecurveview.h"
#include "widgets/common/panel.h"
#include "widgets/common/theme.h"

#include <QComboBox>
#include <QLabel>
#include <QVBoxLayout>

namespace trex {

using namespace Qt::Literals::StringLiterals;

CurveBox::CurveBox(QWidget* parent)
    : QWidget(parent)
    , m_channel(named(new QComboBox(this), u"calibration.curveChannel"_s,
                      tr("Channel whose response is drawn")))
    , m_curve(named(new ResponseCurveView(this), u"calibration.curve"_s))
    , m_figures(named(new QLabel(this), u"calibration.figures"_s, tr("Confidence in figures")))
{
    for (int channel = 1; channel <= kChannelCount; ++channel) {
        m_channel->addItem(tr("Response of channel %1").arg(channel), channel);
    }
    m_figures->setTextFormat(Qt::PlainText);
    m_figures->setWordWrap(true);
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(4);
    layout->addWidget(m_channel, 0, Qt::AlignLeft);
    layout->addWidget(m_curve, 1);
    layout->addWidget(m_figures);
    connect(m_channel, &QComboBox::currentIndexChanged, this, &CurveBox::channelChanged);
}

void CurveBox::applyTheme()
{
    m_figures->setFont(theme::font(0.85, true));
    theme::setTextColour(*m_figures, ColourRole::DimText);
}

int CurveBox::channel() const
{
    return m_channel->currentIndex() + 1;
}

void CurveBox::applyStep(const ChannelCalibration& calibration)
{
    using Step = ChannelCalibration::Step;
    const bool isFirst = calibration.step() == Step::Neutral;
    for (int channel = 1;
         isFirst && !calibration.isChosen(this->channel()) && channel <= kChannelCount; ++channel) {
        if (calibration.isChosen(channel)) {
            m_channel->setCurrentIndex(channel - 1);
        }
    }
    m_followed = 0;
}

void CurveBox::refresh(const ChannelCalibration& calibration, std::optional<int> raw)
{
    const bool isAsked = calibration.step() == ChannelCalibration::Step::Direction
        && calibration.directionChannel() != 0;
    if (isAsked && calibration.directionChannel() != m_followed) {
        m_followed = calibration.directionChannel();
        m_channel->setCurrentIndex(m_followed - 1);
    }
    const int shown = channel();
    m_curve->setCurves(shown, calibration.input(), calibration.curveBefore(shown),
                       calibration.curveAfter(shown));
    m_curve->setLive(raw && *raw != kInvalidPulse ? raw : std::nullopt);
    const bool isReview = calibration.step() == ChannelCalibration::Step::Review;
    m_figures->setText(isReview ? calibrationpages::confidence(calibration, shown) : QString());
    m_figures->setVisible(!m_figures->text().isEmpty());
}

} // namespace trex
