// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <QTimer>

#include <memory>
#include <utility>

namespace trex {

/// Forward and turn (−127 to 127) of a stick, −32768 to 32767 with down and right positive; neutral
/// without the dead man's button, and within the slack that every stick has about its middle.
[[nodiscard]] std::pair<int, int> stickOrder(int x, int y, bool isDeadManHeld);

/// A gamepad by SDL2, where the program was built with it and one is plugged in: the left stick
/// drives while a shoulder button is held, the dead man's button. Unplugged, let go or no longer
/// listened to, it is neutral. GUI thread.
class Gamepad : public QObject {
    Q_OBJECT
    Q_DISABLE_COPY_MOVE(Gamepad)

public:
    explicit Gamepad(QObject* parent = nullptr);
    ~Gamepad() override;
    [[nodiscard]] static bool isBuiltIn();
    void listen(bool wanted); ///< looks 50 times a second, from the first call on that wants it
    [[nodiscard]] QString name() const { return m_name; } ///< empty: none is there
    static constexpr std::chrono::milliseconds kInterval{20};

signals:
    void nameChanged();
    void moved(int forward, int turn); ///< at each look while it drives, and once at neutral

private:
    class Device;
    void look();
    void set(std::pair<int, int> order);
    void setName(const QString& name);

    std::unique_ptr<Device> m_device;
    QTimer m_timer;
    QString m_name;
    std::pair<int, int> m_order;
};

} // namespace trex
