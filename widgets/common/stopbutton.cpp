// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/common/stopbutton.h"

#include "protocol/session/controller.h"
#include "widgets/common/theme.h"

namespace trex {

using namespace Qt::Literals::StringLiterals;

namespace {

constexpr int kLeastWidth = 160;

} // namespace

StopButton::StopButton(Controller& controller, QWidget* parent) : QPushButton(parent)
{
    setText(tr("STOP"));
    setProperty("role", u"stop"_s); // theme.cpp paints it by this
    setFont(theme::font(1.5));
    setAccessibleName(tr("Stop all motors"));
    setToolTip(tr("Stops all three motors at once (Esc, from anywhere)."));
    setFocusPolicy(Qt::TabFocus);
    connect(this, &QPushButton::pressed, &controller, [&controller] { controller.stop(); });
}

QSize StopButton::sizeHint() const
{
    const QSize usual = QPushButton::sizeHint();
    return {std::max(usual.width(), kLeastWidth), usual.height()};
}

} // namespace trex
