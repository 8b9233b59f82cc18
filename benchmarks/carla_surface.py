"""Every method of the wheel's classes against the stand-in for CARLA: what answers, what refuses, what hangs or dies.

    python benchmarks/carla_surface.py [CLASS.METHOD ...]

A child process calls one method after the other and says what came of each; where it dies or does not come back within
20 s, that method is named and another child goes on behind it. Arguments stand below, by name. Prints what does not
simply answer, what is refused unheard, and counts. Needs the extra 'carla'. With names, only those.
"""

from __future__ import annotations

import json
import queue
import re
import socket
import subprocess
import sys
import tempfile
import threading
import time
from collections import Counter
from collections.abc import Callable, Iterator
from pathlib import Path
from typing import Any

import carla  # pyright: ignore[reportMissingImports]

LONGEST = 20.0  # [s] of one call
MKZ, WALKER = "vehicle.lincoln.mkz_2017", "walker.pedestrian.0001"
CHILD, MARK = "--child", "@@"  # the wheel prints, too


def arguments(bench: Bench) -> dict[str, tuple[Any, ...]]:
    """What methods are called with, where that is not nothing."""
    vector, at = carla.Vector3D(1.0, 0.0, 0.0), carla.Location(1.0, 2.0, 0.5)
    texture, colours = carla.TextureColor(2, 2), carla.TextureFloatColor(2, 2)
    box = carla.BoundingBox(carla.Location(), carla.Vector3D(1.0, 1.0, 1.0))
    car, light = bench.car, bench.light
    log = str(bench.folder / "recorded.log")
    waypoint = bench.map.get_waypoint(car.get_location())
    junction = next(first for first, _ in bench.map.get_topology() if first.is_junction).get_junction()
    landmark = bench.map.get_all_landmarks()[0]
    diffuse = carla.MaterialParameter.Diffuse
    command = carla.command.ApplyVehicleControl(car, carla.VehicleControl())
    text = bench.map.to_opendrive()
    found: dict[str, tuple[Any, ...]] = {
        "World.apply_color_texture_to_object": ("x", diffuse, texture),
        "World.apply_color_texture_to_objects": (["x"], diffuse, texture),
        "World.apply_float_color_texture_to_object": ("x", diffuse, colours),
        "World.apply_float_color_texture_to_objects": (["x"], diffuse, colours),
        "World.apply_textures_to_object": ("x", texture, colours, colours, colours),
        "World.apply_textures_to_objects": (["x"], texture, colours, colours, colours),
        "World.apply_settings": (bench.world.get_settings(),),
        "World.cast_ray": (at, carla.Location(50.0, 2.0, 0.5)),
        "World.enable_environment_objects": ({1}, True),
        "World.freeze_all_traffic_lights": (False,),
        "World.get_actor": (car.id,),
        "World.get_traffic_light": (landmark,),
        "World.get_traffic_light_from_opendrive_id": (light.get_opendrive_id(),),
        "World.get_traffic_lights_from_waypoint": (waypoint, 50.0),
        "World.get_traffic_lights_in_junction": (junction.id,),
        "World.get_traffic_sign": (landmark,),
        "World.ground_projection": (carla.Location(at.x, at.y, 5.0), 20.0),
        "World.load_map_layer": (carla.MapLayer.All,),
        "World.unload_map_layer": (carla.MapLayer.All,),
        "World.on_tick": (print,),
        "World.remove_on_tick": (1,),
        "World.project_point": (carla.Location(at.x, at.y, 5.0), carla.Vector3D(0.0, 0.0, -1.0), 20.0),
        "World.set_annotations_traverse_translucency": (True,),
        "World.set_imui_sensor_gravity": (9.8,),
        "World.set_pedestrians_cross_factor": (0.1,),
        "World.set_pedestrians_seed": (1,),
        "World.set_weather": (carla.WeatherParameters(),),
        "World.spawn_actor": (bench.library.find(MKZ), bench.map.get_spawn_points()[20]),
        "World.try_spawn_actor": (bench.library.find(MKZ), bench.map.get_spawn_points()[21]),
        "Actor.add_angular_impulse": (vector,),
        "Actor.add_force": (vector,),
        "Actor.add_impulse": (vector,),
        "Actor.add_torque": (vector,),
        "Actor.enable_constant_velocity": (vector,),
        "Actor.get_component_relative_transform": ("front",),
        "Actor.get_component_world_transform": ("front",),
        "Actor.set_collisions": (True,),
        "Actor.set_enable_gravity": (True,),
        "Actor.set_location": (car.get_location(),),
        "Actor.set_simulate_physics": (True,),
        "Actor.set_target_angular_velocity": (vector,),
        "Actor.set_target_velocity": (vector,),
        "Actor.set_transform": (car.get_transform(),),
        "Vehicle.apply_ackermann_control": (carla.VehicleAckermannControl(),),
        "Vehicle.apply_ackermann_controller_settings": (carla.AckermannControllerSettings(),),
        "Vehicle.apply_control": (carla.VehicleControl(),),
        "Vehicle.apply_physics_control": (carla.VehiclePhysicsControl(),),
        "Vehicle.close_door": (carla.VehicleDoor.All,),
        "Vehicle.open_door": (carla.VehicleDoor.All,),
        "Vehicle.enable_carsim": ("x",),
        "Vehicle.use_carsim_road": (True,),
        "Vehicle.enable_chrono_physics": (10, 0.01, "a", "b", "c", "d"),
        "Vehicle.get_wheel_pitch_angle": (carla.VehicleWheelLocation.FL_Wheel,),
        "Vehicle.get_wheel_steer_angle": (carla.VehicleWheelLocation.FL_Wheel,),
        "Vehicle.set_wheel_pitch_angle": (carla.VehicleWheelLocation.FL_Wheel, 1.0),
        "Vehicle.set_wheel_steer_direction": (carla.VehicleWheelLocation.FL_Wheel, 1.0),
        "Vehicle.set_autopilot": (False, bench.manager_port),
        "Vehicle.set_light_state": (carla.VehicleLightState.NONE,),
        "Vehicle.show_debug_telemetry": (True,),
        "Walker.apply_control": (carla.WalkerControl(),),
        "Walker.blend_pose": (0.5,),
        "Walker.set_bones": (carla.WalkerBoneControlIn(),),
        "TrafficLight.freeze": (False,),
        "TrafficLight.set_green_time": (10.0,),
        "TrafficLight.set_red_time": (2.0,),
        "TrafficLight.set_yellow_time": (3.0,),
        "TrafficLight.set_state": (carla.TrafficLightState.Red,),
        "Sensor.listen": (_ignore,),
        "WalkerAIController.go_to_location": (at,),
        "WalkerAIController.set_max_speed": (1.4,),
        "Map.cook_in_memory_map": (str(bench.folder / "cooked.bin"),),
        "Map.generate_waypoints": (50.0,),
        "Map.geolocation_to_transform": (bench.map.transform_to_geolocation(at),),
        "Map.get_all_landmarks_from_id": (landmark.id,),
        "Map.get_all_landmarks_of_type": ("1000001",),
        "Map.get_all_road_marks_of_type": ("solid",),
        "Map.get_road_marks_from_id": ("1",),
        "Map.get_landmark_group": (landmark,),
        "Map.get_waypoint": (at,),
        "Map.get_waypoint_xodr": (waypoint.road_id, waypoint.lane_id, waypoint.s),
        "Map.save_to_disk": (str(bench.folder / "town.xodr"),),
        "Map.transform_to_geolocation": (at,),
        "Client.apply_batch": ([command],),
        "Client.apply_batch_sync": ([command], False),
        "Client.generate_opendrive_world": (text,),
        "Client.get_trafficmanager": (bench.manager_port,),
        "Client.load_world": ("town",),
        "Client.load_world_if_different": ("town",),
        "Client.reload_world": (),
        "Client.request_file": ("town.xodr",),
        "Client.set_files_base_folder": (str(bench.folder),),
        "Client.set_timeout": (10.0,),
        "Client.set_replayer_ignore_hero": (True,),
        "Client.set_replayer_ignore_spectator": (True,),
        "Client.set_replayer_time_factor": (1.0,),
        "Client.stop_replayer": (True,),
        "Client.start_recorder": (log,),
        "Client.show_recorder_file_info": (bench.recorded, True),
        "Client.show_recorder_collisions": (bench.recorded, "a", "a"),
        "Client.show_recorder_actors_blocked": (bench.recorded, 1.0, 1.0),
        "Client.replay_file": (bench.recorded, 0.0, 0.0, 0),
        "TrafficManager.auto_lane_change": (car, True),
        "TrafficManager.collision_detection": (car, bench.other, True),
        "TrafficManager.distance_to_leading_vehicle": (car, 5.0),
        "TrafficManager.force_lane_change": (car, True),
        "TrafficManager.get_all_actions": (car,),
        "TrafficManager.get_next_action": (car,),
        "TrafficManager.global_lane_offset": (0.1,),
        "TrafficManager.global_percentage_speed_difference": (10.0,),
        "TrafficManager.set_boundaries_respawn_dormant_vehicles": (25.0, 100.0),
        "TrafficManager.set_desired_speed": (car, 20.0),
        "TrafficManager.set_global_distance_to_leading_vehicle": (5.0,),
        "TrafficManager.set_hybrid_physics_mode": (False,),
        "TrafficManager.set_hybrid_physics_radius": (50.0,),
        "TrafficManager.set_osm_mode": (True,),
        "TrafficManager.set_path": (car, [at]),
        "TrafficManager.set_random_device_seed": (1,),
        "TrafficManager.set_respawn_dormant_vehicles": (False,),
        "TrafficManager.set_route": (car, ["Straight"]),
        "TrafficManager.set_synchronous_mode": (True,),
        "TrafficManager.update_vehicle_lights": (car, True),
        "TrafficManager.vehicle_lane_offset": (car, 0.1),
        "DebugHelper.clear_debug_shape": (),
        "DebugHelper.clear_debug_string": (),
        "DebugHelper.draw_arrow": (at, at),
        "DebugHelper.draw_box": (box, carla.Rotation()),
        "DebugHelper.draw_hud_arrow": (at, at),
        "DebugHelper.draw_hud_box": (box, carla.Rotation()),
        "DebugHelper.draw_hud_line": (at, at),
        "DebugHelper.draw_hud_point": (at,),
        "DebugHelper.draw_line": (at, at),
        "DebugHelper.draw_point": (at,),
        "DebugHelper.draw_string": (at, "x"),
        "LightManager.get_all_lights": (),
        "LightManager.set_active": ([], []),
        "LightManager.set_day_night_cycle": (True,),
        "BlueprintLibrary.filter": ("vehicle.*",),
        "BlueprintLibrary.filter_by_attribute": ("number_of_wheels", "4"),
        "BlueprintLibrary.find": (MKZ,),
        "ActorBlueprint.get_attribute": ("role_name",),
        "ActorBlueprint.has_attribute": ("role_name",),
        "ActorBlueprint.has_tag": ("vehicle",),
        "ActorBlueprint.match_tags": ("vehicle.*",),
        "ActorBlueprint.set_attribute": ("role_name", "x"),
        "WorldSnapshot.find": (car.id,),
        "WorldSnapshot.has_actor": (car.id,),
        "Waypoint.get_landmarks": (50.0,),
        "Waypoint.get_landmarks_of_type": (50.0, "1000001"),
        "Waypoint.next": (5.0,),
        "Waypoint.next_until_lane_end": (5.0,),
        "Waypoint.previous": (5.0,),
        "Waypoint.previous_until_lane_start": (5.0,),
        "Junction.get_waypoints": (carla.LaneType.Driving,),
    }
    for one in ("ignore_lights", "ignore_signs", "ignore_vehicles", "ignore_walkers", "keep_slow_lane_rule"):
        found[f"TrafficManager.{one}_percentage"] = (car, 10.0)
    for one in ("random_left_lanechange", "random_right_lanechange"):
        found[f"TrafficManager.{one}_percentage"] = (car, 10.0)
    found["TrafficManager.vehicle_percentage_speed_difference"] = (car, 10.0)
    for one in ("get_color", "get_intensity", "get_light_group", "get_light_state"):
        found[f"LightManager.{one}"] = ([],)
    for one in ("turn_on", "turn_off", "is_active"):
        found[f"LightManager.{one}"] = ([],)
    groups = carla.LightGroup.NONE
    found |= {
        "LightManager.get_all_lights": (groups,),
        "LightManager.get_turned_on_lights": (groups,),
        "LightManager.get_turned_off_lights": (groups,),
        "LightManager.set_color": ([], carla.Color(1, 2, 3)),
        "LightManager.set_colors": ([], []),
        "LightManager.set_intensity": ([], 1.0),
        "LightManager.set_intensities": ([], []),
        "LightManager.set_light_group": ([], groups),
        "LightManager.set_light_groups": ([], []),
        "LightManager.set_light_state": ([], carla.LightState()),
        "LightManager.set_light_states": ([], []),
    }
    return found


def _ignore(_: Any) -> None:
    """For what a sensor tells."""


class Bench:
    """A world with one of everything.

    Args:
        port: Of the server.
    """

    def __init__(self, port: int) -> None:
        self.folder = Path(tempfile.mkdtemp(prefix="carla-surface-"))
        self.client = carla.Client("127.0.0.1", port)
        self.client.set_timeout(10.0)
        self.world = self.client.load_world("town")
        settings = self.world.get_settings()
        settings.synchronous_mode, settings.fixed_delta_seconds = True, 0.05
        self.world.apply_settings(settings)
        self.library, self.map = self.world.get_blueprint_library(), self.world.get_map()
        points = self.map.get_spawn_points()
        self.car, self.other = (self.world.spawn_actor(self.library.find(MKZ), point) for point in points[:2])
        self.walker = self.world.spawn_actor(self.library.find(WALKER), points[3])
        head = carla.Transform()
        self.guide = self.world.spawn_actor(self.library.find("controller.ai.walker"), head, attach_to=self.walker)
        self.sensor = self.world.spawn_actor(self.library.find("sensor.other.gnss"), head, attach_to=self.car)
        self.recorded = str(self.folder / "before.log")
        self.client.start_recorder(self.recorded)
        self.world.tick()
        self.client.stop_recorder()
        self.light = self.world.get_actors().filter("traffic.traffic_light")[0]
        self.manager_port = free_port()
        self._manager: Any = None

    def of(self, name: str) -> Any:
        """The object of a class."""
        waypoint: Callable[[], Any] = lambda: self.map.get_waypoint(self.car.get_location())  # noqa: E731
        junction: Callable[[], Any] = lambda: next(  # noqa: E731
            first for first, _ in self.map.get_topology() if first.is_junction
        ).get_junction()
        return {
            "Client": lambda: self.client,
            "World": lambda: self.world,
            "Map": lambda: self.map,
            "Vehicle": lambda: self.car,
            "Walker": lambda: self.walker,
            "WalkerAIController": lambda: self.guide,
            "Sensor": lambda: self.sensor,
            "TrafficLight": lambda: self.light,
            "TrafficManager": self._managed,
            "DebugHelper": lambda: self.world.debug,
            "LightManager": self.world.get_lightmanager,
            "BlueprintLibrary": lambda: self.library,
            "ActorBlueprint": lambda: self.library.find(MKZ),
            "WorldSnapshot": self.world.get_snapshot,
            "Waypoint": waypoint,
            "Junction": junction,
            "Landmark": lambda: self.map.get_all_landmarks()[0],
        }[name]()

    def _managed(self) -> Any:
        if self._manager is None:
            self._manager = self.client.get_trafficmanager(self.manager_port)
            self._manager.set_synchronous_mode(True)
            self.car.set_autopilot(True, self.manager_port)
            self.world.tick()
        return self._manager


CLASSES = (
    "World", "Vehicle", "Walker", "TrafficLight", "Map", "Client", "Sensor", "WalkerAIController", "TrafficManager",
    "DebugHelper", "LightManager", "BlueprintLibrary", "ActorBlueprint", "WorldSnapshot", "Waypoint", "Junction",
    "Landmark",
)  # fmt: skip
LAST = ("destroy", "shut_down", "load_world", "reload_world", "generate_opendrive_world")


def surface() -> Iterator[str]:
    """All names, those that end what others need at the end."""
    names = [f"{kind}.{name}" for kind in CLASSES for name in dir(getattr(carla, kind)) if not name.startswith("_")]
    late = [name for name in names if name.split(".")[1] in LAST]
    yield from (name for name in names if name not in late)
    yield from late


def called(bench: Bench, name: str, given: dict[str, tuple[Any, ...]]) -> str:
    """What comes of one."""
    kind, method = name.split(".")
    what = given.get(name, given.get(f"Actor.{method}", ()))
    try:
        found = getattr(bench.of(kind), method)
        if callable(found):
            found = found(*what)
        if method not in LAST and kind in ("Vehicle", "Walker", "World"):
            bench.world.tick()
    except Exception as error:  # noqa: BLE001 - whatever a call ends in is what is asked
        return f"{type(error).__name__}: {' '.join(str(error).split())[:160]}"
    return "answers"


def child(port: int, names: list[str]) -> None:
    """Call one after the other; a line for each, before and after."""
    bench = Bench(port)
    given = arguments(bench)
    for name in names:
        print(f"\n{MARK}{json.dumps([name])}", flush=True)
        print(f"\n{MARK}{json.dumps([name, called(bench, name, given)])}", flush=True)


def free_port() -> int:
    with socket.socket() as probe:
        probe.bind(("127.0.0.1", 0))
        port: int = probe.getsockname()[1]
        return port


def read(out: Any, lines: queue.Queue[str]) -> None:
    """Pass on what a process prints, and an empty line at its end."""
    for line in out:
        lines.put(line)
    lines.put("")


def all_called(port: int, names: list[str]) -> dict[str, str]:
    """What came of each."""
    results: dict[str, str] = {}
    while left := [name for name in names if name not in results]:
        command = [sys.executable, __file__, CHILD, str(port), *left]
        with subprocess.Popen(command, stdout=subprocess.PIPE, stderr=subprocess.DEVNULL, text=True) as process:
            lines: queue.Queue[str] = queue.Queue()
            threading.Thread(target=read, args=(process.stdout, lines), daemon=True).start()
            now, ended = "the beginning", ""
            while not ended:
                try:
                    line = lines.get(timeout=LONGEST)
                except queue.Empty:
                    ended = f"HANGS: no answer in {LONGEST:g} s"
                    break
                if not line:
                    ended = f"DIES: exit status {process.wait()}"
                    break
                if line.startswith(MARK):
                    (now, *result), _ = json.JSONDecoder().raw_decode(line.removeprefix(MARK))
                    if result:
                        results[now] = result[0]
            process.kill()
        if set(left) - set(results) and now not in results:
            results[now] = ended
        elif set(left) - set(results):
            results[now] += f", then {ended}"
    return results


def main() -> None:
    if sys.argv[1:2] == [CHILD]:
        child(int(sys.argv[2]), sys.argv[3:])
        return
    names = sys.argv[1:] or list(surface())
    port = free_port()
    command = [sys.executable, "-m", "chatscene", "serve-carla", "--port", str(port), "--files", tempfile.gettempdir()]
    with (
        tempfile.TemporaryFile("w+") as log,
        subprocess.Popen(command, stdout=subprocess.PIPE, stderr=log, text=True) as server,
    ):
        try:
            assert server.stdout is not None
            server.stdout.readline()
            start = time.perf_counter()
            results = all_called(port, names)
        finally:
            server.terminate()
        log.seek(0)
        refused = set(re.findall(r"^refused: (\w+):", log.read(), re.MULTILINE))
    for name, result in results.items():
        if result != "answers":
            print(f"{name}: {result}")
    unheard = sorted(name for name in refused if not any(name in result for result in results.values()))
    print(f"refused, though the wheel does not wait to hear it: {', '.join(unheard) or 'none'}")
    kinds = Counter(
        "answer" if result == "answers" else "hang or die" if result.startswith(("HANGS", "DIES")) else "refuse"
        for result in results.values()
    )
    print(
        ", ".join(f"{count} {kind}" for kind, count in sorted(kinds.items())), f"in {time.perf_counter() - start:.0f} s"
    )


if __name__ == "__main__":
    main()
