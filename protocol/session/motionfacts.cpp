// SPDX-License-Identifier: GPL-3.0-or-later
#include "protocol/session/motionfacts.h"

#include "protocol/errortext.h"

#include <QCoreApplication>
#include <QStringList>

#include <algorithm>
#include <cstdlib>

namespace trex::motionfacts {

using namespace Qt::Literals::StringLiterals;

namespace {

QString words(const char* text)
{
    return QCoreApplication::translate("MotionReason", text);
}

} // namespace

bool isMoved(const MotorOrder& order)
{
    return order.action != MotorOrder::Action::Brake && order.amount != 0;
}

bool isDriven(const MotionFacts& facts)
{
    return std::any_of(facts.orders.begin(), facts.orders.end(), isMoved);
}

bool hasChannelMode(const MotionFacts& facts)
{
    return facts.mode && !isSerial(*facts.mode);
}

QString orderText(const MotorOrder& order)
{
    const int percent = qRound(std::abs(order.amount) * 100.0 / kFullSpeed);
    if (order.action == MotorOrder::Action::Brake) {
        return words(QT_TRANSLATE_NOOP("MotionReason", "braking %1 %")).arg(percent);
    }
    if (order.amount == 0) {
        return words(QT_TRANSLATE_NOOP("MotionReason", "at zero"));
    }
    return (order.amount > 0 ? words(QT_TRANSLATE_NOOP("MotionReason", "forward %1 %"))
                             : words(QT_TRANSLATE_NOOP("MotionReason", "reverse %1 %")))
        .arg(percent);
}

QString ordersText(const std::array<MotorOrder, 3>& orders)
{
    return words(QT_TRANSLATE_NOOP("MotionReason", "motor 1 %1, motor 2 %2, auxiliary %3"))
        .arg(orderText(orders[0]), orderText(orders[1]), orderText(orders[2]));
}

int missingChannel(const MotionFacts& facts)
{
    if (facts.mode != Mode::Rc || !facts.raw || !facts.requiredChannels) {
        return 0;
    }
    const int needed = *facts.requiredChannels & ~facts.ignoredChannels.value_or(0);
    for (int channel = 1; channel <= kChannelCount; ++channel) {
        if ((needed & (1 << (channel - 1))) != 0
            && facts.raw->at(static_cast<std::size_t>(channel - 1)) == kInvalidPulse) {
            return channel;
        }
    }
    return 0;
}

int remappedOf(const MotionFacts& facts, std::size_t channel)
{
    return facts.remapped
        ? signedFromRemapped(static_cast<std::uint8_t>(facts.remapped->at(channel)))
        : 0;
}

bool doChannelsOrder(const MotionFacts& facts)
{
    return facts.remapped && (remappedOf(facts, 0) != 0 || remappedOf(facts, 1) != 0);
}

bool isWithoutCurrent(const MotionFacts& facts)
{
    return facts.currents && facts.currents->at(0) == 0 && facts.currents->at(1) == 0;
}

bool isSafeStartLikely(const MotionFacts& facts)
{
    return hasChannelMode(facts) && facts.serialControls == false && isWithoutCurrent(facts)
        && (std::abs(remappedOf(facts, 0)) > kNearNeutral
            || std::abs(remappedOf(facts, 1)) > kNearNeutral);
}

bool isLimited(const MotionFacts& facts)
{
    if ((facts.status & kOverCurrent) == 0 || !facts.currentLimits) {
        return false;
    }
    const bool first = (facts.status & kMotor1OverCurrent) != 0;
    return facts.currentLimits->at(first ? 0 : 1) > 0;
}

bool isConnected(const MotionFacts& facts)
{
    return facts.link == LinkState::Connected;
}

bool isDisconnected(const MotionFacts& facts)
{
    return facts.link == LinkState::Disconnected;
}

bool isTrying(const MotionFacts& facts)
{
    return facts.link == LinkState::Lost || facts.link == LinkState::Retrying;
}

bool isBraking(const MotionFacts& facts)
{
    return std::any_of(facts.orders.begin(), facts.orders.end(), [](const MotorOrder& order) {
        return order.action == MotorOrder::Action::Brake && order.amount > 0;
    });
}

bool isDisarmedByHand(const MotionFacts& facts)
{
    const DisarmReason why = facts.disarming.reason;
    return !facts.isArmed
        && (why == DisarmReason::NeverArmed || why == DisarmReason::Person
            || why == DisarmReason::Stop);
}

bool isDisarmedFor(const MotionFacts& facts)
{
    const DisarmReason why = facts.disarming.reason;
    return !facts.isArmed && (why == DisarmReason::Stop || !isDisarmedByHand(facts));
}

int speedOf(const MotorOrder& order)
{
    return isMoved(order) ? std::abs(order.amount) : 0;
}

// What stands in the place of %1, %2 …

QStringList errorWords(const MotionFacts& facts)
{
    return {errorText(*facts.error)};
}

QStringList faultyMotor(const MotionFacts& facts)
{
    return {(facts.status & kMotor1Fault) != 0 ? u"1"_s : u"2"_s};
}

QStringList overCurrentMotor(const MotionFacts& facts)
{
    return {(facts.status & kMotor1OverCurrent) != 0 ? u"1"_s : u"2"_s};
}

QStringList disarmedWords(const MotionFacts& facts)
{
    const QString why = disarmText(facts.disarming.reason);
    return {facts.disarming.detail.isEmpty() ? why : u"%1 (%2)"_s.arg(why, facts.disarming.detail)};
}

QStringList channelOrders(const MotionFacts& facts)
{
    return {orderText({MotorOrder::Action::Set, remappedOf(facts, 0)}),
            orderText({MotorOrder::Action::Set, remappedOf(facts, 1)})};
}

} // namespace trex::motionfacts
