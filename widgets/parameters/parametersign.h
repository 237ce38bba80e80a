// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/parameters/parametermodel.h"

#include <QFont>
#include <QPixmap>
#include <QVariant>

namespace trex {

/// The sign at the head of a row: a shape of its own for each state, so that colour is never the
/// only one.
[[nodiscard]] QPixmap parameterSign(ParameterModel::State state);
/// Text colour of a cell; invalid: the usual one.
[[nodiscard]] QVariant parameterColour(ParameterModel::State state, int column);
[[nodiscard]] QFont boldFont();

} // namespace trex
