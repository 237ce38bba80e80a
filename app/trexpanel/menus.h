// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QList>
#include <QString>

#include <functional>
#include <utility>

class QAction;
class QMenu;
class QMimeData;
class QWidget;

namespace trex {

struct PanelContext;

/// A menu of exclusive choices: each row is a key and the words for it. `chosen` gets the key.
void addChoices(QMenu& menu, const QString& objectPrefix,
                const QList<std::pair<QString, QString>>& rows, const QString& current,
                const std::function<void(const QString& key)>& chosen);

/// An entry with a name that scripts find ("action." + part).
QAction* addEntry(QMenu& menu, const QString& part, const QString& text, const QString& icon,
                  const std::function<void()>& triggered);

/// The entry that opens the journal of the window, if writes are recorded.
void addJournal(QMenu& menu, PanelContext& context, QWidget& window);

/// The files of this computer that were dragged.
[[nodiscard]] QStringList filesIn(const QMimeData& data);

} // namespace trex
