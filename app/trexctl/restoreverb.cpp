// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/trexctl/restoreverb.h"

#include "protocol/codec/packet.h"

#include <CLI/CLI.hpp>

using namespace Qt::Literals::StringLiterals;

namespace trex {
namespace {

QJsonObject json(const TransferPlan& plan)
{
    QJsonArray changed;
    for (const auto& change : plan.changes()) {
        changed.append(
            QJsonObject{{u"key"_s, change.key},
                        {u"from"_s, change.from ? QJsonValue(*change.from) : QJsonValue()},
                        {u"to"_s, change.to}});
    }
    return {{u"changed"_s, changed}, {u"needsReset"_s, plan.needsReset()}};
}

QString text(const TransferPlan& plan)
{
    QStringList lines;
    for (const auto& write : plan.writes) {
        lines << write.text();
    }
    return lines.isEmpty() ? Cli::tr("Nothing differs.") : lines.join(u'\n');
}

void showPackets(Session& session, const TransferPlan& plan)
{
    QJsonArray packets;
    QString lines = text(plan);
    for (const Command& command : plan.commands()) {
        const QString hex = toHex(encode(command, session.options().line));
        packets.append(hex);
        lines += u"\n  %1  %2"_s.arg(hex, describe(command));
    }
    QJsonObject document = json(plan);
    document.insert(u"packets"_s, packets);
    session.output().answer(document, lines);
}

} // namespace

void RestoreVerb::declare(CLI::App& app)
{
    app.add_flag("--dry-run", m_isDryRun,
                 Cli::tr("write nothing; show the changes and their packets").toStdString());
}

Task RestoreVerb::run(Session& session)
{
    m_transfer = std::make_unique<ConfigTransfer>(session.controller(), session.settings());
    co_await session.need<Configuration>([&](const Awaiting<Configuration>::Handler& handler) {
        QObject::connect(m_transfer.get(), &ConfigTransfer::readFinished, &session, handler);
        m_transfer->read();
    });
    const auto state = wanted(session);
    if (!state) {
        session.fail(state.error());
        co_return;
    }
    const TransferPlan plan = session.audit().planRestore(*state);
    if (m_isDryRun) {
        showPackets(session, plan);
    } else {
        if (!plan.writes.empty()) {
            m_isWriting = true;
            const TransferOutcome outcome = co_await session.need<TransferOutcome>(
                [&](const Awaiting<TransferOutcome>::Handler& handler) {
                    QObject::connect(m_transfer.get(), &ConfigTransfer::finished, &session,
                                     handler);
                    m_transfer->write(plan);
                });
            if (outcome.error) {
                session.fail(Failure{exitCodeOf(outcome.error->code), outcome.text()});
                co_return;
            }
        }
        session.output().answer(json(plan), text(plan));
        if (plan.needsReset()) {
            session.warn(Cli::tr("Some of it acts after the controller's power is switched off "
                                 "and on."));
        }
    }
    for (const QString& sentence : plan.leftOut) {
        session.warn(sentence);
    }
    session.end();
}

void RestoreVerb::interrupted(Session& session)
{
    if (m_isWriting) {
        m_transfer->cancel(); // puts back what was written, then ends with Cancelled
    } else {
        Verb::interrupted(session);
    }
}

} // namespace trex
