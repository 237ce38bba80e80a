// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/packets/packetcomposer.h"

#include "protocol/codec/packet.h"
#include "protocol/errortext.h"
#include "protocol/session/controller.h"
#include "widgets/common/panel.h"
#include "widgets/common/theme.h"
#include "widgets/packets/composedpacket.h"
#include "widgets/packets/packetentry.h"

#include <QComboBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QSpinBox>
#include <QVBoxLayout>

namespace trex {

using namespace Qt::Literals::StringLiterals;

namespace {

constexpr int kMostReplyBytes = 64;
constexpr QLatin1StringView kRawKey = "raw"_L1;

QString fromKey(std::string_view key)
{
    return QString::fromLatin1(key.data(), static_cast<qsizetype>(key.size()));
}

/// With its first letter in upper case, as a field's title.
QString titleOf(std::string_view key)
{
    const QString label = labelOf(key);
    return label.left(1).toUpper() + label.mid(1);
}

std::size_t mostArguments()
{
    std::size_t most = 0;
    for (const CommandRow& row : kCommands) {
        most = std::max(most, row.arguments.size());
    }
    return most;
}

} // namespace

PacketComposer::PacketComposer(Controller& controller, QWidget* parent)
    : QWidget(parent), m_controller(controller)
{
    auto* top = new QHBoxLayout;
    top->setSpacing(8);
    m_command = new QComboBox(this);
    m_command->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
    m_command->setMinimumContentsLength(16);
    m_command->setMaxVisibleItems(24);
    addField(*top, m_command, u"packets.command"_s, 1).label->setText(tr("Command"));
    buildFields(*top);
    m_send = named(new QPushButton(theme::icon(u"send"_s), tr("S&end"), this), u"packets.send"_s,
                   tr("Send the packet"));
    top->addWidget(m_send, 0, Qt::AlignBottom);

    const auto addLabel = [this](const QString& name, const QString& title) {
        auto* label = named(new QLabel(this), name, title);
        label->setWordWrap(true);
        label->setTextFormat(Qt::PlainText);
        label->setTextInteractionFlags(Qt::TextSelectableByMouse | Qt::TextSelectableByKeyboard);
        return label;
    };
    m_preview = addLabel(u"packets.preview"_s, tr("The packet as it will be sent"));
    m_preview->setForegroundRole(QPalette::PlaceholderText);
    m_result = addLabel(u"packets.result"_s, tr("What came of it"));
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(4);
    layout->addLayout(top);
    layout->addWidget(m_preview);
    layout->addWidget(m_result);
    m_result->hide();

    fillCommands();
    connect(m_command, &QComboBox::currentIndexChanged, this, &PacketComposer::onCommandChosen);
    // Connected only now: setting the fields up is no change by a person.
    for (QSpinBox* editor : findChildren<QSpinBox*>()) {
        connect(editor, &QSpinBox::valueChanged, this, &PacketComposer::showPreview);
    }
    for (const Field& direction : m_directions) {
        connect(direction.combo, &QComboBox::currentIndexChanged, this,
                &PacketComposer::showPreview);
    }
    connect(m_raw, &QLineEdit::textChanged, this, &PacketComposer::showPreview);
    connect(m_raw, &QLineEdit::returnPressed, this, &PacketComposer::send);
    connect(m_send, &QPushButton::clicked, this, &PacketComposer::send);
    connect(&controller, &Controller::stateChanged, this, &PacketComposer::showPreview);
    onCommandChosen();
}

void PacketComposer::buildFields(QHBoxLayout& layout)
{
    m_channel = addSpin(layout, u"packets.channel"_s);
    m_channel.label->setText(tr("Channel"));
    m_channel.spin->setRange(1, kChannelCount);
    m_directions[0] = addDirection(layout, u"packets.direction"_s);
    m_directions[1] = addDirection(layout, u"packets.direction2"_s);
    m_directions[1].label->setText(tr("Motor 2 direction"));
    for (std::size_t i = 0; i < mostArguments(); ++i) {
        m_arguments.push_back(addSpin(layout, u"packets.argument%1"_s.arg(i + 1)));
    }
    m_raw = new QLineEdit(this);
    m_raw->setPlaceholderText(u"86 1F"_s);
    m_raw->setClearButtonEnabled(true);
    m_rawField = addField(layout, m_raw, u"packets.raw"_s, 1);
    m_rawField.label->setText(tr("Bytes in hex"));
    m_replyBytes = addSpin(layout, u"packets.replyBytes"_s);
    m_replyBytes.label->setText(tr("Reply bytes"));
    m_replyBytes.spin->setRange(0, kMostReplyBytes);
    m_replyBytes.spin->setToolTip(tr("How many bytes to wait for, the CRC byte not counted."));
}

/// Its title above it: five fields side by side still fit a narrow panel.
PacketComposer::Field PacketComposer::addField(QHBoxLayout& layout, QWidget* editor,
                                               const QString& name, int stretch)
{
    auto* box = new QWidget(this);
    auto* column = new QVBoxLayout(box);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(0);
    auto* label = new QLabel(box);
    label->setForegroundRole(QPalette::PlaceholderText);
    label->setBuddy(named(editor, name));
    column->addWidget(label);
    column->addWidget(editor);
    layout.addWidget(box, stretch);
    return {box, label, qobject_cast<QSpinBox*>(editor), qobject_cast<QComboBox*>(editor)};
}

PacketComposer::Field PacketComposer::addSpin(QHBoxLayout& layout, const QString& name)
{
    return addField(layout, new QSpinBox(this), name);
}

PacketComposer::Field PacketComposer::addDirection(QHBoxLayout& layout, const QString& name)
{
    auto* combo = new QComboBox(this);
    combo->addItem(tr("Forward"), static_cast<int>(MotorDirection::Forward));
    combo->addItem(tr("Reverse"), static_cast<int>(MotorDirection::Reverse));
    combo->addItem(tr("Brake"), static_cast<int>(MotorDirection::Brake));
    return addField(layout, combo, name);
}

void PacketComposer::fillCommands()
{
    for (const CommandRow& row : kCommands) {
        if (row.kind == CommandKind::Framing) {
            continue; // the packet form is the line's, not a command of its own
        }
        m_command->addItem(QCoreApplication::translate("Commands", row.title), fromKey(row.key));
        m_command->setItemData(m_command->count() - 1,
                               QCoreApplication::translate("Commands", row.help), Qt::ToolTipRole);
    }
    m_command->addItem(tr("Raw bytes (hex)"), QString(kRawKey));
}

void PacketComposer::onCommandChosen()
{
    m_row = nullptr;
    const QString key = m_command->currentData().toString();
    for (const CommandRow& row : kCommands) {
        if (fromKey(row.key) == key) {
            m_row = &row;
        }
    }
    m_command->setToolTip(m_command->currentData(Qt::ToolTipRole).toString());
    m_result->hide();
    showFields();
    showPreview();
}

void PacketComposer::showFields()
{
    const OpcodeBits bits = isRaw() ? OpcodeBits::None : m_row->opcodeBits;
    const bool isPair = bits == OpcodeBits::DirectionPair;
    m_channel.box->setVisible(bits == OpcodeBits::Channel);
    m_directions[0].box->setVisible(isPair || bits == OpcodeBits::Direction);
    m_directions[0].label->setText(isPair ? tr("Motor 1 direction") : tr("Direction"));
    m_directions[1].box->setVisible(isPair);
    m_rawField.box->setVisible(isRaw());
    m_replyBytes.box->setVisible(isRaw());
    for (std::size_t i = 0; i < m_arguments.size(); ++i) {
        const Field& field = m_arguments[i];
        const bool isUsed = !isRaw() && i < m_row->arguments.size()
            && m_row->arguments[i].kind != FieldKind::Constant;
        field.box->setVisible(isUsed);
        if (isUsed) {
            const FieldSpec& spec = m_row->arguments[i];
            const bool isMask = spec.kind == FieldKind::Bits;
            const QSignalBlocker blocker(field.spin);
            field.spin->setRange(spec.minimum, spec.maximum);
            field.spin->setValue(isMask ? spec.maximum : spec.minimum);
            field.spin->setToolTip(isMask ? tr("The sum of 1, 2, 4, 8 and 16 for channels 1 to 5.")
                                          : QString());
            field.label->setText(titleOf(spec.key));
        }
    }
    for (QLabel* label : findChildren<QLabel*>()) {
        if (label->buddy() != nullptr) {
            label->buddy()->setAccessibleName(label->text());
        }
    }
}

Result<Command> PacketComposer::command() const
{
    if (isRaw()) {
        return fail(ErrorCode::BadCommand);
    }
    int bits = 0;
    if (m_row->opcodeBits == OpcodeBits::Channel) {
        bits = m_channel.spin->value() - 1;
    } else if (m_row->opcodeBits != OpcodeBits::None) {
        bits = m_directions[0].combo->currentData().toInt();
        if (m_row->opcodeBits == OpcodeBits::DirectionPair) {
            bits |= m_directions[1].combo->currentData().toInt() << 2;
        }
    }
    Command command{static_cast<std::uint8_t>(m_row->first + bits), {}};
    for (std::size_t i = 0; i < m_row->arguments.size(); ++i) {
        const FieldSpec& spec = m_row->arguments[i];
        const int raw =
            spec.kind == FieldKind::Constant ? spec.minimum : m_arguments.at(i).spin->value();
        command.data.append(static_cast<char>(raw & 0x7F));
        if (spec.width() == 2) {
            command.data.append(static_cast<char>(raw >> 7)); // conformance C-35
        }
    }
    if (const Result<void> verdict = validate(command); !verdict) {
        return tl::make_unexpected(verdict.error());
    }
    return command;
}

void PacketComposer::showPreview()
{
    if (m_preview == nullptr) {
        return; // the form is still being built
    }
    if (isRaw()) {
        const Result<QByteArray> bytes = bytesFromHex(m_raw->text());
        m_preview->setText(bytes ? tr("Sends %1, as given.").arg(spacedHex(*bytes))
                                 : tr("Sends the bytes as given, without packet form and CRC."));
        return;
    }
    const Result<Command> composed = command();
    m_preview->setText(composed
                           ? tr("Sends %1: %2")
                                 .arg(spacedHex(encode(*composed, m_controller.options().line)),
                                      describe(*composed))
                           : errorText(composed.error()));
}

void PacketComposer::send()
{
    if (isRaw()) {
        sendRaw();
        return;
    }
    const Result<Command> composed = command();
    if (composed) {
        sendCommand(*composed);
    } else {
        say(errorText(composed.error()), true);
    }
}

void PacketComposer::sendCommand(const Command& command)
{
    const auto handler = [this, command](const Result<Reply>& reply) {
        report(encode(command, m_controller.options().line), reply,
               reply && !reply->payload.isEmpty() ? describeReply(command, reply->payload)
                                                  : QString());
    };
    if (command.row().kind != CommandKind::Motor) {
        m_controller.request(command, this, handler);
        return;
    }
    const std::optional<GateOrder> order = gateOrderOf(command);
    if (!order) {
        // Bytes that the gate would write differently, such as "reverse 0"; it is asked all the
        // same.
        m_controller.requestRaw(encode(command, m_controller.options().line), 0, this, handler);
        return;
    }
    const Result<void> taken = order->isBoth
        ? m_controller.driveBoth(order->first, order->second, this, handler)
        : m_controller.driveMotor(order->motor, order->first, this, handler);
    if (!taken) {
        say(errorText(taken.error()), true);
    }
}

void PacketComposer::sendRaw()
{
    const Result<QByteArray> bytes = bytesFromHex(m_raw->text());
    if (!bytes) {
        const QString wrong = bytes.error().context;
        say(wrong.isEmpty()
                ? tr("Nothing was sent: give the bytes in hex, such as 86 1F.")
                : tr("Nothing was sent: \"%1\" is not bytes in hex, such as 86 1F.").arg(wrong),
            true);
        return;
    }
    const auto handler = [this, sent = *bytes](const Result<Reply>& reply) {
        const auto packet = decodePacket(sent, m_controller.options().line);
        report(sent, reply,
               packet && reply ? describeReply(packet->command, reply->payload) : QString());
    };
    m_controller.requestRaw(*bytes, m_replyBytes.spin->value(), this, handler);
}

void PacketComposer::report(const QByteArray& sent, const Result<Reply>& reply, const QString& text)
{
    if (!reply) {
        say(errorText(reply.error()), true);
        return;
    }
    if (reply->payload.isEmpty()) {
        say(tr("Sent %1; no reply is due.").arg(spacedHex(sent)), false);
        return;
    }
    const std::chrono::duration<double, std::milli> taken = reply->received - reply->sent;
    const QString received =
        tr("Received %1 after %2 ms").arg(spacedHex(reply->payload)).arg(taken.count(), 0, 'f', 1);
    say(text.isEmpty() ? tr("%1.").arg(received) : tr("%1: %2").arg(received, text), false);
}

void PacketComposer::say(const QString& text, bool isError)
{
    theme::setTextColour(*m_result, isError ? ColourRole::Fault : ColourRole::Text);
    m_result->setText(text);
    m_result->setVisible(!text.isEmpty());
}

} // namespace trex
