// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "protocol/session/transaction.h"
#include "protocol/session/writerecorder.h"
#include "protocol/telemetry/marktrack.h"
#include "protocol/telemetry/statuslatch.h"

#include <QObject>

namespace trex {

class Controller;
class DeviceSettings;

/// Writes down what happens to one controller and by the person's hand, as marks beside the
/// samples. The only place that fills the live MarkTrack. Main thread.
class MarkKeeper : public QObject {
    Q_OBJECT
    Q_DISABLE_COPY_MOVE(MarkKeeper)

public:
    /// All outlive it.
    MarkKeeper(MarkTrack& track, Controller& controller, const StatusLatch& latch,
               DeviceSettings& settings, QObject* parent = nullptr);
    /// The marks of bits that a read found set and the read before did not.
    [[nodiscard]] static std::vector<Mark> marksOf(StatusLatch::Byte byte, std::uint8_t risen,
                                                   Instant time);

private:
    void add(MarkKind kind, const QString& text = {});
    void onState(LinkState state);
    void onLatch();
    void onWrite(const WriteIntent& intent, const WriteConclusion& conclusion);

    MarkTrack& m_track;
    Controller& m_controller;
    const StatusLatch& m_latch;
    std::array<std::array<bool, 8>, 2> m_wasLit{}; ///< by byte and bit
    bool m_isOpen = false; ///< connected, or trying to be again
    bool m_isLost = false;
};

} // namespace trex
