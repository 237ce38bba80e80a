#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""The real programs where things are missing, damaged, full, small or odd: one clear sentence each, nothing lost, no
crash and no hang.

Usage: hostile_environment.py TREXPANEL TREXCTL [TEST...]     (TREX_PICTURES=FOLDER keeps the pictures)
"""
import glob
import json
import os
import shutil
import signal
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

PANEL, CTL = sys.argv[1:3]
LONGEST = 120  # seconds, of one program on a machine that does other things
NOWHERE = "/proc/nowhere"  # a folder that nobody, not even root, can make
CONNECTED = {"waitFor": {"object": "connection.state", "property": "state", "equals": "connected"},
             "timeoutMs": 30000}
LOG = {"file": {"object": "log.save", "path": "{screenshots}/log.txt"}}
WRITE = [
    {"waitFor": {"object": "parameters.apply", "property": "visible", "equals": True}},
    {"waitFor": {"object": "parameters.serial-timeout.editor", "property": "enabled", "equals": True},
     "timeoutMs": 30000},
    {"set": {"object": "parameters.serial-timeout.editor", "property": "raw", "value": 5}},
    {"click": "parameters.apply"},
]


def limited(blocks):
    """A shell's words that run the rest of the arguments with files of at most so many blocks of 512 bytes."""
    return ["sh", "-c", f"ulimit -f {blocks}; exec \"$0\" \"$@\""]


class Hostile(unittest.TestCase):
    def setUp(self):
        self.folder = tempfile.TemporaryDirectory(prefix="hostile-")
        self.addCleanup(self.folder.cleanup)
        self.home = self.path("home")
        os.makedirs(self.home)

    def path(self, *parts):
        return os.path.join(self.folder.name, *parts)

    def environment(self, changes):
        environment = {key: value for key, value in os.environ.items()
                       if not key.startswith("XDG_") and key not in ("DISPLAY", "WAYLAND_DISPLAY", "QT_QPA_PLATFORM",
                                                                     "QT_LOGGING_RULES")}
        environment["HOME"] = self.home
        environment.update({key: value for key, value in changes.items() if value is not None})
        for key in (key for key, value in changes.items() if value is None):
            environment.pop(key, None)
        return environment

    def run_program(self, arguments, changes=None, before=(), text=True):
        done = subprocess.run([*before, *arguments], env=self.environment(changes or {}), cwd=self.folder.name,
                              capture_output=True, timeout=LONGEST, check=False, stdin=subprocess.DEVNULL)
        if text:
            done.stdout, done.stderr = (part.decode(errors="replace") for part in (done.stdout, done.stderr))
        self.assertGreaterEqual(done.returncode, 0, f"ended by a signal; {done.stderr}")
        return done

    def ctl(self, *arguments, **how):
        return self.run_program([CTL, *arguments], **how)

    def panel(self, steps, *arguments, settings="settings.ini", port="sim:", offscreen=True, **how):
        script = self.path("script.json")
        Path(script).write_text(json.dumps({"steps": steps}), encoding="utf-8")
        all_arguments = [PANEL, *(["--offscreen"] if offscreen else []), "--script", script, "--screenshots",
                         self.path("pictures"), "--language", "en", *(["--port", port] if port else []),
                         *(["--settings", self.path(settings)] if settings else []), *arguments]
        done = self.run_program(all_arguments, **how)
        if pictures := os.environ.get("TREX_PICTURES"):
            for picture in glob.glob(self.path("pictures", "*.png")):
                shutil.copy(picture, os.path.join(pictures, f"{self.id().split('.')[-1]}-{os.path.basename(picture)}"))
        return done

    def log(self):
        return Path(self.path("pictures", "log.txt")).read_text(encoding="utf-8")

    def assert_sentence(self, done, code, *words):
        """One line on stderr, no more, that says this."""
        self.assertEqual(done.returncode, code, done.stderr)
        self.assertEqual(done.stderr.strip().count("\n"), 0, done.stderr)
        for word in words:
            self.assertIn(word, done.stderr)

    # ---- display and fonts

    def test_no_display(self):
        for changes in ({}, {"DISPLAY": ":77"}, {"QT_QPA_PLATFORM": "nonsense"}):
            done = self.panel([], offscreen=False, changes=changes)
            self.assert_sentence(done, 2, "no window can be shown", "--offscreen")
            for name, value in changes.items():
                self.assertIn(f"{name}={value}", done.stderr)

    def test_no_fonts(self):
        fonts = self.path("fonts")
        os.makedirs(fonts)
        config = os.path.join(fonts, "fonts.conf")
        Path(config).write_text(f"<?xml version='1.0'?><fontconfig><dir>{fonts}</dir><cachedir>{fonts}</cachedir>"
                                "</fontconfig>", encoding="utf-8")
        done = self.panel([CONNECTED], changes={"FONTCONFIG_FILE": config, "FONTCONFIG_PATH": fonts})
        self.assert_sentence(done, 2, "no font is installed")

    # ---- settings

    def test_damaged_settings_are_kept_aside(self):
        damaged = {
            "garbage": os.urandom(5000) + b"\n[[[\n",
            "half written": b"[ui]\ntheme=dark\nlayout=@ByteArray(\\0\\0\\xff)\n[motion",
            "zeros": bytes(4096),
            "huge": b"[ui]\n" + b"a=" + b"x" * (5 << 20) + b"\n",
        }
        for name, content in damaged.items():
            with self.subTest(name):
                file = self.path(f"{name}.ini")
                Path(file).write_bytes(content)
                done = self.panel([CONNECTED, LOG], settings=f"{name}.ini")
                self.assertEqual(done.returncode, 0, done.stderr)
                self.assertEqual(Path(file + ".damaged").read_bytes(), content)
                self.assertIn(f"It is kept as {file}.damaged, and the settings begin anew.", self.log())
                self.assertTrue(os.path.isfile(file))

    def test_settings_of_wrong_types_hold_their_defaults(self):
        own = b"""[ui]
theme=7, 8, 9
language=@Variant(\\0\\0\\0\\n)
geometry=@Rect(1 2 3 4)
layout=@ByteArray(\\xde\\xad\\xbe\\xef)
[motion]
maximum1=nan
maximum2=@Invalid()
maximumAux=1e400
sliderStep=-99999999999999999999
holdSpeed=fast
holdToRun=perhaps
stallMilliamperes=inf
[safety]
motorFault=never
idleSeconds=99999999999
[telemetry]
memory=-2147483648
[currents]
window=0
[plots]
window=-1
layout={"rows":[{"curves":["nonsense",7,null]}],"x":1e999}
[flight]
minutes=2147483647
folder=/proc/nowhere/at/all
[line]
lastPort=\x01\x02
[future]
newThing=42
[linePorts]
%2Fdev%2FttyUSB9=19200 none 137 1 compact 7 auto 100 and more
"""
        file = self.path("settings.ini")
        Path(file).write_bytes(own)
        done = self.panel([CONNECTED,
                           {"expect": {"object": "motors.motor1.slider", "property": "maximum", "equals": 127}},
                           {"expect": {"object": "motors.motor2.slider", "property": "maximum", "equals": 127}},
                           {"expect": {"object": "motors.aux.slider", "property": "maximum", "equals": 127}},
                           {"expect": {"object": "motors.hold", "property": "checked", "equals": False}},
                           {"screenshot": {"object": "mainWindow", "file": "wrong-types.png"}}, LOG])
        self.assertEqual(done.returncode, 0, done.stderr)
        kept = Path(file).read_text(encoding="utf-8")
        self.assertIn("newThing=42", kept)  # of a newer version: not ours to drop
        self.assertIn("and more", kept)

    def test_settings_that_are_no_file(self):
        done = self.panel([CONNECTED], settings=".")
        self.assert_sentence(done, 2, "Could not read")
        os.mkfifo(self.path("pipe"))
        self.assert_sentence(self.panel([CONNECTED], settings="pipe"), 2, "Could not read")

    # ---- places that cannot be written

    def test_home_that_cannot_be_written(self):
        done = self.panel([CONNECTED, *WRITE,
                           {"waitFor": {"object": "parameters.message", "property": "text",
                                        "matches": "Nothing is written .*journal cannot be written: Could not write /proc/nowhere"},
                            "timeoutMs": 20000},
                           {"screenshot": {"object": "mainWindow", "file": "read-only-home.png"}},
                           {"expect": {"object": "parameters.apply", "property": "enabled", "equals": True}},
                           {"click": "parameters.apply"},
                           {"waitFor": {"object": "parameters.pending", "property": "text",
                                        "matches": "^Nothing to write"}, "timeoutMs": 20000}, LOG],
                          settings=None, changes={"HOME": NOWHERE})
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertIn("Settings of this session are not kept.", done.stderr)
        self.assertIn("Settings of this session are not kept.", self.log())
        done = self.ctl("--port", "sim:", "param", "set", "serial-timeout", "500ms", changes={"HOME": NOWHERE})
        self.assertEqual(done.returncode, 0)
        self.assertIn("verified", done.stdout)
        self.assert_sentence(done, 0, "The settings as they were could not be saved first", NOWHERE)

    def test_home_unset(self):
        for name in ("HOME", "XDG_RUNTIME_DIR", "TMPDIR"):
            changes = {"HOME": None, "XDG_RUNTIME_DIR": None} if name != "TMPDIR" else {"TMPDIR": NOWHERE}
            self.assertEqual(self.panel([CONNECTED], changes=changes).returncode, 0)
            done = self.ctl("--port", "sim:", "--json", "info", changes=changes)
            self.assertEqual((done.returncode, done.stderr), (0, ""))

    def test_full_disk(self):
        """Files may not get longer than nothing, as on a full disk: what was there stays, and it is told."""
        old = self.path("old.json")
        self.assertEqual(self.ctl("--port", "sim:", "config", "save", old).returncode, 0)
        content = Path(old).read_bytes()
        self.assert_sentence(self.ctl("--port", "sim:", "config", "save", old, before=limited(0)), 2, old)
        self.assertEqual(Path(old).read_bytes(), content)
        self.assert_sentence(self.ctl("--port", "sim:", "record", self.path("new.trexrec"), "--duration", "1",
                                      before=limited(0)), 2, "new.trexrec")
        done = self.ctl("--port", "sim:", "currents", "--csv", self.path("c.csv"), "--duration", "1", "--json",
                        before=limited(0))
        self.assertEqual(done.returncode, 2, done.stderr)
        self.assertIn("c.csv", done.stderr)
        with open("/dev/full", "wb") as full:
            done = subprocess.run([CTL, "--port", "sim:", "info"], stdout=full, stderr=subprocess.PIPE, check=False,
                                  env=self.environment({}), timeout=LONGEST)
        self.assertEqual(done.returncode, 2)
        self.assertIn(b"standard output", done.stderr)

    def test_full_disk_in_the_panel(self):
        settings = self.path("settings.ini")
        Path(settings).write_text("[future]\nnewThing=42\n", encoding="utf-8")
        old = self.path("old.json")
        self.assertEqual(self.ctl("--port", "sim:", "config", "save", old).returncode, 0)
        content = Path(old).read_bytes()
        done = self.panel([CONNECTED, WRITE[1],
                           {"file": {"object": "parameters.save", "path": old}},
                           {"waitFor": {"object": "parameters.message", "property": "text",
                                        "matches": "Could not write"}},
                           {"click": "action.record"},
                           {"waitFor": {"object": "mainWindow.recording", "property": "text", "matches": "."},
                            "timeoutMs": 10000},
                           {"expect": {"object": "mainWindow.identity", "property": "text", "matches": "TReX Jr"}}],
                          "--report", self.path("report.json"), before=limited(0))
        self.assertEqual(done.returncode, 2, done.stderr)
        self.assertIn(f"Could not write {self.path('report.json')}", done.stderr)
        self.assertEqual(Path(old).read_bytes(), content)
        self.assertEqual(Path(settings).read_text(encoding="utf-8"), "[future]\nnewThing=42\n")
        done = self.panel([CONNECTED, {"screenshot": {"object": "mainWindow", "file": "a.png"}}], before=limited(0))
        self.assertEqual(done.returncode, 1)
        self.assertIn("a.png", done.stderr)

    # ---- names

    def odd_port(self):
        folder = self.path("Ordner mit Leer<b>zeichen & ünïcode “日本語” %41")
        os.makedirs(folder)
        return os.path.join(folder, "Näme <i>x; rm -rf %s %n 'q' \"d\"")

    def simulator(self, link):
        process = subprocess.Popen([CTL, "simulate", "--pty", link], stdout=subprocess.PIPE, env=self.environment({}))
        self.addCleanup(process.wait)
        self.addCleanup(process.stdout.close)
        self.addCleanup(process.send_signal, signal.SIGINT)
        self.assertEqual(process.stdout.readline().decode().rstrip("\n"), f"ready {link}")
        return process

    def test_odd_port_name(self):
        port = self.odd_port()
        self.simulator(port)
        self.assertEqual(self.ctl("--port", port, "--json", "info").returncode, 0)
        # remembered: the next command needs no --port
        self.assertEqual(self.ctl("--json", "info").returncode, 0)
        self.assertEqual(self.ctl("--port", port, "param", "set", "serial-timeout", "5").returncode, 0)
        journal = self.ctl("--json", "journal")
        self.assertEqual(journal.returncode, 0, journal.stderr)
        self.assertEqual(json.loads(journal.stdout)[0]["port"], port)
        recording = self.path("Aufnähme <b>.trexrec")
        self.assertEqual(self.ctl("--port", port, "record", recording, "--duration", "0.5").returncode, 0)
        self.assertEqual(self.ctl("export", recording, "--csv", self.path("ü.csv")).returncode, 0)
        self.assertGreater(os.path.getsize(self.path("ü.csv")), 100)
        done = self.panel([CONNECTED, LOG,
                           {"expect": {"object": "mainWindow.identity", "property": "text",
                                       "matches": "Näme <i>x; rm -rf %s %n"}},
                           {"expect": {"object": "connection.port", "property": "currentText", "matches": "Näme"}},
                           {"screenshot": {"object": "mainWindow", "file": "odd-port.png"}},
                           {"screenshot": {"object": "connection", "file": "odd-port-connection.png"}},
                           {"screenshot": {"object": "log", "file": "odd-port-log.png"}}], port=port)
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertIn(port, self.log())

    def test_absurd_arguments(self):
        for arguments, words in ((["--script", "/dev/zero"], "makes no sense"),
                                 (["--script", "/"], "Could not read"),
                                 (["--script", "a" * 100_000], "Could not read"),
                                 (["--script", b"/tmp/\xff\xfe\xfd"], "Could not read"),
                                 (["--theme", "\x1b[31mred"], "--theme"),
                                 (["--scale", "nan"], "--scale"), (["--scale", "1e99"], "--scale"),
                                 (["--language", "../../etc/passwd"], "--language"),
                                 (["--report"], "--report"), (["--nonsense"], "--nonsense")):
            with self.subTest(str(arguments)[:40]):
                done = self.run_program([PANEL, "--offscreen", "--simulate", "--settings", self.path("s.ini"), *arguments])
                self.assert_sentence(done, 2, words)
                self.assertNotIn("\x1b", done.stderr)
        for arguments, code in ((["--port", b"/dev/\xff\xfe", "info"], 4), (["--port", "", "info"], 2),
                                (["--port", "x" * 100_000, "info"], 4), (["--port", "/dev/a\nb", "info"], 4),
                                (["--port", "sim:", "raw", "é"], 2), (["param", "get", "\u202ekey"], 2),
                                (["--port", "sim:", "run", b"\xc3\x28"], 2),
                                (["--port", "sim:?nonsense=%00", "info"], 2),
                                (["--port", "tcp://[::1", "info"], 2), (["--port", "tcp://a:99999", "info"], 2)):
            with self.subTest(str(arguments)[:40]):
                self.assert_sentence(self.ctl(*arguments), code)

    # ---- small screens

    def test_small_screens(self):
        for width, height in ((640, 480), (800, 600)):
            with self.subTest(f"{width}x{height}"):
                config = self.path("screen.json")
                Path(config).write_text(json.dumps({"screens": [{
                    "name": "small", "x": 0, "y": 0, "width": width, "height": height, "logicalDpi": 96,
                    "logicalBaseDpi": 96, "dpr": 1}]}), encoding="utf-8")
                size = f"-{width}.png"
                done = self.panel([
                    CONNECTED,
                    {"expect": {"object": "mainWindow", "property": "width", "max": width}},
                    {"expect": {"object": "mainWindow", "property": "height", "max": height}},
                    {"expect": {"object": "mainWindow.stop", "property": "visible", "equals": True}},
                    {"expect": {"object": "why.text", "property": "visible", "equals": True}},
                    {"screenshot": {"object": "mainWindow", "file": "main" + size}},
                    {"screenshot": {"object": "motors", "file": "motors" + size}},
                    {"click": "motors.safety"},
                    {"waitFor": {"object": "motors.safetyDialog", "property": "visible", "equals": True}},
                    {"screenshot": {"object": "motors.safetyDialog", "file": "safety" + size}},
                    {"expect": {"object": "motors.safetyDialog", "property": "width", "max": width}},
                    {"expect": {"object": "motors.safetyDialog", "property": "height", "max": height}},
                    {"dialog": "reject"},
                    {"click": "parameters.journal"},
                    {"waitFor": {"object": "journal", "property": "visible", "equals": True}},
                    {"screenshot": {"object": "journal", "file": "journal" + size}},
                    {"expect": {"object": "journal", "property": "width", "max": width}},
                    {"expect": {"object": "journal", "property": "height", "max": height}},
                ], changes={"QT_QPA_PLATFORM": f"offscreen:configfile={config}"})
                self.assertEqual(done.returncode, 0, done.stderr)

    # ---- locales and clocks

    def test_odd_locales(self):
        answers = set()
        for locale in ("C", "tr_TR.UTF-8", "ar_EG.UTF-8", "de_DE.ISO-8859-1", "nonsense"):
            changes = {"LC_ALL": locale, "LANG": locale}
            with self.subTest(locale):
                saved = self.path(f"saved-{locale}.json")
                done = self.ctl("--port", "sim:", "config", "save", saved, changes=changes)
                self.assertEqual((done.returncode, done.stderr), (0, ""))
                content = json.loads(Path(saved).read_text(encoding="utf-8"))
                content.pop("saved")
                done = self.ctl("--port", "sim:", "--json", "param", "list", changes=changes)
                self.assertEqual((done.returncode, done.stderr), (0, ""))
                answers.add(json.dumps(content) + done.stdout)
                done = self.ctl("--port", "sim:", "param", "set", "motor1-current-limit", "2.4A", changes=changes)
                self.assertEqual((done.returncode, done.stderr), (0, ""))
        self.assertEqual(len(answers), 1)
        for locale in ("C", "tr_TR.UTF-8", "ar_EG.UTF-8"):
            with self.subTest("panel " + locale):
                done = self.panel([CONNECTED, *WRITE,
                                   {"waitFor": {"object": "parameters.pending", "property": "text",
                                                "matches": "^Nothing to write"}, "timeoutMs": 20000},
                                   {"screenshot": {"object": "mainWindow", "file": f"{locale}.png"}}],
                                  changes={"LC_ALL": locale})
                self.assertEqual((done.returncode, done.stderr), (0, ""))


if __name__ == "__main__":
    unittest.main(argv=[sys.argv[0], *sys.argv[3:]])
