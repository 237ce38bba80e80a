// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QSaveFile>

namespace trex {

/// A QSaveFile that keeps its word. Qt's own (6.4) replaces the old file all the same when what it
/// still held in its buffer could not be written: on a full disk a configuration of some kilobytes
/// became an empty file, and commit() said that all was well.
class SaveFile : public QSaveFile {
public:
    using QSaveFile::QSaveFile;
    /// False: nothing is changed on the disk, and errorString() says why.
    [[nodiscard]] bool commit();
};

} // namespace trex
