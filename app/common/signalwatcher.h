// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>

#include <initializer_list>

class QSocketNotifier;

namespace trex {

/// Turns Unix signals (SIGINT, SIGTERM, SIGUSR1) into a Qt signal on the thread that made it: the
/// handler only writes a byte to a pipe. One at a time; where there are no Unix signals it does
/// nothing. SIGHUP stays ignored in a program that was started so (nohup).
class SignalWatcher : public QObject {
    Q_OBJECT
    Q_DISABLE_COPY_MOVE(SignalWatcher)

public:
    explicit SignalWatcher(std::initializer_list<int> signalNumbers, QObject* parent = nullptr);
    ~SignalWatcher() override; ///< the signals do again what they did before

signals:
    void received(int signalNumber);

private:
    void readPipe();
    QSocketNotifier* m_notifier = nullptr;
};

} // namespace trex
