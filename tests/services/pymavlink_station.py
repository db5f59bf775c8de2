"""pymavlink as the ground station of the simulated AutoQuad (`cargo run --bin vehicle`): its helpers for parameters and waypoints,
in MAVLink 1 with floats as old stations do, and in MAVLink 2.

usage: pymavlink_station.py VEHICLE, the program
"""

import os
import struct
import subprocess
import sys
import time

PORT = 24551
TYPES = {1: "B", 2: "b", 3: "H", 4: "h", 5: "I", 6: "i", 9: "f"}
EXPECTED = {
    "RATE_P": (9, 0.15), "RATE_D": (9, 0.003), "MOTORS": (1, 4), "TRIM": (2, -3), "PWM_MAX": (3, 1950), "LEVEL": (4, -250),
    "BAUD": (5, 115200), "OFFSET": (6, -70000),
}
NEW = {"RATE_P": 0.5, "MOTORS": 255, "TRIM": -128, "PWM_MAX": 65535, "LEVEL": -32768, "BAUD": 2**32 - 1, "OFFSET": -(2**31)}


def value(message):
    """The value, bytewise; every type is as it is, whatever float its bytes are."""
    form = TYPES[message.param_type]
    raw = struct.pack("<f", message.param_value)
    return struct.unpack("<" + form, raw[: struct.calcsize(form)])[0]


def answer(mav, kind, seconds=3.0, **fields):
    """The next message of this kind, with these fields."""
    end = time.monotonic() + seconds
    while time.monotonic() < end:
        message = mav.recv_match(type=kind, blocking=True, timeout=0.2)
        if message is not None and all(getattr(message, name) == wanted for name, wanted in fields.items()):
            return message
    raise AssertionError(f"no {kind} with {fields}")


def check_params(mav):
    from pymavlink.mavparm import MAVParmDict

    mav.param_fetch_all()
    listed = {}
    while len(listed) < len(EXPECTED):
        message = answer(mav, "PARAM_VALUE")
        assert message.param_count == len(EXPECTED)
        listed[message.param_id] = (message.param_type, value(message))
    for name, (kind, wanted) in EXPECTED.items():
        assert listed[name][0] == kind and abs(listed[name][1] - wanted) < 1e-6, (name, listed[name])
    for name, wanted in NEW.items():
        assert MAVParmDict().mavset(mav, name, wanted, parm_type=EXPECTED[name][0]), name
        mav.param_fetch_one(name)
        message = answer(mav, "PARAM_VALUE", param_id=name)
        assert value(message) == wanted, (name, value(message))
    for name in NEW:
        assert MAVParmDict().mavset(mav, name, EXPECTED[name][1], parm_type=EXPECTED[name][0]), name
    print(f"parameters: {len(listed)} of {len({kind for kind, _ in EXPECTED.values()})} types listed, {len(NEW)} set and read")


def plan(mavutil, count):
    """A mission with the loader of pymavlink, in floats."""
    from pymavlink.mavwp import MAVWPLoader

    loader = MAVWPLoader(1, 1)
    for seq in range(count):
        loader.add_latlonalt(47.0 + seq / 1000, 8.0 - seq / 1000, 10.0 + seq)
    return loader


def check_mission(mavutil, mav, count, request, item):
    """Uploads with the items that the vehicle asks for, or with those of an old station; reads them back."""
    loader = plan(mavutil, count)
    mav.waypoint_clear_all_send()
    answer(mav, "MISSION_ACK", type=0)
    mav.waypoint_count_send(loader.count())
    sent = 0
    while sent < count:
        asked = answer(mav, ["MISSION_REQUEST", "MISSION_REQUEST_INT"])
        wp = loader.wp(asked.seq)
        if item == "MISSION_ITEM":
            mav.mav.send(wp)
        else:
            mav.mav.mission_item_int_send(
                1, 1, wp.seq, wp.frame, wp.command, wp.current, wp.autocontinue, wp.param1, wp.param2, wp.param3, wp.param4,
                round(wp.x * 1e7), round(wp.y * 1e7), wp.z,
            )
        sent = max(sent, asked.seq + 1)
    answer(mav, "MISSION_ACK", type=0)
    mav.waypoint_request_list_send()
    assert answer(mav, "MISSION_COUNT").count == count
    for seq in range(count):
        if request == "MISSION_REQUEST":
            mav.waypoint_request_send(seq)
            told, scale = answer(mav, "MISSION_ITEM", seq=seq), 1.0
        else:
            mav.mav.mission_request_int_send(1, 1, seq)
            told, scale = answer(mav, "MISSION_ITEM_INT", seq=seq), 1e-7
        wp = loader.wp(seq)
        assert abs(told.x * scale - wp.x) < 1e-5 and abs(told.y * scale - wp.y) < 1e-5 and told.z == wp.z, (told, wp)
    mav.mav.mission_ack_send(1, 1, 0)
    mav.waypoint_set_current_send(count // 2)
    answer(mav, "MISSION_CURRENT", seq=count // 2)
    print(f"mission: {count} of {item} up, by {request} down")


def check_commands(mavutil, mav):
    mav.arducopter_arm()
    assert answer(mav, "COMMAND_ACK", command=mavutil.mavlink.MAV_CMD_COMPONENT_ARM_DISARM).result == 0
    mav.motors_armed_wait()
    mav.mav.command_int_send(1, 1, 6, mavutil.mavlink.MAV_CMD_NAV_TAKEOFF, 0, 0, 0, 0, 0, 0, 0, 0, 10.0)
    progress = []
    while True:
        ack = answer(mav, "COMMAND_ACK", command=mavutil.mavlink.MAV_CMD_NAV_TAKEOFF)
        if ack.result != 5:
            break
        progress.append(ack.progress)
    assert ack.result == 0 and progress == sorted(progress) and len(progress) > 3, (ack, progress)
    mav.mav.command_long_send(1, 1, mavutil.mavlink.MAV_CMD_SET_MESSAGE_INTERVAL, 0, 33, 50000, 0, 0, 0, 0, 0)
    answer(mav, "COMMAND_ACK", command=511, result=0)
    mav.mav.command_long_send(1, 1, 511, 0, 99999, 50000, 0, 0, 0, 0, 0)
    assert answer(mav, "COMMAND_ACK", command=511).result == 3
    print(f"commands: armed, took off with {len(progress)} reports of progress")


def check_time(mav):
    mav.mav.timesync_send(0, 123456789)
    told = answer(mav, "TIMESYNC", ts1=123456789)
    assert told.tc1 > 0
    print("time: answered")


def run(program, version):
    os.environ["MAVLINK20"] = "1" if version == 2 else ""
    for name in [name for name in sys.modules if name.startswith("pymavlink")]:
        del sys.modules[name]
    if version == 1:
        os.environ.pop("MAVLINK20")
    from pymavlink import mavutil

    mav = mavutil.mavlink_connection(f"udpin:127.0.0.1:{PORT}", source_system=255, source_component=190)
    vehicle = subprocess.Popen([program, f"udpout:127.0.0.1:{PORT}"], stdout=subprocess.DEVNULL)
    try:
        assert mav.wait_heartbeat(timeout=10) is not None
        print(f"MAVLink {version}: system {mav.target_system}, component {mav.target_component}")
        check_params(mav)
        check_mission(mavutil, mav, 20, "MISSION_REQUEST", "MISSION_ITEM")
        check_mission(mavutil, mav, 300, "MISSION_REQUEST_INT", "MISSION_ITEM_INT")
        check_time(mav)
        if version == 2:
            check_commands(mavutil, mav)
    finally:
        vehicle.kill()
        vehicle.wait()
        mav.close()


if __name__ == "__main__":
    for each in (1, 2):
        run(sys.argv[1], each)
