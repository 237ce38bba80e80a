// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <QString>

#include <functional>
#include <optional>

class QWidget;

namespace trex {

/// Asks for file names. A script answers ahead of time; else a (non-blocking) dialog asks the
/// person.
class FileDialogs : public QObject {
    Q_OBJECT
    Q_DISABLE_COPY_MOVE(FileDialogs)

public:
    using Handler = std::function<void(const QString& path)>;
    explicit FileDialogs(QObject* parent = nullptr) : QObject(parent) { }

    void answerNext(const QString& path); ///< the next question gets this answer without a dialog
    /// Forgets an answer that nobody asked for; true when there was one.
    bool takeAnswerBack();
    [[nodiscard]] bool isAnswerWaiting() const { return m_answer.has_value(); }
    /// The handler is not called when the person cancels.
    void askSave(QWidget* parent, const QString& title, const QString& suggestion,
                 const QString& filter, const Handler& handler);
    void askOpen(QWidget* parent, const QString& title, const QString& filter,
                 const Handler& handler);

    void askFolder(QWidget* parent, const QString& title, const QString& folder,
                   const Handler& handler);

private:
    [[nodiscard]] bool takeAnswer(QWidget* parent, const Handler& handler);
    void ask(QWidget* parent, const QString& title, const QString& suggestion,
             const QString& filter, bool save, const Handler& handler);
    std::optional<QString> m_answer;
};

} // namespace trex
