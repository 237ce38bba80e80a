// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/panelregistry.h"

#include "widgets/bench/benchpanel.h"
#include "widgets/calibration/calibrationpanel.h"
#include "widgets/channels/channelspanel.h"
#include "widgets/connection/connectionpanel.h"
#include "widgets/currents/currentspanel.h"
#include "widgets/health/healthpanel.h"
#include "widgets/log/logpanel.h"
#include "widgets/motors/motorspanel.h"
#include "widgets/packets/packetspanel.h"
#include "widgets/parameters/parameterspanel.h"
#include "widgets/plots/plotspanel.h"
#include "widgets/status/statuspanel.h"

#include <QCoreApplication>

#include <array>

namespace trex {

namespace {

template <class T>
Panel* make(PanelContext& context, QWidget* parent)
{
    return new T(context, parent);
}

/// The window has no centre of its own: the top and the bottom area share the middle column.
// clang-format off
constexpr std::array kPanels {
    PanelRow {.id = "connection",  .title = QT_TRANSLATE_NOOP("Panels", "Connection"),     .icon = "connection", .area = Qt::LeftDockWidgetArea,   .order = 0, .make = make<ConnectionPanel>},
    PanelRow {.id = "status",      .title = QT_TRANSLATE_NOOP("Panels", "Status"),         .icon = "status",     .area = Qt::LeftDockWidgetArea,   .order = 0, .make = make<StatusPanel>, .inRecordings = true},
    PanelRow {.id = "motors",      .title = QT_TRANSLATE_NOOP("Panels", "Motors"),         .icon = "motor",      .area = Qt::LeftDockWidgetArea,   .order = 1, .make = make<MotorsPanel>, .inRecordings = true},
    PanelRow {.id = "currents",    .title = QT_TRANSLATE_NOOP("Panels", "Motor currents"), .icon = "currents",   .area = Qt::TopDockWidgetArea,    .order = 0, .make = make<CurrentsPanel>, .inRecordings = true},
    PanelRow {.id = "plots",       .title = QT_TRANSLATE_NOOP("Panels", "Plots"),          .icon = "plots",      .area = Qt::TopDockWidgetArea,    .order = 0, .make = make<PlotsPanel>, .inRecordings = true},
    PanelRow {.id = "parameters",  .title = QT_TRANSLATE_NOOP("Panels", "Parameters"),     .icon = "parameters", .area = Qt::BottomDockWidgetArea, .order = 0, .make = make<ParametersPanel>, .inRecordings = true},
    PanelRow {.id = "packets",     .title = QT_TRANSLATE_NOOP("Panels", "Packets"),        .icon = "packets",    .area = Qt::BottomDockWidgetArea, .order = 0, .make = make<PacketsPanel>, .inRecordings = true},
    PanelRow {.id = "log",         .title = QT_TRANSLATE_NOOP("Panels", "Log"),            .icon = "log",        .area = Qt::BottomDockWidgetArea, .order = 0, .make = make<LogPanel>, .inRecordings = true},
    PanelRow {.id = "health",      .title = QT_TRANSLATE_NOOP("Panels", "Link health"),    .icon = "link",       .area = Qt::BottomDockWidgetArea, .order = 0, .make = make<HealthPanel>},
    PanelRow {.id = "calibration", .title = QT_TRANSLATE_NOOP("Panels", "Calibration"),    .icon = "calibrate",  .area = Qt::BottomDockWidgetArea, .order = 0, .make = make<CalibrationPanel>},
    PanelRow {.id = "bench",       .title = QT_TRANSLATE_NOOP("Panels", "Bench tests"),    .icon = "play",       .area = Qt::BottomDockWidgetArea, .order = 0, .make = make<BenchPanel>},
    PanelRow {.id = "channels",    .title = QT_TRANSLATE_NOOP("Panels", "Channels"),       .icon = "channels",   .area = Qt::RightDockWidgetArea,  .order = 0, .make = make<ChannelsPanel>, .inRecordings = true},
};
// clang-format on

} // namespace

std::span<const PanelRow> panels()
{
    return kPanels;
}

} // namespace trex
