"""A place that was said is the place: along the road, across it, in a row, and on the side that was said."""

from __future__ import annotations

import re
from pathlib import Path
from typing import Any

import pytest
from test_towards import driven, track

import chatscene
from chatscene.build.build import build
from chatscene.errors import NotBuilt
from chatscene.situations.form import from_plain
from chatscene.terms.actors import LIMITS
from chatscene.terms.scene import CAR
from chatscene.terms.situation import Situation

LONG = LIMITS[CAR].length


def one(where: str, *does: Any, **more: Any) -> dict[str, Any]:
    start = {name: more.pop(name) for name in ("side", "distance", "speed", "facing", "lateral") if name in more}
    deeds = [{"act": deed} if isinstance(deed, str) else deed for deed in does]
    return {"id": "A", "kind": "car", "starts": {"where": where, **start}, "does": deeds} | more


def said(*others: dict[str, Any], ego: dict[str, Any] | None = None, **more: Any) -> Situation:
    return from_plain({"ego": {"speed": "50 km/h"} | (ego or {}), "others": list(others), **more})


def at(situation: Situation, name: str = "A") -> float:
    """How far ahead of the ego somebody is at first, along the road."""
    episode = driven(situation)
    ego, other = episode.ego_track, track(episode, name)
    return float(((other.x - ego.x) ** 2 + (other.y - ego.y) ** 2)[0] ** 0.5)


@pytest.mark.parametrize("where", ["ahead", "kerb"])
def test_an_ego_swings_out_where_somebody_was_said_to_stand(where: str) -> None:
    side = {"side": "right"} if where == "kerb" else {}
    stands = one(where, "stand", distance="40 m", role="supporting", **side)
    comes = one("oncoming", "go-along", id="B", kind="motorcycle")
    situation = said(stands, comes, ego={"speed": "30 km/h", "route": "bypass"})
    assert at(situation) == pytest.approx(40.0 + (LONG if where == "ahead" else 0.0), abs=1.0)


def test_nobody_stands_nearer_than_the_ego_can_swing_out() -> None:
    stands = one("ahead", "stand", distance="8 m", role="supporting")
    comes = one("oncoming", "go-along", id="B", kind="motorcycle")
    with pytest.raises(NotBuilt, match=r"A\.starts\.distance: 8 m: the ego swings out round who is"):
        build(said(stands, comes, ego={"speed": "30 km/h", "route": "bypass"}))


def test_rails_that_are_elsewhere_than_was_said_are_refused_with_where_they_are() -> None:
    tram = one("crossing", "cross", kind="tram", side="right", distance="30 m")
    with pytest.raises(NotBuilt, match=r"A\.starts\.distance: 30 m: the rails are"):
        build(said(tram, road={"kind": "rail-crossing"}))


def test_who_comes_from_a_ramp_begins_as_far_ahead_as_was_said() -> None:
    truck = one("on-ramp", "merge", kind="truck", distance="20 m", speed="50 km/h")
    source = build(said(truck, ego={"speed": "110 km/h"})).program.source
    assert "egoRoute.eventAt" not in re.findall(r"^A = .*$", source, re.MULTILINE)[0]


def test_a_bus_is_no_farther_than_a_road_leads_up_to_its_bay() -> None:
    bus = one("bus-bay", "stand", "pull-out", kind="bus", distance="400 m")
    with pytest.raises(NotBuilt, match=r"A\.starts\.distance: 400 m: say \d+ m, and a place is found"):
        build(said(bus, map="outskirts"))
    assert build(said(bus)).map == "road:1+1,bus-bay,length=2700"


def test_those_who_come_side_by_side_are_apart_by_how_wide_they_are() -> None:
    cars = one("driveway", "cross", side="right", count=2)
    episode = driven(said(cars))
    first, second = track(episode, "A"), track(episode, "A-2")
    assert ((first.x - second.x) ** 2 + (first.y - second.y) ** 2)[0] ** 0.5 > first.width


@pytest.mark.parametrize("where", ["kerb", "bus-bay"])
def test_a_row_beside_the_lane_begins_where_it_was_said_and_goes_on_from_there(where: str) -> None:
    bus = {"kind": "bus"} if where == "bus-bay" else {"distance": "20 m", "side": "right"}
    source = build(said(one(where, "stand", "pull-out", count=3, **bus))).program.source
    places = re.findall(r"^A(?:_\d)? = new \w+ at pointOn\(wayA, (.*?)\), facing", source, re.MULTILINE)
    assert len(places) == 3 and not re.search(r"- \d", "".join(places)) and re.search(r"\+ [\d.]+$", places[2])


def test_who_stands_at_the_left_kerb_is_not_placed_in_our_lane() -> None:
    with pytest.raises(NotBuilt, match=r"others\.A\.starts\.lateral\.edge"):
        build(said(one("kerb", "stand", side="left", lateral={"edge": "0.5 m"})))


def test_who_changes_lanes_and_back_steers_back() -> None:
    changes = [{"act": "lane-change", "to": side, "time": "4 s"} for side in ("left", "right")]
    source = build(said(one("ahead", *changes), ego={"speed": "110 km/h"}, road={"kind": "motorway"})).program.source
    back = re.findall(r"DrivePath\(ownLane\(egoRoute\), .*?, (-?[\d.]+)\) for", source)
    assert float(back[0]) > 3.0 and all(float(aside) >= 0.0 for aside in back)


def test_who_passes_on_the_right_leaves_the_room_on_the_egos_side() -> None:
    passes = {"act": "overtake", "lateral": {"clearance": "1 m"}}
    road = {"lanes": 2, "ego_lane": 2, "two_way": True}
    source = build(said(one("behind", passes, kind="motorcycle"), road=road)).program.source
    asides = re.findall(r"besideA\.offset\((-?[\d.]+)\)", source)
    assert asides and all(float(aside) > 0.0 for aside in asides)


LEAD = one("ahead", "brake")
NOTHING = [
    ("others.A.does.0.speed", LEAD | {"does": [{"act": act, "speed": "0 km/h"}]}, {})
    for act in ("slow-down", "brake", "go-along")
] + [
    ("others.A.does.0.time", LEAD | {"does": [{"act": "brake", "time": "0 s"}]}, {}),
    ("others.A.does.0.distance", LEAD | {"does": [{"act": "stop", "distance": "0 m"}]}, {}),
    ("others.A.does.0.acceleration", LEAD | {"does": [{"act": "brake", "acceleration": "at most 0 m/s²"}]}, {}),
    ("others.A.does.0.when.ego_within", LEAD | {"does": [{"act": "brake", "when": {"ego_within": "0 m"}}]}, {}),
    ("ego.speed", LEAD, {"ego": {"speed": "0 km/h"}}),
    ("road.speed_limit", LEAD, {"road": {"speed_limit": "0 km/h"}, "ego": {}}),
    ("ego.does.0.speed", LEAD, {"ego": {"speed": "50 km/h", "does": [{"act": "accelerate", "speed": "0 km/h"}]}}),
]  # fmt: skip


@pytest.mark.parametrize(("path", "other", "more"), NOTHING)
def test_a_number_that_is_0_where_that_is_nothing_is_refused_by_its_path(
    path: str, other: dict[str, Any], more: dict[str, Any]
) -> None:
    with pytest.raises(NotBuilt, match=f"impossible: {re.escape(path)}: (?:at most )?0 "):
        build(from_plain({"others": [other], **more}))


def test_who_was_said_to_have_no_speed_at_first_stands_and_two_may_have_no_room_between_them() -> None:
    assert "Park()" in build(said(one("ahead", "accelerate", speed="0 km/h"))).program.source
    assert build(said(one("behind", {"act": "tailgate", "distance": "0 m"})))


def test_no_run_is_begun_of_an_ego_at_no_speed(tmp_path: Path) -> None:
    with pytest.raises(NotBuilt, match=r"impossible: ego\.speed: 0 km/h"):
        chatscene.run("The car ahead brakes hard.", tmp_path / "run", speed=0.0)
