// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/packets/packetentry.h"

#include "protocol/codec/packet.h"
#include "protocol/errortext.h"

namespace trex {

using namespace Qt::Literals::StringLiterals;

namespace {

const QString kAbsent = u"–"_s;

/// What failed, without the advice that follows it.
QString firstSentence(const QString& text)
{
    const qsizetype end = text.indexOf(". "_L1);
    return end < 0 ? text : text.left(end);
}

} // namespace

QString spacedHex(const QByteArray& bytes)
{
    return QString::fromLatin1(bytes.toHex(' ').toUpper());
}

PacketEntry::PacketEntry(TransactionRecord taken, const LineSettings& line,
                         double secondsSinceOpened)
    : record(std::move(taken)), seconds(secondsSinceOpened), hasCrc(line.hasCrc())
{
    if (record.isRaw) {
        const Result<DecodedPacket> decoded = decodePacket(record.sentBytes, line);
        isDecoded = decoded.has_value();
        record.command = decoded ? decoded->command : Command{};
    }
}

const CommandRow* PacketEntry::row() const
{
    return isDecoded ? findCommand(record.command.opcode) : nullptr;
}

QString PacketEntry::sentHex() const
{
    return spacedHex(record.sentBytes);
}

QString PacketEntry::receivedHex() const
{
    return record.receivedBytes.isEmpty() ? kAbsent : spacedHex(record.receivedBytes);
}

QString PacketEntry::meaning() const
{
    const QString sent = isDecoded ? describe(record.command) : tr("Raw bytes");
    const QString asked = record.isRaw && isDecoded ? tr("Raw: %1").arg(sent) : sent;
    const bool hasReply = !record.error && !record.receivedBytes.isEmpty();
    if (!hasReply || !isDecoded) {
        return asked;
    }
    QByteArrayView payload(record.receivedBytes);
    if (hasCrc) {
        payload.chop(1);
    }
    return u"%1 → %2"_s.arg(asked, describeReply(record.command, payload));
}

QString PacketEntry::roundTrip() const
{
    if (record.receivedBytes.isEmpty() || record.error) {
        return kAbsent;
    }
    const std::chrono::duration<double, std::milli> taken = record.ended - record.sent;
    return QString::number(taken.count(), 'f', 1);
}

QString PacketEntry::note() const
{
    QStringList parts;
    if (record.error) {
        parts.append(firstSentence(errorText({*record.error, {}})));
    }
    if (record.attempt > 1) {
        parts.append(tr("attempt %1").arg(record.attempt));
    }
    return parts.join(u", "_s);
}

bool PacketEntry::isOf(PacketClass kind) const
{
    const CommandRow* command = row();
    const auto is = [command](CommandKind wanted) {
        return command != nullptr && command->kind == wanted;
    };
    switch (kind) {
    case PacketClass::All:
        return true;
    case PacketClass::Motors:
        return is(CommandKind::Motor);
    case PacketClass::Settings:
        return is(CommandKind::Setting);
    case PacketClass::Queries:
        return is(CommandKind::Query) && record.priority != Priority::Poll;
    case PacketClass::Polls:
        return record.priority == Priority::Poll;
    case PacketClass::Errors:
        return record.error.has_value();
    }
    return true;
}

bool PacketEntry::contains(const QString& needle) const
{
    if (meaning().contains(needle, Qt::CaseInsensitive)) {
        return true;
    }
    if (const CommandRow* command = row(); command != nullptr
        && QString::fromLatin1(command->key.data(), static_cast<qsizetype>(command->key.size()))
               .contains(needle)) {
        return true;
    }
    QString digits = needle;
    const QByteArray hex = digits.remove(u' ').toLatin1();
    return !hex.isEmpty()
        && (record.sentBytes.toHex().contains(hex) || record.receivedBytes.toHex().contains(hex));
}

} // namespace trex
