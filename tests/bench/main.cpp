// SPDX-License-Identifier: GPL-3.0-or-later
// Measures the program: `trex_bench [--json FILE] [store|plot|programs|record|lines|stop ...]`, all
// if none is named. Times drift with the machine and its load; the ratios within a run are what to
// compare.
#include "tests/bench/benchsections.h"

#include <QApplication>
#include <QCommandLineParser>
#include <QDir>
#include <QFile>
#include <QFileInfo>
#include <QTextStream>

#include <array>

using namespace Qt::Literals::StringLiterals;
using namespace trex::bench;

namespace {

struct Section {
    const char* name;
    void (*measure)(Results&);
};
constexpr std::array kSections{
    Section{"store", measureStore},       Section{"plot", measurePlot},
    Section{"programs", measurePrograms}, Section{"record", measureRecording},
    Section{"lines", measureLines},       Section{"stop", measureStop}};

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
    parser.addHelpOption();
    parser.process(app);

    QTextStream out(stdout);
    QTextStream err(stderr);
    const QStringList wanted = parser.positionalArguments();
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
