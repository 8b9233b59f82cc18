"""What deeds wait for and how they are done there, each kind by one toy: an ego that changes lanes late, who yields."""

from __future__ import annotations

from typing import Any

import pytest
from test_in_time import deed, unseen
from test_towards import car, others

from chatscene.build.build import build
from chatscene.errors import NotBuilt
from chatscene.terms.situation import Situation


def after(act: dict[str, Any], what: str) -> dict[str, Any]:
    return act | {"when": {"after": what}}


_ROUND = deed("u-turn")
_WAITS = {
    "another has turned round": others(car("A", "ahead", after(deed("brake"), "B.0")), car("B", "oncoming", _ROUND)),
    "another comes on from the first": others(
        car("A", "ahead", after(deed("stop"), "B.0")), car("B", "oncoming-in-our-lane", deed("go-along"))
    ),
}
_THERE = {
    "somebody on foot stops, lets another by and steps back": others(
        car("A", "roadside", deed("cross"), deed("stop"), deed("yield", whom="B"), deed("reverse"), kind="pedestrian"),
        car("B", "oncoming", deed("go-along")),
        road={"kind": "road", "two_way": True},
    ),
    "the ego changes lanes once it was passed": others(
        car("A", "ahead", deed("go-along"), kind="truck", speed="10 km/h"),
        car("B", "beside", deed("overtake", whom="ego"), side="left"),
        ego={
            "speed": "60 km/h",
            "route": "lane-change-left",
            "does": [deed("slow-down"), after(deed("lane-change", to="left"), "B.0")],
        },
        road={"kind": "motorway"},
    ),
    "the ego lets another by and changes back": others(
        car("A", "behind", after(deed("overtake", whom="ego"), "ego.0"), kind="emergency-vehicle"),
        ego={
            "route": "lane-change-right",
            "does": [deed("lane-change", to="right"), after(deed("lane-change", to="left"), "A.0")],
        },
    ),
    "nobody touches who comes up behind": others(
        car("A", "roadside", deed("cross"), kind="child"),
        car("D", "behind", deed("go-along")),
        contact={"whom": "D", "happens": False},
    ),
}


@pytest.mark.parametrize("said", _WAITS.values(), ids=_WAITS)
def test_a_deed_waits_for_whatever_is_seen_of_another(said: Situation) -> None:
    assert "until" in build(said).program.source
    assert unseen(said) == ()


@pytest.mark.parametrize("said", _THERE.values(), ids=_THERE)
def test_a_deed_is_done_as_it_can_be_from_there(said: Situation) -> None:
    assert unseen(said) == ()


def test_an_ego_that_slows_down_by_a_number_once_another_comes_in_does_so_by_that_number() -> None:
    slows = after(deed("slow-down", acceleration="1 m/s²"), "A.0")
    ego = {"kind": "truck", "speed": "80 km/h", "does": [slows]}
    said = others(car("A", "behind-beside", deed("cut-in"), side="left", speed="90 km/h"), ego=ego)
    source = build(said).program.source
    assert "braking=1, whom='A', phase=" in source


def test_the_way_within_which_the_ego_changes_lanes_late_is_no_way_to_the_side() -> None:
    within = [deed("lane-change", to="right", distance="30 m"), after(deed("lane-change", to="left"), "A.0")]
    said = others(car("A", "behind", deed("overtake")), ego={"speed": "50 km/h", "does": within})
    with pytest.raises(NotBuilt, match=r"ego\.does\.0\.distance: 30 m: at its speed the ego is in the next lane after"):
        build(said)


def test_who_goes_on_from_the_first_where_it_was_said_to_be_starts_there() -> None:
    aside: dict[str, Any] = deed("go-along") | {"lateral": {"side": "right", "edge": "0.3 m"}}
    assert unseen(others(car("A", "ahead", aside, kind="bicycle"))) == ()


def test_no_ego_that_overtakes_on_a_divided_road_meets_somebody_who_drives_backwards() -> None:
    ego = {"speed": "110 km/h", "route": "overtake"}
    road = {"kind": "motorway", "lanes": 2, "ego_lane": 2, "has": ["median"]}
    wrong_way = car("A", "oncoming-in-our-lane", deed("go-along"), facing="against")
    source = build(others(wrong_way, car("B", "beside", deed("go-along"), side="right"), ego=ego, road=road)).program
    assert "speed -" not in source.source
