// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/trexpanel/recordingfiles.h"

#include "app/trexpanel/recordingwindow.h"
#include "protocol/errortext.h"
#include "protocol/storage/comparisonrun.h"
#include "widgets/common/eventlog.h"

#include <QDir>
#include <QFileInfo>

namespace trex {

RecordingFiles::RecordingFiles(PanelContext& live, QObject* parent) : QObject(parent), m_live(live)
{
}

RecordingFiles::~RecordingFiles() = default;

Result<void> RecordingFiles::open(const QString& path)
{
    const QString whole = QFileInfo(path).absoluteFilePath();
    for (const auto& window : m_windows) {
        if (window->windowFilePath() == whole) {
            window->show();
            window->raise();
            window->activateWindow();
            return {};
        }
    }
    auto reader = RecordingReader::open(path);
    if (!reader) {
        return tl::make_unexpected(reader.error());
    }
    auto window = std::make_unique<RecordingWindow>(m_live, std::move(*reader), path);
    window->setWindowFilePath(whole);
    connect(window.get(), &RecordingWindow::closed, this,
            [this, gone = window.get()] { forget(gone); });
    connect(window.get(), &RecordingWindow::recordingChosen, this, &RecordingFiles::openOrTell);
    connect(window.get(), &RecordingWindow::comparisonChosen, this,
            [this, shown = window.get()](const QString& other) {
                compare(other, shown->references());
            });
    window->show();
    m_windows.push_back(std::move(window));
    return {};
}

void RecordingFiles::openOrTell(const QString& path)
{
    if (const auto opened = open(path); !opened) {
        emit failed(errorText(opened.error()));
    }
}

void RecordingFiles::compare(const QString& path, PlotReferences& references)
{
    auto reader = RecordingReader::open(path);
    if (!reader) {
        emit failed(errorText(reader.error()));
        return;
    }
    // Lives until it is loaded, or until the runs that it goes to are no more.
    auto* run = new ComparisonRun(std::move(*reader), path, &references);
    connect(run, &ComparisonRun::finished, this, [this, run, path, &references] {
        run->addTo(references);
        run->deleteLater();
        m_live.log.add(EventLog::Information,
                       tr("Compared with %1: its curves lie behind those of the plots.")
                           .arg(QDir::toNativeSeparators(path)));
        emit compared(path);
    });
    run->start();
}

/// Later: it is still closing.
void RecordingFiles::forget(RecordingWindow* window)
{
    const auto found = std::find_if(m_windows.begin(), m_windows.end(),
                                    [window](const auto& each) { return each.get() == window; });
    if (found != m_windows.end()) {
        found->release()->deleteLater();
        m_windows.erase(found);
    }
}

void RecordingFiles::closeAll()
{
    m_windows.clear();
}

} // namespace trex
