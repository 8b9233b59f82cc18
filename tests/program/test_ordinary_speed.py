"""Ordinary drives at the speed of the road."""

from __future__ import annotations

from typing import Any

import pytest

from chatscene.ego.policy import load_ego
from chatscene.maps.limits import MOTORWAY
from chatscene.maps.limits import TOWN as IN_TOWN
from chatscene.maps.network import resolve_map
from chatscene.program.ordinary import ordinary_program, ordinary_queries
from chatscene.program.sample import scene_at
from chatscene.settings import SimulationSettings
from chatscene.simulate.simulator import Simulator, load_simulator, simulate
from chatscene.terms.episode import Role
from chatscene.terms.scene import Rejected

STRAIGHT = ordinary_queries()[0]


@pytest.fixture(scope="module")
def town() -> Simulator:
    return load_simulator(resolve_map("town"), SimulationSettings())


def test_without_a_speed_a_program_says_nothing_of_one() -> None:
    for query in ordinary_queries():
        source = ordinary_program(query).source
        assert not any(word in source for word in ("wantedSpeed", "keepsLimits", "pace", "speedOn"))


def test_with_one_the_ego_keeps_the_limits_and_has_the_same_parameters() -> None:
    for query in ordinary_queries():
        told, untold = ordinary_program(query, 20.0), ordinary_program(query)
        assert told.wanted_speed == 20.0
        assert told.keeps_limits
        assert told.parameters == untold.parameters


@pytest.mark.parametrize("number", range(len(ordinary_queries())))
def test_everybody_who_drives_is_on_the_move_from_the_first(town: Simulator, number: int) -> None:
    program = ordinary_program(ordinary_queries()[number], MOTORWAY)
    scene = scene_at(program, 0, 0.5, name="0")
    episode: Any = simulate(town, program, scene, load_ego("rule-based"))
    assert not isinstance(episode, Rejected), episode
    assert episode.ego_track.speed[0] == pytest.approx(IN_TOWN, abs=1.0)
    driving = [track for track in episode.tracks if track.role is Role.BACKGROUND and track.actor != "waiting"]
    moving = [track for track in driving if not track.actor.startswith(("waiting", "blocker", "parked"))]
    assert all(track.speed[0] > 5.0 for track in moving)
