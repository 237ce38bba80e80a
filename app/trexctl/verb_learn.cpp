// SPDX-License-Identifier: GPL-3.0-or-later
// calibration learn
#include "app/common/numbers.h"
#include "app/trexctl/calibrationtext.h"
#include "app/trexctl/terminal.h"
#include "app/trexctl/verbs.h"
#include "protocol/errortext.h"
#include "protocol/procedures/calibrationfeed.h"
#include "protocol/procedures/calibrationtext.h"

#include <CLI/CLI.hpp>

using namespace Qt::Literals::StringLiterals;
using namespace std::chrono_literals;

namespace trex {
namespace {

using Step = ChannelCalibration::Step;

constexpr auto kLook = 50ms; // how often the procedure's state is looked at
constexpr double kLongestNeutralSeconds = 60.0;
constexpr double kLongestSweepSeconds = 600.0;
constexpr double kUsualSweepSeconds = 6.0;
// How much longer than asked for a rest or a full sweep is waited before it is given up.
constexpr auto kPatience = 20s;
constexpr auto kReadBackPatience = 3s; // after a write that failed, to say what is held

Instant clockNow()
{
    return std::chrono::steady_clock::now();
}

Duration toDuration(double seconds)
{
    return std::chrono::duration_cast<Duration>(std::chrono::duration<double>(seconds));
}

class LearnVerb : public Verb {
public:
    [[nodiscard]] bool usesSettings() const override { return true; }
    void declare(CLI::App& app) override
    {
        const auto add = [&app](const char* name, const char* unit, QString& target,
                                const QString& help) {
            app.add_option_function<std::string>(
                   name,
                   [&target](const std::string& text) { target = QString::fromStdString(text); },
                   help.toStdString())
                ->type_name(unit);
        };
        add("--channels", "LIST", m_channelsText, Cli::tr("such as 1,2; default: all five"));
        add("--neutral-seconds", "S", m_neutralText, Cli::tr("rest needed for neutral; default 2"));
        add("--sweep-seconds", "S", m_sweepText, Cli::tr("least time for the extremes; default 6"));
        app.add_flag("--yes", m_isConfirmed,
                     Cli::tr("ask nothing: start at once, and write at the end").toStdString());
    }

    Checked check(const OpenOptions&) override
    {
        return readChannels()
            .and_then([this] { return readSeconds(); })
            .and_then([this]() -> Checked {
                if (!m_isConfirmed && !isAtTerminal()) {
                    return usage(Cli::tr("A calibration asks before it writes: use a terminal, or "
                                         "--yes. Nothing was sent."));
                }
                return {};
            });
    }

    Task run(Session& session) override
    {
        const Reply modeReply = co_await session.ask(query("get-mode"));
        const auto mode = parseMode(modeReply.payload);
        if (!mode) {
            session.fail(mode.error());
            co_return;
        }
        if (!isSerial(*mode)) {
            // The same warning as the panel gives, in the failure's one line.
            session.fail(Failure{exitcode::kRefused,
                                 errorText(Error{ErrorCode::NotInSerialMode, {}}) + u' '
                                     + Cli::tr("In this mode the sticks also move the motors: "
                                               "keep the motors' power off.")});
            co_return;
        }
        startCalibration(session);
        while (m_calibration->step() == Step::Choose && !m_result) {
            co_await session.sleepUntil(clockNow() + kLook);
        }
        guide(session, Cli::tr("Neutral: leave all sticks and switches at rest and let go."));
        const Instant neutralEnd = clockNow() + 2 * toDuration(m_neutralSeconds) + kPatience;
        while (m_calibration->step() == Step::Neutral && !m_calibration->canContinue()
               && clockNow() < neutralEnd) {
            co_await session.sleepUntil(clockNow() + kLook);
        }
        if (m_calibration->step() == Step::Neutral && !m_calibration->canContinue()) {
            giveUp(session, nothingWritten(m_calibration->whyNot()));
            co_return;
        }
        m_calibration->next();
        guide(session,
              Cli::tr("Extremes: move every stick and switch to all its ends, and hold it at each "
                      "for a second."));
        const Instant sweepBegin = clockNow();
        const Instant sweepLeast = sweepBegin + toDuration(m_sweepSeconds);
        while (m_calibration->step() == Step::Extremes
               && (clockNow() < sweepLeast || !m_calibration->canContinue())
               && clockNow() < sweepLeast + kPatience) {
            co_await session.sleepUntil(clockNow() + kLook);
        }
        m_calibration->finishExtremes();
        if (m_calibration->step() == Step::Review) {
            if (const QString reason = unlearned(); !reason.isEmpty()) {
                giveUp(session, nothingWritten(reason));
                co_return;
            }
            guide(session, confidence());
            guide(session, toText(entries(*mode, 0), false));
            if (!m_isConfirmed && !co_await confirmed(session)) {
                giveUp(session, Cli::tr("Not confirmed. Nothing was written."), exitcode::kUsage);
                co_return;
            }
            m_calibration->next();
        }
        while (!m_result) {
            co_await session.sleepUntil(clockNow() + kLook);
        }
        if (!*m_result) {
            const Instant readBackEnd = clockNow() + kReadBackPatience;
            while (m_calibration->isReadingBack() && clockNow() < readBackEnd) {
                co_await session.sleepUntil(clockNow() + kLook);
            }
            session.fail(Failure{exitCodeOf(m_result->error().code), m_calibration->outcomeText()});
            co_return;
        }
        const Reply learned = co_await session.ask(query("get-learned"));
        const auto mask = static_cast<std::uint8_t>(learned.payload.front());
        session.output().answer(toJson(entries(*mode, mask)), toText(entries(*mode, mask)));
        tellWhatIsNotAsAsked(session);
        session.end();
    }

    void interrupted(Session& session) override
    {
        if (m_calibration && m_calibration->step() == Step::Writing) {
            m_calibration->cancel(); // ends behind the channel being written, and says which
        } else {
            Verb::interrupted(session);
        }
    }

private:
    Checked readChannels()
    {
        if (m_channelsText.isNull()) {
            return {};
        }
        m_mask = 0;
        const QStringList parts = m_channelsText.split(u',');
        for (const QString& part : parts) {
            const auto channel = numberInRange("--channels", part, 1, kChannelCount);
            if (!channel) {
                return checked(channel);
            }
            m_mask = static_cast<std::uint8_t>(m_mask | 1U << (*channel - 1));
        }
        return {};
    }

    Checked readSeconds()
    {
        if (!m_neutralText.isNull()) {
            const auto seconds =
                positiveNumber("--neutral-seconds", m_neutralText, kLongestNeutralSeconds);
            if (!seconds) {
                return checked(seconds);
            }
            m_neutralSeconds = *seconds;
        }
        if (!m_sweepText.isNull()) {
            return checked(positiveNumber("--sweep-seconds", m_sweepText, kLongestSweepSeconds)
                               .map([this](double seconds) { m_sweepSeconds = seconds; }));
        }
        return {};
    }

    static Required<bool> confirmed(Session& session)
    {
        return session.need<bool>([&session](const Awaiting<bool>::Handler& handler) {
            confirmLater(Cli::tr("Write these calibrations to the controller?"), &session,
                         [handler](bool isYes) { handler(isYes); });
        });
    }

    void startCalibration(Session& session)
    {
        m_calibration =
            std::make_unique<ChannelCalibration>(session.controller(), session.settings());
        m_feed = std::make_unique<RequestFeed>(session.controller(), *m_calibration);
        QObject::connect(m_calibration.get(), &Procedure::finished, &session,
                         [this](const Result<void>& result) { m_result = result; });
        m_calibration->setChannels(m_mask);
        m_calibration->setStillTime(toDuration(m_neutralSeconds));
        m_calibration->setOptionalSteps(false); // neutral, extremes, summary (contract)
        m_calibration->start();
    }

    /// For a person who watches; a script's stderr stays clean.
    static void guide(Session& session, const QString& text)
    {
        if (isAtTerminal()) {
            const QStringList lines = text.split(u'\n');
            for (const QString& line : lines) {
                session.tell(line);
            }
        }
    }

    static QString nothingWritten(const QString& reason)
    {
        return Cli::tr("%1 Nothing was written; --channels chooses the channels.").arg(reason);
    }

    void giveUp(Session& session, const QString& reason, int exitCode = exitcode::kNoReply)
    {
        if (!m_result) {
            m_calibration->cancel();
        }
        session.fail(Failure{exitCode, reason});
    }

    /// Why the first chosen channel that could not be learned was not.
    QString unlearned() const
    {
        for (int channel = 1; channel <= kChannelCount; ++channel) {
            const LearnedChannel* learned = m_calibration->learned(channel);
            if (learned != nullptr && learned->verdict == Verdict::DoAgain) {
                return Cli::tr("Channel %1: %2")
                    .arg(channel)
                    .arg(reasonText(*learned, m_calibration->input()));
            }
        }
        return {};
    }

    /// Verdict, reason and figures of each channel, for a person to decide by.
    QString confidence() const
    {
        QStringList lines;
        for (int channel = 1; channel <= kChannelCount; ++channel) {
            if (const LearnedChannel* learned = m_calibration->learned(channel)) {
                const InputKind input = m_calibration->input();
                lines << Cli::tr("Channel %1: %2. %3")
                             .arg(channel)
                             .arg(verdictText(learned->verdict), reasonText(*learned, input));
                const QStringList figures = figuresText(*learned, input).split(u'\n');
                for (const QString& figure : figures) {
                    lines << u"  "_s + figure;
                }
            }
        }
        return lines.join(u'\n');
    }

    /// For a script, too: what is worth looking at, and values that are only near those learned.
    void tellWhatIsNotAsAsked(Session& session) const
    {
        std::uint8_t nearest = 0;
        for (int channel = 1; channel <= kChannelCount; ++channel) {
            const LearnedChannel* learned = m_calibration->learned(channel);
            if (learned == nullptr) {
                continue;
            }
            if (learned->verdict == Verdict::Usable) {
                session.warn(Cli::tr("Channel %1: %2")
                                 .arg(channel)
                                 .arg(reasonText(*learned, m_calibration->input())));
            }
            const bool isNear = m_calibration->readBack(channel).value_or(learned->calibration)
                != learned->calibration;
            nearest = static_cast<std::uint8_t>(nearest | (isNear ? 1U << (channel - 1) : 0U));
        }
        if (nearest != 0) {
            session.warn(Cli::tr("This controller joins calibration bytes as low + 256 × high: "
                                 "channels %1 hold the nearest values that can be sent that way, "
                                 "read back.")
                             .arg(channelListText(nearest)));
        }
    }

    std::vector<CalibrationEntry> entries(Mode mode, std::uint8_t learnedMask) const
    {
        std::vector<CalibrationEntry> all;
        for (int channel = 1; channel <= kChannelCount; ++channel) {
            const LearnedChannel* learned = m_calibration->learned(channel);
            if (learned != nullptr) {
                all.push_back({channel, inputOf(mode),
                               m_calibration->readBack(channel).value_or(learned->calibration),
                               (learnedMask >> (channel - 1) & 1) != 0});
            }
        }
        return all;
    }

    QString m_channelsText;
    QString m_neutralText;
    QString m_sweepText;
    bool m_isConfirmed = false;
    std::uint8_t m_mask = kAllChannelsMask;
    double m_neutralSeconds =
        std::chrono::duration<double>(CalibrationLearner::kDefaultStillTime).count();
    double m_sweepSeconds = kUsualSweepSeconds;
    std::unique_ptr<ChannelCalibration> m_calibration;
    std::unique_ptr<RequestFeed> m_feed;
    std::optional<Result<void>> m_result;
};

} // namespace

std::unique_ptr<Verb> makeCalibrationLearn()
{
    return std::make_unique<LearnVerb>();
}

} // namespace trex
