"""What CommonRoad's own tools make of exported scenes, against exported tracks: read, held to the schema, driven.

commonroad-io wants protobuf 3.20.2, which onnxruntime does not work with, and its drivability checker an older
commonroad-io, which comes without the schema. So each has an environment of its own:

    python -m venv read && read/bin/pip install commonroad-io==2026.1
    read/bin/python benchmarks/commonroad_elsewhere.py COMMONROAD_FOLDER CSV_FOLDER
    python -m venv drive && drive/bin/pip install commonroad-io==2024.3 commonroad-drivability-checker==2025.4.0
    drive/bin/python benchmarks/commonroad_elsewhere.py COMMONROAD_FOLDER CSV_FOLDER --drive

A drive is feasible from one step to the next if the checker finds inputs for which its kinematic single-track model, of
a BMW 320i, gets within 2 cm and 0.03 rad, its own margins. Steering angles are those that the yaw rates ask for.
"""

from __future__ import annotations

import argparse
import csv
import logging
import math
import warnings
from collections import Counter
from itertools import pairwise
from pathlib import Path
from typing import Any

import commonroad
import numpy as np
import shapely
from commonroad.common.file_reader import CommonRoadFileReader
from commonroad.common.solution import VehicleType
from commonroad.scenario.state import KSState
from lxml import etree

SCHEMA = Path(commonroad.__file__).parent / "common" / "xml_definition_files" / "XML_commonRoad_XSD.xsd"
Tracks = dict[str, dict[str, Any]]


def driven(path: Path) -> Tracks:
    """Columns of the table of tracks, by actor in its order."""
    tracks: Tracks = {}
    with path.open() as rows:
        for row in csv.DictReader(rows):
            track = tracks.setdefault(row["actor"], {"kind": row["kind"], "size": None, "poses": []})
            track["size"] = float(row["length_m"]), float(row["width_m"])
            names = ("x_m", "y_m", "heading_rad", "speed_m_per_s")
            track["poses"].append([float(row[name]) for name in names])
    return {actor: {**track, "poses": np.array(track["poses"])} for actor, track in tracks.items()}


def farthest(scenario: Any, problem: Any, tracks: Tracks) -> tuple[float, float, int]:
    """The largest distance [m] and angle [rad] of a body from its track, and the poses compared."""
    away = turned = 0.0
    compared = 0
    ego, *others = tracks.values()
    obstacles = sorted(scenario.obstacles, key=lambda one: one.obstacle_id)
    assert len(obstacles) == len(others), "the same actors"
    for obstacle, track in zip(obstacles, others, strict=True):
        shape = obstacle.obstacle_shape
        assert abs(shape.length - track["size"][0]) + abs(shape.width - track["size"][1]) < 1e-6, "the same size"
        for step, (x, y, heading, speed) in enumerate(track["poses"]):
            state = obstacle.state_at_time(step)
            away = max(away, math.dist(state.position, (x, y)))
            turned = max(turned, abs(math.remainder(state.orientation - heading, math.tau)))
            assert abs(state.velocity - speed) < 1e-6, "the same speed"
            compared += 1
    away = max(away, math.dist(problem.initial_state.position, ego["poses"][0, :2]))
    return away, turned, compared


def box(track: dict[str, Any], step: int) -> shapely.Polygon:
    x, y, heading, _ = track["poses"][step]
    length, width = track["size"]
    box = shapely.affinity.rotate(shapely.box(-length / 2, -width / 2, length / 2, width / 2), heading, (0, 0), True)
    return shapely.affinity.translate(box, x, y)


def contact(tracks: Tracks) -> int | None:
    """The first step at which the ego's box overlaps another's, by our tracks."""
    ego, *others = tracks.values()
    steps = range(len(ego["poses"]))
    return next((i for i in steps if any(box(ego, i).intersection(box(o, i)).area > 0 for o in others)), None)


def contact_there(scenario: Any, ego: dict[str, Any]) -> int | None:
    """The same by the checker's collision detection, with everybody else from the file."""
    from commonroad_dc.collision.collision_detection.pycrcc_collision_dispatch import create_collision_checker
    from commonroad_dc.pycrcc import RectOBB, TimeVariantCollisionObject

    checker = create_collision_checker(scenario)
    length, width = ego["size"]
    for step, (x, y, heading, _) in enumerate(ego["poses"]):
        moment = TimeVariantCollisionObject(step)
        moment.append_obstacle(RectOBB(length / 2, width / 2, heading, x, y))
        if checker.collide(moment):
            return step
    return None


def feasible(track: dict[str, Any], dt: float) -> list[bool]:
    """Whether each step of a car can be driven."""
    from commonroad_dc.feasibility.feasibility_checker import state_transition_feasibility
    from commonroad_dc.feasibility.vehicle_dynamics import VehicleDynamics

    car = VehicleDynamics.KS(VehicleType.BMW_320i)
    wheelbase = car.parameters.a + car.parameters.b
    x, y, heading, speed = track["poses"].T
    rate = np.diff(heading, append=heading[-1:]) / dt
    steer = np.where(np.abs(speed) > 0.1, np.arctan2(wheelbase * rate, np.maximum(np.abs(speed), 0.1)), 0.0)
    states = [
        KSState(
            time_step=step,
            position=np.array([x[step], y[step]]),  # the centre; the checker goes to the axle itself
            velocity=speed[step],
            orientation=h,
            steering_angle=float(steer[step]),
        )
        for step, h in enumerate(heading)
    ]
    return [state_transition_feasibility(a, b, car, dt)[0] for a, b in pairwise(states)]


def reached(problem: Any, on: list[list[int]]) -> bool:
    """Whether the ego as driven, on these lanelets step by step, is at the goal at a time that is asked for."""
    (goal,) = problem.goal.state_list
    wanted = (problem.goal.lanelets_of_goal_position or {}).get(0)
    steps = on[goal.time_step.start : goal.time_step.end + 1]
    return any(wanted is None or not set(wanted).isdisjoint(there) for there in steps)


def read(path: Path, scenario: Any, problem: Any, tracks: Tracks) -> Counter[str]:
    """What the reader and the schema say."""
    etree.XMLSchema(etree.parse(str(SCHEMA))).assertValid(etree.parse(str(path)))
    away, turned, poses = farthest(scenario, problem, tracks)
    network = scenario.lanelet_network
    on = network.find_lanelet_by_position(list(tracks["ego"]["poses"][:, :2]))
    told = f"{100 * away:.1e} cm, {turned:.1e} rad at most, of {poses} poses"
    print(f"{path.stem}: {told}; goal reached: {reached(problem, on)}")
    return Counter(
        scenes=1,
        poses=poses,
        lanelets=len(network.lanelets),
        valid_lanelets=sum(lanelet.polygon.shapely_object.is_valid for lanelet in network.lanelets),
        goals_of_lanelets=problem.goal.lanelets_of_goal_position is not None,
        reached=reached(problem, on),
        ego_poses=len(on),
        ego_poses_on_lanelets=sum(map(bool, on)),
    )


def drive(path: Path, scenario: Any, _: Any, tracks: Tracks) -> Counter[str]:
    """What the drivability checker says."""
    here, there = contact(tracks), contact_there(scenario, tracks["ego"])
    cars = [track for track in tracks.values() if track["kind"] == "Car"]
    steps = [step for car in cars for step in feasible(car, scenario.dt)]
    print(f"{path.stem}: contact at step {here}, there {there}; feasible {sum(steps)} of {len(steps)} steps")
    return Counter(scenes=1, collided=here is not None, agreed=here == there, steps=len(steps), feasible=sum(steps))


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("commonroad", type=Path)
    parser.add_argument("csv", type=Path)
    parser.add_argument("--drive", action="store_true", help="ask the drivability checker instead")
    asked = parser.parse_args()
    logging.disable(logging.WARNING)
    warnings.simplefilter("ignore")
    count: Counter[str] = Counter()
    for path in sorted(asked.commonroad.glob("*.xml")):
        scenario, problems = CommonRoadFileReader(str(path)).open(lanelet_assignment=True)
        (problem,) = problems.planning_problem_dict.values()
        count += (drive if asked.drive else read)(path, scenario, problem, driven(asked.csv / f"{path.stem}.csv"))
    print(", ".join(f"{name} {number}" for name, number in count.items()))


if __name__ == "__main__":
    main()
