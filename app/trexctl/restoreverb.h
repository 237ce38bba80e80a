// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/trexctl/verb.h"
#include "protocol/procedures/configtransfer.h"

namespace trex {

/// Brings the controller back to an earlier state: reads everything, shows or writes what differs,
/// each read back, all or nothing. The subclass says which state.
class RestoreVerb : public Verb {
public:
    void declare(CLI::App& app) override;
    [[nodiscard]] bool usesSettings() const override { return true; }
    Task run(Session& session) override;
    void interrupted(Session& session) override;

protected:
    /// Errors end the verb; nothing was written then.
    [[nodiscard]] virtual Result<Configuration> wanted(Session& session) = 0;

private:
    bool m_isDryRun = false;
    bool m_isWriting = false;
    std::unique_ptr<ConfigTransfer> m_transfer;
};

} // namespace trex
