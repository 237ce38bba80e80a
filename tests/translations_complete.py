#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Fails when a string of the sources has no finished translation in one of the languages, and names it.

Usage: translations_complete.py LUPDATE [SOURCE_DIR]

lupdate works on copies: nothing in the source folder changes.
"""
import re
import shutil
import subprocess
import sys
import tempfile
import xml.etree.ElementTree as ET
from pathlib import Path

FOLDERS = ("protocol", "widgets", "app")


def placeholders(text):
    return sorted(set(re.findall(r"%(?:L?\d|n)", text)))


def fault(message):
    """Says what is wrong with one message, or nothing."""
    source = message.findtext("source") or ""
    translation = message.find("translation")
    if translation is None or translation.get("type") == "unfinished":
        return "not translated"
    forms = translation.findall("numerusform") if message.get("numerus") == "yes" else [translation]
    texts = ["".join(form.itertext()) for form in forms]
    if not texts or not all(texts):
        return "not translated"
    wanted = placeholders(source)
    # A plural form may leave out the number ("one error"), never an argument.
    if any(set(wanted) - {"%n"} - set(placeholders(text)) or set(placeholders(text)) - set(wanted) for text in texts):
        return "has other placeholders in its translation"
    return None


def main():
    lupdate = sys.argv[1]
    root = Path(sys.argv[2] if len(sys.argv) > 2 else Path(__file__).parent.parent)
    files = sorted(root.glob("translations/trex_*.ts"))
    if not files:
        sys.exit(f"no language in {root}/translations")
    faults = 0
    with tempfile.TemporaryDirectory() as folder:
        for file in files:
            copy = Path(shutil.copy(file, folder))
            english = ["-pluralonly"] if copy.name == "trex_en.ts" else []  # the rest of it is in the sources
            done = subprocess.run([lupdate, "-silent", "-no-obsolete", "-locations", "none", "-I", str(root), *english,
                                   *(str(root / name) for name in FOLDERS), "-ts", str(copy)],
                                  check=True, stderr=subprocess.PIPE, text=True)
            # A class that lupdate lost (it trips over some declarations) has its texts under a name that
            # the running program never asks for.
            for line in sorted(set(done.stderr.splitlines())):
                faults += 1
                print(f"{copy.name}: {line}")
            messages = 0
            for context in ET.parse(copy).getroot().iter("context"):
                for message in context.iter("message"):
                    messages += 1
                    what = fault(message)
                    if what:
                        faults += 1
                        print(f'{copy.name}: {context.findtext("name")}: "{message.findtext("source")}" {what}')
            print(f"{copy.name}: {messages} strings")
            if not messages and not english:
                faults += 1
                print(f"{copy.name}: lupdate found nothing to translate under {root}")
    if faults:
        print("To take new strings over: cmake --build build/dev --target update_translations; then translate them.")
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main())
