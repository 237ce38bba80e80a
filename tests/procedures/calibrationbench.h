// SPDX-License-Identifier: GPL-3.0-or-later
// A guided calibration over a simulated controller, with sticks that a test moves.
#pragma once

#include "protocol/procedures/channelcalibration.h"
#include "protocol/telemetry/statuslatch.h"
#include "protocol/telemetry/telemetrystore.h"
#include "tests/procedures/generatedstick.h"

#include <QTest>

namespace trex::test {

constexpr const ParameterRow& kReversed = parameterRow("reversed-channels");
inline const Calibration kDefaultRc{2500, 3750, 5000, 100}; // of the simulator (conformance C-63)

/// A calibration over a simulated controller; samples are made up, their time runs as fast as they
/// are fed.
struct CalibrationBench {
    TelemetryStore store;
    StatusLatch latch;
    Controller controller{&store, &latch};
    DeviceSettings settings{controller};
    ChannelCalibration calibration{controller, settings};
    Instant now = Instant{} + std::chrono::hours(1);

    CalibrationBench() { calibration.setOptionalSteps(false); }

    [[nodiscard]] bool connectTo(const QString& port)
    {
        controller.open({.port = port, .line = {}});
        return QTest::qWaitFor([this] {
            return controller.state() == LinkState::Connected && controller.device().mode;
        });
    }
    [[nodiscard]] bool waitFor(ChannelCalibration::Step step, int timeoutMs = 5000)
    {
        return QTest::qWaitFor([this, step] { return calibration.step() == step; }, timeoutMs);
    }
    void feedAll(const std::array<int, kChannelCount>& raw, Duration time)
    {
        for (const Instant end = now + time; now < end;) {
            now += GeneratedStick::kInterval;
            PollSample sample{PollId::RawChannels, {}, now};
            for (std::size_t i = 0; i < raw.size(); ++i) {
                sample.raw.at(i) = static_cast<std::uint16_t>(raw.at(i));
            }
            calibration.feed(sample);
        }
    }
    /// One channel moves, the others rest.
    void feedOne(int channel, int raw, Duration time)
    {
        std::array<int, kChannelCount> all;
        all.fill(3700);
        all.at(static_cast<std::size_t>(channel - 1)) = raw;
        feedAll(all, time);
    }
    void feed(int raw, Duration time) { feedAll({raw, raw, raw, raw, raw}, time); }
    void feedNeutral() { feed(3700, std::chrono::milliseconds(2200)); }
    void feedSweep()
    {
        feed(2600, std::chrono::seconds(1));
        feed(4900, std::chrono::seconds(1));
        feed(3700, std::chrono::seconds(2));
    }
    /// From choosing to the page behind the extremes, as a person goes who skips the returns.
    [[nodiscard]] bool goToDirection(std::uint8_t channels)
    {
        calibration.setOptionalSteps(true);
        calibration.setChannels(channels);
        calibration.next();
        if (!waitFor(ChannelCalibration::Step::Neutral)) {
            return false;
        }
        feedNeutral();
        calibration.next();
        calibration.next();
        feedSweep();
        calibration.next();
        return calibration.step() == ChannelCalibration::Step::Direction;
    }
    [[nodiscard]] std::optional<int> parameter(const ParameterRow& row)
    {
        std::optional<int> result;
        bool isDone = false;
        settings.readParameter(row, &calibration, [&](const Result<int>& read) {
            isDone = true;
            result = read ? std::optional(*read) : std::nullopt;
        });
        (void)QTest::qWaitFor([&isDone] { return isDone; });
        return result;
    }
    /// Calls `what` as soon as that item is being written.
    template <class F>
    void whenWriting(int item, F what)
    {
        QObject::connect(&calibration, &Procedure::progressed, &controller,
                         [this, item, what](int begun, int, const QString&) {
                             if (begun == item) {
                                 QMetaObject::invokeMethod(&controller, what, Qt::QueuedConnection);
                             }
                         });
    }
    /// From choosing to the review.
    [[nodiscard]] bool learnAll()
    {
        calibration.next();
        if (!waitFor(ChannelCalibration::Step::Neutral)) {
            return false;
        }
        feedNeutral();
        calibration.next();
        feedSweep();
        calibration.next();
        return calibration.step() == ChannelCalibration::Step::Review;
    }
    [[nodiscard]] std::optional<Calibration> stored(int channel)
    {
        std::optional<Calibration> result;
        bool isDone = false;
        settings.readCalibration(channel, &calibration, [&](const Result<Calibration>& read) {
            isDone = true;
            result = read ? std::optional(*read) : std::nullopt;
        });
        (void)QTest::qWaitFor([&isDone] { return isDone; });
        return result;
    }
    [[nodiscard]] bool isUntouched()
    {
        for (int channel = 1; channel <= kChannelCount; ++channel) {
            if (stored(channel) != kDefaultRc) {
                return false;
            }
        }
        return true;
    }
};

} // namespace trex::test
