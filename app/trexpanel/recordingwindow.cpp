// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/trexpanel/recordingwindow.h"

#include "app/trexpanel/linkstatusbar.h"
#include "app/trexpanel/menus.h"
#include "app/trexpanel/paneldocks.h"
#include "protocol/errortext.h"
#include "protocol/procedures/recordingmarks.h"
#include "protocol/storage/recordingcsv.h"
#include "widgets/common/filedialogs.h"
#include "widgets/common/stopbutton.h"
#include "widgets/common/theme.h"
#include "widgets/recording/playbar.h"
#include "widgets/recording/recordingmenu.h"

#include <QCloseEvent>
#include <QDir>
#include <QDockWidget>
#include <QFileInfo>
#include <QLabel>
#include <QMenuBar>
#include <QMimeData>
#include <QPainter>
#include <QStatusBar>
#include <QToolBar>
#include <QVBoxLayout>

namespace trex {

using namespace Qt::Literals::StringLiterals;

namespace {

constexpr std::chrono::seconds kMessageShown{15};

/// A band in a colour that nothing live has, with a hatched edge. Painted: a style sheet would have
/// the last word on a palette.
class Banner : public QWidget {
public:
    using QWidget::QWidget;

protected:
    void paintEvent(QPaintEvent* /*event*/) override
    {
        constexpr int kEdge = 8;
        QPainter painter(this);
        painter.fillRect(rect(), theme::colour(ColourRole::Warning));
        painter.fillRect(0, 0, kEdge, height(),
                         QBrush(theme::colour(ColourRole::Panel), Qt::BDiagPattern));
    }
};

} // namespace

RecordingWindow::RecordingWindow(PanelContext& live, std::unique_ptr<RecordingReader> reader,
                                 const QString& path)
    : m_live(live)
    , m_controller(&m_store, nullptr)
    , m_settings(m_controller)
    , m_context{m_controller, m_settings,       m_store, m_latch,  m_log,        live.settings,
                live.ticker,  live.fileDialogs, nullptr, &m_marks, &m_references}
{
    m_controller.becomeRecording();
    m_player = std::make_unique<RecordingPlayer>(
        std::move(reader), RecordingStage{m_controller, m_settings, m_store, m_latch});
    setObjectName(u"recordingWindow"_s);
    setWindowTitle(tr("Recording of %1 – %2").arg(dateText(), QFileInfo(path).fileName()));
    setAcceptDrops(true);
    makeTop(path);
    m_docks =
        new PanelDocks(*this, m_context, [](const PanelRow& row) { return row.inRecordings; });
    makeMenus();
    connectPlayer();
    m_docks->restore({}, {});
    m_player->loader().start();
}

RecordingWindow::~RecordingWindow()
{
    qDeleteAll(findChildren<QDockWidget*>()); // the panels, before what they look at
}

QString RecordingWindow::dateText() const
{
    const QDateTime started = m_player->reader().started().toLocalTime();
    return started.isValid() ? started.toString(u"yyyy-MM-dd HH:mm:ss"_s) : tr("an unknown date");
}

QWidget* RecordingWindow::makeBanner(const QString& path)
{
    auto* banner = named(new Banner(this), u"recording.banner"_s);
    auto* title = named(new QLabel(tr("Recording of %1").arg(dateText()), banner),
                        u"recording.title"_s, tr("This window shows a recording"));
    title->setFont(theme::font(1.25));
    QFont bold = title->font();
    bold.setBold(true);
    title->setFont(bold);
    const RecordingReader& reader = m_player->reader();
    QStringList parts{tr("not live: nothing here reaches a controller"),
                      QFileInfo(path).fileName()};
    if (const QString signature = reader.fact(recordingfact::kSignature); !signature.isEmpty()) {
        parts << signature.left(40);
    }
    auto* details = named(new QLabel(parts.join(u" · "_s), banner), u"recording.details"_s);
    details->setTextFormat(Qt::PlainText);
    details->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Preferred);
    details->setToolTip(QDir::toNativeSeparators(path));
    for (QLabel* label : {title, details}) {
        theme::setTextColour(*label, ColourRole::Panel);
        label->setForegroundRole(QPalette::WindowText); // a tool bar's are those of buttons
    }
    auto* stop = named(new StopButton(m_live.controller, banner), u"recording.stop"_s,
                       tr("Stop all motors"));
    stop->setToolTip(tr("Stops the motors of the controller that is connected now."));
    auto* row = new QHBoxLayout(banner);
    row->setContentsMargins(20, 4, 8, 4);
    row->setSpacing(16);
    row->addWidget(title);
    row->addWidget(details, 1);
    row->addWidget(stop);
    return banner;
}

void RecordingWindow::makeTop(const QString& path)
{
    auto* top = new QWidget(this);
    auto* layout = new QVBoxLayout(top);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(0);
    layout->addWidget(makeBanner(path));
    m_playBar = new PlayBar(*m_player, m_live.ticker, top);
    layout->addWidget(m_playBar);
    auto* bar = named(new QToolBar(tr("Recording"), this), u"recording.toolbar"_s);
    bar->setMovable(false);
    bar->toggleViewAction()->setVisible(false);
    bar->layout()->setContentsMargins(0, 0, 0, 0);
    top->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
    bar->addWidget(top);
    addToolBar(bar);
    setStatusBar(named(new LinkStatusBar(m_context, this), u"recording.status"_s));
    m_message = named(new QLabel(this), u"recording.message"_s, tr("Message"));
    m_message->setTextFormat(Qt::PlainText);
    theme::setTextColour(*m_message, ColourRole::Warning);
    statusBar()->addPermanentWidget(m_message);
    m_messageTime.setSingleShot(true);
    connect(&m_messageTime, &QTimer::timeout, m_message, &QLabel::clear);
    if (const QString remark = m_player->reader().remark(); !remark.isEmpty()) {
        auto* label = named(new QLabel(u"▲ "_s + remark, this), u"recording.remark"_s);
        label->setTextFormat(Qt::PlainText);
        theme::setTextColour(*label, ColourRole::Warning);
        statusBar()->addPermanentWidget(label);
    }
}

void RecordingWindow::makeMenus()
{
    QMenu* file = menuBar()->addMenu(tr("&File"));
    addEntry(*file, u"recording.open"_s, tr("&Open recording…"), u"load"_s, [this] {
        askOpen(tr("Open a recording"), &RecordingWindow::recordingChosen);
    })->setShortcut(QKeySequence::Open);
    addEntry(*file, u"recording.compare"_s, tr("&Compare with recording…"), u"currents"_s, [this] {
        askOpen(tr("Compare with a recording"), &RecordingWindow::comparisonChosen);
    });
    addEntry(*file, u"recording.export"_s, tr("&Export all samples…"), u"export"_s, [this] {
        m_context.fileDialogs.askSave(this, tr("Export all samples"), u"recording.csv"_s,
                                      tr("CSV (*.csv)"),
                                      [this](const QString& path) { exportCsv(path); });
    });
    file->addSeparator();
    addEntry(*file, u"recording.close"_s, tr("C&lose"), u"cancel"_s, [this] {
        close();
    })->setShortcut(QKeySequence::Close);
    QMenu* play = menuBar()->addMenu(tr("&Play"));
    play->addActions(m_playBar->actionsForMenu());
    QMenu* view = menuBar()->addMenu(tr("&View"));
    m_docks->addToMenu(*view);
    view->addSeparator();
    addEntry(*view, u"recording.resetLayout"_s, tr("Put all panels back"), u"window"_s,
             [this] { m_docks->applyDefaultLayout(); });
}

void RecordingWindow::askOpen(const QString& title, void (RecordingWindow::*chosen)(const QString&))
{
    m_context.fileDialogs.askOpen(
        this, title, recordingFilter(),
        [this, chosen](const QString& path) { emit(this->*chosen)(path); });
}

void RecordingWindow::connectPlayer()
{
    connect(m_player.get(), &RecordingPlayer::eventsPassed, this, &RecordingWindow::tellEvents);
    connect(&m_player->loader(), &RecordingLoader::finished, this,
            [this] { fillMarks(m_marks, m_player->history(), m_store); });
    // Whoever means the motors means those that run now.
    connect(&m_controller, &Controller::lockedOut, &m_live.controller,
            [&controller = m_live.controller] { controller.stop(); });
    connect(&m_controller, &Controller::eventLogged, &m_log, &EventLog::add);
    // What a panel says here is no part of the recording, and is told beside it, too.
    connect(&m_log, &QAbstractItemModel::rowsInserted, this,
            [this](const QModelIndex&, int, int last) {
                if (!m_isTelling) {
                    m_message->setText(m_log.at(last).text);
                    m_messageTime.start(kMessageShown);
                }
            });
}

void RecordingWindow::tellEvents(std::size_t begin, std::size_t end, bool isAnew)
{
    m_isTelling = true;
    if (isAnew) {
        m_log.clear();
    }
    constexpr qint64 kTicksPerMs = std::chrono::milliseconds(1) / TimeAxis::kTick;
    const QDateTime started = m_player->reader().started().toLocalTime();
    for (std::size_t i = begin; i < end; ++i) {
        const RecordedEvent& event = m_player->history().events()[i];
        if (event.kind == u"log"_s) {
            m_log.addEntry({.time = started.addMSecs(event.tick / kTicksPerMs),
                            .severity = event.severity,
                            .text = event.text});
        }
    }
    m_isTelling = false;
}

void RecordingWindow::exportCsv(const QString& path)
{
    const RecordingReader& reader = m_player->reader();
    CsvOptions options{.model = reader.model(), .input = reader.input()};
    options.polls.fill(true);
    const auto rows = exportSamplesCsv(path, m_store, options);
    if (rows) {
        m_log.add(EventLog::Information,
                  tr("%n row(s) exported to %1.", nullptr, static_cast<int>(*rows))
                      .arg(QDir::toNativeSeparators(path)));
    } else {
        m_log.add(EventLog::Failure, errorText(rows.error()));
    }
}

void RecordingWindow::closeEvent(QCloseEvent* event)
{
    m_player->pause();
    event->accept();
    emit closed();
}

QMenu* RecordingWindow::createPopupMenu()
{
    return nullptr;
}

void RecordingWindow::dragEnterEvent(QDragEnterEvent* event)
{
    if (!filesIn(*event->mimeData()).isEmpty()) {
        event->acceptProposedAction();
    }
}

void RecordingWindow::dropEvent(QDropEvent* event)
{
    for (const QString& path : filesIn(*event->mimeData())) {
        emit recordingChosen(path);
    }
    event->acceptProposedAction();
}

} // namespace trex
