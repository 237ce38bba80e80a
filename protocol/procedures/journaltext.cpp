// SPDX-License-Identifier: GPL-3.0-or-later
// How journal entries read (writeaudit.h).
#include "protocol/procedures/writeaudit.h"

#include <QCoreApplication>

namespace trex {

using namespace Qt::Literals::StringLiterals;

namespace {

struct JournalText {
    Q_DECLARE_TR_FUNCTIONS(JournalText)
};

QString seenText(const JournalEntry& entry, const QString& sentence)
{
    return entry.resolved.isValid() ? JournalText::tr("%1, found out later").arg(sentence)
                                    : sentence;
}

} // namespace

QString titleOf(const SettingId& setting)
{
    if (setting.row != nullptr) {
        return QCoreApplication::translate("Parameters", setting.row->title);
    }
    SettingWrite write;
    write.input = setting.input;
    write.channel = setting.channel;
    return write.title();
}

QString textOf(const SettingId& setting, const std::optional<SettingValue>& value)
{
    if (!value) {
        return u"–"_s;
    }
    if (const auto* const raw = std::get_if<int>(&*value)) {
        return setting.row != nullptr && accepts(*setting.row, *raw)
            ? parameterText(*setting.row, *raw)
            : QString::number(*raw);
    }
    const auto& c = std::get<Calibration>(*value);
    return u"%1/%2/%3 ±%4"_s.arg(c.minimum).arg(c.neutral).arg(c.maximum).arg(c.deadband);
}

QString changeText(const JournalEntry& entry)
{
    const SettingId& setting = entry.intent.setting;
    const bool isReset = setting.row != nullptr && setting.row->isTrigger;
    return u"%1 → %2"_s.arg(textOf(setting, entry.intent.before),
                            isReset ? JournalText::tr("factory defaults")
                                    : textOf(setting, entry.intent.after));
}

QString resultText(const JournalEntry& entry)
{
    const SettingId& setting = entry.intent.setting;
    switch (entry.conclusion.result) {
    case WriteResult::New:
        return seenText(entry, JournalText::tr("read back as written"));
    case WriteResult::Old:
        return seenText(entry, JournalText::tr("not written: the old value holds"));
    case WriteResult::Other:
        return seenText(entry,
                        JournalText::tr("another value holds: %1")
                            .arg(textOf(setting, entry.conclusion.found)));
    case WriteResult::Answered:
        return JournalText::tr("accepted, not read back");
    case WriteResult::Refused:
        return JournalText::tr("refused: %1").arg(entry.conclusion.detail);
    case WriteResult::Unknown:
        break;
    }
    return entry.resolved.isValid()
        ? JournalText::tr("not known, cannot be read back")
        : JournalText::tr("not known: will be read back when this controller is connected");
}

} // namespace trex
