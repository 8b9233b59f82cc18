"""What a judged drive costs: processor time each, and a digest of everything that came of all.

    python benchmarks/judged_drives.py [--ego idm] [--ego sac] [--drives 50]

Five encounters, as programs of snippets and as situations, each on one route of the town: drawn, placed, driven,
judged, crashes driven again. A program's figure is that of the quickest ten of its drives, so that other work on the
machine counts little. Runs on older commits, too (with this folder and `src` of those first in PYTHONPATH), where
situations are not built, so that two commits can be compared in turn.
"""

from __future__ import annotations

import dataclasses
import hashlib
import statistics
import time
from collections.abc import Iterator
from enum import Enum
from typing import Any

import click
import numpy as np

from chatscene.ego.policy import load_ego
from chatscene.library.load import library_with
from chatscene.maps.network import resolve_map
from chatscene.measure.drive import drive
from chatscene.program.assemble import assemble
from chatscene.program.sample import draw, scene_seed
from chatscene.settings import SimulationSettings
from chatscene.simulate.simulator import load_simulator
from chatscene.terms.actors import AdversaryKind
from chatscene.terms.acts import Action
from chatscene.terms.scenario import Scenario, Side, Slots, SubDescriptions
from chatscene.terms.scene import Scene, ScenicProgram

try:
    from chatscene.build.build import build
    from chatscene.situations.form import from_plain
except ImportError:  # a commit that knows no situations
    build = from_plain = None

try:
    from chatscene.measure.drive import drive_all
except ImportError:  # a commit that judges one after another

    def drive_all(program: Any, said: Any, scenes: Any, *, simulator: Any, ego: Any) -> Any:
        return [drive(program, said, one, simulator=simulator, ego=ego) for one in scenes]


PEDESTRIAN, BICYCLE, CAR = AdversaryKind.PEDESTRIAN, AdversaryKind.BICYCLE, AdversaryKind.CAR
SNIPPETS: list[tuple[str, str, str, AdversaryKind, Side | None, tuple[Action, ...]]] = [
    ("cross", "straight-road", "roadside-right", PEDESTRIAN, Side.RIGHT, (Action.CROSS,)),
    ("cross-and-stop", "straight-road", "roadside-left", BICYCLE, Side.LEFT, (Action.CROSS, Action.STOP)),
    ("lead-hard-stop", "straight-road", "ahead-in-lane", CAR, None, (Action.STOP,)),
    ("run-light", "straight-signalised", "crossing-from-left", CAR, Side.LEFT, (Action.RUN_LIGHT,)),
    ("junction-turn-left", "straight-four-way", "oncoming-at-junction", CAR, None, (Action.TURN_LEFT,)),
]
SITUATIONS: list[tuple[str, dict[str, Any], list[dict[str, Any]], dict[str, str]]] = [
    ("pedestrian", {"where": "roadside", "side": "right"}, [{"act": "cross"}], {}),
    ("bicycle", {"where": "roadside", "side": "left"}, [{"act": "enter"}, {"act": "stop"}], {}),
    ("car", {"where": "ahead", "distance": "15 m"}, [{"act": "brake", "acceleration": "4 m/s²"}], {}),
    (
        *("car", {"where": "arm", "side": "left"}, [{"act": "go-straight", "breaks": "red-light"}]),
        {"kind": "four-way", "control": "signal"},
    ),
    (
        *("car", {"where": "oncoming"}, [{"act": "turn-left", "breaks": "right-of-way"}]),
        {"kind": "four-way", "control": "signal", "ego_light": "green"},
    ),
]


def programs() -> Iterator[tuple[ScenicProgram, Any]]:
    """Each program, and what was said."""
    library = library_with()
    for number, (behavior, geometry, spawn, kind, side, acts) in enumerate(SNIPPETS):
        ids = f"behavior/{behavior}", f"geometry/{geometry}", f"spawn/{spawn}"
        parts = SubDescriptions(behavior=ids[0], geometry=ids[1], spawn=ids[2])
        slots = Slots(adversary=kind, side=side, actions=acts)
        scenario = Scenario(id=f"snippets-{number}", text="judged", base=None, parts=parts, slots=slots)
        yield assemble(scenario, tuple(map(library.get, ids)), kind), slots
    for number, (kind, starts, does, road) in enumerate(SITUATIONS if build else ()):
        other = {"id": "A", "kind": kind, "starts": starts, "does": does}
        situation = from_plain({"others": [other]} | ({"road": road} if road else {}))
        yield build(situation, name=f"situation-{number}").program, situation


def scene(program: ScenicProgram, name: str) -> Scene:
    """A scene on the first route, drawn by its name."""
    name = f"{program.scenario_id}/{name}"
    seed = scene_seed(0, name)
    values = draw(program.parameters, seed=seed)
    return Scene(id=name, scenario_id=program.scenario_id, route=0, block=0, seed=seed, values=values)


def take_in(digest: Any, found: Any) -> None:
    """Add everything that came of a drive to a digest, bit for bit."""
    if isinstance(found, np.ndarray):
        digest.update(found.tobytes())
    elif dataclasses.is_dataclass(found) and not isinstance(found, type):
        for field in dataclasses.fields(found):
            take_in(digest, getattr(found, field.name))
    elif isinstance(found, dict):
        take_in(digest, list(found.items()))
    elif isinstance(found, list | tuple):
        for part in found:
            take_in(digest, part)
    else:
        digest.update((str(found) if isinstance(found, Enum) else repr(found)).encode() + b";")


@click.command()
@click.option("--ego", "egos", multiple=True, default=("idm", "sac"))
@click.option("--drives", default=50)
def main(egos: tuple[str, ...], drives: int) -> None:
    """Print milliseconds of processor time for each judged drive, and the digest of all."""
    simulator = load_simulator(resolve_map("town"), SimulationSettings(simulator="native"))
    for name in egos:
        ego, digest, costs = load_ego(name), hashlib.blake2b(digest_size=8), dict[str, float]()
        for program, said in programs():
            for number in range(3):
                drive_all(program, said, [scene(program, f"before-{number}")], simulator=simulator, ego=ego)
            for block in range(drives // 10):
                scenes = [scene(program, str(10 * block + number)) for number in range(10)]
                began = time.process_time()
                ran = drive_all(program, said, scenes, simulator=simulator, ego=ego)
                spent = 100.0 * (time.process_time() - began)
                costs[program.scenario_id] = min(spent, costs.get(program.scenario_id, spent))
                take_in(digest, ran)
        each = ", ".join(f"{program} {cost:.2f}" for program, cost in costs.items())
        print(f"{name}: {statistics.mean(costs.values()):.2f} ms ({each}); digest {digest.hexdigest()}", flush=True)


if __name__ == "__main__":
    main()
