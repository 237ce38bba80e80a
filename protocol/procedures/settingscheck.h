// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "protocol/session/devicesettings.h"
#include "protocol/storage/configfile.h"

namespace trex {

/// Reads many settings back and compares them with what they should be. Main thread.
class SettingsCheck : public QObject {
    Q_OBJECT
    Q_DISABLE_COPY_MOVE(SettingsCheck)

public:
    /// What the controller holds now, of all that was asked.
    using Handler = std::function<void(const Result<Configuration>&)>;

    SettingsCheck(Controller& controller, DeviceSettings& settings, QObject* parent);

    /// Everything that `expected` mentions; of the calibrations those of the input set in force. A
    /// value that is not the expected one is read until two replies in a row say the same.
    void read(const Configuration& expected, const Handler& handler);

private:
    struct Field {
        const ParameterRow* row = nullptr; ///< null: a calibration
        int channel = 0;
    };
    void readNext();
    [[nodiscard]] bool keep(const std::optional<Error>& error);

    Controller& m_controller;
    DeviceSettings& m_settings;
    Configuration m_expected;
    Configuration m_found;
    std::vector<Field> m_fields;
    std::size_t m_next = 0;
    InputKind m_input = InputKind::Rc;
    Handler m_handler;
};

} // namespace trex
