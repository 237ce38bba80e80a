// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/plots/plotexport.h"

#include "protocol/savefile.h"
#include "protocol/telemetry/streamtable.h"
#include "widgets/plots/plotstack.h"

#include <QBuffer>
#include <QCoreApplication>
#include <QPainter>
#include <QSvgGenerator>

namespace trex {

namespace {

constexpr double kPngScale = 2.0;
constexpr int kSvgResolution = 96; ///< a pixel of the screen is a unit of the picture

Result<void> write(const QString& path, const QByteArray& content)
{
    SaveFile file(path);
    const bool isFine = isFileOrNew(path);
    if (!isFine || !file.open(QIODevice::WriteOnly) || file.write(content) != content.size()
        || !file.commit()) {
        const QString cause = isFine ? file.errorString()
                                     : QCoreApplication::translate("CsvExport", "not a plain file");
        return fail(ErrorCode::FileUnwritable, QStringLiteral("%1: %2").arg(path, cause));
    }
    return {};
}

} // namespace

Result<std::size_t> exportPlotsCsv(const QString& path, const TelemetryStore& store,
                                   std::span<const QString> keys, Model model,
                                   std::optional<InputKind> input, std::optional<TimeRange> range)
{
    CsvOptions options;
    options.model = model;
    options.input = input;
    options.range = range;
    for (const QString& key : keys) {
        const int index = streamIndex(key.toStdString());
        if (index >= 0) {
            options.polls.at(streams()[static_cast<std::size_t>(index)].source.index()) = true;
        }
    }
    return exportSamplesCsv(path, store, options);
}

QImage pictureOf(PlotStack& stack, double scale)
{
    QImage image(stack.pictureSize() * scale, QImage::Format_RGB32);
    image.setDevicePixelRatio(scale);
    QPainter painter(&image);
    stack.renderTo(painter);
    return image;
}

Result<void> exportPlotsPng(const QString& path, PlotStack& stack)
{
    QByteArray content;
    QBuffer buffer(&content);
    buffer.open(QIODevice::WriteOnly);
    pictureOf(stack, kPngScale).save(&buffer, "PNG");
    return write(path, content);
}

Result<void> exportPlotsSvg(const QString& path, PlotStack& stack)
{
    QByteArray content;
    QBuffer buffer(&content);
    buffer.open(QIODevice::WriteOnly);
    QSvgGenerator generator;
    generator.setOutputDevice(&buffer);
    generator.setSize(stack.pictureSize());
    generator.setViewBox(QRect(QPoint(), stack.pictureSize()));
    generator.setResolution(kSvgResolution);
    generator.setTitle(QCoreApplication::translate("Plots", "Plots"));
    generator.setDescription(
        QStringLiteral("TReX Panel %1").arg(QCoreApplication::applicationVersion()));
    QPainter painter(&generator);
    stack.renderTo(painter);
    painter.end();
    return write(path, content);
}

} // namespace trex
