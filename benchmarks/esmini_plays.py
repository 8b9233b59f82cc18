"""How far esmini is from what was driven: exported OpenSCENARIO in its library, against exported tracks.

esmini is no package of Python; its library is built from its sources (3.6.0: `cmake` with USE_OSG, USE_OSI, USE_SUMO,
USE_GTEST, USE_IMPLOT and DOWNLOAD_EXTERNALS off, then the target esminiLib), or is part of its releases:

    python benchmarks/esmini_plays.py libesminiLib.so XOSC_FOLDER CSV_FOLDER --near 0

By itself esmini leaves out vertices that are less than 0.1 m apart (its option `traj_filter`).
"""

from __future__ import annotations

import argparse
import ctypes
import math
import multiprocessing
from pathlib import Path
from typing import Any

import numpy as np
from played_elsewhere import driven

_POSE = ("x", "y", "z", "h", "p", "r")
_PLACE = (("t", ctypes.c_double), ("lane", ctypes.c_int), ("lane_offset", ctypes.c_double), ("s", ctypes.c_double))
_BODY = ("speed", "centre_x", "centre_y", "centre_z", "width", "length", "height")


class State(ctypes.Structure):
    """`SE_ScenarioObjectState` of esminiLib.hpp."""

    _fields_ = (
        *((name, ctypes.c_int) for name in ("id", "model", "control")),
        ("timestamp", ctypes.c_double),
        *((name, ctypes.c_double) for name in _POSE),
        *((name, ctypes.c_uint32) for name in ("road", "junction")),
        *_PLACE,
        *((name, ctypes.c_double) for name in _BODY),
        *((name, ctypes.c_int) for name in ("kind", "category")),
        *((name, ctypes.c_double) for name in ("wheel_angle", "wheel_turned")),
        ("visible", ctypes.c_int),
    )


def loaded(library: Path) -> Any:
    """The library, with the types of what is called."""
    esmini = ctypes.CDLL(str(library.resolve()))
    esmini.SE_GetSimulationTime.restype = ctypes.c_double
    esmini.SE_GetObjectName.restype = ctypes.c_char_p
    esmini.SE_StepDT.argtypes = [ctypes.c_double]
    return esmini


def farthest(library: Path, path: Path, tracks: dict[str, Any], step: float, near: float) -> str:
    """How far centres [cm] and headings [rad] are from the track, in words."""
    esmini = loaded(library)
    esmini.SE_SetOption(b"disable_stdout")
    esmini.SE_SetOption(b"disable_log")
    esmini.SE_SetOptionValue(b"traj_filter", str(near).encode())
    assert esmini.SE_Init(str(path).encode(), 0, 0, 0, 0) == 0, "esmini takes the scenario"
    turned = 0.0
    distances: list[float] = []
    compared, last = 0, max(float(track[-1, 0]) for track in tracks.values())
    names: set[str] = set()
    end = 0.0
    while (now := esmini.SE_GetSimulationTime()) <= last + 1e-6:
        end = now
        for index in range(esmini.SE_GetNumberOfObjects()):
            number, state = esmini.SE_GetId(index), State()
            esmini.SE_GetObjectState(number, ctypes.byref(state))
            name = esmini.SE_GetObjectName(number).decode()
            names.add(name)
            track = tracks[name]
            assert abs(state.length - track[0, 4]) + abs(state.width - track[0, 5]) < 1e-5, "the same size"
            was_x, was_y, was_heading = (np.interp(now, track[:, 0], track[:, i]) for i in (1, 2, 3))
            x = state.x + state.centre_x * math.cos(state.h)
            y = state.y + state.centre_x * math.sin(state.h)
            distances.append(100 * math.dist((x, y), (was_x, was_y)))
            turned = max(turned, abs(math.remainder(state.h - was_heading, math.tau)))
            compared += 1
        if esmini.SE_GetQuitFlag() == 1 or esmini.SE_StepDT(step) != 0:
            break
    assert names == set(tracks), "the same actors"
    median, most = np.median(distances), max(distances)
    told = f"{median:.3f} cm in the median, {most:.2f} cm and {turned:.3f} rad at most, of {compared} poses"
    return f"{told}, until {end:.3f} of {last:.3f} s"


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("library", type=Path)
    parser.add_argument("xosc", type=Path)
    parser.add_argument("csv", type=Path)
    parser.add_argument("--step", type=float, default=0.1, help="of the player [s]")
    parser.add_argument("--near", type=float, default=0.1, help="vertices are left out that are nearer than this [m]")
    asked = parser.parse_args()
    paths = sorted(asked.xosc.resolve().glob("*.xosc"))
    work = [(asked.library, path, driven(asked.csv / f"{path.stem}.csv"), asked.step, asked.near) for path in paths]
    with multiprocessing.Pool(1, maxtasksperchild=1) as fresh:  # esmini keeps state in its process
        for path, found in zip(paths, fresh.starmap(farthest, work, chunksize=1), strict=True):
            print(f"{path.stem}: {found}")


if __name__ == "__main__":
    main()
