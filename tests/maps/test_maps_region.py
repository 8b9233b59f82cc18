"""The packaged region: what the plan gives, and what readers of OpenDRIVE make of it."""

from __future__ import annotations

import math
import xml.etree.ElementTree as ET
from dataclasses import replace
from typing import Any

import pytest
import shapely

from chatscene.maps.car_parks import car_parks
from chatscene.maps.crossings import CrossingPath
from chatscene.maps.furniture import Stand, furniture_of
from chatscene.maps.lane_runs import lane_runs
from chatscene.maps.layout import JunctionKind, junction_kinds, motorway_groups, ramp_ways, roundabouts
from chatscene.maps.network import load_network, resolve_map
from chatscene.maps.ring_ways import line_beside, ring_ways
from chatscene.maps.routes import find_routes, place_of
from chatscene.maps.settings import lies_in
from chatscene.maps.sites import APPROACHED
from chatscene.maps.survey import check_map
from chatscene.maps.writing.opendrive import write_opendrive
from chatscene.maps.writing.streets import Node
from chatscene.terms.route import Equipment, RouteQuery
from chatscene.terms.scenario import Control, Maneuver, Place, Site
from chatscene.terms.vocabulary import Setting
from making.maps.region import plan

REGION = resolve_map("region")
NETWORK: Any = load_network(REGION)
ROOT = ET.parse(REGION).getroot()


def test_the_packaged_map_is_what_the_plan_gives_byte_for_byte() -> None:
    assert write_opendrive("region", plan(), located=True).encode() == REGION.read_bytes()


def test_it_is_no_larger_than_600_kb() -> None:
    assert REGION.stat().st_size < 600_000


def test_it_has_no_faults() -> None:
    assert check_map(REGION) == ()


def test_every_lane_leads_on_but_those_that_taper_out_beside_one_that_does() -> None:
    stuck = [lane for lane in NETWORK.lanes if not lane.maneuvers]
    assert len(stuck) == 6
    for lane in stuck:
        assert math.dist(lane.leftEdge.points[-1][:2], lane.rightEdge.points[-1][:2]) < 0.01
        assert lane.sections[-1]._laneToLeft.lane.maneuvers
        assert lane.sections[-1]._laneToLeft.isForward == lane.sections[-1].isForward


def test_one_can_drive_from_every_lane_to_every_other() -> None:
    after = {lane.uid: _beyond(lane) for lane in NETWORK.lanes}
    for start in [lane for lane in NETWORK.lanes if lane.maneuvers][:3]:
        reached, ahead = {start.uid}, [start.uid]
        while ahead:
            fresh = after[ahead.pop()] - reached
            reached |= fresh
            ahead += fresh
        assert reached == {lane.uid for lane in NETWORK.lanes}


def _beyond(lane: Any) -> set[str]:
    """Where one can get from a lane: on from its end, or into a lane of its direction beside it."""
    ways = {(m.connectingLane or m.endLane).uid for m in lane.maneuvers}
    if lane._successor is not None:
        ways.add(lane._successor.uid)
    sides = [side for part in lane.sections for side in (part._laneToLeft, part._laneToRight) if side is not None]
    return ways | {side.lane.uid for side in sides if side.isForward == lane.sections[0].isForward}


def test_its_roads_say_how_fast_one_may_drive() -> None:
    said = {
        (kind.get("type"), speed.get("max"), speed.get("unit"))
        for kind in ROOT.iterfind("road/type")
        for speed in kind.iter("speed")
    }
    limits = {("town", "50"), ("town", "30"), ("rural", "80"), ("motorway", "110"), ("motorway", "80")}
    assert said == {(*limit, "km/h") for limit in limits | {("motorway", "60"), ("town", "10")}}
    assert all(road.find("type/speed") is not None for road in ROOT.iter("road"))


@pytest.mark.parametrize("control", Control)
@pytest.mark.parametrize("place", [Place.THREE_WAY, Place.FOUR_WAY])
@pytest.mark.parametrize("lanes", [1, 2])
def test_300_m_lead_up_to_junctions_of_every_kind(control: Control, place: Place, lanes: int) -> None:
    for maneuver in (Maneuver.LEFT_TURN, Maneuver.RIGHT_TURN):
        query = RouteQuery(
            maneuver=maneuver, place=place, control=control, lanes_same_way=lanes, most_lanes=lanes, approach=300.0
        )
        assert all(route.event_at >= 200.0 for route in find_routes(NETWORK, "region", query))


def test_every_arm_of_a_junction_of_the_town_is_300_m_long() -> None:
    kinds, runs = junction_kinds(NETWORK), lane_runs(NETWORK)
    town = [j for j in NETWORK.intersections if kinds[j.uid] is JunctionKind.CROSSING and place_of(j) is Place.FOUR_WAY]
    town = [j for j in town if car_parks(NETWORK).isdisjoint(lane.road.id for lane in j.incomingLanes)]
    assert town
    short = {lane.uid for j in town for lane in j.incomingLanes if runs[lane.uid].line.length < 300.0}
    ramps_apart = {
        lane.uid for lane in NETWORK.elements["intersection155"].incomingLanes
    }  # the rural road between them
    assert short <= ramps_apart


def test_the_motorway_has_three_lanes_each_way_for_3_km_and_ramps_of_real_length() -> None:
    groups, runs = motorway_groups(NETWORK), lane_runs(NETWORK)
    wide = sum(group.centerline.length for group in groups if len(group.lanes) >= 3)
    assert wide / 2 > 3000.0
    for kind, end in ((JunctionKind.MERGE, "endLane"), (JunctionKind.DIVERGE, "startLane")):
        ways = ramp_ways(NETWORK, kind)
        assert len(ways) == 2
        for way in ways:
            assert runs[getattr(way, end).uid].line.length > 250.0
            ramp = way.startLane if kind is JunctionKind.MERGE else way.endLane
            assert ramp.centerline.length > 350.0


def test_one_roundabout_is_large_and_the_other_compact() -> None:
    large, compact = sorted(roundabouts(NETWORK), key=lambda ring: -_round(ring))
    assert _round(large) > 200.0
    assert _round(compact) < 100.0
    entries = [m for j in large.junctions for m in NETWORK.elements[j].maneuvers if m.startLane.uid not in large.lanes]
    assert max(len(m.startLane.group.lanes) for m in entries) == 2
    for ring in (large, compact):
        into = {lane.uid: lane for j in ring.junctions for lane in NETWORK.elements[j].incomingLanes}
        arms = [uid for uid, lane in into.items() if lane.road.backwardLanes is not None or lane.centerline.length > 90]
        assert all(lane_runs(NETWORK)[uid].line.length > 300.0 for uid in arms)


def _round(ring: Any) -> float:
    return sum(NETWORK.elements[uid].centerline.length for uid in ring.lanes)


@pytest.mark.parametrize("radius", [150.0, 250.0, 400.0])
def test_rural_roads_have_bends_of_stated_radii(radius: float) -> None:
    rural = [road for road in ROOT.iter("road") if road.find("type[@type='rural']") is not None]
    bends = [
        float(piece.get("length", "0"))
        for road in rural
        for piece in road.iterfind("planView/geometry")
        for arc in piece.iter("arc")
        if math.isclose(abs(float(arc.get("curvature", "1"))), 1 / radius, rel_tol=1e-6)
    ]
    assert max(bends) > 170.0


def test_rural_roads_have_straights_of_500_m() -> None:
    query = RouteQuery(maneuver=Maneuver.STRAIGHT, place=Place.ROAD, site=Site.RURAL, approach=250.0)
    assert len(find_routes(NETWORK, "region", query)) >= 4


def test_crosswalks_lie_across_roads_of_every_kind_but_the_motorway() -> None:
    roads = {road.id: road for road in NETWORK.roads}
    on = [roads[number] for number, _ in furniture_of(NETWORK).crosswalks]
    marked = [end for street in plan() for end in (street.start, street.end) if isinstance(end, Node) and end.marked]
    assert len(on) == 6 + len(marked) > 50
    two = [road for road in on if len(road.forwardLanes.lanes) == 2]
    assert {road.backwardLanes is None for road in two} == {True, False}
    for road, area in furniture_of(NETWORK).crosswalks:
        assert all(lane.polygons.intersects(area) for lane in roads[road].lanes)


def test_places_to_stand_lie_beside_the_streets() -> None:
    lot = car_parks(NETWORK)
    uses = [place.use for place in furniture_of(NETWORK).standing if place.road not in lot]
    assert uses.count(Stand.BUS) == uses.count(Stand.PARKING) == 2


def test_carla_can_drive_on_everywhere_and_sees_the_crosswalks(capfd: pytest.CaptureFixture[str]) -> None:
    carla = pytest.importorskip("carla", reason="the carla client has no wheel for this Python")
    world_map = carla.Map("region", REGION.read_text())
    told = capfd.readouterr()
    assert "WARNING" not in told.out + told.err
    assert len(world_map.get_crosswalks()) == 5 * len(furniture_of(NETWORK).crosswalks)
    assert {mark.type for mark in world_map.get_all_landmarks()} == {"1000001", "206", "224"}
    ends = {(w.road_id, w.lane_id) for w in world_map.generate_waypoints(2.0) if not w.next(3.0)}
    assert len(ends) == 6  # where lanes taper out
    assert {road for road, _ in ends} == {street.id for street in plan() if street.ceases}


@pytest.mark.parametrize(("side", "track"), [("left", 1), ("right", 0)])
def test_in_the_large_roundabout_somebody_goes_round_beside_the_ego(side: str, track: int) -> None:
    large = max(roundabouts(NETWORK), key=_round)
    query = RouteQuery(maneuver=Maneuver.STRAIGHT, site=Site.ROUNDABOUT, lanes_same_way=2, lane_beside=side)
    drivable = NETWORK.drivableRegion.polygons.buffer(0.1)
    for route in find_routes(NETWORK, "region", query):
        assert set(route.lane_ids) & set(large.tracks[track])
        assert not set(route.lane_ids) & set(large.tracks[1 - track])
        line = line_beside(NETWORK, route, side)
        assert drivable.contains(shapely.LineString(line.points))
        assert any(abs(line.project(*point)[1]) < 6.0 for point in route.line.between(150.0, 160.0).points) or (
            side == "right"
        )


def test_who_enters_the_inner_lane_meets_who_goes_round_in_either() -> None:
    query = RouteQuery(maneuver=Maneuver.STRAIGHT, site=Site.ROUNDABOUT, lanes_same_way=2, lane=2)
    for route in find_routes(NETWORK, "region", query):
        assert [way.from_side for way in ring_ways(NETWORK, route)].count("round") == 2


def test_who_enters_a_roundabout_and_goes_straight_on_leaves_it_opposite() -> None:
    query = RouteQuery(maneuver=Maneuver.STRAIGHT, site=Site.ROUNDABOUT)
    ways = [way for route in find_routes(NETWORK, "region", query) for way in ring_ways(NETWORK, route)]
    straight = [way for way in ways if way.turn is Maneuver.STRAIGHT and way.from_side != "round"]
    assert {way.from_side for way in straight} >= {"left", "right"}
    for way in straight:
        x, y = way.line.point_at(way.meets_at)
        middle = min((_middle(ring) for ring in roundabouts(NETWORK)), key=lambda one: math.dist(one, (x, y)))
        came, leaves = (
            math.atan2(point[1] - middle[1], point[0] - middle[0])
            for point in (way.line.point_at(way.entry), _left_ring(way, middle))
        )
        assert abs(math.cos(leaves - came) + 1.0) < 0.4, (way.from_side, came, leaves)


def _left_ring(way: CrossingPath, middle: tuple[float, float]) -> tuple[float, float]:
    """Where a way is as far from the middle of the ring for the last time as where it enters that."""
    far = math.dist(way.line.point_at(way.entry), middle)
    return [point for point in way.line.points if math.dist(point, middle) <= far][-1]


def _middle(ring: Any) -> tuple[float, float]:
    points = [NETWORK.elements[uid].centerline.points[0] for uid in ring.lanes]
    return sum(point[0] for point in points) / len(points), sum(point[1] for point in points) / len(points)


@pytest.mark.parametrize(
    ("maneuver", "site"),
    [
        (Maneuver.LANE_CHANGE_LEFT, Site.ON_RAMP),
        (Maneuver.LANE_CHANGE_RIGHT, Site.OFF_RAMP),
        (Maneuver.STRAIGHT, Site.PAST_ON_RAMP),
        (Maneuver.STRAIGHT, Site.PAST_OFF_RAMP),
        (Maneuver.LANE_CHANGE_LEFT, Site.LANE_DROP),
    ],
)
def test_past_ramps_one_can_drive_at_120_km_per_h_which_needs_four_times_the_road(
    maneuver: Maneuver, site: Site
) -> None:
    slow = RouteQuery(maneuver=maneuver, site=site)
    fast = replace(slow, approach=4 * APPROACHED[site])
    usual, far = (find_routes(NETWORK, "region", query)[0] for query in (slow, fast))
    assert far.event_at >= 3 * usual.event_at
    assert far.length >= 3 * usual.length


@pytest.mark.parametrize("setting", Setting)
def test_a_setting_is_told_from_limits_width_and_sidewalks(setting: Setting) -> None:
    limits = {Setting.TOWN: {50.0, 30.0}, Setting.RESIDENTIAL: {30.0}, Setting.RURAL: {80.0}}
    roads = {road.get("id"): float(road.find("type/speed").get("max", "0")) for road in ROOT.iter("road")}  # type: ignore[union-attr]
    found = {roads[str(lane.road.id)] for lane in NETWORK.lanes if lane.maneuvers and lies_in_street(lane, setting)}
    assert found == limits[setting]


def lies_in_street(lane: Any, setting: Setting) -> bool:
    return lane.uid in lane_runs(NETWORK) and lies_in(NETWORK, lane, setting)


def test_a_divided_road_has_no_oncoming_lane_beside_any_of_its_own() -> None:
    query = RouteQuery(maneuver=Maneuver.STRAIGHT, lanes_same_way=2, setting=Setting.TOWN, divided=True)
    routes = find_routes(NETWORK, "region", replace(query, place=Place.ROAD))
    assert {NETWORK.elements[route.lane_ids[0]].road.id for route in routes} <= {51, 52, 53, 54, 55, 56, 57, 58}
    assert {j.control for j in find_routes(NETWORK, "region", replace(query, place=Place.FOUR_WAY))} == {Control.SIGNAL}


@pytest.mark.parametrize("control", Control)
@pytest.mark.parametrize("place", [Place.THREE_WAY, Place.FOUR_WAY])
@pytest.mark.parametrize("maneuver", [Maneuver.LEFT_TURN, Maneuver.RIGHT_TURN])
def test_junctions_of_every_kind_have_crosswalks(control: Control, place: Place, maneuver: Maneuver) -> None:
    query = RouteQuery(maneuver=maneuver, place=place, control=control, has=(Equipment.CROSSWALKS,))
    areas = [area for _, area in furniture_of(NETWORK).crosswalks]
    for route in find_routes(NETWORK, "region", query):
        assert sum(area.intersects(shapely.LineString(route.line.points)) for area in areas) == 2


@pytest.mark.parametrize("control", Control)
def test_a_cycle_lane_leads_up_to_junctions_of_every_control(control: Control) -> None:
    query = RouteQuery(maneuver=Maneuver.RIGHT_TURN, control=control, has=(Equipment.CYCLE_LANE,))
    beside = {lane.get("type") for road in ROOT.iter("road") for lane in road.iter("lane") if road.get("id") == "67"}
    assert "biking" in beside and "shoulder" not in beside
    for route in find_routes(NETWORK, "region", query):
        road = NETWORK.elements[route.lane_ids[0]].road
        assert {(road.id, True), (road.id, False)} <= furniture_of(NETWORK).cycle_lanes.keys()


def test_rails_lie_in_the_inner_lane_of_a_street() -> None:
    query = RouteQuery(maneuver=Maneuver.STRAIGHT, place=Place.ROAD, lane_beside="left", has=(Equipment.TRAM_TRACK,))
    for route in find_routes(NETWORK, "region", query):
        lane = NETWORK.elements[route.lane_ids[0]]
        areas = [area for road, area, _ in furniture_of(NETWORK).tracks if road == lane.road.id]
        inner = lane.sections[0]._laneToLeft.lane
        assert any(inner.polygons.contains(area.centroid) for area in areas)
        assert not any(lane.polygons.intersects(area) for area in areas)


def test_rails_lead_across_roads_of_the_country_and_of_the_town() -> None:
    query = RouteQuery(maneuver=Maneuver.STRAIGHT, site=Site.RAIL_CROSSING)
    routes = find_routes(NETWORK, "region", query)
    assert {NETWORK.elements[route.lane_ids[0]].road.id for route in routes} == {85, 97}
    for route in routes:
        x, y = route.line.point_at(route.event_at + 0.7)
        assert any(area.contains(shapely.Point(x, y)) for _, area, across in furniture_of(NETWORK).tracks if across)


def test_aisles_of_a_car_park_are_found_by_who_asks_for_bays_and_by_nobody_else() -> None:
    lot = car_parks(NETWORK)
    assert lot == {201, 202, 203, 204}
    along = RouteQuery(maneuver=Maneuver.STRAIGHT, place=Place.ROAD)
    through = RouteQuery(maneuver=Maneuver.STRAIGHT, place=Place.JUNCTION, conflicting_from=("left",))
    for query in (along, through):
        inside = find_routes(NETWORK, "region", replace(query, has=(Equipment.BAYS,)))
        assert {NETWORK.elements[route.lane_ids[0]].road.id for route in inside} <= lot
        outside = find_routes(NETWORK, "region", query)
        assert lot.isdisjoint(NETWORK.elements[route.lane_ids[0]].road.id for route in outside)
