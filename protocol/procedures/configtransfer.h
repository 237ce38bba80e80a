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
    [[nodiscard]] QString text() const; ///< "Serial timeout: off → 500 ms"
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
    bool failedMayHold = false; ///< what failed was left alone, and either value may hold
    QStringList notes; ///< sentences, with those of the plan
    bool needsReset = false;

    [[nodiscard]] QString text() const; ///< the whole outcome in sentences for people
    /// What putBack() would have to do: `written`, and what failed when either value may hold.
    [[nodiscard]] std::vector<SettingWrite> toPutBack() const;
};

/// What is known of the controller now, without asking it anything.
[[nodiscard]] Configuration presentConfiguration(const Controller& controller,
                                                 const DeviceSettings& settings);
/// True when every readable parameter and every calibration of the set in force is in it.
[[nodiscard]] bool isComplete(const Configuration& configuration);

class SettingsCheck;

/// Moves whole configurations between the controller and us. Main thread; one task at a time.
///
/// Without CRC-7 a damaged packet may reach another setting than was meant, and a damaged reply may
/// say what is not so. After the last packet everything that is known of the controller is
/// therefore read once more; what a damaged packet has changed is put right and named.
class ConfigTransfer : public QObject {
    Q_OBJECT
    Q_DISABLE_COPY_MOVE(ConfigTransfer)

public:
    ConfigTransfer(Controller& controller, DeviceSettings& settings, QObject* parent = nullptr);

    /// Asks the controller for everything; readFinished() follows.
    void read();
    enum class OnFailure : std::uint8_t { PutBack, Stop };
    /// Writes the plan one after another, each read back. Stops at the first failure and puts back
    /// what it wrote, last first, or leaves that to whoever asked; finished() follows.
    void write(const TransferPlan& plan, OnFailure onFailure = OnFailure::PutBack);
    /// Undoes these writes, last first; those whose value before is not known stay. finished()
    /// follows, without an error: what could not be put back is told in it.
    void putBack(const std::vector<SettingWrite>& written);
    /// Ends the writing after the packet in flight (Cancelled), and then does as after a failure.
    void cancel();
    /// After a transfer that lost its line, on a connection to the same controller: reads back what
    /// may hold either value; finished() follows, with the truth in place of "may".
    void examine();
    /// The configuration before the last write, as far as it was known.
    [[nodiscard]] const Configuration& before() const { return m_before; }
    [[nodiscard]] bool isBusy() const { return m_busy; }

signals:
    void progressed(int done, int total);
    void readFinished(const trex::Result<trex::Configuration>& configuration);
    void finished(const trex::TransferOutcome& outcome);

private:
    void writeNext();
    using Done = std::function<void(const std::optional<Error>&)>;
    void perform(const SettingWrite& write, bool isRestoring);
    void performCalibration(const SettingWrite& write, const Done& done);
    void onWritten(const SettingWrite& write, const std::optional<Error>& error);
    void onFailure();
    void restoreNext();
    void onRestored(const std::optional<Error>& error);
    void finish();

    // Reading everything once more, in transferverify.cpp.
    void prepare();
    void expect(const SettingWrite& write);
    void verify(void (ConfigTransfer::*then)());
    void onFound(const Configuration& found);
    void settleDoubts(const Configuration& found);
    void collectStrays(const Configuration& found);
    [[nodiscard]] bool isSuspect(const SettingWrite& stray) const;
    void repairNext();
    void onRepaired(const std::optional<Error>& error);
    [[nodiscard]] bool isUnreadable(const SettingWrite& write) const;

    Controller& m_controller;
    DeviceSettings& m_settings;
    SettingsCheck* m_check; ///< child
    Configuration m_before;
    Configuration m_expected; ///< what the controller should hold now
    std::vector<SettingWrite> m_suspects; ///< packets that may have reached another setting
    std::vector<SettingWrite> m_strays; ///< to be put right: rawFrom is there, rawTo should be
    void (ConfigTransfer::*m_then)() = nullptr; ///< after the check
    int m_rounds = 0;
    bool m_isChecked = false; ///< before a device number that ends the connection
    TransferPlan m_plan;
    TransferOutcome m_outcome;
    std::size_t m_next = 0;
    OnFailure m_onFailure = OnFailure::PutBack;
    bool m_busy = false;
    bool m_cancelled = false;
};

} // namespace trex
