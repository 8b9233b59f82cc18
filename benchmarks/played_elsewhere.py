"""How far a player of others is from what was driven: exported OpenSCENARIO in scenario-gym, against exported tracks.

scenario-gym 0.4.5 needs NumPy 1, and nothing of it is needed here, so it has an environment of its own:

    python -m venv gym && gym/bin/pip install scenario-gym==0.4.5 "numpy<2"
    gym/bin/python benchmarks/played_elsewhere.py XOSC_FOLDER CSV_FOLDER --step 0.1
"""

from __future__ import annotations

import argparse
import csv
import math
from collections import defaultdict
from pathlib import Path
from typing import Any

import numpy as np


def driven(path: Path) -> dict[str, Any]:
    """Rows of time, x, y, heading, length and width by actor."""
    tracks: dict[str, list[list[float]]] = defaultdict(list)
    with path.open() as rows:
        for row in csv.DictReader(rows):
            names = ("time_s", "x_m", "y_m", "heading_rad", "length_m", "width_m")
            tracks[row["actor"]].append([float(row[name]) for name in names])
    return {actor: np.array(poses) for actor, poses in tracks.items()}


def farthest(path: Path, tracks: dict[str, Any], step: float) -> tuple[float, float, int]:
    """The largest distance of a centre [m] and of a heading [rad] from the track, and the poses compared."""
    from scenario_gym import ScenarioGym
    from scenario_gym.xosc_interface import import_scenario

    scenario = import_scenario(str(path), relabel=False)
    assert {one.ref for one in scenario.entities} == set(tracks), "the same actors"
    assert scenario.road_network is not None, "the map beside it is read"
    gym = ScenarioGym(timestep=step)
    gym.set_scenario(scenario)
    gym.reset_scenario()
    away = turned = 0.0
    compared = 0
    while True:
        for one in scenario.entities:
            x, y, _, heading, *_ = gym.state.poses[one]
            box, track = one.catalog_entry.bounding_box, tracks[one.ref]
            assert abs(box.length - track[0, 4]) + abs(box.width - track[0, 5]) < 1e-6, "the same size"
            was_x, was_y, was_heading = (np.interp(gym.state.t, track[:, 0], track[:, i]) for i in (1, 2, 3))
            centre = x + box.center_x * math.cos(heading), y + box.center_x * math.sin(heading)
            away = max(away, math.dist(centre, (was_x, was_y)))
            turned = max(turned, abs(math.remainder(heading - was_heading, math.tau)))
            compared += 1
        if gym.state.is_done:
            return away, turned, compared
        gym.step()


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("xosc", type=Path)
    parser.add_argument("csv", type=Path)
    parser.add_argument("--step", type=float, default=0.1, help="of the player [s]")
    asked = parser.parse_args()
    for path in sorted(asked.xosc.glob("*.xosc")):
        away, turned, compared = farthest(path, driven(asked.csv / f"{path.stem}.csv"), asked.step)
        print(f"{path.stem}: {100 * away:.6f} cm, {turned:.1e} rad at most, of {compared} poses")


if __name__ == "__main__":
    main()
