"""Who passes the ego and turns off across its way does so at the junction or the driveway, slowed down before that."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest
from test_building import drive, simulator

from chatscene.build.build import Built, build
from chatscene.program.judge import failures, judge
from chatscene.situations.form import from_plain
from chatscene.terms.episode import Episode, Track
from chatscene.terms.situation import Situation


def hook(where: str, turn: str = "turn-right", **said: Any) -> tuple[Situation, Built]:
    side = {} if where == "behind" else {"side": "left"}
    one = {"id": "A", "kind": "car", "starts": {"where": where, **side}, "does": [{"act": "overtake"}, {"act": turn}]}
    situation = from_plain({"others": [one], **said})
    return situation, build(situation)


def turns_at(built: Built, episode: Episode) -> tuple[Track, int, float]:
    """Who hooks, the step at which it has turned by a sixth, and how far beyond its place [m] it then is."""
    route = simulator(built.map, "native").route(built.program, 0)
    other = next(one for one in episode.tracks if one.actor == "A")
    along = route.line.headings_at(route.line.along(other.x, other.y))
    off = np.abs(np.remainder(other.heading - along + np.pi, 2 * np.pi) - np.pi) > np.radians(30)
    beyond = route.line.along(other.x, other.y) - route.event_at
    first = int(np.argmax(off & (beyond > -15.0)))
    return other, first, float(beyond[first])


CASES: list[tuple[str, dict[str, Any]]] = [
    ("behind", {"road": {"kind": "junction"}, "ego": {"speed": "50 km/h"}}),
    ("behind-beside", {"road": {"kind": "junction"}}),
    ("behind-beside", {"ego": {"kind": "bicycle", "speed": "25 km/h"}}),
    ("behind", {"ego": {"kind": "bicycle", "speed": "20 km/h"}}),
]


@pytest.mark.parametrize(("where", "said"), CASES)
def test_who_has_passed_the_ego_turns_off_at_the_place_and_not_anywhere(where: str, said: dict[str, Any]) -> None:
    situation, built = hook(where, **said)
    episode = drive(built, seed=1)
    assert isinstance(episode, Episode), episode
    other, first, beyond = turns_at(built, episode)
    assert -6.0 < beyond < 9.0
    assert float(other.speed[first]) < 20 / 3.6  # it has slowed down for it
    route = simulator(built.map, "native").route(built.program, 0)
    assert not failures(judge(situation, episode, route))


def test_an_ego_of_whom_no_speed_was_said_drives_as_in_a_town_while_it_is_passed() -> None:
    _, built = hook("behind", road={"kind": "junction"})
    episode = drive(built, seed=1)
    assert isinstance(episode, Episode), episode
    assert float(episode.ego_track.speed[0]) > 40 / 3.6


def test_a_road_is_laid_with_the_driveway_that_somebody_hooks_into() -> None:
    _, built = hook("behind-beside", road={"has": ["cycle-lane"]}, ego={"kind": "bicycle", "speed": "25 km/h"})
    assert "driveway=right" in built.map
    assert "site='driveway'" in built.program.source


@pytest.mark.parametrize(("side", "turn"), [("right", "turn-left"), ("left", "turn-right")])
def test_who_is_beside_the_ego_turns_across_its_way_at_the_junction(side: str, turn: str) -> None:
    one = {"id": "A", "kind": "car", "starts": {"where": "beside", "side": side}, "does": [{"act": turn}]}
    built = build(from_plain({"road": {"kind": "junction"}, "ego": {"route": "straight"}, "others": [one]}))
    episode = drive(built, seed=1)
    assert isinstance(episode, Episode), episode
    other = next(one for one in episode.tracks if one.actor == "A")
    route = simulator(built.map, "native").route(built.program, 0)
    along = route.line.headings_at(route.line.along(other.x, other.y))
    off = np.abs(np.remainder(other.heading - along + np.pi, 2 * np.pi) - np.pi) > np.radians(5)
    beyond = route.line.along(other.x, other.y) - route.event_at
    assert -15.0 < float(beyond[int(np.argmax(off))]) < 9.0


def test_who_takes_priority_that_it_has_not_comes_from_the_left_where_nothing_rules_the_junction() -> None:
    one = {"id": "A", "kind": "car", "starts": {"where": "arm"}, "does": [{"act": "go-straight"}]}
    breaks = one | {"does": [{"act": "go-straight", "breaks": "right-of-way"}]}
    road = {"kind": "junction", "control": "none"}
    assert 'trafficFrom(egoRoute, "right")' in build(from_plain({"road": road, "others": [one]})).program.source
    assert 'trafficFrom(egoRoute, "left")' in build(from_plain({"road": road, "others": [breaks]})).program.source


def test_who_brakes_before_it_hooks_off_turns_in_beside_who_waits_there() -> None:
    does = [{"act": one} for one in ("overtake", "brake", "turn-right")]
    turns = {"id": "A", "kind": "car", "starts": {"where": "behind-beside", "side": "left"}, "does": does}
    waits = {"id": "B", "kind": "car", "role": "supporting", "starts": {"where": "driveway", "side": "right"}}
    situation = from_plain(
        {
            "ego": {"kind": "bicycle", "speed": "25 km/h"},
            "others": [turns, waits | {"does": [{"act": "stand"}]}],
            "road": {"has": ["driveway"]},
        }
    )
    built = build(situation)
    assert "mouth=8" in built.map
    assert built.lacking == ()
    episode = drive(built, seed=1)
    assert isinstance(episode, Episode)
    route = simulator(built.map, "native").route(built.program, 0)
    a, b = (next(one for one in episode.tracks if one.actor == name) for name in ("A", "B"))
    in_there = float(np.min(np.hypot(a.x - b.x, a.y - b.y)))
    assert 2.3 < in_there < 6.0  # beside it, and not into it
    aside = np.abs([route.line.project(x, y)[1] for x, y in zip(a.x, a.y, strict=True)])
    assert float(aside.max()) > 8.0
    assert float(a.speed[-1]) < 0.5
