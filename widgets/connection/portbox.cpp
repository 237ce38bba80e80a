// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/connection/portbox.h"

#include <QAbstractItemView>
#include <QLineEdit>
#include <QWheelEvent>

namespace trex {

using namespace Qt::Literals::StringLiterals;
using namespace std::chrono_literals;

namespace {

constexpr auto kLookAgain = 1s; ///< a plugged-in adapter shows up within this

/// "ttyUSB0 — FT232R (FTDI)": the name first, since a narrow field shows the beginning.
QString textOf(const PortInfo& info)
{
    const QString name = shortPortName(info.port);
    QString about = info.description;
    if (!info.manufacturer.isEmpty()) {
        about = about.isEmpty() ? info.manufacturer : u"%1 (%2)"_s.arg(about, info.manufacturer);
    }
    return about.isEmpty() ? name : u"%1 — %2"_s.arg(name, about);
}

} // namespace

QString simulatorAddress()
{
    return u"sim:?scenario=:/stick.json"_s;
}

QString shortPortName(const QString& address)
{
    if (address.startsWith("sim:"_L1)) {
        return PortBox::tr("simulated controller");
    }
    return address.contains("://"_L1) ? address : address.section(u'/', -1);
}

PortBox::PortBox(QWidget* parent) : QComboBox(parent), m_lister(availablePorts), m_timer(this)
{
    setEditable(true);
    setInsertPolicy(NoInsert);
    setCompleter(nullptr); // it would turn a typed address into an item that begins alike
    setSizeAdjustPolicy(AdjustToMinimumContentsLengthWithIcon);
    setMinimumContentsLength(12);
    m_timer.setInterval(kLookAgain);
    connect(&m_timer, &QTimer::timeout, this, &PortBox::refresh);
    connect(this, &QComboBox::activated, this, [this] { emit addressEdited(address()); });
    connect(lineEdit(), &QLineEdit::textEdited, this, [this] { emit addressEdited(address()); });
    fill();
    setCurrentIndex(0);
}

QString PortBox::address() const
{
    const QString text = currentText();
    if (currentIndex() >= 0 && itemText(currentIndex()) == text) {
        return currentData().toString(); // of several that read alike, the one that was chosen
    }
    const int index = findText(text, Qt::MatchFixedString | Qt::MatchCaseSensitive);
    return index >= 0 ? itemData(index).toString() : text.trimmed();
}

void PortBox::setAddress(const QString& address)
{
    const int index = findData(address);
    setCurrentIndex(index);
    if (index < 0) {
        setEditText(address);
    }
    lineEdit()->setCursorPosition(0);
}

void PortBox::setNetworkAddress(const QString& address)
{
    if (address != m_network) {
        m_network = address;
        fill();
    }
}

QString PortBox::firstAdapter() const
{
    const auto isUsb = [](const PortInfo& info) { return info.vendorId != 0; };
    const auto found = std::find_if(m_ports.begin(), m_ports.end(), isUsb);
    return found == m_ports.end() ? QString() : found->port;
}

void PortBox::setLister(Lister lister)
{
    m_lister = std::move(lister);
    refresh();
}

void PortBox::refresh()
{
    const QList<PortInfo> ports = m_lister();
    if (ports == m_ports || view()->isVisible()) {
        return; // an open list does not change under the pointer
    }
    m_ports = ports;
    fill();
    emit portsChanged();
}

/// Rebuilds the items; the address stays. Typed text stays as it is, with its cursor.
void PortBox::fill()
{
    const QString text = currentText();
    const QString before = address();
    const bool isTyped = findText(text, Qt::MatchFixedString | Qt::MatchCaseSensitive) < 0;
    const int cursor = lineEdit()->cursorPosition();
    const QSignalBlocker blocker(this);
    clear();
    addItem(tr("Simulated controller"), simulatorAddress());
    for (const PortInfo& info : std::as_const(m_ports)) {
        addItem(textOf(info), info.port);
        setItemData(count() - 1, info.port, Qt::ToolTipRole);
    }
    if (!m_network.isEmpty()) {
        addItem(m_network, m_network);
    }
    if (isTyped) {
        setCurrentIndex(-1);
        setEditText(text);
        lineEdit()->setCursorPosition(cursor);
    } else {
        setAddress(before);
    }
}

void PortBox::showEvent(QShowEvent* event)
{
    QComboBox::showEvent(event);
    refresh();
    m_timer.start();
}

void PortBox::hideEvent(QHideEvent* event)
{
    m_timer.stop();
    QComboBox::hideEvent(event);
}

void PortBox::focusInEvent(QFocusEvent* event)
{
    QComboBox::focusInEvent(event);
    refresh();
}

void PortBox::wheelEvent(QWheelEvent* event)
{
    event->ignore(); // a wheel that scrolls the panel must not choose another port
}

} // namespace trex
