// SPDX-License-Identifier: GPL-3.0-or-later
// Finds what a person would see by its object name, and brings it to where a person could reach it.
#pragma once

#include <QObject>
#include <QString>

class QWidget;

namespace trex {

struct Found {
    QObject* object = nullptr;
    QString problem{}; ///< a sentence when there is no object: missing, or more than one
};

/// Looks in all windows that are open, in their actions too. "window/name" looks in that window
/// only; without it, of two the one outside of a recording's window is meant.
[[nodiscard]] Found findObject(const QString& name);

/// Opens the dock and turns to the tab that the widget stands in. True when the widget can be seen
/// already; otherwise ask again after the event loop had its turn.
bool bringForward(QWidget* widget);

/// A sentence when a person could not use it now: disabled, or behind a modal dialog.
[[nodiscard]] QString obstacleOf(const QObject* object);

} // namespace trex
