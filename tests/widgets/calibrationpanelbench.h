// SPDX-License-Identifier: GPL-3.0-or-later
// The calibration panel with everything behind it, and a simulated controller to connect to.
#pragma once

#include "protocol/procedures/writeaudit.h"
#include "protocol/session/devicesettings.h"
#include "protocol/telemetry/statuslatch.h"
#include "protocol/telemetry/telemetrystore.h"
#include "widgets/calibration/calibrationpanel.h"
#include "widgets/calibration/calibrationwizard.h"
#include "widgets/calibration/statemark.h"
#include "widgets/common/eventlog.h"
#include "widgets/common/filedialogs.h"
#include "widgets/common/frameticker.h"
#include "widgets/common/uisettings.h"

#include <QCheckBox>
#include <QDir>
#include <QLabel>
#include <QPushButton>
#include <QTemporaryDir>
#include <QTest>

namespace trex::test {

constexpr int kLongMs = 60'000;

/// The panel with everything behind it, and a simulated controller to connect to.
struct CalibrationPanelBench {
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
    Journal journal{folder.filePath(QStringLiteral("journal.sqlite"))};
    WriteAudit audit{controller, settings, journal, WriteAudit::WhenUnsaved::RefuseOnce};
    PanelContext context{controller, settings, store,   latch, log,
                         uiSettings, ticker,   dialogs, &audit};
    CalibrationPanel panel{context};

    CalibrationPanelBench()
    {
        panel.resize(1000, 460);
        panel.show();
    }
    [[nodiscard]] bool connectTo(const QString& port)
    {
        controller.open({.port = port, .line = {}});
        return QTest::qWaitFor([this] { return controller.device().mode.has_value(); }, kLongMs);
    }
    [[nodiscard]] QString scenario(const QByteArray& json) const
    {
        QFile scenarioFile(folder.filePath(QStringLiteral("scenario.json")));
        if (scenarioFile.open(QIODevice::WriteOnly)) {
            scenarioFile.write(json);
        }
        return QStringLiteral("sim:?scenario=") + scenarioFile.fileName();
    }
    template <class T>
    [[nodiscard]] T* part(const QString& name) const
    {
        return panel.findChild<T*>(QStringLiteral("calibration.") + name);
    }
    [[nodiscard]] QString text(const QString& name) const { return part<QLabel>(name)->text(); }
    [[nodiscard]] QString page() const
    {
        return part<QWidget>(QStringLiteral("wizard"))->property("page").toString();
    }
    [[nodiscard]] QPushButton* next() const { return part<QPushButton>(QStringLiteral("next")); }
    void click(const QString& name) const
    {
        QTest::mouseClick(part<QPushButton>(name), Qt::LeftButton);
    }
    [[nodiscard]] bool waitForNext() const
    {
        return QTest::qWaitFor([this] { return next()->isEnabled(); }, kLongMs);
    }
    [[nodiscard]] bool waitForPage(const QString& name) const
    {
        return QTest::qWaitFor([this, name] { return page() == name; }, kLongMs);
    }
    void clickNext() const { click(QStringLiteral("next")); }
    [[nodiscard]] QString state(int channel) const
    {
        return part<StateMark>(QStringLiteral("%1.state").arg(channel))->text();
    }
    void choose(std::uint8_t mask) const
    {
        for (int channel = 1; channel <= kChannelCount; ++channel) {
            part<QCheckBox>(QStringLiteral("%1.use").arg(channel))
                ->setChecked((mask >> (channel - 1) & 1) != 0);
        }
    }
    /// Clicks Next, whatever it reads, until that page is there.
    [[nodiscard]] bool goTo(const QString& name) const
    {
        constexpr int kMostPages = 12;
        for (int i = 0; i < kMostPages && page() != name; ++i) {
            if (page() == QStringLiteral("writing")) { // goes on by itself
                if (!QTest::qWaitFor([this] { return page() != QStringLiteral("writing"); },
                                     kLongMs)) {
                    return false;
                }
                continue;
            }
            if (!waitForNext()) {
                return false;
            }
            const QString from = page();
            clickNext();
            if (!QTest::qWaitFor([this, from] { return page() != from; }, kLongMs)) {
                return false;
            }
        }
        return page() == name;
    }
    /// With TREX_TEST_PICTURES naming a folder, leaves a picture of the panel there.
    void picture(const QString& name)
    {
        const QString where = qEnvironmentVariable("TREX_TEST_PICTURES");
        if (!where.isEmpty()) {
            QTest::qWait(100);
            panel.grab().save(QDir(where).filePath(name + QStringLiteral(".png")));
        }
    }
};

} // namespace trex::test
