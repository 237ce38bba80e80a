// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "protocol/codec/command.h"
#include "protocol/session/transaction.h"

#include <QWidget>

#include <array>
#include <vector>

class QComboBox;
class QHBoxLayout;
class QLabel;
class QLineEdit;
class QPushButton;
class QSpinBox;

namespace trex {

class Controller;

/// Puts a packet together, by a command's name and fields or as raw hex, shows the bytes as they
/// will go out, sends them and says what came back. Motor commands pass the controller's gate.
/// GUI thread.
class PacketComposer : public QWidget {
    Q_OBJECT
    Q_DISABLE_COPY_MOVE(PacketComposer)

public:
    explicit PacketComposer(Controller& controller, QWidget* parent = nullptr);

    /// The command that the fields give. Errors: OutOfRange, BadCommand.
    [[nodiscard]] Result<Command> command() const;
    [[nodiscard]] bool isRaw() const { return m_row == nullptr; }

public slots:
    void send();

private:
    struct Field {
        QWidget* box; ///< label and editor
        QLabel* label;
        QSpinBox* spin; ///< null where the editor is another
        QComboBox* combo;
    };
    void buildFields(QHBoxLayout& layout);
    Field addField(QHBoxLayout& layout, QWidget* editor, const QString& name, int stretch = 0);
    Field addSpin(QHBoxLayout& layout, const QString& name);
    Field addDirection(QHBoxLayout& layout, const QString& name);
    void fillCommands();
    void onCommandChosen();
    void showFields();
    void showPreview();
    void sendCommand(const Command& command);
    void sendRaw();
    void report(const QByteArray& sent, const Result<Reply>& reply, const QString& text);
    void say(const QString& text, bool isError);

    Controller& m_controller;
    const CommandRow* m_row = nullptr; ///< null: raw hex
    QComboBox* m_command = nullptr;
    Field m_channel{};
    std::array<Field, 2> m_directions{};
    std::vector<Field> m_arguments;
    QLineEdit* m_raw = nullptr;
    Field m_rawField{};
    Field m_replyBytes{};
    QPushButton* m_send = nullptr;
    QLabel* m_preview = nullptr;
    QLabel* m_result = nullptr;
};

} // namespace trex
