"""Ways off a road and out of a driveway lie where the road has them, and begin and end in lanes."""

from __future__ import annotations

import math

import pytest

from chatscene.errors import MapError
from chatscene.maps.loading import load_roads
from chatscene.maps.network import resolve_map
from chatscene.maps.ways_off import turns_at, way_off, ways_out
from chatscene.terms.scenario import Maneuver
from chatscene.world.ego_route import EgoRoute, choose_route
from chatscene.world.places import outOfDriveway, wayOff


def route_on(name: str, **query: object) -> EgoRoute:
    path = str(resolve_map(name))
    return choose_route(load_roads(path), path, 0, **{"maneuver": "straight", **query})  # type: ignore[arg-type]


@pytest.mark.parametrize(("side", "sign"), [("right", -1.0), ("left", 1.0)])
def test_a_way_into_a_driveway_follows_the_lane_and_ends_inside(side: str, sign: float) -> None:
    site = "driveway" if side == "right" else "driveway-left"
    route = route_on(f"road:1+1,driveway={side}", site=site)
    way = wayOff(route, side)
    begins = turns_at(route.network, route.route, side)
    assert begins is not None
    assert all(abs(route.line.project(*way.point_at(s))[1]) < 0.1 for s in range(int(begins)))
    along, aside, _ = route.line.project(*way.point_at(way.length))
    assert 0.0 < along - route.eventAt < 5.0
    assert sign * aside > 15.0
    assert way_off(route.network, route.route, "left" if side == "right" else "right") is None


def test_who_comes_out_of_a_driveway_on_the_right_turns_into_either_lane() -> None:
    route = route_on("road:1+1,driveway=right", site="driveway")
    ways = {way.turn: way for way in outOfDriveway(route, "right")}
    assert set(ways) == {Maneuver.LEFT_TURN, Maneuver.RIGHT_TURN}
    ends = {turn: route.line.project(*way.line.point_at(way.entry + 40.0)) for turn, way in ways.items()}
    assert ends[Maneuver.RIGHT_TURN][1] == pytest.approx(0.0, abs=0.2)
    assert ends[Maneuver.LEFT_TURN][1] == pytest.approx(3.5, abs=0.2)
    for way in ways.values():
        heading = way.line.heading_at(0.0) - route.line.heading_at(route.eventAt)
        assert math.remainder(heading - math.pi / 2, 2 * math.pi) == pytest.approx(0.0, abs=0.01)
        assert abs(route.line.project(*way.line.point_at(way.entry))[1]) == pytest.approx(2.25, abs=0.3)


def test_who_comes_out_of_one_on_the_left_meets_the_ego_by_a_left_turn_alone() -> None:
    route = route_on("road:1+1,driveway=left", site="driveway-left")
    assert [way.turn for way in ways_out(route.network, route.route, "left")] == [Maneuver.LEFT_TURN]
    with pytest.raises(MapError, match="no driveway on its right"):
        outOfDriveway(route, "right")


def test_two_pass_each_other_in_a_driveway_that_is_wide_enough() -> None:
    route = route_on("road:1+1,driveway=right,mouth=8", site="driveway")
    into = wayOff(route, "right")
    (out,) = (way for way in outOfDriveway(route, "right") if way.turn is Maneuver.RIGHT_TURN)
    apart = math.dist(into.point_at(into.length - 2.0), out.line.point_at(2.0))
    assert apart == pytest.approx(3.2, abs=0.2)


def test_a_way_into_an_arm_leads_through_the_junction_to_its_lane() -> None:
    route = route_on("road:1+1,junction=right", place="three-way")
    way = wayOff(route, "right")
    assert turns_at(route.network, route.route, "right") == route.eventAt
    turned = math.remainder(way.heading_at(way.length) - route.line.heading_at(0.0), 2 * math.pi)
    assert turned == pytest.approx(-math.pi / 2, abs=0.05)
    with pytest.raises(MapError, match="no way off to its left"):
        wayOff(route, "left")
