// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/parameters/writepreview.h"

#include "protocol/codec/packet.h"

#include <QCoreApplication>

using namespace Qt::Literals::StringLiterals;

namespace trex {
namespace {

struct WritePreview {
    Q_DECLARE_TR_FUNCTIONS(WritePreview)
};

QString lineOf(const SettingWrite& write, const ParameterModel& model, const LineSettings& line)
{
    QString text = write.text();
    if (write.row != nullptr) {
        const auto from = write.rawFrom
            ? std::optional(ValueInContext{*write.rawFrom, model.deviceContext(*write.row)})
            : std::nullopt;
        text = u"%1: %2"_s.arg(
            write.title(), changeText(*write.row, from, {write.rawTo, model.context(*write.row)}));
    }
    const QByteArray bytes = encode(write.command(), line).toHex(' ').toUpper();
    return u"%1  [%2]"_s.arg(text, QString::fromLatin1(bytes));
}

} // namespace

QString writePreview(const TransferPlan& plan, const ParameterModel& model,
                     const LineSettings& line)
{
    if (plan.writes.empty()) {
        return (QStringList(WritePreview::tr("Nothing to write.")) + plan.leftOut).join(u'\n');
    }
    QStringList changes;
    QStringList late;
    QStringList advice;
    for (const auto& write : plan.writes) {
        changes << lineOf(write, model, line);
        if (write.row == nullptr) {
            continue;
        }
        if (write.needsReset()) {
            late << write.title();
        }
        for (const auto& remark : model.advice(write.row->number)) {
            advice << u"▲ "_s + remark;
        }
    }
    const QString notes = advice.isEmpty() ? QString()
                                           : u' '
            + (advice.size() == 1 ? WritePreview::tr("(▲ 1 note below)")
                                  : WritePreview::tr("(▲ %1 notes below)").arg(advice.size()));
    QStringList lines{changes.size() == 1
                          ? WritePreview::tr("Will be written: %1").arg(changes.first())
                          : WritePreview::tr("Will be written, %1 settings%2:")
                                .arg(QString::number(changes.size()), notes)};
    if (changes.size() > 1) {
        lines += changes;
    }
    if (!late.isEmpty()) {
        lines << WritePreview::tr("Needs a power cycle afterwards: %1.").arg(late.join(u", "_s));
    }
    return (lines + advice + plan.leftOut).join(u'\n');
}

} // namespace trex
