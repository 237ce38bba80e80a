// SPDX-License-Identifier: GPL-3.0-or-later
// raw
#include "app/common/numbers.h"
#include "app/trexctl/verbs.h"
#include "protocol/codec/packet.h"
#include "protocol/codec/replyparser.h"

#include <CLI/CLI.hpp>

using namespace Qt::Literals::StringLiterals;

namespace trex {
namespace {

constexpr int kMostReplyBytes = 255;
constexpr std::uint8_t kCommandBit = 0x80; // serial protocols 5.b

/// "86", "861F", "0x86", "5": the bytes of one argument; none for what is no hex.
std::optional<QByteArray> bytesFromText(const QString& text)
{
    QByteArray digits = text.toLatin1();
    if (text.startsWith("0x"_L1, Qt::CaseInsensitive)) {
        digits.remove(0, 2);
    }
    const bool isHex = !digits.isEmpty() && std::ranges::all_of(digits, [](char c) {
        return (c >= '0' && c <= '9') || (c >= 'a' && c <= 'f') || (c >= 'A' && c <= 'F');
    });
    if (!isHex || (digits.size() > 1 && digits.size() % 2 != 0)) {
        return std::nullopt;
    }
    return QByteArray::fromHex(digits.size() == 1 ? '0' + digits : digits);
}

class RawVerb : public Verb {
public:
    void declare(CLI::App& app) override
    {
        app.add_option("HEX", m_texts, Cli::tr("bytes in hex: 861F, or 86 1F").toStdString())
            ->required()
            ->type_name("");
        app.add_option_function<std::string>(
               "--reply",
               [this](const std::string& text) { m_replyText = QString::fromStdString(text); },
               Cli::tr("bytes to wait for, without CRC byte; default: as the command says")
                   .toStdString())
            ->type_name("N");
        app.add_flag("--frame", m_isFramed,
                     Cli::tr("as a packet of the chosen form with its CRC: command byte, data")
                         .toStdString());
    }

    [[nodiscard]] Line line() const override { return Line::Open; }

    Checked check(const OpenOptions& options) override
    {
        for (const std::string& text : m_texts) {
            const auto bytes = bytesFromText(QString::fromStdString(text));
            if (!bytes) {
                return usage(Cli::tr("'%1' is not bytes in hex, such as 861F. Nothing was sent.")
                                 .arg(QString::fromStdString(text)));
            }
            m_bytes += *bytes;
        }
        if (m_isFramed) {
            Checked framed = frame(options.line);
            if (!framed) {
                return framed;
            }
        }
        if (!m_replyText.isNull()) {
            return checked(
                numberInRange("--reply", m_replyText, 0, kMostReplyBytes).map([this](int count) {
                    m_replyBytes = count;
                }));
        }
        if (const auto packet = decodePacket(m_bytes, options.line)) {
            m_replyBytes = replyLength(packet->command);
        }
        return {};
    }

    Task run(Session& session) override
    {
        // The gate lets motor commands pass only when it is armed: raw bytes are as deliberate.
        if (const auto armed = session.controller().arm(); !armed) {
            session.fail(armed.error());
            co_return;
        }
        const Reply reply =
            co_await session.need<Reply>([this, &session](const Awaiting<Reply>::Handler& handler) {
                session.controller().requestRaw(m_bytes, m_replyBytes, &session, handler);
            });
        const QString received = toHex(reply.payload);
        session.output().answer(
            QJsonObject{{u"sent"_s, toHex(m_bytes)}, {u"received"_s, received}},
            labelled({{Cli::tr("Sent"), toHex(m_bytes)},
                      {Cli::tr("Received"), received.isEmpty() ? u"–"_s : received}}));
        session.end();
    }

private:
    Checked frame(const LineSettings& line)
    {
        const auto isData = [](char byte) {
            return (static_cast<std::uint8_t>(byte) & kCommandBit) == 0;
        };
        const QByteArray data = m_bytes.sliced(1);
        if (isData(m_bytes.front()) || !std::ranges::all_of(data, isData)) {
            return usage(
                Cli::tr("A packet is a command byte of 80 or more and data bytes below 80. "
                        "Nothing was sent."));
        }
        m_bytes = encode(Command{static_cast<std::uint8_t>(m_bytes.front()), data}, line);
        return {};
    }

    std::vector<std::string> m_texts;
    QString m_replyText;
    bool m_isFramed = false;
    QByteArray m_bytes;
    int m_replyBytes = 0;
};

} // namespace

std::unique_ptr<Verb> makeRaw()
{
    return std::make_unique<RawVerb>();
}

} // namespace trex
