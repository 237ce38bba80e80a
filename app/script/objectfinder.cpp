// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/script/objectfinder.h"

#include <QAction>
#include <QApplication>
#include <QDockWidget>
#include <QScrollArea>
#include <QSet>
#include <QStackedWidget>
#include <QTabWidget>

namespace trex {

using namespace Qt::Literals::StringLiterals;

namespace {

constexpr int kMostSuggestions = 6;

template <class T>
QSet<QObject*> objectsInWindows(T&& wanted)
{
    QSet<QObject*> found;
    const QWidgetList windows = QApplication::topLevelWidgets();
    for (QWidget* window : windows) {
        if (!window->isVisible()) {
            continue; // closed, or a window that is about to go
        }
        if (wanted(*window)) {
            found.insert(window);
        }
        const QObjectList children = window->findChildren<QObject*>();
        for (QObject* child : children) {
            if (wanted(*child)) {
                found.insert(child);
            }
        }
    }
    return found;
}

/// Names that begin alike, for whoever wrote the script.
QString suggestions(const QString& name)
{
    const QString stem = name.section(u'.', 0, 0);
    QStringList names;
    for (const QObject* object : objectsInWindows([&](const QObject& candidate) {
             return candidate.objectName().startsWith(stem + u'.');
         })) {
        names << object->objectName();
    }
    names.removeDuplicates();
    names.sort();
    if (names.isEmpty()) {
        return {};
    }
    const bool more = names.size() > kMostSuggestions;
    return u" There are: "_s + names.mid(0, kMostSuggestions).join(u", "_s)
        + (more ? u" …"_s : u"."_s);
}

/// A dock behind another tab calls itself visible; it only lies outside of the window.
bool isBehindTab(const QDockWidget& dock)
{
    return !dock.isFloating() && !dock.parentWidget()->rect().intersects(dock.geometry());
}

} // namespace

Found findObject(const QString& path)
{
    const QString window = path.contains(u'/') ? path.section(u'/', 0, 0) : QString();
    const QString name = path.section(u'/', window.isEmpty() ? 0 : 1);
    const auto isIn = [](const QObject& object, const QString& owner) {
        for (const QObject* each = &object; each != nullptr; each = each->parent()) {
            if (each->objectName() == owner) {
                return true;
            }
        }
        return false;
    };
    QSet<QObject*> found = objectsInWindows([&](const QObject& candidate) {
        return candidate.objectName() == name && (window.isEmpty() || isIn(candidate, window));
    });
    if (window.isEmpty() && found.size() > 1) {
        // A window of a recording has the same panels: unless it is named, the live one is meant.
        found.removeIf([&](QObject* object) { return isIn(*object, u"recordingWindow"_s); });
    }
    if (found.isEmpty()) {
        return {.problem = u"There is no object \"%1\"."_s.arg(name) + suggestions(name)};
    }
    if (found.size() > 1) {
        return {.problem = u"\"%1\" is ambiguous: %2 objects have this name."_s.arg(name).arg(
                    found.size())};
    }
    return {.object = *found.begin()};
}

bool bringForward(QWidget* widget)
{
    bool isThere = widget->isVisible();
    for (QWidget* inner = widget; inner != nullptr; inner = inner->parentWidget()) {
        auto* dock = qobject_cast<QDockWidget*>(inner);
        if (dock != nullptr && (!dock->isVisible() || isBehindTab(*dock))) {
            dock->show();
            dock->raise();
            isThere = false;
        }
        auto* stack = qobject_cast<QStackedWidget*>(inner->parentWidget());
        auto* tabs = stack != nullptr ? qobject_cast<QTabWidget*>(stack->parentWidget()) : nullptr;
        if (tabs != nullptr && tabs->currentWidget() != inner) {
            tabs->setCurrentWidget(inner);
            isThere = false;
        }
        if (auto* area = qobject_cast<QScrollArea*>(inner); area != nullptr && inner != widget) {
            area->ensureWidgetVisible(widget);
        }
    }
    return isThere;
}

QString obstacleOf(const QObject* object)
{
    if (const auto* action = qobject_cast<const QAction*>(object)) {
        return action->isEnabled() ? QString() : u"\"%1\" is disabled."_s.arg(object->objectName());
    }
    const auto* widget = qobject_cast<const QWidget*>(object);
    if (widget == nullptr) {
        return {};
    }
    if (!widget->isEnabled()) {
        return u"\"%1\" is disabled."_s.arg(object->objectName());
    }
    const QWidget* modal = QApplication::activeModalWidget();
    if (modal != nullptr && modal != widget && !modal->isAncestorOf(widget)) {
        return u"\"%1\" is behind a dialog (\"%2\")."_s.arg(object->objectName(),
                                                            modal->windowTitle());
    }
    return {};
}

} // namespace trex
