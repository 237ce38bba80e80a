// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/bench/benchsections.h"

#include "protocol/codec/packet.h"
#include "protocol/session/controller.h"

#include <QCoreApplication>
#include <QElapsedTimer>
#include <QEventLoop>
#include <QFile>
#include <QProcess>
#include <QTemporaryDir>
#include <QTimer>

#include <fcntl.h>
#include <poll.h>
#include <termios.h>
#include <unistd.h>

namespace trex::bench {

using namespace std::chrono_literals;
using namespace Qt::Literals::StringLiterals;

namespace {

constexpr auto kMeasure = 3s;

struct Query {
    QByteArray packet;
    int replyBytes;
};

/// What the link is to carry: polls with the rates that are asked for.
using Mix = std::vector<std::pair<PollId, double>>;

Query queryOf(PollId poll)
{
    const Command command = pollCommand(poll);
    // A masked query of all five channels answers so many bytes for each.
    const int channels = pollRow(poll).hasMask ? kChannelCount : 1;
    return {encode(command, LineSettings{}), command.row().replyBytes * channels};
}

/// Ten times what the panels want: more than any line carries, so that it is always busy.
Mix fullMix()
{
    Mix mix;
    for (const PollRow& row : kPolls) {
        mix.emplace_back(row.id, row.hertz * 10.0);
    }
    return mix;
}

Mix backToBack()
{
    return {{PollId::Currents, 20'000.0}};
}

/// Transactions a second that fit on the wire with nothing between them.
double capacity(const Mix& mix, int baud)
{
    double bytes = 0.0;
    double rate = 0.0;
    for (const auto& [poll, hertz] : mix) {
        const Query query = queryOf(poll);
        bytes += hertz * double(query.packet.size() + query.replyBytes);
        rate += hertz;
    }
    constexpr double kBitsPerByte = 10.0;
    return baud / kBitsPerByte * rate / bytes;
}

/// The floor: write, poll, read; nothing is decoded, nothing is kept.
class BareLoop {
public:
    explicit BareLoop(const QString& path) : m_file(::open(qPrintable(path), O_RDWR | O_NOCTTY))
    {
        termios settings{};
        tcgetattr(m_file, &settings);
        cfmakeraw(&settings);
        tcsetattr(m_file, TCSANOW, &settings);
        tcflush(m_file, TCIOFLUSH);
    }
    ~BareLoop() { ::close(m_file); }
    Q_DISABLE_COPY_MOVE(BareLoop)

    double transactionsPerSecond(const Mix& mix)
    {
        // Each poll in proportion to its rate: the one that is furthest behind is next.
        std::vector<double> due(mix.size(), 0.0);
        std::vector<Query> queries;
        for (const auto& [poll, hertz] : mix) {
            queries.push_back(queryOf(poll));
        }
        int count = 0;
        QElapsedTimer timer;
        timer.start();
        while (std::chrono::milliseconds(timer.elapsed()) < kMeasure) {
            const auto next = std::size_t(std::min_element(due.begin(), due.end()) - due.begin());
            due[next] += 1.0 / mix[next].second;
            if (!transact(queries[next])) {
                return 0.0;
            }
            ++count;
        }
        return count * 1e3 / double(timer.elapsed());
    }

private:
    [[nodiscard]] bool transact(const Query& query) const
    {
        constexpr int kLongestMs = 1000;
        if (::write(m_file, query.packet.constData(), std::size_t(query.packet.size())) < 0) {
            return false;
        }
        std::array<char, 64> buffer{};
        for (int got = 0; got < query.replyBytes;) {
            pollfd wait{m_file, POLLIN, 0};
            if (::poll(&wait, 1, kLongestMs) <= 0) {
                return false;
            }
            const ssize_t bytes = ::read(m_file, buffer.data(), buffer.size());
            if (bytes <= 0) {
                return false;
            }
            got += int(bytes);
        }
        return true;
    }
    int m_file;
};

void spin(std::chrono::milliseconds time)
{
    QEventLoop loop;
    QTimer::singleShot(time, &loop, &QEventLoop::quit);
    loop.exec();
}

double ourTransactionsPerSecond(const QString& path, int baud, const Mix& mix)
{
    Controller controller(nullptr, nullptr);
    OpenOptions options;
    options.port = path;
    options.line.baud = baud;
    controller.open(options);
    QElapsedTimer timer;
    timer.start();
    while (controller.state() != LinkState::Connected && timer.elapsed() < 5000) {
        spin(20ms);
    }
    const QObject who;
    for (const auto& [poll, hertz] : mix) {
        controller.want(&who, poll, hertz);
    }
    spin(500ms);
    const quint64 before = controller.stats().transactions;
    timer.restart();
    spin(kMeasure);
    const double rate =
        double(controller.stats().transactions - before) * 1e3 / double(timer.elapsed());
    controller.close();
    spin(200ms);
    return rate;
}

void measureLine(Results& results, const QString& name, int baud, const Mix& mix)
{
    const QTemporaryDir folder;
    const QString link = folder.filePath(u"line"_s);
    QProcess simulator;
    simulator.start(
        QStringLiteral(TREX_CTL_PROGRAM),
        {u"simulate"_s, u"--pty"_s, link, u"--pace"_s, u"--baud"_s, QString::number(baud)});
    if (!simulator.waitForReadyRead(5000)) {
        qWarning("trexctl simulate does not start");
        return;
    }
    std::vector<double> ours;
    std::vector<double> bare;
    for (int run = 0; run < 3; ++run) {
        bare.push_back(BareLoop(link).transactionsPerSecond(mix));
        ours.push_back(ourTransactionsPerSecond(link, baud, mix));
    }
    simulator.terminate();
    simulator.waitForFinished(5000);

    const double fits = capacity(mix, baud);
    const QString key = u"line.%1.%2."_s.arg(name).arg(baud);
    const QString title = u"line: %1 at %2 baud, "_s.arg(name).arg(baud);
    results.add(key + u"ours"_s, title + u"ours"_s, median(ours), u"transactions/s"_s);
    results.add(key + u"bare"_s, title + u"bare termios loop"_s, median(bare), u"transactions/s"_s);
    results.add(key + u"wire"_s, title + u"what the wire can carry"_s, fits, u"transactions/s"_s);
    results.add(key + u"ofBare"_s, title + u"ours / bare loop"_s, median(ours) / median(bare), {});
    results.add(key + u"ofWire"_s, title + u"ours / wire"_s, median(ours) / fits, {});
}

} // namespace

void measureLines(Results& results)
{
    for (const int baud : {19200, 115200}) {
        measureLine(results, u"full mix"_s, baud, fullMix());
        measureLine(results, u"back to back"_s, baud, backToBack());
    }
}

} // namespace trex::bench
