// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/common/logging.h"

#include "protocol/codec/packet.h"
#include "protocol/errortext.h"
#include "protocol/session/controller.h"

#include <QCoreApplication>
#include <QLoggingCategory>

#include <cstdio>

namespace trex {
namespace {

constexpr auto kContext = "Logging";

QString spacedHex(const QByteArray& bytes)
{
    return QString::fromLatin1(bytes.toHex(' ').toUpper());
}

double milliseconds(Duration duration)
{
    return std::chrono::duration<double, std::milli>(duration).count();
}

QString outcomeOf(const TransactionRecord& record)
{
    if (record.error) {
        return errorText({*record.error, {}});
    }
    if (record.receivedBytes.isEmpty()) {
        return QCoreApplication::translate(kContext, "sent");
    }
    return record.isRaw ? QCoreApplication::translate(kContext, "answered")
                        : describeReply(record.command, record.receivedBytes);
}

QString lineOf(const TransactionRecord& record, Instant start, bool withBytes)
{
    const QString what = record.isRaw ? QCoreApplication::translate(kContext, "Bytes as given")
                                      : describe(record.command);
    QString line = QStringLiteral("%1 s  %2: %3 (%4 ms)")
                       .arg(milliseconds(record.sent - start) / 1000.0, 8, 'f', 4)
                       .arg(what, outcomeOf(record))
                       .arg(milliseconds(record.ended - record.sent), 0, 'f', 2);
    if (record.attempt > 1) {
        line += QCoreApplication::translate(kContext, ", attempt %1").arg(record.attempt);
    }
    if (withBytes) {
        line += QStringLiteral("  > %1").arg(spacedHex(record.sentBytes));
        if (!record.receivedBytes.isEmpty()) {
            line += QStringLiteral("  < %1").arg(spacedHex(record.receivedBytes));
        }
    }
    return line;
}

void dropMessage(QtMsgType type, const QMessageLogContext&, const QString& text)
{
    if (type == QtCriticalMsg || type == QtFatalMsg) {
        printMessage(text);
    }
}

void showMessage(QtMsgType, const QMessageLogContext&, const QString& text)
{
    printMessage(text);
}

} // namespace

void printMessage(const QString& text)
{
    QString oneLine = text.trimmed();
    for (QChar& letter : oneLine) { // a file's name or a peer's bytes may hold anything
        if (letter.category() == QChar::Other_Control) {
            letter = u' ';
        }
    }
    const QByteArray line = oneLine.toUtf8() + '\n';
    std::fwrite(line.constData(), 1, static_cast<std::size_t>(line.size()), stderr);
    std::fflush(stderr);
}

void installLogging(int verbosity)
{
    qInstallMessageHandler(verbosity > 0 ? showMessage : dropMessage);
}

void logWire(Controller& controller, int verbosity)
{
    if (verbosity <= 0) {
        return;
    }
    const auto start = std::chrono::steady_clock::now();
    QObject::connect(&controller, &Controller::eventLogged, &controller,
                     [](int, const QString& text) { printMessage(text); });
    QObject::connect(&controller, &Controller::recordsArrived, &controller,
                     [start, verbosity](const std::vector<TransactionRecord>& records) {
                         for (const auto& record : records) {
                             printMessage(lineOf(record, start, verbosity > 1));
                         }
                     });
}

} // namespace trex
