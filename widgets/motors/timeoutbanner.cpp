// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/motors/timeoutbanner.h"

#include "protocol/session/controller.h"
#include "protocol/session/serialtimeoutwatch.h"
#include "widgets/common/stateshape.h"
#include "widgets/common/theme.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QPainter>
#include <QPushButton>

namespace trex {

using namespace Qt::Literals::StringLiterals;

namespace {

constexpr int kShapeSize = 14;
constexpr int kUnitMs = 100; // facts.md 2, 0x07

bool isWritable(const Controller& controller)
{
    const auto mode = controller.device().mode;
    return mode && isSerial(*mode); // conformance C-38: refused elsewhere
}

} // namespace

TimeoutBanner::TimeoutBanner(PanelContext& context, QWidget* parent)
    : QWidget(parent)
    , m_context(context)
    , m_text(named(new QLabel(this), u"motors.timeoutWarning"_s, tr("Serial timeout")))
    , m_set(named(new QPushButton(this), u"motors.setTimeout"_s))
{
    m_text->setWordWrap(true);
    m_text->setText(
        tr("Serial timeout off: if this program or its line fails, the motors run on."));
    m_set->setText(tr("Set %1 ms").arg(SerialTimeoutWatch::kSensible * kUnitMs));
    m_set->setAccessibleName(
        tr("Set the serial timeout to %1 ms").arg(SerialTimeoutWatch::kSensible * kUnitMs));
    auto* row = new QHBoxLayout(this);
    row->setContentsMargins(kShapeSize + 8, 0, 0, 0);
    row->setSpacing(8);
    row->addWidget(m_text, 1);
    row->addWidget(m_set);
    if (context.timeoutWatch == nullptr) {
        hide();
        return;
    }
    connect(m_set, &QPushButton::clicked, this, [this] {
        m_set->setEnabled(false);
        m_context.timeoutWatch->setIt();
    });
    connect(context.timeoutWatch, &SerialTimeoutWatch::changed, this, &TimeoutBanner::refresh);
    connect(&context.controller, &Controller::deviceChanged, this, &TimeoutBanner::refresh);
    refresh();
}

void TimeoutBanner::refresh()
{
    setVisible(m_context.timeoutWatch->state() == SerialTimeoutWatch::State::Off);
    const bool may = isWritable(m_context.controller);
    m_set->setEnabled(may);
    m_set->setToolTip(
        may ? tr("Writes the parameter and reads it back. The motors then stop when the controller "
                 "has heard nothing for so long; while it is armed, this program sees to it that "
                 "it always hears something.")
            : tr("Settings can be written in serial mode only (mode jumper off)."));
}

void TimeoutBanner::paintEvent(QPaintEvent* /*event*/)
{
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    drawStateShape(painter, QRectF(0, (height() - kShapeSize) / 2.0, kShapeSize, kShapeSize),
                   StateShape::Warning);
}

} // namespace trex
