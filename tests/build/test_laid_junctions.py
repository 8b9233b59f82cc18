"""A roundabout or a junction of a shape that was said is one that a packaged map has, else one that is laid."""

from __future__ import annotations

from dataclasses import replace
from typing import Any

import numpy as np
import pytest
from test_building import drive

from benchmarks.differing import differences
from chatscene.build.arms import meets
from chatscene.build.build import Built, build
from chatscene.errors import NotBuilt, SituationError
from chatscene.maps.road_spec import Meets
from chatscene.situations.form import from_plain
from chatscene.situations.words import told
from chatscene.terms.episode import Episode


def said(where: str, *does: Any, road: dict[str, Any], ego: dict[str, Any] | None = None, **start: Any) -> Any:
    deeds = [{"act": deed} if isinstance(deed, str) else deed for deed in does]
    one = {"id": "A", "kind": "car", "starts": {"where": where, **start}, "does": deeds}
    return from_plain({"others": [one], "road": road, "ego": ego or {}})


def made(where: str, *does: Any, road: dict[str, Any], ego: dict[str, Any] | None = None, **start: Any) -> Built:
    return build(said(where, *does, road=road, ego=ego, **start))


@pytest.mark.parametrize(
    ("road", "ego", "on", "asked"),
    [
        ({"kind": "roundabout"}, {"route": "roundabout"}, "outskirts", "site='roundabout'"),
        ({"kind": "roundabout"}, {"exit": 3}, "outskirts", "by_exit=3"),
        ({"kind": "roundabout"}, {"exit": 4}, "outskirts", "by_exit=4"),
        (
            {"kind": "roundabout", "diameter": "24 m"},
            {},
            "road:1+1,junction=four,ring=1,diameter=24",
            "across",
        ),
        ({"kind": "mini-roundabout"}, {}, "road:1+1,junction=four,ring=1,diameter=18", "across=(0.0, 28.0)"),
        ({"kind": "roundabout", "arms": 3}, {"route": "roundabout"}, "road:1+1,junction=fork,ring=1", "arms=3"),
        ({"kind": "roundabout", "arms": 5}, {"exit": 5}, "road:1+1,junction=five,ring=1", "by_exit=5"),
        ({"kind": "roundabout", "lanes": 3}, {"exit": 2}, "road:3+3,junction=four,side=3,ring=3", "lanes=3"),
    ],
)
def test_a_roundabout_is_as_it_was_said(road: dict[str, Any], ego: dict[str, Any], on: str, asked: str) -> None:
    built = made("in-roundabout", "go-along", road=road, ego={"speed": "25 km/h", **ego})
    assert built.map.startswith(on)
    assert asked in built.program.source
    assert not (built.left_out or built.lacking)


@pytest.mark.parametrize(
    ("road", "side", "act", "on"),
    [
        ({"kind": "three-way", "side_road": "left", "control": "priority"}, "left", "turn-left", "junction=left"),
        ({"kind": "three-way", "control": "priority"}, "right", "stand", "junction=right"),
        ({"kind": "t-end", "control": "yield-sign"}, "right", "go-straight", "junction=stem,signs=yield"),
        ({"kind": "fork"}, "left", "go-straight", "junction=fork"),
        ({"kind": "junction", "has": ["turn-lane"]}, "right", "go-straight", "junction=four,turn-lane=left"),
    ],
)
def test_a_junction_is_as_it_was_said(road: dict[str, Any], side: str, act: str, on: str) -> None:
    built = made("arm", act, road=road, side=side)
    assert on in built.map
    assert not (built.left_out or built.lacking)


def test_a_shape_that_a_packaged_map_has_is_not_laid() -> None:
    assert made("arm", "go-straight", road={"kind": "t-end"}, side="left").map == "town"
    assert made("arm", "turn-left", road={"kind": "three-way", "side_road": "right"}, side="right").map == "town"
    assert made("arm", "go-straight", road={"arms": 4}, side="left").map == "town"


@pytest.mark.parametrize(
    ("route", "where", "act", "side", "shape"),
    [
        ("straight", "arm", "turn-left", "right", Meets.RIGHT),
        ("straight", "arm", "turn-left", "left", Meets.LEFT),
        ("left-turn", "arm", "go-straight", "right", Meets.STEM),
        ("left-turn", "oncoming", "go-straight", None, Meets.LEFT),
        ("right-turn", "arm", "go-straight", "left", Meets.STEM),
        ("straight", "oncoming", "turn-left", None, Meets.RIGHT),
    ],
)
def test_a_t_has_the_arms_that_are_come_from_and_taken(
    route: str, where: str, act: str, side: str | None, shape: Meets
) -> None:
    start = {} if side is None else {"side": side}
    assert meets(said(where, act, road={"kind": "three-way"}, ego={"route": route}, **start)) is shape


@pytest.mark.parametrize(
    ("road", "ego", "why"),
    [
        ({"kind": "roundabout", "arms": 6}, {}, "6 arms cannot be built; 3 to 5 can"),
        ({"kind": "four-way", "arms": 3}, {}, "it has 4 arms where the road is a four-way junction"),
        ({"kind": "motorway", "arms": 3}, {}, "there are no arms where the road is a motorway"),
        ({"kind": "t-end", "side_road": "left"}, {}, "it is the third arm of a junction; say three-way"),
        ({"kind": "four-way", "diameter": "20 m"}, {}, "only a roundabout has one"),
        ({"kind": "four-way"}, {"exit": 2}, "only a roundabout has one"),
        ({"kind": "roundabout", "arms": 3}, {"exit": 4}, "4 is none of its exits: it has 3 at most"),
        ({"kind": "fork"}, {"route": "straight"}, "no way straight on where the road is a fork"),
    ],
)
def test_arms_and_exits_that_exclude_each_other_are_refused(
    road: dict[str, Any], ego: dict[str, Any], why: str
) -> None:
    with pytest.raises(SituationError, match=why):
        said("ahead", "brake", road=road, ego=ego)


def test_a_roundabout_that_no_map_has_is_refused_on_a_map_that_was_named() -> None:
    one = said("in-roundabout", "go-along", road={"kind": "mini-roundabout"})
    with pytest.raises(NotBuilt, match="0 to 28 m across"):
        build(replace(one, map="outskirts"))


def test_who_walks_at_an_exit_is_on_the_crosswalk_of_that_exit() -> None:
    walks = {"id": "A", "kind": "pedestrian", "starts": {"where": "exit-crossing"}, "does": [{"act": "cross"}]}
    road = {"kind": "roundabout", "lanes": 2, "has": ["crosswalk"]}
    built = build(from_plain({"others": [walks], "road": road, "ego": {"exit": 3, "speed": "25 km/h"}}))
    assert "crosswalk,junction=four,side=2,ring=2" in built.map
    assert not built.lacking


def test_arms_size_and_exit_are_told_in_words() -> None:
    road = {"kind": "roundabout", "arms": 3, "diameter": "30 m"}
    words = told(said("in-roundabout", "go-along", road=road, ego={"route": "roundabout", "exit": 2}))
    assert "We take the second exit. Three roads meet there, and it is 30 m across." in words
    t = told(said("ahead", "brake", road={"kind": "three-way", "side_road": "left"}))
    assert "There is a side road on our left." in t


def test_who_goes_round_beside_the_ego_is_beside_it_where_that_leaves_over_its_way() -> None:
    road = {"kind": "roundabout", "lanes": 2, "ego_lane": 2}
    one = said("beside", "go-along", road=road, ego={"exit": 3, "speed": "28 km/h"}, side="right")
    episode = drive(build(one))
    assert isinstance(episode, Episode)
    assert episode.stepped.by == "native", episode.stepped.instead
    ego, other = episode.ego_track, next(track for track in episode.tracks if track.actor == "A")
    apart = np.hypot(other.x - ego.x, other.y - ego.y)
    leaves = int(np.argmax(np.unwrap(ego.heading)))  # it has turned left all the way round, and turns right from now on
    assert np.all(apart[: leaves + 1] < 8.0)
    assert leaves * episode.dt > 10.0


def test_each_shape_is_driven_alike_by_the_native_engine_and_the_embedded_one() -> None:
    for road, ego, start in (
        ({"kind": "mini-roundabout"}, {"exit": 4}, {"where": "roundabout-entry"}),
        ({"kind": "roundabout", "arms": 5, "diameter": "36 m"}, {"exit": 3}, {"where": "in-roundabout"}),
        ({"kind": "fork"}, {"route": "left-turn"}, {"where": "arm", "side": "right"}),
    ):
        one = {"id": "A", "kind": "car", "starts": start, "does": [{"act": "go-along"}]}
        built = build(from_plain({"others": [one], "road": road, "ego": {"speed": "25 km/h", **ego}}))
        native, embedded = drive(built), drive(built, "embedded")
        assert isinstance(native, Episode)
        assert isinstance(embedded, Episode)
        assert native.stepped.by == "native", native.stepped.instead
        assert differences(native, embedded) == []
