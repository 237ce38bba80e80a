// SPDX-License-Identifier: GPL-3.0-or-later
#include "protocol/session/devicesettings.h"

#include "protocol/codec/replies.h"

#include <QCoreApplication>

namespace trex {

namespace {

using namespace Qt::Literals::StringLiterals;

/// Says what was asked; who did not answer is the controller.
tl::unexpected<Error> lossOf(const Error& error, const QString& what)
{
    return fail(error.code,
                error.code == ErrorCode::NoReply
                    ? DeviceSettings::tr("the controller (%1)").arg(what)
                    : what);
}

} // namespace

DeviceSettings::DeviceSettings(Controller& controller, QObject* parent)
    : QObject(parent), m_controller(controller)
{
    connect(&controller, &Controller::stateChanged, this, [this](LinkState state) {
        if (state != LinkState::Connected) {
            forget();
        }
    });
    connect(&controller, &Controller::restarted, this, [this] {
        m_inForce.clear();
        emit forgotten();
    });
    // What waited for a power cycle, and is seen to be in force, proves that there was one.
    connect(this, &DeviceSettings::parameterChanged, this, [this](int number) {
        const auto which = static_cast<std::uint8_t>(number);
        const auto before = m_inForce.find(which);
        const auto stored = parameter(which);
        if (before != m_inForce.end() && stored && *stored != before->second
            && evidenceInForce(which) == stored) {
            m_inForce.clear();
            m_controller.noteRestart(
                tr("%1 has its new value in force, which only a power cycle brings about")
                    .arg(QCoreApplication::translate("Parameters", findParameter(number)->title)));
        }
    });
}

void DeviceSettings::forget()
{
    if (!m_parameters.empty() || !m_calibrations.empty()) {
        m_parameters.clear();
        m_calibrations.clear();
        emit forgotten();
    }
}

std::optional<int> DeviceSettings::parameter(std::uint8_t number) const
{
    const auto found = m_parameters.find(number);
    return found == m_parameters.end() ? std::nullopt : std::optional(found->second);
}

std::optional<Calibration> DeviceSettings::calibration(InputKind input, int channel) const
{
    const auto found = m_calibrations.find({input, channel});
    return found == m_calibrations.end() ? std::nullopt : std::optional(found->second);
}

/// What the line itself shows to be in force, whatever is stored.
std::optional<int> DeviceSettings::evidenceInForce(std::uint8_t number) const
{
    const OpenOptions& options = m_controller.options();
    const auto& mode = m_controller.device().mode;
    if (number == parameterRow("uart-settings").number && !options.port.startsWith("tcp:"_L1)
        && options.line.baud > 0) {
        return UartSettings{baudIndex(options.line.baud), options.line.errorDetection,
                            options.line.stopBits}
            .toRaw();
    }
    if (number == parameterRow("crc7-polynomial").number && options.line.hasCrc()) {
        return options.line.polynomial & 0x7F;
    }
    if (number == parameterRow("channel-input-source").number && mode && isSerial(*mode)) {
        return inputOf(*mode) == InputKind::Analog ? 1 : 0;
    }
    return std::nullopt;
}

bool DeviceSettings::isPending(std::uint8_t number) const
{
    const auto stored = parameter(number);
    const ParameterRow* row = findParameter(int{number});
    if (!stored || row == nullptr || !row->needsReset) {
        return false;
    }
    if (const auto inForce = evidenceInForce(number)) {
        return *inForce != *stored;
    }
    const auto before = m_inForce.find(number);
    return before != m_inForce.end() && before->second != *stored;
}

void DeviceSettings::show(const std::map<std::uint8_t, int>& parameters,
                          const Calibrations& calibrations)
{
    m_parameters = parameters;
    m_calibrations.clear();
    for (const auto& [input, channels] : calibrations) {
        for (const auto& [channel, calibration] : channels) {
            m_calibrations[{input, channel}] = calibration;
        }
    }
    emit forgotten(); // what is no longer known, and what is
    for (const auto& [number, raw] : m_parameters) {
        emit parameterChanged(number);
    }
    for (const auto& [key, calibration] : m_calibrations) {
        emit calibrationChanged(key.first, key.second);
    }
}

void DeviceSettings::store(const ParameterRow& row, int raw)
{
    m_parameters[row.number] = raw;
    emit parameterChanged(row.number);
}

void DeviceSettings::readParameter(const ParameterRow& row, QObject* context,
                                   const Handler<int>& handler)
{
    if (row.isTrigger) {
        handler(fail(ErrorCode::BadParameterNumber, QString::fromLatin1(row.key)));
        return;
    }
    if (m_controller.isRecording()) {
        const auto known = parameter(row.number);
        handler(known ? Result<int>(*known)
                      : fail(ErrorCode::IsRecording, QString::fromLatin1(row.key)));
        return;
    }
    m_controller.request(trex::readParameter(row.number), context,
                         [this, &row, handler](const Result<Reply>& reply) {
                             if (!reply) {
                                 handler(lossOf(reply.error(), QString::fromLatin1(row.key)));
                                 return;
                             }
                             const int raw = static_cast<std::uint8_t>(reply->payload.front());
                             store(row, raw);
                             handler(raw);
                         });
}

template <class T>
void DeviceSettings::settle(const Result<T>& read, const std::optional<T>& expected,
                            QObject* context, const Handler<T>& handler,
                            const std::function<void(const T&)>& again)
{
    if (!read || expected == *read || m_controller.options().line.hasCrc()) {
        handler(read);
        return;
    }
    // The query may have been taken for one with a longer reply, whose next byte would pass for the
    // second answer: the mode's letter cannot be mistaken for it.
    m_controller.request(query("get-mode"), context,
                         [again, seen = *read](const Result<Reply>&) { again(seen); });
}

void DeviceSettings::readSurely(const ParameterRow& row, const std::optional<int>& expected,
                                QObject* context, const Handler<int>& handler)
{
    readParameter(row, context, [=, this, &row](const Result<int>& read) {
        settle<int>(read, expected, context, handler,
                    [=, this, &row](int seen) { readSurely(row, seen, context, handler); });
    });
}

void DeviceSettings::readSurely(int channel, const std::optional<Calibration>& expected,
                                QObject* context, const Handler<Calibration>& handler)
{
    readCalibration(channel, context, [=, this](const Result<Calibration>& read) {
        settle<Calibration>(read, expected, context, handler, [=, this](const Calibration& seen) {
            readSurely(channel, seen, context, handler);
        });
    });
}

void DeviceSettings::readCalibration(int channel, QObject* context,
                                     const Handler<Calibration>& handler)
{
    m_controller.request(
        trex::readCalibration(channel), context,
        [this, channel, handler](const Result<Reply>& reply) {
            if (!reply) {
                handler(lossOf(reply.error(), tr("calibration of channel %1").arg(channel)));
                return;
            }
            const Calibration calibration = parseCalibration(reply->payload);
            if (const auto mode = m_controller.device().mode) {
                m_calibrations[{inputOf(*mode), channel}] = calibration;
                emit calibrationChanged(inputOf(*mode), channel);
            }
            handler(calibration);
        });
}

void DeviceSettings::readAll(QObject* context, const std::function<void(int, int)>& progress,
                             const Handler<void>& handler)
{
    if (m_controller.isRecording()) { // what was known then is shown already
        QMetaObject::invokeMethod(
            context, [handler] { handler({}); }, Qt::QueuedConnection);
        return;
    }
    // The mode says which set the calibrations belong to.
    m_controller.request(query("get-mode"), context, [=, this](const Result<Reply>& reply) {
        if (!reply) {
            handler(tl::make_unexpected(reply.error()));
            return;
        }
        readNext(0, context, progress, handler);
    });
}

void DeviceSettings::readNext(std::size_t index, QObject* context,
                              const std::function<void(int, int)>& progress,
                              const Handler<void>& handler)
{
    const std::size_t parameters = kParameters.size() - 1; // the last one is the reset trigger
    const std::size_t total = parameters + kChannelCount;
    if (progress) {
        progress(static_cast<int>(index), static_cast<int>(total));
    }
    const auto onward = [=, this](const std::optional<Error>& error) {
        if (error) {
            handler(tl::make_unexpected(*error));
        } else {
            readNext(index + 1, context, progress, handler);
        }
    };
    if (index == total) {
        handler({});
    } else if (index < parameters) {
        const ParameterRow& row = kParameters.at(index);
        readParameter(row, context, [=, this, &row](const Result<int>& raw) {
            // Firmware before 1.2 has no 0x17 (facts.md 2) and does not answer; that is no failure.
            const auto& signature = m_controller.device().signature;
            const bool old = signature && signature->major == 1 && signature->minor < 2;
            const bool mayLack = old && row.number == parameterRow("uart-response-delay").number;
            onward(raw || mayLack ? std::nullopt : std::optional(raw.error()));
        });
    } else {
        readCalibration(static_cast<int>(index - parameters) + 1, context,
                        [onward](const Result<Calibration>& calibration) {
                            onward(calibration ? std::nullopt : std::optional(calibration.error()));
                        });
    }
}

} // namespace trex
