// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/common/plotlimits.h"

#include "protocol/codec/parametertable.h"
#include "protocol/session/devicesettings.h"
#include "widgets/common/plotframe.h"

#include <QCoreApplication>

namespace trex {

namespace {

struct LimitRow {
    const ParameterRow& row;
    ColourRole colour;
    const char* text; ///< QT_TRANSLATE_NOOP("PlotView", …)
};

const std::array kLimits{
    LimitRow{parameterRow("motor1-current-limit"), ColourRole::Motor1,
             QT_TRANSLATE_NOOP("PlotView", "limit 1: %1")},
    LimitRow{parameterRow("motor2-current-limit"), ColourRole::Motor2,
             QT_TRANSLATE_NOOP("PlotView", "limit 2: %1")},
};

} // namespace

std::vector<PlotView::Limit> currentLimits(const DeviceSettings& settings)
{
    std::vector<PlotView::Limit> found;
    for (const LimitRow& limit : kLimits) {
        const auto raw = settings.parameter(limit.row.number);
        if (raw && *raw > 0) { // 0 is probably no limit (parametertable.h)
            const double amperes = *raw * limit.row.scale;
            const QString value = valueText(amperes, limit.row.decimals, QStringLiteral("A"));
            found.push_back({amperes,
                             QCoreApplication::translate("PlotView", limit.text).arg(value),
                             limit.colour});
        }
    }
    return found;
}

} // namespace trex
