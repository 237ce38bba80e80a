// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/recording/recordings.h"

#include "protocol/errortext.h"
#include "protocol/procedures/configtransfer.h"
#include "protocol/session/devicesettings.h"
#include "protocol/storage/datafolder.h"
#include "protocol/telemetry/marktrack.h"
#include "widgets/common/eventlog.h"
#include "widgets/common/uisettings.h"

#include <QDir>
#include <QLocale>
#include <QStandardPaths>

namespace trex {

using namespace Qt::Literals::StringLiterals;
using namespace std::chrono_literals;

namespace {

constexpr auto kSettled = 300ms;
constexpr int kJointMode = 1; // parameter 0x7B (facts.md 2)
constexpr ParameterRow kMotorMode = parameterRow("motor-mode");

SampleTap::Wanted allPolls()
{
    SampleTap::Wanted all;
    all.fill(true);
    return all;
}

QString shown(const QString& path)
{
    return QDir::toNativeSeparators(path);
}

/// "" for those that somebody asked for.
QString reasonText(const QString& reason)
{
    return reason == u"fault"_s ? Recordings::tr("there was a fault")
        : reason == u"stop"_s   ? Recordings::tr("the motors were stopped while armed")
        : reason == u"loss"_s   ? Recordings::tr("the link was lost")
                                : QString();
}

} // namespace

QString recordingTimeText(std::chrono::milliseconds length)
{
    const auto seconds = std::chrono::duration_cast<std::chrono::seconds>(length).count();
    return u"%1:%2:%3"_s.arg(seconds / 3600, 2, 10, '0'_L1)
        .arg(seconds / 60 % 60, 2, 10, '0'_L1)
        .arg(seconds % 60, 2, 10, '0'_L1);
}

QString recordingSizeText(qint64 bytes)
{
    return QLocale().formattedDataSize(bytes, 1);
}

Recordings::Recordings(PanelContext& context, const RecordingFacts& program, QObject* parent)
    : QObject(parent)
    , m_context(context)
    , m_program(program)
    , m_recorder(context.controller, context.store)
    , m_flight(context.controller, context.store)
{
    m_settled.setSingleShot(true);
    m_settled.setInterval(kSettled);
    connectContext();
    connectRecorders();
    applySettings();
}

Recordings::~Recordings() = default;

void Recordings::connectContext()
{
    connect(&m_settled, &QTimer::timeout, this, &Recordings::noteSettings);
    const auto settle = [this] { m_settled.start(); };
    DeviceSettings& settings = m_context.deviceSettings;
    connect(&settings, &DeviceSettings::calibrationChanged, this, settle);
    connect(&settings, &DeviceSettings::parameterChanged, this, [this](int number) {
        m_settled.start();
        if (number == kMotorMode.number) {
            updateWishes();
        }
    });
    connect(&settings, &DeviceSettings::forgotten, this, &Recordings::updateWishes);
    connect(&m_context.settings, &UiSettings::changed, this, &Recordings::applySettings);
    connect(&m_context.controller, &Controller::batchArrived, this, &Recordings::noteMarks);
}

void Recordings::connectRecorders()
{
    EventLog& log = m_context.log;
    connect(&m_recorder, &SessionRecorder::started, this, [this, &log](const QString& path) {
        log.add(EventLog::Information, tr("Recording to %1.").arg(shown(path)));
        emit changed();
    });
    connect(&m_recorder, &SessionRecorder::finished, this, [this, &log](const QString& path) {
        log.add(EventLog::Information,
                tr("Recording ended: %n sample(s) in %1.", nullptr,
                   static_cast<int>(m_recorder.samples()))
                    .arg(shown(path)));
        emit changed();
        emit kept(path);
    });
    connect(&m_recorder, &SessionRecorder::failed, this, [this, &log](const Error& error) {
        m_problem = errorText(error);
        log.add(EventLog::Failure,
                tr("The recording has ended: %1 The file keeps what was written before.")
                    .arg(m_problem));
        updateWishes();
        emit changed();
    });
    connect(&m_flight, &FlightRecorder::frozen, this, &Recordings::onFrozen);
    connect(&m_flight, &FlightRecorder::failed, this, [&log](const Error& error) {
        log.add(EventLog::Failure,
                tr("The last minutes could not be kept: %1").arg(errorText(error)));
    });
}

QString Recordings::folder() const
{
    const QString chosen = m_context.settings.value(settings::kRecordingFolder);
    if (!chosen.isEmpty()) {
        return chosen;
    }
    // With settings of its own (--settings), a session keeps everything beside them.
    const QString data = dataFolder(m_context.settings.file().path());
    const bool isOwn =
        data.startsWith(QStandardPaths::writableLocation(QStandardPaths::GenericDataLocation));
    const QString documents = QStandardPaths::writableLocation(QStandardPaths::DocumentsLocation);
    return isOwn && !documents.isEmpty() ? documents + u"/TReX Panel"_s : data + u"/recordings"_s;
}

QString Recordings::flightFolder() const
{
    const QString chosen = m_context.settings.value(settings::kFlightFolder);
    return chosen.isEmpty() ? dataFolder(m_context.settings.file().path()) + u"/flight"_s : chosen;
}

int Recordings::flightMinutes() const
{
    return std::clamp(m_context.settings.value(settings::kFlightMinutes), 1, kMostFlightMinutes);
}

void Recordings::applySettings()
{
    const UiSettings& stored = m_context.settings;
    m_flight.setPolicy({.isEnabled = stored.value(settings::kFlightEnabled),
                        .folder = flightFolder(),
                        .before = std::chrono::minutes(flightMinutes()),
                        .facts = m_program});
}

void Recordings::start()
{
    const QString name =
        u"trex-%1.trexrec"_s.arg(QDateTime::currentDateTime().toString(u"yyyyMMdd-HHmmss"_s));
    begin({.path = QDir(folder()).filePath(name), .existing = RecorderThread::Existing::Keep});
}

void Recordings::startAs(const QString& path)
{
    begin({.path = path});
}

void Recordings::begin(const RecordingPlan& plan)
{
    m_problem.clear();
    m_noted.reset();
    RecordingPlan whole = plan;
    whole.polls = allPolls();
    whole.hasPackets = m_context.settings.value(settings::kRecordingPackets);
    whole.facts = m_program;
    m_recorder.start(whole);
    m_since.start();
    updateWishes();
    noteSettings();
    // What no panel has asked for yet; each value that comes is noted.
    const bool isConnected = m_context.controller.state() == LinkState::Connected;
    if (isConnected
        && !isComplete(presentConfiguration(m_context.controller, m_context.deviceSettings))) {
        m_context.deviceSettings.readAll(this, {}, [](const Result<void>&) {});
    }
    emit changed();
}

void Recordings::stop()
{
    m_recorder.stop();
    updateWishes();
    emit changed();
}

void Recordings::keepLastMinutes()
{
    noteSettings();
    m_flight.keepNow(u"kept"_s);
}

std::chrono::milliseconds Recordings::length() const
{
    return std::chrono::milliseconds(isRecording() ? m_since.elapsed() : 0);
}

bool Recordings::isJoint() const
{
    // The value read is the stored one; when it waits for a power cycle, the other is in force.
    const auto mode = m_context.deviceSettings.parameter(kMotorMode.number);
    return mode && (*mode == kJointMode) != m_context.deviceSettings.isPending(kMotorMode.number);
}

/// A recording has every stream, whatever panels are open. In joint mode there are no currents
/// (conformance C-31).
void Recordings::updateWishes()
{
    Controller& controller = m_context.controller;
    if (!isRecording()) {
        controller.wantNothing(this);
        return;
    }
    for (const PollId poll : {PollId::Currents, PollId::RawChannels, PollId::RemappedChannels}) {
        const bool isAbsent = poll == PollId::Currents && isJoint();
        controller.want(this, poll, isAbsent ? 0.0 : pollRow(poll).hertz);
    }
}

/// They are put down now, so that a new one is among the last.
void Recordings::noteMarks()
{
    if (m_context.marks == nullptr) {
        return;
    }
    const auto& marks = m_context.marks->marks();
    for (std::size_t i = std::min(m_marks, marks.size()); i < marks.size(); ++i) {
        if (isRecording() && marks[i].kind == MarkKind::Note) {
            m_recorder.addEvent({TimeAxis::ticksOf(marks[i].time), 0, u"note"_s, marks[i].text});
        }
    }
    m_marks = marks.size();
}

void Recordings::noteSettings()
{
    const Configuration known =
        presentConfiguration(m_context.controller, m_context.deviceSettings);
    if (known.parameters.empty() && known.calibrations.empty()) {
        return;
    }
    m_flight.setConfiguration(known);
    const bool isNew = !m_noted || known.parameters != m_noted->parameters
        || known.calibrations != m_noted->calibrations;
    if (isRecording() && isNew) {
        m_recorder.addConfiguration(known);
        m_noted = known;
    }
}

void Recordings::onFrozen(const QString& path, const QString& reason)
{
    const QString why = reasonText(reason);
    m_context.log.add(EventLog::Information,
                      why.isEmpty()
                          ? tr("The last minutes are kept in %1.").arg(shown(path))
                          : tr("The last minutes are kept in %1: %2.").arg(shown(path), why));
    emit kept(path);
}

} // namespace trex
