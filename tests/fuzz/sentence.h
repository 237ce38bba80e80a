// SPDX-License-Identifier: GPL-3.0-or-later
// What a refused file has to say: one sentence about what is wrong, and where.
#pragma once

#include "protocol/errortext.h"
#include "tests/fuzz/fuzzing.h"

#include <QString>

namespace trex::fuzz {

/// A name that no input has in it by chance, and that a careless arg() would spoil.
inline QString fileName()
{
    return QStringLiteral("Datei \u00FC %1 %2.json");
}

/// What was said stands above what does not hold.
inline void say(const QString& text)
{
    static const bool isAsked = std::getenv("TREX_FUZZ_SAY") != nullptr;
    if (isAsked) {
        std::fprintf(stderr, "%s\n", qPrintable(text));
    }
}

/// Holds that the error names the file, and is one line that fits on a screen.
inline void holdsSentence(const Error& error)
{
    say(error.context);
    holds(error.code == ErrorCode::FileMalformed || error.code == ErrorCode::FileUnreadable,
          "a file is refused as a file");
    holds(error.context.contains(fileName()), "a refusal names the file");
    holds(error.context.size() > fileName().size() + 5, "a refusal says why");
    const QString text = errorText(error);
    holds(text.size() < 600, "a refusal is a sentence, not the file");
    for (const QChar each : text) {
        const QChar::Category kind = each.category();
        holds(kind != QChar::Other_Control && kind != QChar::Separator_Line
                  && kind != QChar::Separator_Paragraph,
              "a refusal is one line");
    }
}

/// And a place in it, between the name and the reason: a line, or the key that is not there.
inline void holdsPlace(const Error& error)
{
    holdsSentence(error);
    holds(error.context.startsWith(fileName() + QStringLiteral(", "))
              && error.context.contains(QStringLiteral(": ")),
          "a refusal says where");
}

} // namespace trex::fuzz
