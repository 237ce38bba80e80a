// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/bench/benchsamples.h"
#include "tests/bench/benchsections.h"

namespace trex::bench {

using namespace std::chrono_literals;
using namespace Qt::Literals::StringLiterals;

namespace {

constexpr double kNsPerUs = 1e3;
constexpr int kColumns = 900;

struct Figures {
    double appendNs = 0.0; ///< a sample of a motor
    double bytes = 0.0; ///< a sample of a motor: value, time and pyramid
    double queryUs = 0.0; ///< a row of kColumns pixels over everything
};

Figures measure(std::size_t count, std::size_t limit)
{
    const double samples = 2.0 * double(count);
    TelemetryStore store;
    store.setMemoryLimit(limit);
    Figures figures;
    ThreadTimer timer;
    fillCurrents(store, count, Instant(1'000'000s));
    figures.appendNs = timer.ns() / samples;
    figures.bytes = double(store.memoryBytes()) / samples;
    const TimeSeries& series = store.series("motor1-current");
    const Duration span = std::int64_t(series.size() - series.first()) * kSampleStep;
    const ColumnGrid grid{series.time(series.first()), span / kColumns, kColumns};
    std::vector<PlotColumn> columns;
    std::vector<double> query;
    for (int i = 0; i < 20; ++i) {
        timer.restart();
        series.columns(grid, columns);
        query.push_back(timer.ns() / kNsPerUs);
    }
    figures.queryUs = median(query);
    return figures;
}

} // namespace

void measureStore(Results& results)
{
    constexpr std::array<std::size_t, 5> kCounts{1'000, 10'000, 100'000, 1'000'000, 10'000'000};
    constexpr std::size_t kCeiling = 4U << 20U; // a tenth of what 10⁷ take
    constexpr int kRounds = 5;
    std::array<std::vector<Figures>, kCounts.size() + 1> all; // the last one: at a ceiling
    for (int round = 0; round < kRounds; ++round) { // one after another: noise meets them alike
        for (std::size_t i = 0; i < kCounts.size(); ++i) {
            for (std::size_t again = 0; again < (kCounts[i] <= 10'000 ? 9 : 1); ++again) {
                all[i].push_back(measure(kCounts[i], 0));
            }
        }
        all.back().push_back(measure(kCounts[3], kCeiling));
    }
    const auto medianOf = [&all](std::size_t i, double Figures::*figure) {
        std::vector<double> values;
        for (const Figures& each : all[i]) {
            values.push_back(each.*figure);
        }
        return median(values);
    };
    for (std::size_t i = 0; i < all.size(); ++i) {
        const bool isCeiling = i == kCounts.size();
        const QString n = isCeiling ? u"the ceiling"_s : u"%1"_s.arg(double(kCounts[i]), 0, 'g', 1);
        const QString key = isCeiling ? u"ceiling"_s : n;
        results.add(u"store.append."_s + key, u"store: append at %1"_s.arg(n),
                    medianOf(i, &Figures::appendNs), u"ns a sample"_s);
        results.add(u"store.query."_s + key, u"store: a row of 900 pixels at %1"_s.arg(n),
                    medianOf(i, &Figures::queryUs), u"us"_s);
        if (!isCeiling && kCounts[i] >= 100'000) { // below, a chunk is not full
            results.add(u"store.bytes."_s + key, u"store: memory of the currents at %1"_s.arg(n),
                        medianOf(i, &Figures::bytes), u"bytes a sample"_s);
        }
    }
    results.add(u"store.append.growth"_s, u"store: append at 1e+07 / at 1e+04"_s,
                medianOf(4, &Figures::appendNs) / medianOf(1, &Figures::appendNs), {});
}

} // namespace trex::bench
