// SPDX-License-Identifier: GPL-3.0-or-later
#include "protocol/savefile.h"

namespace trex {

bool SaveFile::commit()
{
    if (flush()) {
        return QSaveFile::commit();
    }
    const QString why = errorString();
    cancelWriting();
    static_cast<void>(QSaveFile::commit()); // removes what was begun
    setErrorString(why);
    return false;
}

} // namespace trex
