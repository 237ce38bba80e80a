// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "protocol/procedures/calibrationlearner.h"

#include "tests/procedures/generatedstick.h"

#include <QTest>

#include <functional>

namespace trex {

/// Five channels on a learner; a test says where each stands.
class Bench {
public:
    explicit Bench(InputKind input = InputKind::Rc, std::uint8_t mask = 0b00011)
        : learner(input, mask)
    {
        at.fill(input == InputKind::Rc ? 3750 : 512);
        learner.beginNeutral();
    }

    void hold(Duration time)
    {
        for (const Instant end = now + time; now < end;) {
            step();
        }
    }
    /// Moves to a place within a tenth of a second, and holds it there.
    void move(int channel, int raw, Duration time)
    {
        auto& place = at.at(static_cast<std::size_t>(channel - 1));
        const int from = place;
        for (int i = 1; i <= 5; ++i) {
            place = from + (raw - from) * i / 5;
            step();
        }
        hold(time);
    }
    void learnNeutral()
    {
        hold(std::chrono::milliseconds(2500));
        QVERIFY(learner.isNeutralDone());
    }
    /// Both ends of a channel, and back.
    void sweep(int channel, int low, int high)
    {
        const int rest = at.at(static_cast<std::size_t>(channel - 1));
        move(channel, high, std::chrono::milliseconds(600));
        move(channel, low, std::chrono::milliseconds(600));
        move(channel, rest, std::chrono::milliseconds(300));
    }
    void learnAll(int low = 2500, int high = 5000)
    {
        learnNeutral();
        learner.beginExtremes();
        for (int channel = 1; channel <= kChannelCount; ++channel) {
            if (learner.isUsed(channel)) {
                sweep(channel, low, high);
            }
        }
        hold(std::chrono::seconds(2));
        QVERIFY(learner.areExtremesDone());
    }

    CalibrationLearner learner;
    std::array<int, kChannelCount> at{};
    Instant now{};
    std::function<int(int channel, int raw)> disturb; ///< what is read instead

private:
    void step()
    {
        now += GeneratedStick::kInterval;
        PollSample sample{PollId::RawChannels, {}, now};
        for (std::size_t i = 0; i < at.size(); ++i) {
            const int raw = at[i] + m_noise[m_count++ % std::size(m_noise)];
            sample.raw[i] = static_cast<std::uint16_t>(
                std::clamp(disturb ? disturb(static_cast<int>(i) + 1, raw) : raw, 0, 0xFFFF));
        }
        learner.feed(sample);
    }
    static constexpr int m_noise[] = {0, 1, 0, -1, 0, 0, 1, -1, 0, 1, -1};
    std::size_t m_count = 0;
};

} // namespace trex
