// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/plots/plotlayout.h"

#include <QCoreApplication>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>

#include <algorithm>
#include <array>

namespace trex {

using namespace Qt::Literals::StringLiterals;

namespace {

// clang-format off
constexpr std::array kColours{
    CurveColourRow{ColourRole::Motor1,  "blue",   QT_TRANSLATE_NOOP("Plots", "Blue")},
    CurveColourRow{ColourRole::Motor2,  "orange", QT_TRANSLATE_NOOP("Plots", "Orange")},
    CurveColourRow{ColourRole::Aux,     "teal",   QT_TRANSLATE_NOOP("Plots", "Teal")},
    CurveColourRow{ColourRole::Curve4,  "violet", QT_TRANSLATE_NOOP("Plots", "Violet")},
    CurveColourRow{ColourRole::Curve5,  "pink",   QT_TRANSLATE_NOOP("Plots", "Pink")},
    CurveColourRow{ColourRole::Ok,      "green",  QT_TRANSLATE_NOOP("Plots", "Green")},
    CurveColourRow{ColourRole::Warning, "ochre",  QT_TRANSLATE_NOOP("Plots", "Ochre")},
    CurveColourRow{ColourRole::Fault,   "red",    QT_TRANSLATE_NOOP("Plots", "Red")},
    CurveColourRow{ColourRole::Stale,   "grey",   QT_TRANSLATE_NOOP("Plots", "Grey")},
    CurveColourRow{ColourRole::Text,    "plain",  QT_TRANSLATE_NOOP("Plots", "Black or white")},
};
constexpr std::array kWidths{
    CurveWidthRow{1.0, QT_TRANSLATE_NOOP("Plots", "Thin")},
    CurveWidthRow{1.6, QT_TRANSLATE_NOOP("Plots", "Normal")},
    CurveWidthRow{2.6, QT_TRANSLATE_NOOP("Plots", "Thick")},
};
constexpr std::array<std::string_view, 4> kPlots{"-current", "-command", "-raw", "-remapped"};
// clang-format on

constexpr int kMostPlots = 12;
constexpr double kThinnest = 0.5;
constexpr double kThickest = 6.0;
constexpr int kCurrentsHeight = 160; ///< what one looks at most

ColourRole roleOf(StreamColour colour)
{
    switch (colour) {
    case StreamColour::Motor1:
    case StreamColour::Channel1:
        return ColourRole::Motor1;
    case StreamColour::Motor2:
    case StreamColour::Channel2:
        return ColourRole::Motor2;
    case StreamColour::Aux:
    case StreamColour::Channel3:
        return ColourRole::Aux;
    case StreamColour::Channel4:
        return ColourRole::Curve4;
    case StreamColour::Channel5:
        return ColourRole::Curve5;
    case StreamColour::Neutral:
        break;
    }
    return ColourRole::Text;
}

QString text(std::string_view view)
{
    return QString::fromUtf8(view.data(), static_cast<qsizetype>(view.size()));
}

CurveSpec curveFrom(const QJsonObject& object, const StreamRow& row)
{
    CurveSpec curve = curveOf(row);
    const QString colour = object[u"colour"_s].toString();
    for (const CurveColourRow& each : kColours) {
        if (colour == QLatin1StringView(each.key)) {
            curve.colour = each.role;
        }
    }
    curve.width = std::clamp(object[u"width"_s].toDouble(curve.width), kThinnest, kThickest);
    curve.isVisible = object[u"visible"_s].toBool(true);
    return curve;
}

} // namespace

std::span<const CurveColourRow> curveColours()
{
    return kColours;
}

std::span<const CurveWidthRow> curveWidths()
{
    return kWidths;
}

QString keyOf(const StreamRow& row)
{
    return text(row.key);
}

QString titleOf(const StreamRow& row)
{
    const QString title = QCoreApplication::translate("Streams", row.title);
    if (row.source == Source(PollId::Currents)) {
        return QCoreApplication::translate("Plots", "%1 current").arg(title);
    }
    return title;
}

QString unitOf(const StreamRow& row)
{
    return text(row.unit);
}

CurveSpec curveOf(const StreamRow& row)
{
    return {.key = keyOf(row), .colour = roleOf(row.colour)};
}

PlotLayout defaultLayout()
{
    PlotLayout layout;
    for (const std::string_view suffix : kPlots) {
        PlotSpec plot;
        for (const StreamRow& row : streams()) {
            if (row.key.ends_with(suffix)) {
                plot.curves.push_back(curveOf(row));
            }
        }
        if (!plot.curves.empty()) {
            plot.height = layout.empty() ? kCurrentsHeight : plot.height;
            layout.push_back(plot);
        }
    }
    return layout;
}

QByteArray toJson(const PlotLayout& layout)
{
    QJsonArray plots;
    for (const PlotSpec& plot : layout) {
        QJsonArray curves;
        for (const CurveSpec& curve : plot.curves) {
            QJsonObject object{{u"stream"_s, curve.key}, {u"width"_s, curve.width}};
            for (const CurveColourRow& each : kColours) {
                if (each.role == curve.colour) {
                    object[u"colour"_s] = QLatin1StringView(each.key);
                }
            }
            if (!curve.isVisible) {
                object[u"visible"_s] = false;
            }
            curves.append(object);
        }
        plots.append(QJsonObject{{u"curves"_s, curves}, {u"height"_s, plot.height}});
    }
    return QJsonDocument(plots).toJson(QJsonDocument::Compact);
}

std::optional<PlotLayout> layoutFromJson(const QByteArray& json)
{
    const QJsonDocument document = QJsonDocument::fromJson(json);
    if (!document.isArray()) {
        return std::nullopt;
    }
    PlotLayout layout;
    for (const QJsonValue& value : document.array()) {
        if (!value.isObject()) {
            continue;
        }
        const QJsonObject object = value.toObject();
        PlotSpec plot;
        plot.height = std::clamp(object[u"height"_s].toInt(plot.height), 1, 100'000);
        const QJsonArray curves = object[u"curves"_s].toArray();
        for (const QJsonValue& each : curves) {
            const int index = streamIndex(each[u"stream"_s].toString().toStdString());
            if (index >= 0) {
                plot.curves.push_back(
                    curveFrom(each.toObject(), streams()[static_cast<std::size_t>(index)]));
            }
        }
        // A plot that was left empty on purpose stays; one whose curves are all gone does not.
        if ((!plot.curves.empty() || curves.isEmpty()) && layout.size() < kMostPlots) {
            layout.push_back(plot);
        }
    }
    return layout.empty() ? std::nullopt : std::optional(layout);
}

} // namespace trex
