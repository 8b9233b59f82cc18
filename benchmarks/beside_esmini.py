"""How far our player of OpenSCENARIO is from esmini's: each file driven as it is written by both, origins compared.

esmini's library is built from its sources (see `esmini_plays.py`). It steps by a thousandth of a second, since
it takes speeds as steady within a step:

    python benchmarks/beside_esmini.py libesminiLib.so DIR... [--most 30] [--each]

A moment of a road user is *identical* if somewhere within 0.1 s of it, before or after, esmini has its origin within
0.05 m of where we have it. A file is, if all moments of all road users are that both have, until the first of both
drives ends. Of others, what is written in the file is counted, and where the first difference begins.
"""

from __future__ import annotations

import argparse
import json
import math
import multiprocessing
import re
import resource
import sys
from collections import Counter
from dataclasses import dataclass, replace
from pathlib import Path
from typing import Any

import numpy as np
from esmini_plays import State, loaded

from chatscene.imports.names import plain

NEAR, SOON = 0.05, 0.1  # [m], [s]
STEP, FINE = 0.001, 0.01  # [s] of esmini's steps, and between those that are looked at
EVERY = 0.1  # [s] of ours
LONGEST = 60.0  # [s]


def of_esmini(library: Path, path: Path, most: float, options: tuple[str, ...] = ()) -> dict[str, Any] | str:
    """Origins by road user: times, x, y, headings; or why there are none."""
    import ctypes

    esmini = loaded(library)
    for option in (b"disable_stdout", b"disable_log", *(one.encode() for one in options)):
        esmini.SE_SetOption(option)
    esmini.SE_SetOptionValue(b"traj_filter", b"0")
    if esmini.SE_Init(str(path).encode(), 1, 0, 0, 0) != 0:  # with controllers disabled: as the file says
        return "esmini does not take it"
    rows: dict[str, list[tuple[float, float, float, float, float]]] = {}
    while (now := esmini.SE_GetSimulationTime()) <= most + 1e-6:
        for index in range(esmini.SE_GetNumberOfObjects()):
            number, state = esmini.SE_GetId(index), State()
            esmini.SE_GetObjectState(number, ctypes.byref(state))
            name = esmini.SE_GetObjectName(number).decode(errors="replace")
            rows.setdefault(name, []).append((now, state.x, state.y, state.h, state.speed))
        over = False
        for _ in range(round(FINE / STEP)):
            over = over or esmini.SE_GetQuitFlag() == 1 or esmini.SE_StepDT(STEP) != 0
        if over:
            break
    return {name: np.array(told) for name, told in rows.items()}


def of_ours(path: Path, most: float) -> tuple[dict[str, Any], tuple[str, ...]]:
    """The same of our player, as the file is written; and what was noted of it."""
    from chatscene.imports.names import labels
    from chatscene.imports.openscenario import ScenarioFile
    from chatscene.imports.stranger_xml import read_xml
    from chatscene.imports.written_story import written_story
    from chatscene.program.sample import scene_at
    from chatscene.search.generators.foreign import foreign_program
    from chatscene.settings import SimulationSettings
    from chatscene.simulate.embedded.physics import make_simulator
    from chatscene.terms.episode import Role
    from chatscene.terms.scene import Rejected

    root = read_xml(path)
    group = root.find("ParameterDeclarations")
    declared = [one.attributes for one in group.inside] if group else []
    values = {one["name"]: one["value"] for one in declared if "$" not in one.get("value", "$")}
    read = ScenarioFile(path, root=root).said(told=values)  # no value is drawn from a range
    whole = read.as_written
    if whole is None:
        raise ValueError("it says nothing of what the ego does")
    program = foreign_program("theirs", written_story(whole, path.name), as_written=True)
    scene = replace(scene_at(program, 0, 0.5, name="scene"), seed=0)
    settings = SimulationSettings(max_steps=round(most / EVERY), dt=EVERY)
    drive = make_simulator(read.map_path, settings).open(
        program, scene, observation="safebench", pedals="safebench", through_collisions=True
    )
    if isinstance(drive, Rejected):
        raise ValueError(drive.reason)  # noqa: TRY004 - it is told with every other reason
    try:
        while drive.ending is None and not drive.rejection:
            drive.step((0.0, 0.0))
        if drive.rejection:
            raise ValueError(drive.rejection)
        episode = drive.episode(scene.id, "as written")
    finally:
        drive.close()
    others = whole.members[1:]
    adversary = next(iter([one for one in others if one.acts] or others), None)
    called = dict(zip(labels(one.name for one in whole.members), whole.members, strict=True))
    if adversary is not None:
        called[Role.ADVERSARY] = adversary
    found: dict[str, Any] = {}
    times = np.arange(len(episode.tracks[0].x)) * EVERY
    for track in episode.tracks:
        member = called[track.actor]
        x = track.x - member.ahead * np.cos(track.heading)
        y = track.y - member.ahead * np.sin(track.heading)
        found[member.name] = np.column_stack((times, x, y, track.heading, track.speed))
    return found, read.notes


@dataclass(frozen=True, slots=True)
class Beside:
    """How one road user of a file compares.

    Attributes:
        name: Whose.
        share: Of its moments, those that are identical.
        farthest: How far [m] the farthest is, beyond what 0.1 s explains.
        first: The first moment that is not identical [s].
        at_once: How far both are apart at most at the same time [m].
    """

    name: str
    share: float
    farthest: float
    first: float | None
    at_once: float


def beside(name: str, ours: Any, theirs: Any) -> Beside:
    """How one road user compares."""
    end = min(ours[-1, 0], theirs[-1, 0])
    # what is told of the beginning, we do in our first step; at the end nothing is known of the tenth after it
    own = ours[(ours[:, 0] > 0.0) & (ours[:, 0] <= end - SOON + 1e-9)]
    shifts = np.arange(-SOON, SOON + 1e-9, FINE)
    gaps = []
    for shift in (0.0, *shifts):
        at = np.clip(own[:, 0] + shift, theirs[0, 0], theirs[-1, 0])
        gaps.append(
            np.hypot(
                np.interp(at, theirs[:, 0], theirs[:, 1]) - own[:, 1],
                np.interp(at, theirs[:, 0], theirs[:, 2]) - own[:, 2],
            )
        )
    # between samples of theirs that are FINE apart somebody fast goes farther than NEAR: the nearest of the pieces
    least = np.min(gaps, axis=0)
    speed = np.abs(own[:, 4])
    least = np.maximum(least - speed * FINE / 2.0, 0.0)
    away = least > NEAR
    first = float(own[np.argmax(away), 0]) if away.any() else None
    return Beside(name, float(1.0 - away.mean()), float(least.max()), first, float(gaps[0].max()))


def compared(library: Path, path: Path, most: float, options: tuple[str, ...]) -> dict[str, Any]:
    """What became of one file."""
    with multiprocessing.get_context("spawn").Pool(1) as fresh:  # esmini keeps state in its process
        theirs = fresh.apply(of_esmini, (library, path, most, options))
    if isinstance(theirs, str):
        return {"file": str(path), "status": "not esmini's", "why": theirs}
    try:
        ours, notes = of_ours(path, most)
    except Exception as error:  # noqa: BLE001 - whatever it is, it is told
        return {"file": str(path), "status": "not ours", "why": f"{type(error).__name__}: {error}"[:300]}
    theirs = _called(ours, theirs)
    both = {name: track for name, track in ours.items() if name in theirs}
    if both and min(min(t[-1, 0], theirs[name][-1, 0]) for name, t in both.items()) < EVERY + SOON:
        return {"file": str(path), "status": "over at once", "why": "one of both drives has no second step"}
    found = [beside(name, track, theirs[name]) for name, track in both.items()]
    away = [one for one in found if one.first is not None]
    last = (max(float(t[-1, 0]) for t in ours.values()), max(float(t[-1, 0]) for t in theirs.values()))
    return {
        "file": str(path),
        "status": "identical" if found and not away else "differs" if found else "nobody in common",
        "ends": last,
        "each": [
            (one.name, round(one.share, 3), round(one.farthest, 3), one.first, round(one.at_once, 3)) for one in found
        ],
        "farthest": max((one.farthest for one in found), default=None),
        "first": min((one.first for one in away if one.first is not None), default=None),
        "written": _written(path),
        "notes": [note for note in notes if "left to the ego" not in note],
    }


def _called(ours: dict[str, Any], theirs: dict[str, Any]) -> dict[str, Any]:
    """Theirs by our names: our ego is who is left and nearest to it at first."""
    left = {name: track for name, track in theirs.items() if plain(name) not in ours or plain(name) == "ego"}
    named = {plain(name): track for name, track in theirs.items() if name not in left}
    if left:
        begin = ours["ego"][0, 1:3]
        named["ego"] = min(left.values(), key=lambda track: math.dist(track[0, 1:3], begin))
    return named


def _written(path: Path) -> list[str]:
    """The actions of a file by the names of their elements."""
    text = path.read_text(encoding="utf-8", errors="replace")
    return sorted(
        set(re.findall(r"<(\w+Action)\b", text))
        - {"PrivateAction", "GlobalAction", "LongitudinalAction", "LateralAction", "RoutingAction"}
    )


def main() -> None:
    """Print a line for each file, and how many are identical."""
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("library", type=Path)
    parser.add_argument("files", type=Path, nargs="+")
    parser.add_argument("--most", type=float, default=LONGEST, help="of a drive [s]")
    parser.add_argument("--each", action="store_true", help="a line for each road user, too")
    parser.add_argument("--option", action="append", default=[], help="of esmini, such as align_routepositions")
    parser.add_argument("--out", type=Path, help="where to keep a line of JSON for each file")
    asked = parser.parse_args()
    paths = [p for one in asked.files for p in (sorted(one.rglob("*.xosc")) if one.is_dir() else [one])]
    count = Counter[str]()
    kept = asked.out.open("a") if asked.out else None
    for path in paths:
        text = path.read_text(encoding="utf-8", errors="replace")
        if "<Storyboard" not in text or "ParameterValueDistribution" in text:
            continue
        row = compared(asked.library, path.resolve(), asked.most, tuple(asked.option))
        count[row["status"]] += 1
        far = f"{row['farthest']:.2f} m, from {row['first']} s" if row.get("first") is not None else row.get("why", "")
        print(f"{row['status']:>14}  {path.name}: {far}", flush=True)
        if asked.each:
            for one in row.get("each", ()):
                print(f"                {one}")
        if kept:
            kept.write(json.dumps(row) + "\n")
            kept.flush()
    spent = resource.getrusage(resource.RUSAGE_SELF).ru_utime + resource.getrusage(resource.RUSAGE_CHILDREN).ru_utime
    print(dict(count), f"{spent:.0f} s of processor time")


if __name__ == "__main__":
    sys.exit(main())
