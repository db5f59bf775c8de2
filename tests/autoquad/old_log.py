"""Writes a recording as AutoQuad's QGroundControl did: times with the lowest byte first, frames without their last eight bytes."""

import sys
from pathlib import Path


def main():
    log, old = Path(sys.argv[1]).read_bytes(), bytearray()
    place = 0
    while place < len(log):
        frame = log[place + 8 : place + 16 + log[place + 9]]
        old += log[place : place + 8][::-1] + frame[:-8]
        place += 8 + len(frame)
    Path(sys.argv[2]).write_bytes(old)


if __name__ == "__main__":
    main()
