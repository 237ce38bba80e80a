// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/status/statuspanel.h"

#include "protocol/session/controller.h"
#include "widgets/common/indicator.h"
#include "widgets/common/theme.h"

#include <QCoreApplication>
#include <QGridLayout>
#include <QLabel>
#include <QLocale>
#include <QPushButton>

#include <array>

namespace trex {

using namespace Qt::Literals::StringLiterals;
using namespace std::chrono_literals;

namespace {

// A latched bit is lit for one read only, since reading clears it; a person needs longer to see it.
constexpr qint64 kLitMs = 1500;

struct LampRow {
    QLatin1StringView name;
    const char* label;
    StatusLatch::Byte byte;
    std::uint8_t mask;
    Indicator::Meaning meaning;
};

using enum Indicator::Meaning;
constexpr auto kStatus = StatusLatch::Byte::Status;
constexpr auto kUart = StatusLatch::Byte::Uart;

// clang-format off
constexpr std::array kLamps {
    LampRow {"status.motor1Fault"_L1,            QT_TRANSLATE_NOOP("trex::StatusPanel", "Motor 1 fault"),        kStatus, statusbit::kMotor1Fault,       Fault},
    LampRow {"status.motor1OverCurrent"_L1,      QT_TRANSLATE_NOOP("trex::StatusPanel", "Motor 1 over limit"),   kStatus, statusbit::kMotor1OverCurrent, Warning},
    LampRow {"status.motor2Fault"_L1,            QT_TRANSLATE_NOOP("trex::StatusPanel", "Motor 2 fault"),        kStatus, statusbit::kMotor2Fault,       Fault},
    LampRow {"status.motor2OverCurrent"_L1,      QT_TRANSLATE_NOOP("trex::StatusPanel", "Motor 2 over limit"),   kStatus, statusbit::kMotor2OverCurrent, Warning},
    LampRow {"status.uartError"_L1,              QT_TRANSLATE_NOOP("trex::StatusPanel", "UART error"),           kStatus, statusbit::kUartError,         Warning},
    LampRow {"status.uart.timeout"_L1,           QT_TRANSLATE_NOOP("trex::StatusPanel", "Serial timeout"),       kUart,   uartbit::kTimeout,             Fault},
    LampRow {"status.uart.format"_L1,            QT_TRANSLATE_NOOP("trex::StatusPanel", "Packet format"),        kUart,   uartbit::kFormat,              Warning},
    LampRow {"status.uart.crc"_L1,               QT_TRANSLATE_NOOP("trex::StatusPanel", "CRC"),                  kUart,   uartbit::kCrc,                 Warning},
    LampRow {"status.uart.frame"_L1,             QT_TRANSLATE_NOOP("trex::StatusPanel", "Frame"),                kUart,   uartbit::kFrame,               Warning},
    LampRow {"status.uart.overrun"_L1,           QT_TRANSLATE_NOOP("trex::StatusPanel", "Data overrun"),         kUart,   uartbit::kOverrun,             Warning},
    LampRow {"status.uart.parity"_L1,            QT_TRANSLATE_NOOP("trex::StatusPanel", "Parity"),               kUart,   uartbit::kParity,              Warning},
    LampRow {"status.uart.readBufferOverrun"_L1, QT_TRANSLATE_NOOP("trex::StatusPanel", "Read buffer overrun"),  kUart,   uartbit::kReadBufferOverrun,   Warning},
    LampRow {"status.uart.sendBufferOverrun"_L1, QT_TRANSLATE_NOOP("trex::StatusPanel", "Send buffer overrun"),  kUart,   uartbit::kSendBufferOverrun,   Warning},
};
// clang-format on

int bitOf(std::uint8_t mask)
{
    int bit = 0;
    while ((mask >> bit & 1) == 0) {
        ++bit;
    }
    return bit;
}

const QString kAbsent = u"–"_s;

} // namespace

QString modeText(Mode mode)
{
    switch (mode) {
    case Mode::Rc:
        return StatusPanel::tr("RC");
    case Mode::Analog:
        return StatusPanel::tr("Analog");
    case Mode::SerialRc:
        return StatusPanel::tr("Serial (RC)");
    case Mode::SerialAnalog:
        return StatusPanel::tr("Serial (analog)");
    }
    return {};
}

StatusPanel::StatusPanel(PanelContext& context, QWidget* parent)
    : Panel(context, parent), m_fade(this)
{
    auto* grid = new QGridLayout(this);
    grid->setContentsMargins(8, 8, 8, 8);
    grid->setHorizontalSpacing(8);
    grid->setVerticalSpacing(4);
    m_signature = addFact(*grid, tr("Signature"), u"status.signature"_s);
    m_firmware = addFact(*grid, tr("Firmware"), u"status.firmware"_s);
    m_mode = addFact(*grid, tr("Mode"), u"status.mode"_s);
    m_control = addFact(*grid, tr("Motors follow"), u"status.serialControls"_s);
    m_learned = addFact(*grid, tr("Calibrated"), u"status.calibrated"_s);
    grid->setColumnStretch(1, 1);
    addLamps(*grid, grid->rowCount());

    m_fade.setInterval(250ms);
    connect(&m_fade, &QTimer::timeout, this, &StatusPanel::refreshLamps);
    connect(&context.controller, &Controller::deviceChanged, this, &StatusPanel::refreshFacts);
    connect(&context.controller, &Controller::stateChanged, this, &StatusPanel::refreshFacts);
    connect(&context.latch, &StatusLatch::changed, this, &StatusPanel::refreshLamps);
    refreshFacts();
    refreshLamps();
}

QLabel* StatusPanel::addFact(QGridLayout& grid, const QString& title, const QString& name)
{
    auto* caption = new QLabel(title, this);
    caption->setForegroundRole(QPalette::PlaceholderText);
    auto* fact = named(new QLabel(kAbsent, this), name, title);
    fact->setTextInteractionFlags(Qt::TextSelectableByMouse | Qt::TextSelectableByKeyboard);
    fact->setWordWrap(true);
    const int row = grid.rowCount();
    grid.addWidget(caption, row, 0, Qt::AlignTop);
    grid.addWidget(fact, row, 1);
    return fact;
}

void StatusPanel::addLamps(QGridLayout& grid, int row)
{
    auto* lamps = new QGridLayout;
    lamps->setVerticalSpacing(0);
    lamps->setHorizontalSpacing(8);
    const auto heading = [&](const QString& text, int column) {
        auto* label = new QLabel(text, this);
        label->setForegroundRole(QPalette::PlaceholderText);
        lamps->addWidget(label, 0, column);
    };
    heading(tr("Status byte"), 0);
    heading(tr("UART error byte"), 1);
    std::array<int, 2> next{1, 1};
    for (const LampRow& lamp : kLamps) {
        auto* indicator =
            named(new Indicator(tr(lamp.label), lamp.meaning, this), lamp.name, tr(lamp.label));
        const std::size_t column = lamp.byte == kStatus ? 0 : 1;
        lamps->addWidget(indicator, next.at(column)++, static_cast<int>(column));
        m_lamps.push_back({lamp.byte, bitOf(lamp.mask), indicator});
    }
    auto* clear = named(new QPushButton(theme::icon(u"clear"_s), tr("Clear counts"), this),
                        u"status.clear"_s, tr("Clear the counts of seen bits"));
    clear->setToolTip(
        tr("Forgets how often each bit was seen. The controller's own bits are cleared "
           "by every read."));
    clear->setVisible(!context().controller.isRecording()); // those counts are history
    connect(clear, &QPushButton::clicked, &context().latch, &StatusLatch::clear);
    lamps->addWidget(clear, 7, 0, 2, 1, Qt::AlignLeft | Qt::AlignVCenter);
    grid.addLayout(lamps, row, 0, 1, 2);
    grid.setRowMinimumHeight(row, 8);
    grid.setRowStretch(row + 1, 1);
}

QString StatusPanel::controlText() const
{
    const DeviceInfo& device = context().controller.device();
    if (!device.mode || !device.serialControls) {
        return kAbsent;
    }
    if (isSerial(*device.mode)) {
        return tr("serial orders (serial mode)");
    }
    if (*device.serialControls) {
        return tr("serial orders (override by channel 5)");
    }
    return *device.mode == Mode::Rc ? tr("the RC channels (mode jumper)")
                                    : tr("the analog channels (mode jumper)");
}

void StatusPanel::refreshFacts()
{
    const DeviceInfo& device = context().controller.device();
    m_signature->setText(device.signature ? device.signature->text() : kAbsent);
    m_firmware->setText(device.signature ? device.signature->firmware() : kAbsent);
    m_mode->setText(device.mode ? modeText(*device.mode) : kAbsent);
    m_control->setText(controlText());
    QStringList learned;
    for (int channel = 1; device.learnedMask && channel <= kChannelCount; ++channel) {
        if ((*device.learnedMask >> (channel - 1) & 1) != 0) {
            learned.append(QString::number(channel));
        }
    }
    m_learned->setText(!device.learnedMask     ? kAbsent
                           : learned.isEmpty() ? tr("no channel (defaults)")
                                               : tr("channels %1").arg(learned.join(u", "_s)));
}

void StatusPanel::refreshLamps()
{
    const QDateTime now = context().latch.now();
    bool fading = false;
    for (const Lamp& lamp : m_lamps) {
        const StatusLatch::Entry& entry = context().latch.entry(lamp.byte, lamp.bit);
        const bool stale = !context().latch.lastRead(lamp.byte);
        const bool recent = entry.count > 0 && entry.lastSeen.msecsTo(now) < kLitMs;
        fading = fading || (recent && !stale);
        lamp.indicator->setState((entry.lit || recent) && !stale, entry.count, stale);
        const QLocale locale;
        lamp.indicator->setDetail(
            entry.count == 0 ? tr("Not seen.")
                             : tr("Seen %n time(s), first %1, last %2.", nullptr, entry.count)
                                   .arg(locale.toString(entry.firstSeen.time(), u"HH:mm:ss"_s),
                                        locale.toString(entry.lastSeen.time(), u"HH:mm:ss"_s)));
    }
    if (fading) {
        m_fade.start();
    } else {
        m_fade.stop();
    }
}

} // namespace trex
