// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/common/theme.h"

#include "widgets/common/panelstyle.h"
#include "widgets/common/svgiconengine.h"

#include <QApplication>
#include <QFontDatabase>
#include <QFontMetricsF>
#include <QPalette>
#include <QWidget>

#include <array>

namespace trex::theme {

using namespace Qt::Literals::StringLiterals;

namespace {

struct RoleRow {
    ColourRole role;
    QRgb light;
    QRgb dark;
};

/// The colours of the design, by role; contrast against the panel is at least 4.5 for all that is
/// read. In the order of ColourRole.
constexpr std::array kRoles{
    RoleRow{ColourRole::Panel, 0xFFFFFFFF, 0xFF1E2227},
    RoleRow{ColourRole::Window, 0xFFF0F2F5, 0xFF15181C},
    RoleRow{ColourRole::Border, 0xFFD0D7DE, 0xFF3B434D},
    RoleRow{ColourRole::Text, 0xFF1F2328, 0xFFE6EAEF},
    RoleRow{ColourRole::DimText, 0xFF59636E, 0xFF9AA4AF},
    RoleRow{ColourRole::Motor1, 0xFF0063A6, 0xFF58B4F0},
    RoleRow{ColourRole::Motor2, 0xFFB84A00, 0xFFF0A03C},
    RoleRow{ColourRole::Aux, 0xFF00735A, 0xFF3CCFA6},
    RoleRow{ColourRole::Ok, 0xFF1A7F37, 0xFF4CC38A},
    RoleRow{ColourRole::Warning, 0xFF8A5A00, 0xFFE3B341},
    RoleRow{ColourRole::Fault, 0xFFC4232B, 0xFFFF6B6B},
    RoleRow{ColourRole::OnFault, 0xFFFFFFFF, 0xFF1E2227},
    RoleRow{ColourRole::Stale, 0xFF6E7781, 0xFF8B949E},
    RoleRow{ColourRole::Accent, 0xFF2E5E9E, 0xFF7FB0E8},
    RoleRow{ColourRole::Grid, 0xFFE4E8EC, 0xFF2F363E},
    RoleRow{ColourRole::Curve4, 0xFF7A3EB1, 0xFFC29BF2},
    RoleRow{ColourRole::Curve5, 0xFFA0287E, 0xFFEE8AC8},
};

constexpr bool isInOrder()
{
    for (std::size_t i = 0; i < kRoles.size(); ++i) {
        if (static_cast<std::size_t>(kRoles.at(i).role) != i) {
            return false;
        }
    }
    return kRoles.size() == static_cast<std::size_t>(ColourRole::Curve5) + 1;
}
static_assert(isInOrder());

/// Channels 1 to 3 are what motors 1, 2 and aux would be told (conformance C-29), so they share
/// their colours; 4 and 5 are switches of their own.
constexpr std::array kChannels{ColourRole::Motor1, ColourRole::Motor2, ColourRole::Aux,
                               ColourRole::Curve4, ColourRole::Curve5};

QColor roleColour(ColourRole role, bool dark)
{
    const RoleRow& row = kRoles.at(static_cast<std::size_t>(role));
    return QColor::fromRgb(dark ? row.dark : row.light);
}

QPalette paletteOf(bool dark)
{
    const auto of = [dark](ColourRole role) { return roleColour(role, dark); };
    QPalette palette;
    palette.setColor(QPalette::Window, of(ColourRole::Window));
    palette.setColor(QPalette::Base, of(ColourRole::Panel));
    palette.setColor(QPalette::AlternateBase, of(ColourRole::Window));
    palette.setColor(QPalette::Button, of(ColourRole::Panel));
    palette.setColor(QPalette::ToolTipBase, of(ColourRole::Panel));
    for (const auto role : {QPalette::WindowText, QPalette::Text, QPalette::ButtonText,
                            QPalette::ToolTipText, QPalette::BrightText}) {
        palette.setColor(role, of(ColourRole::Text));
    }
    palette.setColor(QPalette::PlaceholderText, of(ColourRole::Stale));
    palette.setColor(QPalette::Highlight, of(ColourRole::Accent));
    palette.setColor(QPalette::HighlightedText, of(ColourRole::Panel));
    palette.setColor(QPalette::Link, of(ColourRole::Accent));
    palette.setColor(QPalette::LinkVisited, of(ColourRole::Accent));
    palette.setColor(QPalette::Light, of(ColourRole::Panel));
    palette.setColor(QPalette::Midlight, of(ColourRole::Grid));
    palette.setColor(QPalette::Mid, of(ColourRole::Border));
    palette.setColor(QPalette::Dark, of(ColourRole::Stale));
    palette.setColor(QPalette::Shadow, of(ColourRole::Border));
    for (const auto role : {QPalette::WindowText, QPalette::Text, QPalette::ButtonText}) {
        palette.setColor(QPalette::Disabled, role, of(ColourRole::Stale));
    }
    palette.setColor(QPalette::Disabled, QPalette::Highlight, of(ColourRole::Border));
    return palette;
}

/// Only what the palette cannot say. Names in capitals are replaced by the colours of the roles.
QString styleSheet(bool dark)
{
    QString sheet = uR"(
QMainWindow::separator { background: WINDOW; width: 5px; height: 5px; }
QMainWindow::separator:hover { background: ACCENT; }
QDockWidget { titlebar-close-icon: url(); }
QStatusBar { background: PANEL; border-top: 1px solid BORDER; }
QStatusBar::item { border: none; }
QToolBar { background: PANEL; border: none; border-bottom: 1px solid BORDER; spacing: 8px; padding: 4px 8px; }
QMenuBar { background: PANEL; }
QMenuBar::item { padding: 4px 8px; background: transparent; }
QMenuBar::item:selected { background: ACCENT; color: PANEL; }
QMenu { background: PANEL; border: 1px solid BORDER; padding: 4px; }
QToolTip { background: PANEL; color: TEXT; border: 1px solid BORDER; padding: 4px; }
QHeaderView::section { background: WINDOW; color: DIM; border: none; border-bottom: 1px solid BORDER; padding: 4px 8px; }
QTabBar::tab { background: transparent; color: DIM; padding: 6px 12px; border: none; border-bottom: 2px solid transparent; }
QTabBar::tab:selected { color: TEXT; border-bottom: 2px solid ACCENT; }
QTabBar::tab:hover { color: TEXT; }
QTabBar::tab:focus { color: ACCENT; }
QPushButton[role="stop"] { background: FAULT; color: ONFAULT; border: 2px solid FAULT; border-radius: 4px; font-weight: bold; padding: 4px 24px; }
QPushButton[role="stop"]:hover, QPushButton[role="stop"]:focus { border: 2px solid TEXT; }
QPushButton[role="stop"]:pressed { background: TEXT; color: PANEL; }
)"_s;
    const std::pair<QLatin1StringView, ColourRole> names[] = {
        {"ONFAULT"_L1, ColourRole::OnFault}, {"FAULT"_L1, ColourRole::Fault},
        {"WINDOW"_L1, ColourRole::Window},   {"PANEL"_L1, ColourRole::Panel},
        {"BORDER"_L1, ColourRole::Border},   {"ACCENT"_L1, ColourRole::Accent},
        {"TEXT"_L1, ColourRole::Text},       {"DIM"_L1, ColourRole::DimText},
    };
    for (const auto& [name, role] : names) {
        sheet.replace(name, roleColour(role, dark).name());
    }
    return sheet;
}

bool isDarkPalette(const QPalette& palette)
{
    return palette.color(QPalette::Window).lightness()
        < palette.color(QPalette::WindowText).lightness();
}

} // namespace

void apply(Choice choice)
{
    qApp->setStyleSheet({});
    QApplication::setStyle(new PanelStyle); // the application owns it
    // An empty palette is the desktop's again; that is how it can be looked at after ours was set.
    QApplication::setPalette({});
    const bool dark = choice == Choice::Dark
        || (choice == Choice::System && isDarkPalette(QApplication::palette()));
    QApplication::setPalette(paletteOf(dark));
    qApp->setStyleSheet(styleSheet(dark));
}

bool isDark()
{
    return isDarkPalette(QGuiApplication::palette());
}

QColor colour(ColourRole role)
{
    return roleColour(role, isDark());
}

QColor channelColour(int channel)
{
    return colour(channelRole(channel));
}

ColourRole channelRole(int channel)
{
    return kChannels.at(static_cast<std::size_t>(std::clamp(channel, 1, 5) - 1));
}

QFont font(double step, bool tabular)
{
    QFont font = QApplication::font();
    if (tabular) {
        // Qt 6.4 cannot ask a font for its tabular digits; where its usual ones differ in width,
        // the desktop's fixed font stands in.
        const QFontMetricsF metrics(font);
        const double width = metrics.horizontalAdvance(u'0');
        for (char16_t digit = u'1'; digit <= u'9'; ++digit) {
            if (std::abs(metrics.horizontalAdvance(digit) - width) > 0.01) {
                font = QFontDatabase::systemFont(QFontDatabase::FixedFont);
                break;
            }
        }
    }
    const QFont body = QApplication::font();
    if (body.pointSizeF() > 0) {
        font.setPointSizeF(body.pointSizeF() * step);
    } else {
        font.setPixelSize(qRound(body.pixelSize() * step));
    }
    return font;
}

void setTextColour(QWidget& widget, ColourRole role)
{
    // A label on a Base background writes in Text, on any other in WindowText.
    QPalette palette = widget.palette();
    palette.setColor(QPalette::WindowText, colour(role));
    palette.setColor(QPalette::Text, colour(role));
    widget.setPalette(palette);
}

QIcon icon(const QString& name, ColourRole role)
{
    return QIcon(new SvgIconEngine(u":/icons/"_s + name + u".svg"_s, role)); // QIcon owns it
}

} // namespace trex::theme
