#!/usr/bin/env python3
"""pymavlink at the other end of a link: reads each frame that comes, packs its message anew, and sends it back.

usage: peer.py XML PORT

For tests/tests/peer.rs, which waits on this UDP port of the loopback interface. Each line on
standard input begins another link: `v1`, `v2` or `signed`. Every frame is answered by one
datagram: the message as pymavlink reads it, packed by pymavlink for system 7, component 8,
signed where the link is; or, where pymavlink refuses the frame, the reason as text.
"""

import socket
import sys
from pathlib import Path

from dialect import Encoder
from layout import SIGNING_KEY

SYSTEM, COMPONENT, LINK = 7, 8, 5


def main():
    """The command."""
    xml, port = Path(sys.argv[1]), int(sys.argv[2])
    modules = Encoder(xml).modules
    with socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as link:
        link.connect(("127.0.0.1", port))
        for line in sys.stdin:
            kind = line.strip()
            peer = Peer(modules["1.0" if kind == "v1" else "2.0"], signed=kind == "signed")
            link.send(b"ready")
            while (datagram := link.recv(512)) != b"done":
                link.send(peer.answer(datagram))


class Peer:
    """A receiver and a sender of one protocol version."""

    def __init__(self, module, signed):
        self._mav = module.MAVLink(None, SYSTEM, COMPONENT)
        if signed:
            self._mav.signing.secret_key = SIGNING_KEY
            self._mav.signing.link_id = LINK
            self._mav.signing.sign_outgoing = True

    def answer(self, datagram):
        """The message of the frame in a datagram, packed again; or why there is none."""
        try:
            messages = self._mav.parse_buffer(datagram) or []
        except Exception as refusal:
            # What the parser holds of a refused frame would precede the next one.
            self._mav.buf, self._mav.buf_index = bytearray(), 0
            return f"refused: {refusal}".encode()
        if len(messages) != 1:
            return f"refused: {len(messages)} messages in one datagram".encode()
        packed = messages[0].pack(self._mav)
        self._mav.seq = (self._mav.seq + 1) % 256
        return bytes(packed)


if __name__ == "__main__":
    main()
