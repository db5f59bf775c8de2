"""pymavlink as an old vehicle, for a station of ours: parameters cast to floats as ArduPilot does, waypoints in floats asked for by
MISSION_REQUEST, AUTOPILOT_VERSION by the old command. It answers until its standard input is closed.

usage: pymavlink_vehicle.py PORT, where the station listens
"""

import os
import sys
import threading
import time

os.environ["MAVLINK20"] = "1"
from pymavlink import mavutil  # noqa: E402
from pymavlink.mavparm import MAVParmDict  # noqa: E402
from pymavlink.mavwp import MAVWPLoader  # noqa: E402

link = mavutil.mavlink
TYPES = {"FLOAT": 9, "UINT8": 1, "INT8": 2, "UINT16": 3, "INT16": 4, "UINT32": 5, "INT32": 6}
VALUES = {"FLOAT": 0.15, "UINT8": 200, "INT8": -100, "UINT16": 60000, "INT16": -30000, "UINT32": 2**24, "INT32": -(2**24)}


class Vehicle:
    def __init__(self, port):
        self.mav = mavutil.mavlink_connection(f"udpout:127.0.0.1:{port}", source_system=1, source_component=1)
        self.params = MAVParmDict()
        for name in [*VALUES, *(f"MORE_{index}" for index in range(60 - len(VALUES)))]:
            self.params[name] = VALUES.get(name, 0.5)
        self.wp, self.coming = MAVWPLoader(255, 190), None

    def param(self, index, told=None):
        name = list(self.params)[index]
        self.mav.mav.param_value_send(
            name.encode(), float(self.params[name]), TYPES.get(name, 9), len(self.params), index if told is None else told
        )

    def ack(self, command, result, progress=0):
        self.mav.mav.command_ack_send(command, result, progress, 0, 255, 190)

    def on_PARAM_REQUEST_LIST(self, _):
        for index in range(len(self.params)):
            # Some do not get through.
            if index % 7 != 3:
                self.param(index)

    def on_PARAM_REQUEST_READ(self, message):
        if message.param_index >= 0:
            self.param(message.param_index)
        elif message.param_id in self.params:
            self.param(list(self.params).index(message.param_id))

    def on_PARAM_SET(self, message):
        if message.param_id in self.params:
            self.params[message.param_id] = message.param_value
            # ArduPilot tells no index here.
            self.param(list(self.params).index(message.param_id), told=65535)

    def on_MISSION_COUNT(self, message):
        self.coming = (MAVWPLoader(255, 190), message.count)
        self.mav.mav.mission_request_send(255, 190, 0)

    def on_MISSION_ITEM(self, message):
        loader, count = self.coming
        if message.seq != loader.count():
            return
        loader.add(message)
        if loader.count() < count:
            self.mav.mav.mission_request_send(255, 190, loader.count())
        else:
            self.wp = loader
            self.mav.mav.mission_ack_send(255, 190, link.MAV_MISSION_ACCEPTED)

    def on_MISSION_REQUEST_LIST(self, _):
        self.mav.mav.mission_count_send(255, 190, self.wp.count())

    def on_MISSION_REQUEST(self, message):
        item = self.wp.wp(message.seq)
        item.target_system, item.target_component = 255, 190
        self.mav.mav.send(item)

    def on_MISSION_CLEAR_ALL(self, _):
        self.wp.clear()
        self.mav.mav.mission_ack_send(255, 190, link.MAV_MISSION_ACCEPTED)

    def on_MISSION_SET_CURRENT(self, message):
        self.mav.mav.mission_current_send(message.seq)

    def on_TIMESYNC(self, message):
        if message.tc1 == 0:
            self.mav.mav.timesync_send(time.monotonic_ns(), message.ts1)

    def on_COMMAND_LONG(self, message):
        if message.command == link.MAV_CMD_REQUEST_AUTOPILOT_CAPABILITIES:
            self.ack(message.command, link.MAV_RESULT_ACCEPTED)
            capabilities = link.MAV_PROTOCOL_CAPABILITY_MISSION_FLOAT
            self.mav.mav.autopilot_version_send(capabilities, 0, 0, 0, 0, [0] * 8, [0] * 8, [0] * 8, 0, 0, 7)
        elif message.command == link.MAV_CMD_PREFLIGHT_CALIBRATION:
            for progress in (0, 50):
                self.ack(message.command, link.MAV_RESULT_IN_PROGRESS, progress)
                time.sleep(0.1)
            self.ack(message.command, link.MAV_RESULT_ACCEPTED)
        elif message.command == link.MAV_CMD_COMPONENT_ARM_DISARM and message.param1 == 0:
            self.mav.mav.statustext_send(link.MAV_SEVERITY_ERROR, b"in flight")
            self.ack(message.command, link.MAV_RESULT_DENIED)
        elif message.command == link.MAV_CMD_COMPONENT_ARM_DISARM:
            self.ack(message.command, link.MAV_RESULT_ACCEPTED)
        else:
            self.ack(message.command, link.MAV_RESULT_UNSUPPORTED)

    def run(self, over):
        beat = 0.0
        while not over.is_set():
            if time.monotonic() >= beat:
                self.mav.mav.heartbeat_send(link.MAV_TYPE_QUADROTOR, link.MAV_AUTOPILOT_ARDUPILOTMEGA, 0, 0, 3)
                beat = time.monotonic() + 1
            message = self.mav.recv_match(blocking=True, timeout=0.05)
            if message is not None:
                getattr(self, f"on_{message.get_type()}", lambda _: None)(message)


if __name__ == "__main__":
    over = threading.Event()
    threading.Thread(target=lambda: (sys.stdin.read(), over.set()), daemon=True).start()
    Vehicle(sys.argv[1]).run(over)
