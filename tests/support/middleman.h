// SPDX-License-Identifier: GPL-3.0-or-later
// Stands between the program and a simulated controller on TCP, on a thread of its own, and plays
// what a network, a serial server or its computer can do to a connection.
#pragma once

#include <QPointer>
#include <QSemaphore>
#include <QTcpServer>
#include <QTcpSocket>
#include <QThread>
#include <QTimer>

#include <atomic>

#include <sys/socket.h>

namespace trex::test {

class Middleman : public QThread {
public:
    enum class Way {
        Pass, ///< all bytes, both ways
        Reset, ///< the connection is torn off (RST), and none is accepted
        Finish, ///< the connection is closed in order (FIN), and none is accepted
        Silent, ///< the connection stays, nothing passes in either direction
        Slow, ///< one byte of the answers every 200 ms
        Rubbish, ///< what comes back is noise, as fast as it is taken
        RubbishOnce, ///< the same, and no other connection is accepted
    };

    explicit Middleman(quint16 behind) : m_behind(behind)
    {
        start();
        m_started.acquire();
    }
    ~Middleman() override
    {
        quit();
        wait();
    }

    [[nodiscard]] quint16 port() const { return m_port; }
    [[nodiscard]] qint64 poured() const { return m_poured; } ///< bytes of rubbish taken
    void be(Way way)
    {
        QMetaObject::invokeMethod(m_server, [this, way] { become(way); });
    }

protected:
    void run() override
    {
        QTcpServer server;
        m_server = &server;
        QTimer drip;
        QObject::connect(&drip, &QTimer::timeout, &server, [this] {
            if (m_way == Way::Slow && m_client != nullptr) {
                m_client->write(m_held.left(1));
                m_held.remove(0, 1);
            }
        });
        drip.start(200);
        QObject::connect(&server, &QTcpServer::newConnection, &server, [this] { accept(); });
        server.listen(QHostAddress::LocalHost);
        m_port = server.serverPort();
        m_started.release();
        exec();
    }

private:
    void accept()
    {
        drop(); // a new one replaces the old one, as a serial server does it with kickolduser
        m_client = m_server->nextPendingConnection();
        m_line = new QTcpSocket(m_client);
        m_line->connectToHost(QHostAddress::LocalHost, m_behind);
        QObject::connect(m_client, &QTcpSocket::readyRead, m_server, [this] {
            const QByteArray bytes = m_client->readAll();
            if (m_line != nullptr && m_way != Way::Silent) {
                m_line->write(bytes);
            }
        });
        QObject::connect(m_line, &QTcpSocket::readyRead, m_server, [this] {
            const QByteArray bytes = m_line->readAll();
            if (m_way == Way::Pass) {
                m_client->write(bytes);
            } else if (m_way == Way::Slow) {
                m_held += bytes;
            }
        });
        QObject::connect(m_client, &QTcpSocket::bytesWritten, m_server, [this](qint64 count) {
            m_poured += isPouring() ? count : 0;
            pour();
        });
        pour();
    }

    void become(Way way)
    {
        m_way = way;
        m_held.clear();
        if (way == Way::Reset || way == Way::Finish) {
            m_server->close();
            drop();
        } else if (way == Way::RubbishOnce) {
            m_server->close();
        } else if (!m_server->isListening()) {
            m_server->listen(QHostAddress::LocalHost, m_port);
        }
        pour();
    }

    [[nodiscard]] bool isPouring() const
    {
        return m_way == Way::Rubbish || m_way == Way::RubbishOnce;
    }

    void pour()
    {
        static const QByteArray kNoise(64 * 1024, '\xA5');
        if (isPouring() && m_client != nullptr && m_client->bytesToWrite() < kNoise.size()) {
            m_client->write(kNoise);
        }
    }

    void drop()
    {
        QTcpSocket* client = std::exchange(m_client, nullptr);
        if (client == nullptr) {
            return;
        }
        client->disconnect(m_server);
        if (m_line != nullptr) {
            m_line->disconnect(m_server);
            m_line->abort();
        }
        if (m_way == Way::Reset) {
            const linger now{1, 0}; // close() sends RST
            ::setsockopt(static_cast<int>(client->socketDescriptor()), SOL_SOCKET, SO_LINGER, &now,
                         sizeof now);
        }
        m_way == Way::Finish ? client->disconnectFromHost() : client->abort();
        client->deleteLater(); // and the line with it
    }

    quint16 m_behind;
    std::atomic<quint16> m_port = 0;
    std::atomic<qint64> m_poured = 0;
    QSemaphore m_started;
    QTcpServer* m_server = nullptr; ///< this and what follows: on its own thread
    QTcpSocket* m_client = nullptr;
    QPointer<QTcpSocket> m_line;
    Way m_way = Way::Pass;
    QByteArray m_held;
};

} // namespace trex::test
