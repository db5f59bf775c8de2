"""MAVSDK as a vehicle, for a station of ours: it answers until its standard input is closed, and prints what it was told.

usage: mavsdk_vehicle.py PORT, where the station listens
"""

import sys
import time
import threading

from mavsdk import ComponentType, Configuration, Mavsdk
from mavsdk.plugins.action_server.action_server import ActionServer, AllowableFlightModes
from mavsdk.plugins.mission_raw_server.mission_raw_server import MissionRawServer
from mavsdk.plugins.param_server.param_server import ParamServer
from mavsdk.plugins.telemetry_server.telemetry_server import Heading, Position, TelemetryServer, VelocityNed


def main():
    mavsdk = Mavsdk(Configuration.create_with_component_type(ComponentType.AUTOPILOT))
    component = mavsdk.server_component_by_type(ComponentType.AUTOPILOT)
    params = ParamServer(component)
    for index in range(50):
        params.provide_param_int(f"INT_{index}", index * 1000003 - 25)
        params.provide_param_float(f"FLOAT_{index}", index / 8)
    params.provide_param_int("CAL_ACC0_ID", 1)
    actions, missions, telemetry = ActionServer(component), MissionRawServer(component), TelemetryServer(component)
    actions.set_armable(True, False)
    actions.set_disarmable(True, False)
    actions.set_allow_takeoff(True)
    actions.set_allowable_flight_modes(AllowableFlightModes(True, True, True))

    def say(*words):
        print(*words, flush=True)

    actions.subscribe_arm_disarm(lambda result, data, _: say("arm", result.name, data.arm))
    actions.subscribe_takeoff(lambda result, data, _: say("takeoff", result.name, data))
    missions.subscribe_incoming_mission(lambda result, plan, _: say("mission", result.name, len(plan.mission_items)))
    missions.subscribe_clear_all(lambda data, _: say("clear", data))
    params.subscribe_changed_param_int(lambda data, _: say("int", data.name, data.value))
    params.subscribe_changed_param_float(lambda data, _: say("float", data.name, data.value))
    result = mavsdk.add_any_connection(f"udpout://127.0.0.1:{sys.argv[1]}")
    assert result.name == "SUCCESS", result

    threading.Thread(target=lambda: (sys.stdin.read(), over.set()), daemon=True).start()
    while not over.wait(0.1):
        telemetry.publish_position(Position(47.397742, 8.545594, 418.0, 10.0), VelocityNed(0.0, 0.0, 0.0), Heading(0.0))
    mavsdk.destroy()


over = threading.Event()
if __name__ == "__main__":
    main()
