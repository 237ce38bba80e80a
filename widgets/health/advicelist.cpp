// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/health/advicelist.h"

#include "widgets/common/panel.h"
#include "widgets/common/stateshape.h"
#include "widgets/common/theme.h"

#include <QApplication>
#include <QClipboard>
#include <QFontDatabase>
#include <QLabel>
#include <QPainter>
#include <QPushButton>
#include <QVBoxLayout>

namespace trex {

using namespace Qt::Literals::StringLiterals;

namespace {

constexpr int kShapeSize = 14;

StateShape shapeOf(LinkAdvice::Look look)
{
    switch (look) {
    case LinkAdvice::Look::Ok:
    case LinkAdvice::Look::Note:
        return StateShape::Ok;
    case LinkAdvice::Look::Warning:
        return StateShape::Warning;
    case LinkAdvice::Look::Fault:
        return StateShape::Fault;
    case LinkAdvice::Look::Off:
        break;
    }
    return StateShape::Off;
}

/// The panels' own titles (panelregistry.cpp), in their words.
QString titleOf(QLatin1StringView panel)
{
    const char* title = panel == "parameters"_L1 ? "Parameters"
        : panel == "packets"_L1                  ? "Packets"
        : panel == "status"_L1                   ? "Status"
        : panel == "log"_L1                      ? "Log"
                                                 : "Connection";
    return QCoreApplication::translate("Panels", title);
}

} // namespace

AdviceList::AdviceList(QWidget* parent) : QWidget(parent), m_layout(new QVBoxLayout(this))
{
    m_layout->setContentsMargins(0, 0, 0, 0);
    m_layout->setSpacing(8);
    m_layout->addStretch();
}

QString AdviceList::kinds() const
{
    QStringList keys;
    for (const Row& row : m_rows) {
        keys << keyOf(row.advice.kind);
    }
    return keys.join(u',');
}

void AdviceList::show(const std::vector<LinkAdvice>& advice)
{
    const bool isSame =
        std::equal(advice.begin(), advice.end(), m_rows.begin(), m_rows.end(),
                   [](const LinkAdvice& a, const Row& row) {
                       return a.kind == row.advice.kind && a.command == row.advice.command;
                   });
    if (!isSame) {
        for (const Row& row : m_rows) {
            row.box->hide();
            row.box->deleteLater();
        }
        m_rows.clear();
        for (const LinkAdvice& one : advice) {
            const qsizetype number = std::ssize(m_rows) + 1;
            m_rows.push_back(makeRow(one, number));
            m_layout->insertWidget(static_cast<int>(number) - 1, m_rows.back().box);
        }
    }
    for (std::size_t i = 0; i < advice.size(); ++i) {
        m_rows[i].advice = advice[i];
        m_rows[i].text->setText(advice[i].sentence);
    }
    update();
}

AdviceList::Row AdviceList::makeRow(const LinkAdvice& advice, qsizetype number)
{
    const QString name = u"health.advice.%1"_s.arg(number);
    auto* box = new QWidget(this);
    auto* layout = new QVBoxLayout(box);
    layout->setContentsMargins(kShapeSize + 8, 0, 0, 0);
    layout->setSpacing(4);
    auto* text = named(new QLabel(box), name + u".text"_s, tr("Advice %1").arg(number));
    text->setWordWrap(true);
    text->setTextFormat(Qt::PlainText);
    text->setTextInteractionFlags(Qt::TextSelectableByMouse | Qt::TextSelectableByKeyboard);
    layout->addWidget(text);
    if (!advice.command.isEmpty()) {
        // Breaks after each slash; what is copied is the command itself.
        QString shown = advice.command;
        shown.replace(u'/', u"/\u200B"_s);
        auto* command =
            named(new QLabel(shown, box), name + u".command"_s, tr("Command for the superuser"));
        command->setFont(QFontDatabase::systemFont(QFontDatabase::FixedFont));
        command->setWordWrap(true);
        command->setTextFormat(Qt::PlainText);
        layout->addWidget(command);
    }
    if (!advice.command.isEmpty() || !advice.panel.isEmpty()) {
        layout->addWidget(makeButton(advice, name), 0, Qt::AlignLeft);
    }
    return {advice, box, text};
}

QPushButton* AdviceList::makeButton(const LinkAdvice& advice, const QString& name)
{
    auto* button = named(new QPushButton, name + u".go"_s);
    if (!advice.command.isEmpty()) {
        button->setText(tr("Copy the command"));
        button->setIcon(theme::icon(u"copy"_s));
        connect(button, &QPushButton::clicked, this,
                [command = advice.command] { QApplication::clipboard()->setText(command); });
        return button;
    }
    button->setText(tr("Go to %1").arg(titleOf(advice.panel)));
    const QString target = advice.control.isEmpty() ? QString(advice.panel)
                                                    : QString(advice.panel + u'/' + advice.control);
    connect(button, &QPushButton::clicked, this, [this, target] { emit panelRequested(target); });
    return button;
}

void AdviceList::paintEvent(QPaintEvent* /*event*/)
{
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    for (const Row& row : m_rows) {
        const double lineHeight = row.text->fontMetrics().height();
        drawStateShape(
            painter,
            QRectF(0, row.box->y() + (lineHeight - kShapeSize) / 2.0 + 1, kShapeSize, kShapeSize),
            shapeOf(row.advice.look));
    }
}

} // namespace trex
