"""Receivers of signed frames: pymavlink's own, and the C library that it generates."""

import os
import subprocess
from dataclasses import dataclass
from pathlib import Path

from dialect import generate_c, load_module
from layout import SIGNING_KEY

RADIO_STATUS = 109
"""The message that is accepted unsigned."""

FRAMING_OK = 1
VERDICTS = {
    (1, 1): "signed",
    (3, 0): "unsigned",
    (3, 2): "wrong_hash",
    (3, 4): "too_many_streams",
    (3, 5): "too_old",
    (3, 6): "replayed",
}
"""What the C library says, by the result of framing and the status of signing."""

HERE = Path(__file__).parent


@dataclass(frozen=True)
class Verdict:
    """What the C library says of a frame, its time afterwards, and whether pymavlink accepts the frame."""

    word: str
    time: int
    accepted_by_pymavlink: bool


class Receivers:
    """Both receivers of a dialect that has the messages of `common.xml`."""

    def __init__(self, xml, folder):
        self.module = load_module(xml, "2.0", folder)
        generate_c(xml, folder / "c")
        self._c = folder / "verify_signatures"
        command = [
            os.environ.get("CC", "cc"),
            "-O1",
            "-w",
            "-I",
            folder / "c",
            HERE / "verify_signatures.c",
            "-o",
            self._c,
        ]
        subprocess.run(command, check=True)

    def verdicts(self, time, frames):
        """What both say of these frames, one after the other, if it is this time at the start."""
        lines = "".join(f"{frame.hex()}\n" for frame in frames)
        run = subprocess.run([self._c], input=f"sequence {time:x}\n{lines}", text=True, capture_output=True, check=True)
        answers = [tuple(int(number, 16) for number in line.split()) for line in run.stdout.splitlines()]
        accepted = self._accepted(time, frames)
        return [Verdict(_word(*answer[:2]), answer[2], yes) for answer, yes in zip(answers, accepted, strict=True)]

    def _accepted(self, time, frames):
        receiver = self.module.MAVLink(None)
        receiver.signing.secret_key = SIGNING_KEY
        receiver.signing.timestamp = time
        receiver.signing.allow_unsigned_callback = lambda _, id: id == RADIO_STATUS
        for frame in frames:
            try:
                receiver.decode(bytearray(frame))
                yield True
            except self.module.MAVError as error:
                if str(error) != "Invalid signature":
                    raise
                yield False


def _word(framing, status):
    """A frame that is accepted although its signature is not good is allowed."""
    if framing == FRAMING_OK and status != 1:
        return "allowed"
    return VERDICTS[framing, status]
