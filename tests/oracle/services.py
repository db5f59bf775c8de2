#!/usr/bin/env python3
"""pymavlink at the other end of parameters and plans, with its own helpers: as a station, or as a vehicle.

usage: services.py station PORT bytewise|cast    asks the vehicle on this UDP port, and prints what it got
       services.py vehicle PORT bytewise|cast    is a vehicle for the station on this UDP port, until that says STATUSTEXT

For mavlink-services/tests/pymavlink.rs. With `bytewise`, values are bytes and plans go by the messages of today; with `cast`, values
are floats and everything is as old stations and vehicles do it. The dialect is pymavlink's own `common`.
"""

import os
import struct
import sys
import time

os.environ["MAVLINK20"] = "1"

from pymavlink import mavparm, mavutil, mavwp  # noqa: E402

mavutil.set_dialect("common")
mavlink = mavutil.mavlink

PATIENCE = 20
TYPES = {
    mavlink.MAV_PARAM_TYPE_UINT8: "<B",
    mavlink.MAV_PARAM_TYPE_INT8: "<b",
    mavlink.MAV_PARAM_TYPE_UINT16: "<H",
    mavlink.MAV_PARAM_TYPE_INT16: "<h",
    mavlink.MAV_PARAM_TYPE_UINT32: "<I",
    mavlink.MAV_PARAM_TYPE_INT32: "<i",
    mavlink.MAV_PARAM_TYPE_REAL32: "<f",
}


def main():
    """The command."""
    role, port, encoding = sys.argv[1], int(sys.argv[2]), sys.argv[3]
    system, component = (255, 190) if role == "station" else (1, 1)
    link = mavutil.mavlink_connection(f"udpout:127.0.0.1:{port}", source_system=system, source_component=component)
    (Station if role == "station" else Vehicle)(link, encoding == "bytewise").run()


def decode(field, kind, bytewise):
    """The number that a field of a parameter carries."""
    if not bytewise:
        return field
    layout = TYPES[kind]
    return struct.unpack(layout, struct.pack("<f", field)[: struct.calcsize(layout)])[0]


def encode(value, kind, bytewise):
    """The field that carries a number."""
    if not bytewise:
        return float(value)
    return struct.unpack("<f", struct.pack(TYPES[kind], value).ljust(4, b"\0"))[0]


class Station:
    """Does what ground stations on pymavlink do."""

    def __init__(self, link, bytewise):
        self.link, self.bytewise = link, bytewise

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
        self.download(mavlink.MAV_MISSION_TYPE_MISSION)
        self.download(mavlink.MAV_MISSION_TYPE_FENCE)
        self.link.waypoint_set_current_send(3)
        while self.expect("MISSION_CURRENT").seq != 3:
            pass
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
            print("param", value.param_id, value.param_type, decode(value.param_value, value.param_type, self.bytewise))

    def set(self):
        """Sets with mavparm, and reads again."""
        parameters = mavparm.MAVParmDict()
        kinds = (mavlink.MAV_PARAM_TYPE_UINT8, mavlink.MAV_PARAM_TYPE_INT32, mavlink.MAV_PARAM_TYPE_REAL32)
        for name, value, kind in zip(("A_UINT8", "AN_INT32", "A_REAL32"), (5, -77, 0.75), kinds):
            # Stations of ArduPilot leave the type away.
            if not parameters.mavset(self.link, name, value, parm_type=kind if self.bytewise else None):
                sys.exit(f"{name} was not set")
            self.link.param_fetch_one(name)
            value = self.expect("PARAM_VALUE")
            print("set", value.param_id, decode(value.param_value, value.param_type, self.bytewise))

    def upload(self, loader):
        """Sends a plan; as an old station, knowing nothing of MISSION_REQUEST_INT."""
        kind = loader.mav_mission_type()
        command = {0: mavlink.MAV_CMD_NAV_WAYPOINT, 1: mavlink.MAV_CMD_NAV_FENCE_CIRCLE_INCLUSION}.get(kind, mavlink.MAV_CMD_NAV_RALLY_POINT)
        for seq in range(12):
            frame = mavlink.MAV_FRAME_GLOBAL_RELATIVE_ALT
            place = (47.5 + seq / 64, -8.25 - seq / 64, 10.0 + seq)
            loader.add(mavlink.MAVLink_mission_item_message(1, 1, seq, frame, command, 0, 1, seq, 0, 0, 0, *place, kind))
        self.link.mav.mission_count_send(1, 1, loader.count(), kind)
        while True:
            old = ("MISSION_REQUEST", "MISSION_ACK")
            message = self.expect(*old, "MISSION_REQUEST_INT") if self.bytewise else self.expect(*old)
            if message.get_type() == "MISSION_ACK":
                print("upload", message.type, message.mission_type)
                return
            item = loader.wp(message.seq)
            self.link.mav.send(scaled(item) if self.bytewise else item)

    def download(self, kind):
        """Fetches a plan."""
        self.link.mav.mission_request_list_send(1, 1, kind)
        loader = mavwp.MAVWPLoader(1, 1)
        for seq in range(self.expect("MISSION_COUNT").count):
            if self.bytewise:
                self.link.mav.mission_request_int_send(1, 1, seq, kind)
                item = self.expect("MISSION_ITEM_INT")
                item.x, item.y = item.x / 1e7, item.y / 1e7
            else:
                self.link.mav.mission_request_send(1, 1, seq, kind)
                item = self.expect("MISSION_ITEM")
            loader.add(item)
            print("item", kind, item.seq, item.command, item.x, item.y, item.z)
        self.link.mav.mission_ack_send(1, 1, mavlink.MAV_MISSION_ACCEPTED, kind)


def scaled(item):
    """An item with integers."""
    numbers = (item.param1, item.param2, item.param3, item.param4, int(item.x * 1e7), int(item.y * 1e7), item.z)
    flags = (item.frame, item.command, item.current, item.autocontinue)
    return mavlink.MAVLink_mission_item_int_message(1, 1, item.seq, *flags, *numbers, item.mission_type)


class Vehicle:
    """A vehicle with parameters and plans; a PX4 or an ArduPilot in what they do differently."""

    def __init__(self, link, bytewise):
        self.link, self.bytewise = link, bytewise
        self.kinds = {f"P{number}": list(TYPES)[number % 7] for number in range(40)}
        self.values = mavparm.MAVParmDict()
        for number, name in enumerate(self.kinds):
            self.values[name] = number
        self.plans = {}
        self.awaited = None

    def run(self):
        """Answers until it is told to stop."""
        self.link.mav.heartbeat_send(mavlink.MAV_TYPE_QUADROTOR, mavlink.MAV_AUTOPILOT_GENERIC, 0, 0, 0)
        end = time.time() + 6 * PATIENCE
        while time.time() < end:
            message = self.link.recv_match(blocking=True, timeout=PATIENCE)
            if message is None:
                sys.exit(f"nothing came in {PATIENCE} s")
            kind = message.get_type()
            if kind == "STATUSTEXT":
                return
            answer = getattr(self, kind.lower(), None)
            if answer is not None:
                answer(message)
        sys.exit("the station does not come to an end")

    def tell(self, name, index):
        """PARAM_VALUE."""
        field = encode(self.values[name], self.kinds[name], self.bytewise)
        self.link.mav.param_value_send(name.encode(), field, self.kinds[name], len(self.kinds), index)

    def param_request_list(self, _):
        """Every seventh is lost."""
        if self.bytewise:
            self.link.mav.param_value_send(b"_HASH_CHECK", 1.0, mavlink.MAV_PARAM_TYPE_UINT32, len(self.kinds), 65535)
        for index, name in enumerate(self.kinds):
            if index % 7 != 3:
                self.tell(name, index)

    def param_request_read(self, request):
        """By index, or by name."""
        names = list(self.kinds)
        name = request.param_id if request.param_index < 0 else names[request.param_index]
        if name in self.kinds:
            self.tell(name, names.index(name) if self.bytewise or request.param_index >= 0 else 65535)

    def param_set(self, request):
        """ArduPilot does not look at the type, and tells no index."""
        name = request.param_id
        if name not in self.kinds or (self.bytewise and request.param_type != self.kinds[name]):
            return
        self.values[name] = decode(request.param_value, self.kinds[name], self.bytewise)
        self.tell(name, list(self.kinds).index(name) if self.bytewise else 65535)

    def mission_count(self, count):
        """A plan is to come."""
        self.plans[count.mission_type] = mavwp.MAVWPLoader(255, 190)
        self.awaited = count.count
        self.go_on(count.mission_type)

    def go_on(self, kind):
        """Asks for the next item."""
        have = self.plans[kind].count()
        if have == self.awaited:
            self.link.mav.mission_ack_send(255, 190, mavlink.MAV_MISSION_ACCEPTED, kind)
        elif self.bytewise:
            self.link.mav.mission_request_int_send(255, 190, have, kind)
        else:
            self.link.mav.mission_request_send(255, 190, have, kind)

    def mission_item_int(self, item):
        """The next item."""
        if item.seq == self.plans[item.mission_type].count():
            self.plans[item.mission_type].add(item)
            self.go_on(item.mission_type)

    mission_item = mission_item_int

    def mission_request_list(self, request):
        """How many there are."""
        loader = self.plans.get(request.mission_type, mavwp.MAVWPLoader(255, 190))
        self.link.mav.mission_count_send(255, 190, loader.count(), request.mission_type)

    def mission_request_int(self, request):
        """An item, in the form in which it came."""
        item = self.plans[request.mission_type].wp(request.seq)
        item.target_system, item.target_component = 255, 190
        self.link.mav.send(item)

    mission_request = mission_request_int

    def mission_clear_all(self, request):
        """A plan is cleared; rally points are not."""
        refused = request.mission_type == mavlink.MAV_MISSION_TYPE_RALLY
        result = mavlink.MAV_MISSION_DENIED if refused else mavlink.MAV_MISSION_ACCEPTED
        if not refused:
            self.plans.pop(request.mission_type, None)
        self.link.mav.mission_ack_send(255, 190, result, request.mission_type)

    def mission_set_current(self, request):
        """Says where it is."""
        self.link.mav.mission_current_send(request.seq)


if __name__ == "__main__":
    main()
