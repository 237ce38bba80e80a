// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/trexpanel/program.h"

#include "app/common/logging.h"
#include "app/common/version.h"
#include "app/script/metrics.h"
#include "app/script/report.h"
#include "app/script/scriptplayer.h"
#include "app/trexpanel/mainwindow.h"
#include "protocol/errortext.h"
#include "protocol/storage/datafolder.h"
#include "protocol/storage/linesettingsstore.h"
#include "widgets/common/theme.h"
#include "widgets/connection/portbox.h"

#include <QApplication>
#include <QDir>

#include <csignal>
#include <cstdio>

namespace trex {

using namespace Qt::Literals::StringLiterals;
using namespace std::chrono_literals;

namespace {

constexpr auto kPatience = 3s; ///< for the motors' stop and the line's end
constexpr QLatin1StringView kDemonstration = ":/script/demo.json"_L1;
constexpr QLatin1StringView kPictures = "out/demo"_L1;
constexpr int kStepFailed = 1;
constexpr int kUnwritable = 2;

theme::Choice choiceOf(const QString& key)
{
    return key == "light"_L1 ? theme::Choice::Light
        : key == "dark"_L1   ? theme::Choice::Dark
                             : theme::Choice::System;
}

} // namespace

Program::Program(PanelOptions options)
    : m_options(std::move(options))
    , m_file(m_options.settings)
    , m_settings(m_file)
    , m_controller(&m_store, &m_latch)
    , m_deviceSettings(m_controller)
    , m_timeoutWatch(m_controller, m_deviceSettings)
    , m_safety(m_controller, m_store, m_settings)
    , m_journal(journalPath(m_file.path()))
    , m_audit(m_controller, m_deviceSettings, m_journal, WriteAudit::WhenUnsaved::RefuseOnce)
    , m_markKeeper(m_marks, m_controller, m_latch, m_deviceSettings)
    , m_context{m_controller, m_deviceSettings, m_store,  m_latch,  m_log,         m_settings,
                m_ticker,     m_fileDialogs,    &m_audit, &m_marks, &m_references, &m_timeoutWatch}
    , m_recordings(
          m_context,
          {{QString::fromLatin1(recordingfact::kProgram), u"trexpanel"_s},
           {QString::fromLatin1(recordingfact::kProgramVersion), QString::fromLatin1(kVersion)}})
    , m_recordingFiles(m_context)
{
    m_patience.setSingleShot(true);
    connect(&m_patience, &QTimer::timeout, this, &Program::finish);
    connect(&m_controller, &Controller::stateChanged, this, &Program::onStateChanged);
    connect(&m_recordingFiles, &RecordingFiles::failed, this, [this](const QString& sentence) {
        m_log.add(EventLog::Failure, sentence);
        m_window->bringForward(u"log"_s);
    });
    logEvents();
    limitHistory();
}

Program::~Program() = default;

void Program::logEvents()
{
    connect(&m_controller, &Controller::eventLogged, &m_log, &EventLog::add);
    connect(&m_audit, &WriteAudit::told, &m_log, &EventLog::add);
    m_audit.resolveWhenConnected();
    if (m_file.problem()) {
        m_log.add(EventLog::Warning, m_file.problemText());
    }
    logWire(m_controller, m_options.verbosity);
}

/// The oldest samples leave the memory beyond the ceiling that the person has set; told once.
void Program::limitHistory()
{
    const auto apply = [this] {
        const int mib =
            std::max(m_settings.value(settings::kHistoryMiB), settings::kLeastHistoryMiB);
        m_store.setMemoryLimit(std::size_t(mib) << 20U);
    };
    apply();
    connect(&m_settings, &UiSettings::changed, this, [apply](const QString& key) {
        if (key == settings::kHistoryMiB.key) {
            apply();
        }
    });
    connect(&m_controller, &Controller::batchArrived, this, [this] {
        if (m_store.hasDropped() && !std::exchange(m_isDropTold, true)) {
            m_log.add(EventLog::Warning,
                      tr("The memory for the history of this session (%1 MiB) is full. From now on "
                         "its oldest part is only in a recording, if one runs.")
                          .arg(m_store.memoryLimit() >> 20U));
        }
    });
}

Result<void> Program::prepareScript()
{
    m_metrics = std::make_unique<Metrics>(m_controller, m_ticker);
    if (!m_options.plays()) {
        return {};
    }
    Result<Script> script =
        readScript(m_options.script.isEmpty() ? QString(kDemonstration) : m_options.script);
    if (!script) {
        return tl::make_unexpected(script.error());
    }
    const QString folder =
        m_options.screenshots.isEmpty() ? QString(kPictures) : m_options.screenshots;
    m_player = std::make_unique<ScriptPlayer>(std::move(*script), m_fileDialogs, folder);
    connect(m_player.get(), &ScriptPlayer::finished, this, &Program::quit);
    return {};
}

/// An empty port: the person chooses.
Result<OpenOptions> Program::lineAtStart()
{
    if (m_options.simulate) {
        return toLineSettings(m_options.line).map([](const LineSettings& line) {
            return OpenOptions{.port = simulatorAddress(), .line = line};
        });
    }
    if (m_options.line.any()) {
        return toOpenOptions(m_options.line, m_file);
    }
    return OpenOptions{};
}

Result<void> Program::start()
{
    if (const auto problem = m_file.problem();
        problem && problem->code == ErrorCode::FileUnreadable && !m_options.settings.isEmpty()) {
        return tl::make_unexpected(*problem);
    }
    const Result<OpenOptions> line = lineAtStart();
    if (!line) {
        return tl::make_unexpected(line.error());
    }
    if (!m_options.recording.isEmpty()) { // what is wrong with it is told before anything is shown
        if (const auto readable = RecordingReader::open(m_options.recording); !readable) {
            return tl::make_unexpected(readable.error());
        }
    }
    if (const Result<void> script = prepareScript(); !script) {
        return script;
    }
    m_languages.use(m_options.language.isEmpty() ? m_settings.value(settings::kLanguage)
                                                 : m_options.language);
    m_theme = m_options.theme.isEmpty() ? m_settings.value(settings::kTheme) : m_options.theme;
    theme::apply(choiceOf(m_theme));
    makeWindow();
    connect(m_window.get(), &MainWindow::firstFramePainted, this, [this] {
        m_metrics->firstFramePainted();
        if (m_player) {
            m_player->start();
        }
    });
    if (!m_options.recording.isEmpty()) {
        m_recordingFiles.openOrTell(m_options.recording);
    }
    if (!line->port.isEmpty()) {
        m_window->bringForward(u"status"_s);
        m_controller.open(*line);
    }
    return {};
}

void Program::makeWindow()
{
    m_window = std::make_unique<MainWindow>(m_context, m_recordings, m_theme, m_languages.inUse());
    connect(m_window.get(), &MainWindow::closeRequested, this, &Program::quit);
    connect(m_window.get(), &MainWindow::themeChosen, this, &Program::chooseTheme);
    connect(m_window.get(), &MainWindow::languageChosen, this, &Program::chooseLanguage);
    connect(m_window.get(), &MainWindow::recordingChosen, &m_recordingFiles,
            &RecordingFiles::openOrTell);
    connect(m_window.get(), &MainWindow::comparisonChosen, this,
            [this](const QString& path) { m_recordingFiles.compare(path, m_references); });
    m_window->show();
}

void Program::chooseTheme(const QString& key)
{
    m_theme = key;
    m_settings.set(settings::kTheme, key);
    theme::apply(choiceOf(key));
}

/// The window is built anew over the same connection. Sliders of the new one stand at zero, so the
/// motors are stopped before.
void Program::chooseLanguage(const QString& code)
{
    m_settings.set(settings::kLanguage, code);
    if (code == m_languages.inUse()) {
        return;
    }
    m_controller.disarm(DisarmReason::LanguageSwitch);
    m_window->saveLayout();
    m_window->hide();
    m_window.release()->deleteLater(); // one of its menus is still calling
    m_languages.use(code);
    makeWindow();
}

void Program::onStateChanged(LinkState state)
{
    if (state == LinkState::Connected && !m_options.simulate) {
        LineSettingsStore(m_file).remember(m_controller.options().port,
                                           m_controller.options().line);
    }
}

void Program::quit()
{
    if (m_isQuitting) {
        return;
    }
    m_isQuitting = true;
    m_window->saveLayout();
    if (m_controller.state() == LinkState::Disconnected) {
        QMetaObject::invokeMethod(this, &Program::finish, Qt::QueuedConnection);
        return;
    }
    connect(&m_controller, &Controller::closed, this, &Program::finish);
    m_patience.start(kPatience);
    m_controller.close();
}

void Program::suspend()
{
#ifdef SIGSTOP
    if (m_controller.gate().isArmed()) {
        m_controller.stop(Controller::StopKind::Coast, this,
                          [](const Result<Reply>& /*sent*/) { std::raise(SIGSTOP); });
    } else {
        std::raise(SIGSTOP);
    }
#endif
}

void Program::finish()
{
    m_patience.stop();
    disconnect(&m_controller, &Controller::closed, this, &Program::finish);
    if (!m_file.sync()) {
        printMessage(u"trexpanel: "_s + m_file.problemText());
    }
    int exitCode = 0;
    if (m_player) {
        exitCode = m_player->isPassed() ? 0 : kStepFailed;
        if (!m_player->isPassed()) {
            const StepRecord& last = m_player->records().back();
            printMessage(u"trexpanel: step %1 (%2) failed: %3"_s.arg(last.index)
                             .arg(last.action, last.message));
        }
        if (m_options.playsDemonstration()) {
            printPictures();
        }
        if (!m_options.report.isEmpty()) {
            const Result<void> written =
                writeReport(m_options.report, reportOf(*m_player, *m_metrics));
            if (!written) {
                printMessage(u"trexpanel: "_s + errorText(written.error()));
                exitCode = exitCode == 0 ? kUnwritable : exitCode;
            }
        }
    }
    m_recordingFiles.closeAll();
    m_window->hide();
    QCoreApplication::exit(exitCode);
}

void Program::printPictures() const
{
    const QDir folder(m_player->screenshotFolder());
    const QStringList files = folder.entryList(QDir::Files, QDir::Name);
    std::printf("%s\n",
                qUtf8Printable(tr("The demonstration wrote to %1:").arg(folder.absolutePath())));
    for (const QString& file : files) {
        std::printf("  %s\n", qUtf8Printable(file));
    }
    std::fflush(stdout);
}

} // namespace trex
