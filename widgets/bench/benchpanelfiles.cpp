// SPDX-License-Identifier: GPL-3.0-or-later
// The bench panel's files: tests, reports, proposals.
#include "protocol/errortext.h"
#include "widgets/bench/benchpanel.h"
#include "widgets/bench/benchpdf.h"
#include "widgets/common/eventlog.h"
#include "widgets/common/filedialogs.h"

#include <QDir>
#include <QListWidget>

namespace trex {

using namespace Qt::Literals::StringLiterals;

namespace {

QString fileNameOf(const QString& name, const QString& ending)
{
    QString tame;
    for (const QChar letter : name.toLower()) {
        tame += letter.isLetterOrNumber() ? letter : u'-';
    }
    return (tame.isEmpty() ? u"bench-test"_s : tame) + ending;
}

} // namespace

void BenchPanel::openFile()
{
    context().fileDialogs.askOpen(this, tr("Open a bench test"), tr("Bench tests (*.json)"),
                                  [this](const QString& path) {
                                      const auto profile = loadBenchProfile(path);
                                      if (!profile) {
                                          tell(EventLog::Failure, errorText(profile.error()));
                                          return;
                                      }
                                      addEntry(*profile, path);
                                      m_list->setCurrentRow(m_list->count() - 1);
                                  });
}

void BenchPanel::saveFile()
{
    const QString suggestion =
        entry().path.isEmpty() ? fileNameOf(entry().profile.name, u".json"_s) : entry().path;
    context().fileDialogs.askSave(
        this, tr("Save the bench test"), suggestion, tr("Bench tests (*.json)"),
        [this](const QString& path) {
            if (const auto saved = saveBenchProfile(entry().profile, path); !saved) {
                tell(EventLog::Failure, errorText(saved.error()));
                return;
            }
            const BenchProfile profile = entry().profile;
            if (entry().path == path) {
                entry().original = profile;
            } else {
                entry().profile = entry().original; // the one that it was made from stays as it was
                addEntry(profile, path);
                m_list->setCurrentRow(m_list->count() - 1);
            }
            refreshTitles();
            refresh();
            tell(EventLog::Information,
                 tr("Bench test saved to %1.").arg(QDir::toNativeSeparators(path)));
        });
}

void BenchPanel::saveReportAs(bool isPdf)
{
    if (!entry().outcome) {
        return;
    }
    context().fileDialogs.askSave(
        this, isPdf ? tr("Report as PDF") : tr("Report as HTML"),
        fileNameOf(entry().profile.name, isPdf ? u".pdf"_s : u".html"_s),
        isPdf ? tr("PDF (*.pdf)") : tr("HTML (*.html)"), [this, isPdf](const QString& path) {
            const BenchOutcome& outcome = *entry().outcome;
            const auto saved = isPdf ? savePdf(path, outcome, entry().report)
                                     : saveReport(path, outcome, entry().report);
            saved ? tell(EventLog::Information,
                         tr("Report written to %1.").arg(QDir::toNativeSeparators(path)))
                  : tell(EventLog::Failure, errorText(saved.error()));
        });
}

void BenchPanel::saveProposals()
{
    if (!entry().outcome) {
        return;
    }
    context().fileDialogs.askSave(
        this, tr("Proposed settings as a configuration file"),
        fileNameOf(entry().profile.name, u"-proposals.json"_s), tr("Configurations (*.json)"),
        [this](const QString& path) {
            const Configuration configuration =
                configurationOf(entry().outcome->proposals, entry().profile.name);
            if (const auto saved = saveConfiguration(configuration, path); !saved) {
                tell(EventLog::Failure, errorText(saved.error()));
                return;
            }
            tell(EventLog::Information,
                 tr("Proposals written to %1. Load shows them in the parameters, where each is "
                    "taken or left.")
                     .arg(QDir::toNativeSeparators(path)));
            emit panelRequested(u"parameters"_s);
        });
}

} // namespace trex
