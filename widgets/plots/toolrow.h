// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>

namespace trex {

/// A row of tool buttons whose texts go where there is no room for them; their tool tips and
/// accessible names stay.
class ToolRow : public QWidget {
    Q_OBJECT

public:
    using QWidget::QWidget;
    [[nodiscard]] QSize minimumSizeHint() const override; ///< without the texts

protected:
    void resizeEvent(QResizeEvent* event) override;

private:
    [[nodiscard]] int widthOfTexts() const;
    bool m_isShort = false;
};

} // namespace trex
