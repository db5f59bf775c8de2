#!/usr/bin/env python3
"""MAVSDK at the other end of a link.

usage: mavsdk_peer.py ADDRESS

Answers each heartbeat with a number by one with that number and 1000 more; its own heartbeats have number 0.
"""

import json
import sys
import threading
import time

from mavsdk import Configuration, Mavsdk
from mavsdk.plugins.mavlink_direct import MavlinkDirect, MavlinkMessage


def main():
    """Answers until it is killed."""
    sdk = Mavsdk(Configuration.create_manual(7, 8, True))
    while sdk.add_any_connection(sys.argv[1]) != 0:
        # Nobody listens yet, or the port is not free again yet.
        time.sleep(0.02)
    while not (systems := sdk.get_systems()):
        time.sleep(0.01)
    direct = MavlinkDirect(systems[0])

    def answer(message, _):
        fields = json.loads(message.fields_json)
        if message.system_id != 255:
            return
        beat = {"custom_mode": fields["custom_mode"] + 1000, "type": 0, "autopilot": 8, "base_mode": 0}
        beat |= {"system_status": 0, "mavlink_version": 3}
        direct.send_message(MavlinkMessage("HEARTBEAT", 7, 8, 0, 0, json.dumps(beat)))

    direct.subscribe_message("HEARTBEAT", answer)
    threading.Event().wait()


if __name__ == "__main__":
    main()
