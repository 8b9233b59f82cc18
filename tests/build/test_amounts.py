"""Where across the road somebody was said to be, and how long after something a deed was said to begin."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest
from test_building import simulator
from test_meeting import met
from test_towards import driven, track

from chatscene.build.build import build
from chatscene.errors import NotBuilt, SituationError
from chatscene.program.judge import judge
from chatscene.situations.form import from_plain
from chatscene.terms.episode import Episode
from chatscene.terms.situation import Situation


def of(kind: str, start: dict[str, Any], *does: dict[str, Any] | str, **more: Any) -> Situation:
    deeds = [{"act": deed} if isinstance(deed, str) else deed for deed in does]
    return from_plain({"others": [{"id": "A", "kind": kind, "starts": start, "does": deeds}], **more})


def left_of_ego(episode: Episode, name: str = "A") -> np.ndarray[Any, Any]:
    ego, other = episode.ego_track, track(episode, name)
    sin, cos = np.sin(ego.heading[0]), np.cos(ego.heading[0])
    return (other.y - ego.y[0]) * cos - (other.x - ego.x[0]) * sin


def shown(said: Situation, episode: Episode, seed: int = 1) -> dict[str, bool | None]:
    built = build(said)
    route = simulator(built.map, "native").route(built.program, 0)
    return {one.path: one.shown for one in judge(said, episode, route)}


@pytest.mark.parametrize(
    ("kind", "where", "lateral", "left"),
    [
        ("car", "ahead", {"overlap": "50 %", "side": "right"}, -1.1),
        ("car", "ahead", {"overlap": "25 %", "side": "left"}, 1.65),
        ("bicycle", "ahead", {"overlap": "25 %", "side": "right"}, -0.55),
        ("pedestrian", "ahead", {"edge": "0.5 m", "side": "right"}, -1.25),
        ("car", "ahead", {"offset": "0.4 m", "side": "left"}, 0.4),
        ("bicycle", "ahead", {"clearance": "0.8 m", "side": "right"}, -2.3),
    ],
)
def test_who_is_said_to_be_beside_the_middle_of_the_lane_is_there(
    kind: str, where: str, lateral: dict[str, str], left: float
) -> None:
    act = "stand" if kind == "car" else "go-along"
    said = of(kind, {"where": where, "lateral": lateral}, act)
    episode = driven(said)
    assert left_of_ego(episode)[0] == pytest.approx(left, abs=0.15)
    found = shown(said, episode)
    name = next(iter(lateral))
    assert found[f"others.A.starts.lateral.{name}"] is True
    assert found["others.A.starts.lateral.side"] is True
    wrong = of(kind, {"where": where, "lateral": {"offset": "0 m"}}, act)
    assert shown(wrong, episode)["others.A.starts.lateral.offset"] is False


def test_who_comes_against_the_ego_is_halfway_over_the_line() -> None:
    start = {"where": "oncoming-in-our-lane", "lateral": {"edge": "0 m", "side": "left"}}
    episode = driven(of("motorcycle", start, "go-along", road={"kind": "road", "two_way": True}))
    assert left_of_ego(episode)[0] == pytest.approx(1.75, abs=0.2)


def test_who_cuts_in_goes_on_where_it_was_said_to() -> None:
    does = {"act": "cut-in", "lateral": {"offset": "0.8 m", "side": "right"}}
    said = of("car", {"where": "ahead-beside", "side": "right"}, does, ego={"speed": "50 km/h"})
    episode = driven(said)
    assert shown(said, episode)["others.A.does.0.lateral.offset"] is True
    assert np.abs(left_of_ego(episode) + 0.8).min() < 0.1 and left_of_ego(episode)[-1] < -0.5


def test_a_place_across_the_road_is_said_by_one_number_of_who_can_be_there() -> None:
    with pytest.raises(SituationError, match="say one of"):
        of("car", {"where": "ahead", "lateral": {"side": "left", "edge": "0 m", "offset": "1 m"}})
    with pytest.raises(SituationError, match="has no lateral position"):
        of("car", {"where": "ahead"}, {"act": "brake", "lateral": {"edge": "0 m"}})
    with pytest.raises(SituationError, match="100 %"):
        of("car", {"where": "ahead", "lateral": {"overlap": "120 %"}})
    with pytest.raises(NotBuilt, match=r"starts\.lateral"):
        build(of("child", {"where": "roadside", "side": "right", "lateral": {"edge": "1 m"}}, "cross"))


def test_who_is_wholly_in_line_with_the_ego_is_told_to_no_side() -> None:
    made = build(of("car", {"where": "ahead", "lateral": {"overlap": "100 %"}}, "stand"))
    assert not [one for one in made.assumed if "across the road" in one]


def test_a_side_that_was_not_said_is_told() -> None:
    made = build(of("car", {"where": "ahead", "lateral": {"overlap": "50 %"}}, "stand"))
    assert "A is to the right across the road" in made.assumed


@pytest.mark.parametrize("share", ["25 %", "50 %", "75 %"])
def test_an_ego_that_does_not_brake_meets_who_crosses_at_the_point_of_its_width(share: str) -> None:
    contact = {"ego": "front", "at": share}
    crosses = {"act": "cross", "speed": "5 km/h"}
    said = of("child", {"where": "roadside", "side": "right"}, crosses, ego={"speed": "40 km/h"}, contact=contact)
    built = build(said)
    for seed in range(3):
        assert shown(said, met(built, seed))["contact.at"] is True
    other = of("child", {"where": "roadside", "side": "right"}, crosses, contact={"at": "1 %"})
    assert shown(other, met(built, 0))["contact.at"] is False


@pytest.mark.parametrize(("name", "seconds"), [("during", 1.1), ("during", 2.5)])
def test_somebody_follows_so_long_after_the_other(name: str, seconds: float) -> None:
    start = {"where": "roadside", "side": "left"}
    later = {name: "A.0", "delay": f"{seconds} s"}
    said = from_plain(
        {
            "others": [
                {"id": "A", "kind": "dog", "role": "supporting", "starts": start, "does": [{"act": "cross"}]},
                {"id": "B", "kind": "pedestrian", "starts": start, "does": [{"act": "cross", "when": later}]},
            ]
        }
    )
    episode = driven(said)
    began = [int(np.argmax(track(episode, name).speed > 0.3)) * episode.dt for name in "AB"]
    assert began[1] - began[0] == pytest.approx(seconds, abs=0.3)
    assert shown(said, episode)["others.B.does.0.when.delay"] is True


def test_a_deed_of_its_own_follows_so_long_after_the_last() -> None:
    later = {"act": "brake", "acceleration": "4 m/s²", "when": {"after": "A.0", "delay": "2 s"}}
    said = of("car", {"where": "ahead-beside", "side": "right"}, "cut-in", later, ego={"speed": "60 km/h"})
    episode = driven(said)
    assert shown(said, episode)["others.A.does.1.when.delay"] is True


def test_how_near_the_ego_is_is_from_its_front_to_the_tail_of_who_stands() -> None:
    pulls = {"act": "pull-out", "when": {"ego_within": "15 m"}}
    episode = driven(of("bus", {"where": "kerb", "side": "right"}, "stand", pulls, ego={"speed": "45 km/h"}))
    bus, ego = track(episode), episode.ego_track
    begins = int(np.argmax(bus.speed > 0.1))
    room = np.hypot(bus.x - ego.x, bus.y - ego.y)[begins] - (bus.length + ego.length) / 2
    assert room == pytest.approx(15.0, abs=2.5)  # the ego drives 1.25 m a step, and a bus is slow to begin


def numbers(said: Situation, name: str, seeds: int = 2) -> list[bool | None]:
    built = build(said)
    route = simulator(built.map, "native").route(built.program, 0)
    found = [one for n in range(seeds) for one in judge(said, met(built, n), route)]
    return [one.shown for one in found if one.path == f"others.A.does.{name}"]


@pytest.mark.parametrize(
    ("kind", "start", "does", "name"),
    [
        ("car", {"where": "ahead-beside", "side": "right", "speed": "40 km/h"}, [{"act": "cut-in", "distance": "12 m"}],
         "0.distance"),
        ("car", {"where": "ahead-beside", "side": "right"}, [{"act": "lane-change", "time": "3.5 s"}], "0.time"),
        ("car", {"where": "ahead"}, [{"act": "cut-out", "time": "5 s"}], "0.time"),
        ("bus", {"where": "kerb", "side": "right"}, [{"act": "pull-out", "acceleration": "1 m/s²"}], "0.acceleration"),
        ("car", {"where": "ahead"}, [{"act": "stand"}, {"act": "set-off", "acceleration": "2 m/s²"}], "1.acceleration"),
        ("car", {"where": "ahead"}, [{"act": "accelerate", "time": "3 s"}], "0.time"),
        ("car", {"where": "ahead"}, [{"act": "accelerate", "time": "5 s"}], "0.time"),
        ("car", {"where": "behind"}, [{"act": "follow", "time": "3 s"}, {"act": "brake"}], "0.time"),
        ("car", {"where": "behind-beside", "side": "left"}, [{"act": "overtake", "distance": "25 m"}], "0.distance"),
        ("car", {"where": "ahead"}, [{"act": "slow-down", "acceleration": "1 m/s²"}], "0.acceleration"),
        ("car", {"where": "ahead"}, [{"act": "brake", "speed": "20 km/h", "time": "3 s"}], "0.time"),
        ("car", {"where": "ahead"}, [{"act": "stop", "distance": "25 m"}], "0.distance"),
        ("car", {"where": "ahead"}, [{"act": "weave", "time": "5 s"}], "0.time"),
        ("car", {"where": "ahead-beside", "side": "right"}, [{"act": "drift", "time": "3 s"}], "0.time"),
        ("car", {"where": "behind"}, [{"act": "follow", "distance": "25 m"}], "0.distance"),
        ("car", {"where": "ahead"}, [{"act": "go-along", "distance": "40 m"}, {"act": "brake"}], "0.distance"),
    ],
)  # fmt: skip
def test_how_hard_how_far_and_how_long_is_what_was_said(
    kind: str, start: dict[str, Any], does: list[dict[str, Any]], name: str
) -> None:
    said = of(kind, start, *does, ego={"speed": "50 km/h"})
    found = numbers(said, name)
    assert found and False not in found and True in found


def test_what_no_body_does_in_a_time_or_on_a_way_is_refused_by_its_path() -> None:
    for start, deed in (
        ({"where": "ahead-beside", "side": "right"}, {"act": "lane-change", "time": "1 s"}),
        ({"where": "ahead"}, {"act": "stop", "distance": "5 m"}),
        ({"where": "ahead"}, {"act": "accelerate", "time": "0.5 s", "speed": "90 km/h"}),
        ({"where": "ahead"}, {"act": "weave", "time": "1 s"}),
    ):
        with pytest.raises(NotBuilt, match=r"others\.A\.does\.0\.(time|distance)"):
            build(of("car", start, deed, ego={"speed": "50 km/h"}))


def test_who_is_passed_while_it_cuts_in_is_before_the_ego_by_the_room_that_was_said_at_the_line() -> None:
    start = {"where": "ahead-beside", "side": "right", "speed": "80 km/h"}
    said = of("car", start, {"act": "cut-in", "distance": "12 m"}, ego={"speed": "100 km/h"}, road={"lanes": 3})
    episode = driven(said)
    ego, other, left = episode.ego_track, track(episode), left_of_ego(episode)
    over = int(np.argmax(np.abs(left) < 1.75))
    room = np.hypot(other.x - ego.x, other.y - ego.y)[over] - (other.length + ego.length) / 2
    assert room == pytest.approx(12.0, rel=0.15)


def test_who_keeps_a_distance_keeps_up_with_a_fast_ego() -> None:
    said = of("car", {"where": "behind"}, {"act": "tailgate", "distance": "12 m"}, ego={"speed": "120 km/h"})
    assert numbers(said, "0.distance") == [True, True]


def test_a_protocol_of_a_change_of_lanes_is_driven_to_its_numbers() -> None:
    over = {"act": "lane-change", "to": "left", "time": "3.5 s", "when": {"ego_within": "25 m"}}
    brakes = {"act": "brake", "acceleration": "4 m/s²", "speed": "50 km/h", "when": {"after": "A.0", "delay": "1 s"}}
    start = {"where": "ahead-beside", "side": "right", "speed": "80 km/h"}
    said = of("car", start, over, brakes, ego={"speed": "110 km/h"}, road={"lanes": 3, "ego_lane": 2})
    found = shown(said, driven(said))
    for name in ("0.time", "0.when.ego_within", "1.when.delay", "1.acceleration", "1.speed"):
        assert found[f"others.A.does.{name}"] is True, name


def test_a_bus_that_pulls_out_gains_speed_at_the_rate_that_was_said_of_what_it_does_then() -> None:
    gains = {"act": "accelerate", "acceleration": "1 m/s²"}
    said = of("bus", {"where": "kerb", "side": "right"}, "stand", "pull-out", gains, ego={"speed": "45 km/h"})
    assert shown(said, driven(said))["others.A.does.2.acceleration"] is True
    bus = track(driven(said))
    begins = int(np.argmax(bus.speed > 0.2))
    assert bus.speed[begins + 30] - bus.speed[begins] == pytest.approx(3.0, rel=0.2)
