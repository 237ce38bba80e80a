// SPDX-License-Identifier: GPL-3.0-or-later
// Every cause that the why-line can name, from the facts that bear it out.
#include "protocol/session/motionreason.h"

#include <QSet>
#include <QTest>

#include <functional>

using namespace trex;
using namespace Qt::Literals::StringLiterals;

namespace {

constexpr MotorOrder kForward{MotorOrder::Action::Set, 64};

MotionFacts connected()
{
    MotionFacts facts;
    facts.link = LinkState::Connected;
    facts.wasConnected = true;
    facts.mode = Mode::SerialRc;
    facts.serialControls = true;
    return facts;
}

MotionFacts armed()
{
    MotionFacts facts = connected();
    facts.isArmed = true;
    return facts;
}

MotionFacts driving()
{
    MotionFacts facts = armed();
    facts.orders[0] = facts.sent[0] = kForward;
    return facts;
}

MotionFacts inRcMode()
{
    MotionFacts facts = connected();
    facts.mode = Mode::Rc;
    facts.serialControls = false;
    facts.requiredChannels = 1;
    facts.ignoredChannels = 0;
    facts.raw = {3750, 3750, 3750, 3750, 3750};
    facts.remapped = std::array<std::uint16_t, kChannelCount>{};
    facts.currents = std::array<std::uint16_t, 2>{};
    return facts;
}

struct Row {
    const char* name;
    MotionCause cause;
    MotionRemedy remedy;
    const char* part; ///< of the sentence
    std::function<MotionFacts()> facts;
};

const std::vector<Row>& rows()
{
    using C = MotionCause;
    using R = MotionRemedy;
    static const std::vector<Row> kRows{
        {"stop asked", C::StopAsked, R::None, "on its way",
         [] {
             MotionFacts f = driving();
             f.stop = StopProgress::Asked;
             return f;
         }},
        {"stop not confirmed", C::StopFailed, R::Stop, "may still run",
         [] {
             MotionFacts f = connected();
             f.stop = StopProgress::Failed;
             return f;
         }},
        {"stop not confirmed, link gone", C::StopFailed, R::Stop, "may still run",
         [] {
             MotionFacts f = connected();
             f.link = LinkState::Lost;
             f.stop = StopProgress::Failed;
             return f;
         }},
        {"connecting", C::Connecting, R::Disconnect, "ttyUSB9",
         [] {
             MotionFacts f;
             f.link = LinkState::Connecting;
             f.port = u"ttyUSB9"_s;
             return f;
         }},
        {"never found", C::NotFound, R::Disconnect, "Trying again",
         [] {
             MotionFacts f;
             f.link = LinkState::Retrying;
             f.error = Error{ErrorCode::NoReply, {}};
             return f;
         }},
        {"lost", C::LinkLost, R::Disconnect, "not known",
         [] {
             MotionFacts f = connected();
             f.link = LinkState::Lost;
             f.error = Error{ErrorCode::LineLost, {}};
             return f;
         }},
        {"lost, no reason", C::LinkLost, R::Disconnect, "not known",
         [] {
             MotionFacts f = connected();
             f.link = LinkState::Retrying;
             return f;
         }},
        {"could not connect", C::LinkError, R::Connect, "",
         [] {
             MotionFacts f;
             f.error = Error{ErrorCode::PortMissing, u"ttyUSB9"_s};
             return f;
         }},
        {"not connected", C::NotConnected, R::Connect, "Not connected",
         [] { return MotionFacts(); }},
        {"watchdog proof", C::Proving, R::Stop, "on purpose",
         [] {
             MotionFacts f = driving();
             f.isProving = true;
             return f;
         }},
        {"stall guard", C::StallGuard, R::Stop, "Stall guard",
         [] {
             MotionFacts f = driving();
             f.isRampingDown = true;
             return f;
         }},
        {"locked out", C::LockedOut, R::Arm, "half a second",
         [] {
             MotionFacts f = connected();
             f.isLockedOut = f.isJustStopped = true;
             f.disarming.reason = DisarmReason::Stop;
             f.stop = StopProgress::Sent;
             return f;
         }},
        {"stopped", C::Stopped, R::Arm, "Arm to drive again",
         [] {
             MotionFacts f = connected();
             f.isJustStopped = true;
             f.disarming.reason = DisarmReason::Stop;
             f.stop = StopProgress::Sent;
             return f;
         }},
        {"driver fault", C::DriverFault, R::OpenPanel, "Motor 2",
         [] {
             MotionFacts f = armed();
             f.status = 0x40;
             return f;
         }},
        {"required channel", C::RequiredChannelMissing, R::OpenPanel, "channel 1 is required",
         [] {
             MotionFacts f = inRcMode();
             f.raw->at(0) = kInvalidPulse;
             return f;
         }},
        {"override by channel 5", C::OverrideActive, R::Arm, "channel 5",
         [] {
             MotionFacts f = inRcMode();
             f.serialControls = true;
             return f;
         }},
        {"safe-start, channel 2", C::SafeStart, R::OpenPanel, "channel 2",
         [] {
             MotionFacts f = inRcMode();
             f.remapped->at(1) = 40 | 0x80;
             return f;
         }},
        {"command pending", C::CommandPending, R::Disarm, "serial takes over",
         [] {
             MotionFacts f = driving();
             f.serialControls = false;
             return f;
         }},
        {"armed, not in control", C::ArmedWithoutControl, R::Disarm, "mode jumper",
         [] {
             MotionFacts f = armed();
             f.serialControls = false;
             return f;
         }},
        {"the channels drive", C::ChannelsDrive, R::OpenPanel, "motor 1 reverse 31 %",
         [] {
             MotionFacts f = inRcMode();
             f.remapped->at(0) = 40 | 0x80;
             f.currents = std::array<std::uint16_t, 2>{12, 0};
             return f;
         }},
        {"the channels control", C::ChannelsControl, R::OpenPanel, "RC or analog mode",
         [] { return inRcMode(); }},
        {"timeout latched", C::TimeoutLatched, R::Arm, "serial timeout",
         [] {
             MotionFacts f = connected();
             f.uart = 0x80;
             return f;
         }},
        {"shutdown for a UART error", C::UartShutdown, R::OpenPanel, "set to stop",
         [] {
             MotionFacts f = driving();
             f.uart = 0x10;
             f.uartErrorShutdown = 1;
             return f;
         }},
        {"held back", C::CurrentLimited, R::OpenPanel, "Motor 2 is held back",
         [] {
             MotionFacts f = driving();
             f.status = 0x80;
             f.currentLimits = {0, 20};
             return f;
         }},
        {"over current", C::OverCurrent, R::OpenPanel, "Motor 1 drew",
         [] {
             MotionFacts f = driving();
             f.status = 0x20;
             return f;
         }},
        {"disarmed for a reason", C::DisarmedFor, R::Arm, "screen was locked",
         [] {
             MotionFacts f = connected();
             f.disarming = {DisarmReason::SessionLocked, {}, {}};
             return f;
         }},
        {"disarmed for a reason with a detail", C::DisarmedFor, R::Arm, "(motor 1)",
         [] {
             MotionFacts f = connected();
             f.disarming = {DisarmReason::MotorFault, u"motor 1"_s, {}};
             return f;
         }},
        {"disarmed", C::Disarmed, R::Arm, "nothing is sent", [] { return connected(); }},
        {"joint mode", C::JointMode, R::OpenPanel, "motor 2 do nothing",
         [] {
             MotionFacts f = armed();
             f.isJoint = true;
             f.orders[1] = f.sent[1] = kForward;
             return f;
         }},
        {"braking", C::Braking, R::Disarm, "braking 100 %",
         [] {
             MotionFacts f = armed();
             f.orders[0] = f.sent[0] = {MotorOrder::Action::Brake, 127};
             return f;
         }},
        {"on a ramp", C::Ramping, R::Disarm, "forward 25 %",
         [] {
             MotionFacts f = driving();
             f.sent[0].amount = 32;
             return f;
         }},
        {"no current", C::NoCurrent, R::Disarm, "inferred",
         [] {
             MotionFacts f = driving();
             f.isSettled = true;
             f.currents = std::array<std::uint16_t, 2>{};
             return f;
         }},
        {"driving", C::Driving, R::Disarm, "motor 1 forward 50 %",
         [] {
             MotionFacts f = driving();
             f.currents = std::array<std::uint16_t, 2>{20, 0};
             return f;
         }},
        {"armed", C::Armed, R::Disarm, "Esc stops", [] { return armed(); }},
    };
    return kRows;
}

} // namespace

class TestMotionReason : public QObject {
    Q_OBJECT

private slots:
    void facts_giveTheirCause_data()
    {
        QTest::addColumn<int>("index");
        for (std::size_t i = 0; i < rows().size(); ++i) {
            QTest::newRow(rows().at(i).name) << static_cast<int>(i);
        }
    }

    void facts_giveTheirCause()
    {
        QFETCH(int, index);
        const Row& row = rows().at(static_cast<std::size_t>(index));
        const MotionReason reason = motionReason(row.facts());
        QVERIFY2(reason.cause == row.cause, qPrintable(reason.sentence));
        QVERIFY2(reason.sentence.contains(QLatin1StringView(row.part)),
                 qPrintable(reason.sentence));
        QVERIFY(!reason.sentence.contains(u'%' + u"1"_s));
        QCOMPARE(static_cast<int>(reason.remedy), static_cast<int>(row.remedy));
        QCOMPARE(reason.panel.isEmpty(), row.remedy != MotionRemedy::OpenPanel);
        // What is inferred about the device is marked, and nothing else is.
        QCOMPARE(reason.isGuess, reason.sentence.contains("(inferred)"_L1));
    }

    void everyCause_isCovered()
    {
        QSet<int> seen;
        for (const Row& row : rows()) {
            seen.insert(static_cast<int>(row.cause));
        }
        QCOMPARE(seen.size(), kMotionCauseCount);
    }

    void unknown_isNeverAssumed()
    {
        // Right after the connection: neither mode, nor control, nor channels are known.
        MotionFacts facts;
        facts.link = LinkState::Connected;
        QCOMPARE(static_cast<int>(motionReason(facts).cause),
                 static_cast<int>(MotionCause::Disarmed));
        facts.isArmed = true;
        facts.orders[0] = facts.sent[0] = kForward;
        QCOMPARE(static_cast<int>(motionReason(facts).cause),
                 static_cast<int>(MotionCause::Driving));
    }
};

QTEST_GUILESS_MAIN(TestMotionReason)
#include "tst_motionreason.moc"
