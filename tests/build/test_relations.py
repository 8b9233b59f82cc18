"""How the speeds of those on the road stand to each other, as their drives show."""

from __future__ import annotations

import itertools
from typing import Any

import numpy as np
import pytest
from test_building import drive
from test_towards import car, deed, driven, others, track

from chatscene.build.build import build
from chatscene.errors import NotBuilt
from chatscene.terms.episode import Episode, Track

SEEDS = (0, 1)


def _track(episode: Episode, name: str) -> Track:
    return next(one for one in episode.tracks if one.actor == name)


def _lead(episode: Episode, name: str = "A") -> np.ndarray[Any, Any]:
    there, ego = _track(episode, name), episode.ego_track
    steps = min(len(there.x), len(ego.x))
    dx, dy = there.x[:steps] - ego.x[:steps], there.y[:steps] - ego.y[:steps]
    return dx * np.cos(ego.heading[:steps]) + dy * np.sin(ego.heading[:steps])


@pytest.mark.parametrize("seed", SEEDS)
def test_a_lead_goes_steadily_and_brakes_once_as_hard_as_was_said(seed: int) -> None:
    lead = car("A", "ahead", deed("brake", acceleration="6 m/s²"), deed("stop"), distance="40 m", speed="80 km/h")
    episode = drive(build(others(lead, ego={"speed": "80 km/h"})), seed=seed)
    assert isinstance(episode, Episode)
    speed = _track(episode, "A").speed
    begins = int(np.argmax(speed < 0.92 * speed[0]))
    assert np.abs(speed[:begins] - speed[0]).max() < 0.08 * speed[0]
    stands = int(np.argmax(speed < 0.1))
    assert (np.diff(speed[begins:stands]) < 0.0).all()
    middle = slice(begins + (stands - begins) // 4, begins + 3 * (stands - begins) // 4)
    assert -np.diff(speed[middle]).mean() / episode.dt == pytest.approx(6.2, abs=0.3)  # with drag
    assert _lead(episode)[0] == pytest.approx(44.9, abs=0.3)


@pytest.mark.parametrize("seed", SEEDS)
def test_who_overtakes_against_the_ego_passes_and_is_back_before_it(seed: int) -> None:
    said = others(
        car("A", "oncoming", deed("overtake", whom="B")),
        car("B", "oncoming", deed("go-along"), kind="truck"),
        contact={"whom": "A", "happens": False},
    )
    episode = drive(build(said), seed=seed)
    assert isinstance(episode, Episode)
    assert episode.collision is None
    mine, theirs = _lead(episode), _lead(episode, "B")
    meets = int(np.argmax(mine < 0.0))
    assert mine[0] > theirs[0]
    assert theirs[meets] - mine[meets] > 0.0  # it is past the truck when it meets the ego


@pytest.mark.parametrize("seed", SEEDS)
def test_who_brakes_twice_before_the_ego_is_near_it_each_time(seed: int) -> None:
    does = [deed(act) for act in ("overtake", "cut-in", "brake", "go-along", "brake")]
    episode = drive(build(others(car("A", "behind", *does))), seed=seed)
    assert isinstance(episode, Episode)
    there = _track(episode, "A")
    lead, speed = _lead(episode)[: len(there.speed)], there.speed
    hard = np.flatnonzero((np.gradient(speed, episode.dt) < -3.0) & (lead > 0.0))
    assert hard.size
    assert lead[hard].max() < 25.0


def test_an_ego_that_is_to_overtake_somebody_faster_is_refused() -> None:
    ahead = car("A", "ahead", deed("go-along"), speed="60 km/h")
    with pytest.raises(NotBuilt, match=r"others\.A: the ego at 50 km/h does not overtake a car at 60 km/h"):
        build(others(ahead, ego={"route": "overtake", "speed": "50 km/h"}))


def test_who_passes_an_ego_that_waits_may_be_slower_than_the_road() -> None:
    cyclist = car("A", "behind-beside", deed("overtake"), kind="bicycle", side="right")
    episode = driven(others(cyclist, ego={"does": [deed("stand")]}))
    assert _lead(episode)[0] < 0.0 < _lead(episode)[-1]


def test_several_in_a_row_keep_apart() -> None:
    said = others(car("A", "ahead", deed("stop")), car("B", "behind", deed("tailgate")) | {"count": 3})
    episode = driven(said)
    row = [_lead(episode, name) for name in ("B", "B-2", "B-3")]
    for first, then in itertools.pairwise(row):
        assert (first - then).min() > track(episode).length


def test_a_truck_does_not_turn_round_on_a_narrow_road() -> None:
    with pytest.raises(NotBuilt, match=r"u-turn: a truck needs \d+ m of road"):
        build(others(car("A", "ahead", deed("u-turn"), kind="truck")))


def test_who_exits_takes_a_ramp_that_the_ego_goes_past() -> None:
    made = build(others(car("A", "beside", deed("cut-in"), deed("exit"), side="left"), road={"kind": "motorway"}))
    assert "offRamp(egoRoute)" in made.program.source
    assert "past-off-ramp" in made.program.source
