"""A deed comes at the moment at which it matters to the ego: level with one that stands, as near as was said."""

from __future__ import annotations

import re

import numpy as np
from test_building import simulator
from test_in_time import deed, unseen
from test_towards import car, driven, others, track

from chatscene.build.build import build
from chatscene.program.judge import judge
from chatscene.program.near import how_near
from chatscene.program.watching import watch
from chatscene.situations.form import from_plain

BESIDE = {"side": "left", "speed": "56 mph"}
DRIFTS = deed("drift", to="right") | {"lateral": {"side": "left", "clearance": "0.5 m"}}
PASSED = from_plain(
    {
        "ego": {"does": [deed("stand")]},
        "road": {"kind": "motorway"},
        "others": [car("A", "behind-beside", DRIFTS, kind="truck", **BESIDE)],
        "contact": {"whom": "A", "happens": False},
    }
)
"""Somebody drifts toward an ego that stands on the shoulder, as it comes by."""


def test_who_drifts_past_an_ego_that_stands_is_aside_as_it_is_level_with_that() -> None:
    assert unseen(PASSED) == ()
    episode = driven(PASSED)
    ego, truck = episode.ego_track, track(episode)
    level = int(np.argmin(np.abs(truck.x - ego.x[: len(truck.x)]) + np.abs(truck.y - ego.y[: len(truck.x)])))
    began = abs(float(np.hypot(truck.x[0] - ego.x[0], truck.y[0] - ego.y[0])))
    assert level > 0
    assert began > 30.0


AGAINST = others(
    car("A", "oncoming", deed("overtake", whom="B") | {"when": {"ego_within": "3.1 s"}}),
    car("B", "oncoming", deed("go-along"), kind="tractor"),
    ego={"speed": "80 km/h"},
    road={"setting": "rural", "lanes": 1, "two_way": True},
)


def test_a_time_to_who_comes_against_the_ego_is_how_soon_the_two_would_meet() -> None:
    made = build(AGAINST)
    assert re.search(r"gap\(self, ego\).* < 3\.1 \* \(self\.pose\[3\] \+ ego\.pose\[3\]\)", made.program.source)
    episode = driven(AGAINST)
    route = simulator(made.map, "native").route(made.program, 0)
    seen = watch(episode, route, track(episode))
    out = int(np.argmax(np.abs(seen.drift) > 0.4))
    (seconds,) = how_near(seen, out, in_seconds=True, leaves=False)
    assert 2.0 < seconds < 3.2
    found = {one.path: one.shown for one in judge(AGAINST, episode, route)}
    assert found["others.A.does.0.when.ego_within"] is True


FAR = others(
    car("A", "oncoming", deed("overtake", whom="B"), distance="300 m"),
    car("B", "oncoming", deed("go-along"), kind="truck"),
    ego={"speed": "80 km/h", "does": [deed("swerve", to="right") | {"when": {"during": "A.overtake"}}, deed("stop")]},
    road={"setting": "rural", "two_way": True},
)


def test_who_is_passed_begins_just_before_who_passes_it_where_that_was_said_to_begin() -> None:
    episode = driven(FAR)
    passes, passed = (track(episode, name) for name in "AB")
    assert float(np.hypot(passes.x[0] - passed.x[0], passes.y[0] - passed.y[0])) < 30.0


def test_an_ego_that_steers_for_somebody_and_stops_then_stops_after_that_one_acts() -> None:
    orders = build(FAR).program.source.partition("with orders (")[2].partition("\n")[0]
    last = orders.split("Order(")[-1]
    assert "at_most=0" in last
    assert "whom='A'" in last
    assert "place=" not in last
