// SPDX-License-Identifier: GPL-3.0-or-later
// export
#include "app/trexctl/verbs.h"
#include "protocol/storage/recordingcsv.h"
#include "protocol/storage/recordingreader.h"

#include <CLI/CLI.hpp>

using namespace Qt::Literals::StringLiterals;

namespace trex {
namespace {

class ExportVerb : public Verb {
public:
    void declare(CLI::App& app) override
    {
        const auto add = [&app](const char* name, QString& target, const QString& help) {
            return app
                .add_option_function<std::string>(
                    name,
                    [&target](const std::string& text) { target = QString::fromStdString(text); },
                    help.toStdString())
                ->required();
        };
        add("FILE", m_path, Cli::tr("a recording"));
        add("--csv", m_csv, Cli::tr("the file to write: one row a sample"))->type_name("OUT");
    }
    [[nodiscard]] Line line() const override { return Line::None; }
    [[nodiscard]] bool usesPort() const override { return false; }

    Task run(Session& session) override
    {
        auto reader = RecordingReader::open(m_path);
        if (!reader) {
            session.fail(reader.error());
            co_return;
        }
        RecordingReader& recording = **reader;
        TelemetryStore store;
        recording.loadAll(store, Instant());
        CsvOptions options{.model = recording.model(), .input = recording.input()};
        options.polls.fill(true);
        const auto rows = exportSamplesCsv(m_csv, store, options);
        if (!rows) {
            session.fail(rows.error());
            co_return;
        }
        if (const QString remark = recording.remark(); !remark.isEmpty()) {
            session.warn(remark);
        }
        const auto count = static_cast<qint64>(*rows);
        session.output().answer(
            QJsonObject{{u"file"_s, m_path}, {u"csv"_s, m_csv}, {u"rows"_s, count}},
            Cli::tr("%1: %2 rows").arg(m_csv).arg(count));
        session.end();
    }

private:
    QString m_path;
    QString m_csv;
};

} // namespace

std::unique_ptr<Verb> makeExport()
{
    return std::make_unique<ExportVerb>();
}

} // namespace trex
