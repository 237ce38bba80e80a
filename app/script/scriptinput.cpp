// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/script/scriptinput.h"

#include <QAbstractButton>
#include <QAbstractSlider>
#include <QAction>
#include <QApplication>
#include <QComboBox>
#include <QDialog>
#include <QDialogButtonBox>
#include <QDoubleSpinBox>
#include <QKeySequence>
#include <QLineEdit>
#include <QMenu>
#include <QMessageBox>
#include <QMouseEvent>
#include <QPlainTextEdit>
#include <QPushButton>
#include <QSpinBox>
#include <QWindow>

/// Qt's own way in for its test library: a key press as the platform would bring it, shortcuts
/// included. Exported from QtGui and declared in qtestkey.h, which is not linked into the program.
Q_GUI_EXPORT void qt_handleKeyEvent(QWindow* window, QEvent::Type type, int key,
                                    Qt::KeyboardModifiers modifiers, const QString& text,
                                    bool autorepeat, ushort count);

namespace trex::input {

using namespace Qt::Literals::StringLiterals;

namespace {

bool isNumber(const QVariant& value)
{
    return value.typeId() == QMetaType::Double || value.typeId() == QMetaType::LongLong
        || value.typeId() == QMetaType::Int;
}

/// Signals that only a person's input sends; they are public, so that they can be sent here too.
template <class... Arguments>
void send(QObject& object, const char* signal, Arguments... arguments)
{
    QMetaObject::invokeMethod(&object, signal, Qt::DirectConnection, arguments...);
}

QString outside(double value, double minimum, double maximum)
{
    return u"%1 is outside of %2 to %3."_s.arg(value).arg(minimum).arg(maximum);
}

QString setSlider(QAbstractSlider& slider, const QVariant& value)
{
    if (!isNumber(value)) {
        return u"A slider takes a number."_s;
    }
    const int wanted = value.toInt();
    if (wanted < slider.minimum() || wanted > slider.maximum()) {
        return outside(wanted, slider.minimum(), slider.maximum());
    }
    slider.setSliderDown(true);
    slider.setSliderPosition(wanted);
    slider.setSliderDown(false);
    return {};
}

template <class Box>
QString setSpinBox(Box& box, double wanted)
{
    if (wanted < box.minimum() || wanted > box.maximum()) {
        return outside(wanted, box.minimum(), box.maximum());
    }
    box.setValue(static_cast<decltype(box.value())>(wanted));
    send(box, "editingFinished");
    return {};
}

QString setText(QLineEdit& edit, const QString& text)
{
    if (edit.isReadOnly()) {
        return u"It is read-only."_s;
    }
    edit.setText(text);
    send(edit, "textEdited", Q_ARG(QString, text));
    send(edit, "editingFinished");
    return {};
}

int indexOf(const QComboBox& combo, const QVariant& value)
{
    if (value.typeId() == QMetaType::QString) {
        if (const int index = combo.findText(value.toString()); index >= 0) {
            return index;
        }
    }
    for (int i = 0; i < combo.count(); ++i) {
        const QVariant data = combo.itemData(i);
        if (data.isValid() && data.toString() == value.toString()) {
            return i;
        }
    }
    return combo.findText(value.toString());
}

QString setComboBox(QComboBox& combo, const QVariant& value)
{
    const int index = indexOf(combo, value);
    if (index >= 0) {
        combo.setCurrentIndex(index);
        send(combo, "activated", Q_ARG(int, index));
        send(combo, "textActivated", Q_ARG(QString, combo.itemText(index)));
        return {};
    }
    if (combo.isEditable()) {
        return setText(*combo.lineEdit(), value.toString());
    }
    return u"There is no item \"%1\"."_s.arg(value.toString());
}

QString setProperty(QObject& object, const QString& property, const QVariant& value)
{
    const QByteArray name = property.toUtf8();
    if (object.metaObject()->indexOfProperty(name.constData()) < 0) {
        return u"\"%1\" has no property \"%2\"."_s.arg(object.objectName(), property);
    }
    return object.setProperty(name.constData(), value)
        ? QString()
        : u"The property \"%1\" does not take \"%2\"."_s.arg(property, value.toString());
}

template <class Checkable>
QString setChecked(Checkable& checkable, const QVariant& value)
{
    if (!checkable.isCheckable() || value.typeId() != QMetaType::Bool) {
        return u"It takes true or false, if it can be checked at all."_s;
    }
    return checkable.isChecked() == value.toBool() ? QString() : click(checkable);
}

QString clickMouse(QWidget& widget)
{
    const QPointF where = widget.rect().center();
    const QPointF global = widget.mapToGlobal(where);
    QMouseEvent down(QEvent::MouseButtonPress, where, global, Qt::LeftButton, Qt::LeftButton,
                     Qt::NoModifier);
    QApplication::sendEvent(&widget, &down);
    QMouseEvent up(QEvent::MouseButtonRelease, where, global, Qt::LeftButton, Qt::NoButton,
                   Qt::NoModifier);
    QApplication::sendEvent(&widget, &up);
    return {};
}

/// What a key types, as far as scripts need it.
QString textOf(QKeyCombination combination)
{
    const int key = combination.key();
    if (key < 0x20 || key > 0x7E || (combination.keyboardModifiers() & ~Qt::ShiftModifier)) {
        return {};
    }
    const QChar letter(key);
    return combination.keyboardModifiers() & Qt::ShiftModifier ? QString(letter)
                                                               : QString(letter.toLower());
}

} // namespace

QString click(QObject& object)
{
    if (auto* action = qobject_cast<QAction*>(&object)) {
        if (QMenu* menu = action->menu()) {
            menu->popup(QPoint(0, 0));
            return {};
        }
        action->trigger();
        return {};
    }
    if (auto* button = qobject_cast<QPushButton*>(&object); button != nullptr && button->menu()) {
        // Its own click would wait, in an event loop of the menu, for what the script does next.
        button->menu()->popup(button->mapToGlobal(button->rect().bottomLeft()));
        return {};
    }
    if (auto* button = qobject_cast<QAbstractButton*>(&object)) {
        button->click();
        return {};
    }
    auto* widget = qobject_cast<QWidget*>(&object);
    return widget != nullptr ? clickMouse(*widget) : u"It cannot be clicked."_s;
}

QString set(QObject& object, const QString& property, const QVariant& value)
{
    if (!property.isEmpty()) {
        return setProperty(object, property, value);
    }
    if (auto* slider = qobject_cast<QAbstractSlider*>(&object)) {
        return setSlider(*slider, value);
    }
    if (auto* spin = qobject_cast<QSpinBox*>(&object); spin != nullptr && isNumber(value)) {
        return setSpinBox(*spin, value.toDouble());
    }
    if (auto* spin = qobject_cast<QDoubleSpinBox*>(&object); spin != nullptr && isNumber(value)) {
        return setSpinBox(*spin, value.toDouble());
    }
    if (auto* combo = qobject_cast<QComboBox*>(&object)) {
        return setComboBox(*combo, value);
    }
    if (auto* edit = qobject_cast<QLineEdit*>(&object)) {
        return setText(*edit, value.toString());
    }
    if (auto* button = qobject_cast<QAbstractButton*>(&object)) {
        return setChecked(*button, value);
    }
    if (auto* action = qobject_cast<QAction*>(&object)) {
        return setChecked(*action, value);
    }
    if (auto* edit = qobject_cast<QPlainTextEdit*>(&object)) {
        edit->setPlainText(value.toString());
        return {};
    }
    return u"\"%1\" takes no such value; name a property."_s.arg(object.objectName());
}

QString press(QObject& object, const QString& sequence)
{
    auto* widget = qobject_cast<QWidget*>(&object);
    if (widget == nullptr) {
        return u"It has no keyboard focus."_s;
    }
    widget->window()->activateWindow();
    if (!widget->isWindow() && widget->focusPolicy() != Qt::NoFocus) {
        widget->setFocus(Qt::OtherFocusReason);
    }
    QWindow* window = widget->window()->windowHandle();
    if (window == nullptr) {
        return u"Its window is not open."_s;
    }
    const QKeySequence keys = QKeySequence::fromString(sequence, QKeySequence::PortableText);
    for (int i = 0; i < keys.count(); ++i) {
        const QKeyCombination chord = keys[static_cast<uint>(i)];
        for (const auto type : {QEvent::KeyPress, QEvent::KeyRelease}) {
            qt_handleKeyEvent(window, type, chord.key(), chord.keyboardModifiers(), textOf(chord),
                              false, 1);
        }
    }
    return {};
}

QString answer(QDialog& dialog, bool accept)
{
    if (auto* box = qobject_cast<QMessageBox*>(&dialog)) {
        // By the roles: accept() would not say which button it was.
        const QList<QAbstractButton*> buttons = box->buttons();
        for (QAbstractButton* button : buttons) {
            const QMessageBox::ButtonRole role = box->buttonRole(button);
            const bool isYes = role == QMessageBox::AcceptRole || role == QMessageBox::YesRole
                || role == QMessageBox::DestructiveRole || role == QMessageBox::ApplyRole;
            const bool isNo = role == QMessageBox::RejectRole || role == QMessageBox::NoRole;
            if (accept ? isYes : isNo) {
                button->click();
                return {};
            }
        }
    }
    if (const auto* row = dialog.findChild<QDialogButtonBox*>()) {
        auto* button = row->button(accept ? QDialogButtonBox::Ok : QDialogButtonBox::Cancel);
        if (button != nullptr) {
            if (!button->isEnabled()) {
                return u"Its button is disabled."_s;
            }
            button->click();
            return {};
        }
    }
    accept ? dialog.accept() : dialog.reject();
    return {};
}

} // namespace trex::input
