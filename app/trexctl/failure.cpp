// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/trexctl/failure.h"

#include "protocol/errortext.h"

namespace trex {

int exitCodeOf(ErrorCode code)
{
    switch (code) {
    case ErrorCode::BadParameterNumber:
    case ErrorCode::BadValue:
    case ErrorCode::NotInSerialMode:
    case ErrorCode::UnknownAnswer:
    case ErrorCode::JointMode:
        return exitcode::kRefused;
    case ErrorCode::NoReply:
    case ErrorCode::ShortReply:
    case ErrorCode::BadReplyCrc:
    case ErrorCode::BadReply:
    case ErrorCode::NotTrusted:
    case ErrorCode::EchoOnly:
    case ErrorCode::Garbage:
    case ErrorCode::NotATrex:
        return exitcode::kNoReply;
    case ErrorCode::LineLost:
    case ErrorCode::NotConnected:
    case ErrorCode::PortMissing:
    case ErrorCode::PortBusy:
    case ErrorCode::PortDenied:
    case ErrorCode::PortNotSerial:
    case ErrorCode::PortFailed:
        return exitcode::kPort;
    case ErrorCode::ReadBackDiffers:
        return exitcode::kDiffers;
    case ErrorCode::Cancelled:
        return exitcode::kInterrupted;
    case ErrorCode::PortAddress: // makes no sense as typed: nothing was opened
    case ErrorCode::OutOfRange:
    case ErrorCode::BadCommand:
    case ErrorCode::Disarmed:
    case ErrorCode::LockedOut:
    case ErrorCode::FileUnreadable:
    case ErrorCode::FileMalformed:
    case ErrorCode::FileUnwritable:
    case ErrorCode::IsRecording:
        break;
    }
    return exitcode::kUsage;
}

Failure toFailure(const Error& error)
{
    return {exitCodeOf(error.code), errorText(error)};
}

} // namespace trex
