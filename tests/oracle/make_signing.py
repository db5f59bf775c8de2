#!/usr/bin/env python3
"""Write sequences of signed frames, and which of them a receiver accepts.

usage: make_signing.py XML OUT [--check]

XML is a definition that has the messages of common.xml. pymavlink makes the
frames; the C library that it generates says what to think of them, and needs a
C compiler (`cc`, or what CC names).

`--check` writes nothing; it makes the sequences again and says where OUT differs.
Exit status: 0 fine, 1 OUT differs, 2 pymavlink refuses the XML.

The file is lines of ASCII. A line that begins with `#`, or is empty, says nothing.

    sequence NAME TIME
        The frames below reach one receiver, one after the other. TIME, 12 digits
        like every time here, is the receiver's when the first one comes.
    frame VERDICT TIME PYMAVLINK BYTES
        VERDICT is the C library's: signed, allowed, unsigned, wrong_hash,
        replayed, too_old or too_many_streams; TIME is its own afterwards.
        PYMAVLINK says whether pymavlink accepts the frame, yes or no. BYTES are the
        frame, in hexadecimal. The key is 00 01 02 … 1f, and RADIO_STATUS is allowed.
"""

import argparse
import sys
import tempfile
from itertools import zip_longest
from pathlib import Path

import pymavlink

from dialect import Refused
from layout import SIGNING_KEY
from receivers import Receivers

MINUTE = 6_000_000
LAST = 0xFFFF_FFFF_FFFF
NOW = 10 * MINUTE


def main():
    """The command."""
    parser = argparse.ArgumentParser(description="Write sequences of signed frames.")
    parser.add_argument("xml", type=Path, metavar="XML", help="the definition")
    parser.add_argument("out", type=Path, metavar="OUT", help="the file of sequences")
    parser.add_argument("--check", action="store_true", help="compare OUT, do not write it")
    arguments = parser.parse_args()
    with tempfile.TemporaryDirectory() as folder:
        try:
            made = list(lines(Receivers(arguments.xml, Path(folder))))
        except Refused as error:
            print(f"make_signing: {error}", file=sys.stderr)
            return 2
    text = "".join(f"{line}\n" for line in made)
    if arguments.check:
        return _check(arguments.out, text)
    arguments.out.write_text(text, encoding="ascii", newline="\n")
    print(f"{sum(line.startswith('frame') for line in made)} frames")
    return 0


def lines(receivers):
    """The lines of the file."""
    yield f"# Signed frames by tests/oracle/make_signing.py and pymavlink {pymavlink.__version__}."
    yield "# Do not edit; README.md explains the format."
    for name, time, frames in sequences(Frames(receivers.module)):
        yield ""
        yield f"sequence {name} {time:012x}"
        for frame, verdict in zip(frames, receivers.verdicts(time, frames), strict=True):
            accepted = "yes" if verdict.accepted_by_pymavlink else "no"
            yield f"frame {verdict.word} {verdict.time:012x} {accepted} {frame.hex()}"


class Frames:
    """Makes frames of a heartbeat, or of RADIO_STATUS."""

    def __init__(self, module):
        self._module = module

    def signed(self, timestamp, link=3, system=1, component=1, key=SIGNING_KEY, radio=False):
        """A frame of this stream; the sequence number is always 0."""
        return self._message(radio).pack(self._signer(timestamp, link, system, component, key))

    def burst(self, timestamp, count):
        """So many frames of one sender, which counts the time by itself."""
        sender = self._signer(timestamp, link=3, system=1, component=1, key=SIGNING_KEY)
        return [self._message(radio=False).pack(sender) for _ in range(count)]

    def unsigned(self, version=2, radio=False):
        """A frame without signature."""
        return self._message(radio).pack(self._module.MAVLink(None, 1, 1), force_mavlink1=version == 1)

    def _signer(self, timestamp, link, system, component, key):
        sender = self._module.MAVLink(None, system, component)
        sender.signing.secret_key = key
        sender.signing.link_id = link
        sender.signing.timestamp = timestamp
        sender.signing.sign_outgoing = True
        return sender

    def _message(self, radio):
        if radio:
            return self._module.MAVLink_radio_status_message(1, 2, 3, 4, 5, 6, 7)
        return self._module.MAVLink_heartbeat_message(6, 8, 0, 0, 4, 3)


def forged(frame):
    """The frame with a wrong hash."""
    return frame[:-1] + bytes([frame[-1] ^ 1])


def sequences(frames):
    """Name, the receiver's time, frames."""
    signed, burst, unsigned = frames.signed, frames.burst, frames.unsigned
    yield "one_stream", NOW, burst(NOW, 5)
    yield "replays", NOW, [signed(NOW), signed(NOW), signed(NOW - 1), signed(NOW + 5), signed(NOW + 1), signed(NOW + 6)]
    yield (
        "streams",
        NOW,
        [
            signed(NOW + 3),
            signed(NOW + 2, link=4),
            signed(NOW + 1, system=2),
            signed(NOW, component=2),
            signed(NOW + 3, link=4),
            signed(NOW + 2, link=4),
            signed(NOW + 1, system=2),
            signed(NOW + 1, component=2),
            signed(NOW + 4),
        ],
    )
    yield "one_minute_behind", NOW, [signed(NOW - MINUTE), signed(NOW - MINUTE), signed(NOW - MINUTE + 1)]
    yield "more_than_one_minute_behind", NOW, [signed(NOW - MINUTE - 1), signed(0), signed(NOW)]
    yield "known_stream_falls_behind", 0, [signed(1), signed(NOW, link=4), signed(2), signed(0, link=5), signed(3)]
    yield "start_of_time", 0, [signed(0), signed(0), signed(1)]
    yield "end_of_time", LAST - 1, burst(LAST - 1, 4)
    yield "end_of_time_is_replayed", LAST, [signed(LAST), signed(LAST), signed(LAST - 1), signed(0)]
    yield "unsigned", NOW, [unsigned(1), unsigned(2), unsigned(1, radio=True), unsigned(2, radio=True)]
    yield (
        "radio_status",
        NOW,
        [
            signed(NOW, radio=True),
            signed(NOW, radio=True),
            forged(signed(NOW + 9, radio=True)),
            signed(NOW + 1, radio=True),
        ],
    )
    yield "another_key", NOW, [signed(NOW, key=bytes(32)), signed(NOW, link=4), signed(NOW, link=4, key=bytes(32))]
    yield (
        "forged_then_genuine",
        NOW,
        [
            signed(NOW),
            forged(signed(NOW + 1000)),
            signed(NOW + 1),
            forged(signed(LAST)),
            signed(NOW + 2),
        ],
    )
    yield "forged_first", NOW, [forged(signed(NOW + 1000)), signed(NOW)]
    yield (
        "seventeen_streams",
        NOW,
        [
            *(signed(NOW, system=system) for system in range(1, 18)),
            signed(NOW - MINUTE - 1, system=18),
            signed(NOW + 1, system=16),
        ],
    )


def _check(out, text):
    """Say where the file first differs from what it should be."""
    present = out.read_text(encoding="ascii", errors="replace") if out.exists() else ""
    for number, (found, made) in enumerate(zip_longest(present.split("\n"), text.split("\n")), start=1):
        if found != made:
            print(f"{out}:{number}: differs from what pymavlink makes", file=sys.stderr)
            return 1
    return 0


if __name__ == "__main__":
    sys.exit(main())
