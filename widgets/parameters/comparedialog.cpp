// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/parameters/comparedialog.h"

#include "protocol/errortext.h"
#include "protocol/procedures/configtransfer.h"
#include "protocol/session/controller.h"
#include "widgets/common/filedialogs.h"
#include "widgets/common/fitting.h"
#include "widgets/common/stopbutton.h"
#include "widgets/common/theme.h"

#include <QBoxLayout>
#include <QClipboard>
#include <QComboBox>
#include <QDialogButtonBox>
#include <QFileInfo>
#include <QGuiApplication>
#include <QHeaderView>
#include <QLabel>
#include <QPushButton>
#include <QSignalBlocker>
#include <QTreeWidget>

#include <algorithm>

using namespace Qt::Literals::StringLiterals;

namespace trex {
namespace {

enum Source { FromController, FromDefaults, FromFile };

/// Calibrations are no difference to the defaults: the vendor states none.
Configuration withoutCalibrations(Configuration configuration)
{
    configuration.calibrations.clear();
    return configuration;
}

} // namespace

CompareDialog::CompareDialog(PanelContext& context, QWidget* parent)
    : QDialog(parent)
    , m_context(context)
    , m_table(named(new QTreeWidget(this), u"parameters.comparison.table"_s, tr("Differences")))
    , m_summary(named(new QLabel(this), u"parameters.comparison.summary"_s))
{
    setObjectName(u"parameters.comparison"_s);
    setWindowTitle(tr("Compare settings"));
    setAttribute(Qt::WA_DeleteOnClose);
    buildSide(m_left, u"left"_s, tr("Left side"));
    buildSide(m_right, u"right"_s, tr("Right side"));
    m_right.source->setCurrentIndex(m_right.source->findData(FromDefaults));
    m_table->setColumnCount(4);
    m_table->setRootIsDecorated(false);
    m_table->setUniformRowHeights(true);
    m_table->setSelectionMode(QAbstractItemView::ExtendedSelection);
    m_summary->setWordWrap(true);

    auto* const sides = new QHBoxLayout;
    for (const auto* const side : {&m_left, &m_right}) {
        sides->addWidget(side->source, 1);
        sides->addWidget(side->open);
        sides->addSpacing(8);
    }
    sides->addWidget(
        named(new StopButton(context.controller, this), u"parameters.comparison.stop"_s));
    auto* const buttons = new QDialogButtonBox(QDialogButtonBox::Close, this);
    auto* const copyButton =
        named(new QPushButton(theme::icon(u"copy"_s), tr("&Copy as text"), this),
              u"parameters.comparison.copy"_s);
    buttons->addButton(copyButton, QDialogButtonBox::ActionRole);
    auto* const layout = new QVBoxLayout(this);
    layout->addLayout(sides);
    layout->addWidget(m_summary);
    layout->addWidget(m_table, 1);
    layout->addWidget(buttons);
    resizeToFit(*this, {780, 480});
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    connect(copyButton, &QPushButton::clicked, this, &CompareDialog::copy);
    const auto& settings = context.deviceSettings;
    connect(&settings, &DeviceSettings::parameterChanged, this, &CompareDialog::refresh);
    connect(&settings, &DeviceSettings::calibrationChanged, this, &CompareDialog::refresh);
    connect(&settings, &DeviceSettings::forgotten, this, &CompareDialog::refresh);
    refresh();
}

void CompareDialog::buildSide(Side& side, const QString& part, const QString& title)
{
    side.source = named(new QComboBox(this), u"parameters.comparison."_s + part, title);
    side.source->addItem(tr("In the controller"), FromController);
    side.source->addItem(tr("Factory defaults"), FromDefaults);
    side.source->setSizeAdjustPolicy(QComboBox::AdjustToContents);
    side.open = named(new QPushButton(theme::icon(u"load"_s), tr("File…"), this),
                      u"parameters.comparison.%1File"_s.arg(part), tr("%1: a file").arg(title));
    side.open->setAutoDefault(false);
    connect(side.source, &QComboBox::currentIndexChanged, this, &CompareDialog::refresh);
    connect(side.open, &QPushButton::clicked, this, [this, &side] { openFile(side); });
}

void CompareDialog::openFile(Side& side)
{
    m_context.fileDialogs.askOpen(this, tr("Settings to compare"), tr("Configuration (*.json)"),
                                  [this, &side](const QString& path) { loadFile(side, path); });
}

void CompareDialog::loadFile(Side& side, const QString& path)
{
    const auto loaded = loadConfiguration(path);
    if (!loaded) {
        m_summary->setText(u"▲ "_s + errorText(loaded.error()));
        theme::setTextColour(*m_summary, ColourRole::Fault);
        return;
    }
    side.file = *loaded;
    {
        const QSignalBlocker blocker(side.source);
        if (const int old = side.source->findData(FromFile); old >= 0) {
            side.source->removeItem(old);
        }
        side.source->addItem(QFileInfo(path).fileName(), FromFile);
        side.source->setCurrentIndex(side.source->count() - 1);
    }
    refresh();
}

Configuration CompareDialog::configuration(const Side& side) const
{
    switch (side.source->currentData().toInt()) {
    case FromDefaults:
        return factoryDefaults();
    case FromFile:
        return side.file.value_or(Configuration{});
    default:
        return presentConfiguration(m_context.controller, m_context.deviceSettings);
    }
}

void CompareDialog::refresh()
{
    const auto isDefaults = [](const Side& side) {
        return side.source->currentData().toInt() == FromDefaults;
    };
    Configuration left = configuration(m_left);
    Configuration right = configuration(m_right);
    const bool hasNoCalibrations = isDefaults(m_left) || isDefaults(m_right);
    if (hasNoCalibrations) {
        left = withoutCalibrations(left);
        right = withoutCalibrations(right);
    }
    const auto originOf = [&isDefaults](const Side& side) {
        return isDefaults(side) ? SettingsOrigin::Factory : SettingsOrigin::Held;
    };
    m_settings =
        compare(left, right, m_context.controller.model(), originOf(m_left), originOf(m_right));
    m_table->clear();
    m_table->setHeaderLabels(
        {tr("Key"), tr("Setting"), m_left.source->currentText(), m_right.source->currentText()});
    for (const auto& each : m_settings) {
        auto* const item =
            new QTreeWidgetItem(m_table, QStringList{each.key, each.title, each.left, each.right});
        item->setForeground(0, theme::colour(ColourRole::DimText));
    }
    for (int column = 0; column < m_table->columnCount(); ++column) {
        constexpr int kGap = 16;
        m_table->resizeColumnToContents(column);
        m_table->setColumnWidth(column, m_table->columnWidth(column) + kGap);
    }
    constexpr int kAround = 48; // margins, and a scroll bar
    constexpr int kWidest = 1100;
    resize(std::max(width(), std::min(m_table->header()->length() + kAround, kWidest)), height());
    const bool isUnread = left.parameters.empty() || right.parameters.empty();
    QString summary = isUnread   ? tr("The controller's settings are not read: connect first.")
        : m_settings.empty()     ? tr("No differences.")
        : m_settings.size() == 1 ? tr("1 setting differs.")
                                 : tr("%1 settings differ.").arg(m_settings.size());
    if (hasNoCalibrations && !isUnread) {
        summary += u' '
            + tr("Calibrations are left out: their defaults are not known. Defaults marked ≈ are "
                 "guesses: the vendor does not state them.");
    }
    m_summary->setText(summary);
    theme::setTextColour(*m_summary, ColourRole::Text);
}

void CompareDialog::copy() const
{
    QGuiApplication::clipboard()->setText(
        comparisonText(m_settings, m_left.source->currentText(), m_right.source->currentText()));
}

} // namespace trex
