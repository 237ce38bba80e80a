// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "protocol/session/transaction.h"

#include <QLabel>

namespace trex {

/// The state of the link in words, with the shape and colour of its kind. The property holds the
/// state's key, never translated. GUI thread.
class LinkStateLabel : public QLabel {
    Q_OBJECT
    Q_DISABLE_COPY_MOVE(LinkStateLabel)
    Q_PROPERTY(QString state READ state)

public:
    explicit LinkStateLabel(QWidget* parent = nullptr);
    void setLink(LinkState state, const QString& text);
    [[nodiscard]] QString state() const { return keyOf(m_state); }

protected:
    void paintEvent(QPaintEvent* event) override;
    void changeEvent(QEvent* event) override;

private:
    void makeRoom(); ///< for the shape, in the size of the font

    LinkState m_state = LinkState::Disconnected;
};

} // namespace trex
