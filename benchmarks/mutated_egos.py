"""How many faults of an ego are found by scenes as tests, and how often a sound ego is blamed.

Some hundred scenes of twelve sentences in several voices that `idm` survives; twenty-one egos that are `idm` with one
fault; `idm` itself again and again, in another order each time. Writes one JSON object to standard output.

    python benchmarks/mutated_egos.py --scenes 10 --reruns 10 --seed 0
"""

from __future__ import annotations

import argparse
import hashlib
import json
import random
import time
from collections import deque
from collections.abc import Callable
from typing import Any

import numpy as np

from chatscene.ego.intelligent_driver import IntelligentDriver
from chatscene.ego.observation import NEAREST, OWN, PER_ACTOR, Observation
from chatscene.ego.policy import load_ego
from chatscene.testing.scenes import Asked, Found, find, judge
from chatscene.testing.solvable import Solvable

SENTENCES = (
    "a child runs out behind a van",
    "The car in front of us brakes hard.",
    "a motorbike cuts us off from the right",
    "an oncoming car turns left across our path at a traffic light",
    "a cyclist cuts across from the left while we turn right",
    "A pedestrian steps out from behind a bus stop on the right and freezes in front of us.",
    "Vehicle 1 was going straight when a pedestrian crossed from the left.",
    "The vehicle in the adjacent lane on the left cuts in in front of the subject vehicle.",
    "On a motorway, the car ahead of us brakes hard.",
    "A cyclist rides out from the left and stops in front of us.",
    "A car runs the red light from the left.",
    "POV: you drive along and the taxi beside you just swerves into your lane",
)
MARGIN = 5  # scenes more than are kept, since some are survived by others than idm
ALONG, LEFT, X, Y, VX, VY, WALKS, HALF_WIDTH = 1, 2, 3, 4, 5, 6, 10, 9


class Faulty(IntelligentDriver):
    """`idm` that sees or acts with a fault."""

    def __init__(self, sees: Callable[[Rows, int], Rows] | None, acts: Callable[[float, int], float] | None) -> None:
        self._sees, self._acts = sees, acts
        self.reset()

    def reset(self) -> None:
        """Begin a drive."""
        self._step = 0

    def act(self, observation: Observation) -> tuple[float, float]:
        """As `idm`, with the fault."""
        seen = observation.copy()
        if self._sees is not None:
            rows = self._sees(seen[OWN:].reshape(NEAREST, PER_ACTOR), self._step)
            seen[OWN:] = rows.reshape(-1)
        acceleration, steering = super().act(seen)
        if self._acts is not None:
            acceleration = self._acts(acceleration, self._step)
        self._step += 1
        return acceleration, steering


Rows = np.ndarray[Any, np.dtype[np.float64]]


def _without(hidden: Callable[[Rows], Any]) -> Callable[[Rows, int], Rows]:
    """Rows of those who are not hidden."""
    return lambda rows, _: np.where(np.asarray(hidden(rows))[:, None], 0.0, rows)


def _late(seconds: float) -> Callable[[Rows, int], Rows]:
    """Sees everybody as they were."""
    past: deque[Rows] = deque(maxlen=round(seconds / 0.1) + 1)

    def sees(rows: Rows, step: int) -> Rows:
        if step == 0:
            past.clear()
        past.append(rows.copy())
        return past[0]

    return sees


def _changed(column: int, to: Callable[[Any], Any]) -> Callable[[Rows, int], Rows]:
    def sees(rows: Rows, _: int) -> Rows:
        rows = rows.copy()
        rows[:, column] = to(rows[:, column])
        return rows

    return sees


def _brakes_late(seconds: float) -> Callable[[float, int], float]:
    """Coasts for a while wherever it should brake hard."""
    since = [0]

    def acts(wish: float, step: int) -> float:
        since[0] = 0 if step == 0 or wish > -0.25 else since[0] + 1
        return 0.0 if 0 < since[0] <= round(seconds / 0.1) else wish

    return acts


def _lets_go(seconds: float) -> Callable[[float, int], float]:
    since = [0]

    def acts(wish: float, step: int) -> float:
        since[0] = 0 if step == 0 or wish > -0.25 else since[0] + 1
        return 0.2 if since[0] > round(seconds / 0.1) else wish

    return acts


MUTANTS: dict[str, Callable[[], IntelligentDriver]] = {
    "brakes hard 0.5 s late": lambda: Faulty(None, _brakes_late(0.5)),
    "brakes hard 1 s late": lambda: Faulty(None, _brakes_late(1.0)),
    "sees 0.5 s late": lambda: Faulty(_late(0.5), None),
    "sees 1 s late": lambda: Faulty(_late(1.0), None),
    "half brake": lambda: Faulty(None, lambda wish, _: max(wish, -0.5)),
    "quarter brake": lambda: Faulty(None, lambda wish, _: max(wish, -0.25)),
    "lets go of the brake after 0.5 s": lambda: Faulty(None, _lets_go(0.5)),
    "blind to the left": lambda: Faulty(_without(lambda rows: rows[:, LEFT] > 1.5), None),
    "blind to the right": lambda: Faulty(_without(lambda rows: rows[:, LEFT] < -1.5), None),
    "blind to walkers": lambda: Faulty(_without(lambda rows: rows[:, WALKS] > 0), None),
    "blind to two-wheelers": lambda: Faulty(
        _without(lambda rows: (rows[:, WALKS] == 0) & (rows[:, HALF_WIDTH] < 0.6)), None
    ),
    "blind to cars": lambda: Faulty(_without(lambda rows: rows[:, HALF_WIDTH] >= 0.6), None),
    "sees 15 m far": lambda: Faulty(_without(lambda rows: np.hypot(rows[:, X], rows[:, Y]) > 15), None),
    "sees 8 m far": lambda: Faulty(_without(lambda rows: np.hypot(rows[:, X], rows[:, Y]) > 8), None),
    "blind within 10 m": lambda: Faulty(_without(lambda rows: np.hypot(rows[:, X], rows[:, Y]) < 10), None),
    "takes everybody for crossing nobody": lambda: Faulty(_changed(VY, lambda v: 0.0 * v), None),
    "takes everybody for as fast as itself": lambda: Faulty(_changed(VX, lambda v: np.maximum(v, 7.0)), None),
    "takes whoever comes for whoever goes": lambda: Faulty(_changed(VY, lambda v: -v), None),
    "loses everybody every other second": lambda: Faulty(
        lambda rows, step: rows * 0.0 if step // 10 % 2 else rows, None
    ),
    "stands": lambda: Faulty(None, lambda _wish, _: -1.0),
    "brakes for whoever is within 20 m": lambda: Faulty(
        _changed(LEFT, lambda left: np.where(np.abs(left) < 20, 0.0, left)), None
    ),
}


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--scenes", type=int, default=10, help="of each sentence")
    parser.add_argument("--reruns", type=int, default=10, help="of every scene with idm itself")
    parser.add_argument("--seed", type=int, default=0)
    asked = parser.parse_args()
    began = time.process_time()
    kept: list[tuple[Found, Solvable]] = []
    sought: dict[str, dict[str, Any]] = {}
    for text in SENTENCES:
        found = find(Asked(of=text, scenes=asked.scenes + MARGIN, seed=asked.seed))
        own = [one for one in found.scenes if one.survivor == "idm"][: asked.scenes]
        kept += [(found, one) for one in own]
        twins = [one.twin.told for one in own]
        told = {twin: twins.count(twin) for twin in sorted(set(twins))}
        sought[text] = {"kept": len(own), "twins": told, "left out": found.unfit}
    values = json.dumps([(one.scene.id, dict(one.scene.values), one.twin.told) for _, one in kept])
    report: dict[str, Any] = {
        "sentences": sought,
        "scenes": len(kept),
        "digest": hashlib.sha256(values.encode()).hexdigest()[:16],
        "seconds to find": round(time.process_time() - began, 1),
    }
    report["mutants"] = {name: _caught(make, kept) for name, make in MUTANTS.items()}
    report["caught"] = sum(one["scenes"] > 0 for one in report["mutants"].values())
    report["of"] = len(MUTANTS)
    report["planner"] = _caught(lambda: load_ego("planner"), kept)
    began, alarms, drives = time.process_time(), 0, 0
    for number in range(asked.reruns):
        order = random.Random(f"{asked.seed}/{number}").sample(kept, len(kept))
        # Half by the engine's own idm, half by the same in Python.
        ego = load_ego("idm") if number % 2 else Faulty(None, None)
        alarms += sum(bool(judge(found, one, ego).failures) for found, one in order)
        drives += len(order)
    report["idm itself"] = {
        "false alarms": alarms,
        "reruns": drives,
        "seconds": round(time.process_time() - began, 1),
    }
    print(json.dumps(report, indent=1))


def _caught(make: Callable[[], Any], kept: list[tuple[Found, Solvable]]) -> dict[str, Any]:
    """By how many scenes an ego is caught, in the scene or in the twin, and of how many sentences."""
    failed = [(found.text, judge(found, one, make())) for found, one in kept]
    caught = [(text, driven) for text, driven in failed if driven.failures]
    return {
        "scenes": len(caught),
        "in the scene": sum(driven.episode.collision is not None for _, driven in caught),
        "in the twin": sum(any("twin" in said for said in driven.failures) for _, driven in caught),
        "sentences": len({text for text, _ in caught}),
    }


if __name__ == "__main__":
    main()
