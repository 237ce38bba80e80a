// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/trexctl/controllertext.h"

#include "app/trexctl/failure.h"
#include "app/trexctl/output.h"

#include <QStringList>

namespace trex {

QString modeText(Mode mode)
{
    switch (mode) {
    case Mode::Rc:
        return Cli::tr("RC mode");
    case Mode::Analog:
        return Cli::tr("analog mode");
    case Mode::SerialRc:
        return Cli::tr("serial mode, RC inputs");
    case Mode::SerialAnalog:
        break;
    }
    return Cli::tr("serial mode, analog inputs");
}

QString channelList(std::uint8_t mask)
{
    QStringList numbers;
    for (int channel = 1; channel <= kChannelCount; ++channel) {
        if ((mask >> (channel - 1) & 1) != 0) {
            numbers << QString::number(channel);
        }
    }
    return numbers.isEmpty() ? Cli::tr("none") : numbers.join(QStringLiteral(", "));
}

QString latin(std::string_view text)
{
    return QString::fromLatin1(text.data(), static_cast<qsizetype>(text.size()));
}

QString yesNo(bool yes)
{
    return yes ? Cli::tr("yes") : Cli::tr("no");
}

QJsonObject currentJson(int raw, Model model)
{
    return {{QStringLiteral("raw"), raw},
            {QStringLiteral("amperes"), rounded(raw * amperesPerCount(model), 3)}};
}

QString currentText(int raw, Model model)
{
    const QString text = QString::number(raw * amperesPerCount(model), 'f', 2);
    return isGuess(amperesGrade(model)) ? Cli::tr("about %1 A").arg(text)
                                        : QStringLiteral("%1 A").arg(text);
}

} // namespace trex
