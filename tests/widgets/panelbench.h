// SPDX-License-Identifier: GPL-3.0-or-later
// A panel with everything behind it, for tests that feed the store by hand or use the simulator.
#pragma once

#include "protocol/session/controller.h"
#include "protocol/session/devicesettings.h"
#include "protocol/storage/setting.h"
#include "protocol/telemetry/statuslatch.h"
#include "protocol/telemetry/telemetrystore.h"
#include "widgets/common/eventlog.h"
#include "widgets/common/filedialogs.h"
#include "widgets/common/frameticker.h"
#include "widgets/common/panel.h"
#include "widgets/common/uisettings.h"

#include <QTemporaryDir>
#include <QTest>

#include <memory>

namespace trex::test {

template <class PanelClass>
struct PanelBench {
    QTemporaryDir folder;
    SettingsFile file{folder.filePath(QStringLiteral("settings.ini"))};
    UiSettings uiSettings{file};
    TelemetryStore store;
    StatusLatch latch;
    EventLog log;
    FrameTicker ticker;
    FileDialogs dialogs;
    Controller controller{&store, &latch};
    DeviceSettings settings{controller};
    PanelContext context{controller, settings, store, latch, log, uiSettings, ticker, dialogs};
    PanelClass panel{context};

    PanelBench()
    {
        panel.resize(760, 480);
        panel.show();
    }
    [[nodiscard]] bool connectTo(const QString& port)
    {
        constexpr int kLongMs = 30'000;
        controller.open({.port = port, .line = {}});
        return QTest::qWaitFor([this] { return controller.device().mode.has_value(); }, kLongMs);
    }
    template <class T>
    [[nodiscard]] T* part(const QString& name) const
    {
        return panel.template findChild<T*>(name);
    }
    [[nodiscard]] QByteArray contents(const QString& name) const
    {
        QFile written(folder.filePath(name));
        return written.open(QIODevice::ReadOnly) ? written.readAll() : QByteArray();
    }
};

} // namespace trex::test
