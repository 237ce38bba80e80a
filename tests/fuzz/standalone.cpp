// SPDX-License-Identifier: GPL-3.0-or-later
// The driver of a fuzz target where there is no libFuzzer: plays the kept corpus, then as many
// mutations of it as asked for, always the same ones. What was being played when the process died
// or hung stands in fuzz_NAME.input.
//
// fuzz_NAME [--runs N] [--seed N] [--dict FILE] [--longest BYTES] (FILE | FOLDER)...
#include "tests/fuzz/fuzzing.h"

#include <QByteArrayList>
#include <QDirIterator>
#include <QFile>
#include <QFileInfo>

#include <algorithm>
#include <csignal>
#include <iterator>
#include <random>
#include <vector>

#include <fcntl.h>
#include <unistd.h>

extern "C" __attribute__((weak)) int LLVMFuzzerInitialize(int* argc, char*** argv);
extern "C" __attribute__((weak)) void __sanitizer_set_death_callback(void (*callback)());

namespace {

constexpr unsigned kLongestSeconds = 100; // for a hundred inputs: one of them hangs

struct Options {
    std::size_t runs = 0;
    std::uint64_t seed = 1;
    qsizetype longest = 4096;
    QByteArrayList words;
    QStringList paths;
};

/// libFuzzer's form: one "word" a line, with \\, \" and \xHH; what stands before it is its name.
QByteArrayList readDictionary(const QString& path)
{
    QFile file(path);
    if (!file.open(QIODevice::ReadOnly)) {
        return {};
    }
    QByteArrayList words;
    while (!file.atEnd()) {
        const QByteArray line = file.readLine().trimmed();
        const qsizetype begin = line.indexOf('"') + 1;
        if (line.startsWith('#') || begin == 0 || !line.endsWith('"')) {
            continue;
        }
        QByteArray word;
        for (qsizetype i = begin; i < line.size() - 1; ++i) {
            if (line[i] == '\\' && line[i + 1] == 'x') {
                word += QByteArray::fromHex(line.mid(i + 2, 2));
                i += 3;
            } else {
                i += line[i] == '\\' ? 1 : 0;
                word += line[i];
            }
        }
        words << word;
    }
    return words;
}

/// The input being played. Whatever ends the process by a signal leaves it in a file.
struct LastInput {
    const char* bytes = nullptr;
    std::size_t size = 0;
    char path[256] = {};
} last;

/// Nothing but what signal-safety(7) allows.
void keepLastInput()
{
    const int file = ::open(last.path, O_WRONLY | O_CREAT | O_TRUNC, 0644);
    if (file >= 0) {
        [[maybe_unused]] const ssize_t written = ::write(file, last.bytes, last.size);
        ::close(file);
    }
}

void keepAndEnd(int signal)
{
    keepLastInput();
    ::signal(signal, SIG_DFL);
    ::raise(signal);
}

void watch(const QByteArray& program)
{
    std::snprintf(last.path, sizeof last.path, "%s.input", program.constData());
    for (const int signal : {SIGABRT, SIGSEGV, SIGBUS, SIGFPE, SIGILL, SIGALRM}) {
        ::signal(signal, keepAndEnd);
    }
    if (__sanitizer_set_death_callback != nullptr) {
        __sanitizer_set_death_callback(keepLastInput);
    }
}

class Mutator {
public:
    Mutator(const Options& options, std::vector<QByteArray> corpus)
        : m_options(options), m_corpus(std::move(corpus)), m_random(options.seed)
    {
        if (m_corpus.empty()) {
            m_corpus.emplace_back();
        }
    }
    [[nodiscard]] QByteArray next()
    {
        QByteArray input = m_corpus[below(m_corpus.size())];
        for (std::size_t count = 1 + below(4); count > 0; --count) {
            mutate(input);
        }
        return input.left(m_options.longest);
    }

private:
    [[nodiscard]] std::size_t below(std::size_t count) { return m_random() % count; }
    [[nodiscard]] qsizetype place(const QByteArray& input)
    {
        return static_cast<qsizetype>(below(static_cast<std::size_t>(input.size()) + 1));
    }
    [[nodiscard]] char anyByte() { return static_cast<char>(below(256)); }
    void mutate(QByteArray& input)
    {
        const qsizetype at = place(input);
        const auto length = static_cast<qsizetype>(1 + below(below(8) == 0 ? 64 : 8));
        switch (below(m_options.words.isEmpty() ? 7 : 9)) {
        case 0:
            if (at < input.size()) {
                input[at] = static_cast<char>(input[at] ^ (1 << below(8)));
            }
            return;
        case 1:
            if (at < input.size()) {
                input[at] = anyByte();
            }
            return;
        case 2:
            input.remove(at, length);
            return;
        case 3:
            for (qsizetype i = 0; i < length; ++i) {
                input.insert(at, anyByte());
            }
            return;
        case 4:
            input.insert(at, input.mid(place(input), length * 4));
            return;
        case 5: { // the beginning of this one and the end of another
            const QByteArray& other = m_corpus[below(m_corpus.size())];
            input = input.first(at) + other.mid(place(other));
            return;
        }
        case 6: {
            constexpr char kTelling[] = {'\0', '\1', '\x7F', '\x80', '\xFF', '0', '9', '"', '{'};
            input.replace(at, 1, QByteArray(1, kTelling[below(std::size(kTelling))]));
            return;
        }
        default: {
            const auto word =
                static_cast<qsizetype>(below(static_cast<std::size_t>(m_options.words.size())));
            input.replace(at, below(2) == 0 ? 0 : length, m_options.words[word]);
            return;
        }
        }
    }

    const Options& m_options;
    std::vector<QByteArray> m_corpus;
    std::mt19937_64 m_random;
};

Options parse(int argc, char** argv)
{
    Options options;
    for (int i = 1; i < argc; ++i) {
        const QByteArray name(argv[i]);
        const QByteArray value(i + 1 < argc ? argv[i + 1] : "");
        if (name == "--runs") {
            options.runs = value.toULongLong();
        } else if (name == "--seed") {
            options.seed = value.toULongLong();
        } else if (name == "--longest") {
            options.longest = value.toLongLong();
        } else if (name == "--dict") {
            options.words = readDictionary(QString::fromLocal8Bit(value));
        } else {
            options.paths << QString::fromLocal8Bit(name);
            --i;
        }
        ++i;
    }
    return options;
}

std::vector<QByteArray> readCorpus(const QStringList& paths)
{
    QStringList files;
    for (const QString& path : paths) {
        if (!QFileInfo(path).isDir()) {
            files << path;
            continue;
        }
        for (QDirIterator each(path, QDir::Files); each.hasNext();) {
            files << each.next();
        }
    }
    files.sort();
    std::vector<QByteArray> corpus;
    for (const QString& path : files) {
        QFile file(path);
        if (!file.open(QIODevice::ReadOnly)) {
            std::fprintf(stderr, "%s cannot be read\n", qPrintable(path));
            std::exit(2);
        }
        corpus.push_back(file.readAll());
    }
    return corpus;
}

void play(const QByteArray& input)
{
    // A buffer of its own, so that a sanitizer sees one byte too far.
    const std::vector<std::uint8_t> exact(input.begin(), input.end());
    last.bytes = input.constData();
    last.size = static_cast<std::size_t>(input.size());
    static int played = 0;
    if (played++ % 100 == 0) {
        ::alarm(kLongestSeconds);
    }
    LLVMFuzzerTestOneInput(exact.data(), exact.size());
}

} // namespace

int main(int argc, char** argv)
{
    if (LLVMFuzzerInitialize != nullptr) {
        LLVMFuzzerInitialize(&argc, &argv);
    }
    const Options options = parse(argc, argv);
    const std::vector<QByteArray> corpus = readCorpus(options.paths);
    watch(QFileInfo(QString::fromLocal8Bit(argv[0])).fileName().toLocal8Bit());
    for (const QByteArray& input : corpus) {
        play(input);
    }
    Mutator mutator(options, corpus);
    for (std::size_t run = 0; run < options.runs; ++run) {
        const QByteArray input = mutator.next();
        play(input);
    }
    std::printf("%zu kept inputs and %zu mutations of them (seed %llu)\n", corpus.size(),
                options.runs, static_cast<unsigned long long>(options.seed));
    return 0;
}
