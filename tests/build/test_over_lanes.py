"""Who changes lanes away from ours or over several, who opens a door in a lane, and who alone has a stop sign."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import numpy as np
import pytest
from test_building import drive

from chatscene.build.build import build
from chatscene.build.over_lanes import lane_after
from chatscene.errors import NotBuilt
from chatscene.situations.form import from_plain
from chatscene.terms.episode import Episode, Track

STANDS, OPENS = {"act": "stand"}, {"act": "open-door"}


def said(where: str, *does: dict[str, Any], side: str | None = None, **more: Any) -> dict[str, Any]:
    starts = {"where": where} | ({"side": side} if side else {})
    return {"others": [{"id": "A", "kind": "car", "starts": starts, "does": list(does)}], **more}


def driven(plain: dict[str, Any]) -> dict[str, Track]:
    episode = drive(build(from_plain(plain)), seed=1, ego="idm")
    assert isinstance(episode, Episode), episode
    return {one.actor: one for one in episode.tracks}


def to_left(tracks: dict[str, Track], name: str) -> np.ndarray[Any, np.dtype[np.float64]]:
    """How far [m] somebody is to the left of where the ego began, as that faced."""
    ego, one = tracks["ego"], tracks[name]
    cos, sin = np.cos(ego.heading[0]), np.sin(ego.heading[0])
    return -(one.x - ego.x[0]) * sin + (one.y - ego.y[0]) * cos


def change(to: str) -> dict[str, Any]:
    return {"act": "lane-change", "to": to}


MOTORWAY = {"kind": "motorway"}


@pytest.mark.parametrize(
    ("where", "side", "does", "lanes"),
    [
        ("ahead-beside", "left", [change("left")], [1, 2]),
        ("ahead-beside", "left", [{"act": "cut-in", "to": "right"}, change("right")], [1, 0, -1]),
        ("ahead", None, [change("right"), change("right")], [0, -1, -2]),
        ("ahead-beside", "right", [{"act": "lane-change"}], [-1, 0]),
    ],
    ids=["away from ours", "over ours", "over two", "into ours"],
)
def test_who_changes_lanes_is_in_one_after_the_other(
    where: str, side: str | None, does: list[dict[str, Any]], lanes: list[int]
) -> None:
    plain = said(where, *does, side=side, road=MOTORWAY)
    one = from_plain(plain).others[0]
    assert [lane_after(one, one.does, k) for k in range(len(does))] == lanes[1:]
    aside = to_left(driven(plain), "A")
    assert abs(aside[0] - 3.5 * lanes[0]) < 1.0
    for lane in lanes:
        assert np.abs(aside - 3.5 * lane).min() < 1.0


@pytest.mark.parametrize(
    ("where", "side", "ego"),
    [("ahead-beside", "left", {}), ("ahead-beside", "right", {}), ("oncoming", None, {}), ("ahead", None, "bypass")],
)
def test_a_door_opens_into_our_way_of_who_stands_in_a_lane(where: str, side: str | None, ego: Any) -> None:
    route = {"route": ego} if ego else {}
    tracks = driven(said(where, STANDS, OPENS, side=side, ego=route))
    door, car = to_left(tracks, "A-door"), to_left(tracks, "A")
    toward = 1.0 if where == "ahead" else -np.sign(car[0])  # an ego that swings out passes on the left
    assert abs(door[-1] - door[0]) > 0.5
    assert np.sign(door[-1] - car[0]) == toward


def test_a_door_of_who_drives_is_refused() -> None:
    with pytest.raises(NotBuilt, match="open-door, except by a vehicle"):
        build(from_plain(said("ahead-beside", {"act": "go-along"}, OPENS, side="left")))


def test_where_only_others_have_a_stop_sign_the_ego_has_none() -> None:
    breaks = {"act": "go-straight", "breaks": "stop-sign"}
    plain = said("arm", breaks, side="right")
    for where, shown in ((None, True), ("town", False)):
        built = build(from_plain(plain | ({"map": where} if where else {})))
        assert "control='none'" in built.program.source
        assert any("the others' stop sign is not shown" in one for one in built.assumed) is not shown
        assert ("signs=side-stop" in built.map) is shown
    assert from_plain(plain | {"road": {"control": "none"}}).others[0].does[0].breaks == "stop-sign"
    waits = plain | {"ego": {"does": [{"act": "stand"}, {"act": "set-off"}]}}
    assert "control='stop-sign'" in build(from_plain(waits)).program.source


def test_two_beside_each_other_in_a_roundabout_are_refused_by_its_one_lane() -> None:
    told = said("beside", {"act": "go-along"}, side="left", ego={"route": "roundabout"})
    with pytest.raises(NotBuilt, match=r"no place for .* a lane of the ego's direction to its left, the roundabout"):
        build(from_plain(told | {"map": "outskirts"}))


@pytest.mark.parametrize("side", ["left", "right"])
def test_where_it_has_two_they_go_round_beside_each_other(side: str) -> None:
    built = build(from_plain(said("beside", {"act": "go-along"}, side=side, ego={"route": "roundabout"})))
    assert Path(built.map).stem == "region"


def test_past_an_on_ramp_the_lane_that_comes_from_it_is_not_counted() -> None:
    road = {"kind": "motorway", "ego_lane": 1, "has": ["on-ramp"]}
    built = build(from_plain(said("on-ramp", {"act": "merge"}, road=road)))
    assert "lane=2" in built.program.source
    assert not built.left_out


def test_who_joins_slower_than_the_ego_has_a_start_and_is_met() -> None:
    plain = said("on-ramp", {"act": "merge"}, road={"kind": "motorway"}, ego={"speed": "110 km/h"})
    plain["others"][0]["starts"]["speed"] = "60 km/h"
    tracks = driven(plain)
    ego, other = tracks["ego"], tracks["A"]
    steps = min(len(ego.x), len(other.x))
    assert np.hypot(ego.x[:steps] - other.x[:steps], ego.y[:steps] - other.y[:steps]).min() < 15.0


def test_who_overtakes_in_a_roundabout_does_so_where_that_has_two_lanes() -> None:
    built = build(from_plain(said("behind", {"act": "overtake"}, ego={"route": "roundabout"})))
    assert Path(built.map).stem == "region"
    assert not built.left_out
