#!/usr/bin/env python3
"""pymavlink at the other end of a link, as programs use it: mavutil.

usage: peer.py talk ADDRESS KIND, peer.py write FILE KIND, or peer.py read FILE KIND; KIND is v1, v2, or a key of 32 characters

`talk` answers each heartbeat with a number by one with that number and 1000 more, and says 0 every 100 ms. It takes
frames of its own version alone, and with a key, only what is signed. `write` makes a log of 50
heartbeats, `read` prints the numbers in one.
"""

import os
import socket
import sys
import time

V1 = sys.argv[3] == "v1"
if not V1:
    os.environ["MAVLINK20"] = "1"

from pymavlink import mavutil  # noqa: E402  the version is chosen before


def beat(mav, number):
    """Sends a heartbeat with this number."""
    mav.heartbeat_send(0, 0, 0, number, 0)


def talk(address, kind):
    """Answers until it is killed."""
    # Nobody listens yet, or the port is not free again yet.
    while True:
        try:
            link = mavutil.mavlink_connection(
                address, baud=57600, source_system=7, source_component=8, dialect="common", autoreconnect=True
            )
            break
        except OSError:
            time.sleep(0.02)
    # Else it would change its version with what it hears.
    link.first_byte = False
    if len(kind) == 32:
        link.setup_signing(kind.encode(), sign_outgoing=True, link_id=2)
    following = time.monotonic()
    while True:
        message = link.recv_match(type="HEARTBEAT", blocking=True, timeout=0.02)
        try:
            if message and message.get_srcSystem() == 255 and (message.get_msgbuf()[0] == 0xFE) == V1:
                beat(link.mav, message.custom_mode + 1000)
            if time.monotonic() >= following:
                beat(link.mav, 0)
                following += 0.1
        except OSError:
            # The other side is not there now.
            time.sleep(0.02)


def write(path):
    """Makes a log of what comes over a link."""
    # Over UDP it would write none.
    link = mavutil.mavlink_connection("tcpin:127.0.0.1:0", dialect="common")
    link.setup_logfile(path, mode="wb")
    sender = socket.create_connection(link.listen.getsockname())
    mav = mavutil.mavlink.MAVLink(None, srcSystem=7, srcComponent=8)
    for number in range(50):
        sender.send(mav.heartbeat_encode(0, 0, 0, number, 0).pack(mav))
        mav.seq = (mav.seq + 1) % 256
        link.recv_match(type="HEARTBEAT", blocking=True, timeout=10)
    link.logfile.close()


def read(path):
    """Prints the numbers in a log."""
    log = mavutil.mavlink_connection(path, dialect="common")
    while message := log.recv_match(type="HEARTBEAT"):
        print(message.custom_mode)


if __name__ == "__main__":
    if sys.argv[1] == "talk":
        talk(*sys.argv[2:])
    else:
        {"write": write, "read": read}[sys.argv[1]](sys.argv[2])
