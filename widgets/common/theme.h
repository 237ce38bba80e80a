// SPDX-License-Identifier: GPL-3.0-or-later
// Colours by role, fonts by size step and icons: the only file that names a colour.
#pragma once

#include <QColor>
#include <QFont>
#include <QIcon>

class QWidget;

namespace trex {

enum class ColourRole {
    Panel, ///< background of panels and plots
    Window, ///< behind the panels
    Border,
    Text,
    DimText,
    Motor1,
    Motor2,
    Aux,
    Ok,
    Warning,
    Fault, ///< also STOP
    OnFault, ///< text on STOP
    Stale,
    Accent, ///< selection, focus
    Grid,
    Curve4, ///< more curves than motors: violet, as channel 4
    Curve5, ///< pink, as channel 5
};

namespace theme {

enum class Choice { System, Light, Dark };

/// Applies palette, style and style sheet to the whole application; "system" looks at the desktop's
/// own palette (Qt 6.4 has no colour scheme property). Widgets are told by a PaletteChange event.
void apply(Choice choice);
[[nodiscard]] bool isDark();
[[nodiscard]] QColor colour(ColourRole role); ///< of the theme in force
/// Colour of channel 1 to 5 in plots and bars.
[[nodiscard]] QColor channelColour(int channel);
[[nodiscard]] ColourRole channelRole(int channel);

/// The desktop's font, scaled: 1 body, 1.25 panel title, 2 read-outs, 4 bench mode. Read-outs have
/// tabular digits, so that nothing jumps.
[[nodiscard]] QFont font(double step, bool tabular = false);

/// Writes a label in a role's colour, whatever background it stands on.
void setTextColour(QWidget& widget, ColourRole role);

/// An action icon (":/icons/NAME.svg") in the text colour, or in a role's colour.
[[nodiscard]] QIcon icon(const QString& name, ColourRole role = ColourRole::Text);

} // namespace theme
} // namespace trex
