// SPDX-License-Identifier: GPL-3.0-or-later
// currents
#include "app/trexctl/controllertext.h"
#include "app/trexctl/streamverb.h"
#include "app/trexctl/verbs.h"
#include "protocol/storage/csvexport.h"

#include <QFile>
#include <QFileInfo>

#include <CLI/CLI.hpp>

using namespace Qt::Literals::StringLiterals;

namespace trex {
namespace {

constexpr int kJointMode = 1; // parameter 0x7B (facts.md 2)

class CurrentsVerb : public StreamVerb {
public:
    ~CurrentsVerb() override
    {
        if (m_isNewFile && !m_hasHeader) {
            m_csv.remove(); // the line could not be opened: leave no empty file behind
        }
    }

    void declare(CLI::App& app) override
    {
        StreamVerb::declare(app);
        app.add_option_function<std::string>(
               "--csv",
               [this](const std::string& path) { m_csvPath = QString::fromStdString(path); },
               Cli::tr("write the samples to a file, too, one row each").toStdString())
            ->type_name("FILE");
    }

    Checked check(const OpenOptions& options) override
    {
        auto streamChecked = StreamVerb::check(options);
        if (!streamChecked || m_csvPath.isNull()) {
            return streamChecked;
        }
        // Opened now, so that a wrong name is told before anything is sent; emptied when there is
        // a sample to write.
        m_isNewFile = !QFileInfo::exists(m_csvPath);
        m_csv.setFileName(m_csvPath);
        if (m_csvPath.isEmpty() || !m_csv.open(QIODevice::ReadWrite)) {
            m_isNewFile = false;
            return checked(Result<void>(unwritable()));
        }
        return {};
    }

protected:
    Command firstQuestion() const override
    {
        return readParameter(parameterRow("motor-mode").number);
    }

    bool begin(Session& session, const Reply& answer) override
    {
        m_model = session.controller().model();
        if (answer.payload.front() == kJointMode) {
            // conformance C-31: in joint mode there is no current, and no number is shown.
            const QString reason = Cli::tr("Joint motor mode: the controller measures no currents "
                                           "while both H-bridges drive one motor.");
            session.output().answer(
                QJsonObject{{u"t"_s, 0.0}, {u"available"_s, false}, {u"reason"_s, reason}}, reason);
            return false;
        }
        return true;
    }

    std::vector<Command> questions() const override { return {query("get-currents")}; }

    void print(Session& session, double seconds, const std::vector<Reply>& replies) override
    {
        const int raw1 = static_cast<std::uint8_t>(replies.front().payload[0]);
        const int raw2 = static_cast<std::uint8_t>(replies.front().payload[1]);
        if (const auto written = writeCsv(seconds, raw1, raw2); !written) {
            session.fail(written.error());
            return;
        }
        Output& output = session.output();
        if (output.isJson()) {
            output.json(QJsonObject{{u"t"_s, rounded(seconds, 4)},
                                    {u"motor1"_s, currentJson(raw1, m_model)},
                                    {u"motor2"_s, currentJson(raw2, m_model)}});
        } else if (isWatching()) {
            output.text(u"%1 s   %2   %3"_s.arg(seconds, 9, 'f', 3)
                            .arg(currentText(raw1, m_model), 8)
                            .arg(currentText(raw2, m_model), 8));
        } else {
            output.text(labelled(
                {{Cli::tr("Motor 1"), withRaw(raw1)}, {Cli::tr("Motor 2"), withRaw(raw2)}}));
        }
    }

    void finish(const FinishHandler& done) override
    {
        bool isFlushed = true;
        if (m_csv.isOpen() && m_hasHeader) {
            isFlushed = m_csv.flush();
            m_csv.close();
        }
        done(isFlushed ? Result<void>() : unwritable());
    }

private:
    tl::unexpected<Error> unwritable() const
    {
        return trex::fail(ErrorCode::FileUnwritable, m_csvPath);
    }

    QString withRaw(int raw) const { return u"%1 (%2)"_s.arg(currentText(raw, m_model)).arg(raw); }

    Result<void> writeCsv(double seconds, int raw1, int raw2)
    {
        if (!m_csv.isOpen()) {
            return {};
        }
        QByteArray text;
        if (!m_hasHeader) {
            // A pipe or a device cannot be shortened, and need not be.
            const bool isPlain = QFileInfo(m_csvPath).isFile();
            if (isPlain && !m_csv.resize(0)) {
                return unwritable();
            }
            text = currentsCsvHeader();
            m_hasHeader = true;
        }
        text += currentsCsvRow(seconds, raw1, raw2, amperesPerCount(m_model));
        // Handed to the system each row: a crash or Ctrl+C costs nothing.
        const bool isWritten = m_csv.write(text) == text.size() && m_csv.flush();
        return isWritten ? Result<void>() : unwritable();
    }

    QString m_csvPath;
    QFile m_csv;
    bool m_isNewFile = false;
    bool m_hasHeader = false;
    Model m_model = Model::TrexJr;
};

} // namespace

std::unique_ptr<Verb> makeCurrents()
{
    return std::make_unique<CurrentsVerb>();
}

} // namespace trex
