// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/script/screenshots.h"

#include "app/script/objectfinder.h"
#include "protocol/errortext.h"
#include "protocol/savefile.h"
#include "widgets/panelregistry.h"

#include <QBuffer>
#include <QDir>
#include <QFileInfo>
#include <QPixmap>
#include <QWidget>

namespace trex {

using namespace Qt::Literals::StringLiterals;

namespace {

constexpr qint64 kSettleMs = 120; ///< layouts and live views have had a few frames by then

StepResult write(StepContext& context, QWidget& widget, const QString& file)
{
    const QString path = QDir(context.folder).filePath(file);
    QByteArray png;
    QBuffer buffer(&png);
    SaveFile target(path);
    const bool ok = QDir().mkpath(QFileInfo(path).absolutePath())
        && buffer.open(QIODevice::WriteOnly) && widget.grab().save(&buffer, "PNG")
        && target.open(QIODevice::WriteOnly) && target.write(png) == png.size() && target.commit();
    if (!ok) { // without a reason of its own: the folder cannot be made
        return {Verdict::Failed,
                target.error() == QFileDevice::NoError
                    ? errorText({ErrorCode::FileUnwritable, path})
                    : u"Could not write %1: %2"_s.arg(path, target.errorString())};
    }
    context.screenshots << file;
    return {};
}

/// True once the widget has been in view for a while; `phase` counts on when it begins to be.
bool hasSettled(StepContext& context, QWidget& widget)
{
    if (!bringForward(&widget)) {
        context.phaseBeganMs = context.elapsedMs;
        return false;
    }
    return context.elapsedMs - context.phaseBeganMs >= kSettleMs;
}

} // namespace

StepResult screenshot(StepContext& context, QWidget& widget, const QString& file)
{
    if (hasSettled(context, widget)) {
        return write(context, widget, file);
    }
    return context.elapsedMs < context.timeoutMs
        ? StepResult{Verdict::Pending, {}}
        : StepResult{Verdict::Failed, u"It cannot be brought into view."_s};
}

StepResult screenshotEveryPanel(StepContext& context)
{
    const std::span<const PanelRow> rows = panels();
    const PanelRow& row = rows[static_cast<std::size_t>(context.phase)];
    const QString id = QString::fromUtf8(row.id.data(), static_cast<qsizetype>(row.id.size()));
    const Found found = findObject(id);
    auto* widget = qobject_cast<QWidget*>(found.object);
    if (widget == nullptr) {
        return {Verdict::Failed, found.problem};
    }
    if (!hasSettled(context, *widget)) {
        return context.elapsedMs < context.timeoutMs + context.phase * 1000
            ? StepResult{Verdict::Pending, {}}
            : StepResult{Verdict::Failed, u"\"%1\" cannot be brought into view."_s.arg(id)};
    }
    if (StepResult result = write(context, *widget, id + u".png"_s);
        result.verdict != Verdict::Done) {
        return result;
    }
    context.phaseBeganMs = context.elapsedMs;
    ++context.phase;
    return {static_cast<std::size_t>(context.phase) < rows.size() ? Verdict::Pending
                                                                  : Verdict::Done,
            {}};
}

} // namespace trex
