// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "protocol/storage/setting.h"
#include "widgets/common/panel.h"

#include <QDialog>

#include <array>

class QCheckBox;
class QDoubleSpinBox;
class QFormLayout;
class QSpinBox;

namespace trex {

/// What closes the motor gate by itself, and what the host adds to the motors' motion. Everything
/// acts at once and is kept. Not modal, with a STOP of its own. GUI thread.
class SafetyDialog : public QDialog {
    Q_OBJECT
    Q_DISABLE_COPY_MOVE(SafetyDialog)

public:
    explicit SafetyDialog(PanelContext& context, QWidget* parent = nullptr);

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    [[nodiscard]] QWidget* makeDisarming();
    [[nodiscard]] QWidget* makeLimits();
    [[nodiscard]] QWidget* makeHolding();
    QCheckBox* addCheck(QLayout& layout, const Setting<bool>& setting, const QString& name,
                        const QString& text, const QString& tip);
    /// A number that the setting holds in `unit`ths of what is shown.
    QSpinBox* addNumber(QFormLayout& form, const Setting<int>& setting, const QString& name,
                        const QString& label, std::pair<int, int> range, const QString& suffix,
                        const QString& atLeast = {});

    PanelContext& m_context;
};

} // namespace trex
