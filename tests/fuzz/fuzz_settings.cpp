// SPDX-License-Identifier: GPL-3.0-or-later
// The settings file: any bytes as one. Whatever is in it, it is read or put aside, never lost, and
// what is read as the settings of a line can be used.
#include "protocol/storage/linesettingsstore.h"
#include "tests/fuzz/sentence.h"

#include <QCoreApplication>
#include <QDir>
#include <QFile>
#include <QTemporaryDir>

using namespace trex;
using namespace Qt::Literals::StringLiterals;
using fuzz::holds;

namespace {

const QString kPort = u"/dev/ttyUSB0"_s;

QByteArray contents(const QString& path)
{
    QFile file(path);
    return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
}

void use(SettingsFile& file)
{
    LineSettingsStore lines(file);
    holds(!lines.lastPort().isEmpty(), "there is a port to begin with");
    const auto last = lines.lastGood(kPort);
    holds(!last || validate(*last).has_value(), "settings of a line are in range");
    for (const int number : lines.numbersInUse(kPort)) {
        holds(number >= 0 && number <= 127, "a device number is one");
    }
    (void)file.value(Setting<int>{u"motion/maximum1"_s, 127});
    (void)file.value(Setting<bool>{u"safety/motorFault"_s, true});
    (void)file.value(Setting<QByteArray>{u"ui/geometry"_s, {}});
    LineSettings wanted;
    wanted.baud = 115200;
    wanted.device = 3;
    lines.remember(kPort, wanted);
    holds(lines.lastGood(kPort) == wanted, "what was stored is there");
}

} // namespace

extern "C" int LLVMFuzzerInitialize(int* argc, char*** argv)
{
    static QCoreApplication application(*argc, *argv);
    return 0;
}

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
    static const QString root = QDir(u"/dev/shm"_s).exists() ? u"/dev/shm"_s : QDir::tempPath();
    static QTemporaryDir folder(root + u"/trex-fuzz-XXXXXX"_s);
    const QString path = folder.filePath(fuzz::fileName());
    const QString aside = path + u".damaged"_s;
    QFile::remove(aside);
    fuzz::Input input(data, size);
    const QByteArray bytes = input.rest();
    {
        QFile file(path);
        holds(file.open(QIODevice::WriteOnly | QIODevice::Truncate), "the file can be written");
        file.write(bytes);
    }
    SettingsFile file(path);
    if (file.problem()) {
        holds(contents(aside) == bytes, "a damaged file is kept as it was");
        holds(!errorText(*file.problem()).isEmpty(), "a damaged file is told");
    } else {
        holds(!QFile::exists(aside), "a good file is not put aside");
    }
    use(file);
    return 0;
}
