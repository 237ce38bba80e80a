// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/script/condition.h"

#include "app/script/objectfinder.h"

#include <QAbstractItemView>
#include <QComboBox>
#include <QJsonObject>
#include <QRegularExpression>
#include <QVariant>

#include <optional>

namespace trex {

using namespace Qt::Literals::StringLiterals;

namespace {

/// The property, and the few that Qt calls otherwise or keeps in the model.
QVariant propertyOf(const QObject& object, const QString& name)
{
    QVariant variant = object.property(name.toUtf8().constData());
    if (variant.isValid()) {
        return variant;
    }
    if (const auto* combo = qobject_cast<const QComboBox*>(&object); combo != nullptr) {
        if (name == "text"_L1) {
            return combo->currentText();
        }
        return name == "value"_L1 ? combo->currentData() : QVariant();
    }
    if (const auto* view = qobject_cast<const QAbstractItemView*>(&object);
        view != nullptr && view->model() != nullptr && name == "rowCount"_L1) {
        return view->model()->rowCount(view->rootIndex());
    }
    return {};
}

/// A number, or the number that a text begins with ("2.20 A").
std::optional<double> numberOf(const QVariant& variant)
{
    bool ok = false;
    const double number = variant.toDouble(&ok);
    if (ok) {
        return number;
    }
    static const QRegularExpression leading(u"^\\s*([-+\u2212]?\\d+(?:[.,]\\d+)?)"_s);
    const QRegularExpressionMatch match = leading.match(variant.toString());
    if (!match.hasMatch()) {
        return std::nullopt;
    }
    return match.captured(1).replace(u'\u2212', u'-').replace(u',', u'.').toDouble();
}

bool isEqual(const QVariant& variant, const QJsonValue& wanted)
{
    if (wanted.isBool()) {
        return variant.toBool() == wanted.toBool();
    }
    if (wanted.isDouble()) {
        bool ok = false;
        const double number = variant.toDouble(&ok);
        return ok && std::abs(number - wanted.toDouble()) < 1e-9;
    }
    return variant.toString() == wanted.toString();
}

QString shown(const QVariant& variant)
{
    const QString text = variant.typeId() == QMetaType::QStringList
        ? variant.toStringList().join(u", "_s)
        : variant.toString();
    return u"\"%1\""_s.arg(text.size() > 200 ? text.left(200) + u"…"_s : text);
}

bool holds(const QVariant& variant, const QJsonValue& condition)
{
    if (const QJsonValue wanted = condition["equals"_L1]; !wanted.isUndefined()) {
        if (!isEqual(variant, wanted)) {
            return false;
        }
    }
    if (const QJsonValue pattern = condition["matches"_L1]; !pattern.isUndefined()) {
        if (!QRegularExpression(pattern.toString()).match(variant.toString()).hasMatch()) {
            return false;
        }
    }
    for (const auto bound : {"min"_L1, "max"_L1}) {
        const QJsonValue limit = condition[bound];
        if (limit.isUndefined()) {
            continue;
        }
        const std::optional<double> number = numberOf(variant);
        const bool isIn = number
            && (bound == "min"_L1 ? *number >= limit.toDouble() : *number <= limit.toDouble());
        if (!isIn) {
            return false;
        }
    }
    return true;
}

QString wish(const QJsonValue& condition)
{
    QStringList parts;
    for (const auto field : {"equals"_L1, "matches"_L1, "min"_L1, "max"_L1}) {
        if (const QJsonValue value = condition[field]; !value.isUndefined()) {
            parts << u"%1 \"%2\""_s.arg(field, value.toVariant().toString());
        }
    }
    return parts.join(u", "_s);
}

} // namespace

QString conditionProblem(const QJsonValue& condition)
{
    if (!condition.isObject()) {
        return u"not an object"_s;
    }
    int tests = 0;
    const QJsonObject object = condition.toObject();
    for (auto field = object.begin(); field != object.end(); ++field) {
        const QString key = field.key();
        const bool isName = key == "object"_L1 || key == "property"_L1;
        if ((isName || key == "matches"_L1)
            && (!field->isString() || field->toString().isEmpty())) {
            return u"\"%1\" is no text"_s.arg(key);
        }
        if ((key == "min"_L1 || key == "max"_L1) && !field->isDouble()) {
            return u"\"%1\" is no number"_s.arg(key);
        }
        if (key == "equals"_L1 && (field->isObject() || field->isArray() || field->isNull())) {
            return u"\"equals\" is neither a number, a text, true nor false"_s;
        }
        if (key == "matches"_L1 && !QRegularExpression(field->toString()).isValid()) {
            return u"\"matches\" is no regular expression"_s;
        }
        if (!isName) {
            if (key != "equals"_L1 && key != "matches"_L1 && key != "min"_L1 && key != "max"_L1) {
                return u"there is no field \"%1\""_s.arg(key);
            }
            ++tests;
        }
    }
    if (!object.contains("object"_L1) || !object.contains("property"_L1)) {
        return u"\"object\" or \"property\" is missing"_s;
    }
    return tests == 0 ? u"neither \"equals\", \"matches\", \"min\" nor \"max\""_s : QString();
}

QString unmetCondition(const QJsonValue& condition)
{
    const QString name = condition["object"_L1].toString();
    const QString property = condition["property"_L1].toString();
    const Found found = findObject(name);
    if (found.object == nullptr) {
        return found.problem;
    }
    const QVariant variant = propertyOf(*found.object, property);
    if (!variant.isValid()) {
        return u"\"%1\" has no property \"%2\"."_s.arg(name, property);
    }
    if (holds(variant, condition)) {
        return {};
    }
    return u"%1 of \"%2\" is %3, wanted %4."_s.arg(property, name, shown(variant), wish(condition));
}

} // namespace trex
