// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QTime>
#include <QWidget>

class QLabel;

namespace trex {

/// One line that says that the controller was restarted, when, and what became of it: everything
/// is read again, and what waited for a power cycle is in force. It stays until the person has seen
/// it. GUI thread.
class RestartLine : public QWidget {
    Q_OBJECT
    Q_DISABLE_COPY_MOVE(RestartLine)

public:
    enum class Kind : std::uint8_t {
        Sure,
        Perhaps ///< it was silent for a while, which a loose wire brings about, too
    };
    enum class Reading : std::uint8_t { Running, Done, Failed };

    explicit RestartLine(QWidget* parent);
    /// `waited`: titles of the settings that waited for a power cycle.
    void tell(Kind kind, const QTime& at, const QStringList& waited);
    void setReading(Reading reading); ///< of everything, since then
    void dismiss();

private:
    void refresh();

    QLabel* m_text;
    bool m_isShown = false;
    Kind m_kind = Kind::Sure;
    QTime m_at;
    QStringList m_waited;
    Reading m_reading = Reading::Running;
};

} // namespace trex
