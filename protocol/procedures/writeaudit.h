// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "protocol/procedures/configtransfer.h"
#include "protocol/session/writerecorder.h"
#include "protocol/storage/journal.h"

#include <QPointer>
#include <QTimer>

#include <deque>

namespace trex {

/// Keeps the journal of one connection: saves the whole configuration before its first write,
/// records every write that goes through DeviceSettings before and after it is sent, and what other
/// packets write; reads back on a later connection what was left unknown. Main thread.
class WriteAudit : public QObject, public WriteRecorder {
    Q_OBJECT

public:
    /// What happens when the journal or the configuration cannot be saved: `RefuseOnce` fails the
    /// write (FileUnwritable, or the loss), so that the person knows before it goes without;
    /// `GoOn` says so and writes.
    enum class WhenUnsaved : std::uint8_t { RefuseOnce, GoOn };

    /// Becomes the recorder of `settings` for as long as it lives.
    WriteAudit(Controller& controller, DeviceSettings& settings, Journal& journal,
               WhenUnsaved whenUnsaved, QObject* parent = nullptr);
    ~WriteAudit() override;

    [[nodiscard]] Journal& journal() { return m_journal; }
    /// The person has been told elsewhere that nothing can be saved, and wants to write all the
    /// same: not refused a second time in this connection.
    void goWithout() { m_mayGoWithout = true; }
    /// Who is connected, as far as it is known.
    [[nodiscard]] ControllerIdentity controller() const;

    /// Reads back every write whose effect is unknown (not those of the input set that is not in
    /// force), and tells each by name. `done` is called once. Does nothing where nothing is open.
    void resolve(QObject* context, const std::function<void()>& done);
    /// Resolves by itself whenever a controller is connected (the panel).
    void resolveWhenConnected();

    /// Everything, read now, under a name. Errors: a loss, those of the journal.
    void saveCheckpoint(const QString& name, QObject* context,
                        const DeviceSettings::Handler<qint64>& handler);
    /// What has to be written so that the controller holds what it held before that entry. Plans
    /// from what was last read: read everything first.
    [[nodiscard]] Result<TransferPlan> planRevert(const JournalEntry& entry);
    [[nodiscard]] TransferPlan planRestore(const Configuration& wanted) const;

    void prepare(const SettingId& setting, std::function<void(Result<void>)> go) override;
    [[nodiscard]] Result<qint64> intend(const WriteIntent& intent) override;
    void conclude(qint64 number, const WriteConclusion& conclusion) override;

signals:
    /// A plain sentence for the log. `severity`: 0 information, 1 warning, 2 error.
    void told(int severity, const QString& sentence);
    void recorded(); ///< the journal holds something new

private:
    void onState(LinkState state);
    void onRecords(const std::vector<TransactionRecord>& records);
    void recordForeign(const Command& command, const TransactionRecord& record);
    void readEverything(const DeviceSettings::Handler<Configuration>& handler);
    void finishReading(const Result<Configuration>& read);
    void finishPreparing(const Result<void>& saved);
    [[nodiscard]] bool mayGoWithout(const Error& error); ///< tells it
    void tellRemark();
    void findOpen();
    void resolveNext();
    void finishResolving();
    void readBack(const SettingId& setting, const DeviceSettings::Handler<SettingValue>& handler);
    void settle(const JournalEntry& entry, const std::optional<SettingValue>& found);
    void tellFailure(const Result<void>& recorded);

    Controller& m_controller;
    DeviceSettings& m_settings;
    Journal& m_journal;
    WhenUnsaved m_whenUnsaved;
    bool m_isPrepared = false; ///< in this connection
    bool m_mayGoWithout = false; ///< the person was told
    bool m_wasFailureTold = false; ///< in this connection
    bool m_readsForeignBack = false;
    std::vector<std::function<void(Result<void>)>> m_waiting; ///< for the configuration's saving
    std::unique_ptr<QObject> m_reading; ///< context of a reading of everything; gone: given up
    std::vector<DeviceSettings::Handler<Configuration>> m_readers;
    QTimer m_patience; ///< how long reading everything may take
    QByteArrayList m_expected; ///< packets of ours that will be seen on the wire
    std::deque<JournalEntry> m_open; ///< to be read back
    bool m_isResolving = false;
    bool m_mustLookAgain = false; ///< the device number is known anew
    std::vector<std::pair<QPointer<QObject>, std::function<void()>>> m_whenResolved;
};

/// What a value that was read says of an entry: new, old or other.
[[nodiscard]] WriteConclusion conclusionOf(const JournalEntry& entry, const SettingValue& found);

/// What an entry is about, in words for people.
[[nodiscard]] QString titleOf(const SettingId& setting); ///< "Serial timeout"
[[nodiscard]] QString textOf(const SettingId& setting, const std::optional<SettingValue>& value);
[[nodiscard]] QString changeText(const JournalEntry& entry); ///< "0 ms → 500 ms"
[[nodiscard]] QString resultText(const JournalEntry& entry); ///< "read back as written"

} // namespace trex
