// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "protocol/storage/recordingreader.h"
#include "widgets/common/panel.h"

#include <memory>
#include <vector>

namespace trex {

class PlotReferences;
class RecordingWindow;

/// Opens recordings: in windows of their own, or behind the curves of another. GUI thread.
class RecordingFiles : public QObject {
    Q_OBJECT
    Q_DISABLE_COPY_MOVE(RecordingFiles)

public:
    explicit RecordingFiles(PanelContext& live, QObject* parent = nullptr);
    ~RecordingFiles() override;

    /// Shows it in a window of its own; the same file once more only brings that forward. Errors:
    /// FileUnreadable, FileMalformed.
    [[nodiscard]] Result<void> open(const QString& path);
    void openOrTell(const QString& path); ///< the same; what is wrong is told by failed()
    /// Loads it behind what is looked at; there when it is whole.
    void compare(const QString& path, PlotReferences& references);
    void closeAll();

signals:
    void failed(const QString& sentence);
    void compared(const QString& path); ///< it is there

private:
    void forget(RecordingWindow* window);

    PanelContext& m_live;
    std::vector<std::unique_ptr<RecordingWindow>> m_windows;
};

} // namespace trex
