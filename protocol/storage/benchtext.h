// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QCoreApplication>

namespace trex {

/// The words of the bench tests, for tr().
struct Bench {
    Q_DECLARE_TR_FUNCTIONS(Bench)
};

} // namespace trex
