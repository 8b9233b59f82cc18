"""How far readers of others are from what was driven: exported OSI traces, against exported tracks.

Two readers, which share no code of messages with the exporter: betterosi 0.9.0 decodes with protobuf-py, and
omega-prime 0.3.7 makes a validated recording of a trace. They have an environment of their own:

    python -m venv osi && osi/bin/pip install omega-prime==0.3.7 betterosi==0.9.0
    osi/bin/python benchmarks/traces_elsewhere.py OSI_FOLDER CSV_FOLDER
"""

from __future__ import annotations

import argparse
import csv
import math
from pathlib import Path

import betterosi
import omega_prime

Poses = dict[tuple[int, str], tuple[float, float, float]]


def driven(path: Path) -> Poses:
    """Centres [m] and headings [rad] by time [ms] and actor."""
    with path.open() as rows:
        return {
            (round(float(row["time_s"]) * 1e3), row["actor"]): (
                float(row["x_m"]),
                float(row["y_m"]),
                float(row["heading_rad"]),
            )
            for row in csv.DictReader(rows)
        }


def told(path: Path) -> tuple[Poses, dict[int, str]]:
    """The same, as betterosi reads it, and the actors by their number."""
    poses: Poses = {}
    actors: dict[int, str] = {}
    for message in betterosi.read(str(path), return_ground_truth=True):
        time = message.timestamp.seconds * 1000 + round(message.timestamp.nanos / 1e6)
        for one in (*message.moving_object, *message.stationary_object):
            name = actors[one.id.value] = one.source_reference[0].identifier[0]
            poses[time, name] = (one.base.position.x, one.base.position.y, one.base.orientation.yaw)
    return poses, actors


def recorded(path: Path, actors: dict[int, str]) -> Poses:
    """Those that move, as omega-prime records them."""
    table = omega_prime.Recording.from_file(str(path), validate=True).df
    return {
        (round(row["total_nanos"] / 1e6), actors[row["idx"]]): (row["x"], row["y"], row["yaw"])
        for row in table.select("total_nanos", "idx", "x", "y", "yaw").iter_rows(named=True)
    }


def farthest(found: Poses, was: Poses) -> str:
    away = max(math.dist(found[key][:2], was[key][:2]) for key in found)
    turned = max(abs(math.remainder(found[key][2] - was[key][2], math.tau)) for key in found)
    return f"{100 * away:.6f} cm, {turned:.1e} rad at most, of {len(found)} poses"


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("osi", type=Path)
    parser.add_argument("csv", type=Path)
    asked = parser.parse_args()
    for path in sorted(asked.osi.glob("*.mcap")):
        was = driven(asked.csv / f"{path.stem.removesuffix('_gt')}.csv")
        poses, actors = told(path)
        assert poses.keys() == was.keys(), "the same actors at the same times"
        print(f"{path.stem}: betterosi {farthest(poses, was)}; omega-prime {farthest(recorded(path, actors), was)}")


if __name__ == "__main__":
    main()
