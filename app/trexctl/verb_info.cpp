// SPDX-License-Identifier: GPL-3.0-or-later
// info, status
#include "app/trexctl/controllertext.h"
#include "app/trexctl/verbs.h"

using namespace Qt::Literals::StringLiterals;

namespace trex {
namespace {

QJsonArray channelArray(std::uint8_t mask)
{
    QJsonArray channels;
    for (int channel = 1; channel <= kChannelCount; ++channel) {
        if ((mask >> (channel - 1) & 1) != 0) {
            channels.append(channel);
        }
    }
    return channels;
}

class InfoVerb : public Verb {
public:
    Task run(Session& session) override
    {
        const Reply modeReply = co_await session.ask(query("get-mode"));
        const Reply controlReply = co_await session.ask(query("get-serial-control"));
        const Reply learnedReply = co_await session.ask(query("get-learned"));
        const auto mode = parseMode(modeReply.payload);
        if (!mode) {
            session.fail(mode.error());
            co_return;
        }
        const Facts facts{*session.controller().device().signature, *mode,
                          controlReply.payload.front() != 0,
                          static_cast<std::uint8_t>(learnedReply.payload.front())};
        const LineSettings& line = session.options().line;
        const bool echo = session.controller().stats().echo;
        session.output().answer(json(facts, line, echo), text(facts, line, echo));
        session.end();
    }

private:
    struct Facts {
        Signature signature;
        Mode mode;
        bool serialControls;
        std::uint8_t learnedMask;
    };

    static QJsonObject json(const Facts& facts, const LineSettings& line, bool echo)
    {
        return {{u"signature"_s, facts.signature.text()},
                {u"model"_s, facts.signature.modelName()},
                {u"firmware"_s, facts.signature.firmware()},
                {u"mode"_s, latin(keyOf(facts.mode))},
                {u"modeByte"_s, QString(QLatin1Char(letterOf(facts.mode)))},
                {u"serialControlsMotors"_s, facts.serialControls},
                {u"calibratedChannels"_s, channelArray(facts.learnedMask)},
                {u"device"_s, line.device},
                {u"protocol"_s, latin(keyOf(line.form))},
                {u"baud"_s, line.baud},
                {u"errorDetection"_s, latin(keyOf(line.errorDetection))},
                {u"echo"_s, echo}};
    }

    static QString text(const Facts& facts, const LineSettings& line, bool echo)
    {
        const QString form = line.form == PacketForm::Pololu
            ? Cli::tr("Pololu packets to device %1").arg(line.device)
            : Cli::tr("compact packets");
        return labelled({{Cli::tr("Controller"),
                          Cli::tr("%1, firmware %2 (%3)")
                              .arg(facts.signature.modelName(), facts.signature.firmware(),
                                   facts.signature.text())},
                         {Cli::tr("Mode"), modeText(facts.mode)},
                         {Cli::tr("Motors"),
                          facts.serialControls ? Cli::tr("serial is in control")
                                               : Cli::tr("the channels are in control")},
                         {Cli::tr("Learned channels"), channelList(facts.learnedMask)},
                         {Cli::tr("Line"),
                          Cli::tr("%1 baud, error detection %2, %3, %4")
                              .arg(QString::number(line.baud), latin(keyOf(line.errorDetection)),
                                   form, echo ? Cli::tr("with echo") : Cli::tr("no echo"))}});
    }
};

struct BitRow {
    const char* key;
    std::uint8_t bit;
    const char* title; ///< QT_TRANSLATE_NOOP("Cli", …)
};
// clang-format off
constexpr auto kStatusRows = std::to_array<BitRow>({
    {"motor1OverCurrent", statusbit::kMotor1OverCurrent, QT_TRANSLATE_NOOP("Cli", "motor 1 over its current limit")},
    {"motor1Fault", statusbit::kMotor1Fault, QT_TRANSLATE_NOOP("Cli", "motor 1 driver fault")},
    {"motor2OverCurrent", statusbit::kMotor2OverCurrent, QT_TRANSLATE_NOOP("Cli", "motor 2 over its current limit")},
    {"motor2Fault", statusbit::kMotor2Fault, QT_TRANSLATE_NOOP("Cli", "motor 2 driver fault")},
    {"uartError", statusbit::kUartError, QT_TRANSLATE_NOOP("Cli", "UART error")},
});
constexpr auto kUartRows = std::to_array<BitRow>({
    {"timeout", uartbit::kTimeout, QT_TRANSLATE_NOOP("Cli", "serial timeout")},
    {"format", uartbit::kFormat, QT_TRANSLATE_NOOP("Cli", "packet format")},
    {"crc", uartbit::kCrc, QT_TRANSLATE_NOOP("Cli", "CRC")},
    {"frame", uartbit::kFrame, QT_TRANSLATE_NOOP("Cli", "frame")},
    {"overrun", uartbit::kOverrun, QT_TRANSLATE_NOOP("Cli", "data overrun")},
    {"parity", uartbit::kParity, QT_TRANSLATE_NOOP("Cli", "parity")},
    {"readBufferOverrun", uartbit::kReadBufferOverrun, QT_TRANSLATE_NOOP("Cli", "read buffer overrun")},
    {"sendBufferOverrun", uartbit::kSendBufferOverrun, QT_TRANSLATE_NOOP("Cli", "send buffer overrun")},
});
// clang-format on

class StatusVerb : public Verb {
public:
    Task run(Session& session) override
    {
        const Reply status = co_await session.ask(query("get-status"));
        const Reply uart = co_await session.ask(query("get-uart-errors"));
        const auto statusByte = static_cast<std::uint8_t>(status.payload.front());
        const auto uartByte = static_cast<std::uint8_t>(uart.payload.front());
        session.output().answer(QJsonObject{{u"status"_s, bits(kStatusRows, statusByte)},
                                            {u"uartError"_s, bits(kUartRows, uartByte)}},
                                labelled({{Cli::tr("Status"), words(kStatusRows, statusByte)},
                                          {Cli::tr("UART errors"), words(kUartRows, uartByte)}}));
        if (session.controller().stats().lostLatchReads > 0) {
            session.warn(Cli::tr("A reply was lost on the line and asked for again: bits that it "
                                 "carried may be missing here."));
        }
        session.end();
    }

private:
    static QJsonObject bits(std::span<const BitRow> rows, std::uint8_t byte)
    {
        QJsonObject object{{u"byte"_s, byte}};
        for (const auto& row : rows) {
            object.insert(QLatin1StringView(row.key), (byte & row.bit) != 0);
        }
        return object;
    }
    static QString words(std::span<const BitRow> rows, std::uint8_t byte)
    {
        QStringList lit;
        for (const auto& row : rows) {
            if ((byte & row.bit) != 0) {
                lit << Cli::tr(row.title);
            }
        }
        return u"0x%1  %2"_s.arg(byte, 2, 16, QLatin1Char('0'))
            .arg(lit.isEmpty() ? Cli::tr("nothing latched") : lit.join(u", "_s));
    }
};

} // namespace

std::unique_ptr<Verb> makeInfo()
{
    return std::make_unique<InfoVerb>();
}

std::unique_ptr<Verb> makeStatus()
{
    return std::make_unique<StatusVerb>();
}

} // namespace trex
