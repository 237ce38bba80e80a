// SPDX-License-Identifier: GPL-3.0-or-later
// The writing half of devicesettings.h: record, send, read back, conclude.
#include "protocol/codec/packet.h"
#include "protocol/codec/replies.h"
#include "protocol/errortext.h"
#include "protocol/session/devicesettings.h"

#include <algorithm>

namespace trex {

namespace {

using namespace Qt::Literals::StringLiterals;

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

/// Why a write was not read back. Not being connected any more must not be taken for a write that
/// was never sent.
Error lostAfterSending(const Error& readBack, const std::optional<Error>& write)
{
    if (write) {
        return *write;
    }
    const bool isGone =
        readBack.code == ErrorCode::NotConnected || readBack.code == ErrorCode::Cancelled;
    return isGone ? Error{ErrorCode::LineLost, {}} : readBack;
}

/// A write goes on when whoever asked for it is gone; only the answer then goes nowhere.
template <class T>
DeviceSettings::Handler<T> guarded(QObject* context, const DeviceSettings::Handler<T>& handler)
{
    if (context == nullptr) {
        return handler;
    }
    return [guard = QPointer(context), handler](const Result<T>& result) {
        if (guard) {
            handler(result);
        }
    };
}

} // namespace

void DeviceSettings::transmit(
    const Command& command, const WriteIntent& intent,
    const std::function<void(const Pending&, const Result<void>&)>& onward)
{
    const auto send = [=, this](const Result<void>& go) {
        Pending pending{intent, 0};
        if (go && m_controller.isArmed() && !m_controller.options().line.hasCrc()) {
            m_controller.stop(); // a damaged setting may be heard as a motor order
            emit m_controller.eventLogged(
                0,
                tr("Stopped and disarmed before a setting is written: without CRC-7 a damaged "
                   "packet could be heard as a motor order."));
        }
        pending.intent.packet = encode(command, m_controller.options().line);
        Result<qint64> number = 0;
        if (go && m_recorder != nullptr) {
            number = m_recorder->intend(pending.intent);
        }
        if (!go || !number) {
            pending.number = -1;
            onward(pending, tl::make_unexpected(go ? number.error() : go.error()));
            return;
        }
        pending.number = *number;
        m_controller.request(command, this, [pending, onward](const Result<Reply>& reply) {
            onward(pending,
                   reply ? parseAnswer(reply->payload) : tl::make_unexpected(reply.error()));
        });
    };
    if (m_recorder != nullptr) {
        m_recorder->prepare(intent.setting, send);
    } else {
        send({});
    }
}

void DeviceSettings::conclude(const Pending& pending, WriteResult result,
                              const std::optional<SettingValue>& found, const QString& detail)
{
    const WriteConclusion conclusion{result, found, detail};
    if (m_recorder != nullptr && pending.number > 0) {
        m_recorder->conclude(pending.number, conclusion);
    }
    emit writeConcluded(pending.intent, conclusion);
}

void DeviceSettings::writeParameter(const ParameterRow& row, int raw, bool verify, QObject* context,
                                    const Handler<ParameterWrite>& unguarded)
{
    const auto handler = guarded(context, unguarded);
    if (row.isTrigger || !accepts(row, raw)) {
        handler(fail(ErrorCode::OutOfRange, u"%1 = %2"_s.arg(QLatin1StringView(row.key)).arg(raw)));
        return;
    }
    // Read first: the EEPROM lives about 100,000 writes, so what is there already is not written.
    readSurely(row, parameter(row.number), this, [=, this, &row](const Result<int>& before) {
        if (!before) {
            handler(tl::make_unexpected(before.error()));
        } else if (*before == raw) {
            handler(ParameterWrite{raw, raw, true});
        } else {
            sendParameter(row, raw, *before, verify, handler);
        }
    });
}

void DeviceSettings::sendParameter(const ParameterRow& row, int raw, int from, bool verify,
                                   const Handler<ParameterWrite>& handler)
{
    const WriteIntent intent{{.row = &row}, from, raw, {}};
    const Command command = trex::writeParameter(row.number, static_cast<std::uint8_t>(raw));
    transmit(command, intent, [=, this, &row](const Pending& pending, const Result<void>& answer) {
        const QString key = QString::fromLatin1(row.key);
        if (pending.number < 0) {
            handler(tl::make_unexpected(answer.error()));
            return;
        }
        if (answer && row.needsReset) {
            m_inForce.try_emplace(row.number, evidenceInForce(row.number).value_or(from));
        }
        if (answer && !verify) {
            m_parameters.erase(row.number); // answered "done", but not seen
            conclude(pending, WriteResult::Answered);
            handler(ParameterWrite{from, raw, false});
            return;
        }
        verifyParameter(pending, answer ? std::nullopt : std::optional(answer.error()), handler);
    });
}

void DeviceSettings::verifyParameter(const Pending& pending, const std::optional<Error>& lost,
                                     const Handler<ParameterWrite>& handler)
{
    const ParameterRow& row = *pending.intent.setting.row;
    const int from = std::get<int>(*pending.intent.before);
    const int raw = std::get<int>(*pending.intent.after);
    readSurely(row, raw, this, [=, this, &row](const Result<int>& now) {
        const QString key = QString::fromLatin1(row.key);
        if (!now && lost && isRefusal(lost->code)) {
            conclude(pending, WriteResult::Refused, {}, errorText(*lost));
            handler(fail(lost->code, key));
            return;
        }
        if (!now) {
            conclude(pending, WriteResult::Unknown, {}, errorText(lost.value_or(now.error())));
            handler(tl::make_unexpected(lostAfterSending(now.error(), lost)));
            return;
        }
        if (*now == raw) {
            if (row.needsReset) {
                m_inForce.try_emplace(row.number, evidenceInForce(row.number).value_or(from));
            }
            conclude(pending, WriteResult::New, *now);
            handler(ParameterWrite{from, raw, true});
            return;
        }
        const bool isRefused = lost && isRefusal(lost->code) && *now == from;
        conclude(pending,
                 isRefused          ? WriteResult::Refused
                     : *now == from ? WriteResult::Old
                                    : WriteResult::Other,
                 *now, lost ? errorText(*lost) : QString());
        if (isRefused) {
            handler(fail(lost->code, key));
        } else if (lost && !isRefusal(lost->code)) {
            explainSilence(
                {lost->code == ErrorCode::NoReply ? ErrorCode::NotTrusted : lost->code, key},
                [handler](const Error& error) { handler(tl::make_unexpected(error)); });
        } else {
            handler(fail(ErrorCode::ReadBackDiffers,
                         tr("%1: wrote %2, read back %3").arg(key).arg(raw).arg(*now)));
        }
    });
}

void DeviceSettings::explainSilence(const Error& error, const std::function<void(Error)>& then)
{
    m_controller.request(query("get-uart-errors"), this, [error, then](const Result<Reply>& reply) {
        Error explained = error;
        if (reply) {
            explained.context += u" ("_s + describeReply(reply->command, reply->payload) + u')';
        }
        then(explained);
    });
}

void DeviceSettings::writeCalibration(int channel, const Calibration& calibration, QObject* context,
                                      const Handler<CalibrationWrite>& unguarded)
{
    const auto handler = guarded(context, unguarded);
    const Command command = trex::writeCalibration(channel, calibration);
    const bool ordered = calibration.minimum <= calibration.neutral
        && calibration.neutral <= calibration.maximum && calibration.minimum < calibration.maximum;
    if (!ordered || !validate(command)) {
        handler(fail(
            ErrorCode::OutOfRange,
            tr("calibration of channel %1: %2").arg(channel).arg(calibrationText(calibration))));
        return;
    }
    if (!m_controller.device().mode) { // it says to which set the calibration belongs
        m_controller.request(query("get-mode"), this, [=, this](const Result<Reply>& reply) {
            if (reply && m_controller.device().mode) {
                writeCalibration(channel, calibration, nullptr, handler);
            } else {
                handler(reply ? fail(ErrorCode::BadReply) : tl::make_unexpected(reply.error()));
            }
        });
        return;
    }
    const SettingId setting{
        .row = nullptr, .input = inputOf(*m_controller.device().mode), .channel = channel};
    const auto known = this->calibration(setting.input, channel);
    readSurely(channel, known, this, [=, this](const Result<Calibration>& before) {
        if (!before) {
            handler(tl::make_unexpected(before.error()));
        } else if (*before == calibration) {
            handler(CalibrationWrite{calibration, true, false});
        } else {
            sendCalibration(setting, *before, calibration, calibration, handler);
        }
    });
}

void DeviceSettings::sendCalibration(const SettingId& setting, const Calibration& before,
                                     const Calibration& wanted, const Calibration& sent,
                                     const Handler<CalibrationWrite>& handler)
{
    // What the second try is to bring is what such a controller makes of the bytes.
    const WriteIntent intent{setting, before, sent == wanted ? wanted : eightBitReading(sent), {}};
    const Command command = trex::writeCalibration(setting.channel, sent);
    transmit(command, intent, [=, this](const Pending& pending, const Result<void>& answer) {
        if (pending.number < 0) {
            handler(tl::make_unexpected(answer.error()));
            return;
        }
        verifyCalibration(pending, wanted, sent,
                          answer ? std::nullopt : std::optional(answer.error()), handler);
    });
}

void DeviceSettings::verifyCalibration(const Pending& pending, const Calibration& wanted,
                                       const Calibration& sent, const std::optional<Error>& lost,
                                       const Handler<CalibrationWrite>& handler)
{
    const SettingId setting = pending.intent.setting;
    const auto expected = std::get<Calibration>(*pending.intent.after);
    readSurely(setting.channel, expected, this, [=, this](const Result<Calibration>& now) {
        const QString what = tr("calibration of channel %1").arg(setting.channel);
        const bool firstTry = sent == wanted;
        if (!now && lost && isRefusal(lost->code)) {
            conclude(pending, WriteResult::Refused, {}, errorText(*lost));
            handler(fail(lost->code, what));
            return;
        }
        if (!now) {
            conclude(pending, WriteResult::Unknown, {}, errorText(lost.value_or(now.error())));
            handler(tl::make_unexpected(lostAfterSending(now.error(), lost)));
            return;
        }
        const SettingValue found = *now;
        const bool isRefused = lost && isRefusal(lost->code) && found == pending.intent.before;
        conclude(pending,
                 found == pending.intent.after        ? WriteResult::New
                     : isRefused                      ? WriteResult::Refused
                     : found == pending.intent.before ? WriteResult::Old
                                                      : WriteResult::Other,
                 found, lost ? errorText(*lost) : QString());
        if (isRefused) {
            handler(fail(lost->code, what));
        } else if (*now == wanted) {
            handler(CalibrationWrite{*now, true, !firstTry});
        } else if (firstTry && *now == eightBitReading(sent)) {
            // The other reading of the byte pairs (C-35): send what that controller stores nearest.
            sendCalibration(setting, *now, wanted, forEightBit(wanted), handler);
        } else if (!firstTry && *now == eightBitReading(sent)) {
            handler(CalibrationWrite{*now, false, true});
        } else if (lost && !isRefusal(lost->code)) {
            explainSilence(
                {lost->code == ErrorCode::NoReply ? ErrorCode::NotTrusted : lost->code, what},
                [handler](const Error& error) { handler(tl::make_unexpected(error)); });
        } else {
            handler(fail(ErrorCode::ReadBackDiffers,
                         tr("%1: wrote %2, read back %3")
                             .arg(what, calibrationText(wanted), calibrationText(*now))));
        }
    });
}

void DeviceSettings::factoryReset(QObject* context, const Handler<void>& unguarded)
{
    const auto handler = guarded(context, unguarded);
    const ParameterRow& row = parameterRow("factory-reset");
    const WriteIntent intent{{.row = &row}, std::nullopt, std::nullopt, {}};
    transmit(trex::writeParameter(row.number, kFactoryResetValue), intent,
             [=, this](const Pending& pending, const Result<void>& answer) {
                 if (answer) {
                     conclude(pending, WriteResult::Answered);
                     for (const auto& [known, raw] : m_parameters) {
                         m_inForce.try_emplace(known, evidenceInForce(known).value_or(raw));
                     }
                     forget(); // what was read before may be old now
                 } else {
                     conclude(pending,
                              isRefusal(answer.error().code) ? WriteResult::Refused
                                                             : WriteResult::Unknown,
                              {}, errorText(answer.error()));
                 }
                 handler(answer);
             });
}

} // namespace trex
