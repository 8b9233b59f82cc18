"""The packaged spawn positions, measured where they put the adversary: no two do the same."""

from __future__ import annotations

from dataclasses import replace
from functools import cache
from itertools import combinations
from typing import Any

import numpy as np
import pytest
from numpy.typing import NDArray

from chatscene.ego.policy import load_ego
from chatscene.library.compatibility import incompatibility
from chatscene.library.load import load_library
from chatscene.maps.network import resolve_map
from chatscene.program.assemble import assemble
from chatscene.program.meaning import check_meaning
from chatscene.settings import SimulationSettings
from chatscene.simulate.simulator import load_simulator, simulate
from chatscene.terms.actors import AdversaryKind
from chatscene.terms.episode import Episode
from chatscene.terms.route import Route
from chatscene.terms.scenario import Component, Scenario, Slots, SubDescriptions
from chatscene.terms.scene import Scene
from chatscene.terms.snippet import Snippet

LIBRARY = load_library()
SPAWNS = LIBRARY.of(Component.SPAWN)
GEOMETRIES = LIBRARY.without_sites().of(Component.GEOMETRY)
SIMULATOR = load_simulator(resolve_map("town"), SimulationSettings(max_steps=1))
EGO = load_ego("rule-based")
SHARES = (0.05, 0.5, 0.95)  # of each range
APART = 0.3  # [m] or [rad], by which two starts are seen to differ

NOBODY = replace(
    LIBRARY.of(Component.BEHAVIOR)[0],
    id="behavior/stands",
    source='advTurn = ("straight", "left-turn")\nadvFacing = 3.14\nadvAlong = 0\nadvStill = 0\nadvAside = 0\n\n'
    "behavior AdvBehavior():\n    do Halt()\n",
    requires=(),
    provides=("AdvBehavior", "advAlong", "advFacing", "advTurn"),
    parameters=(),
    adversaries=tuple(AdversaryKind),
    slots=Slots(),
)


def _geometry(spawn: Snippet) -> Snippet:
    """The first geometry that a spawn fits; the same for two spawns that ask for the same."""
    behavior = replace(
        NOBODY,
        requires=tuple(sorted({"advTrajectory", "advLane", "advKerb"} & set(spawn.provides))),
        provides=(*NOBODY.provides, *sorted({"advStill", "advAside"} & set(spawn.requires))),
    )
    return next(g for g in GEOMETRIES if incompatibility(behavior, g, spawn) is None)


@cache
def _starts(spawn_id: str) -> tuple[tuple[Episode, Route], ...]:
    """The first moment of three drives: all parameters near their lower end, in the middle, near their upper end."""
    spawn = LIBRARY.get(spawn_id)
    scenario = Scenario(
        id=spawn.id, text="", base=None, parts=SubDescriptions(behavior="", geometry="", spawn=""), slots=Slots()
    )
    nobody = replace(NOBODY, provides=(*NOBODY.provides, "advStill", "advAside"))
    program = assemble(scenario, (nobody, _geometry(spawn), spawn), spawn.adversaries[0])
    found: list[tuple[Episode, Route]] = []
    for i, share in enumerate(SHARES):
        values = {p.name: p.low + share * (p.high - p.low) for p in program.parameters}
        scene = Scene(id=f"{i}", scenario_id=spawn.id, route=0, block=0, seed=i, values=values)
        outcome = simulate(SIMULATOR, program, scene, EGO, through_collisions=True)
        assert isinstance(outcome, Episode), outcome
        found.append((outcome, SIMULATOR.route(program, 0)))
    return tuple(found)


@cache
def _poses(spawn_id: str) -> list[tuple[tuple[str, ...], NDArray[Any]]]:
    """Of each of the three drives, the kinds of all but the ego and their (N, 3) poses."""
    return [
        (
            tuple(track.kind for track in episode.tracks[1:]),
            np.array([(track.x[0], track.y[0], track.heading[0]) for track in episode.tracks[1:]]),
        )
        for episode, _ in _starts(spawn_id)
    ]


def _alike(one: Snippet, other: Snippet) -> bool:
    for (kinds, poses), (others, their) in zip(_poses(one.id), _poses(other.id), strict=True):
        if kinds != others or float(np.abs(poses - their).max()) > APART:
            return False
    return True


def test_no_two_spawns_put_everybody_in_the_same_places() -> None:
    same = [
        (one.id, other.id)
        for one, other in combinations(SPAWNS, 2)
        if set(one.adversaries) & set(other.adversaries) and one.requires == other.requires and _alike(one, other)
    ]
    assert not same


@pytest.mark.parametrize("spawn", SPAWNS, ids=lambda s: s.id)
def test_a_spawn_puts_the_adversary_where_its_facts_say(spawn: Snippet) -> None:
    seen = replace(spawn.slots, occluder=None, leader=None)  # what hides and who leads is seen later
    for episode, route in _starts(spawn.id):
        assert check_meaning(seen, episode, route) == ()


@pytest.mark.parametrize("spawn", [s for s in SPAWNS if s.slots.group], ids=lambda s: s.id)
def test_in_a_group_nobody_stands_in_another(spawn: Snippet) -> None:
    for episode, _ in _starts(spawn.id):
        places = np.array([(track.x[0], track.y[0]) for track in episode.adversaries])
        assert 2 <= len(places) <= 4
        apart = np.hypot(*(places[:, None] - places[None, :]).transpose(2, 0, 1))
        assert apart[~np.eye(len(places), dtype=bool)].min() > 0.9
