"""A deed comes at the moment at which it matters to the ego: level with one that stands, as near as was said."""

from __future__ import annotations

import re
from dataclasses import replace

import numpy as np
from test_building import simulator
from test_in_time import deed, unseen
from test_towards import car, driven, others, track

from chatscene.build.build import build
from chatscene.program.judge import judge
from chatscene.program.near import how_near
from chatscene.program.watching import watch
from chatscene.simulate.boxes import gaps
from chatscene.situations.form import from_plain
from chatscene.terms.episode import Episode, Track

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


def test_who_follows_and_is_not_to_touch_the_ego_is_all_but_in_it_when_it_slows() -> None:
    said = from_plain(
        {
            "ego": {"speed": "45 km/h"},
            "others": [
                car("A", "ahead", deed("brake", speed="10 km/h")),
                car("B", "behind", deed("follow"), kind="motorcycle"),
            ],
            "contact": {"whom": "B", "ego": "rear", "happens": False},
        }
    )
    assert unseen(said) == ()
    episode = driven(said)
    assert 0.2 < float(gaps(episode.ego_track, track(episode, "B")).min()) < 3.0


def test_who_comes_in_from_the_other_side_meanwhile_begins_with_who_comes_in() -> None:
    aside = {"to": "left"} | {"when": {"during": "A.0"}}
    said = others(
        car("A", "beside", deed("lane-change", to="right"), side="left"),
        car("B", "beside", deed("lane-change") | aside, side="right"),
        road={"lanes": 3, "ego_lane": 2},
    )
    episode = driven(said)
    began = [int(np.argmax(np.abs(_along(episode, name).y) > 0.5)) for name in "AB"]
    assert abs(began[0] - began[1]) * episode.dt < 1.6


def _along(episode: Episode, name: str) -> Track:
    """A track, seen along its first heading."""
    one = track(episode, name)
    turn = -float(one.heading[0])
    x, y = one.x - one.x[0], one.y - one.y[0]
    return replace(one, x=x * np.cos(turn) - y * np.sin(turn), y=x * np.sin(turn) + y * np.cos(turn))


def test_what_goes_on_for_a_time_that_was_said_ends_then() -> None:
    said = others(
        car("A", "ahead", deed("go-along", time="5 s"), deed("brake", speed="30 km/h")),
        ego={"speed": "110 km/h"},
        road={"kind": "motorway"},
    )
    episode = driven(said)
    loses = np.diff(track(episode).speed) / episode.dt < -2.0
    assert abs(float(np.argmax(loses)) * episode.dt - 5.0) < 0.5


def test_who_crosses_before_an_ego_that_stands_does_so_close_before_it_while_another_comes_by() -> None:
    said = others(
        car("A", "behind-beside", deed("overtake") | {"when": {"during": "B.cross"}}, kind="pickup", side="left"),
        car("B", "roadside", deed("cross"), kind="child", side="right"),
        ego={"kind": "bus", "does": [deed("stand")]},
    )
    assert unseen(said) == ()
    episode = driven(said)
    child, pickup = track(episode, "B"), track(episode)
    ego = episode.ego_track
    assert float(np.hypot(child.x[0] - ego.x[0], child.y[0] - ego.y[0])) < 18.0
    by = int(np.argmin(np.hypot(pickup.x - child.x, pickup.y - child.y)))
    assert float(child.speed[by]) > 0.5


def test_who_comes_up_in_the_lane_to_which_the_ego_changes_comes_after_it() -> None:
    def found(far: str) -> bool | None:
        said = others(
            car("A", "behind-beside", deed("go-along"), side="left", speed="200 km/h", distance=far),
            ego={"speed": "120 km/h", "does": [deed("lane-change", to="left")]},
            road={"kind": "motorway", "ego_lane": 1},
        )
        made = build(said)
        route = simulator(made.map, "native").route(made.program, 0)
        return {one.path: one.shown for one in judge(said, driven(said), route)}.get("encounter.A")

    assert found("4 m") is False
    assert found("90 m") is True


def test_a_door_is_opened_before_the_nose_of_an_ego_that_it_does_not_touch_is_by() -> None:
    said = others(
        car("A", "kerb", deed("stand"), deed("open-door"), side="right", distance="9 m"),
        ego={"speed": "30 km/h"},
    )
    episode = driven(said)
    door = track(episode, "A-door")
    opens = int(np.argmax(door.speed > 0.1))
    nose = np.hypot(episode.ego_track.x[opens] - door.x[opens], episode.ego_track.y[opens] - door.y[opens])
    assert float(nose) > 0.5 * episode.ego_track.length


def test_an_ego_that_leaves_its_lane_and_stops_is_not_held_in_that_behind_who_goes_before_it() -> None:
    said = others(
        car("A", "oncoming", deed("overtake", whom="C")),
        car("B", "ahead", deed("go-along"), kind="truck"),
        car("C", "oncoming", deed("go-along"), kind="truck"),
        ego={
            "speed": "80 km/h",
            "does": [deed("swerve", to="right") | {"when": {"during": "A.overtake"}}, deed("stop")],
        },
        road={"setting": "rural", "two_way": True},
    )
    assert "Order(aside=0)" not in build(said).program.source
