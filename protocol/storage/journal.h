// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "protocol/session/writerecorder.h"
#include "protocol/storage/configfile.h"

namespace trex {

/// Which controller: where it was found, what it called itself, its number (parameter 0x00).
struct ControllerIdentity {
    QString port;
    QString signature; ///< "TReXJr1.2"; empty: not asked
    int device = -1; ///< −1: not known
    bool operator==(const ControllerIdentity&) const = default;
};

/// One write that went through us.
struct JournalEntry {
    qint64 number = 0; ///< grows with time
    QDateTime time; ///< UTC, of the intent
    ControllerIdentity controller;
    QString program; ///< "trexpanel", "trexctl"
    WriteIntent intent;
    bool isConcluded = false; ///< false: the program ended before it knew
    WriteConclusion conclusion;
    QDateTime resolved; ///< UTC; valid: found out on a later connection

    /// What the controller certainly held after it; none: not known (or a factory reset).
    [[nodiscard]] std::optional<SettingValue> valueAfter() const;
    /// True while nobody knows what the controller holds.
    [[nodiscard]] bool isOpen() const;
};

/// A whole configuration kept with the journal.
struct Checkpoint {
    qint64 number = 0;
    QDateTime time; ///< UTC
    ControllerIdentity controller;
    QString name; ///< empty: saved by itself before a connection's first write
    qint64 lastEntry = 0; ///< newest journal entry of that time
    Configuration configuration;
};

/// Every write ever made through us, and whole configurations, in one SQLite file that trexpanel
/// and trexctl share. Opened when first used; main thread. Each write is on the disk when its
/// function returns (WAL, synchronous=FULL), so that a killed program loses nothing.
///
/// Schema, version 1 (PRAGMA user_version); times are UTC, ISO 8601 with milliseconds:
///   controller(id, port, signature, device)
///   entry(id, time, controller, program,
///         setting,          `serial-timeout`, `calibration.rc.1`, `factory-reset`
///         old, new, found,  raw: `5`, `2500 3750 5000 100` (minimum neutral maximum deadband)
///         packet,           upper-case hex
///         result,           NULL (no conclusion yet) `unknown new old other answered refused`
///         detail, resolved)
///   configuration(id, hash, json)   JSON as config save writes it, without its date; each once
///   checkpoint(id, time, controller, name, last_entry, configuration)
///
/// Errors of all functions: FileUnreadable (no driver, no permission, a newer version),
/// FileMalformed (damaged), FileUnwritable (read-only, full disk). A damaged file is kept aside as
/// FILE.damaged and a new one is begun; takeRemark() says so.
class Journal {
public:
    static constexpr int kVersion = 1;

    explicit Journal(const QString& path);
    ~Journal();
    Q_DISABLE_COPY_MOVE(Journal)

    [[nodiscard]] QString path() const { return m_path; }
    /// Opens it, making it where there is none. One sentence says what is wrong.
    [[nodiscard]] Result<void> ready();
    [[nodiscard]] QString takeRemark(); ///< to be told once; mostly empty

    [[nodiscard]] Result<qint64> intend(const ControllerIdentity& controller,
                                        const WriteIntent& intent);
    [[nodiscard]] Result<void> conclude(qint64 number, const WriteConclusion& conclusion);
    /// A read-back on a later connection.
    [[nodiscard]] Result<void> resolve(qint64 number, const WriteConclusion& conclusion);

    struct Filter {
        std::optional<ControllerIdentity> controller; ///< none: all of them
        std::optional<SettingId> setting;
        qint64 from = 0; ///< least number
        bool onlyOpen = false;
        int limit = 0; ///< newest ones; 0: all
    };
    /// Newest first. A controller's entries under numbers that it had before are its own.
    [[nodiscard]] Result<std::vector<JournalEntry>> entries(const Filter& filter);
    [[nodiscard]] Result<JournalEntry> entry(qint64 number);
    /// All writes of one channel's calibration, newest first.
    [[nodiscard]] Result<std::vector<JournalEntry>>
    calibrationHistory(const ControllerIdentity& controller, InputKind input, int channel);

    /// An empty name: automatic. A name that is there for this controller is refused (OutOfRange).
    [[nodiscard]] Result<qint64> saveCheckpoint(const ControllerIdentity& controller,
                                                const QString& name,
                                                const Configuration& configuration);
    [[nodiscard]] Result<std::vector<Checkpoint>>
    checkpoints(const std::optional<ControllerIdentity>& controller); ///< newest first
    [[nodiscard]] Result<Checkpoint> checkpoint(const ControllerIdentity& controller,
                                                const QString& name);
    [[nodiscard]] Result<void> removeCheckpoint(qint64 number);

    /// What the controller held before that entry, as far as checkpoints and entries tell.
    [[nodiscard]] Result<Configuration> stateBefore(const JournalEntry& entry);

private:
    [[nodiscard]] Result<void> open();
    [[nodiscard]] Result<void> prepareSchema();
    [[nodiscard]] Result<qint64> controllerId(const ControllerIdentity& controller);
    [[nodiscard]] bool isThere() const; ///< false: nothing was ever recorded
    void close();

    QString m_path;
    QString m_connection; ///< empty: not open
    QString m_remark;
};

/// "serial-timeout", "calibration.rc.1"
[[nodiscard]] QString keyOf(const SettingId& setting);
[[nodiscard]] std::optional<SettingId> settingFromKey(const QString& key);
[[nodiscard]] QString keyOf(WriteResult result); ///< as in the schema

} // namespace trex
