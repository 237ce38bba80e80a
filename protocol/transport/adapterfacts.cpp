// SPDX-License-Identifier: GPL-3.0-or-later
#include "protocol/transport/adapterfacts.h"

#include <QCoreApplication>
#include <QDir>
#include <QFile>
#include <QFileInfo>

namespace trex {

namespace {

using namespace Qt::Literals::StringLiterals;

/// The device itself: udev's and our users' links end there.
QString deviceOf(const QString& port)
{
    const QString canonical = QFileInfo(port).canonicalFilePath();
    return canonical.isEmpty() ? port : canonical;
}

std::optional<int> numberIn(const QString& path)
{
    QFile file(path);
    if (!file.open(QIODevice::ReadOnly)) {
        return std::nullopt;
    }
    bool isNumber = false;
    const int number = file.read(16).trimmed().toInt(&isNumber);
    return isNumber ? std::optional(number) : std::nullopt;
}

bool holds(const QString& descriptors, const QString& device)
{
    const QDir folder(descriptors);
    const QStringList entries =
        folder.entryList(QDir::AllEntries | QDir::System | QDir::NoDotAndDotDot);
    return std::any_of(entries.begin(), entries.end(), [&](const QString& entry) {
        return QFile::symLinkTarget(folder.filePath(entry)) == device;
    });
}

} // namespace

AdapterFacts readAdapterFacts(const QString& port, const QString& system)
{
    const QString device = deviceOf(port);
    AdapterFacts facts;
    facts.kind = device.startsWith("/dev/pts/"_L1) ? AdapterFacts::Kind::PseudoTerminal
                                                   : AdapterFacts::Kind::Serial;
    facts.port = QFileInfo(device).fileName();
    if (facts.kind == AdapterFacts::Kind::PseudoTerminal) {
        return facts;
    }
    const QString driver =
        QFile::symLinkTarget(system + u"/class/tty/%1/device/driver"_s.arg(facts.port));
    facts.driver = QFileInfo(driver).fileName();
    const QString timer = system + u"/bus/usb-serial/devices/%1/latency_timer"_s.arg(facts.port);
    if (QFileInfo::exists(timer)) {
        facts.timerFile = timer;
        facts.latencyTimerMs = numberIn(timer);
    }
    return facts;
}

QString portHolder(const QString& port, const QString& processes)
{
    const QString device = deviceOf(port);
    const QString own = QString::number(QCoreApplication::applicationPid());
    const QStringList entries = QDir(processes).entryList(QDir::Dirs | QDir::NoDotAndDotDot);
    for (const QString& entry : entries) {
        const bool isProcess = !entry.isEmpty() && entry.front().isDigit();
        const QString folder = processes + u'/' + entry;
        if (!isProcess || entry == own || !holds(folder + "/fd"_L1, device)) {
            continue;
        }
        QFile name(folder + "/comm"_L1);
        const QString program = name.open(QIODevice::ReadOnly)
            ? QString::fromLocal8Bit(name.read(64)).trimmed()
            : QString();
        return program.isEmpty()
            ? QCoreApplication::translate("Errors", "process %1").arg(entry)
            : QCoreApplication::translate("Errors", "%1, process %2").arg(program, entry);
    }
    return {};
}

} // namespace trex
