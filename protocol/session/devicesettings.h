// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "protocol/codec/command.h"
#include "protocol/codec/parametertable.h"
#include "protocol/session/controller.h"
#include "protocol/session/writerecorder.h"

#include <map>

namespace trex {

/// The controller's settings as last read, and reads and writes that verify themselves. Main
/// thread. Reads are cached until the link is lost; a write is recorded, followed by its read-back
/// and never repeated blindly.
class DeviceSettings : public QObject {
    Q_OBJECT
    Q_DISABLE_COPY_MOVE(DeviceSettings)

public:
    template <class T>
    using Handler = std::function<void(Result<T>)>;

    struct ParameterWrite {
        int from = -1; ///< −1: not known before
        int to = 0; ///< as read back
        bool verified = false;
    };
    struct CalibrationWrite {
        Calibration readBack;
        bool verified = false; ///< read back as asked
        bool eightBitBytes = false; ///< the controller reads low + 256 × high (conformance C-35)
    };

    explicit DeviceSettings(Controller& controller, QObject* parent = nullptr);
    /// Told of every write before it is sent and when its effect is known; null: nobody is.
    void setRecorder(WriteRecorder* recorder) { m_recorder = recorder; }

    [[nodiscard]] std::optional<int> parameter(std::uint8_t number) const; ///< last read, else none
    [[nodiscard]] std::optional<Calibration> calibration(InputKind input, int channel) const;
    /// True when a stored value waits for a power cycle: it was written since the last known one,
    /// or the line's own settings or the mode show that another value is in force.
    [[nodiscard]] bool isPending(std::uint8_t number) const;

    void readParameter(const ParameterRow& row, QObject* context, const Handler<int>& handler);
    /// Writes, reads back. Nothing is written when the controller already holds the value. Errors:
    /// OutOfRange (nothing sent), FileUnwritable (the recorder's; nothing sent), a refusal, a loss,
    /// ReadBackDiffers (with both values). Once begun it is carried to its end even when `context`
    /// dies.
    void writeParameter(const ParameterRow& row, int raw, bool verify, QObject* context,
                        const Handler<ParameterWrite>& handler);
    /// Of the input set in force; the result is kept under that set when the mode is known.
    void readCalibration(int channel, QObject* context, const Handler<Calibration>& handler);
    /// Without CRC-7 a damaged byte makes another legal value, or asks for another setting: a reply
    /// is believed when it says what was expected, or when two in a row say the same.
    void readSurely(const ParameterRow& row, const std::optional<int>& expected, QObject* context,
                    const Handler<int>& handler);
    void readSurely(int channel, const std::optional<Calibration>& expected, QObject* context,
                    const Handler<Calibration>& handler);
    void writeCalibration(int channel, const Calibration& calibration, QObject* context,
                          const Handler<CalibrationWrite>& handler);
    /// Everything: all readable parameters and the calibrations of the input set in force.
    /// progress(done, total) may be empty; the handler gets the first error, with its key.
    void readAll(QObject* context, const std::function<void(int, int)>& progress,
                 const Handler<void>& handler);
    /// 0x7F with data 0x7F: factory defaults, in force after a power cycle.
    void factoryReset(QObject* context, const Handler<void>& handler);

    using Calibrations = std::map<InputKind, std::map<int, Calibration>>;
    /// Of a recording: the settings as they were known then, in place of all that is known.
    void show(const std::map<std::uint8_t, int>& parameters, const Calibrations& calibrations);

signals:
    void parameterChanged(int number); ///< a read or a read-back brought a value
    void calibrationChanged(trex::InputKind input, int channel);
    /// What became of a write that was sent; exactly once for each.
    void writeConcluded(const trex::WriteIntent& intent, const trex::WriteConclusion& conclusion);
    void forgotten(); ///< the link was lost or changed: nothing is known any more

private:
    void forget();
    void store(const ParameterRow& row, int raw);
    void readNext(std::size_t index, QObject* context,
                  const std::function<void(int, int)>& progress, const Handler<void>& handler);
    /// One write under way: what was intended, and its number in the recorder (0: none).
    struct Pending {
        WriteIntent intent;
        qint64 number = 0;
    };
    /// Has the write recorded, then sends it. `onward` gets the controller's answer, or why nothing
    /// was sent (then with number −1).
    void transmit(const Command& command, const WriteIntent& intent,
                  const std::function<void(const Pending&, const Result<void>&)>& onward);
    void conclude(const Pending& pending, WriteResult result,
                  const std::optional<SettingValue>& found = {}, const QString& detail = {});
    void sendParameter(const ParameterRow& row, int raw, int from, bool verify,
                       const Handler<ParameterWrite>& handler);
    void verifyParameter(const Pending& pending, const std::optional<Error>& lost,
                         const Handler<ParameterWrite>& handler);
    void sendCalibration(const SettingId& setting, const Calibration& before,
                         const Calibration& wanted, const Calibration& sent,
                         const Handler<CalibrationWrite>& handler);
    void verifyCalibration(const Pending& pending, const Calibration& wanted,
                           const Calibration& sent, const std::optional<Error>& lost,
                           const Handler<CalibrationWrite>& handler);
    /// Sees to it that what `read` brought is certain; asks again with `again(expected)`.
    template <class T>
    void settle(const Result<T>& read, const std::optional<T>& expected, QObject* context,
                const Handler<T>& handler, const std::function<void(const T&)>& again);
    /// A setting that got no answer was not trusted: the UART error byte may say why.
    void explainSilence(const Error& error, const std::function<void(Error)>& then);
    [[nodiscard]] std::optional<int> evidenceInForce(std::uint8_t number) const;

    Controller& m_controller;
    WriteRecorder* m_recorder = nullptr;
    std::map<std::uint8_t, int> m_parameters;
    std::map<std::pair<InputKind, int>, Calibration> m_calibrations;
    std::map<std::uint8_t, int> m_inForce; ///< value before the first write, until a power cycle
};

} // namespace trex
