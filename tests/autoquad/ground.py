"""A ground station behind `autoquad bridge`, made of pymavlink and our definition.

It listens on a port of this machine, and leaves with an error if a frame is damaged, unsigned though it should be signed,
out of sequence, of a message that ground stations of today take for another one, or reports other values than the vehicle has.
"""

import hashlib
import socket
import sys
import time
from pathlib import Path

from recording import load, messages

SECONDS = 20
"""How long the ground station waits for everything at most."""

AQ_TELEMETRY = 2
"""The command that asks for AQ_TELEMETRY_F."""


class Silent:
    """Where pymavlink would write to."""

    def __init__(self):
        self.bytes = b""

    def write(self, data):
        self.bytes += bytes(data)


def flown(module, log):
    """The speeds of each batch of motors that the vehicle ever had."""
    telemetry = (message for _, message in messages(module, Path(log).read_bytes()) if message.get_type() == "AQ_ESC_TELEMETRY")
    return {(4 * (batch.seq - 1), slot, batch.data0[slot] >> 29 | (batch.data1[slot] & 0xFFF) << 3) for batch in telemetry for slot in range(4)}


class Station:
    """What was heard so far."""

    def __init__(self, module, speeds, key):
        self.module, self.speeds, self.key = module, speeds, key
        self.heard, self.expected, self.acknowledged = {}, {}, False
        self.link = module.MAVLink(Silent(), srcSystem=255, srcComponent=190)
        if key:
            self.link.signing.secret_key = key
            self.link.signing.sign_outgoing = True
            self.link.signing.timestamp = int((time.time() - 1420070400) * 100_000)

    def receive(self, datagram):
        for message in self.link.parse_buffer(datagram) or []:
            self.take(message)

    def take(self, message):
        kind, sender = message.get_type(), (message.get_srcSystem(), message.get_srcComponent())
        self.heard[kind] = self.heard.get(kind, 0) + 1
        if message.get_seq() != self.expected.get(sender, message.get_seq()):
            sys.exit(f"{kind} of {sender} is number {message.get_seq()}, not {self.expected[sender]}")
        self.expected[sender] = (message.get_seq() + 1) % 256
        if message.get_msgId() in (150, 152):
            sys.exit(f"{kind} came through")
        if kind == "ESC_STATUS":
            for slot, rpm in enumerate(message.rpm):
                if rpm and (message.index, slot, rpm) not in self.speeds:
                    sys.exit(f"motor {message.index + slot} never had {rpm} rpm")
        if kind == "COMMAND_ACK":
            self.acknowledged = message.command == AQ_TELEMETRY and message.result == 0

    def ask(self):
        """A command in MAVLink 2, which the vehicle does not understand."""
        self.link.file.bytes = b""
        self.link.command_long_send(1, 1, AQ_TELEMETRY, 0, 1, 100_000, 3, 0, 0, 0, 0)
        return self.link.file.bytes

    def is_content(self):
        enough = {"HEARTBEAT": 3, "ATTITUDE": 20, "ESC_INFO": 4, "ESC_STATUS": 30}
        return self.acknowledged and all(self.heard.get(kind, 0) >= count for kind, count in enough.items())


def main():
    port, xml, log, *passphrase = sys.argv[1:]
    module = load(xml)
    key = hashlib.sha256(Path(passphrase[0]).read_bytes().strip()).digest() if passphrase else None
    station = Station(module, flown(module, log), key)
    receiver = socket.socket(socket.AF_INET, socket.SOCK_DGRAM)
    receiver.bind(("127.0.0.1", int(port)))
    receiver.settimeout(0.5)
    print("listening", flush=True)
    end, asked = time.monotonic() + SECONDS, 0
    while not station.is_content():
        if time.monotonic() > end:
            sys.exit(f"after {SECONDS} s there is no more than {station.heard}, acknowledged: {station.acknowledged}")
        try:
            datagram, bridge = receiver.recvfrom(65536)
        except TimeoutError:
            continue
        station.receive(datagram)
        if time.monotonic() > asked + 1 and not station.acknowledged:
            asked = time.monotonic()
            receiver.sendto(station.ask(), bridge)
    signed = "signed " if key else ""
    print(f"pymavlink reads {sum(station.heard.values())} {signed}frames of the bridge, and is answered through it")


if __name__ == "__main__":
    main()
