// SPDX-License-Identifier: GPL-3.0-or-later
#include "protocol/procedures/linetext.h"

#include <QCoreApplication>

namespace trex {

using namespace Qt::Literals::StringLiterals;

namespace {

struct Sentences {
    Q_DECLARE_TR_FUNCTIONS(LineText)
};

QString detectionText(const LineSettings& line)
{
    switch (line.errorDetection) {
    case ErrorDetection::None:
        return Sentences::tr("%1 baud, no error detection").arg(line.baud);
    case ErrorDetection::Even:
        return Sentences::tr("%1 baud, even parity").arg(line.baud);
    case ErrorDetection::Odd:
        return Sentences::tr("%1 baud, odd parity").arg(line.baud);
    case ErrorDetection::Crc7:
        break;
    }
    return Sentences::tr("%1 baud, CRC-7").arg(line.baud);
}

} // namespace

QString lineText(const LineSettings& line)
{
    QString text = detectionText(line);
    if (line.hasCrc() && line.polynomial != kDefaultPolynomial) {
        text = Sentences::tr("%1 with polynomial 0x%2").arg(text).arg(line.polynomial, 2, 16);
    }
    return line.stopBits == 2 ? Sentences::tr("%1, two stop bits").arg(text) : text;
}

QString wiringAdvice(LineAnswer heard)
{
    switch (heard) {
    case LineAnswer::Silence:
        return Sentences::tr("Nothing at all came back. Check the controller's power, that ground "
                             "and both data wires are connected, and that the two data wires are "
                             "not swapped.");
    case LineAnswer::EchoOnly:
        return Sentences::tr("Only our own bytes came back: the wiring reaches the RS-232 pins, "
                             "but the controller does not answer. Check its power, and that an "
                             "RS-232 adapter (not a logic-level one) is on those pins.");
    case LineAnswer::Zeros:
        return Sentences::tr("Only zeros came back: the data line is held low or inverted. A "
                             "logic-level adapter belongs on SI and SO, an RS-232 adapter on the "
                             "RS-232 pins; do not mix them.");
    case LineAnswer::Garbage:
        return Sentences::tr("Bytes came back that are no reply of a TReX. Check for a loose "
                             "ground and for other devices on the line; with CRC-7, give its "
                             "polynomial if it was changed.");
    }
    return {};
}

QString leftOutText(const std::vector<LineSettings>& leftOut)
{
    if (leftOut.empty()) {
        return {};
    }
    QStringList lines;
    for (const LineSettings& line : leftOut) {
        lines << Sentences::tr("%1 with polynomial 0x%2")
                     .arg(detectionText(line))
                     .arg(line.polynomial, 2, 16);
    }
    return Sentences::tr("Not tried: %1, since a question there could be heard as a motor command "
                         "at another speed; if these are the settings, switch the motor power off "
                         "and connect with them.")
        .arg(lines.join("; "_L1));
}

QString vendorResetText()
{
    return Sentences::tr(
        "Last resort, back to the factory's serial settings (19200 baud, no error detection):\n"
        "1. Switch the controller off.\n"
        "2. Take the mode jumper off.\n"
        "3. Connect SO to ground with the learning jumper.\n"
        "4. Put the mix jumper on.\n"
        "5. Switch on: red and green blink in turn.\n"
        "6. Take the mix jumper off: they blink faster. Go no further, taking the SO jumper off "
        "now "
        "enters the firmware upgrade.\n"
        "7. Switch off, take the learning jumper off, switch on, and recover again.\n"
        "The steps come from people who quote the vendor's guide; that they restore the serial "
        "settings is inferred, not confirmed.");
}

} // namespace trex
