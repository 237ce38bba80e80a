// SPDX-License-Identifier: GPL-3.0-or-later
// The plots of a bench test's report, as SVG.
#include "protocol/procedures/benchreport.h"
#include "protocol/procedures/benchresults.h"
#include "protocol/storage/benchtext.h"

#include <QXmlStreamWriter>

#include <cmath>

using namespace Qt::Literals::StringLiterals;

namespace trex {
namespace {

constexpr int kWidth = 900;
constexpr int kLeft = 62;
constexpr int kRight = 14;
constexpr int kTop = 26;
constexpr int kBottom = 40;
constexpr int kPanel = 132; // height of one of the stacked parts
constexpr int kGap = 18;
constexpr int kCurveHeight = 300;
constexpr std::size_t kMostPoints = 1800; // then the extremes of each column are drawn
constexpr int kColumns = 820;
constexpr int kMostMarks = 24;

struct Colour {
    const char* name; ///< class
    const char* paper;
};
constexpr std::array kMotorColours{Colour{"m1", "#0063A6"}, Colour{"m2", "#B84A00"},
                                   Colour{"aux", "#00735A"}};

const Colour& colourOf(MotorId motor)
{
    return kMotorColours.at(std::size_t(motor));
}

QString number(double value)
{
    return QString::number(value, 'f', 1);
}

/// For people: with a true minus.
QString figure(double value, int digits)
{
    return QString::number(value, 'f', digits).replace(u'-', u'\u2212');
}

/// A range of values on a range of pixels.
struct Scale {
    double from = 0.0;
    double to = 1.0;
    double begin = 0.0; ///< px
    double end = 1.0;
    [[nodiscard]] double px(double value) const
    {
        return begin + (value - from) / (to - from) * (end - begin);
    }
    /// 1, 2 or 5 times a power of ten, about `wanted` of them.
    [[nodiscard]] double step(int wanted) const
    {
        const double raw = (to - from) / wanted;
        const double power = std::pow(10.0, std::floor(std::log10(raw)));
        const double part = raw / power;
        return power * (part <= 1.0 ? 1.0 : part <= 2.0 ? 2.0 : part <= 5.0 ? 5.0 : 10.0);
    }
};

class Drawing {
public:
    Drawing(int height, const QString& title) : m_xml(&m_svg)
    {
        m_xml.writeStartElement(u"svg"_s);
        m_xml.writeAttribute(u"xmlns"_s, u"http://www.w3.org/2000/svg"_s);
        m_xml.writeAttribute(u"viewBox"_s, u"0 0 %1 %2"_s.arg(kWidth).arg(height));
        m_xml.writeAttribute(u"width"_s, QString::number(kWidth));
        m_xml.writeAttribute(u"height"_s, QString::number(height));
        m_xml.writeAttribute(u"role"_s, u"img"_s);
        m_xml.writeAttribute(u"font-family"_s, u"sans-serif"_s);
        m_xml.writeAttribute(u"font-size"_s, u"12"_s);
        m_xml.writeTextElement(u"title"_s, printable(title));
    }
    void line(double x1, double y1, double x2, double y2, const char* className, const char* paper,
              double width = 1.0, const char* dashes = nullptr)
    {
        m_xml.writeStartElement(u"line"_s);
        attribute("x1", number(x1));
        attribute("y1", number(y1));
        attribute("x2", number(x2));
        attribute("y2", number(y2));
        stroke(className, paper, width, dashes);
        m_xml.writeEndElement();
    }
    void path(const QString& data, const Colour& colour, double width, const char* dashes = nullptr)
    {
        if (data.isEmpty()) {
            return;
        }
        m_xml.writeStartElement(u"path"_s);
        attribute("d", data);
        attribute("fill", u"none"_s);
        attribute("stroke-linejoin", u"round"_s);
        stroke(colour.name, colour.paper, width, dashes);
        m_xml.writeEndElement();
    }
    void dot(double x, double y, const Colour& colour, bool isSquare)
    {
        m_xml.writeStartElement(isSquare ? u"rect"_s : u"circle"_s);
        attribute(isSquare ? "x" : "cx", number(isSquare ? x - 3.5 : x));
        attribute(isSquare ? "y" : "cy", number(isSquare ? y - 3.5 : y));
        if (isSquare) {
            attribute("width", u"7"_s);
            attribute("height", u"7"_s);
        } else {
            attribute("r", u"3.8"_s);
        }
        attribute("fill", QLatin1StringView(colour.paper));
        attribute("class", QLatin1StringView(colour.name) + u"f"_s);
        m_xml.writeEndElement();
    }
    void text(double x, double y, const QString& words, const char* anchor = "start",
              bool isDim = true, double turn = 0.0)
    {
        m_xml.writeStartElement(u"text"_s);
        attribute("x", number(x));
        attribute("y", number(y));
        attribute("text-anchor", QLatin1StringView(anchor));
        attribute("fill", isDim ? u"#59636E"_s : u"#1F2328"_s);
        attribute("class", isDim ? u"dim"_s : u"ink"_s);
        if (turn != 0.0) {
            attribute("transform", u"rotate(%1 %2 %3)"_s.arg(turn).arg(number(x), number(y)));
        }
        m_xml.writeCharacters(printable(words));
        m_xml.writeEndElement();
    }
    /// Grid lines and figures; `digits` follow from the step.
    void ticksLeft(const Scale& scale, const Scale& across, int wanted)
    {
        const double step = scale.step(wanted);
        const int digits = std::max(0, -int(std::floor(std::log10(step) + 1e-9)));
        for (double at = std::ceil(scale.from / step - 1e-9) * step; at <= scale.to + step * 1e-6;
             at += step) {
            const bool isZero = std::abs(at) < step * 1e-6;
            line(across.begin, scale.px(at), across.end, scale.px(at), isZero ? "zero" : "grid",
                 isZero ? "#8C959F" : "#DFE3E8");
            text(across.begin - 6, scale.px(at) + 4, figure(isZero ? 0.0 : at, digits), "end");
        }
    }
    void ticksBelow(const Scale& scale, double top, double bottom, bool hasFigures)
    {
        const double step = scale.step(9);
        const int digits = std::max(0, -int(std::floor(std::log10(step) + 1e-9)));
        for (double at = std::ceil(scale.from / step - 1e-9) * step; at <= scale.to + step * 1e-6;
             at += step) {
            line(scale.px(at), top, scale.px(at), bottom, "grid", "#DFE3E8");
            if (hasFigures) {
                text(scale.px(at), bottom + 16,
                     figure(std::abs(at) < step * 1e-6 ? 0.0 : at, digits), "middle");
            }
        }
    }
    [[nodiscard]] QByteArray end()
    {
        m_xml.writeEndElement();
        return m_svg;
    }

private:
    void attribute(const char* name, const QString& value)
    {
        m_xml.writeAttribute(QLatin1StringView(name), value);
    }
    void stroke(const char* className, const char* paper, double width, const char* dashes)
    {
        attribute("class", QLatin1StringView(className));
        attribute("stroke", QLatin1StringView(paper));
        attribute("stroke-width", QString::number(width));
        if (dashes != nullptr) {
            attribute("stroke-dasharray", QLatin1StringView(dashes));
        }
    }
    QByteArray m_svg;
    QXmlStreamWriter m_xml;
};

QString point(double x, double y)
{
    return number(x) + u',' + number(y);
}

/// What a motor was told, as a staircase.
QString speedPath(const BenchTrace& trace, MotorId motor, const Scale& x, const Scale& y)
{
    QString data;
    double level = y.px(0.0);
    double lastX = -1.0;
    for (const BenchTrace::Order& order : trace.orders) {
        if (order.motor != motor) {
            continue;
        }
        const double at = x.px(BenchTrace::secondsOf(order.tick));
        const double to = y.px(order.action == MotorOrder::Action::Brake ? 0 : order.amount);
        if (data.isEmpty()) {
            data = u"M"_s + point(x.begin, level);
        }
        if (at - lastX >= 0.3 || to != level) {
            data += u"L"_s + point(at, level) + u"L"_s + point(at, to);
            lastX = at;
        }
        level = to;
    }
    return data.isEmpty() ? data : data + u"L"_s + point(x.end, level);
}

QString currentPath(const BenchTrace& trace, MotorId motor, const Scale& x, const Scale& y)
{
    QString data;
    const std::size_t count = trace.samples.size();
    double before = -1.0;
    if (count <= kMostPoints) {
        for (std::size_t i = 0; i < count; ++i) {
            const double at = BenchTrace::secondsOf(trace.samples[i].tick);
            const bool isGap = i == 0 || at - before > BenchTrace::kGapSeconds;
            data += (isGap ? u"M"_s : u"L"_s) + point(x.px(at), y.px(trace.amperes(i, motor)));
            before = at;
        }
        return data;
    }
    std::size_t i = 0;
    for (int column = 0; column < kColumns && i < count; ++column) {
        const double end = x.from + (x.to - x.from) * (column + 1) / kColumns;
        double low = HUGE_VAL;
        double high = -HUGE_VAL;
        const double first = BenchTrace::secondsOf(trace.samples[i].tick);
        double last = first;
        for (; i < count && BenchTrace::secondsOf(trace.samples[i].tick) <= end; ++i) {
            last = BenchTrace::secondsOf(trace.samples[i].tick);
            low = std::min(low, trace.amperes(i, motor));
            high = std::max(high, trace.amperes(i, motor));
        }
        if (high < low) {
            continue; // nothing was read here: a gap
        }
        const double at = x.begin + (x.end - x.begin) * (column + 0.5) / kColumns;
        const bool isGap = before < 0.0 || first - before > BenchTrace::kGapSeconds;
        data += (isGap ? u"M"_s : u"L"_s) + point(at, y.px(high)) + u"L"_s
            + point(at, y.px(low) + (low == high ? 0.1 : 0.0));
        before = last;
    }
    return data;
}

double topOf(const BenchTrace& trace, MotorId motor)
{
    double top = 0.2;
    for (std::size_t i = 0; i < trace.samples.size(); ++i) {
        top = std::max(top, trace.amperes(i, motor));
    }
    return top * 1.08;
}

void drawMarks(Drawing& drawing, const BenchTrace& trace, const Scale& x, double bottom)
{
    int labels = 0;
    for (const BenchTrace::Event& event : trace.events) {
        labels += event.severity == 0 ? 1 : 0;
    }
    double free = x.begin; // where the next label may begin
    for (const BenchTrace::Event& event : trace.events) {
        const bool isFirst = &event == trace.events.data(); // "Started", at 0
        if (isFirst || (event.severity == 0 && labels > kMostMarks)) {
            continue;
        }
        const double at = x.px(event.seconds);
        const bool isBad = event.severity > 0;
        drawing.line(at, kTop, at, bottom, isBad ? "bad" : "mark", isBad ? "#C4232B" : "#8C959F",
                     1.0, isBad ? nullptr : "2 3");
        const double width = 6.5 * double(event.text.size());
        if (at >= free && at + width < x.end && event.text.size() < 28) {
            drawing.text(at + 3, kTop - 8, event.text);
            free = at + width + 14.0;
        }
    }
}

BenchPlot timePlot(const BenchOutcome& outcome)
{
    const BenchTrace& trace = outcome.trace;
    std::vector<MotorId> measured;
    for (const MotorId motor : bench::kMeasured) {
        if (bench::isDriven(trace, motor)) {
            measured.push_back(motor);
        }
    }
    const int panels = 1 + int(measured.size());
    const int height = kTop + panels * kPanel + (panels - 1) * kGap + kBottom;
    const QString title = Bench::tr("Speeds and currents over time");
    Drawing drawing(height, title);
    const Scale x{0.0, std::max(trace.seconds, 0.1), kLeft, kWidth - kRight};
    double top = kTop;
    const Scale speeds{-135.0, 135.0, top + kPanel, top};
    drawing.ticksBelow(x, top, top + kPanel, false);
    drawing.ticksLeft(speeds, x, 4);
    drawing.text(16, top + kPanel / 2.0, Bench::tr("speed"), "middle", false, -90.0);
    constexpr std::array<const char*, 3> kDashes{nullptr, "7 4", "2 3"};
    for (const MotorId motor : {MotorId::Motor1, MotorId::Motor2, MotorId::Aux}) {
        drawing.path(speedPath(trace, motor, x, speeds), colourOf(motor), 1.6,
                     kDashes.at(std::size_t(motor)));
    }
    for (const MotorId motor : measured) {
        top += kPanel + kGap;
        const Scale amperes{0.0, topOf(trace, motor), top + kPanel, top};
        drawing.ticksBelow(x, top, top + kPanel, motor == measured.back());
        drawing.ticksLeft(amperes, x, 4);
        drawing.text(16, top + kPanel / 2.0, bench::titleOf(motor) + u", A"_s, "middle", false,
                     -90.0);
        drawing.path(currentPath(trace, motor, x, amperes), colourOf(motor), 1.1);
    }
    drawMarks(drawing, trace, x, top + kPanel);
    drawing.text((x.begin + x.end) / 2.0, height - 6, Bench::tr("time, s"), "middle", false);
    return {title, drawing.end(), {kWidth, height}};
}

BenchPlot curvePlot(const QString& title, const std::vector<const BenchCurve*>& curves)
{
    Drawing drawing(kCurveHeight + kTop + kBottom, title);
    Scale x{HUGE_VAL, -HUGE_VAL, kLeft, kWidth - kRight};
    Scale y{0.0, 0.0, kTop + kCurveHeight, kTop};
    for (const BenchCurve* curve : curves) {
        for (const BenchCurve::Point& each : curve->points) {
            x.from = std::min(x.from, each.x);
            x.to = std::max(x.to, each.x);
            y.from = std::min(y.from, each.y);
            y.to = std::max(y.to, each.y);
        }
    }
    const double margin = std::max((x.to - x.from) * 0.03, 0.5);
    x.from -= margin;
    x.to += margin;
    y.to += std::max((y.to - y.from) * 0.08, 0.01);
    drawing.ticksBelow(x, kTop, kTop + kCurveHeight, true);
    drawing.ticksLeft(y, x, 6);
    double legend = x.begin;
    for (std::size_t i = 0; i < curves.size(); ++i) {
        const BenchCurve& curve = *curves[i];
        const Colour& colour = colourOf(curve.motor);
        const bool isSquare = curve.motor == MotorId::Motor2;
        const char* dashes = i % 2 == 1 ? "7 4" : nullptr;
        QString data;
        for (const BenchCurve::Point& each : curve.points) {
            data += (data.isEmpty() ? u"M"_s : u"L"_s) + point(x.px(each.x), y.px(each.y));
        }
        drawing.path(data, colour, 1.3, dashes);
        for (const BenchCurve::Point& each : curve.points) {
            drawing.dot(x.px(each.x), y.px(each.y), colour, isSquare);
        }
        drawing.line(legend, 12, legend + 26, 12, colour.name, colour.paper, 1.6, dashes);
        drawing.dot(legend + 13, 12, colour, isSquare);
        drawing.text(legend + 32, 16, curve.title, "start", false);
        legend += 50.0 + 7.2 * double(curve.title.size());
    }
    drawing.text((x.begin + x.end) / 2.0, kCurveHeight + kTop + kBottom - 6, curves[0]->xTitle,
                 "middle", false);
    drawing.text(16, kTop + kCurveHeight / 2.0, curves[0]->yTitle, "middle", false, -90.0);
    return {title, drawing.end(), {kWidth, kCurveHeight + kTop + kBottom}};
}

} // namespace

std::vector<BenchPlot> plotsOf(const BenchOutcome& outcome)
{
    std::vector<BenchPlot> plots;
    if (!outcome.trace.orders.empty()) {
        plots.push_back(timePlot(outcome));
    }
    std::vector<QString> groups;
    for (const BenchCurve& curve : outcome.curves) {
        if (std::ranges::find(groups, curve.group) == groups.end()) {
            groups.push_back(curve.group);
        }
    }
    for (const QString& group : groups) {
        std::vector<const BenchCurve*> curves;
        for (const BenchCurve& curve : outcome.curves) {
            if (curve.group == group) {
                curves.push_back(&curve);
            }
        }
        plots.push_back(curvePlot(group, curves));
    }
    return plots;
}

} // namespace trex
