"""pymavlink as a vehicle that behaves as PX4 does: values bytewise, a hash before the list, types that have to fit, MISSION_REQUEST_INT
and MISSION_ITEM_INT; it says nothing of its capabilities. It answers until its standard input is closed.

usage: pymavlink_px4.py PORT, where the station listens
"""

import os
import struct
import sys
import threading
import time

os.environ["MAVLINK20"] = "1"
from pymavlink import mavutil  # noqa: E402
from pymavlink.mavparm import MAVParmDict  # noqa: E402
from pymavlink.mavwp import MAVWPLoader  # noqa: E402

mavutil.set_dialect("common")
link = mavutil.mavlink
LAYOUTS = {1: "<B", 2: "<b", 3: "<H", 4: "<h", 5: "<I", 6: "<i", 9: "<f"}


class Vehicle:
    def __init__(self, port):
        self.mav = mavutil.mavlink_connection(f"udpout:127.0.0.1:{port}", source_system=1, source_component=1)
        self.kinds = {f"P{number}": list(LAYOUTS)[number % 7] for number in range(40)}
        self.values = MAVParmDict()
        for number, name in enumerate(self.kinds):
            self.values[name] = number
        self.plans, self.awaited = {}, None

    def param(self, name):
        kind, index = self.kinds[name], list(self.kinds).index(name)
        (field,) = struct.unpack("<f", struct.pack(LAYOUTS[kind], self.values[name]).ljust(4, b"\0"))
        self.mav.mav.param_value_send(name.encode(), field, kind, len(self.kinds), index)

    def on_PARAM_REQUEST_LIST(self, _):
        self.mav.mav.param_value_send(b"_HASH_CHECK", 1.0, link.MAV_PARAM_TYPE_UINT32, len(self.kinds), 65535)
        for index, name in enumerate(self.kinds):
            # Some do not get through.
            if index % 7 != 3:
                self.param(name)

    def on_PARAM_REQUEST_READ(self, message):
        name = message.param_id if message.param_index < 0 else list(self.kinds)[message.param_index]
        if name in self.kinds:
            self.param(name)

    def on_PARAM_SET(self, message):
        if self.kinds.get(message.param_id) == message.param_type:
            layout = LAYOUTS[message.param_type]
            raw = struct.pack("<f", message.param_value)[: struct.calcsize(layout)]
            (self.values[message.param_id],) = struct.unpack(layout, raw)
            self.param(message.param_id)

    def on_MISSION_COUNT(self, message):
        self.plans[message.mission_type], self.awaited = MAVWPLoader(255, 190), message.count
        self.go_on(message.mission_type)

    def go_on(self, kind):
        have = self.plans[kind].count()
        if have == self.awaited:
            self.mav.mav.mission_ack_send(255, 190, link.MAV_MISSION_ACCEPTED, kind)
        else:
            self.mav.mav.mission_request_int_send(255, 190, have, kind)

    def on_MISSION_ITEM_INT(self, message):
        if message.seq == self.plans[message.mission_type].count():
            self.plans[message.mission_type].add(message)
            self.go_on(message.mission_type)

    def on_MISSION_REQUEST_LIST(self, message):
        count = self.plans[message.mission_type].count() if message.mission_type in self.plans else 0
        self.mav.mav.mission_count_send(255, 190, count, message.mission_type)

    def on_MISSION_REQUEST_INT(self, message):
        item = self.plans[message.mission_type].wp(message.seq)
        item.target_system, item.target_component = 255, 190
        self.mav.mav.send(item)

    def on_MISSION_CLEAR_ALL(self, message):
        refused = message.mission_type == link.MAV_MISSION_TYPE_RALLY
        if not refused:
            self.plans.pop(message.mission_type, None)
        result = link.MAV_MISSION_DENIED if refused else link.MAV_MISSION_ACCEPTED
        self.mav.mav.mission_ack_send(255, 190, result, message.mission_type)

    def on_COMMAND_LONG(self, message):
        self.mav.mav.command_ack_send(message.command, link.MAV_RESULT_UNSUPPORTED, 0, 0, 255, 190)

    def run(self, over):
        beat = 0.0
        while not over.is_set():
            if time.monotonic() >= beat:
                self.mav.mav.heartbeat_send(link.MAV_TYPE_QUADROTOR, link.MAV_AUTOPILOT_PX4, 0, 0, 3)
                beat = time.monotonic() + 1
            message = self.mav.recv_match(blocking=True, timeout=0.05)
            if message is not None:
                getattr(self, f"on_{message.get_type()}", lambda _: None)(message)


if __name__ == "__main__":
    over = threading.Event()
    threading.Thread(target=lambda: (sys.stdin.read(), over.set()), daemon=True).start()
    Vehicle(sys.argv[1]).run(over)
