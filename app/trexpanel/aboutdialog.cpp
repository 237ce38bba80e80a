// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/trexpanel/aboutdialog.h"

#include "app/common/version.h"
#include "widgets/common/fitting.h"
#include "widgets/common/panel.h"
#include "widgets/common/stopbutton.h"
#include "widgets/common/theme.h"

#include <QDialogButtonBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QTextBrowser>

#include <array>

namespace trex {

using namespace Qt::Literals::StringLiterals;

namespace {

struct LicenceRow {
    const char* name;
    const char* licence;
    const char* address;
};

/// What is linked into the program. Names of licences are SPDX identifiers.
constexpr std::array kLicences{
    LicenceRow{"Qt 6 (Core, Gui, Widgets, Network, Serial Port, SVG)", "LGPL-3.0-only",
               "https://www.qt.io"},
    LicenceRow{"Qt Charts", "GPL-3.0-only", "https://www.qt.io"},
    LicenceRow{"tl::expected", "CC0-1.0", "https://github.com/TartanLlama/expected"},
    LicenceRow{"CLI11", "BSD-3-Clause", "https://github.com/CLIUtils/CLI11"},
};

QString licencesHtml()
{
    QString html = u"<table cellspacing=\"4\">"_s;
    for (const LicenceRow& row : kLicences) {
        html += u"<tr><td><a href=\"%3\">%1</a></td><td>%2</td></tr>"_s.arg(
            QString::fromUtf8(row.name), QString::fromUtf8(row.licence),
            QString::fromUtf8(row.address));
    }
    return html + u"</table>"_s;
}

QString aboutHtml()
{
    return AboutDialog::tr(
               "<p>A control panel for the Pololu TReX Jr dual motor controller.</p>"
               "<p>This is free software under the GNU General Public License, version 3 or later "
               "(GPL-3.0-or-later). It comes without any warranty.</p>"
               "<p>Pololu and TReX are names of Pololu Corporation, which has no part in this "
               "program.</p>"
               "<p>The icons are drawn for this program and under the same licence. It is built "
               "with:</p>")
        + licencesHtml();
}

} // namespace

AboutDialog::AboutDialog(Controller& controller, QWidget* parent) : QDialog(parent)
{
    setObjectName(u"about"_s);
    setWindowTitle(tr("About TReX Panel"));
    setAttribute(Qt::WA_DeleteOnClose);
    auto* title = named(new QLabel(u"TReX Panel %1"_s.arg(QLatin1StringView(kVersion)), this),
                        u"about.title"_s);
    title->setFont(theme::font(2));
    auto* icon = new QLabel(this);
    icon->setPixmap(QIcon(u":/icons/trexpanel.svg"_s).pixmap(QSize(48, 48), devicePixelRatioF()));
    auto* stop = named(new StopButton(controller, this), u"about.stop"_s);

    auto* text = named(new QTextBrowser(this), u"about.text"_s, tr("About and licences"));
    text->setOpenExternalLinks(true);
    text->setHtml(aboutHtml());
    text->setFrameShape(QFrame::NoFrame);
    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Close, this);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);

    auto* top = new QHBoxLayout;
    top->addWidget(icon);
    top->addWidget(title, 1);
    top->addWidget(stop);
    auto* layout = new QVBoxLayout(this);
    layout->addLayout(top);
    layout->addWidget(text, 1);
    layout->addWidget(buttons);
    resizeToFit(*this, {560, 420});
    buttons->button(QDialogButtonBox::Close)->setFocus();
}

} // namespace trex
