"""Who loses control slides on and turns about itself; who falls off two wheels slides; both are seen on tracks."""

from __future__ import annotations

from functools import cache
from typing import Any

import numpy as np
import pytest

from benchmarks.differing import differences
from chatscene.build.build import Built, build
from chatscene.ego.policy import load_ego
from chatscene.maps.network import resolve_map
from chatscene.program.judge import judge
from chatscene.program.sample import draw
from chatscene.settings import SimulationSettings
from chatscene.simulate.simulator import Simulator, load_simulator, simulate
from chatscene.situations.form import from_plain
from chatscene.terms.episode import Episode
from chatscene.terms.scene import Scene
from chatscene.terms.situation import Situation


@cache
def simulator(map_name: str, by: str, physics: Any = "kinematic") -> Simulator:
    return load_simulator(resolve_map(map_name), SimulationSettings(simulator=by, physics=physics))


def drive(one: Built, by: str = "native", physics: str = "kinematic", seed: int = 1) -> Episode:
    values = draw(one.program.parameters, seed=seed)
    scene = Scene(id="slide/0", scenario_id="slide", route=0, block=0, seed=seed, values=values)
    episode = simulate(simulator(one.map, by, physics), one.program, scene, load_ego("idm"))
    assert isinstance(episode, Episode), episode
    return episode


def one_who(kind: str, where: str, *does: dict[str, Any], **more: Any) -> Situation:
    starts = {"where": where} | more.pop("starts", {})
    others = [{"id": "A", "kind": kind, "starts": starts, "does": list(does)}]
    return from_plain({"ego": {"speed": "60 km/h"}, "others": others, **more})


SPINS = {"act": "lose-control"}
FALLS = {"act": "fall"}
CASES = [
    one_who("car", "ahead", SPINS, starts={"distance": "30 m"}),
    one_who("car", "oncoming", SPINS | {"to": "left"}, around={"surface": "ice"}),
    one_who("truck", "ahead", {"act": "drift", "to": "right"}, SPINS | {"to": "left"}),
    one_who("motorcycle", "ahead", FALLS),
    one_who("bicycle", "roadside", {"act": "cross"}, FALLS, starts={"side": "right"}),
]


@pytest.mark.parametrize("said", CASES)
def test_it_is_seen_in_a_drive_that_both_simulators_give_to_the_bit(said: Situation) -> None:
    one = build(said)
    episode = drive(one)
    assert episode.stepped.by == "native"
    assert differences(episode, drive(one, "embedded")) == []
    route = simulator(one.map, "native").route(one.program, 0)
    shown = {found.path: found.shown for found in judge(said, episode, route)}
    last = len(said["A"].does) - 1
    assert shown[f"others.A.does.{last}.act"]


@pytest.mark.parametrize("physics", ["kinematic", "lagged"])
def test_who_spins_goes_on_where_it_went_and_stands_turned_away(physics: str) -> None:
    episode = drive(build(CASES[0]), "embedded", physics)
    track = episode.tracks[1]
    turned = abs(track.heading - track.heading[0])
    assert turned.max() > 1.0
    assert track.speed[-1] == pytest.approx(0.0, abs=0.1)
    slides = np.flatnonzero(turned > 0.6)[:-8]
    ways = np.unwrap(np.arctan2(np.gradient(track.y), np.gradient(track.x)))[slides]
    assert np.ptp(ways[track.speed[slides] > 1.0]) < 0.02


def test_who_was_not_said_to_spin_is_not_seen_to() -> None:
    brakes = one_who("car", "ahead", {"act": "stop"}, starts={"distance": "30 m"})
    one = build(brakes)
    episode, route = drive(one), simulator(one.map, "native").route(one.program, 0)
    shown = {found.path: found.shown for found in judge(CASES[0], episode, route)}
    assert shown["others.A.does.0.act"] is False


def test_a_spinning_body_is_struck_as_fast_as_it_goes() -> None:
    episode = drive(build(CASES[0]))
    crash = next(event for event in episode.events if event.kind.value == "collision")
    ego, other = episode.tracks[0], episode.tracks[1]
    row = crash.step - 1
    step = np.array(
        [track.x[row + 1] - track.x[row] - 1j * (track.y[row] - track.y[row + 1]) for track in (ego, other)]
    )
    assert crash.impact_speed == pytest.approx(abs(step[0] - step[1]) / episode.dt, abs=0.8)
