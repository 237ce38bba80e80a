// SPDX-License-Identifier: GPL-3.0-or-later
// The part of CurrentsPanel that clears, exports and records.
#include "widgets/currents/currentspanel.h"

#include "protocol/errortext.h"
#include "protocol/session/controller.h"
#include "protocol/storage/csvexport.h"
#include "protocol/telemetry/marktrack.h"
#include "widgets/common/eventlog.h"
#include "widgets/common/filedialogs.h"
#include "widgets/common/plotticks.h"
#include "widgets/common/plotview.h"

#include <QDateTime>
#include <QDir>
#include <QFileInfo>
#include <QToolButton>

namespace trex {

using namespace Qt::Literals::StringLiterals;

namespace {

QString suggestedName()
{
    return u"currents-%1.csv"_s.arg(QDateTime::currentDateTime().toString(u"yyyyMMdd-HHmmss"_s));
}

} // namespace

void CurrentsPanel::clearSamples()
{
    if (const auto pumped = m_recorder.pump(std::chrono::steady_clock::now()); !pumped) {
        context().log.add(EventLog::Failure, errorText(pumped.error()));
    }
    context().store.clear();
    if (context().marks != nullptr) {
        context().marks->clear(); // their times mean nothing without the samples
    }
    m_plot->timeline().clearCursors();
    m_latest.reset();
    m_plot->follow();
    updateDevice();
    context().log.add(EventLog::Information, tr("The samples of the session were cleared."));
}

void CurrentsPanel::askExport(bool isVisiblePartOnly)
{
    const QString title = isVisiblePartOnly ? tr("Export the visible part") : tr("Export");
    context().fileDialogs.askSave(
        this, title, suggestedName(), tr("All samples as CSV (*.csv);;Plot as picture (*.png)"),
        [this, isVisiblePartOnly](const QString& path) { writeExport(path, isVisiblePartOnly); });
}

void CurrentsPanel::writeExport(const QString& path, bool isVisiblePartOnly)
{
    const QString shown = QDir::toNativeSeparators(path);
    if (QFileInfo(path).suffix().compare(u"png"_s, Qt::CaseInsensitive) == 0) {
        if (isFileOrNew(path) && m_plot->picture().save(path, "PNG")) {
            context().log.add(EventLog::Information, tr("Plot saved as %1.").arg(shown));
        } else {
            context().log.add(EventLog::Failure, errorText({ErrorCode::FileUnwritable, path}));
        }
        return;
    }
    const auto range =
        isVisiblePartOnly ? std::optional(m_plot->visibleRange()) : std::optional<TimeRange>();
    const auto rows = exportCurrentsCsv(path, context().store, scale(), range);
    if (rows) {
        context().log.add(
            EventLog::Information,
            tr("%n sample(s) exported to %1.", nullptr, static_cast<int>(*rows)).arg(shown));
    } else {
        context().log.add(EventLog::Failure, errorText(rows.error()));
    }
}

void CurrentsPanel::toggleRecording()
{
    if (!m_recorder.isRecording()) {
        m_record->setChecked(false); // until there is a file
        context().fileDialogs.askSave(this, tr("Record the currents to a file"), suggestedName(),
                                      tr("CSV (*.csv)"),
                                      [this](const QString& path) { startRecording(path); });
        return;
    }
    const QString path = QDir::toNativeSeparators(m_recorder.path());
    if (const auto stopped = m_recorder.stop(); !stopped) {
        context().log.add(EventLog::Failure, errorText(stopped.error()));
    } else {
        context().log.add(EventLog::Information,
                          tr("Recording ended: %n sample(s) in %1.", nullptr,
                             static_cast<int>(m_recorder.samples()))
                              .arg(path));
    }
    showRecording();
    updateWish();
}

void CurrentsPanel::startRecording(const QString& path)
{
    if (const auto started = m_recorder.start(path, scale()); !started) {
        context().log.add(EventLog::Failure, errorText(started.error()));
    } else {
        m_sinceRecording.start();
        context().log.add(EventLog::Information,
                          tr("Recording the currents to %1.").arg(QDir::toNativeSeparators(path)));
    }
    showRecording();
    updateWish();
}

void CurrentsPanel::showRecording()
{
    if (const auto pumped = m_recorder.pump(std::chrono::steady_clock::now()); !pumped) {
        context().log.add(EventLog::Failure,
                          tr("Recording ended: %1").arg(errorText(pumped.error())));
        updateWish();
    }
    const bool isRecording = m_recorder.isRecording();
    constexpr qint64 kMsPerSecond = 1000;
    const qint64 second = isRecording ? m_sinceRecording.elapsed() / kMsPerSecond : -1;
    if (isRecording && second == m_shownSecond) {
        return;
    }
    m_shownSecond = second;
    m_record->setChecked(isRecording);
    if (isRecording) {
        const QString time = ticks::timeLabel(static_cast<double>(second), 1.0);
        m_record->setText(tr("Recording %1").arg(time));
        m_record->setToolTip(
            tr("%1: click to end the recording").arg(QDir::toNativeSeparators(m_recorder.path())));
    } else {
        m_record->setText(tr("Record"));
        m_record->setToolTip(tr("Write every sample from now on to a CSV file, at once"));
    }
    m_record->setIcon(theme::icon(u"record"_s, isRecording ? ColourRole::Fault : ColourRole::Text));
}

} // namespace trex
