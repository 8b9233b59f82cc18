"""A number that was said of the ego holds until the deed begins for which it was said, whoever drives the ego."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import numpy as np
import pytest
from test_building import drive, simulator
from test_towards import car, deed, others, track

from chatscene.build.build import build
from chatscene.program.sample import draw
from chatscene.simulate.simulator import simulate
from chatscene.terms.episode import Episode
from chatscene.terms.scene import Scene
from chatscene.terms.situation import Situation

SPEED, GAP = 22.2, 31.1  # [m/s], [m]
HELD = "the ego is held at 80 km/h behind B until B does its"


def follows(act: str = "brake", **kept: str) -> Situation:
    """An ego at 80 km/h behind a car that does something for which another stands ahead."""
    ego = {"speed": "80 km/h", "does": [deed("follow") | {"whom": "B"} | kept]}
    when = {"when": {"ego_within": "70 m", "of": "A"}} if act == "cut-out" else {}
    stands = car("A", "ahead", deed("stand")) | {"hidden_by": "B"}
    return others(*([stands] if when else []), car("B", "ahead", deed(act) | when), ego=ego)


@dataclass
class Brakes:
    """An ego that brakes from the first."""

    observation: str = "safebench"

    def act(self, observation: Any) -> tuple[float, float]:
        """The whole brake."""
        return -1.0, 0.0


def begins(episode: Episode) -> int:
    """The step at which B loses speed, or leaves its lane."""
    one = track(episode, "B")
    acts = (one.speed < one.speed[0] - 1.5) | (np.abs(one.heading - one.heading[0]) > 0.04)
    return int(np.flatnonzero(acts)[0])


@pytest.mark.parametrize("ego", ["planner", "idm"])
@pytest.mark.parametrize("act", ["brake", "cut-out"])
def test_speed_and_gap_are_as_said_when_who_is_ahead_acts(act: str, ego: str) -> None:
    made = build(follows(act, time="1.4 s"))
    assert any(one.startswith(HELD) for one in made.assumed)
    episode = drive(made, ego=ego)
    assert isinstance(episode, Episode)
    at, one, own = begins(episode), track(episode, "B"), episode.ego_track
    gap = np.hypot(one.x[at] - own.x[at], one.y[at] - own.y[at]) - 0.5 * (one.length + own.length)
    assert own.speed[: at + 1].min() > 0.96 * SPEED
    assert 0.9 * GAP < gap < 1.1 * GAP


def test_an_ego_is_let_go_when_that_begins() -> None:
    made = build(follows("brake", time="1.4 s"))
    values = draw(made.program.parameters, seed=1)
    name = made.program.scenario_id
    scene = Scene(id=f"{name}/route-00/scene-1", scenario_id=name, route=0, block=0, seed=1, values=values)
    episode = simulate(simulator(made.map, "native"), made.program, scene, Brakes())
    assert isinstance(episode, Episode)
    at, own = begins(episode), episode.ego_track
    assert own.speed[at - 1] > 0.96 * SPEED
    after = min(at + round(2.0 / episode.dt), len(own.speed) - 1)
    assert own.speed[after] < own.speed[at] - 6.0  # a careful driver in its place brakes then, too, and not before


@pytest.mark.parametrize(
    "said",
    [
        follows("go-along", time="1.4 s"),  # who is ahead does nothing
        others(car("B", "ahead", deed("brake")), ego={"speed": "80 km/h"}),  # no gap was said
        others(car("B", "ahead", deed("brake")), ego={"does": [deed("follow") | {"time": "1.4 s"}]}),  # and no speed
    ],
)
def test_an_ego_is_held_only_for_a_speed_and_who_is_followed_until_it_acts(said: Situation) -> None:
    assert not any("is held at" in one for one in build(said).assumed)


def test_an_ego_makes_room_for_who_would_not_fit_into_the_gap() -> None:
    def said(gap: str) -> Situation:
        comes = car("A", "behind-beside", deed("overtake"), deed("cut-in"), side="left")
        ego = {"speed": "60 km/h", "does": [deed("follow") | {"whom": "B", "distance": gap}]}
        return others(comes, car("B", "ahead", deed("go-along")) | {"role": "supporting"}, ego=ego)

    held = [any("is held at" in one for one in build(said(gap)).assumed) for gap in ("6 m", "30 m")]
    assert held == [False, True]


def test_an_ego_that_is_a_little_faster_than_who_is_ahead_is_held_too() -> None:
    def said(speed: str) -> Situation:
        return others(car("B", "ahead", deed("brake"), speed=speed, distance="35 m"), ego={"speed": "80 km/h"})

    held = [any(one.startswith(HELD) for one in build(said(speed)).assumed) for speed in ("70 km/h", "40 km/h")]
    assert held == [True, False]
    episode = drive(build(said("70 km/h")), ego="planner")
    assert isinstance(episode, Episode)
    assert episode.ego_track.speed[: begins(episode)].min() > 0.96 * SPEED


@pytest.mark.parametrize("ego", ["planner", "idm"])
def test_an_ego_closes_in_at_its_speed_on_who_is_slower_until_it_is_as_near_as_said(ego: str) -> None:
    slow = car("B", "ahead", deed("brake") | {"when": {"ego_within": "1.8 s"}}, speed="60 km/h")
    made = build(others(slow, ego={"speed": "80 km/h"}))
    episode = drive(made, ego=ego)
    assert isinstance(episode, Episode)
    at, one, own = begins(episode), track(episode, "B"), episode.ego_track
    before = at - 4  # by which it has lost 1.5 m/s
    gap = np.hypot(one.x[before] - own.x[before], one.y[before] - own.y[before]) - 0.5 * (one.length + own.length)
    assert own.speed[:before].min() > 0.96 * SPEED
    assert gap == pytest.approx(1.8 * (80 - 60) / 3.6, abs=2.5)


def test_who_waits_until_the_ego_is_near_is_never_put_nearer_than_that() -> None:
    slow = car("B", "ahead", deed("brake") | {"when": {"ego_within": "1.8 s"}}, speed="60 km/h")
    assert any(name.endswith("_Y") for name in build(others(slow, ego={"speed": "80 km/h"})).bound)
