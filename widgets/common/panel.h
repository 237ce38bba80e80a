// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>

namespace trex {

class Controller;
class DeviceSettings;
class EventLog;
class FileDialogs;
class FrameTicker;
class MarkTrack;
class PlotReferences;
class SerialTimeoutWatch;
class StatusLatch;
class TelemetryStore;
class UiSettings;
class WriteAudit;

/// All that a panel may know. Panels never talk to each other, only to this.
struct PanelContext {
    Controller& controller;
    DeviceSettings& deviceSettings;
    TelemetryStore& store;
    StatusLatch& latch;
    EventLog& log;
    UiSettings& settings;
    FrameTicker& ticker;
    FileDialogs& fileDialogs;
    WriteAudit* audit = nullptr; ///< the journal of writes; null: nothing is recorded
    MarkTrack* marks = nullptr; ///< events beside the samples; null: plots show none
    PlotReferences* references = nullptr; ///< runs to compare with; null: a panel keeps its own
    SerialTimeoutWatch* timeoutWatch = nullptr; ///< null: nobody looks after the serial timeout
};

/// Base of the panels; a row of panelregistry.cpp makes each one. GUI thread.
class Panel : public QWidget {
    Q_OBJECT

public:
    explicit Panel(PanelContext& context, QWidget* parent = nullptr)
        : QWidget(parent), m_context(context)
    {
    }

signals:
    /// The person wants to go on in another panel; the window brings it forward. "ID", or
    /// "ID/NAME" where the control of that object name is to have the focus.
    void panelRequested(const QString& id);

protected:
    [[nodiscard]] PanelContext& context() const { return m_context; }

private:
    PanelContext& m_context;
};

/// Sets the object name that scripts and tests find, and the accessible name that a screen reader
/// says; returns the widget, so that it wraps its creation.
template <class T>
T* named(T* widget, const QString& objectName, const QString& accessibleName = {})
{
    widget->setObjectName(objectName);
    if (!accessibleName.isEmpty()) {
        widget->setAccessibleName(accessibleName);
    }
    return widget;
}

} // namespace trex
