#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Runs client.py against `trexctl simulate --pty`: run_client.py TREXCTL CLIENT"""
import os
import signal
import subprocess
import sys
import tempfile

trexctl, client = sys.argv[1:3]
with tempfile.TemporaryDirectory() as folder:
    link = os.path.join(folder, "trex")
    with subprocess.Popen([trexctl, "simulate", "--pty", link, "--pace"], stdout=subprocess.PIPE,
                          text=True) as simulator:
        try:
            if simulator.stdout.readline() != f"ready {link}\n":
                sys.exit("the simulator is not ready")
            code = subprocess.run([sys.executable, client, link], timeout=60, check=False).returncode
        finally:
            simulator.send_signal(signal.SIGINT)
    if simulator.returncode != 0 or os.path.lexists(link):
        sys.exit(f"the simulator ended with {simulator.returncode}, link left: {os.path.lexists(link)}")
sys.exit(code)
