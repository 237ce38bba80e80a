// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QList>
#include <QObject>
#include <QTranslator>

#include <utility>

namespace trex {

/// The languages that are built in: English, and one for each :/i18n/trex_xx.qm. GUI thread.
class Languages : public QObject {
    Q_OBJECT
    Q_DISABLE_COPY_MOVE(Languages)

public:
    using Language = std::pair<QString, QString>; ///< code ("de"), name in that language itself
    explicit Languages(QObject* parent = nullptr) : QObject(parent) { }

    [[nodiscard]] static QList<Language> available();
    [[nodiscard]] static bool isAvailable(const QString& code);
    /// "" chooses by the system's settings. Windows that exist keep their words until built anew.
    void use(const QString& code);
    [[nodiscard]] QString inUse() const { return m_inUse; }

private:
    QString m_inUse = QStringLiteral("en");
    QTranslator m_ours;
    QTranslator m_qt;
};

} // namespace trex
