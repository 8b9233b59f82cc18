"""Places that only the region has are found for what was said: crosswalks at junctions, cycle lanes, rails, bays."""

from __future__ import annotations

from typing import Any

import pytest

from chatscene.build.build import Built, build
from chatscene.situations.form import from_plain

ON_FOOT = {"id": "A", "kind": "pedestrian", "does": [{"act": "cross"}]}
RIDER = {"id": "A", "kind": "bicycle", "starts": {"where": "beside", "side": "right"}, "does": [{"act": "go-straight"}]}
TRAM = {"id": "T", "kind": "tram", "role": "supporting", "starts": {"where": "ahead-beside", "side": "left"}}
LEAVES = {"id": "A", "kind": "pedestrian", "starts": {"where": "ahead-beside", "side": "left"}}


def made(*others: dict[str, Any], **facts: Any) -> Built:
    return build(from_plain({"others": list(others), **facts}))


@pytest.mark.parametrize(("where", "route"), [("crossing", "straight"), ("exit-crossing", "right-turn")])
def test_who_crosses_at_a_junction_does_so_on_a_crosswalk(where: str, route: str) -> None:
    at = ON_FOOT | {"starts": {"where": where, "side": "left"}}
    built = made(at, ego={"route": route}, road={"kind": "four-way", "control": "signal", "has": ["crosswalk"]})
    assert built.map == "region"
    assert "has=('crosswalks',)" in built.program.source
    assert not any("crosswalk" in line for line in built.assumed)
    assert built.left_out == ()
    [level] = [one for one in built.program.parameters if one.name == "OPT_A_Y"]
    assert (level.low, level.high) == (2.7, 5.3)


def test_a_cycle_lane_is_not_left_out_at_a_junction() -> None:
    built = made(RIDER, ego={"route": "right-turn"}, road={"control": "signal", "has": ["cycle-lane"]})
    assert "has=('cycle-lane',)" in built.program.source
    assert built.left_out == ()


def test_a_tram_stands_on_rails_beside_the_ego() -> None:
    stands, enters = {"does": [{"act": "stand"}]}, {"does": [{"act": "enter"}]}
    built = made(LEAVES | enters, TRAM | stands, road={"has": ["tram-track"]})
    assert "has=('tram-track',)" in built.program.source
    assert built.left_out == ()


@pytest.mark.parametrize("road", [{}, {"control": "signal"}])
def test_who_comes_along_rails_crosses_where_they_do_at_its_speed(road: dict[str, Any]) -> None:
    comes = {"id": "A", "kind": "tram", "starts": {"where": "arm", "side": "left"}, "does": [{"act": "cross"}]}
    built = made(comes, road={"kind": "rail-crossing", **road})
    assert "site='rail-crossing'" in built.program.source
    assert 'asideOf(egoRoute, levelA, "left"' in built.program.source
    assert "with speed 13.8889" in built.program.source
    assert any("the rail crossing has no lights" in line for line in built.assumed) == bool(road)


def test_in_a_car_park_one_stands_in_bays_and_comes_out_between_them() -> None:
    child = ON_FOOT | {"kind": "child", "starts": {"where": "roadside", "side": "right"}, "hidden_by": "P"}
    parked = {"id": "P", "kind": "car", "count": 2, "role": "hides", "starts": {"where": "kerb", "side": "right"}}
    built = made(child, parked | {"does": [{"act": "stand"}]}, road={"kind": "parking-lot", "has": ["parking-places"]})
    assert "has=('bays',)" in built.program.source
    assert built.program.source.count("facing crossingDirection(egoRoute, levelA") == 3
    assert "the ego drives at 10 km/h" in built.assumed
    assert built.left_out == ()


def test_an_ego_that_backs_in_a_car_park_leaves_a_bay() -> None:
    by = ON_FOOT | {"starts": {"where": "roadside", "side": "left"}}
    built = made(by, ego={"route": "reverse"}, road={"kind": "parking-lot"}, contact={"ego": "rear"})
    assert "begins='back-from-bay'" in built.program.source


def test_aisles_of_a_car_park_cross() -> None:
    comes = {"id": "A", "kind": "car", "starts": {"where": "arm", "side": "right"}, "does": [{"act": "go-straight"}]}
    built = made(comes, road={"kind": "parking-lot"})
    assert "has=('bays',)" in built.program.source
    assert "crossed=('right',)" in built.program.source


def test_who_stands_at_the_edge_of_a_car_park_backs_out_of_its_bay_across_the_way() -> None:
    backs = {"id": "A", "kind": "car", "starts": {"where": "kerb"}, "does": [{"act": "stand"}, {"act": "reverse"}]}
    built = build(from_plain({"road": {"kind": "parking-lot"}, "others": [backs]}))
    assert "crossingDirection" in built.program.source
    assert not built.left_out
