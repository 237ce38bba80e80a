// SPDX-License-Identifier: GPL-3.0-or-later
// A simulated controller on a pseudo-terminal and a thread of its own, as another program would be,
// and its record of what it heard and did: a witness beyond the reach of the host's code.
#pragma once

#include "protocol/sim/simserver.h"

#include <QFile>
#include <QJsonDocument>
#include <QJsonObject>
#include <QSemaphore>
#include <QThread>

#include <optional>
#include <vector>

namespace trex::test {

class SimWitness : public QThread {
public:
    SimWitness(sim::SimOptions options, QString link, QString log)
        : m_options(std::move(options)), m_link(std::move(link)), m_log(std::move(log))
    {
        start();
        m_started.acquire();
    }
    /// On TCP, at a free port of this computer; without a log when it has no name.
    SimWitness(sim::SimOptions options, quint16 tcpPort, QString log)
        : m_options(std::move(options)), m_log(std::move(log)), m_tcpPort(tcpPort)
    {
        start();
        m_started.acquire();
    }
    ~SimWitness() override { end(); }
    SimWitness(const SimWitness&) = delete;
    SimWitness& operator=(const SimWitness&) = delete;
    [[nodiscard]] bool isOk() const { return m_server != nullptr; }
    [[nodiscard]] quint16 tcpPort() const { return m_tcpPort.value_or(0); }
    void setFaults(const sim::Faults& faults) ///< their times count from now
    {
        QMetaObject::invokeMethod(m_server, [server = m_server, faults] {
            server->line().setFaults(faults, server->virtualNow());
        });
    }
    void hangUp(double seconds)
    {
        sim::Faults faults;
        faults.hangupFor = seconds;
        setFaults(faults);
    }
    void powerCycle()
    {
        QMetaObject::invokeMethod(m_server, [server = m_server] { server->powerCycle(); });
    }
    void end() ///< the log is complete after this
    {
        quit();
        wait();
    }

protected:
    void run() override
    {
        sim::SimServer server(m_options);
        const bool isLogged = m_log.isEmpty() || server.setLogFile(m_log).has_value();
        const auto listening = m_tcpPort ? server.listenTcp(*m_tcpPort) : server.listenPty(m_link);
        if (isLogged && listening.has_value()) {
            m_server = &server;
        }
        if (m_tcpPort) {
            m_tcpPort = server.tcpPort();
        }
        m_started.release();
        exec();
    }

private:
    sim::SimOptions m_options;
    QString m_link;
    QString m_log;
    std::optional<quint16> m_tcpPort; ///< none: a pseudo-terminal
    QSemaphore m_started;
    sim::SimServer* m_server = nullptr; ///< on its own thread
};

/// What the witness saw.
struct SimRecord {
    struct Packet {
        QByteArray bytes;
        double epochMs = 0.0;
    };
    std::vector<Packet> motorPackets; ///< as heard
    std::array<int, 3> speeds{}; ///< last of each motor
    std::array<bool, 3> moved{};
    std::optional<double> restedMs; ///< epoch of the moment from which on all three stood still
    double lastMovedMs = 0.0; ///< epoch of the last change to a speed other than 0
    bool isBad = false; ///< something that the controller could not take
};

inline SimRecord readSimRecord(const QString& path)
{
    SimRecord record;
    QFile file(path);
    if (!file.open(QIODevice::ReadOnly)) {
        record.isBad = true;
        return record;
    }
    while (!file.atEnd()) {
        const QJsonObject entry = QJsonDocument::fromJson(file.readLine()).object();
        const QString kind = entry[QLatin1StringView("kind")].toString();
        const double epochMs = entry[QLatin1StringView("epochMs")].toDouble();
        if (entry[QLatin1StringView("event")] == QLatin1StringView("output")) {
            const auto motor =
                static_cast<std::size_t>(entry[QLatin1StringView("motor")].toInt() - 1);
            const int speed = entry[QLatin1StringView("speed")].toInt();
            record.speeds.at(motor) = speed;
            record.moved.at(motor) = record.moved.at(motor) || speed != 0;
            if (speed != 0) {
                record.lastMovedMs = epochMs;
                record.restedMs.reset();
            } else if (record.speeds == std::array{0, 0, 0} && !record.restedMs) {
                record.restedMs = epochMs;
            }
        } else if (kind == QLatin1StringView("motor")) {
            record.motorPackets.push_back(
                {QByteArray::fromHex(entry[QLatin1StringView("bytes")].toString().toLatin1()),
                 epochMs});
        } else if (kind.startsWith(QLatin1StringView("bad"))) {
            record.isBad = true;
        }
    }
    return record;
}

} // namespace trex::test
