// SPDX-License-Identifier: GPL-3.0-or-later
// The parameters panel with everything behind it, and a controller of the simulator to connect to.
#pragma once

#include "protocol/codec/packet.h"
#include "protocol/session/devicesettings.h"
#include "protocol/telemetry/statuslatch.h"
#include "protocol/telemetry/telemetrystore.h"
#include "widgets/common/eventlog.h"
#include "widgets/common/filedialogs.h"
#include "widgets/common/frameticker.h"
#include "widgets/common/theme.h"
#include "widgets/common/uisettings.h"
#include "widgets/parameters/parameterfield.h"
#include "widgets/parameters/parameterspanel.h"
#include "widgets/parameters/parametertable.h"

#include <QAction>
#include <QDialog>
#include <QDir>
#include <QLabel>
#include <QPushButton>
#include <QTemporaryDir>
#include <QTest>

namespace trex::test {

using namespace Qt::Literals::StringLiterals;

constexpr int kLongMs = 30'000;
constexpr std::uint8_t kSetParameter = 0xAF;

/// The panel with everything behind it, and a controller of the simulator to connect to.
class ParametersBench : public QObject {
public:
    ParametersBench()
        : file(folder.filePath(u"settings.ini"_s))
        , uiSettings(file)
        , controller(&store, &latch)
        , settings(controller)
        , context{controller, settings, store, latch, log, uiSettings, ticker, dialogs}
        , panel(context)
    {
        connect(&controller, &Controller::recordsArrived, this,
                [this](const std::vector<TransactionRecord>& records) {
                    for (const auto& record : records) {
                        if (record.command.opcode == kSetParameter) {
                            ++writes;
                            sentSettings << toHex(record.sentBytes);
                        }
                    }
                });
        panel.resize(1000, 500);
        panel.show();
    }

    bool connectTo(const QString& port, const LineSettings& line = {})
    {
        OpenOptions options;
        options.port = port;
        options.line = line;
        controller.open(options);
        return QTest::qWaitFor([this] { return text(u"banner"_s).isEmpty(); }, kLongMs);
    }
    template <class T>
    T* part(const QString& name) const
    {
        return panel.findChild<T*>(u"parameters."_s + name);
    }
    ParameterField* editor(const QString& key) const
    {
        return part<ParameterField>(key + u".editor"_s);
    }
    QString text(const QString& name) const { return part<QLabel>(name)->text(); }
    QString pending() const { return text(u"pending"_s); }
    QString cell(const QString& key, int column) const
    {
        const auto* const table = part<ParameterTable>(u"table"_s);
        const auto* const model = qobject_cast<ParameterModel*>(table->model());
        return model->indexOf(findParameter(key)->number, column).data().toString();
    }
    void click(const QString& name) const
    {
        auto* const button = part<QPushButton>(name);
        QVERIFY2(button->isEnabled(), qPrintable(name));
        QTest::mouseClick(button, Qt::LeftButton);
    }
    bool waitForMessage(const QString& words)
    {
        return QTest::qWaitFor([&] { return text(u"message"_s).contains(words); }, kLongMs);
    }
    QStringList backups() const
    {
        return QDir(folder.filePath(u"backups"_s)).entryList(QDir::Files);
    }

    /// A window of the panel's that is open now; null: none.
    QDialog* dialog(const QString& name) const
    {
        for (auto* const each : panel.findChildren<QDialog*>(u"parameters."_s + name)) {
            if (each->isVisible()) {
                return each;
            }
        }
        return nullptr;
    }
    void trigger(const QString& name) const
    {
        auto* const action = panel.findChild<QAction*>(u"parameters."_s + name);
        QVERIFY2(action != nullptr && action->isEnabled(), qPrintable(name));
        action->trigger();
    }

    QTemporaryDir folder;
    SettingsFile file;
    UiSettings uiSettings;
    TelemetryStore store;
    StatusLatch latch;
    EventLog log;
    FrameTicker ticker;
    FileDialogs dialogs;
    Controller controller;
    DeviceSettings settings;
    PanelContext context;
    ParametersPanel panel;
    int writes = 0; ///< of parameters
    QStringList sentSettings; ///< their packets in hex
};

} // namespace trex::test
