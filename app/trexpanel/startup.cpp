// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/trexpanel/startup.h"

#include "app/common/logging.h"

#include <QCoreApplication>
#include <QFontInfo>
#include <QGuiApplication>

#include <cstdlib>

namespace trex {

using namespace Qt::Literals::StringLiterals;

namespace {

constexpr int kCannotStart = 2;
QtMessageHandler before = nullptr;

QString words(const char* text)
{
    return QCoreApplication::translate("Options", text);
}

void tellFatal(QtMsgType type, const QMessageLogContext& context, const QString& text)
{
    if (type != QtFatalMsg) {
        before(type, context, text);
        return;
    }
    QStringList displays;
    for (const char* name : {"QT_QPA_PLATFORM", "WAYLAND_DISPLAY", "DISPLAY"}) {
        if (const QString value = qEnvironmentVariable(name); !value.isEmpty()) {
            displays << u"%1=%2"_s.arg(QLatin1StringView(name), value);
        }
    }
    const QString which = displays.isEmpty()
        ? words(QT_TRANSLATE_NOOP("Options", "there is no display"))
        : words(QT_TRANSLATE_NOOP("Options", "%1 does not answer")).arg(displays.join(u", "_s));
    printMessage(words(QT_TRANSLATE_NOOP("Options",
                                         "trexpanel: no window can be shown: %1. Start it in a "
                                         "graphical session, or with --offscreen, which needs no "
                                         "display."))
                     .arg(which));
    std::_Exit(kCannotStart); // else Qt aborts, and leaves a core
}

} // namespace

DisplayGuard::DisplayGuard() : m_before(qInstallMessageHandler(tellFatal))
{
    before = m_before;
}

DisplayGuard::~DisplayGuard()
{
    qInstallMessageHandler(m_before);
}

bool hasFonts()
{
    // Not the families: fontconfig's own aliases are there without a font behind them.
    if (!QFontInfo(QGuiApplication::font()).family().isEmpty()) {
        return true;
    }
    printMessage(words(QT_TRANSLATE_NOOP("Options",
                                         "trexpanel: no font is installed, so that nothing could "
                                         "be read. Install one (fonts-dejavu-core on Debian), or "
                                         "see to fontconfig's configuration.")));
    return false;
}

} // namespace trex
