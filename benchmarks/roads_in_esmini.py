"""How far esmini's roads are from ours: the middle of each lane, its road, and the speed that the file allows there.

esmini's road manager is built from its sources (see `esmini_plays.py`; the target is esminiRMLib):

    python benchmarks/roads_in_esmini.py libesminiRMLib.so [MAP ...]
"""

from __future__ import annotations

import argparse
import ctypes
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import numpy as np

from chatscene.maps.limits import limits_of
from chatscene.maps.network import PACKAGED, load_network, resolve_map

EVERY = 5.0  # [m] along a lane
DOUBLES = ("x", "y", "z", "h", "p", "r", "h_relative")


class Pose(ctypes.Structure):
    """`RM_PositionData` of esminiRMLib.hpp."""

    _fields_ = (
        *((name, ctypes.c_double) for name in DOUBLES),
        *((name, ctypes.c_uint32) for name in ("road", "junction")),
        ("lane", ctypes.c_int),
        *((name, ctypes.c_double) for name in ("offset", "s")),
    )


def opened(library: Path, path: Path) -> Any:
    """Esmini's road manager with a map in it."""
    manager = ctypes.CDLL(str(library))
    manager.RM_GetSpeedLimit.restype = ctypes.c_double
    manager.RM_SetWorldXYHPosition.argtypes = [ctypes.c_int, *[ctypes.c_double] * 3]
    if manager.RM_Init(str(path).encode()):
        raise SystemExit(f"esmini does not read {path}")
    return manager


def compare(manager: Any, path: Path) -> str:
    """One line of the table: points, how many of them esmini puts elsewhere, distances, and equal limits."""
    network, handle, pose = load_network(path), manager.RM_CreatePosition(), Pose()
    limits = limits_of(network)
    points, offsets, elsewhere, allowed = 0, [], 0, 0
    for section, here in middles(network):
        heading = section.orientation.value(here) + np.pi / 2
        manager.RM_SetWorldXYHPosition(handle, float(here[0]), float(here[1]), heading)
        manager.RM_GetPositionData(handle, ctypes.byref(pose))
        points += 1
        if pose.road != section.road.id:  # roads of a junction lie upon each other
            continue
        if pose.lane != section.openDriveID:
            elsewhere += 1
            continue
        offsets.append(abs(pose.offset))
        allowed += abs(manager.RM_GetSpeedLimit(handle) - limits[pose.road].at(pose.s, pose.lane)) < 0.01
    roads = f"{manager.RM_GetNumberOfRoads()} of {len(network.allRoads)}"
    found = f"{points} | {len(offsets)} | {elsewhere} | {np.median(offsets):.3f} | {max(offsets):.3f}"
    return f"| `{path.stem}` | {roads} | {found} | {allowed} |"


def middles(network: Any) -> Iterator[tuple[Any, Any]]:
    """Each lane that our network has, and points in its middle."""
    for road in network.allRoads:
        for section in (section for lane in road.lanes for section in lane.sections):
            for at in np.arange(EVERY / 2, section.centerline.length, EVERY):
                here = section.centerline.pointAlongBy(float(at))
                if section.containsPoint(here):
                    yield section, here


def main() -> None:
    """Print a table."""
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("library", type=Path)
    parser.add_argument("maps", nargs="*", default=list(PACKAGED))
    asked = parser.parse_args()
    print("| map | roads | points | same lane | another lane | offset, median [m] | at most | same limit |")
    for name in asked.maps:
        path = resolve_map(name)
        print(compare(opened(asked.library, path), path))


if __name__ == "__main__":
    main()
