// SPDX-License-Identifier: GPL-3.0-or-later
// The shape that a state has beside its colour: filled dot ok, triangle warning, octagon fault,
// hollow dot off, hatched dot stale.
#pragma once

class QPainter;
class QRectF;

namespace trex {

enum class StateShape { Ok, Warning, Fault, Off, Stale };

/// Draws it within `rect` in the colour of its role; wants an antialiasing painter.
void drawStateShape(QPainter& painter, const QRectF& rect, StateShape shape);

} // namespace trex
