// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <QTimer>

class QWidget;

namespace trex {

/// Watches over something that a person holds to keep a motor running, a key or the mouse button on
/// one widget, and tells when the hold cannot be trusted any more: the widget lost the focus, was
/// hidden or disabled, another window or program came to the front, or a held key gives no sign of
/// life. GUI thread.
class HoldWatch : public QObject {
    Q_OBJECT
    Q_DISABLE_COPY_MOVE(HoldWatch)

public:
    explicit HoldWatch(QWidget& held);
    enum class By : std::uint8_t { Mouse, Key };
    void begin(By by);
    void sign(); ///< a key's auto-repeat
    void end();
    [[nodiscard]] bool isHeld() const { return m_isHeld; }

    // A held key repeats itself after the desktop's delay (seldom above 1 s) and then many times a
    // second. Where repeats have been seen, their end without a release is a lost release; where
    // none ever come (switched off, or another key took them over), nobody can tell, and the hold
    // ends after the longer time.
    static constexpr std::chrono::milliseconds kWithoutRepeat{3000};
    static constexpr std::chrono::milliseconds kBetweenRepeats{600};

signals:
    void lost();

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    void lose();
    QTimer m_key;
    bool m_isHeld = false;
};

} // namespace trex
