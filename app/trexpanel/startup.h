// SPDX-License-Identifier: GPL-3.0-or-later
// What a program with windows needs of its surroundings, told in a sentence where it is missing: Qt
// itself would abort, or show boxes in place of letters.
#pragma once

#include <QtGlobal>

namespace trex {

/// While it lives: when Qt gives up because no window can be shown, one sentence that names
/// --offscreen, and exit code 2. Around the making of the QApplication.
class DisplayGuard {
    Q_DISABLE_COPY_MOVE(DisplayGuard)

public:
    DisplayGuard();
    ~DisplayGuard();

private:
    QtMessageHandler m_before;
};

/// False when there is no font to write with, which is told on stderr: a STOP button that cannot be
/// read is none.
[[nodiscard]] bool hasFonts();

} // namespace trex
