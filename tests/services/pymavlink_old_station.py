"""pymavlink as a station that is old: for ArduPilot, whose values are floats, and with no idea of MISSION_REQUEST_INT. Sends a mission, a
fence and rally points with pymavlink's loaders, fetches them, and prints what it got.

usage: pymavlink_old_station.py PORT, where the vehicle listens
"""

import os
import sys

os.environ["MAVLINK20"] = "1"
from pymavlink import mavparm, mavutil, mavwp  # noqa: E402

mavutil.set_dialect("common")
mavlink = mavutil.mavlink

PATIENCE = 20


class Station:
    """Does what ground stations on pymavlink do."""

    def __init__(self, port):
        self.link = mavutil.mavlink_connection(f"udpout:127.0.0.1:{port}", source_system=255, source_component=190)

    def expect(self, *kinds):
        """The next message of these kinds."""
        message = self.link.recv_match(type=list(kinds), blocking=True, timeout=PATIENCE)
        if message is None:
            sys.exit(f"no {' or '.join(kinds)} in {PATIENCE} s")
        return message

    def run(self):
        """All of it."""
        self.link.mav.heartbeat_send(mavlink.MAV_TYPE_GCS, mavlink.MAV_AUTOPILOT_INVALID, 0, 0, 0)
        self.link.wait_heartbeat(timeout=PATIENCE)
        self.list()
        self.set()
        for loader in (mavwp.MAVWPLoader, mavwp.MissionItemProtocol_Fence, mavwp.MissionItemProtocol_Rally):
            self.upload(loader(1, 1))
            self.download(loader(1, 1).mav_mission_type())
        self.link.mav.mission_clear_all_send(1, 1, mavlink.MAV_MISSION_TYPE_RALLY)
        ack = self.expect("MISSION_ACK")
        print("clear", ack.type, ack.mission_type)

    def list(self):
        """Lists, fills gaps."""
        self.link.param_fetch_all()
        found, count = {}, None
        while count is None or len(found) < count:
            value = self.link.recv_match(type="PARAM_VALUE", blocking=True, timeout=1)
            if value is None:
                for index in set(range(count or 1)) - set(found):
                    self.link.param_fetch_one(index)
                continue
            found[value.param_index], count = value, value.param_count
        for index in sorted(found):
            value = found[index]
            print("param", value.param_id, value.param_type, value.param_value)

    def set(self):
        """Sets with mavparm, which leaves the type away, and reads again."""
        parameters = mavparm.MAVParmDict()
        for name, value in (("A_UINT8", 5), ("AN_INT32", -77), ("A_REAL32", 0.75)):
            if not parameters.mavset(self.link, name, value):
                sys.exit(f"{name} was not set")
            self.link.param_fetch_one(name)
            value = self.expect("PARAM_VALUE")
            print("set", value.param_id, value.param_value)

    def upload(self, loader):
        """Sends a plan; the first question, a MISSION_REQUEST_INT, is not heard."""
        kind = loader.mav_mission_type()
        command = (mavlink.MAV_CMD_NAV_WAYPOINT, mavlink.MAV_CMD_NAV_FENCE_CIRCLE_INCLUSION, mavlink.MAV_CMD_NAV_RALLY_POINT)[kind]
        for seq in range(12):
            frame = mavlink.MAV_FRAME_GLOBAL_RELATIVE_ALT
            place = (47.5 + seq / 64, -8.25 - seq / 64, 10.0 + seq)
            loader.add(mavlink.MAVLink_mission_item_message(1, 1, seq, frame, command, 0, 1, seq, 0, 0, 0, *place, kind))
        self.link.mav.mission_count_send(1, 1, loader.count(), kind)
        while (message := self.expect("MISSION_REQUEST", "MISSION_ACK")).get_type() != "MISSION_ACK":
            self.link.mav.send(loader.wp(message.seq))
        print("upload", message.type, message.mission_type)

    def download(self, kind):
        """Fetches a plan."""
        self.link.mav.mission_request_list_send(1, 1, kind)
        for seq in range(self.expect("MISSION_COUNT").count):
            self.link.mav.mission_request_send(1, 1, seq, kind)
            item = self.expect("MISSION_ITEM")
            print("item", kind, item.seq, item.command, item.x, item.y, item.z)
        self.link.mav.mission_ack_send(1, 1, mavlink.MAV_MISSION_ACCEPTED, kind)


if __name__ == "__main__":
    Station(sys.argv[1]).run()
