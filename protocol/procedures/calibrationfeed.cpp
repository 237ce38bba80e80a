// SPDX-License-Identifier: GPL-3.0-or-later
#include "protocol/procedures/calibrationfeed.h"

#include "protocol/telemetry/streamtable.h"
#include "protocol/telemetry/telemetrystore.h"

#include <utility>

using namespace std::chrono_literals;

namespace trex {
namespace {

constexpr double kSampleHertz = 50.0; // pulses and voltages are updated at 50 Hz (0x86)
constexpr auto kAskInterval = 20ms;
constexpr std::array<std::string_view, kChannelCount> kStreamKeys{
    "channel1-raw", "channel2-raw", "channel3-raw", "channel4-raw", "channel5-raw"};

} // namespace

StoreFeed::StoreFeed(Controller& controller, const TelemetryStore& store,
                     ChannelCalibration& calibration, QObject* parent)
    : QObject(parent), m_controller(controller), m_store(store), m_calibration(calibration)
{
    connect(&calibration, &ChannelCalibration::stepChanged, this, &StoreFeed::onStep);
    connect(&controller, &Controller::batchArrived, this, &StoreFeed::onBatch);
}

StoreFeed::~StoreFeed()
{
    m_controller.wantNothing(this);
}

void StoreFeed::onStep()
{
    const bool wants = m_calibration.isCollecting();
    if (wants && !m_isWanting) {
        m_next = m_store.series(kStreamKeys.front()).size(); // only what is read from now on
        m_clears = m_store.clears();
    }
    if (wants != std::exchange(m_isWanting, wants)) {
        m_controller.want(this, PollId::RawChannels, wants ? kSampleHertz : 0.0);
    }
}

void StoreFeed::onBatch()
{
    if (m_store.clears() != m_clears) {
        m_clears = m_store.clears();
        m_next = 0;
    }
    const auto& first = m_store.series(kStreamKeys.front());
    m_next = std::max(m_next, first.first());
    for (; m_isWanting && m_next < first.size(); ++m_next) {
        PollSample sample{PollId::RawChannels, {}, first.time(m_next)};
        for (std::size_t i = 0; i < kStreamKeys.size(); ++i) {
            sample.raw.at(i) =
                static_cast<std::uint16_t>(m_store.series(kStreamKeys.at(i)).value(m_next));
        }
        m_calibration.feed(sample);
    }
}

RequestFeed::RequestFeed(Controller& controller, ChannelCalibration& calibration, QObject* parent)
    : QObject(parent), m_controller(controller), m_calibration(calibration), m_timer(this)
{
    m_timer.setInterval(kAskInterval);
    m_timer.setTimerType(Qt::PreciseTimer);
    connect(&m_timer, &QTimer::timeout, this, &RequestFeed::ask);
    connect(&calibration, &ChannelCalibration::stepChanged, this,
            [this] { m_calibration.isCollecting() ? m_timer.start() : m_timer.stop(); });
}

void RequestFeed::ask()
{
    if (std::exchange(m_isAsking, true)) {
        return;
    }
    m_controller.request(pollCommand(PollId::RawChannels), this,
                         [this](const Result<Reply>& reply) {
                             m_isAsking = false;
                             if (reply) {
                                 m_calibration.feed(decodePoll(PollId::RawChannels, reply->payload,
                                                               reply->received));
                             }
                         });
}

} // namespace trex
