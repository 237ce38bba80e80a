// SPDX-License-Identifier: GPL-3.0-or-later
// What DeviceSettings tells of every write to the controller's EEPROM, and to whom.
#pragma once

#include "protocol/codec/command.h"
#include "protocol/codec/parametertable.h"

#include <functional>
#include <variant>

namespace trex {

/// Which setting: a parameter (the factory reset's trigger too), or the calibration of a channel.
struct SettingId {
    const ParameterRow* row = nullptr; ///< null: a calibration
    InputKind input = InputKind::Rc; ///< of a calibration, as the channel
    int channel = 0; ///< 1 to 5
    bool operator==(const SettingId&) const = default;
};

/// Raw: a parameter's value, or the four of a calibration.
using SettingValue = std::variant<int, Calibration>;

/// A write that is about to be sent.
struct WriteIntent {
    SettingId setting;
    std::optional<SettingValue> before; ///< none: not known
    std::optional<SettingValue> after; ///< none: whatever a factory reset brings
    QByteArray packet; ///< as framed for the line
};

/// What became of a write. `New`, `Old` and `Other` were seen: a fresh reply said so.
enum class WriteResult : std::uint8_t {
    Unknown, ///< no answer, not read back: the old or the new value may hold
    New, ///< read back as written
    Old, ///< read back as it was before
    Other, ///< read back as something else
    Answered, ///< the controller said "done"; not read back
    Refused, ///< the controller refused: the old value holds
};

struct WriteConclusion {
    WriteResult result = WriteResult::Unknown;
    std::optional<SettingValue> found; ///< as read back
    QString detail; ///< a sentence: the refusal, the loss
};

/// Keeps account of writes. Main thread.
class WriteRecorder {
public:
    WriteRecorder() = default;
    virtual ~WriteRecorder() = default;
    Q_DISABLE_COPY_MOVE(WriteRecorder)

    /// Before a write: whatever has to be saved first. `go` is called once, at once or later; with
    /// an error nothing may be written.
    virtual void prepare(const SettingId& setting, std::function<void(Result<void>)> go) = 0;
    /// Kept for good when it returns; the packet is sent after that. Its number, 0: not recorded,
    /// and the person knows. An error: nothing may be written.
    [[nodiscard]] virtual Result<qint64> intend(const WriteIntent& intent) = 0;
    virtual void conclude(qint64 number, const WriteConclusion& conclusion) = 0;
};

} // namespace trex
