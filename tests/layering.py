#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Holds the sources against the rules that a compiler cannot check, and names every line that breaks one.

Usage: layering.py [SOURCE_DIR]
"""
import re
import sys
from pathlib import Path

CODE = ("protocol", "widgets", "app")
HEADERS_OF_THE_CODEC_THAT_THE_SIMULATOR_MAY_READ = {"parametertable.h", "quantities.h", "linesettings.h"}
# Tables, and one class template, which has to live in its header.
TABLES = {"commandtable.h", "parametertable.h", "valuecolumn.h"}
COMMAND_BYTES = ({*range(0x81, 0x88), *range(0x8D, 0x96), 0x9F, *range(0xA0, 0xA5), 0xAF}
                 | {*range(0xC0, 0xF2)})
FACTORY_RESET_KEY = "factory-reset"  # not a value that anyone edits


class Source:
    """One file: its lines as written, and as code (comments out), with and without string contents."""

    def __init__(self, root, path):
        self.name = path.relative_to(root).as_posix()
        self.folder = self.name.split("/")[0]
        self.area = "/".join(self.name.split("/")[:2])
        self.lines = path.read_text(encoding="utf-8").split("\n")
        if self.lines and not self.lines[-1]:
            self.lines.pop()
        text = "\n".join(self.lines)
        self.with_strings = without_comments(text, keep_strings=True).split("\n")
        self.code = without_comments(text, keep_strings=False).split("\n")

    def is_in(self, *folders):
        return any(self.name.startswith(folder + "/") for folder in folders)


TOKEN = re.compile(r"""//[^\n]*|/\*.*?\*/|"(?:\\.|[^"\\\n])*"|'(?:\\.|[^'\\\n])+'(?!\w)""", re.S)


def without_comments(text, keep_strings):
    def replace(match):
        token = match.group(0)
        if token.startswith("/"):
            return "\n" * token.count("\n")
        is_include = text[text.rfind("\n", 0, match.start()) + 1:match.start()].strip() == "#include"
        return token if keep_strings or is_include else '""'
    return TOKEN.sub(replace, text)


def grep(pattern, folders, allowed=lambda source: False, strings=False):
    """A rule: the pattern stands in no code of these folders, but in files that are allowed to hold it."""
    expression = re.compile(pattern)

    def check(sources):
        for source in sources:
            if source.is_in(*folders) and not allowed(source):
                for number, line in enumerate(source.with_strings if strings else source.code, 1):
                    if expression.search(line):
                        yield source, number
    return check


def named(*stems):
    return lambda source: Path(source.name).stem in stems


def files_with_settings(sources):
    found = [(source, number) for source in sources if source.is_in(*CODE)
             for number, line in enumerate(source.code, 1) if re.search(r"#include\s*<QSettings>", line)]
    return found if len(found) > 2 else []


def includes_of_the_simulator(sources):
    for source in sources:
        if source.area == "protocol/sim":
            for number, line in enumerate(source.with_strings, 1):
                header = re.search(r'#include "protocol/codec/(.*)"', line)
                if header and header.group(1) not in HEADERS_OF_THE_CODEC_THAT_THE_SIMULATOR_MAY_READ:
                    yield source, number


def include_order_of_layers(sources):
    """Who may include whom: each area names the areas of ours that it may read."""
    core = {"protocol/codec"}
    allowed = {
        "protocol/codec": core,
        "protocol/sim": core | {"protocol/sim"},
        "protocol/telemetry": core | {"protocol/telemetry"},
        "protocol/transport": core | {"protocol/transport", "protocol/sim"},
        "protocol/session": core | {"protocol/session", "protocol/transport", "protocol/telemetry"},
    }
    for source in sources:
        for number, line in enumerate(source.with_strings, 1):
            header = re.match(r'#include "((protocol|widgets|app)/[^"]*)"', line)
            if not header or source.folder == "tests":
                continue
            area = "/".join(header.group(1).split("/")[:2])
            is_upward = (source.folder == "protocol" and header.group(2) != "protocol") or (
                source.folder == "widgets" and header.group(2) == "app")
            is_root_header = header.group(1).count("/") == 1
            if is_upward or (source.area in allowed and not is_root_header and area not in allowed[source.area]):
                yield source, number


def command_bytes(sources):
    literal = re.compile(r"\b0[xX]([0-9a-fA-F]{2})[uU]?\b")
    for source in sources:
        if not source.is_in(*CODE) or source.is_in("protocol/sim") or source.name == "protocol/codec/commandtable.h":
            continue
        for number, line in enumerate(source.code, 1):
            if any(int(digits, 16) in COMMAND_BYTES for digits in literal.findall(line)):
                yield source, number


def parameter_keys(sources):
    table = next((source for source in sources if source.name == "protocol/codec/parametertable.h"), None)
    keys = re.findall(r'\.key = "([a-z0-9-]+)"', "\n".join(table.with_strings)) if table else []
    # parameterRow() is consteval: a wrong key in it does not compile.
    literal = re.compile("(?<!parameterRow\\()\"(?:%s)\"" % "|".join(map(re.escape, keys)))
    for source in sources:
        # The names of the simulator's quirks and faults are its own, and one is a parameter's too.
        if not keys or not source.is_in(*CODE) or source is table or source.is_in("protocol/sim"):
            continue
        for number, line in enumerate(source.with_strings, 1):
            match = literal.search(line)
            if match and FACTORY_RESET_KEY not in match.group(0) and "constexpr" not in line:
                yield source, number


def sizes(sources):
    for source in sources:
        limit = 400 if source.name.endswith(".cpp") else 150
        if Path(source.name).name == "mainwindow.cpp":
            limit = 250
        if source.folder != "tests" and Path(source.name).name not in TABLES and len(source.lines) > limit:
            yield source, len(source.lines)


def licence_lines(sources):
    for source in sources:
        if not source.lines or source.lines[0] != "// SPDX-License-Identifier: GPL-3.0-or-later":
            yield source, 1


RULES = {
    "protocol/ knows no Gui and no Widgets":
        grep(r"#include <(Q(Widget|Application|Gui|Painter|Color|Icon|Font|Pixmap|Image)|QtWidgets|QtGui)",
             ["protocol"]),
    "only widgets/currents and plotview draw with Qt Charts":
        grep(r"#include <(QtCharts|QChart|QLineSeries|QValueAxis|QAbstractSeries)", CODE,
             lambda source: Path(source.name).stem.startswith("plot") or "plotview" in source.name),
    "nothing blocks: no nested event loop, no sleep, no waiting for bytes":
        grep(r"QEventLoop|processEvents|\bm?sleep\(|usleep|sleep_for|waitFor(ReadyRead|BytesWritten)", CODE,
             lambda source: source.is_in("protocol/transport")),  # the link thread's bounded wait on its port
    "connections are checked by the compiler":
        grep(r"\b(SIGNAL|SLOT)\(", (*CODE, "tests")),
    "no naked delete":
        grep(r"(?<!=)(?<!= )\bdelete\b(?!\s*;)", (*CODE, "tests")),
    "no friends for tests":
        grep(r"friend\s+class\s+\w*[Tt](e)?st", (*CODE, "tests")),
    "no shared_ptr, no singletons":
        grep(r"shared_ptr|QSharedPointer|\bstatic\b.*\binstance\(", CODE),
    "threads only in linkthread and recorder":
        grep(r"std::mutex|QMutex|moveToThread|std::atomic|QThread\b", CODE, named("linkthread", "recorder")),
    "<QSettings> is included in two files at most": files_with_settings,
    "files are saved by SaveFile, which Qt's own may empty on a full disk":
        grep(r"\bQSaveFile\b", CODE, named("savefile")),
    "the codec is pure: no QObject, no clock":
        grep(r"#include <(QObject|QTimer|QElapsedTimer|QDateTime)>|Q_OBJECT|_clock::now\(", ["protocol/codec"]),
    "the simulator is a reading of its own: no framing and no decoding of the codec's": includes_of_the_simulator,
    "includes go down the layers only": include_order_of_layers,
    "command bytes stand in the command table only": command_bytes,
    "parameter keys stand in the parameter table, in parameterRow() or in a named constexpr": parameter_keys,
    "a .cpp has at most 400 lines, a header 150, the main window 250 (the tables are exempt)": sizes,
    "the first line names the licence": licence_lines,
}


def main():
    root = Path(sys.argv[1] if len(sys.argv) > 1 else Path(__file__).parent.parent).resolve()
    sources = [Source(root, path) for folder in (*CODE, "tests") for path in sorted((root / folder).rglob("*"))
               if path.suffix in (".h", ".cpp")]
    if not sources:
        sys.exit(f"no sources under {root}")
    broken = 0
    for rule, check in RULES.items():
        findings = list(check(sources))
        broken += bool(findings)
        print(("FAIL  " if findings else "ok    ") + rule)
        for source, number in findings:
            line = source.lines[number - 1].strip() if number <= len(source.lines) and source.lines else ""
            print(f"      {source.name}:{number}: {line}")
    print(f"{len(sources)} files, {len(RULES)} rules, {broken} broken")
    return 1 if broken else 0


if __name__ == "__main__":
    sys.exit(main())
