// SPDX-License-Identifier: GPL-3.0-or-later
// How a run of trexctl ends badly: an exit code of contracts/cli.md and one sentence.
#pragma once

#include "protocol/result.h"

#include <QCoreApplication>

namespace trex {

/// The words of the command line, for tr().
struct Cli {
    Q_DECLARE_TR_FUNCTIONS(Cli)
};

namespace exitcode {
inline constexpr int kDone = 0, kRefused = 1, kUsage = 2, kNoReply = 3, kPort = 4, kDiffers = 5,
                     kInterrupted = 130, kPipeClosed = 141;
}

struct Failure {
    int exitCode = exitcode::kUsage;
    QString text;
};
using Checked = tl::expected<void, Failure>;

[[nodiscard]] int exitCodeOf(ErrorCode code);
[[nodiscard]] Failure toFailure(const Error& error);
/// Found before a byte was sent.
[[nodiscard]] inline tl::unexpected<Failure> usage(const QString& sentence)
{
    return tl::make_unexpected(Failure{exitcode::kUsage, sentence});
}
/// The same from a result of the library.
template <class T>
[[nodiscard]] Checked checked(const Result<T>& result)
{
    return result ? Checked() : tl::make_unexpected(toFailure(result.error()));
}

} // namespace trex
