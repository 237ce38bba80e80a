// SPDX-License-Identifier: GPL-3.0-or-later
#include "protocol/procedures/writeaudit.h"

#include "protocol/codec/packet.h"
#include "protocol/errortext.h"

namespace trex {

using namespace Qt::Literals::StringLiterals;

namespace {

// A poor line must not keep a write waiting: this, and three times the bytes of all queries.
constexpr std::chrono::seconds kPatience{3};
constexpr int kBytesOfEverything = 34 * 12;

/// The write in a packet that DeviceSettings did not send; none: it writes nothing.
std::optional<WriteIntent> intentOf(const Command& command, std::optional<InputKind> input)
{
    const auto byte = [&command](qsizetype i) { return static_cast<int>(command.data.at(i)); };
    if (command.row().kind != CommandKind::Setting) {
        return std::nullopt;
    }
    if (command.opcode == commandRow("set-parameter").first) {
        const auto* const row = command.data.size() >= 2 ? findParameter(byte(0)) : nullptr;
        return row == nullptr
            ? std::nullopt
            : std::optional(WriteIntent{{.row = row}, {}, SettingValue(byte(1)), {}});
    }
    if (command.data.size() < 8 || !input) {
        return std::nullopt;
    }
    const auto pair = [&byte](qsizetype i) { return byte(i) + (byte(i + 1) << 7); };
    const SettingId setting{
        .row = nullptr, .input = *input, .channel = command.opcode - command.row().first + 1};
    return WriteIntent{setting, {}, Calibration{pair(0), pair(2), pair(4), pair(6)}, {}};
}

} // namespace

WriteAudit::WriteAudit(Controller& controller, DeviceSettings& settings, Journal& journal,
                       WhenUnsaved whenUnsaved, QObject* parent)
    : QObject(parent)
    , m_controller(controller)
    , m_settings(settings)
    , m_journal(journal)
    , m_whenUnsaved(whenUnsaved)
{
    m_patience.setSingleShot(true);
    connect(&m_patience, &QTimer::timeout, this,
            [this] { finishReading(fail(ErrorCode::NoReply)); });
    connect(&controller, &Controller::stateChanged, this, &WriteAudit::onState);
    connect(&controller, &Controller::recordsArrived, this, &WriteAudit::onRecords);
    m_settings.setRecorder(this);
}

WriteAudit::~WriteAudit()
{
    m_settings.setRecorder(nullptr);
}

ControllerIdentity WriteAudit::controller() const
{
    const auto& options = m_controller.options();
    const auto& signature = m_controller.device().signature;
    const bool isAddressed = options.line.form == PacketForm::Pololu;
    const auto number = m_settings.parameter(parameterRow("device-number").number);
    return {options.port, signature ? signature->text() : QString(),
            number.value_or(isAddressed ? options.line.device : -1)};
}

void WriteAudit::onState(LinkState state)
{
    if (state == LinkState::Connected) {
        return;
    }
    m_isPrepared = false;
    m_wasFailureTold = false;
    m_expected.clear();
    if (state == LinkState::Disconnected) {
        m_mayGoWithout = false; // the next connection may be to another controller
    }
}

// ---- before the first write

void WriteAudit::prepare(const SettingId& setting, std::function<void(Result<void>)> go)
{
    const bool isReset = setting.row != nullptr && setting.row->isTrigger;
    if (m_isPrepared && !isReset) { // a factory reset changes everything: saved again
        go({});
        return;
    }
    m_waiting.push_back(std::move(go));
    if (m_waiting.size() > 1) {
        return;
    }
    const auto opened = m_journal.ready();
    tellRemark();
    if (!opened) {
        finishPreparing(opened);
        return;
    }
    const auto save = [this](const Configuration& configuration) {
        finishPreparing(
            m_journal.saveCheckpoint(controller(), {}, configuration).map([](qint64) {}));
    };
    if (const auto known = presentConfiguration(m_controller, m_settings); isComplete(known)) {
        save(known);
        return;
    }
    readEverything([this, save](const Result<Configuration>& read) {
        read ? save(*read) : finishPreparing(tl::make_unexpected(read.error()));
    });
}

void WriteAudit::finishPreparing(const Result<void>& saved)
{
    Result<void> verdict;
    if (!saved && !mayGoWithout(saved.error())) {
        verdict = tl::make_unexpected(saved.error());
    }
    m_isPrepared = verdict.has_value();
    if (saved) {
        emit recorded();
    }
    for (const auto& go : std::exchange(m_waiting, {})) {
        go(verdict);
    }
}

/// The person has to know before something is written that cannot be taken back by the journal.
bool WriteAudit::mayGoWithout(const Error& error)
{
    const QString why = errorText(error);
    if (m_whenUnsaved == WhenUnsaved::GoOn) {
        if (!std::exchange(m_mayGoWithout, true)) {
            emit told(1, tr("The settings as they were could not be saved first: %1").arg(why));
        }
        return true;
    }
    if (std::exchange(m_mayGoWithout, true)) {
        return true;
    }
    emit told(2,
              tr("Nothing is written to the controller, because the settings as they are could not "
                 "be saved first: %1 Do it once more to write without that copy and its journal.")
                  .arg(why));
    return false;
}

void WriteAudit::tellRemark()
{
    if (const QString remark = m_journal.takeRemark(); !remark.isEmpty()) {
        emit told(1, remark);
    }
}

void WriteAudit::readEverything(const DeviceSettings::Handler<Configuration>& handler)
{
    m_readers.push_back(handler);
    if (m_reading) {
        return;
    }
    m_reading = std::make_unique<QObject>();
    m_patience.start(std::chrono::ceil<std::chrono::milliseconds>(
        kPatience + 3 * m_controller.options().line.timeOf(kBytesOfEverything)));
    m_settings.readAll(m_reading.get(), {}, [this](const Result<void>& read) {
        finishReading(read.map([this] { return presentConfiguration(m_controller, m_settings); }));
    });
}

void WriteAudit::finishReading(const Result<Configuration>& read)
{
    m_patience.stop();
    m_reading.reset(); // what is still asked of the controller is answered to nobody
    for (const auto& handler : std::exchange(m_readers, {})) {
        handler(read);
    }
}

void WriteAudit::saveCheckpoint(const QString& name, QObject* context,
                                const DeviceSettings::Handler<qint64>& handler)
{
    readEverything(
        [this, name, guard = QPointer(context), handler](const Result<Configuration>& read) {
            const auto saved = read.and_then([&](const Configuration& configuration) {
                return m_journal.saveCheckpoint(controller(), name, configuration);
            });
            tellRemark();
            if (saved) {
                emit recorded();
            }
            if (guard) {
                handler(saved);
            }
        });
}

// ---- each write

Result<qint64> WriteAudit::intend(const WriteIntent& intent)
{
    const auto number = m_journal.intend(controller(), intent);
    if (!number && !mayGoWithout(number.error())) {
        return tl::make_unexpected(number.error());
    }
    m_expected.append(intent.packet);
    if (number) {
        emit recorded();
    }
    return number.value_or(0);
}

void WriteAudit::conclude(qint64 number, const WriteConclusion& conclusion)
{
    tellFailure(m_journal.conclude(number, conclusion));
}

void WriteAudit::tellFailure(const Result<void>& written)
{
    if (written) {
        emit recorded();
    } else if (!std::exchange(m_wasFailureTold, true)) {
        emit told(1,
                  tr("The result of a write is not recorded: %1").arg(errorText(written.error())));
    }
}

// ---- packets of others: the packet composer, `trexctl raw`

void WriteAudit::onRecords(const std::vector<TransactionRecord>& records)
{
    for (const TransactionRecord& record : records) {
        if (record.priority != Priority::User || m_expected.removeOne(record.sentBytes)) {
            continue;
        }
        if (!record.isRaw) {
            if (record.command.row().kind == CommandKind::Setting) {
                recordForeign(record.command, record);
            }
        } else if (const auto packet =
                       decodePacket(record.sentBytes, m_controller.options().line)) {
            recordForeign(packet->command, record);
        }
    }
}

void WriteAudit::recordForeign(const Command& command, const TransactionRecord& record)
{
    const auto mode = m_controller.device().mode;
    auto intent = intentOf(command, mode ? std::optional(inputOf(*mode)) : std::nullopt);
    if (!intent) {
        return;
    }
    intent->packet = record.sentBytes;
    const SettingId setting = intent->setting;
    if (setting.row != nullptr && setting.row->isTrigger) {
        intent->after.reset();
    } else if (setting.row == nullptr) {
        if (const auto known = m_settings.calibration(setting.input, setting.channel)) {
            intent->before = *known;
        }
    } else if (const auto known = m_settings.parameter(setting.row->number)) {
        intent->before = *known;
    }
    WriteConclusion conclusion;
    if (!record.error && !record.receivedBytes.isEmpty()) {
        const auto answer = parseAnswer(record.receivedBytes.first(1));
        conclusion.result = answer ? WriteResult::Answered : WriteResult::Refused;
        conclusion.detail = answer ? QString() : errorText(answer.error());
    }
    const auto number = m_journal.intend(controller(), *intent);
    tellRemark();
    tellFailure(
        number.and_then([&](qint64 added) { return m_journal.conclude(added, conclusion); }));
    if (number && m_readsForeignBack && conclusion.result != WriteResult::Refused
        && (setting.row == nullptr || !setting.row->isTrigger)) {
        readBack(setting, [this, number = *number](const Result<SettingValue>& found) {
            if (const auto entry = m_journal.entry(number); found && entry) {
                tellFailure(m_journal.conclude(number, conclusionOf(*entry, *found)));
            }
        });
    }
}

} // namespace trex
