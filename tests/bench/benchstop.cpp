// SPDX-License-Identifier: GPL-3.0-or-later
// Stop latency: from the request on the main thread to the moment when the last stop byte has been
// handed to the line, at three speeds of the line, idle, at full polling, and with lost bytes. The
// bound is what the controller's deafness costs: the transaction in flight, the stop packets on the
// wire, and 2 ms for the program.
#include "protocol/codec/packet.h"
#include "protocol/session/controller.h"
#include "protocol/session/linkengine.h"
#include "protocol/sim/faults.h"
#include "tests/bench/benchsections.h"

#include <QCoreApplication>
#include <QElapsedTimer>

#include <cstdio>

namespace trex::bench {

namespace {

using namespace Qt::Literals::StringLiterals;
using namespace std::chrono_literals;

constexpr int kStops = 200; ///< each case
constexpr auto kProgram = 2ms;
constexpr int kReplyBytes = 10; ///< of the longest poll
constexpr int kRequestBytes = 2;

enum class Load { Idle, Polling, Drops };

double milliseconds(Duration duration)
{
    return std::chrono::duration<double, std::milli>(duration).count();
}

double boundMs(const LineSettings& line, Load load)
{
    Duration bound = kProgram;
    for (const Command& command : stopCommands(false)) {
        bound += line.timeOf(static_cast<int>(encode(command, line).size()));
    }
    if (load != Load::Idle) {
        bound += line.timeOf(kRequestBytes + kReplyBytes);
    }
    return milliseconds(bound);
}

bool spin(const std::function<bool()>& until, int longestMs)
{
    QElapsedTimer elapsed;
    elapsed.start();
    while (!until() && elapsed.elapsed() < longestMs) {
        QCoreApplication::processEvents(QEventLoop::AllEvents, 1);
    }
    return until();
}

std::vector<double> measure(const LineSettings& line, Load load)
{
    Controller controller(nullptr, nullptr);
    QObject panel;
    if (load != Load::Idle) {
        for (const PollRow& row : kPolls) {
            controller.want(&panel, row.id, row.hertz);
        }
    }
    OpenOptions options;
    options.port = u"sim:?baud=%1"_s.arg(line.baud);
    if (load == Load::Drops) {
        options.port += u"&fault=drop=0.1"_s;
    }
    options.line = line;
    controller.open(options);
    std::vector<double> latencies;
    if (!spin([&] { return controller.state() == LinkState::Connected; }, 20'000)) {
        return latencies;
    }
    sim::Random random(7);
    for (int i = 0; i < kStops; ++i) {
        // At a moment of its own within what the line does.
        const auto pause = static_cast<int>(20 + 60 * random.unit());
        QElapsedTimer elapsed;
        elapsed.start();
        spin([&] { return elapsed.elapsed() >= pause; }, pause + 1);
        if (!spin([&] { return controller.state() == LinkState::Connected; }, 10'000)) {
            break;
        }
        std::ignore = controller.arm();
        const Instant asked = std::chrono::steady_clock::now();
        std::optional<double> took;
        bool isOver = false;
        controller.stop(Controller::StopKind::Coast, &panel, [&](const Result<Reply>& reply) {
            isOver = true;
            if (reply) {
                took = milliseconds(reply->sent - asked);
            }
        });
        spin([&] { return isOver; }, 5000);
        if (took) {
            latencies.push_back(*took);
        }
    }
    return latencies;
}

double quantile(std::vector<double> values, double share)
{
    if (values.empty()) {
        return -1.0;
    }
    std::sort(values.begin(), values.end());
    const auto index = static_cast<std::size_t>(share * static_cast<double>(values.size() - 1));
    return values.at(index);
}

} // namespace

void measureStop(Results& results)
{
    struct LoadRow {
        Load load;
        const char* key;
        const char* title;
    };
    for (const int baud : {1200, 19200, 115200}) {
        for (const LoadRow& row : {LoadRow{Load::Idle, "idle", "idle"},
                                   LoadRow{Load::Polling, "polling", "full polling"},
                                   LoadRow{Load::Drops, "drops", "full polling, 10 % drops"}}) {
            LineSettings line;
            line.baud = baud;
            const std::vector<double> latencies = measure(line, row.load);
            const QString key = u"stop.%1.%2"_s.arg(baud).arg(QLatin1StringView(row.key));
            const QString title =
                u"stop, %1 baud, %2"_s.arg(baud).arg(QLatin1StringView(row.title));
            const auto add = [&](const char* part, double value) {
                results.add(key + u'.' + QLatin1StringView(part),
                            title + u": "_s + QLatin1StringView(part), value, u"ms"_s);
            };
            add("p50", quantile(latencies, 0.5));
            add("p99", quantile(latencies, 0.99));
            add("max", quantile(latencies, 1.0));
            add("bound", boundMs(line, row.load));
        }
    }
}

} // namespace trex::bench
