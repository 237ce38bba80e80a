// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "protocol/session/devicesettings.h"
#include "protocol/storage/configdiff.h"

#include <QStringList>

namespace trex {

/// One write, one packet: a parameter, or the calibration of a channel.
struct SettingWrite {
    const ParameterRow* row = nullptr; ///< null: a calibration
    std::optional<int> rawFrom;
    int rawTo = 0;
    InputKind input = InputKind::Rc; ///< of a calibration, as the channel
    int channel = 0;
    std::optional<Calibration> calibrationFrom;
    Calibration calibrationTo;

    [[nodiscard]] QString key() const; ///< "serial-timeout", "calibration.rc.1"
    [[nodiscard]] QString title() const; ///< "Serial timeout", "Calibration of channel 1 (RC)"
    [[nodiscard]] QString text() const; ///< "Serial timeout: 0 → 500 ms"
    [[nodiscard]] Command command() const;
    [[nodiscard]] bool needsReset() const { return row != nullptr && row->needsReset; }
};

/// What has to be written, in its order: ordinary parameters, calibrations, and last what the line
/// itself depends on (0x7D, 0x7E, 0x00). 0x7F is never in it.
struct TransferPlan {
    std::vector<SettingWrite> writes;
    QStringList leftOut; ///< sentences: what cannot be written now, and why

    [[nodiscard]] bool needsReset() const;
    [[nodiscard]] std::vector<ConfigurationChange> changes() const;
    [[nodiscard]] std::vector<Command> commands() const; ///< the packets, for --dry-run
};

/// `inForce` is the input set that the controller uses now: it takes calibrations of that set only
/// (command documentation, 0xA0).
[[nodiscard]] TransferPlan planTransfer(const Configuration& present, const Configuration& wanted,
                                        std::optional<InputKind> inForce);

/// How a transfer ended.
struct TransferOutcome {
    std::vector<SettingWrite> written; ///< read back as asked, and in the controller now
    std::optional<Error> error; ///< none: all of the plan is written
    std::optional<SettingWrite> failed; ///< what `error` is about
    std::vector<SettingWrite> restored; ///< written before the failure, put back after it
    std::vector<SettingWrite> notRestored; ///< could not be put back: the new value may hold
    QStringList notes; ///< sentences, with those of the plan
    bool needsReset = false;

    [[nodiscard]] QString text() const; ///< the whole outcome in sentences for people
};

/// What is known of the controller now, without asking it anything.
[[nodiscard]] Configuration presentConfiguration(const Controller& controller,
                                                 const DeviceSettings& settings);
/// True when every readable parameter and every calibration of the set in force is in it.
[[nodiscard]] bool isComplete(const Configuration& configuration);

/// Moves whole configurations between the controller and us. Main thread; one task at a time.
class ConfigTransfer : public QObject {
    Q_OBJECT
    Q_DISABLE_COPY_MOVE(ConfigTransfer)

public:
    ConfigTransfer(Controller& controller, DeviceSettings& settings, QObject* parent = nullptr);

    /// Asks the controller for everything; readFinished() follows.
    void read();
    /// Writes the plan one after another, each read back. Stops at the first failure and puts back
    /// what it wrote, last first; finished() follows.
    void write(const TransferPlan& plan);
    /// Ends the writing after the packet in flight and puts back what was written (Cancelled).
    void cancel();
    [[nodiscard]] bool isBusy() const { return m_busy; }

signals:
    void progressed(int done, int total);
    void readFinished(const trex::Result<trex::Configuration>& configuration);
    void finished(const trex::TransferOutcome& outcome);

private:
    void writeNext();
    void perform(const SettingWrite& write, bool isRestoring);
    void onWritten(const SettingWrite& write, const std::optional<Error>& error);
    void restoreNext();
    void onRestored(const std::optional<Error>& error);
    void finish();

    Controller& m_controller;
    DeviceSettings& m_settings;
    TransferPlan m_plan;
    TransferOutcome m_outcome;
    std::size_t m_next = 0;
    bool m_busy = false;
    bool m_cancelled = false;
};

} // namespace trex
