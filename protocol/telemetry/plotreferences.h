// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "protocol/telemetry/telemetrystore.h"

#include <QObject>
#include <QString>

namespace trex {

/// Where a reference run lies against the run that is looked at.
enum class Alignment : std::uint8_t {
    View, ///< its start at the left edge of what is visible: it stands still while time goes on
    Start, ///< by time: its start at the start of the run
    Trigger, ///< its first crossing of the trigger's level at the run's latest
    Command, ///< its first step of a commanded speed at the run's latest
};

/// Runs to compare with: other stores whose curves plots draw behind their own. Owns the stores.
/// Main thread.
class PlotReferences : public QObject {
    Q_OBJECT
    Q_DISABLE_COPY_MOVE(PlotReferences)

public:
    struct Run {
        int id = 0;
        std::unique_ptr<const TelemetryStore> store;
        QString name;
        Instant origin; ///< its time zero, in its own store's clock
        Duration offset{0}; ///< the person's own shift to the right, on top of the alignment
        bool isVisible = true;
        double amperesPerCount = 0.0; ///< 0: as the run that is looked at
        std::optional<Instant> trigger; ///< its own anchors, none: it has none
        std::optional<Instant> command;
    };

    explicit PlotReferences(QObject* parent = nullptr) : QObject(parent) { }
    ~PlotReferences() override;

    /// Adds a run under a name that people see; `origin` is what counts as its start (usually
    /// store->start()). Gives its number, which is never used again.
    int add(std::unique_ptr<const TelemetryStore> store, const QString& name, Instant origin,
            double amperesPerCount = 0.0);
    void remove(int id);
    void clear();
    [[nodiscard]] const std::vector<Run>& runs() const { return m_runs; }
    [[nodiscard]] const Run* run(int id) const; ///< null: no such run
    void rename(int id, const QString& name);
    void setVisible(int id, bool visible);
    void setOffset(int id, Duration offset);

    [[nodiscard]] Alignment alignment() const { return m_alignment; }
    void setAlignment(Alignment alignment);
    /// Where the run that is looked at has the moment that `alignment` speaks of; none: it has
    /// none.
    void setAnchor(Alignment alignment, std::optional<Instant> anchor);
    void setTrigger(int id, std::optional<Instant> trigger); ///< a run's own crossing
    /// By how much the run's times are moved to lie on those of the run looked at; none: one of the
    /// two lacks the moment to align by, so that it cannot be drawn.
    [[nodiscard]] std::optional<Duration> shiftOf(const Run& run) const;

signals:
    void changed(); ///< runs, or how they are shown
    void moved(); ///< an anchor: the same runs lie elsewhere

private:
    [[nodiscard]] Run* find(int id);

    std::vector<Run> m_runs;
    Alignment m_alignment = Alignment::View;
    std::array<std::optional<Instant>, 4> m_anchors;
    int m_nextId = 1;
};

/// The samples of [from, to) as a store of their own: a frozen part of a run.
[[nodiscard]] std::unique_ptr<TelemetryStore> copyOf(const TelemetryStore& store, Instant from,
                                                     Instant to);

/// The first moment at or after `from` at which a commanded speed leaves zero; none: never.
[[nodiscard]] std::optional<Instant> firstCommandStep(const TelemetryStore& store, Instant from);
/// The last such moment before `to`.
[[nodiscard]] std::optional<Instant> lastCommandStep(const TelemetryStore& store, Instant to);

} // namespace trex
