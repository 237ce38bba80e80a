// SPDX-License-Identifier: GPL-3.0-or-later
#include "protocol/errortext.h"

#include <QCoreApplication>

#include <array>

namespace trex {
namespace {

/// What failed and what to do. Where `what` has a %1, the context goes there (`subject` when there
/// is none); elsewhere the context follows in brackets.
struct ErrorRow {
    ErrorCode code;
    const char* what;
    const char* advice = nullptr;
    const char* subject = nullptr;
};

constexpr auto kPort = QT_TRANSLATE_NOOP("Errors", "the port");
constexpr auto kFile = QT_TRANSLATE_NOOP("Errors", "the file");
constexpr auto kController = QT_TRANSLATE_NOOP("Errors", "the controller");

// clang-format off
constexpr auto kErrors = std::to_array<ErrorRow>({
    {.code = ErrorCode::BadParameterNumber, .what = QT_TRANSLATE_NOOP("Errors", "The controller refused: it has no such parameter"),
     .advice = QT_TRANSLATE_NOOP("Errors", "Check the parameter's number; 0x17 needs firmware 1.2 or later.")},
    {.code = ErrorCode::BadValue, .what = QT_TRANSLATE_NOOP("Errors", "The controller refused the value"),
     .advice = QT_TRANSLATE_NOOP("Errors", "Check its range; a calibration needs minimum ≤ neutral ≤ maximum and minimum < maximum.")},
    {.code = ErrorCode::NotInSerialMode, .what = QT_TRANSLATE_NOOP("Errors", "The controller refused: it is not in serial mode"),
     .advice = QT_TRANSLATE_NOOP("Errors", "Switch its power off, take the mode jumper off, switch it on and try again.")},
    {.code = ErrorCode::UnknownAnswer, .what = QT_TRANSLATE_NOOP("Errors", "The controller gave an answer that its documentation does not know"),
     .advice = QT_TRANSLATE_NOOP("Errors", "Read the value back to see whether it was stored.")},
    {.code = ErrorCode::NoReply, .what = QT_TRANSLATE_NOOP("Errors", "No reply from %1"),
     .advice = QT_TRANSLATE_NOOP("Errors", "Check its power, the wiring, baud rate, error detection and device number; Scan tries the settings for you."), .subject = kController},
    {.code = ErrorCode::ShortReply, .what = QT_TRANSLATE_NOOP("Errors", "The reply broke off"),
     .advice = QT_TRANSLATE_NOOP("Errors", "Check the wiring and the controller's power, then try again.")},
    {.code = ErrorCode::BadReplyCrc, .what = QT_TRANSLATE_NOOP("Errors", "The reply failed its CRC check"),
     .advice = QT_TRANSLATE_NOOP("Errors", "Check the wiring for noise, and that the controller uses the same CRC-7 polynomial.")},
    {.code = ErrorCode::BadReply, .what = QT_TRANSLATE_NOOP("Errors", "The reply makes no sense from a TReX"),
     .advice = QT_TRANSLATE_NOOP("Errors", "Check that a TReX or TReX Jr is connected, and its baud rate and error detection.")},
    {.code = ErrorCode::NotTrusted, .what = QT_TRANSLATE_NOOP("Errors", "The controller did not answer the setting, so it discarded the packet"),
     .advice = QT_TRANSLATE_NOOP("Errors", "Look at the UART error byte for the reason, then try again.")},
    {.code = ErrorCode::EchoOnly, .what = QT_TRANSLATE_NOOP("Errors", "Only our own bytes came back from %1"),
     .advice = QT_TRANSLATE_NOOP("Errors", "Check the controller's power and the wiring, that the RS-232 pins carry RS-232 and the SI and SO pins logic levels, and the baud rate."), .subject = kPort},
    {.code = ErrorCode::Garbage, .what = QT_TRANSLATE_NOOP("Errors", "Bytes came from %1 that are no reply of a TReX"),
     .advice = QT_TRANSLATE_NOOP("Errors", "Perhaps it uses another baud rate or error detection (Scan finds it), or another device is connected."), .subject = kPort},
    {.code = ErrorCode::NotATrex, .what = QT_TRANSLATE_NOOP("Errors", "Something answered, but not with the signature of a TReX"),
     .advice = QT_TRANSLATE_NOOP("Errors", "Choose another port, or another baud rate or device number.")},
    {.code = ErrorCode::LineLost, .what = QT_TRANSLATE_NOOP("Errors", "The connection to %1 was lost"),
     .advice = QT_TRANSLATE_NOOP("Errors", "Check the cable and the adapter, then connect again."), .subject = kController},
    {.code = ErrorCode::NotConnected, .what = QT_TRANSLATE_NOOP("Errors", "There is no connection to a controller"),
     .advice = QT_TRANSLATE_NOOP("Errors", "Connect first.")},
    {.code = ErrorCode::Cancelled, .what = QT_TRANSLATE_NOOP("Errors", "Cancelled on request")},
    {.code = ErrorCode::PortMissing, .what = QT_TRANSLATE_NOOP("Errors", "There is no port %1"),
     .advice = QT_TRANSLATE_NOOP("Errors", "Check that the adapter is plugged in, or choose another port."), .subject = QT_TRANSLATE_NOOP("Errors", "of that name")},
    {.code = ErrorCode::PortBusy, .what = QT_TRANSLATE_NOOP("Errors", "Another program uses %1"),
     .advice = QT_TRANSLATE_NOOP("Errors", "Close that program, then try again."), .subject = kPort},
    {.code = ErrorCode::PortDenied, .what = QT_TRANSLATE_NOOP("Errors", "No permission to open %1"),
     .advice = QT_TRANSLATE_NOOP("Errors", "Add yourself to the group dialout (sudo usermod -aG dialout $USER), then log in again."), .subject = kPort},
    {.code = ErrorCode::PortNotSerial, .what = QT_TRANSLATE_NOOP("Errors", "Not a serial port: %1"),
     .advice = QT_TRANSLATE_NOOP("Errors", "Choose a serial device such as /dev/ttyUSB0 or COM3, a tcp://HOST:PORT address, or sim: for the simulator."), .subject = kFile},
    {.code = ErrorCode::PortFailed, .what = QT_TRANSLATE_NOOP("Errors", "Could not open or set up %1"),
     .advice = QT_TRANSLATE_NOOP("Errors", "Check the address and the cable, plug the adapter in again, then retry."), .subject = kPort},
    {.code = ErrorCode::PortAddress, .what = QT_TRANSLATE_NOOP("Errors", "Not a port address: %1"),
     .advice = QT_TRANSLATE_NOOP("Errors", "Give a serial device such as /dev/ttyUSB0 or COM3, tcp://HOST:PORT, or sim: for the simulator."), .subject = QT_TRANSLATE_NOOP("Errors", "empty")},
    {.code = ErrorCode::OutOfRange, .what = QT_TRANSLATE_NOOP("Errors", "Out of range: %1"),
     .advice = QT_TRANSLATE_NOOP("Errors", "Nothing was sent; give a value within the range."), .subject = QT_TRANSLATE_NOOP("Errors", "a number")},
    {.code = ErrorCode::BadCommand, .what = QT_TRANSLATE_NOOP("Errors", "Not a command of the TReX: %1"),
     .advice = QT_TRANSLATE_NOOP("Errors", "Nothing was sent; check the command and its data bytes."), .subject = QT_TRANSLATE_NOOP("Errors", "no bytes")},
    {.code = ErrorCode::Disarmed, .what = QT_TRANSLATE_NOOP("Errors", "The motors are not armed"),
     .advice = QT_TRANSLATE_NOOP("Errors", "Nothing was sent; arm them in the Motors panel first.")},
    {.code = ErrorCode::LockedOut, .what = QT_TRANSLATE_NOOP("Errors", "The motors are locked while another task runs"),
     .advice = QT_TRANSLATE_NOOP("Errors", "Nothing was sent; finish or cancel that task first.")},
    {.code = ErrorCode::JointMode, .what = QT_TRANSLATE_NOOP("Errors", "Not available in joint motor mode"),
     .advice = QT_TRANSLATE_NOOP("Errors", "Both H-bridges drive one motor there, without current readings; the motor mode parameter changes that.")},
    {.code = ErrorCode::ReadBackDiffers, .what = QT_TRANSLATE_NOOP("Errors", "What was read back differs from what was written"),
     .advice = QT_TRANSLATE_NOOP("Errors", "Read the value again, and write it once more if it is still wrong.")},
    {.code = ErrorCode::FileUnreadable, .what = QT_TRANSLATE_NOOP("Errors", "Could not read %1"),
     .advice = QT_TRANSLATE_NOOP("Errors", "Check its name, and that you may read it."), .subject = kFile},
    {.code = ErrorCode::FileMalformed, .what = QT_TRANSLATE_NOOP("Errors", "The file makes no sense"),
     .advice = QT_TRANSLATE_NOOP("Errors", "Correct that place, or choose another file.")},
    {.code = ErrorCode::FileUnwritable, .what = QT_TRANSLATE_NOOP("Errors", "Could not write %1"),
     .advice = QT_TRANSLATE_NOOP("Errors", "Check its folder, that you may write there, and that the disk is not full."), .subject = kFile},
    {.code = ErrorCode::IsRecording, .what = QT_TRANSLATE_NOOP("Errors", "This is a recording: nothing here reaches a controller"),
     .advice = QT_TRANSLATE_NOOP("Errors", "Use the window of the controller that is connected.")},
});
// clang-format on

static_assert(kErrors.size() == static_cast<std::size_t>(ErrorCode::IsRecording) + 1);
static_assert([] {
    for (std::size_t i = 0; i < kErrors.size(); ++i) {
        if (static_cast<std::size_t>(kErrors[i].code) != i || kErrors[i].what == nullptr) {
            return false;
        }
    }
    return true;
}());

QString translated(const char* text)
{
    return QCoreApplication::translate("Errors", text);
}

/// Contexts hold what stood in files, came over the line, or names a port: no sign in them may
/// break the line, move the cursor or turn the direction of what follows.
QString oneLine(QString context)
{
    for (QChar& letter : context) {
        const bool isBlank = letter == u'\n' || letter == u'\t' || letter == u'\r'
            || letter.category() == QChar::Separator_Line
            || letter.category() == QChar::Separator_Paragraph;
        const bool turns = (letter >= u'\u202A' && letter <= u'\u202E')
            || (letter >= u'\u2066' && letter <= u'\u2069');
        if (isBlank) {
            letter = u' ';
        } else if (turns || letter.category() == QChar::Other_Control) {
            letter = QChar::ReplacementCharacter;
        }
    }
    return context;
}

} // namespace

QString errorText(const Error& error)
{
    const QString context = oneLine(error.context);
    const auto& row = kErrors[static_cast<std::size_t>(error.code)];
    QString text = translated(row.what);
    if (row.subject != nullptr) {
        text = text.arg(context.isEmpty() ? translated(row.subject) : context);
    } else if (!context.isEmpty()) {
        text += QStringLiteral(" (%1)").arg(context);
    }
    text += QLatin1Char('.');
    return row.advice == nullptr ? text : text + QLatin1Char(' ') + translated(row.advice);
}

tl::unexpected<Error> outOfRange(std::string_view key, qint64 value, qint64 minimum, qint64 maximum)
{
    return fail(ErrorCode::OutOfRange,
                QStringLiteral("%1 %2 (%3…%4)")
                    .arg(QString::fromLatin1(key))
                    .arg(value)
                    .arg(minimum)
                    .arg(maximum));
}

bool isLoss(ErrorCode code)
{
    switch (code) {
    case ErrorCode::NoReply:
    case ErrorCode::ShortReply:
    case ErrorCode::BadReplyCrc:
    case ErrorCode::BadReply:
    case ErrorCode::EchoOnly:
    case ErrorCode::Garbage:
    case ErrorCode::NotATrex:
    case ErrorCode::LineLost:
    case ErrorCode::NotConnected:
        return true;
    default:
        return false;
    }
}

} // namespace trex
