// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/app/commandrunner.h"

#include <QElapsedTimer>
#include <QFile>

#include <csignal>

using namespace Qt::Literals::StringLiterals;

QList<QByteArray> Finished::errLines() const
{
    QList<QByteArray> lines = err.split('\n');
    lines.removeAll({});
    return lines;
}

QList<QJsonObject> Finished::lines() const
{
    QList<QJsonObject> objects;
    for (const QByteArray& line : out.split('\n')) {
        if (!line.isEmpty()) {
            objects << QJsonDocument::fromJson(line).object();
        }
    }
    return objects;
}

RunningCommand::RunningCommand(const QStringList& arguments)
{
    m_process.setProgram(QStringLiteral(TREXCTL));
    m_process.setArguments(arguments);
    m_process.setStandardInputFile(QProcess::nullDevice());
    m_process.start();
    m_process.waitForStarted();
}

RunningCommand::~RunningCommand()
{
    if (isRunning()) {
        m_process.kill();
        m_process.waitForFinished();
    }
}

bool RunningCommand::waitForLine(const QByteArray& beginning)
{
    QElapsedTimer timer;
    timer.start();
    while (!timer.hasExpired(10'000)) {
        while (m_process.canReadLine()) {
            const QByteArray line = m_process.readLine();
            m_out += line;
            if (line.startsWith(beginning)) {
                m_line = line.trimmed();
                return true;
            }
        }
        if (!isRunning()) {
            return false;
        }
        m_process.waitForReadyRead(100);
    }
    return false;
}

void RunningCommand::signal(int number)
{
    ::kill(static_cast<pid_t>(m_process.processId()), number);
}

void RunningCommand::interrupt()
{
    signal(SIGINT);
}

Finished RunningCommand::wait(int milliseconds)
{
    const bool hasEnded = !isRunning() || m_process.waitForFinished(milliseconds);
    Finished finished;
    finished.out = m_out + m_process.readAllStandardOutput();
    finished.err = m_process.readAllStandardError();
    if (hasEnded && m_process.exitStatus() == QProcess::NormalExit) {
        finished.code = m_process.exitCode();
    } else {
        finished.err += hasEnded ? "(crashed)\n" : "(hangs)\n";
    }
    return finished;
}

Simulator::Simulator(const QStringList& arguments, bool isTcp)
{
    QStringList all{u"simulate"_s, u"--log"_s, m_folder.filePath(u"log"_s)};
    all << (isTcp ? QStringList{u"--tcp"_s, u"0"_s}
                  : QStringList{u"--pty"_s, m_folder.filePath(u"line"_s)});
    m_command = std::make_unique<RunningCommand>(all + arguments);
    m_isReady = m_command->waitForLine("ready ");
    m_port = QString::fromUtf8(m_command->firstLine().mid(6));
}

Finished Simulator::stop()
{
    m_command->interrupt();
    return m_command->wait();
}

void Simulator::powerCycle()
{
    m_command->signal(SIGUSR1);
}

QList<QJsonObject> Simulator::log() const
{
    QFile file(m_folder.filePath(u"log"_s));
    if (!file.open(QIODevice::ReadOnly)) {
        return {};
    }
    return Finished{0, file.readAll(), {}}.lines();
}

QStringList Simulator::packets(const QString& kind) const
{
    QStringList all;
    for (const QJsonObject& entry : log()) {
        if (entry["event"_L1] == "packet"_L1 && (kind.isEmpty() || entry["kind"_L1] == kind)) {
            all << entry["bytes"_L1].toString();
        }
    }
    return all;
}

Finished run(const QStringList& arguments, int milliseconds)
{
    return RunningCommand(arguments).wait(milliseconds);
}

QStringList words(const QString& text)
{
    return text.split(u' ', Qt::SkipEmptyParts);
}
