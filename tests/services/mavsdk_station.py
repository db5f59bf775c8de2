"""MAVSDK as the ground station of the simulated AutoQuad (`cargo run --bin vehicle`).

usage: mavsdk_station.py VEHICLE, the program; fails if MAVSDK sees anything that is not so.
"""

import math
import subprocess
import sys
import time

from mavsdk import ComponentType, Configuration, Mavsdk
from mavsdk.plugins.action.action import Action, ActionError
from mavsdk.plugins.geofence.geofence import Circle, FenceType, Geofence, GeofenceData, Point, Polygon
from mavsdk.plugins.info.info import Info
from mavsdk.plugins.mission_raw.mission_raw import MissionItem, MissionRaw, MissionRawError
from mavsdk.plugins.param.param import Param, ParamError
from mavsdk.plugins.telemetry.telemetry import LandedState, Telemetry

PORT = 24550


def until(what, condition, seconds=10.0):
    """Waits until it is so."""
    end = time.monotonic() + seconds
    while not condition():
        assert time.monotonic() < end, f"{what}: not within {seconds} s"
        time.sleep(0.02)
    print(f"{what}: yes")


def refused(what, error, action):
    """It has to be refused, with a result that is not a timeout."""
    try:
        action()
    except error as refusal:
        assert "TIMEOUT" not in str(refusal), f"{what}: {refusal}"
        print(f"{what}: refused, {str(refusal).split(';')[0]}")
    else:
        raise AssertionError(f"{what}: accepted")


def check_params(system):
    param = Param(system)
    everything = param.get_all_params()
    ints = {item.name: item.value for item in everything.int_params}
    floats = {item.name: item.value for item in everything.float_params}
    # MAVSDK lists signed integers and floats alone, and sets those of 32 bits: pymavlink_station.py has the other types.
    assert ints == {"TRIM": -3, "LEVEL": -250, "OFFSET": -70000}, ints
    for name, value in ints.items():
        assert param.get_param_int(name) == value, name
    for value in (0, 16777217, -(2**31), 2**31 - 1):
        param.set_param_int("OFFSET", value)
        assert param.get_param_int("OFFSET") == value
    param.set_param_float("RATE_P", 0.25)
    assert param.get_param_float("RATE_P") == 0.25
    refused("a parameter that is not there", ParamError, lambda: param.get_param_int("NO_SUCH"))
    print(f"parameters: {len(ints) + len(floats)} listed, 2 set and read")


def waypoint(seq, mission_type=0, command=16, frame=6):
    return MissionItem(
        seq=seq, frame=frame, command=command, current=int(seq == 0), autocontinue=1, param1=float(seq % 7),
        x=473977420 + 10 * seq, y=85455940 - 10 * seq, z=10.0 + seq, mission_type=mission_type,
    )


def same(sent, told):
    facts = [[(i.seq, i.frame, i.command, i.param1, i.x, i.y, i.z) for i in items] for items in (sent, told)]
    assert facts[0] == facts[1], "another plan came back"


def check_plans(system):
    raw = MissionRaw(system)
    mission = [waypoint(seq) for seq in range(300)]
    began = time.monotonic()
    raw.upload_mission(mission)
    sent = time.monotonic()
    same(mission, raw.download_mission())
    print(f"mission of 300 items: up in {sent - began:.2f} s, down in {time.monotonic() - sent:.2f} s")

    corners = [Point(47.39, 8.54), Point(47.40, 8.54), Point(47.40, 8.55), Point(47.39, 8.55)]
    fence = GeofenceData(
        polygons=[Polygon(points=corners, fence_type=FenceType.INCLUSION)],
        circles=[Circle(point=Point(47.395, 8.545), radius=50.0, fence_type=FenceType.EXCLUSION)],
    )
    Geofence(system).upload_geofence(fence)
    told = raw.download_geofence()
    assert [item.command for item in told] == [5001] * 4 + [5004], told
    rally = [waypoint(seq, mission_type=2, command=5100) for seq in range(3)]
    raw.upload_rally_points(rally)
    same(rally, raw.download_rallypoints())
    same(mission, raw.download_mission())
    raw.set_current_mission_item(7)
    print("fence of 5 items, 3 rally points: up, and down; the mission is as it was")
    refused("a mission that is too long", MissionRawError, lambda: raw.upload_mission([waypoint(s) for s in range(600)]))
    raw.clear_mission()
    assert raw.download_mission() == []
    print("mission: cleared")


def check_flight(system):
    action, telemetry = Action(system), Telemetry(system)
    seen = {}
    for name in ("position", "landed_state", "armed"):
        getattr(telemetry, f"subscribe_{name}")(lambda value, _, name=name: seen.__setitem__(name, value))
    telemetry.set_rate_position(20.0)
    until("telemetry: position", lambda: "position" in seen and math.isclose(seen["position"].latitude_deg, 47.397742))
    until("telemetry: on the ground", lambda: seen.get("landed_state") == LandedState.ON_GROUND)
    refused("takeoff while disarmed", ActionError, action.takeoff)
    action.arm()
    until("telemetry: armed", lambda: seen.get("armed") is True)
    action.takeoff()
    until("telemetry: in the air", lambda: seen["landed_state"] == LandedState.IN_AIR)
    until("telemetry: 10 m up", lambda: seen["position"].relative_altitude_m > 9.9)
    refused("disarm in the air", ActionError, action.disarm)
    action.land()
    until("telemetry: landed", lambda: seen["landed_state"] == LandedState.ON_GROUND)
    action.disarm()
    until("telemetry: disarmed", lambda: seen["armed"] is False)


def main():
    configuration = Configuration.create_with_component_type(ComponentType.GROUND_STATION)
    mavsdk = Mavsdk(configuration)
    result = mavsdk.add_any_connection(f"udpin://127.0.0.1:{PORT}")
    assert result.name == "SUCCESS", result
    vehicle = subprocess.Popen([sys.argv[1], f"udpout:127.0.0.1:{PORT}"], stdout=subprocess.DEVNULL)
    try:
        system = mavsdk.first_autopilot(10.0)
        assert system is not None, "MAVSDK sees no vehicle"
        print(f"MAVSDK {mavsdk.version()} sees system {system.get_system_id()}, {system.vehicle_type()}")
        version = Info(system).get_version()
        assert (version.flight_sw_major, version.flight_sw_minor, version.flight_sw_patch) == (1, 2, 3), version
        check_params(system)
        check_plans(system)
        check_flight(system)
        assert system.is_connected()
    finally:
        vehicle.kill()
        vehicle.wait()
    until("the vehicle is gone", lambda: not system.is_connected())
    mavsdk.destroy()


if __name__ == "__main__":
    main()
