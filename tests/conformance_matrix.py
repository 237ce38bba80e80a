#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Prints the matrix of conformance statements and the tests that name them; 1 when a statement has no test.

A test names a statement by its number in a comment at or above its slot (// C-14), or in a field of a data file.

Usage: conformance_matrix.py [TESTS_DIR]
"""
import json
import re
import sys
from collections import defaultdict
from pathlib import Path

NUMBER = re.compile(r"\bC-(\d\d)\b")
SLOT = re.compile(r"^\s*(?:void|def)\s+(?:\w+::)?(\w+)\s*\(")


def tests_of(path):
    """Yields statement and test: the slot that follows the comment, or that it stands in, or the whole file."""
    lines = path.read_text(encoding="utf-8").splitlines()
    slots = {number: match.group(1) for number, line in enumerate(lines) if (match := SLOT.match(line))}
    for number, line in enumerate(lines):
        for statement in NUMBER.findall(line):
            is_above = line.lstrip().startswith(("//", "#", "*", "///"))
            following = next((slots[n] for n in range(number, min(number + 6, len(lines))) if n in slots), None)
            around = next((slots[n] for n in range(number, -1, -1) if n in slots), None)
            slot = (following or around) if is_above else around
            yield f"C-{statement}", path.stem + (f"::{slot}" if slot else "")


def main():
    tests = Path(sys.argv[1] if len(sys.argv) > 1 else Path(__file__).parent).resolve()
    statements = json.loads((tests / "data" / "conformance.json").read_text(encoding="utf-8"))["statements"]
    known = {row["number"] for row in statements}
    own = {tests / "data" / "conformance.json", Path(__file__).resolve()}
    covering = defaultdict(list)
    for path in sorted(path for path in tests.rglob("*") if path.suffix in (".cpp", ".py", ".json")):
        for statement, test in tests_of(path) if path not in own else ():
            if test not in covering[statement]:
                covering[statement].append(test)
    missing = [row for row in statements if not covering[row["number"]]]
    for row in statements:
        names = ", ".join(covering[row["number"]]) or "NO TEST"
        print(f'{row["number"]} {row["binds"]:<2}  {row["statement"]}\n          {names}')
    unknown = sorted(set(covering) - known)
    for statement in unknown:
        print(f"{statement} is no statement; named by {', '.join(covering[statement])}")
    pairs = sum(len(covering[row["number"]]) for row in statements)
    print(f"{len(statements)} statements, {pairs} tests that name one, {len(missing)} statements without a test"
          + (": " + ", ".join(row["number"] for row in missing) if missing else ""))
    return 1 if missing or unknown else 0


if __name__ == "__main__":
    sys.exit(main())
