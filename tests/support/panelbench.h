// SPDX-License-Identifier: GPL-3.0-or-later
// One panel with everything behind it: the real façade, its thread, and a simulated controller to
// connect to. What was sent is kept, so that a test can look at the wire.
#pragma once

#include "protocol/codec/packet.h"
#include "protocol/session/controller.h"
#include "protocol/session/devicesettings.h"
#include "protocol/session/serialtimeoutwatch.h"
#include "protocol/telemetry/statuslatch.h"
#include "protocol/telemetry/telemetrystore.h"
#include "widgets/common/eventlog.h"
#include "widgets/common/filedialogs.h"
#include "widgets/common/frameticker.h"
#include "widgets/common/panel.h"
#include "widgets/common/theme.h"
#include "widgets/common/uisettings.h"

#include <QFile>
#include <QStringList>
#include <QTemporaryDir>
#include <QTest>

namespace trex::test {

template <class P>
class PanelBench : public QObject {
public:
    PanelBench()
        : file(folder.filePath(QStringLiteral("settings.ini")))
        , uiSettings(file)
        , controller(&store, &latch)
        , settings(controller)
        , timeoutWatch(controller, settings)
        , context{controller, settings, store,   latch,   log,     uiSettings,
                  ticker,     dialogs,  nullptr, nullptr, nullptr, &timeoutWatch}
        , panel(context)
    {
        connect(&controller, &Controller::recordsArrived, this,
                [this](const std::vector<TransactionRecord>& records) {
                    for (const auto& record : records) {
                        if (!record.isRaw && record.command.row().kind == CommandKind::Motor) {
                            motorPackets.append(toHex(record.sentBytes));
                        }
                    }
                });
        connect(&controller, &Controller::eventLogged, this,
                [this](int severity, const QString& text) { log.add(severity, text); });
        panel.resize(760, 480);
        panel.show();
    }

    [[nodiscard]] bool connectTo(const QString& port)
    {
        constexpr int kLongMs = 30'000;
        OpenOptions options;
        options.port = port;
        controller.open(options);
        return QTest::qWaitFor(
            [this] {
                return controller.state() == LinkState::Connected && controller.device().mode;
            },
            kLongMs);
    }
    [[nodiscard]] QByteArray contents(const QString& name) const
    {
        QFile written(folder.filePath(name));
        return written.open(QIODevice::ReadOnly) ? written.readAll() : QByteArray();
    }

    template <class T>
    [[nodiscard]] T* part(const QString& name) const
    {
        return panel.template findChild<T*>(name);
    }

    [[nodiscard]] QString lastMotorPacket() const
    {
        return motorPackets.isEmpty() ? QString() : motorPackets.last();
    }

    QTemporaryDir folder;
    SettingsFile file;
    UiSettings uiSettings;
    TelemetryStore store;
    StatusLatch latch;
    Controller controller;
    DeviceSettings settings;
    SerialTimeoutWatch timeoutWatch;
    EventLog log;
    FrameTicker ticker;
    FileDialogs dialogs;
    PanelContext context;
    P panel;
    QStringList motorPackets; ///< hex, in the order they were sent
};

} // namespace trex::test
