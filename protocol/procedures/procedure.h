// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "protocol/result.h"

#include <QObject>

namespace trex {

/// A task of several steps over a controller: started, reports progress, ends once with finished().
/// Main thread; never blocks.
class Procedure : public QObject {
    Q_OBJECT
    Q_DISABLE_COPY_MOVE(Procedure)

public:
    explicit Procedure(QObject* parent = nullptr);
    ~Procedure() override;

    virtual void start() = 0;
    virtual void cancel() = 0; ///< ends with finished(Cancelled) when it runs
    [[nodiscard]] bool isRunning() const { return m_isRunning; }

signals:
    /// `done` of `total` steps; the text is a sentence for people.
    void progressed(int done, int total, const QString& text);
    void finished(const trex::Result<void>& result);

protected:
    void setRunning(); ///< from start()
    void finish(const Result<void>& result); ///< emits finished() when it runs, else nothing

private:
    bool m_isRunning = false;
};

} // namespace trex
