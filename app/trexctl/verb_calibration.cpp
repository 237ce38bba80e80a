// SPDX-License-Identifier: GPL-3.0-or-later
// calibration get, calibration set
#include "app/common/numbers.h"
#include "app/trexctl/calibrationtext.h"
#include "app/trexctl/verbs.h"
#include "protocol/codec/replies.h"

#include <CLI/CLI.hpp>

using namespace Qt::Literals::StringLiterals;

namespace trex {
namespace {

Result<int> channelFromText(const std::string& text)
{
    return numberInRange("channel", QString::fromStdString(text), 1, kChannelCount);
}

bool isLearned(const Reply& learned, int channel)
{
    return (static_cast<std::uint8_t>(learned.payload.front()) >> (channel - 1) & 1) != 0;
}

class CalibrationGetVerb : public Verb {
public:
    [[nodiscard]] bool usesSettings() const override { return true; }
    void declare(CLI::App& app) override
    {
        app.add_option("N", m_channelText, Cli::tr("channel 1 to 5; default: all").toStdString())
            ->type_name("");
    }

    Checked check(const OpenOptions&) override
    {
        if (m_channelText.empty()) {
            m_channels = {1, 2, 3, 4, 5};
            return {};
        }
        return checked(
            channelFromText(m_channelText).map([this](int channel) { m_channels = {channel}; }));
    }

    Task run(Session& session) override
    {
        const Reply modeReply = co_await session.ask(query("get-mode"));
        const auto mode = parseMode(modeReply.payload);
        if (!mode) {
            session.fail(mode.error());
            co_return;
        }
        const Reply learned = co_await session.ask(query("get-learned"));
        std::vector<CalibrationEntry> entries;
        for (const int channel : m_channels) {
            const Reply reply = co_await session.ask(readCalibration(channel));
            entries.push_back({channel, inputOf(*mode), parseCalibration(reply.payload),
                               isLearned(learned, channel)});
        }
        session.output().answer(toJson(entries), toText(entries));
        session.end();
    }

private:
    std::string m_channelText;
    std::vector<int> m_channels;
};

class CalibrationSetVerb : public Verb {
public:
    [[nodiscard]] bool usesSettings() const override { return true; }
    void declare(CLI::App& app) override
    {
        const std::array<std::pair<const char*, QString>, 5> arguments{
            {{"N", Cli::tr("channel 1 to 5")},
             {"MIN", Cli::tr("raw: 0.4 µs or 10-bit counts, by the input set in force")},
             {"NEUTRAL", Cli::tr("MIN to MAX")},
             {"MAX", Cli::tr("above MIN, at most 16383")},
             {"DEADBAND", Cli::tr("on both sides of neutral")}}};
        for (std::size_t i = 0; i < arguments.size(); ++i) {
            app.add_option(arguments.at(i).first, m_texts.at(i),
                           arguments.at(i).second.toStdString())
                ->required()
                ->type_name("");
        }
    }

    Checked check(const OpenOptions&) override
    {
        const auto channel = channelFromText(m_texts[0]);
        if (!channel) {
            return checked(channel);
        }
        m_channel = *channel;
        constexpr std::array<std::pair<std::string_view, int Calibration::*>, 4> kFields{
            {{"minimum", &Calibration::minimum},
             {"neutral", &Calibration::neutral},
             {"maximum", &Calibration::maximum},
             {"deadband", &Calibration::deadband}}};
        for (std::size_t i = 0; i < kFields.size(); ++i) {
            const auto value =
                numberInRange(kFields.at(i).first, QString::fromStdString(m_texts.at(i + 1)), 0,
                              kLargestCalibrationValue);
            if (!value) {
                return checked(value);
            }
            m_wanted.*kFields.at(i).second = *value;
        }
        return checked(validate(m_wanted));
    }

    Task run(Session& session) override
    {
        using Write = DeviceSettings::CalibrationWrite;
        const Reply modeReply = co_await session.ask(query("get-mode"));
        const auto mode = parseMode(modeReply.payload);
        if (!mode) {
            session.fail(mode.error());
            co_return;
        }
        const Write write =
            co_await session.need<Write>([this, &session](const Awaiting<Write>::Handler& handler) {
                session.settings().writeCalibration(m_channel, m_wanted, &session, handler);
            });
        const Reply learned = co_await session.ask(query("get-learned"));
        const CalibrationEntry entry{m_channel, inputOf(*mode), write.readBack,
                                     isLearned(learned, m_channel)};
        QJsonObject json = toJson(entry);
        // Read back as written: with the other byte order the nearest value that it can take.
        json.insert(u"verified"_s, write.verified || write.eightBitBytes);
        session.output().answer(json, toText({entry}));
        if (write.eightBitBytes) {
            session.warn(Cli::tr("This controller joins calibration bytes as low + 256 × high: the "
                                 "nearest values that can be sent that way are written."));
        }
        session.end();
    }

private:
    std::array<std::string, 5> m_texts;
    int m_channel = 1;
    Calibration m_wanted;
};

} // namespace

std::unique_ptr<Verb> makeCalibrationGet()
{
    return std::make_unique<CalibrationGetVerb>();
}

std::unique_ptr<Verb> makeCalibrationSet()
{
    return std::make_unique<CalibrationSetVerb>();
}

} // namespace trex
