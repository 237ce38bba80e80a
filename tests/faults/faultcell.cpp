// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/faults/faultcell.h"

#include "protocol/codec/replies.h"

#include <algorithm>

namespace trex::test {

using namespace std::chrono_literals;

namespace {

constexpr int kBaud = 115200;
constexpr auto kEpisode = 1500ms; // longer than any of the passing faults
constexpr int kMostOfAnEpisode = 60; // transactions
constexpr auto kHearing = 4ms; // an order on the wire
constexpr auto kRepetition =
    1100ms; // until a stop on a doubtful line has been sent for the last time
// None that has a say in a motor's speed.
constexpr std::array kParameters{0x05, 0x06, 0x0B, 0x0C, 0x0D, 0x01};

sim::SimOptions optionsOf(const LineFault& fault, const LineSettings& line, quint64 seed)
{
    sim::SimOptions options;
    options.pace = true;
    options.baud = line.baud;
    options.errorDetection = line.errorDetection;
    options.echo = fault.kind == LineFault::Kind::Echo;
    options.seed = seed;
    if (fault.kind == LineFault::Kind::Second) {
        options.devices = {kDefaultDeviceNumber, kDefaultDeviceNumber};
        options.faults.unplugged = 1;
    }
    for (int channel = 1; channel <= kChannelCount; ++channel) {
        options.scenario.channels.push_back({.channel = channel, .value = 2600.0 + channel * 111});
    }
    return options;
}

LineSettings settingsOf(PacketForm form, ErrorDetection detection)
{
    LineSettings line;
    line.baud = kBaud;
    line.form = form;
    line.errorDetection = detection;
    return line;
}

} // namespace

CellCounts& CellCounts::operator+=(const CellCounts& other)
{
    for (const auto field :
         {&CellCounts::packets, &CellCounts::right, &CellCounts::wrong, &CellCounts::failed,
          &CellCounts::noReply, &CellCounts::badReplies, &CellCounts::crcErrors,
          &CellCounts::recorded, &CellCounts::misheard, &CellCounts::unstopped,
          &CellCounts::running, &CellCounts::hanging, &CellCounts::unrecovered}) {
        this->*field += other.*field;
    }
    worstRecovery = std::max(worstRecovery, other.worstRecovery);
    return *this;
}

FaultCell::FaultCell(const LineFault& fault, PacketForm form, ErrorDetection detection, Asked asked,
                     quint64 seed)
    : m_fault(fault)
    , m_settings(settingsOf(form, detection))
    , m_asked(asked)
    , m_random(seed)
    , m_link(optionsOf(fault, m_settings, seed), m_settings)
{
    PollWishes wishes{};
    for (const PollRow& row : kPolls) {
        // Where another command is meant, polling goes on beside it, but leaves it the line.
        wishes.at(static_cast<std::size_t>(row.id)) = row.hertz * (asked == Asked::Poll ? 2 : 0.2);
    }
    m_link.engine.setWishes(wishes, m_link.now);
    m_link.onSample = [this](const PollSample& sample) { judge(sample); };
    m_link.onBatch = [this](const LinkBatch& batch) {
        for (const TransactionRecord& record : batch.records) {
            m_counts.recorded += record.error && *record.error != ErrorCode::LineLost ? 1 : 0;
        }
        for (const LinkEvent& event : batch.events) {
            m_wasLost = m_wasLost || event.state == LinkState::Lost;
        }
    };
    if (fault.kind == LineFault::Kind::Second) {
        m_link.line.device(1).setInput({.channel = 1, .value = 4111.0});
        m_link.line.device(1).setInput({.channel = 3, .value = 1999.0});
    }
}

CellCounts FaultCell::run(quint64 packets)
{
    m_link.open();
    while (m_link.stats.transactions < packets) {
        m_link.run(200ms);
        episode();
    }
    takeCounts();
    return m_counts;
}

CellCounts FaultCell::soak(Duration length)
{
    m_link.open();
    for (const Instant end = m_link.now + length; m_link.now < end;) {
        m_link.run(std::chrono::milliseconds(number(1, 120'000)));
        do {
            m_fault = kLineFaults.at(
                static_cast<std::size_t>(number(0, static_cast<int>(kLineFaults.size()) - 1)));
        } while (m_fault.kind == LineFault::Kind::Echo || isSecond());
        m_asked = static_cast<Asked>(number(0, static_cast<int>(kAskedNames.size()) - 1));
        episode();
        m_link.outcomes.clear();
        m_link.events.clear();
    }
    takeCounts();
    return m_counts;
}

void FaultCell::episode()
{
    begin();
    work();
    end();
    recover();
    ++m_episode;
}

void FaultCell::takeCounts()
{
    m_counts.packets = m_link.stats.transactions;
    m_counts.noReply = m_link.stats.timeouts;
    m_counts.badReplies = m_link.stats.badReplies;
    m_counts.crcErrors = m_link.stats.crcErrors;
    m_counts.hanging += static_cast<quint64>(m_link.doubleOutcomes);
}

quint64 FaultCell::samples() const
{
    quint64 all = 0;
    for (const int count : m_link.sampleCounts) {
        all += static_cast<quint64>(count);
    }
    return all;
}

quint64 FaultCell::sent()
{
    quint64 all = 0;
    for (const PollRow& row : kPolls) {
        all += controller().firmware().sent().of(pollCommand(row.id).opcode).count;
    }
    return all;
}

void FaultCell::begin()
{
    m_wasLost = false;
    if (m_fault.kind == LineFault::Kind::OtherSpeed) {
        std::size_t index = static_cast<std::size_t>(m_episode) % (kBaudRates.size() - 1);
        controller().setParameter(
            0x7E, UartSettings{static_cast<int>(index), m_settings.errorDetection, 1}.toRaw());
        m_link.line.powerCycle(m_link.now);
        m_allowed.clear();
    }
    sim::Faults faults;
    if (const auto parts = QByteArray(m_fault.amount).split('='); parts.size() == 2) {
        std::ignore = faults.apply(QString::fromLatin1(parts[0]), parts[1].toDouble());
    }
    m_link.line.setFaults(faults, m_link.now);
}

void FaultCell::end()
{
    if (m_fault.kind == LineFault::Kind::OtherSpeed) {
        controller().setParameter(
            0x7E, UartSettings{baudIndex(kBaud), m_settings.errorDetection, 1}.toRaw());
        m_link.line.powerCycle(m_link.now);
    } else if (m_fault.kind == LineFault::Kind::Reset) {
        m_link.line.powerCycle(m_link.now);
    }
    sim::Faults none;
    none.unplugged = isSecond() ? 1 : 0;
    m_link.line.setFaults(none, m_link.now);
}

void FaultCell::work()
{
    const Instant until = m_link.now + kEpisode;
    for (int i = 0; i < kMostOfAnEpisode && m_link.now < until; ++i) {
        ask();
        watchMotors();
    }
}

/// The fault has ceased: how long until a question is answered, and rightly. What a motor did by an
/// order that the noise made, or that was sent before, ends with the stop.
void FaultCell::recover()
{
    watchMotors();
    const Instant begin = m_link.now;
    bool isBack = false;
    while (!isBack && m_link.now < begin + 3 * kRecoveryBound) {
        const int value = number(0, 0x7F);
        controller().setParameter(kParameters[0], value);
        const auto answer = answerTo(trex::readParameter(kParameters[0]));
        isBack = answer && *answer == QByteArray(1, static_cast<char>(value));
        m_counts.wrong += answer && !isBack ? 1 : 0;
        if (!isBack) {
            m_link.run(2ms);
        }
    }
    m_counts.worstRecovery = std::max(m_counts.worstRecovery, m_link.now - begin);
    m_counts.unrecovered += isBack && m_link.now - begin <= kRecoveryBound ? 0 : 1;
    watchMotors();
    const bool isOrdered = m_asked == Asked::Motor || m_asked == Asked::Stop;
    if (isOrdered && !m_wasLost) {
        sendStop();
    }
    m_link.run(kHearing + kRepetition);
    m_counts.running += outputs() == Speeds{} ? 0 : 1;
    m_allowed.clear();
    controller().clearOutputChanges();
}

void FaultCell::ask()
{
    if (m_link.engine.state() != LinkState::Connected) {
        m_link.run(10ms);
    }
    switch (m_asked) {
    case Asked::Poll:
        m_link.run(25ms);
        return;
    case Asked::ParameterRead:
        return readParameter();
    case Asked::ParameterWrite:
        return writeParameter();
    case Asked::CalibrationWrite:
        return writeCalibration();
    case Asked::Motor:
        return drive();
    case Asked::Stop:
        return stop();
    }
}

/// None: refused or failed, and said so.
std::optional<QByteArray> FaultCell::answerTo(const Command& command)
{
    const auto reply = m_link.ask({.id = ++m_id, .command = command});
    m_counts.hanging += reply ? 0 : 1;
    if (!reply || !*reply) {
        ++m_counts.failed;
        return std::nullopt;
    }
    return (*reply)->payload;
}

void FaultCell::readParameter()
{
    const int parameter =
        kParameters[static_cast<std::size_t>(number(0, static_cast<int>(kParameters.size()) - 1))];
    const int value =
        number(0, 0x7F); // another one each time: an answer to an earlier question shows
    controller().setParameter(parameter, value);
    if (isSecond()) { // 0 with its CRC byte 0 joins with anything to a valid reply
        m_link.line.device(1).setParameter(parameter, number(1, 0x7F));
    }
    if (const auto answer = answerTo(trex::readParameter(static_cast<std::uint8_t>(parameter)))) {
        judge(*answer == QByteArray(1, static_cast<char>(value)));
    }
}

/// As DeviceSettings does it: believed when the reading says so.
void FaultCell::writeParameter()
{
    const auto parameter = static_cast<std::uint8_t>(kParameters[0]);
    const auto value = static_cast<std::uint8_t>(number(0, 0x7F));
    const auto answer = answerTo(trex::writeParameter(parameter, value));
    if (!answer || *answer != QByteArray(1, '\0')) {
        return;
    }
    const auto back = answerTo(trex::readParameter(parameter));
    if (back && *back == QByteArray(1, static_cast<char>(value))) {
        judge(controller().storedParameter(parameter) == value);
    }
}

void FaultCell::writeCalibration()
{
    const int neutral = number(3000, 4000);
    const Calibration wanted{neutral - 900, neutral, neutral + 900, number(10, 120)};
    const auto answer = answerTo(trex::writeCalibration(2, wanted));
    if (!answer || *answer != QByteArray(1, '\0')) {
        return;
    }
    const auto back = answerTo(readCalibration(2));
    if (back && parseCalibration(*back) == wanted) {
        const sim::CalibrationValues held = controller().calibration(InputKind::Rc, 2);
        judge(held.minimum == wanted.minimum && held.neutral == wanted.neutral
              && held.maximum == wanted.maximum && held.deadband == wanted.deadband);
    }
}

void FaultCell::order(const Speeds& speeds)
{
    using Action = MotorOrder::Action;
    m_allowed.push_back(speeds);
    const auto& [first, second, aux] = speeds.values;
    for (const Command& command : {*driveBoth({Action::Set, first}, {Action::Set, second}),
                                   *driveMotor(MotorId::Aux, {Action::Set, aux})}) {
        const auto reply =
            m_link.ask({.id = ++m_id, .command = command, .priority = Priority::Motor});
        m_counts.hanging += reply ? 0 : 1;
        m_counts.failed += reply && !*reply ? 1 : 0;
        m_wasLost = m_wasLost && !(reply && *reply); // they go by this order now
    }
    m_link.run(kHearing);
}

void FaultCell::drive()
{
    order({{number(-127, 127), number(-127, 127), number(0, 127)}});
    watchMotors();
    if (m_allowed.size() > 2) { // a motor may still do what one of the last two orders said
        m_allowed.erase(m_allowed.begin(), m_allowed.end() - 2);
    }
}

void FaultCell::sendStop()
{
    std::vector<Transaction> packets;
    for (const Command& command : stopCommands(false)) {
        packets.push_back({.id = ++m_id, .command = command, .priority = Priority::Stop});
    }
    m_link.engine.stop(packets, m_link.now);
    const Instant end = m_link.now + 2s;
    while (!m_link.outcomes.contains(m_id) && m_link.now < end) {
        m_link.run(1ms);
    }
    m_counts.hanging += m_link.outcomes.contains(m_id) ? 0 : 1;
}

void FaultCell::stop()
{
    m_allowed.clear();
    controller().clearOutputChanges();
    order({{60, -50, 40}});
    watchMotors();
    sendStop();
    m_link.run(300ms); // as long as it may take until it is sent once more
    m_counts.unstopped += outputs() == Speeds{} ? 0 : 1;
    watchMotors();
}

void FaultCell::judge(const PollSample& sample)
{
    switch (sample.poll) {
    case PollId::RawChannels:
        for (int i = 0; i < kChannelCount; ++i) {
            const auto raw = sample.raw.at(static_cast<std::size_t>(i));
            if (raw != 2600 + 111 * (i + 1) && raw != kInvalidPulse) {
                judge(false);
                return;
            }
        }
        return judge(true);
    case PollId::Mode:
        return judge(sample.raw.front() == 'r');
    case PollId::SerialControl:
        return judge(sample.raw.front() == 1);
    default:
        return;
    }
}

/// Any motor at a speed that no order in force gives it.
void FaultCell::watchMotors()
{
    for (const sim::OutputChange& change : controller().outputChanges()) {
        const auto motor = static_cast<std::size_t>(change.motor);
        const int speed = change.output.speed;
        const bool isAllowed =
            speed == 0 || std::ranges::any_of(m_allowed, [&](const Speeds& speeds) {
                return speeds.values.at(motor) == speed;
            });
        m_counts.misheard += isAllowed ? 0 : 1;
    }
    controller().clearOutputChanges();
}

FaultCell::Speeds FaultCell::outputs() const
{
    Speeds speeds;
    const sim::Device& device = m_link.line.device(0);
    for (const MotorId motor : {MotorId::Motor1, MotorId::Motor2, MotorId::Aux}) {
        speeds.values.at(static_cast<std::size_t>(motor)) = device.output(motor).speed;
    }
    return speeds;
}

int FaultCell::number(int from, int to)
{
    return from + static_cast<int>(m_random.next() % static_cast<quint64>(to - from + 1));
}

} // namespace trex::test
