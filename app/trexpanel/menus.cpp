// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/trexpanel/menus.h"

#include "widgets/common/panel.h"
#include "widgets/common/theme.h"
#include "widgets/journal/journaldialog.h"

#include <QAction>
#include <QActionGroup>
#include <QMenu>
#include <QMimeData>
#include <QUrl>

namespace trex {

using namespace Qt::Literals::StringLiterals;

void addChoices(QMenu& menu, const QString& objectPrefix,
                const QList<std::pair<QString, QString>>& rows, const QString& current,
                const std::function<void(const QString& key)>& chosen)
{
    auto* group = new QActionGroup(&menu);
    for (const auto& [key, text] : rows) {
        QAction* action = menu.addAction(text);
        action->setObjectName(objectPrefix + key);
        action->setCheckable(true);
        action->setChecked(key == current);
        group->addAction(action);
        QObject::connect(action, &QAction::triggered, &menu, [chosen, key = key] { chosen(key); });
    }
}

QAction* addEntry(QMenu& menu, const QString& part, const QString& text, const QString& icon,
                  const std::function<void()>& triggered)
{
    QAction* action = menu.addAction(theme::icon(icon), text);
    action->setObjectName(u"action."_s + part);
    QObject::connect(action, &QAction::triggered, &menu, triggered);
    return action;
}

void addJournal(QMenu& menu, PanelContext& context, QWidget& window)
{
    if (context.audit != nullptr) {
        addEntry(menu, u"journal"_s, JournalDialog::tr("&Journal…"), u"log"_s,
                 [&context, &window] { JournalDialog::bringForward(context, &window); });
    }
}

QStringList filesIn(const QMimeData& data)
{
    QStringList paths;
    for (const QUrl& url : data.urls()) {
        if (url.isLocalFile()) {
            paths << url.toLocalFile();
        }
    }
    return paths;
}

} // namespace trex
