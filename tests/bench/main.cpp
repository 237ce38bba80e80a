// SPDX-License-Identifier: GPL-3.0-or-later
// Measures the program: `trex_bench [--json FILE] [plot|store|live|record|start|stop ...]`, all if
// none is named. Times drift with the machine and its load; the ratios within a run are what to
// compare.
#include "tests/bench/benchsections.h"

#include <QApplication>
#include <QCommandLineParser>
#include <QDir>
#include <QFile>
#include <QFileInfo>
#include <QTextStream>

#include <algorithm>
#include <array>

using namespace Qt::Literals::StringLiterals;
using namespace trex::bench;

namespace {

struct Section {
    const char* name;
    void (*measure)(Results&);
};
void measureLive(Results& results)
{
    measureLines(results);
    measureProcessor(results);
}

constexpr std::array kSections{Section{"plot", measurePlot},   Section{"store", measureStore},
                               Section{"live", measureLive},   Section{"record", measureRecording},
                               Section{"start", measureStart}, Section{"stop", measureStop}};

/// The first of the names that is no section's; empty: all are.
QString unknownOf(const QStringList& names)
{
    for (const QString& name : names) {
        if (std::none_of(kSections.begin(), kSections.end(), [&](const Section& section) {
                return name == QLatin1StringView(section.name);
            })) {
            return name;
        }
    }
    return {};
}

} // namespace

int main(int argc, char** argv)
{
    qputenv("QT_QPA_PLATFORM", "offscreen");
    if (argc == 2 && QByteArrayView(argv[1]) == "--bare-chart") {
        const QApplication app(argc, argv);
        return runBareChart();
    }
    const QApplication app(argc, argv);
    QCommandLineParser parser;
    const QCommandLineOption json(u"json"_s, u"Write the results as JSON."_s, u"FILE"_s);
    parser.addOption(json);
    parser.addPositionalArgument(
        u"section"_s, u"plot, store, live, record, start, stop; all if none."_s, u"[section...]"_s);
    parser.addHelpOption();
    parser.process(app);

    QTextStream out(stdout);
    QTextStream err(stderr);
    const QStringList wanted = parser.positionalArguments();
    if (const QString unknown = unknownOf(wanted); !unknown.isEmpty()) {
        err << "There is no section '" << unknown << "': plot, store, live, record, start, stop\n";
        return 2;
    }
    err << "load of the machine at the start: " << systemLoad() << '\n';
    Results results;
    for (const Section& section : kSections) {
        const QString name = QString::fromLatin1(section.name);
        if (wanted.isEmpty() || wanted.contains(name)) {
            err << "measuring " << name << " ...\n" << Qt::flush;
            section.measure(results);
        }
    }
    out << results.table() << Qt::flush;
    if (parser.isSet(json)) {
        QFile file(parser.value(json));
        QDir().mkpath(QFileInfo(file).absolutePath());
        if (!file.open(QIODevice::WriteOnly) || file.write(results.json()) < 0) {
            err << file.fileName() << ": " << file.errorString() << '\n';
            return 1;
        }
    }
    return 0;
}
