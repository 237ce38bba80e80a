// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/parameters/factoryresetdialog.h"

#include "protocol/session/controller.h"
#include "widgets/common/fitting.h"
#include "widgets/common/panel.h"
#include "widgets/common/stopbutton.h"
#include "widgets/common/theme.h"

#include <QBoxLayout>
#include <QCheckBox>
#include <QDialogButtonBox>
#include <QLabel>
#include <QPushButton>

using namespace Qt::Literals::StringLiterals;

namespace trex {
namespace {

QString explanation()
{
    const QStringList sentences{
        FactoryResetDialog::tr("All parameters in the controller go back to the factory's values. "
                               "Calibrations stay."),
        FactoryResetDialog::tr("First the whole configuration, calibrations included, is saved to "
                               "a file, from which Load brings it back."),
        FactoryResetDialog::tr("The factory's values are in force after the controller's power "
                               "was switched off and on."),
        FactoryResetDialog::tr("From then on the line is 19200 baud without error detection, one "
                               "stop bit, device number 7: that is what to connect with."),
        FactoryResetDialog::tr("≈ That parameter 0x7F with the value 0x7F does this was seen in "
                               "use but is not stated by the vendor; that the values wait for the "
                               "power cycle is inferred. What the controller holds afterwards is "
                               "read from it.")};
    return sentences.join(u"\n\n"_s);
}

} // namespace

FactoryResetDialog::FactoryResetDialog(Controller& controller, QWidget* parent) : QDialog(parent)
{
    setObjectName(u"parameters.factoryResetDialog"_s);
    setWindowTitle(tr("Reset all parameters"));
    setAttribute(Qt::WA_DeleteOnClose);
    auto* const title = new QLabel(tr("Reset all parameters?"), this);
    title->setFont(theme::font(1.25));
    auto* const text = named(new QLabel(explanation(), this), u"parameters.factoryReset.text"_s);
    text->setWordWrap(true);
    auto* const confirm = named(new QCheckBox(tr("&Yes, all parameters may be overwritten"), this),
                                u"parameters.factoryReset.confirm"_s);
    auto* const buttons =
        new QDialogButtonBox(QDialogButtonBox::Ok | QDialogButtonBox::Cancel, this);
    auto* const reset =
        named(buttons->button(QDialogButtonBox::Ok), u"parameters.factoryReset.reset"_s);
    auto* const cancel =
        named(buttons->button(QDialogButtonBox::Cancel), u"parameters.factoryReset.cancel"_s);
    reset->setText(tr("&Save, then reset"));
    reset->setEnabled(false);
    reset->setAutoDefault(false);
    cancel->setText(tr("Cancel"));
    cancel->setDefault(true);

    auto* const top = new QHBoxLayout;
    top->addWidget(title, 1);
    top->addWidget(named(new StopButton(controller, this), u"parameters.factoryReset.stop"_s));
    auto* const layout = new QVBoxLayout(this);
    layout->addLayout(top);
    layout->addWidget(text, 1);
    layout->addWidget(confirm);
    layout->addWidget(buttons);
    resizeToFit(*this, {520, 380});
    connect(confirm, &QCheckBox::toggled, reset, &QPushButton::setEnabled);
    connect(buttons, &QDialogButtonBox::accepted, this, &QDialog::accept);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    cancel->setFocus();
}

} // namespace trex
