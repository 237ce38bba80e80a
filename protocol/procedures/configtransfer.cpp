// SPDX-License-Identifier: GPL-3.0-or-later
#include "protocol/procedures/configtransfer.h"

#include "protocol/errortext.h"
#include "protocol/procedures/settingscheck.h"

#include <algorithm>

using namespace Qt::Literals::StringLiterals;

namespace trex {
namespace {

/// False when it is certain that a failed write left the old value where it was: the controller
/// refused it, or nothing was sent.
bool mayHaveWritten(ErrorCode code)
{
    switch (code) {
    case ErrorCode::BadParameterNumber:
    case ErrorCode::BadValue:
    case ErrorCode::NotInSerialMode:
    case ErrorCode::OutOfRange:
    case ErrorCode::BadCommand:
    case ErrorCode::NotConnected:
    case ErrorCode::Cancelled:
    case ErrorCode::FileUnreadable: // the journal's: nothing is sent without it
    case ErrorCode::FileMalformed:
    case ErrorCode::FileUnwritable:
        return false;
    default:
        return true;
    }
}

/// The write that undoes one; none when the value before is not known.
std::optional<SettingWrite> undo(const SettingWrite& write)
{
    SettingWrite back = write;
    if (write.row != nullptr && write.rawFrom) {
        back.rawFrom = write.rawTo;
        back.rawTo = *write.rawFrom;
        return back;
    }
    if (write.row == nullptr && write.calibrationFrom) {
        back.calibrationFrom = write.calibrationTo;
        back.calibrationTo = *write.calibrationFrom;
        return back;
    }
    return std::nullopt;
}

} // namespace

ConfigTransfer::ConfigTransfer(Controller& controller, DeviceSettings& settings, QObject* parent)
    : QObject(parent)
    , m_controller(controller)
    , m_settings(settings)
    , m_check(new SettingsCheck(controller, settings, this))
{
}

void ConfigTransfer::read()
{
    Q_ASSERT(!m_busy);
    m_busy = true;
    m_settings.readAll(
        this, [this](int done, int total) { emit progressed(done, total); },
        [this](const Result<void>& result) {
            m_busy = false;
            if (!result) {
                emit readFinished(tl::make_unexpected(result.error()));
                return;
            }
            emit readFinished(presentConfiguration(m_controller, m_settings));
        });
}

void ConfigTransfer::write(const TransferPlan& plan, OnFailure onFailure)
{
    Q_ASSERT(!m_busy);
    m_busy = true;
    m_cancelled = false;
    m_onFailure = onFailure;
    m_plan = plan;
    m_outcome = {};
    m_outcome.notes = plan.leftOut;
    m_next = 0;
    prepare();
    writeNext();
}

void ConfigTransfer::putBack(const std::vector<SettingWrite>& written)
{
    Q_ASSERT(!m_busy);
    m_busy = true;
    m_outcome = {};
    m_outcome.written = written;
    m_plan = {written, {}};
    prepare();
    restoreNext();
}

void ConfigTransfer::cancel()
{
    m_cancelled = m_busy;
}

void ConfigTransfer::writeNext()
{
    const auto total = m_plan.writes.size();
    emit progressed(static_cast<int>(m_next), static_cast<int>(total));
    if (m_next == total) {
        verify(&ConfigTransfer::finish);
        return;
    }
    if (m_cancelled) {
        m_outcome.error = Error{ErrorCode::Cancelled, {}};
        onFailure();
        return;
    }
    const SettingWrite& write = m_plan.writes[m_next];
    if (isUnreadable(write) && m_next > 0 && !std::exchange(m_isChecked, true)) {
        verify(&ConfigTransfer::writeNext); // while this controller can still be asked
        return;
    }
    perform(write, false);
}

void ConfigTransfer::perform(const SettingWrite& write, bool isRestoring)
{
    const auto done = [this, write, isRestoring](const std::optional<Error>& error) {
        isRestoring ? onRestored(error) : onWritten(write, error);
    };
    if (write.row == nullptr) {
        performCalibration(write, done);
        return;
    }
    // The device number acts at once (conformance C-39): a Pololu packet under the old number would
    // ask nobody, so that it cannot be read back on this connection.
    m_settings.writeParameter(*write.row, write.rawTo, !isUnreadable(write), this,
                              [done](const Result<DeviceSettings::ParameterWrite>& result) {
                                  done(result ? std::nullopt : std::optional(result.error()));
                              });
}

void ConfigTransfer::performCalibration(const SettingWrite& write, const Done& done)
{
    // A reset may have brought the other input set into force, to which these numbers mean nothing.
    m_controller.request(query("get-mode"), this, [=, this](const Result<Reply>& reply) {
        const auto mode = reply ? parseMode(reply->payload) : tl::make_unexpected(reply.error());
        if (!mode || inputOf(*mode) != write.input) {
            done(mode
                     ? Error{ErrorCode::BadCommand,
                             tr("%1 while the controller uses its other inputs").arg(write.title())}
                     : mode.error());
            return;
        }
        m_settings.writeCalibration(
            write.channel, write.calibrationTo, this,
            [=, this](const Result<DeviceSettings::CalibrationWrite>& result) {
                if (result && result->eightBitBytes) {
                    m_outcome.notes << tr("%1: this controller takes calibration bytes in another "
                                          "way; the nearest value that it can take is written.")
                                           .arg(write.title());
                } else if (result && !result->verified) {
                    done(Error{ErrorCode::ReadBackDiffers, write.key()});
                    return;
                }
                if (result) { // on such a controller the nearest is what is to be there
                    m_expected.calibrations[write.input][write.channel] = result->readBack;
                }
                done(result ? std::nullopt : std::optional(result.error()));
            });
    });
}

void ConfigTransfer::onWritten(const SettingWrite& write, const std::optional<Error>& error)
{
    if (!error) {
        if (write.row != nullptr) {
            expect(write);
        }
        m_outcome.written.push_back(write);
        ++m_next;
        writeNext();
        return;
    }
    m_outcome.error = error;
    m_outcome.failed = write;
    m_outcome.failedMayHold = mayHaveWritten(error->code);
    m_suspects.push_back(write);
    onFailure();
}

void ConfigTransfer::onFailure()
{
    if (m_onFailure == OnFailure::Stop) {
        verify(&ConfigTransfer::finish);
        return;
    }
    m_outcome.written = m_outcome.toPutBack();
    m_outcome.failedMayHold = false; // told by restored or notRestored from here on
    restoreNext();
}

void ConfigTransfer::restoreNext()
{
    const auto done = m_outcome.restored.size() + m_outcome.notRestored.size();
    emit progressed(static_cast<int>(done), static_cast<int>(done + m_outcome.written.size()));
    if (m_outcome.written.empty()) {
        verify(&ConfigTransfer::finish);
        return;
    }
    const auto back = undo(m_outcome.written.back());
    if (!back) {
        onRestored(Error{ErrorCode::OutOfRange, {}});
        return;
    }
    perform(*back, true);
}

void ConfigTransfer::onRestored(const std::optional<Error>& error)
{
    const auto last = m_outcome.written.back();
    m_outcome.written.pop_back();
    const auto back = undo(last);
    if (!error) {
        m_outcome.restored.push_back(last);
        if (back->row != nullptr) {
            expect(*back);
        }
    } else {
        m_outcome.notRestored.push_back(last);
        m_suspects.push_back(back.value_or(last));
    }
    if (error && isLoss(error->code)) { // the line is gone: the rest would fail one by one
        std::ranges::reverse(m_outcome.written);
        m_outcome.notRestored.insert(m_outcome.notRestored.end(), m_outcome.written.begin(),
                                     m_outcome.written.end());
        m_outcome.written.clear();
    }
    restoreNext();
}

void ConfigTransfer::finish()
{
    m_busy = false;
    m_outcome.needsReset = std::ranges::any_of(m_outcome.written, &SettingWrite::needsReset);
    emit finished(m_outcome);
}

} // namespace trex
