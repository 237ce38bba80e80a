// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/bench/benchlimitsform.h"

#include "widgets/common/panel.h"

#include <QCheckBox>
#include <QDoubleSpinBox>
#include <QFormLayout>
#include <QLineEdit>
#include <QSpinBox>

namespace trex {

using namespace Qt::Literals::StringLiterals;

namespace {

std::optional<double> valueOf(const QDoubleSpinBox* box)
{
    return box->value() > box->minimum() ? std::optional(box->value()) : std::nullopt;
}

} // namespace

BenchLimitsForm::BenchLimitsForm(QWidget* parent) : QWidget(parent), m_form(new QFormLayout(this))
{
    m_form->setContentsMargins(8, 4, 4, 4);
    m_form->setVerticalSpacing(4);
    m_name = named(new QLineEdit(this), u"bench.name"_s, tr("Name"));
    m_form->addRow(tr("Name"), m_name);
    m_amperes = add(u"amperes"_s, tr("Current"), tr(" A"), 60.0, tr("no limit"),
                    tr("More than this in one motor stops everything"));
    m_forSeconds = add(u"forSeconds"_s, tr("… for"), tr(" s"), 3600.0, tr("a single reading"),
                       tr("How long the current may be above its limit"));
    m_ampereSeconds = add(u"ampereSeconds"_s, tr("Current × time"), tr(" A s"), 1e6, tr("no limit"),
                          tr("More than this in one motor since the start stops everything"));
    m_seconds = add(u"limitSeconds"_s, tr("Duration"), tr(" s"), 86'400.0, tr("as planned"),
                    tr("Longer than this stops everything"));
    m_linkErrors = named(new QSpinBox(this), u"bench.linkErrors"_s, tr("Link errors"));
    m_linkErrors->setRange(-1, 1'000'000);
    m_linkErrors->setSpecialValueText(tr("no limit"));
    m_linkErrors->setToolTip(tr("More replies lost or damaged than this stop everything"));
    m_form->addRow(tr("Link errors"), m_linkErrors);
    m_stale = add(u"stale"_s, tr("No readings for"), tr(" s"), 5.0, {},
                  tr("Without a fresh reading for so long, everything stops"));
    m_stale->setMinimum(0.1);
    m_overCurrent =
        named(new QCheckBox(tr("Stop at over-current bit"), this), u"bench.overCurrent"_s);
    m_form->addRow(QString(), m_overCurrent);
    m_volts = add(u"volts"_s, tr("Supply"), tr(" V"), 60.0, tr("not known"),
                  tr("As you measured it; without it nothing can be given in ohms"));
    connect(m_name, &QLineEdit::textEdited, this, &BenchLimitsForm::tell);
    connect(m_linkErrors, &QSpinBox::valueChanged, this, &BenchLimitsForm::tell);
    connect(m_overCurrent, &QCheckBox::toggled, this, &BenchLimitsForm::tell);
}

QDoubleSpinBox* BenchLimitsForm::add(const QString& name, const QString& title, const QString& unit,
                                     double maximum, const QString& none, const QString& help)
{
    auto* box = named(new QDoubleSpinBox(this), u"bench."_s + name, title);
    box->setRange(0.0, maximum);
    box->setDecimals(2);
    box->setSuffix(unit);
    box->setSpecialValueText(none);
    box->setToolTip(help);
    m_form->addRow(title, box);
    connect(box, &QDoubleSpinBox::valueChanged, this, &BenchLimitsForm::tell);
    return box;
}

void BenchLimitsForm::tell()
{
    if (!m_isFilling) {
        emit edited();
    }
}

void BenchLimitsForm::show(const BenchProfile& profile)
{
    m_isFilling = true;
    if (m_name->text() != profile.name) {
        m_name->setText(profile.name);
    }
    const BenchLimits& limits = profile.limits;
    m_amperes->setValue(limits.amperes.value_or(0.0));
    m_forSeconds->setValue(limits.forSeconds);
    m_ampereSeconds->setValue(limits.ampereSeconds.value_or(0.0));
    m_seconds->setValue(limits.seconds.value_or(0.0));
    m_linkErrors->setValue(limits.linkErrors.value_or(-1));
    m_stale->setValue(profile.staleSeconds());
    m_overCurrent->setChecked(limits.overCurrentStops);
    m_volts->setValue(profile.supplyVolts.value_or(0.0));
    m_isFilling = false;
}

BenchProfile BenchLimitsForm::applied(BenchProfile profile) const
{
    profile.name = m_name->text();
    BenchLimits& limits = profile.limits;
    limits.amperes = valueOf(m_amperes);
    limits.forSeconds = limits.amperes ? m_forSeconds->value() : 0.0;
    limits.ampereSeconds = valueOf(m_ampereSeconds);
    limits.seconds = valueOf(m_seconds);
    limits.linkErrors.reset();
    if (m_linkErrors->value() >= 0) {
        limits.linkErrors = m_linkErrors->value();
    }
    if (m_stale->value() != profile.staleSeconds()) {
        limits.staleSeconds = m_stale->value();
    }
    limits.overCurrentStops = m_overCurrent->isChecked();
    profile.supplyVolts = valueOf(m_volts);
    return profile;
}

} // namespace trex
