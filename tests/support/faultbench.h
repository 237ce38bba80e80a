// SPDX-License-Identifier: GPL-3.0-or-later
// A configuration transfer over a simulated line with one fault at one byte, in virtual time: what
// the controller holds afterwards, what was said about it, and whether it can be undone.
#pragma once

#include "protocol/procedures/configtransfer.h"

#include <QCoreApplication>
#include <QElapsedTimer>
#include <QTimer>

namespace trex::test {

/// Keeps what it is told of every write, as the journal does.
class WriteLog : public WriteRecorder {
public:
    struct Entry {
        WriteIntent intent;
        std::optional<WriteConclusion> conclusion;
    };
    void prepare(const SettingId&, std::function<void(Result<void>)> go) override { go({}); }
    [[nodiscard]] Result<qint64> intend(const WriteIntent& intent) override
    {
        entries.push_back({intent, std::nullopt});
        return std::ssize(entries);
    }
    void conclude(qint64 number, const WriteConclusion& conclusion) override
    {
        entries.at(static_cast<std::size_t>(number - 1)).conclusion = conclusion;
    }
    std::vector<Entry> entries;
};

/// A controller of its own on a line of its own; everything through the façade, as a panel does it.
class FaultBench : public QObject {
public:
    FaultBench() : settings(controller), transfer(controller, settings)
    {
        settings.setRecorder(&log);
        m_watchdog.start(kPatienceMs / 4); // wakes the loop below
        connect(&transfer, &ConfigTransfer::readFinished, this,
                [this](const Result<Configuration>& result) { m_read = result; });
        connect(&transfer, &ConfigTransfer::finished, this,
                [this](const TransferOutcome& result) { m_outcome = result; });
    }

    [[nodiscard]] bool open(const QString& fault, const QString& more, const LineSettings& line)
    {
        OpenOptions options;
        options.port = QStringLiteral("sim:?clock=virtual") + more
            + (fault.isEmpty() ? QString() : QStringLiteral("&fault=") + fault);
        options.line = line;
        controller.open(options);
        return connected();
    }
    [[nodiscard]] bool connected()
    {
        return until([this] { return controller.state() == LinkState::Connected; });
    }
    /// Everything that the controller holds; asked again when the line had one of its moments.
    [[nodiscard]] std::optional<Configuration> read()
    {
        for (int attempt = 0; attempt < 4 && connected(); ++attempt) {
            m_read.reset();
            transfer.read();
            if (until([this] { return m_read.has_value(); }) && *m_read) {
                return **m_read;
            }
        }
        return std::nullopt;
    }
    using OnFailure = ConfigTransfer::OnFailure;
    [[nodiscard]] std::optional<TransferOutcome> write(const TransferPlan& plan,
                                                       OnFailure onFailure = OnFailure::PutBack)
    {
        m_outcome.reset();
        transfer.write(plan, onFailure);
        return until([this] { return m_outcome.has_value(); }) ? m_outcome : std::nullopt;
    }
    /// After the line was lost: what the transfer finds out once it is back.
    [[nodiscard]] std::optional<TransferOutcome> examine()
    {
        m_outcome.reset();
        transfer.examine();
        return until([this] { return m_outcome.has_value(); }) ? m_outcome : std::nullopt;
    }
    /// What has crossed the wire, as the host counts it: both directions.
    [[nodiscard]] qint64 wireBytes() const
    {
        return static_cast<qint64>(controller.stats().bytesSent + controller.stats().bytesReceived);
    }

    template <class Condition>
    [[nodiscard]] bool until(Condition condition)
    {
        QElapsedTimer patience;
        patience.start();
        while (!condition()) {
            if (patience.elapsed() > kPatienceMs) {
                return false;
            }
            QCoreApplication::processEvents(QEventLoop::WaitForMoreEvents);
        }
        return true;
    }

    WriteLog log;
    Controller controller{nullptr, nullptr};
    DeviceSettings settings;
    ConfigTransfer transfer;

private:
    static constexpr int kPatienceMs = 20'000;
    QTimer m_watchdog;
    std::optional<Result<Configuration>> m_read;
    std::optional<TransferOutcome> m_outcome;
};

} // namespace trex::test
