// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "protocol/session/devicesettings.h"

#include <array>
#include <optional>

namespace trex {

/// What is to be written: calibrations of the input set in force, and bits of parameter 0x03.
struct CalibrationPlan {
    InputKind input = InputKind::Rc;
    std::array<std::optional<Calibration>, kChannelCount> calibrations;
    std::uint8_t reversedMask = 0; ///< bit n: channel n + 1's bit of 0x03 is set as in `reversed`
    std::uint8_t reversed = 0;
};

/// The nearest calibration that a controller can take which reads byte pairs as low + 256 × high
/// (conformance C-35), its deadband widened so that it still covers the true neutral.
[[nodiscard]] Calibration nearestForEightBit(const Calibration& wanted);

/// Writes a plan one item after another, reading each back; knows what was there before, so that it
/// can be put back; and after an interruption reads what each item holds now. Main thread.
class CalibrationWriter : public QObject {
    Q_OBJECT
    Q_DISABLE_COPY_MOVE(CalibrationWriter)

public:
    enum class State : std::uint8_t {
        Untouched,
        Unchanged, ///< the controller held these values already
        Writing,
        Written, ///< and read back as asked
        NearestWritten, ///< the controller cannot hold them; the nearest it can (C-35)
        Refused, ///< keeps what it held
        Failed, ///< old or new, nobody knows yet
        HoldsNew, ///< read back after an interruption
        HoldsOld,
        HoldsOther, ///< neither the old nor the new values
        Restored, ///< the former values, written and read back
        NearestRestored, ///< the nearest to them that the controller can take
    };
    /// Items: channels 1 to 5, then the directions (parameter 0x03).
    static constexpr int kDirections = kChannelCount + 1;

    CalibrationWriter(Controller& controller, DeviceSettings& settings, QObject* parent = nullptr);

    void reset(); ///< nothing planned, written or to be undone
    void setBefore(int channel, const Calibration& calibration);
    void setReversedBefore(std::uint8_t reversed); ///< 0x03 as it was

    void write(const CalibrationPlan& plan);
    void stopAfterPresent(); ///< a packet on its way cannot be called back
    void interrupt(); ///< the line is lost: the item being written is in doubt
    /// Reads back every item that was written or is in doubt. Only when canReach().
    void check();
    /// Puts the former values back where others were written, and reads them back.
    void undo();

    [[nodiscard]] bool isBusy() const { return m_task != Task::None; }
    [[nodiscard]] bool isStopping() const { return m_isStopAsked; }
    [[nodiscard]] bool needsCheck() const; ///< after an interruption, until it was checked
    [[nodiscard]] bool canUndo() const; ///< something is to be put back, and nothing runs
    /// The controller that was written is there, in serial mode and with the same input set.
    [[nodiscard]] bool canReach() const;
    /// It was seen to join bytes as low + 256 × high (C-35), since the line was opened.
    [[nodiscard]] bool isEightBit() const { return m_isEightBit; }

    [[nodiscard]] State state(int item) const;
    [[nodiscard]] std::uint8_t channelsIn(State state) const; ///< bit n is channel n + 1
    [[nodiscard]] std::optional<Calibration> before(int channel) const;
    [[nodiscard]] std::optional<std::uint8_t> reversedBefore() const { return m_reversedBefore; }
    [[nodiscard]] std::optional<Calibration> readBack(int channel) const;
    [[nodiscard]] const CalibrationPlan& plan() const { return m_plan; }

    // Sentences.
    [[nodiscard]] QString writtenText() const; ///< what is held, as far as is known unasked
    [[nodiscard]] QString heldText() const; ///< what a check found
    [[nodiscard]] QString undoneText() const;

signals:
    void changed(); ///< states or values read back
    void itemBegun(int item);
    void written(const trex::Result<void>& result); ///< of write(); Cancelled when stopped
    void checked();
    void undone(const trex::Result<void>& result);

private:
    enum class Task : std::uint8_t { None, Write, Check, Undo };
    struct Item {
        State state = State::Untouched;
        std::optional<Calibration> before;
        std::optional<Calibration> readBack;
    };
    void begin(Task task);
    void end(const Result<void>& result);
    void writeItem(int item);
    void writeChannel(int channel);
    void writeWidened(int channel, const Calibration& wanted);
    void writeDirections();
    void checkItem(int item);
    void undoItem(int item);
    void undoDirections();
    void put(int item, State state, const std::optional<Calibration>& readBack = {});
    void failed(int item, const Error& error);
    [[nodiscard]] bool wasTouched(int item) const;
    /// `now` with the bits of the mask taken from `bits`: no other channel's direction changes.
    [[nodiscard]] static std::uint8_t merged(int now, std::uint8_t mask, std::uint8_t bits);
    [[nodiscard]] static State seen(const Calibration& now, const Item& item,
                                    const std::optional<Calibration>& wanted, bool isEightBit);
    [[nodiscard]] Item& at(int item) { return m_items.at(static_cast<std::size_t>(item - 1)); }
    [[nodiscard]] const Item& at(int item) const
    {
        return m_items.at(static_cast<std::size_t>(item - 1));
    }

    Controller& m_controller;
    DeviceSettings& m_settings;
    CalibrationPlan m_plan;
    std::array<Item, kDirections> m_items;
    std::optional<std::uint8_t> m_reversedBefore;
    QString m_port; ///< where the plan was written
    int m_device = 0;
    Task m_task = Task::None;
    int m_run = 0; ///< answers to an earlier task are ignored
    bool m_isStopAsked = false;
    bool m_isInterrupted = false;
    bool m_isEightBit = false;
};

} // namespace trex
