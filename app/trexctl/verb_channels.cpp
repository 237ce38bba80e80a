// SPDX-License-Identifier: GPL-3.0-or-later
// channels
#include "app/common/numbers.h"
#include "app/trexctl/controllertext.h"
#include "app/trexctl/streamverb.h"
#include "app/trexctl/verbs.h"

#include <CLI/CLI.hpp>

using namespace Qt::Literals::StringLiterals;

namespace trex {
namespace {

struct ChannelReading {
    int channel = 1;
    int raw = 0;
    int remapped = 0;
};

class ChannelsVerb : public StreamVerb {
public:
    void declare(CLI::App& app) override
    {
        app.add_option_function<std::string>(
               "--mask",
               [this](const std::string& text) { m_maskText = QString::fromStdString(text); },
               Cli::tr("channels: bit 0 is channel 1; default 0x1F, all").toStdString())
            ->type_name("N");
        StreamVerb::declare(app);
    }

    Checked check(const OpenOptions& options) override
    {
        if (!m_maskText.isNull()) {
            const auto mask = numberInRange("--mask", m_maskText, 1, kAllChannelsMask);
            if (!mask) {
                return checked(mask);
            }
            m_mask = static_cast<std::uint8_t>(*mask);
        }
        return StreamVerb::check(options);
    }

protected:
    Command firstQuestion() const override { return query("get-mode"); }

    bool begin(Session& session, const Reply& answer) override
    {
        const auto mode = parseMode(answer.payload);
        if (!mode) {
            session.fail(mode.error());
            return false;
        }
        m_input = inputOf(*mode);
        return true;
    }

    std::vector<Command> questions() const override
    {
        return {channelsQuery("get-raw-channels", m_mask),
                channelsQuery("get-remapped-channels", m_mask)};
    }

    void print(Session& session, double seconds, const std::vector<Reply>& replies) override
    {
        const auto readings = decode(replies[0].payload, replies[1].payload);
        Output& output = session.output();
        if (output.isJson()) {
            output.json(json(seconds, readings));
        } else {
            output.text(isWatching() ? row(seconds, readings) : table(readings));
        }
    }

private:
    std::vector<ChannelReading> decode(const QByteArray& raw, const QByteArray& remapped) const
    {
        std::vector<ChannelReading> readings;
        for (int channel = 1; channel <= kChannelCount; ++channel) {
            if ((m_mask >> (channel - 1) & 1) == 0) {
                continue;
            }
            const auto index = static_cast<qsizetype>(readings.size());
            readings.push_back({channel,
                                rawOf(commandfields::kRaw.front(), raw.constData() + 2 * index),
                                signedFromRemapped(static_cast<std::uint8_t>(remapped[index]))});
        }
        return readings;
    }

    /// An invalid pulse is no number (conformance C-24); analog inputs cannot be invalid.
    bool isValid(const ChannelReading& reading) const
    {
        return m_input == InputKind::Analog || reading.raw != kInvalidPulse;
    }

    QJsonObject json(double seconds, const std::vector<ChannelReading>& readings) const
    {
        QJsonArray channels;
        for (const auto& reading : readings) {
            QJsonObject channel{{u"channel"_s, reading.channel},
                                {u"raw"_s, reading.raw},
                                {u"valid"_s, isValid(reading)},
                                {u"remapped"_s, reading.remapped}};
            if (m_input == InputKind::Analog) {
                channel.insert(u"volts"_s, rounded(voltsFromRaw(reading.raw), 4));
            } else if (isValid(reading)) {
                channel.insert(u"microseconds"_s, rounded(microsecondsFromRaw(reading.raw), 1));
            }
            channels.append(channel);
        }
        return {{u"t"_s, rounded(seconds, 4)},
                {u"input"_s, m_input == InputKind::Rc ? u"rc"_s : u"analog"_s},
                {u"channels"_s, channels}};
    }

    QString physical(const ChannelReading& reading) const
    {
        if (!isValid(reading)) {
            return Cli::tr("no pulse");
        }
        return m_input == InputKind::Analog
            ? u"%1 V"_s.arg(voltsFromRaw(reading.raw), 0, 'f', 2)
            : u"%1 ms"_s.arg(millisecondsFromRaw(reading.raw), 0, 'f', 3);
    }

    QString table(const std::vector<ChannelReading>& readings) const
    {
        TextTable text({Cli::tr("Channel"), Cli::tr("Input"), Cli::tr("Raw"), Cli::tr("Remapped")});
        for (const auto& reading : readings) {
            text.add({QString::number(reading.channel), physical(reading),
                      isValid(reading) ? QString::number(reading.raw) : u"–"_s,
                      QString::number(reading.remapped)});
        }
        return text.text();
    }

    QString row(double seconds, const std::vector<ChannelReading>& readings) const
    {
        QString text = u"%1 s"_s.arg(seconds, 9, 'f', 3);
        for (const auto& reading : readings) {
            text += u"   %1: %2 %3"_s.arg(reading.channel)
                        .arg(physical(reading), 8)
                        .arg(reading.remapped, 4);
        }
        return text;
    }

    QString m_maskText;
    std::uint8_t m_mask = kAllChannelsMask;
    InputKind m_input = InputKind::Rc;
};

} // namespace

std::unique_ptr<Verb> makeChannels()
{
    return std::make_unique<ChannelsVerb>();
}

} // namespace trex
