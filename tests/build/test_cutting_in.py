"""Who comes in from beside the ego is ahead of its nose then, so that the ego can avoid it: any kind, from any side."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest
from test_building import drive, simulator
from test_towards import car, deed, others, track

from chatscene.build.build import Built, build
from chatscene.errors import NotBuilt
from chatscene.program.judge import failures, judge
from chatscene.situations.form import from_plain
from chatscene.terms.episode import Episode, Track


def comes_in(kind: str, where: str, act: str = "cut-in", **said: Any) -> Built:
    side = {} if where == "on-ramp" else {"side": said.pop("side", "left")}
    one = {"id": "A", "kind": kind, "starts": {"where": where, **side}, "does": [{"act": act}]}
    return build(from_plain({"others": [one], **said}))


def tracks(built: Built, seed: int) -> tuple[Episode, Track, Track]:
    episode = drive(built, seed=seed)
    assert isinstance(episode, Episode), episode
    return episode, episode.ego_track, next(one for one in episode.tracks if one.actor == "A")


def room_over_the_line(built: Built, seed: int) -> tuple[float, float]:
    """From nose to tail [m] when the two first are in each other's way, and how fast the ego comes up [m/s]."""
    _, ego, other = tracks(built, seed)
    dx, dy, cos, sin = other.x - ego.x, other.y - ego.y, np.cos(ego.heading), np.sin(ego.heading)
    over = int(np.argmax(np.abs(dy * cos - dx * sin) < 0.5 * (ego.width + other.width)))
    assert over > 0
    along = float(dx[over] * cos[over] + dy[over] * sin[over])
    return along - 0.5 * (ego.length + other.length), float(ego.speed[over] - other.speed[over])


MOTORWAY: dict[str, Any] = {"road": {"kind": "motorway"}}
CASES = [
    ("car", "beside", {"side": "left"}),
    ("car", "beside", {"side": "left", **MOTORWAY}),
    ("car", "beside", {"side": "right", **MOTORWAY}),
    ("car", "behind-beside", {"side": "left", **MOTORWAY}),
    ("truck", "beside", {"side": "right", **MOTORWAY}),
    ("bus", "behind-beside", {"side": "left"}),
    ("motorcycle", "beside", {"side": "right"}),
    ("truck", "ahead-beside", {"side": "left", **MOTORWAY}),
    ("car", "beside", {"act": "merge", **MOTORWAY}),
    ("motorcycle", "behind-beside", {"act": "lane-change", **MOTORWAY}),
    ("truck", "on-ramp", {"act": "merge", **MOTORWAY}),
    ("car", "on-ramp", {"act": "merge", **MOTORWAY}),
]


@pytest.mark.parametrize(("kind", "where", "said"), CASES)
def test_who_comes_in_is_ahead_of_the_ego_by_then_and_near(kind: str, where: str, said: dict[str, Any]) -> None:
    built = comes_in(kind, where, **said)
    for seed in (1, 2):
        room, closing = room_over_the_line(built, seed)
        assert 0.3 < room < 17.0
        assert closing < 9.0


def test_the_room_that_it_leaves_is_searched() -> None:
    names = {one.name: one for one in comes_in("car", "beside", **MOTORWAY).program.parameters}
    assert (names["OPT_A_AHEAD_0"].low, names["OPT_A_AHEAD_0"].high) == (1.0, 6.0)
    assert names["OPT_A_SPEED"].low < names["OPT_A_SPEED"].high == pytest.approx(110 / 3.6, abs=0.01)


@pytest.mark.parametrize("ego", ["left", "left-rear"])
def test_who_is_to_touch_the_ego_s_side_stays_level_with_it(ego: str) -> None:
    built = comes_in("car", "beside", contact={"ego": ego})
    assert tracks(built, 1)[0].collision is not None


def test_who_is_too_slow_to_get_ahead_is_met_by_a_slower_ego_and_that_is_told() -> None:
    built = comes_in("tractor", "beside", **MOTORWAY)
    assert built.program.wanted_speed is not None
    assert built.program.wanted_speed < 20.0
    assert any("since 110 km/h cannot be built" in one for one in built.assumed)


def test_somebody_who_goes_on_before_the_ego_is_far_enough_ahead_of_who_comes_in_between() -> None:
    between = {"id": "A", "kind": "car", "starts": {"where": "ahead-beside"}, "does": [{"act": "cut-in"}]}
    before = {"id": "B", "kind": "car", "starts": {"where": "ahead"}, "does": [{"act": "brake"}]}
    episode = drive(build(from_plain({"others": [between, before]})))
    assert isinstance(episode, Episode)
    one, other = (next(track for track in episode.tracks if track.actor == name) for name in "AB")
    assert np.hypot(other.x[0] - one.x[0], other.y[0] - one.y[0]) > 1.3 * 50 / 3.6


def at_speed(kind: str, where: str, ego: str, own: str, act: str = "cut-in", **said: Any) -> dict[str, Any]:
    """Somebody who comes in at a speed that was said, before an ego of which one was said."""
    starts = {"where": where, **({} if where == "on-ramp" else {"side": "left"})}
    one = {"id": "A", "kind": kind, "starts": starts, "does": [{"act": act, "speed": own, **said}]}
    return {"ego": {"speed": ego}, "road": {"kind": "motorway"}, "others": [one]}


SLOWER = [
    at_speed("car", "ahead-beside", "110 km/h", "90 km/h"),
    at_speed("truck", "ahead-beside", "100 km/h", "60 km/h", "lane-change"),
    at_speed("van", "ahead-beside", "100 km/h", "80 km/h", distance="12 m"),
    at_speed("motorcycle", "beside", "80 km/h", "60 km/h"),
    at_speed("car", "beside", "110 km/h", "90 km/h"),
    at_speed("car", "behind-beside", "110 km/h", "95 km/h", "merge"),
    at_speed("car", "on-ramp", "110 km/h", "70 km/h", "merge"),
]


@pytest.mark.parametrize("facts", SLOWER)
def test_who_comes_in_slower_than_the_ego_is_before_it_until_it_is_in_its_lane(facts: dict[str, Any]) -> None:
    said = from_plain(facts)
    built = build(said)
    for seed in (1, 2):
        episode = drive(built, seed=seed)
        assert isinstance(episode, Episode), episode
        route = simulator(built.map, "native").route(built.program, 0)
        assert failures(judge(said, episode, route), met=False) == ()


@pytest.mark.parametrize(
    ("facts", "told"),
    [
        (at_speed("truck", "beside", "110 km/h", "90 km/h"), "with at most 90 km/h cannot get ahead of an ego at 110"),
        (
            {
                "ego": {"speed": "80 km/h"},
                "others": [
                    {
                        "id": "A",
                        "kind": "car",
                        "starts": {"where": "beside", "side": "left", "speed": "60 km/h"},
                        "does": [{"act": "lane-change"}],
                    }
                ],
            },
            "a car at 60 km/h cannot get ahead of an ego at 80 km/h from beside; say ahead-beside, or a slower ego",
        ),
    ],
)
def test_who_can_never_be_before_the_ego_is_refused_with_what_can(facts: dict[str, Any], told: str) -> None:
    with pytest.raises(NotBuilt, match=told):
        build(from_plain(facts))


def test_a_truck_on_whom_a_fast_ego_closes_in_leaves_the_gap_that_was_said() -> None:
    does = [{"act": "cut-in", "distance": "8 m"}]
    one = {"id": "A", "kind": "truck", "starts": {"where": "ahead-beside", "side": "left"}, "does": does}
    built = build(from_plain({"ego": {"speed": "110 km/h"}, "road": {"kind": "motorway"}, "others": [one]}))
    room, closing = room_over_the_line(built, 1)
    assert 6.0 < room < 11.0
    assert closing > 0.0


def test_who_was_said_how_near_the_ego_is_as_it_cuts_in_does_so_then() -> None:
    when = {"when": {"ego_within": "40 m"}}
    comes = car("A", "ahead-beside", deed("cut-in") | when, side="right", speed="95 km/h")
    said = others(comes, ego={"speed": "130 km/h"}, road={"kind": "motorway", "lanes": 3, "ego_lane": 3})
    for seed in range(3):
        episode = drive(build(said), seed=seed)
        assert isinstance(episode, Episode)
        one, ego = track(episode, "A"), episode.ego_track
        gap = np.hypot(one.x - ego.x, one.y - ego.y) - 0.5 * (one.length + ego.length)
        turns = int(np.flatnonzero(np.abs(one.heading - one.heading[0]) > 0.015)[0])
        assert 32.0 < gap[turns] < 42.0


def sideways(built: Built, seed: int) -> tuple[Track, float, float]:
    """Who goes over, the most that it then is fast sideways [m/s], over a second, and how long it takes [s]."""
    episode, _, other = tracks(built, seed)
    aside = np.abs(other.x - other.x[0]) if abs(np.cos(other.heading[0])) < 0.5 else np.abs(other.y - other.y[0])
    second = round(1.0 / episode.dt)
    over = (aside > 0.1 * aside.max()) & (aside < 0.9 * aside.max())
    return other, float(((aside[second:] - aside[:-second]) * 1.0).max()), float(over.sum() * episode.dt)


@pytest.mark.parametrize("said", [{}, {"distance": "22 m"}, {"when": {"ego_within": "25 m"}}])
def test_a_speed_of_a_cut_in_at_which_nobody_drives_is_how_fast_it_comes_over(said: dict[str, Any]) -> None:
    start = {"where": "ahead-beside", "side": "left", "speed": "40 km/h"}
    one = {"id": "A", "kind": "car", "starts": start, "does": [{"act": "cut-in", "speed": "1.2 m/s", **said}]}
    situation = from_plain({"ego": {"speed": "60 km/h"}, "others": [one]})
    built = build(situation)
    other, fastest, _ = sideways(built, 1)
    assert fastest == pytest.approx(1.2, abs=0.3)
    assert float(other.speed.min()) > 38 / 3.6
    found = judge(situation, tracks(built, 1)[0], simulator(built.map, "native").route(built.program, 0))
    assert not failures(found)


def test_a_judge_sees_that_somebody_comes_over_faster_than_was_said() -> None:
    start = {"where": "ahead-beside", "side": "left", "speed": "40 km/h"}
    plain = {"id": "A", "kind": "car", "starts": start, "does": [{"act": "cut-in", "manner": "sudden"}]}
    built = build(from_plain({"ego": {"speed": "60 km/h"}, "others": [plain]}))
    slow = {**plain, "does": [{"act": "cut-in", "speed": "0.5 m/s"}]}
    said = from_plain({"ego": {"speed": "60 km/h"}, "others": [slow]})
    found = judge(said, tracks(built, 1)[0], simulator(built.map, "native").route(built.program, 0))
    assert any("comes aside at" in told for told in failures(found))


def test_a_lane_change_at_the_pace_of_a_queue_is_along_the_road() -> None:
    one = {"id": "A", "kind": "car", "starts": {"where": "ahead-beside", "side": "left", "speed": "3 km/h"}}
    built = build(from_plain({"others": [{**one, "does": [{"act": "lane-change", "speed": "5 km/h"}]}]}))
    assert "= 1.388" in built.program.source or ", 1.388" in built.program.source


@pytest.mark.parametrize("act", ["cut-out", "lane-change"])
def test_who_is_said_to_change_lanes_slowly_takes_four_seconds_and_who_does_it_suddenly_not(act: str) -> None:
    def over(manner: str) -> tuple[float, tuple[str, ...]]:
        deeds = {"does": [{"act": act, "manner": manner}]}
        start = {"where": "ahead" if act == "cut-out" else "ahead-beside"}
        built = build(
            from_plain({"ego": {"speed": "50 km/h"}, "others": [{"id": "A", "kind": "car", "starts": start, **deeds}]})
        )
        return sideways(built, 1)[2], built.left_out

    (slow, left_out), (sudden, _) = over("slow"), over("sudden")
    assert slow > 2.2 > sudden
    assert not left_out
