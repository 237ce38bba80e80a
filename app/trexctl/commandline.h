// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/common/lineoptions.h"
#include "app/trexctl/failure.h"
#include "app/trexctl/verb.h"

#include <memory>
#include <vector>

namespace CLI {
class App;
}

namespace trex {

/// Reads what was typed: global options, the verb, its arguments.
class CommandLine {
public:
    CommandLine();
    ~CommandLine();
    Q_DISABLE_COPY_MOVE(CommandLine)

    /// An exit code when the run is over already: help and version (shown), or what makes no sense
    /// (told, one line).
    [[nodiscard]] std::optional<int> parse(int argc, char** argv);

    [[nodiscard]] Verb& verb() { return *m_chosen; }
    /// Port and settings, as far as the verb needs them.
    [[nodiscard]] Result<OpenOptions> openOptions(SettingsFile& settings) const;
    [[nodiscard]] const LineOptionValues& lineOptions() const { return m_lineOptions; }
    [[nodiscard]] bool isJson() const { return m_isJson; }
    [[nodiscard]] int verbosity() const { return m_verbosity; }

private:
    void addVerbs();
    CLI::App& addVerbPath(const QString& path, const QString& group);
    [[nodiscard]] QString complaint(const QString& what) const;

    std::unique_ptr<CLI::App> m_app;
    std::vector<std::unique_ptr<Verb>> m_verbs;
    Verb* m_chosen = nullptr;
    LineOptionValues m_lineOptions;
    bool m_isJson = false;
    int m_verbosity = 0;
};

} // namespace trex
