// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/log/logpanel.h"

#include "protocol/savefile.h"
#include "widgets/common/eventlog.h"
#include "widgets/common/filedialogs.h"
#include "widgets/common/theme.h"

#include <QApplication>
#include <QClipboard>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QPushButton>
#include <QScrollBar>
#include <QTableView>
#include <QVBoxLayout>

namespace trex {

using namespace Qt::Literals::StringLiterals;

LogPanel::LogPanel(PanelContext& context, QWidget* parent)
    : Panel(context, parent), m_view(named(new QTableView(this), u"log.view"_s, tr("Events")))
{
    m_view->setModel(&context.log);
    m_view->setShowGrid(false);
    m_view->setWordWrap(true);
    m_view->setSelectionBehavior(QAbstractItemView::SelectRows);
    m_view->setVerticalScrollMode(QAbstractItemView::ScrollPerPixel);
    m_view->setTabKeyNavigation(false);
    m_view->verticalHeader()->hide();
    m_view->verticalHeader()->setSectionResizeMode(QHeaderView::ResizeToContents);
    m_view->horizontalHeader()->setSectionResizeMode(QHeaderView::ResizeToContents);
    m_view->horizontalHeader()->setStretchLastSection(true);
    m_view->horizontalHeader()->setDefaultAlignment(Qt::AlignLeft | Qt::AlignVCenter);

    auto* copyButton = named(new QPushButton(theme::icon(u"copy"_s), tr("Copy"), this),
                             u"log.copy"_s, tr("Copy the log"));
    auto* saveButton = named(new QPushButton(theme::icon(u"save"_s), tr("Save…"), this),
                             u"log.save"_s, tr("Save the log"));
    connect(copyButton, &QPushButton::clicked, this, &LogPanel::copy);
    connect(saveButton, &QPushButton::clicked, this, &LogPanel::save);
    // Follows the newest entry unless the person has scrolled up to read.
    connect(&context.log, &QAbstractItemModel::rowsInserted, this, [this] {
        const QScrollBar* bar = m_view->verticalScrollBar();
        if (bar->value() >= bar->maximum() - 8) {
            QMetaObject::invokeMethod(m_view, &QTableView::scrollToBottom, Qt::QueuedConnection);
        }
    });

    auto* buttons = new QHBoxLayout;
    buttons->addWidget(copyButton);
    buttons->addWidget(saveButton);
    buttons->addStretch();
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(8, 8, 8, 8);
    layout->setSpacing(8);
    layout->addWidget(m_view);
    layout->addLayout(buttons);
    m_view->scrollToBottom();
}

void LogPanel::copy()
{
    QApplication::clipboard()->setText(context().log.toText());
}

void LogPanel::save()
{
    context().fileDialogs.askSave(
        this, tr("Save the log"), u"trexpanel-log.txt"_s, tr("Text (*.txt)"),
        [this](const QString& path) {
            SaveFile file(path);
            const bool saved = file.open(QIODevice::WriteOnly)
                && file.write(context().log.toText().toUtf8()) >= 0 && file.commit();
            context().log.add(
                saved ? EventLog::Information : EventLog::Failure,
                saved ? tr("Log saved to %1.").arg(path)
                      : tr("The log could not be saved to %1: %2. Choose another place.")
                            .arg(path, file.errorString()));
        });
}

} // namespace trex
