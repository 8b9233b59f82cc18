"""What was said of the road, and of who is there, is looked for on every map before it is told as missing."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest
from test_building import drive, simulator

from chatscene.build.build import Built, build
from chatscene.situations.form import from_plain
from chatscene.terms.episode import Episode
from chatscene.terms.vocabulary import UserKind

CROSSES = {"id": "A", "kind": "child", "starts": {"where": "roadside", "side": "right"}, "does": [{"act": "cross"}]}
COMES = {"id": "A", "kind": "tractor", "starts": {"where": "arm", "side": "right"}, "does": [{"act": "turn-right"}]}


def made(*others: dict[str, Any], **facts: Any) -> Built:
    return build(from_plain({"others": list(others), **facts}))


@pytest.mark.parametrize("kind", [kind for kind in UserKind if not kind.row.general])
def test_every_kind_that_says_what_it_is_is_built_as_that(kind: UserKind) -> None:
    stands = {"id": "A", "kind": kind.value, "starts": {"where": "ahead"}, "does": [{"act": "stand"}]}
    built = made(stands)
    assert f"new {kind.scenic} at" in built.program.source
    assert not any(str(kind) in line for line in built.assumed)


def test_bodies_that_were_another_s_differ_from_it() -> None:
    for kind in (UserKind.VAN, UserKind.CHILD, UserKind.TRACTOR, UserKind.TRAM):
        body = kind.row.body
        assert body.heard_as is body.acts_as is not body
        assert body.row.limits != body.acts_as.row.limits
        assert body.row.height != body.acts_as.row.height or kind is UserKind.TRAM


@pytest.mark.parametrize(
    ("road", "asked"),
    [
        ({"has": ["crosswalk"]}, "site='crosswalk'"),
        ({"has": ["crosswalk"], "control": "none"}, "site='crosswalk'"),
        ({"has": ["parking-places"]}, "site='parking'"),
        ({"setting": "rural"}, "site='rural'"),
    ],
)
def test_what_one_map_has_is_not_left_out_since_another_is_asked_first(road: dict[str, Any], asked: str) -> None:
    built = made(CROSSES, road=road)
    assert asked in built.program.source
    assert built.left_out == ()


def test_who_crosses_at_a_crosswalk_that_no_map_has_is_told() -> None:
    there = CROSSES | {"starts": {"where": "exit-crossing", "side": "right"}}
    assert any(
        "where the map has no crosswalk" in line for line in made(there, ego={"route": "left-turn"}, map="town").assumed
    )


def test_who_comes_from_a_side_where_no_junction_was_named_comes_out_of_a_way_without_lights() -> None:
    built = made(COMES)
    assert "place='three-way'" in built.program.source
    assert "control='none'" in built.program.source
    named = made(COMES, road={"kind": "junction", "control": "signal"})
    assert "control='signal'" in named.program.source


def test_a_bus_stop_is_a_shelter_once_and_parked_cars_are_a_row() -> None:
    source = made(CROSSES, road={"has": ["bus-stop", "parked-cars"]}).program.source
    assert source.count("new BusStop at") == 1
    assert source.count("new Car at besideRoad") == 3
    shelter = {"id": "B", "kind": "bus-shelter", "role": "hides", "starts": {"where": "roadside"}}
    hidden = CROSSES | {"hidden_by": "B"}
    assert made(hidden, shelter, road={"has": ["bus-stop"]}).program.source.count("new BusStop at") == 1


@pytest.mark.parametrize(("feature", "cones"), [("school", 0), ("roadworks", 10), ("closed-lane", 10)])
def test_a_sign_stands_before_who_is_met_and_cones_at_roadworks(feature: str, cones: int) -> None:
    built = made(CROSSES, road={"has": [feature]})
    assert built.left_out == ()
    assert any(line.startswith(f"{feature}: a sign") for line in built.assumed)
    lines = [line for line in built.program.source.splitlines() if "with role 'background'" in line]
    assert sum("new WarningSign" in line for line in lines) == 1
    assert sum("new Cone" in line for line in lines) == cones


def _cones_of(built: Built) -> list[str]:
    lines = (one for one in built.program.source.splitlines() if "new Cone" in one)
    return [one.partition(" at ")[2].partition(", facing")[0] for one in lines]


def test_cones_of_roadworks_narrow_the_ego_s_side_beyond_who_comes_from_there() -> None:
    beyond = _cones_of(made(CROSSES, road={"has": ["roadworks"]}))
    assert all('"right"' in one for one in beyond)
    assert [one.rpartition(" ")[2] for one in (beyond[0], beyond[4], beyond[-1])] == ["2.5)", "0.3)", "0.3)"]
    assert " + 5, " in beyond[0]
    from_left = made(CROSSES | {"starts": {"where": "roadside", "side": "left"}}, road={"has": ["roadworks"]})
    assert " - 15, " in _cones_of(from_left)[0]


def test_an_ego_that_stands_at_roadworks_stands_in_the_lane_that_they_close_and_is_passed_beside_it() -> None:
    passes = {"id": "A", "kind": "truck", "starts": {"where": "behind"}, "does": [{"act": "overtake", "to": "right"}]}
    built = made(passes, ego={"kind": "truck", "does": [{"act": "stand"}]}, road={"has": ["roadworks"]})
    assert all(one.startswith("pointOn(egoRoute, ") and one.endswith(", -1.55)") for one in _cones_of(built))
    assert "DrivePath(ownLane(egoRoute)" not in built.program.source


def test_a_lane_that_is_closed_has_a_taper_over_it_beyond_who_is_met() -> None:
    built = made(PASSES, ego={"speed": "50 km/h"}, road={"has": ["closed-lane"], "lanes": 2})
    aside = [float(one.rpartition(", ")[2].rstrip(")")) for one in _cones_of(built)]
    assert aside[0] == -1.55
    assert aside == sorted(aside)
    assert aside[4:] == [1.55] * 6
    assert "DrivePath(ownLane(egoRoute)" not in built.program.source


STOP = {"has": ["bus-stop"]}
PASSES = {"id": "A", "kind": "car", "starts": {"where": "behind-beside", "side": "left"}, "does": [{"act": "overtake"}]}


def _stop_of(built: Built) -> str:
    (line,) = (one for one in built.program.source.splitlines() if "new BusStop" in one)
    return line.partition("besideRoad(")[2].partition(")")[0]


def test_a_bus_that_leaves_a_stop_leaves_it_from_beside_itself() -> None:
    ego = {"kind": "bus", "does": [{"act": "stand"}, {"act": "set-off"}]}
    assert _stop_of(made(PASSES, ego=ego, road=STOP)) == 'egoRoute, 2.875, "right", 3.6'


def test_a_bus_that_comes_to_a_stop_has_it_on_its_own_side() -> None:
    stop = _stop_of(made(CROSSES | {"starts": {"where": "roadside", "side": "left"}}, ego={"kind": "bus"}, road=STOP))
    assert '"right"' in stop


def test_who_passes_the_ego_and_halts_does_so_at_the_bus_stop() -> None:
    halts = PASSES | {"does": [{"act": "overtake"}, {"act": "cut-in"}, {"act": "stop"}]}
    built = made(halts, ego={"kind": "bus", "speed": "20 km/h"}, road=STOP)
    place, _, beyond = _stop_of(built).removeprefix("egoRoute, ").partition(" + 1.2")
    assert f"brakingDistance(self) / globalParameters.OPT_A_BRAKE > {place}" in built.program.source
    assert '"right"' in beyond


def test_who_halts_before_the_ego_does_so_at_the_line_where_the_road_has_one() -> None:
    stops = {"id": "A", "kind": "car", "starts": {"where": "ahead"}, "does": [{"act": "stop"}]}
    line = "OPT_A_BRAKE > egoRoute.eventAt - "
    lights = {"control": "signal", "ego_light": "yellow"}
    assert line in made(stops, road=lights).program.source
    assert line not in made(stops, road=lights | {"ego_light": "green"}).program.source
    assert line not in made(stops).program.source


def test_who_stands_before_the_ego_stands_before_the_rails() -> None:
    tram = {"id": "A", "kind": "tram", "starts": {"where": "arm", "side": "left"}, "does": [{"act": "cross"}]}
    rider = {"id": "B", "kind": "bicycle", "role": "supporting", "starts": {"where": "ahead"}}
    built = made(tram, rider | {"does": [{"act": "stand"}]}, road={"kind": "rail-crossing", "has": ["tram-track"]})
    assert not built.left_out
    assert not any("driveway" in one for one in built.assumed)
    episode = drive(built, seed=1)
    assert isinstance(episode, Episode)
    route = simulator(built.map, "native").route(built.program, 0)
    (there,) = (one for one in episode.tracks if one.actor == "B")
    nose = route.line.along(there.x, there.y)[0] + 0.5 * there.length
    assert -4.0 < nose - route.event_at < -2.0


@pytest.mark.parametrize(("turn", "aside"), [("turn-left", 3.5), ("turn-right", 0.0)])
def test_who_turns_out_of_a_driveway_comes_into_the_lane_that_it_turns_to(turn: str, aside: float) -> None:
    out = {"id": "A", "kind": "car", "starts": {"where": "driveway", "side": "right"}, "does": [{"act": turn}]}
    built = made(out, ego={"speed": "50 km/h"})
    assert built.lacking == built.left_out == ()
    episode = drive(built, seed=1, ego="idm")
    assert isinstance(episode, Episode)
    route = simulator(built.map, "native").route(built.program, 0)
    (one,) = (track for track in episode.tracks if track.actor == "A")
    lateral = [route.line.project(x, y)[1] for x, y in zip(one.x, one.y, strict=True)]
    assert lateral[0] < -1.75 - 0.5 * one.length - 3.0  # well inside
    assert lateral[-1] == pytest.approx(aside, abs=0.6)


def test_nobody_in_a_driveway_begins_with_its_nose_in_the_lane() -> None:
    out = {"id": "A", "kind": "truck", "starts": {"where": "driveway", "side": "right"}, "does": [{"act": "enter"}]}
    (least,) = (one.low for one in made(out).program.parameters if one.name == "OPT_A_X")
    assert least > 0.5 * UserKind.TRUCK.row.body.row.limits.length


def test_who_backs_out_of_a_bay_of_a_car_park_stands_all_in_it() -> None:
    out = {"id": "A", "kind": "car", "starts": {"where": "driveway", "side": "right"}, "does": [{"act": "reverse"}]}
    built = made(out, ego={"speed": "10 km/h"}, road={"kind": "parking-lot"})
    (x,) = (one for one in built.program.parameters if one.name == "OPT_A_X")
    assert x.low - 0.5 * UserKind.CAR.row.body.row.limits.length == pytest.approx(0.1)
    assert x.high < 3.0


def test_a_hedge_that_hides_who_comes_out_of_a_driveway_stands_along_that() -> None:
    out = {"id": "A", "kind": "truck", "starts": {"where": "driveway", "side": "right"}, "hidden_by": "B"}
    hedge = {"id": "B", "kind": "hedge", "role": "hides", "starts": {"where": "roadside", "side": "right"}}
    signed = {"has": ["driveway"], "control": "priority"}
    built = made(out | {"does": [{"act": "enter"}]}, hedge, road=signed)
    assert "driveway=right" in built.map
    (line,) = (one for one in built.program.source.splitlines() if "new Hedge" in one)
    assert "facing crossingDirection(egoRoute, levelA - 2.25" in line


def test_who_turns_round_from_the_opposite_kerb_comes_over_both_lanes_into_the_ego_s() -> None:
    turns = {"id": "A", "kind": "car", "starts": {"where": "kerb", "side": "left"}}
    built = made(turns | {"does": [{"act": "stand"}, {"act": "u-turn"}]}, ego={"speed": "35 km/h"})
    episode = drive(built, seed=1)
    assert isinstance(episode, Episode)
    route = simulator(built.map, "native").route(built.program, 0)
    (one,) = (track for track in episode.tracks if track.actor == "A")
    turned = np.abs(np.remainder(one.heading - route.line.heading_at(0.0) + np.pi, 2 * np.pi) - np.pi)
    assert turned[0] > 3.0
    assert turned[-1] < 0.3
    assert route.line.project(float(one.x[0]), float(one.y[0]))[1] > 4.5
    assert abs(route.line.project(float(one.x[-1]), float(one.y[-1]))[1]) < 0.5


def test_who_comes_the_wrong_way_along_the_divider_meets_an_ego_in_the_lane_beside_it() -> None:
    start = {"where": "oncoming-in-our-lane"}
    comes = {"id": "A", "kind": "auto-rickshaw", "does": [{"act": "go-along"}]}
    along = comes | {"starts": {**start, "lateral": {"side": "left"}}}
    assert "lane=-1" in made(along, road={"has": ["median"]}).program.source
    assert "lane=-1" not in made(comes | {"starts": start}, road={"has": ["median"]}).program.source


def test_a_bend_with_room_for_one_is_laid_for_two_who_meet_in_it() -> None:
    comes = {"id": "A", "kind": "car", "starts": {"where": "oncoming-in-our-lane"}, "does": [{"act": "go-along"}]}
    built = made(comes, road={"kind": "curve", "has": ["narrow"]})
    assert built.map.startswith("road:1+0,lane=3.2,")
    assert built.left_out == ()


def test_hedges_beside_a_road_stand_in_a_row_along_it() -> None:
    hedge = {"id": "B", "kind": "hedge", "count": 2, "role": "hides", "starts": {"where": "roadside", "side": "left"}}
    source = made(CROSSES, hedge).program.source
    lines = [one for one in source.splitlines() if "new Hedge" in one]
    assert len(lines) == 2
    assert all("facing directionOn(egoRoute" in one for one in lines)
    assert "levelB + -5.7" in lines[1]


def test_a_bus_stop_is_where_a_bus_stands_or_stops_on_its_own_side() -> None:
    bus = {"id": "B", "kind": "bus", "role": "supporting"}
    stands = bus | {"starts": {"where": "oncoming"}, "does": [{"act": "stand"}]}
    assert _stop_of(made(CROSSES, stands, road=STOP)).endswith('OPT_B_Y - 2.875, "left", 3.6')
    stops = bus | {"starts": {"where": "ahead"}, "does": [{"act": "stop"}]}
    assert _stop_of(made(PASSES, stops, road=STOP)).startswith("egoRoute, egoRoute.eventAt + globalParameters.OPT_B_Y")
    assert _stop_of(made(CROSSES, road=STOP)).endswith('+ 5, "right", 3.6')
