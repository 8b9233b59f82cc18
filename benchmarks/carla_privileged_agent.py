"""An agent in the leaderboard's manner: sensors in each step, and privileged state, to drive a route by.

ScenarioRunner loads this file by `--agent`; the class is called as the file is. It asks for a camera, a lidar, a
satellite receiver and an inertial sensor, makes its own speedometer of the vehicle's true velocity, and keeps to its
route and off bodies ahead by what the world knows. It ends the run where a sensor's frame is missing or is not true.
"""

from __future__ import annotations

import math
from typing import Any

from agents.navigation.basic_agent import BasicAgent  # pyright: ignore[reportMissingImports]
from srunner.autoagents.autonomous_agent import AutonomousAgent  # pyright: ignore[reportMissingImports]
from srunner.scenariomanager.carla_data_provider import CarlaDataProvider  # pyright: ignore[reportMissingImports]

CRUISE = 30.0  # [km/h]
NEAR = 1e-4  # [degrees] that a satellite fix may be off
MOUNT = {"x": 0.0, "y": 0.0, "z": 1.8, "roll": 0.0, "pitch": 0.0, "yaw": 0.0}


class CarlaPrivilegedAgent(AutonomousAgent):
    """See the head of this file."""

    def setup(self, _: str) -> None:
        """Nothing is read."""
        self._agent: Any = None
        self._steps = 0

    def sensors(self) -> list[dict[str, Any]]:
        """What it asks for; the leaderboard's names."""
        lidar = {"range": 50, "rotation_frequency": 20, "channels": 16, "upper_fov": 2, "lower_fov": -25}
        return [
            {"type": "sensor.camera.rgb", **MOUNT, "width": 200, "height": 150, "fov": 90, "id": "camera"},
            {"type": "sensor.lidar.ray_cast", **MOUNT, **lidar, "points_per_second": 20000, "id": "lidar"},
            {"type": "sensor.other.gnss", **MOUNT, "id": "gnss"},
            {"type": "sensor.other.imu", **MOUNT, "id": "imu"},
        ]

    def run_step(self, input_data: dict[str, Any], _: float) -> Any:
        """One step: look at all sensors, then drive."""
        hero = CarlaDataProvider.get_hero_actor()
        if self._agent is None:
            self._agent = BasicAgent(hero, CRUISE)
            self._agent.set_global_plan(self._plan())
        speed = hero.get_velocity().length()
        shapes = {name: values.shape for name, (_, values) in input_data.items()}
        assert set(shapes) == {"camera", "lidar", "gnss", "imu"}, shapes
        assert shapes["camera"] == (150, 200, 4), shapes
        assert shapes["lidar"][1] == 4, shapes
        fix = CarlaDataProvider.get_map().transform_to_geolocation(hero.get_location())
        told = input_data["gnss"][1]
        assert abs(told[0] - fix.latitude) < NEAR, (told, fix)
        assert abs(told[1] - fix.longitude) < NEAR, (told, fix)
        assert math.isfinite(speed)
        assert all(map(math.isfinite, input_data["imu"][1]))
        self._steps += 1
        if self._steps % 100 == 0:
            points = shapes["lidar"][0]
            print(
                f"step {self._steps}: {speed:.1f} m/s, {points} points, frames {self._frames(input_data)}", flush=True
            )
        return self._agent.run_step()

    @staticmethod
    def _frames(input_data: dict[str, Any]) -> list[int]:
        return sorted({frame for frame, _ in input_data.values()})

    def _plan(self) -> list[Any]:
        """Its route, as the agent wants it."""
        town = CarlaDataProvider.get_map()
        return [(town.get_waypoint(place.location), option) for place, option in self._global_plan_world_coord]
