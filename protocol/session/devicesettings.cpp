// SPDX-License-Identifier: GPL-3.0-or-later
#include "protocol/session/devicesettings.h"

#include "protocol/codec/replies.h"

#include <algorithm>

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

bool isRefusal(ErrorCode code)
{
    return code == ErrorCode::BadParameterNumber || code == ErrorCode::BadValue
        || code == ErrorCode::NotInSerialMode || code == ErrorCode::UnknownAnswer;
}

QString calibrationText(const Calibration& c)
{
    return u"%1 / %2 / %3 / %4"_s.arg(c.minimum).arg(c.neutral).arg(c.maximum).arg(c.deadband);
}

/// Every field as a controller stores it that joins the halves as low + 256 × high (C-35).
int eightBitReading(int value)
{
    return (value & 0x7F) + 256 * (value >> 7);
}

Calibration eightBitReading(const Calibration& c)
{
    return {eightBitReading(c.minimum), eightBitReading(c.neutral), eightBitReading(c.maximum),
            eightBitReading(c.deadband)};
}

/// The value to send so that such a controller stores the nearest one that can be sent that way:
/// its low byte has seven bits.
int forEightBit(int wanted)
{
    int low = wanted & 0xFF;
    int high = wanted >> 8;
    if (low > 0x7F) { // 128 to 255: down to 127, or up to the next multiple of 256
        const bool up = low >= 192;
        low = up ? 0 : 0x7F;
        high += up ? 1 : 0;
    }
    return std::min(low + (high << 7), kLargestCalibrationValue);
}

Calibration forEightBit(const Calibration& c)
{
    return {forEightBit(c.minimum), forEightBit(c.neutral), forEightBit(c.maximum),
            forEightBit(c.deadband)};
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

void DeviceSettings::writeParameter(const ParameterRow& row, int raw, bool verify, QObject* context,
                                    const Handler<ParameterWrite>& handler)
{
    if (row.isTrigger || !accepts(row, raw)) {
        handler(fail(ErrorCode::OutOfRange, u"%1 = %2"_s.arg(QLatin1StringView(row.key)).arg(raw)));
        return;
    }
    // Read first: the EEPROM lives about 100,000 writes, so what is there already is not written.
    readParameter(row, context, [=, this, &row](const Result<int>& before) {
        if (!before) {
            handler(tl::make_unexpected(before.error()));
        } else if (*before == raw) {
            handler(ParameterWrite{raw, raw, true});
        } else {
            sendParameter(row, raw, *before, verify, context, handler);
        }
    });
}

void DeviceSettings::sendParameter(const ParameterRow& row, int raw, int from, bool verify,
                                   QObject* context, const Handler<ParameterWrite>& handler)
{
    const QString key = QString::fromLatin1(row.key);
    const Command command = trex::writeParameter(row.number, static_cast<std::uint8_t>(raw));
    m_controller.request(command, context, [=, this, &row](const Result<Reply>& reply) {
        const Result<void> answer =
            reply ? parseAnswer(reply->payload) : tl::make_unexpected(reply.error());
        if (!answer && isRefusal(answer.error().code)) {
            handler(fail(answer.error().code, key));
            return;
        }
        if (answer && row.needsReset) {
            m_inForce.try_emplace(row.number, from);
        }
        if (answer && !verify) {
            m_parameters.erase(row.number); // answered "done", but not seen
            handler(ParameterWrite{from, raw, false});
            return;
        }
        verifyParameter(row, raw, from, answer ? std::nullopt : std::optional(answer.error()),
                        context, handler);
    });
}

void DeviceSettings::verifyParameter(const ParameterRow& row, int raw, int from,
                                     const std::optional<Error>& lost, QObject* context,
                                     const Handler<ParameterWrite>& handler)
{
    readParameter(row, context, [=, this, &row](const Result<int>& now) {
        const QString key = QString::fromLatin1(row.key);
        if (!now) {
            handler(tl::make_unexpected(now.error()));
        } else if (*now == raw) {
            if (row.needsReset) {
                m_inForce.try_emplace(row.number, from);
            }
            handler(ParameterWrite{from, raw, true});
        } else if (lost) {
            explainSilence(
                {lost->code == ErrorCode::NoReply ? ErrorCode::NotTrusted : lost->code, key},
                context, [handler](const Error& error) { handler(tl::make_unexpected(error)); });
        } else {
            handler(fail(ErrorCode::ReadBackDiffers,
                         tr("%1: wrote %2, read back %3").arg(key).arg(raw).arg(*now)));
        }
    });
}

void DeviceSettings::explainSilence(const Error& error, QObject* context,
                                    const std::function<void(Error)>& then)
{
    m_controller.request(
        query("get-uart-errors"), context, [error, then](const Result<Reply>& reply) {
            Error explained = error;
            if (reply) {
                explained.context += u" ("_s + describeReply(reply->command, reply->payload) + u')';
            }
            then(explained);
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

void DeviceSettings::writeCalibration(int channel, const Calibration& calibration, QObject* context,
                                      const Handler<CalibrationWrite>& handler)
{
    const Command command = trex::writeCalibration(channel, calibration);
    const bool ordered = calibration.minimum <= calibration.neutral
        && calibration.neutral <= calibration.maximum && calibration.minimum < calibration.maximum;
    if (!ordered || !validate(command)) {
        handler(fail(
            ErrorCode::OutOfRange,
            tr("calibration of channel %1: %2").arg(channel).arg(calibrationText(calibration))));
        return;
    }
    readCalibration(channel, context, [=, this](const Result<Calibration>& before) {
        if (!before) {
            handler(tl::make_unexpected(before.error()));
        } else if (*before == calibration) {
            handler(CalibrationWrite{calibration, true, false});
        } else {
            sendCalibration(channel, calibration, calibration, context, handler);
        }
    });
}

void DeviceSettings::sendCalibration(int channel, const Calibration& wanted,
                                     const Calibration& sent, QObject* context,
                                     const Handler<CalibrationWrite>& handler)
{
    const Command command = trex::writeCalibration(channel, sent);
    m_controller.request(command, context, [=, this](const Result<Reply>& reply) {
        const Result<void> answer =
            reply ? parseAnswer(reply->payload) : tl::make_unexpected(reply.error());
        if (!answer && isRefusal(answer.error().code)) {
            handler(fail(answer.error().code, tr("calibration of channel %1").arg(channel)));
            return;
        }
        verifyCalibration(channel, wanted, sent,
                          answer ? std::nullopt : std::optional(answer.error()), context, handler);
    });
}

void DeviceSettings::verifyCalibration(int channel, const Calibration& wanted,
                                       const Calibration& sent, const std::optional<Error>& lost,
                                       QObject* context, const Handler<CalibrationWrite>& handler)
{
    readCalibration(channel, context, [=, this](const Result<Calibration>& now) {
        const QString what = tr("calibration of channel %1").arg(channel);
        const bool firstTry = sent == wanted;
        if (!now) {
            handler(tl::make_unexpected(now.error()));
        } else if (*now == wanted) {
            handler(CalibrationWrite{*now, true, !firstTry});
        } else if (firstTry && *now == eightBitReading(sent)) {
            // The other reading of the byte pairs (C-35): send what that controller stores nearest.
            sendCalibration(channel, wanted, forEightBit(wanted), context, handler);
        } else if (!firstTry && *now == eightBitReading(sent)) {
            handler(CalibrationWrite{*now, false, true});
        } else if (lost) {
            explainSilence(
                {lost->code == ErrorCode::NoReply ? ErrorCode::NotTrusted : lost->code, what},
                context, [handler](const Error& error) { handler(tl::make_unexpected(error)); });
        } else {
            handler(fail(ErrorCode::ReadBackDiffers,
                         tr("%1: wrote %2, read back %3")
                             .arg(what, calibrationText(wanted), calibrationText(*now))));
        }
    });
}

void DeviceSettings::readAll(QObject* context, const std::function<void(int, int)>& progress,
                             const Handler<void>& handler)
{
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

void DeviceSettings::factoryReset(QObject* context, const Handler<void>& handler)
{
    const std::uint8_t number = parameterRow("factory-reset").number;
    m_controller.request(trex::writeParameter(number, kFactoryResetValue), context,
                         [this, handler](const Result<Reply>& reply) {
                             const Result<void> answer = reply ? parseAnswer(reply->payload)
                                                               : tl::make_unexpected(reply.error());
                             if (answer) {
                                 for (const auto& [known, raw] : m_parameters) {
                                     m_inForce.try_emplace(known, raw);
                                 }
                                 forget(); // what was read before may be old now
                             }
                             handler(answer);
                         });
}

} // namespace trex
