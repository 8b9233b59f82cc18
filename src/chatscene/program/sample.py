"""Step 5 of 9, first half: draw concrete values for a scene.

Every scene has a seed of its own, derived from the run's seed and the scene's id, so that order and parallelism do
not matter.
"""

from __future__ import annotations

import hashlib
from collections.abc import Sequence
from functools import lru_cache

import numpy as np

from chatscene.terms.scene import Scene, ScenicProgram
from chatscene.terms.snippet import ParameterRange

DECIMALS = 6  # values survive being written as text


def scene_seed(run_seed: int, scene_id: str) -> int:
    """The seed of one scene, below 2**32."""
    return int.from_bytes(hashlib.blake2b(f"{run_seed}/{scene_id}".encode(), digest_size=4).digest(), "big")


def scene_at(program: ScenicProgram, route: int, share: float, *, name: str) -> Scene:
    """The scene of a program that lies at one share of every declared range, to try the program with.

    Args:
        program: What is tried.
        route: Index of the route.
        share: Where in every range, in [0, 1].
        name: Of the trial; ends the scene's id.
    """
    return Scene(
        id=f"{program.scenario_id}/route-{route:02d}/{name}",
        scenario_id=program.scenario_id,
        route=route,
        block=-1,
        seed=0,
        values={p.name: round(p.low + share * (p.high - p.low), DECIMALS) for p in program.parameters},
    )


def drawn_scene(program: ScenicProgram, number: int, *, seed: int) -> Scene:
    """A scene of a program that nobody searches with, its values drawn from their ranges; on the first route.

    Args:
        program: What is driven.
        number: Which of its scenes, from 0.
        seed: What values are drawn by.
    """
    name = f"{program.scenario_id}/route-00/draw-{number:03d}"
    own = scene_seed(seed, name)
    values = draw(program.parameters, seed=own)
    return Scene(id=name, scenario_id=program.scenario_id, route=0, block=0, seed=own, values=values)


def draw(ranges: Sequence[ParameterRange], *, seed: int) -> dict[str, float]:
    """A value for each parameter, uniform in its range (released code: ``Range`` in each block).

    Args:
        ranges: What to draw from; each parameter has a stream of its own, so that adding one to a program does not
            change the others' values.
        seed: Of the scene.
    """
    values: dict[str, float] = {}
    for p in ranges:
        told = seed, _stream(p.name)
        # The words that numpy would take the two numbers apart into; to do it itself takes it a third of the time.
        words = told if seed >> 32 else np.array(told, np.uint32)
        share = float(np.random.default_rng(words).random())
        values[p.name] = p.clip(round(p.low + share * (p.high - p.low), DECIMALS))
    return values


@lru_cache(maxsize=1024)
def _stream(name: str) -> int:
    """The stream of a parameter, below 2**32."""
    return int.from_bytes(hashlib.blake2b(name.encode(), digest_size=4).digest(), "big")
