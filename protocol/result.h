// SPDX-License-Identifier: GPL-3.0-or-later
// What a call that can fail returns. Becomes std::expected by editing one line (GCC 12 ships
// <expected> only under -std=c++23).
#pragma once

#include <QString>

#include <tl/expected.hpp>

namespace trex {

enum class ErrorCode {
    // refusals: the controller's own answer (command documentation, 0xA0 and 0xAF)
    BadParameterNumber, ///< answer 1
    BadValue, ///< answer 2
    NotInSerialMode, ///< answer 3
    UnknownAnswer, ///< an answer byte the document does not know
    // losses: the line or the controller is gone
    NoReply, ///< nothing came within its time
    ShortReply, ///< some bytes came, then silence
    BadReplyCrc, ///< the reply failed its CRC-7
    BadReply, ///< complete, but no TReX answers so
    NotTrusted, ///< a setting got no answer: the controller discarded the packet
    EchoOnly, ///< only our own bytes came back
    Garbage, ///< bytes that are no reply: wrong speed or another device
    NotATrex, ///< something answered 0x81, but with no TReX signature
    LineLost, ///< the port vanished or the peer closed
    NotConnected, ///< asked while no line is open
    Cancelled, ///< given up on request
    // ports
    PortMissing,
    PortBusy,
    PortDenied,
    PortNotSerial,
    PortFailed,
    PortAddress,
    // ours, before a byte is sent
    OutOfRange,
    BadCommand,
    Disarmed,
    LockedOut,
    JointMode,
    ReadBackDiffers, ///< what was read back is not what was written
    // files
    FileUnreadable,
    FileMalformed,
    FileUnwritable,
    // recordings
    IsRecording, ///< asked of a controller that is only shown as it was
};

/// An error: its kind, and the words that say where (a port, a key, a line of a file). Made into
/// a sentence for people by errorText() (errortext.h) and nowhere else.
struct Error {
    ErrorCode code = ErrorCode::NoReply;
    QString context;
    bool operator==(const Error&) const = default;
};

template <class T>
using Result = tl::expected<T, Error>;

/// tl::expected 1.0 compares the values of expected<void>, which has none; signals that carry one
/// need the comparison.
inline bool operator==(const Result<void>& a, const Result<void>& b)
{
    return a.has_value() == b.has_value() && (a.has_value() || a.error() == b.error());
}

inline tl::unexpected<Error> fail(ErrorCode code, QString context = {})
{
    return tl::make_unexpected(Error{code, std::move(context)});
}

} // namespace trex
