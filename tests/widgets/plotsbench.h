// SPDX-License-Identifier: GPL-3.0-or-later
// The Plots panel over a store that a test fills, on a clock of the test's own. Nothing is
// connected: what is drawn is what was put in.
#pragma once

#include "protocol/session/controller.h"
#include "protocol/session/devicesettings.h"
#include "protocol/telemetry/marktrack.h"
#include "protocol/telemetry/plotreferences.h"
#include "protocol/telemetry/statuslatch.h"
#include "protocol/telemetry/streamtable.h"
#include "protocol/telemetry/telemetrystore.h"
#include "widgets/common/eventlog.h"
#include "widgets/common/filedialogs.h"
#include "widgets/common/frameticker.h"
#include "widgets/common/plotframe.h"
#include "widgets/common/plottimeline.h"
#include "widgets/common/theme.h"
#include "widgets/common/uisettings.h"
#include "widgets/plots/plotspanel.h"
#include "widgets/plots/plotstack.h"

#include <QTemporaryDir>
#include <QTest>

#include <cmath>
#include <functional>
#include <random>

namespace trex::test {

inline const Instant kPlotsStart{std::chrono::hours(500)};

/// What a motor was told and what it draws, at a time in seconds.
struct Profile {
    std::function<int(double)> motor1;
    std::function<int(double)> motor2;
    double load = 1.0; ///< of the current that a free motor draws
};

/// Fills all streams as a session would: currents at 80 Hz, channels at 50, orders as they leave.
inline void fillSession(TelemetryStore& store, Instant start, double seconds,
                        const Profile& profile, unsigned seed = 3)
{
    std::mt19937 random(seed);
    const auto noise = [&random](double width) {
        return (double(random()) / double(std::mt19937::max()) - 0.5) * width;
    };
    const auto at = [start](double time) {
        return start + std::chrono::duration_cast<Duration>(std::chrono::duration<double>(time));
    };
    std::array<double, 2> speed{};
    std::array<int, 2> told{};
    constexpr double kStep = 0.0125;
    for (int i = 0; i * kStep < seconds; ++i) {
        const double time = i * kStep;
        std::array<std::uint16_t, 2> counts{};
        const std::array orders{profile.motor1(time), profile.motor2(time)};
        for (std::size_t m = 0; m < 2; ++m) {
            const double gap = orders[m] - speed[m];
            speed[m] += gap * 0.035;
            const double amperes = profile.load
                    * (std::abs(speed[m]) * 0.0065 + std::abs(gap) * 0.028
                       + 0.05 * std::abs(speed[m]) / 127.0
                           * std::sin(time * (31.0 + 4.0 * double(m))))
                + noise(0.07);
            counts[m] = std::uint16_t(std::clamp(std::lround(amperes / 0.04), 0L, 255L));
        }
        store.append({PollId::Currents, {counts[0], counts[1]}, at(time)});
        const auto stored = [](int value) { return std::uint16_t(value + kFullSpeed); };
        if (orders != told || i % 20 == 0) {
            store.append(Source::orders(), std::array{stored(told[0]), stored(told[1]), stored(0)},
                         at(time));
            store.append(Source::orders(),
                         std::array{stored(orders[0]), stored(orders[1]), stored(0)}, at(time));
            told = orders;
        }
        if (i % 2 == 0) {
            const auto pulse = [&](double middle, double swing) {
                return std::uint16_t(std::lround(middle + swing + noise(8.0)));
            };
            const auto remapped = [](double value) {
                const int whole = int(std::lround(value));
                return std::uint16_t(whole < 0 ? 0x80 - whole : whole);
            };
            const double stick1 = speed[0] * 0.9;
            const double stick2 = 90.0 * std::sin(time * 0.7);
            store.append({PollId::RawChannels,
                          {pulse(3700, stick1 * 8.0), pulse(3720, stick2 * 8.0), pulse(3750, 0),
                           pulse(2700, 0), pulse(4900, 0)},
                          at(time + 0.003)});
            store.append({PollId::RemappedChannels,
                          {remapped(stick1), remapped(stick2), 0, remapped(-100), remapped(100)},
                          at(time + 0.006)});
        }
    }
}

struct PlotsBench {
    PlotsBench()
        : file(folder.filePath(QStringLiteral("settings.ini")))
        , uiSettings(file)
        , controller(&store, &latch)
        , settings(controller)
        , context{controller, settings, store,   latch,  log,        uiSettings,
                  ticker,     dialogs,  nullptr, &marks, &references}
    {
    }
    /// The panel, as it would be at the next start of the program.
    void make(const QSize& size = {1280, 800})
    {
        panel = std::make_unique<PlotsPanel>(context);
        panel->setAutoFillBackground(true);
        panel->setBackgroundRole(QPalette::Base);
        panel->timeline().setClock([this] { return now; });
        panel->resize(size);
        panel->show();
        settle();
    }
    /// Draws what is new, and lets layouts come to rest.
    void settle()
    {
        for (int i = 0; i < 4; ++i) {
            emit ticker.tick();
            QCoreApplication::processEvents();
        }
    }
    [[nodiscard]] PlotPane& pane(std::size_t index) const { return *panel->stack().panes()[index]; }
    [[nodiscard]] PlotView& plot(std::size_t index) const { return pane(index).plot(); }
    template <class T>
    [[nodiscard]] T* part(const QString& name) const
    {
        return panel->findChild<T*>(name);
    }

    QTemporaryDir folder;
    SettingsFile file;
    UiSettings uiSettings;
    TelemetryStore store;
    StatusLatch latch;
    MarkTrack marks;
    PlotReferences references;
    Controller controller;
    DeviceSettings settings;
    EventLog log;
    FrameTicker ticker;
    FileDialogs dialogs;
    PanelContext context;
    Instant now = kPlotsStart;
    std::unique_ptr<PlotsPanel> panel;
};

} // namespace trex::test
