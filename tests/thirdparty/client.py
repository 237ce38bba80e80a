#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""A client of a TReX Jr as somebody else would write it: from the command documentation and the
serial protocols alone, with nothing of this repository. Talks to the serial port named on the
command line in both packet forms and exits with 0 when every answer is what the documents say."""
import os
import select
import sys
import termios
import time
import tty

TIMEOUT = 0.5


class Trex:
    def __init__(self, path, device=None):
        self.device = device  # None: compact protocol
        self.fd = os.open(path, os.O_RDWR | os.O_NOCTTY)
        tty.setraw(self.fd)
        attributes = termios.tcgetattr(self.fd)
        attributes[4] = attributes[5] = termios.B19200
        termios.tcsetattr(self.fd, termios.TCSANOW, attributes)
        termios.tcflush(self.fd, termios.TCIOFLUSH)

    def close(self):
        os.close(self.fd)

    def command(self, opcode, data=(), reply=0):
        if self.device is None:
            packet = bytes([opcode, *data])
        else:  # Pololu protocol: 0x80, device number, command byte with its top bit clear
            packet = bytes([0x80, self.device, opcode & 0x7F, *data])
        os.write(self.fd, packet)
        received = b""
        while len(received) < reply:
            if not select.select([self.fd], [], [], TIMEOUT)[0]:
                raise SystemExit(f"no reply to {packet.hex()}: got {received.hex()}")
            received += os.read(self.fd, reply - len(received))
        return received


def expect(what, condition):
    if not condition:
        raise SystemExit("wrong: " + what)


def parameters(trex):
    numbers = [*range(0x00, 0x18), *range(0x7B, 0x7F)]
    return {number: trex.command(0x9F, [number], 1)[0] for number in numbers}


def highest_currents(trex, seconds):
    best, end = [0, 0], time.monotonic() + seconds
    while time.monotonic() < end:
        best = [max(old, new) for old, new in zip(best, trex.command(0x8F, reply=2))]
    return best


def check(trex):
    signature = trex.command(0x81, reply=9)
    expect(f"signature {signature}", signature[:6] == b"TReXJr" and signature[7:8] == b".")
    expect("mode", trex.command(0x82, reply=1) == b"r")
    expect("serial controls motors", trex.command(0x83, reply=1) == b"\x01")
    trex.command(0x84, reply=1)
    trex.command(0x85, reply=1)
    values = parameters(trex)
    expect("device number 7", values[0x00] == 7)
    expect("seven bits", all(value < 0x80 for value in values.values()))

    trex.command(0xC2, [100])  # motor 1 forward
    trex.command(0xC9, [90])  # motor 2 reverse
    both = highest_currents(trex, 1.0)
    expect(f"both motors draw current: {both}", both[0] > 0 and both[1] > 0)
    first, second = trex.command(0x8D, reply=1), trex.command(0x8E, reply=1)
    expect("single currents", len(first + second) == 2)
    trex.command(0xD0 | 2 << 2 | 2, [0, 0])  # both at once, forward, speed 0
    time.sleep(1.0)
    expect("they stop", max(trex.command(0x8F, reply=2)) == 0)

    answer = trex.command(0xAF, [0x07, 5, 0x55, 0x2A], 1)  # serial timeout 500 ms
    expect("parameter set", answer == b"\x00" and trex.command(0x9F, [0x07], 1) == b"\x05")
    trex.command(0xAF, [0x07, values[0x07], 0x55, 0x2A], 1)
    expect("all as before", parameters(trex) == values)
    expect("no UART error", trex.command(0x85, reply=1) == b"\x00")


for device in (None, 7):
    controller = Trex(sys.argv[1], device)
    check(controller)
    controller.close()
    print("ok:", "compact protocol" if device is None else f"Pololu protocol, device {device}")
