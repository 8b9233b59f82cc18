"""A refusal names what was written, and where it would be built."""

from __future__ import annotations

from typing import Any

import pytest

from chatscene.build.build import build
from chatscene.errors import NotBuilt
from chatscene.mcp.words import explained
from chatscene.situations.form import from_plain
from chatscene.terms.lateral import LATERAL_OF_STARTS, PLACED, PLACED_BEYOND
from chatscene.terms.vocabulary import Where


def someone(where: str, *acts: str, kind: str = "car", ego: dict[str, Any] | None = None, **start: Any) -> Any:
    does = [{"act": act} for act in acts]
    one = {"id": "A", "kind": kind, "starts": {"where": where, **start}, "does": does}
    return {"ego": ego or {}, "others": [one]}


@pytest.mark.parametrize("where", ["ahead"])
def test_a_place_that_an_ego_takes_otherwise_as_it_backs_is_refused_as_it_was_written(where: str) -> None:
    backs = {"kind": "van", "route": "reverse", "speed": "8 km/h"}
    with pytest.raises(NotBuilt, match=rf"others\.A\.starts\.where: {where}\b") as refused:
        build(from_plain(someone(where, "stand", kind="child", ego=backs, distance="3 m")))
    assert "oncoming" not in str(refused.value)


@pytest.mark.parametrize("where", sorted(PLACED))
def test_who_is_where_lateral_is_said_to_be_built_is_built_there(where: Where) -> None:
    side: dict[str, Any] = {"side": "right" if where is Where.KERB else "left"} if where.row.sided else {}
    act = "stand" if where is Where.KERB else "go-along"
    middle = build(from_plain(someone(where, act, **side))).program.source
    for lateral in ({"edge": "0.8 m"}, {"overlap": "50 %"}):
        said = someone(where, act, lateral={"side": "right", **lateral}, **side)
        assert build(from_plain(said)).program.source != middle


@pytest.mark.parametrize("where", sorted(PLACED_BEYOND))
def test_who_is_beside_the_road_is_as_far_beyond_the_lanes_as_was_said(where: Where) -> None:
    turns = {"route": "left-turn"} if where is Where.EXIT_CROSSING else {}
    how: dict[str, Any] = {"kind": "pedestrian", "ego": turns, "side": "right"}
    usual = build(from_plain(someone(where, "cross", **how))).program.source
    assert build(from_plain(someone(where, "cross", **how, lateral={"beyond": "2 m"}))).program.source != usual


def test_a_place_across_the_road_that_is_not_built_is_refused_with_where_it_is() -> None:
    said = someone("roadside", "cross", kind="child", side="right", lateral={"edge": "1 m"})
    with pytest.raises(NotBuilt) as refused:
        build(from_plain(said))
    assert str(refused.value) == f"cannot be built yet: others.A.starts.lateral.edge: 1 m; {LATERAL_OF_STARTS}"
    assert LATERAL_OF_STARTS in explained("Lateral")
    assert LATERAL_OF_STARTS in explained("others.A.starts.lateral")


def test_who_hides_somebody_is_refused_across_the_road_with_that_reason() -> None:
    said = someone("roadside", "cross", kind="child", side="left")
    said["others"][0]["hidden_by"] = "B"
    parked = {"where": "kerb", "side": "left", "lateral": {"overlap": "50 %"}}
    said["others"].append({"id": "B", "kind": "truck", "role": "hides", "starts": parked, "does": [{"act": "stand"}]})
    with pytest.raises(NotBuilt, match=r"not for B, which hides a road user$"):
        build(from_plain(said))


LANES = {"kind": "junction", "control": "signal", "ego_light": "turns-green", "lanes": 7, "ego_lane": 2}


def test_a_place_that_no_map_has_is_refused_with_the_one_fact_to_leave_out() -> None:
    said = someone("arm", "go-straight", side="left") | {"road": LANES}
    with pytest.raises(NotBuilt) as refused:
        build(from_plain(said))
    told = str(refused.value)
    assert told.count("map 'town' has no place") == 1
    assert told.endswith("; leave out road.lanes: 7, and a place is found")
    assert len(told) < 600
    less = LANES | {"lanes": None}
    assert build(from_plain(said | {"road": {name: value for name, value in less.items() if value is not None}}))


def test_where_no_single_fact_lets_a_place_be_found_that_is_said() -> None:
    said = someone("ahead", "brake") | {"road": {"kind": "roundabout", "lanes": 7, "ego_lane": 6}}
    with pytest.raises(NotBuilt, match="leaving out one fact of the road is not enough"):
        build(from_plain(said))


def test_a_map_that_has_such_a_road_is_told_before_those_that_have_none() -> None:
    lorry = {
        "id": "A",
        "kind": "truck",
        "starts": {"where": "beside", "side": "right"},
        "does": [{"act": "keep-level"}],
    }
    with pytest.raises(NotBuilt) as refused:
        build(
            from_plain({"ego": {"route": "merge", "speed": "30 km/h"}, "road": {"kind": "motorway"}, "others": [lorry]})
        )
    assert "no lane of the ego's direction lies to its right" in str(refused.value)
    assert "name no map" not in str(refused.value)  # none was named


@pytest.mark.parametrize("kind", ["child", "dog"])
@pytest.mark.parametrize("before", [(), ("go-along",)])
def test_who_walks_is_not_told_to_back_up_as_who_drives_is(kind: str, before: tuple[str, ...]) -> None:
    with pytest.raises(NotBuilt, match=r"reverse, .*who walks does not go backwards; say turn-back"):
        build(from_plain(someone("ahead", *before, "reverse", kind=kind)))
