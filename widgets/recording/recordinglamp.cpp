// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/recording/recordinglamp.h"

#include "widgets/common/frameticker.h"
#include "widgets/common/panel.h"
#include "widgets/common/stateshape.h"
#include "widgets/common/theme.h"
#include "widgets/recording/recordings.h"

#include <QDir>
#include <QHBoxLayout>
#include <QLabel>
#include <QPainter>

namespace trex {

namespace {

constexpr int kShape = 12;
constexpr int kMargin = 4;
constexpr int kTicksBetween = 6; ///< a fifth of a second: no second is skipped

} // namespace

RecordingLamp::RecordingLamp(const Recordings& recordings, FrameTicker& ticker, QWidget* parent)
    : QWidget(parent)
    , m_recordings(recordings)
    , m_text(named(new QLabel(this), QStringLiteral("mainWindow.recording"), tr("Recording")))
{
    auto* row = new QHBoxLayout(this);
    row->setContentsMargins(kMargin + kShape + kMargin, 0, kMargin, 0);
    row->addWidget(m_text);
    m_text->setFont(theme::font(1.0, true));
    m_text->setTextFormat(Qt::PlainText);
    connect(&ticker, &FrameTicker::tick, this, &RecordingLamp::onTick);
    connect(&recordings, &Recordings::changed, this, &RecordingLamp::refresh);
    refresh();
}

void RecordingLamp::onTick()
{
    if (m_recordings.isRecording() && ++m_ticks >= kTicksBetween) {
        m_ticks = 0;
        refresh();
    }
}

void RecordingLamp::refresh()
{
    const QString problem = m_recordings.problem();
    const bool isRecording = m_recordings.isRecording();
    setVisible(isRecording || !problem.isEmpty());
    if (isRecording) {
        m_text->setText(tr("recording %1 · %2")
                            .arg(recordingTimeText(m_recordings.length()),
                                 recordingSizeText(m_recordings.bytes())));
        setToolTip(QDir::toNativeSeparators(m_recordings.path()));
    } else {
        m_text->setText(tr("recording ended: the file could not be written"));
        setToolTip(problem);
    }
    update();
}

/// A dot while it records, as on every recorder; an octagon for what went wrong.
void RecordingLamp::paintEvent(QPaintEvent* /*event*/)
{
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    const QRectF place(kMargin, (height() - kShape) / 2.0, kShape, kShape);
    if (!m_recordings.isRecording()) {
        drawStateShape(painter, place, StateShape::Fault);
        return;
    }
    painter.setPen(Qt::NoPen);
    painter.setBrush(theme::colour(ColourRole::Fault));
    painter.drawEllipse(place);
}

} // namespace trex
