// SPDX-License-Identifier: GPL-3.0-or-later
// Runs the real trexctl, and `trexctl simulate` beside it, as a person or a script would.
#pragma once

#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QProcess>
#include <QTemporaryDir>

#include <memory>

struct Finished {
    int code = -1;
    QByteArray out;
    QByteArray err;
    [[nodiscard]] QJsonDocument json() const { return QJsonDocument::fromJson(out); }
    [[nodiscard]] QJsonObject object() const { return json().object(); }
    [[nodiscard]] QJsonArray array() const { return json().array(); }
    [[nodiscard]] QList<QByteArray> errLines() const;
    [[nodiscard]] QList<QJsonObject> lines() const; ///< JSON Lines
};

/// A trexctl that has been started and not been waited for.
class RunningCommand {
public:
    explicit RunningCommand(const QStringList& arguments);
    ~RunningCommand();
    [[nodiscard]] bool waitForLine(const QByteArray& beginning = {}); ///< on stdout
    [[nodiscard]] QByteArray firstLine() const { return m_line; }
    void interrupt(); ///< SIGINT
    void signal(int number);
    [[nodiscard]] bool isRunning() const { return m_process.state() != QProcess::NotRunning; }
    [[nodiscard]] Finished wait(int milliseconds = 20'000);

private:
    QProcess m_process;
    QByteArray m_line;
    QByteArray m_out;
};

/// `trexctl simulate` on a pty (the default) or with the arguments given.
class Simulator {
public:
    explicit Simulator(const QStringList& arguments = {}, bool isTcp = false);
    [[nodiscard]] bool isReady() const { return m_isReady; }
    [[nodiscard]] QString port() const { return m_port; }
    [[nodiscard]] Finished stop();
    void powerCycle();
    /// What the controllers heard so far, in hex: their log's packets.
    [[nodiscard]] QList<QJsonObject> log() const;
    [[nodiscard]] QStringList packets(const QString& kind = {}) const;

private:
    QTemporaryDir m_folder;
    std::unique_ptr<RunningCommand> m_command;
    QString m_port;
    bool m_isReady = false;
};

[[nodiscard]] Finished run(const QStringList& arguments, int milliseconds = 20'000);
/// "a b c" in parts, for readable tables.
[[nodiscard]] QStringList words(const QString& text);
