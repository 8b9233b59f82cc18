"""A road that a map's name says is laid: the same bytes for the same road, with all that was said, and no other."""

from __future__ import annotations

import math
from pathlib import Path
from typing import Any
from xml.etree import ElementTree

import pytest

from asam_checker import assert_nothing_wrong
from chatscene.errors import MapError
from chatscene.maps.junctions import control_before, junction_control
from chatscene.maps.laid import laid, laid_name
from chatscene.maps.layout import arms, roundabouts
from chatscene.maps.loading import load_roads
from chatscene.maps.network import check_given, name_of, resolve_map
from chatscene.maps.road_spec import Bend, LaidRoad, Meets, Sides, Signs, road_of
from chatscene.maps.routes import find_routes
from chatscene.maps.survey import check_map
from chatscene.terms.route import Equipment, RouteQuery
from chatscene.terms.scenario import Control, Maneuver, Place, Site
from chatscene.terms.vocabulary import Setting

EVERY = (
    "road:1+1",
    "road:2+2,median=4",
    "road:1+0,lane=3.2,along=residential,parking=both",
    "road:1+1,along=rural,bend=left-250,length=1000",
    "road:3+3,along=motorway,median=4,bend=right-800,length=2000",
    "road:1+1,junction=right,signs=side-stop",
    "road:2+2,median=3,crosswalk,junction=four,signs=signal",
    "road:1+1,along=rural,driveway=right",
    "road:1+1,bus-bay",
    "road:3+2,drop",
    "road:2+1,drop",
    "road:1+1,cycle-lane,crosswalk",
    "road:2+1,bus-lane",
    "road:2+1,cycle-lane,ridden,crosswalk",
    "road:1+1,tram,driveway=left",
    "road:3+3,along=motorway,median=4,drop-left",
    "road:2+2,along=motorway,median=4,ramp=on,length=1500",
    "road:3+3,along=motorway,median=4,ramp=off,length=1500",
    "road:2+1,cycle-lane,ridden,junction=four,signs=signal",
    "road:1+1,junction=four,turn-lane=left,signs=signal",
    "road:2+2,junction=right,turn-lane=right",
    "road:1+1,crosswalk,junction=four,ring=1,diameter=18",
    "road:1+1,junction=left,ring=1",
    "road:2+2,median=4,crosswalk,junction=four,side=2,ring=2",
    "road:3+3,junction=four,side=3,ring=3",
)
AT_ENDS = (
    "road:1+1,junction=stem,signs=side-stop",
    "road:1+1,along=rural,junction=fork,ring=1",
    "road:1+1,junction=five",
)
STRAIGHT = RouteQuery(maneuver=Maneuver.STRAIGHT, place=Place.ROAD)


@pytest.mark.parametrize("name", EVERY)
def test_a_road_is_laid_without_a_fault_and_its_name_says_it(name: str) -> None:
    path = resolve_map(name)
    assert str(road_of(name)) == name == name_of(path)
    assert path.read_text("utf-8") == laid(road_of(name))
    assert not check_map(path)
    query = RouteQuery(maneuver=Maneuver.STRAIGHT) if "junction" in name or "bend" in name else STRAIGHT
    query = RouteQuery(maneuver=Maneuver.STRAIGHT, site=Site.ROUNDABOUT) if "ring" in name else query
    query = RouteQuery(maneuver=Maneuver.STRAIGHT, place=Place.CURVE, approach=250) if "bend" in name else query
    assert find_routes(load_roads(path), name, query)


def test_words_may_come_in_any_order_and_give_the_same_file() -> None:
    assert resolve_map("road:1+1,crosswalk,cycle-lane") == resolve_map("road:1+1,cycle-lane,crosswalk,lane=3.50")


@pytest.mark.parametrize(
    ("name", "why"),
    [
        ("road:", "'' says no lanes; say road:1\\+1"),
        ("road:1+1,tunnel", "'tunnel' says nothing of a road; words are lane=…"),
        ("road:1+1,bend=up-50", "'bend=up-50' says nothing of a road"),
        ("road:9+1", "cannot be laid: it has 1 to 6 lanes ahead"),
        ("road:1+0,median=2", "a median lies between two directions"),
        ("road:1+1,bend=left-5", "a bend has a radius of 30 to 3000 m"),
        ("road:1+1,signs=stop", "signs stand at a junction"),
        ("road:1+1,lane=nan", "a lane is 2.5 to 6 m wide"),
        (f"road:1+1,length={10**400}", "it is 300 to 5000 m long"),
        ("road:1+1,lane=3,lane=4", "'lane' is said twice; say it once"),
        ("road:2+2,drop,crosswalk", "nothing else lies along a road of which a lane ends"),
        ("road:2+2,drop,parking=both", "nothing else lies along a road of which a lane ends"),
        ("road:1+1,bus-bay,parking=left", "one parks beside no road that has a bay for buses"),
        ("road:1+1,junction=four,driveway=left", "a driveway leads off between junctions"),
        ("road:1+1,ring=1", "a roundabout is a junction of arms"),
        ("road:1+1,junction=four,ring=4", "1 to 3 lanes go round"),
        ("road:1+1,junction=four,diameter=30", "a diameter is that of a roundabout"),
        (
            "road:1+1,junction=four,ring=2,diameter=20",
            "a circle of 20 m is too small for 2 lanes round it, and its arms",
        ),
        ("road:1+1,junction=five,ring=1,diameter=16", "a circle of 16 m is too small"),
        ("road:1+1,junction=four,ring=1,signs=signal", "one gives way at a roundabout"),
        ("road:1+1,side=2", "other arms are those of a junction"),
        ("road:1+1,turn-lane=left", "a lane for who turns is on one side of a road"),
        ("road:6+6,lane=6,bend=left-30", "what lies inside its bend is wider than the bend's radius"),
        ("road:2+6,median=30,bend=left-40", "what lies inside its bend is wider than the bend's radius"),
    ],
)
def test_a_name_that_says_no_road_is_refused_with_the_word(name: str, why: str) -> None:
    with pytest.raises(MapError, match=why):
        resolve_map(name)


def test_a_file_that_was_changed_is_laid_anew_and_one_elsewhere_is_none(tmp_path: Path) -> None:
    path = resolve_map("road:1+1,length=700")
    content = path.read_bytes()
    path.write_bytes(b"<OpenDRIVE/>")
    assert resolve_map("road:1+1,length=700").read_bytes() == content
    copy = tmp_path / path.name
    copy.write_bytes(b"<OpenDRIVE/>")
    assert laid_name(copy) is None
    with pytest.raises(MapError, match="without a single road"):
        check_given(copy)


def test_a_road_is_laid_where_no_cache_can_be(monkeypatch: pytest.MonkeyPatch, tmp_path: Path) -> None:
    (tmp_path / "file").touch()
    monkeypatch.setenv("XDG_CACHE_HOME", str(tmp_path / "file"))
    path = resolve_map("road:1+1,length=800")
    assert path.is_file()
    assert name_of(path) == "road:1+1,length=800"


def test_only_the_side_road_has_the_stop_sign() -> None:
    roads: Any = load_roads(resolve_map("road:1+1,junction=right,signs=side-stop"))
    (junction,) = roads.intersections
    assert junction_control(junction) is Control.STOP_SIGN
    signed = {
        m.startLane.road.id for m in junction.maneuvers if control_before(junction, m.startLane) is not Control.NONE
    }
    assert signed == {4}
    query = RouteQuery(maneuver=Maneuver.STRAIGHT, place=Place.THREE_WAY, control=Control.NONE)
    assert {roads.elements[one.lane_ids[0]].road.id for one in find_routes(roads, "x", query)} == {1, 2}


@pytest.mark.parametrize(("side", "site"), [(Sides.RIGHT, Site.DRIVEWAY), (Sides.LEFT, Site.DRIVEWAY_LEFT)])
def test_a_driveway_lies_on_the_side_that_was_said_where_the_route_says(side: Sides, site: Site) -> None:
    roads: Any = load_roads(resolve_map(str(LaidRoad(driveway=side))))
    ((_, area),) = roads.furniture.driveways
    for route in find_routes(roads, "x", RouteQuery(maneuver=Maneuver.STRAIGHT, site=site)):
        at, left, _ = route.line.project(area.centroid.x, area.centroid.y)
        assert at == pytest.approx(route.event_at + 2.5, abs=1.0)
        assert (left > 0.0) is (side is Sides.LEFT)


def test_only_the_lane_that_was_said_ends_and_none_the_other_way() -> None:
    for name in ("road:2+1,drop", "road:2+2,drop", "road:2+2,median=4,drop"):
        lanes = ElementTree.fromstring(laid(road_of(name))).iter("lane")
        assert [one.get("id") for one in lanes if any(width.get("a") == "0" for width in one.iter("width"))] == ["-2"]


def test_a_bend_has_the_radius_that_was_said() -> None:
    road = LaidRoad(bend=Bend(left=False, radius=250.0), length=1200)
    query = RouteQuery(maneuver=Maneuver.STRAIGHT, place=Place.RIGHT_CURVE, approach=90.0)
    for route in find_routes(load_roads(resolve_map(str(road))), "x", query):
        (x0, y0), (x1, y1), (x2, y2) = (route.line.point_at(route.length * share) for share in (0.2, 0.6, 1.0))
        area = abs((x1 - x0) * (y2 - y0) - (x2 - x0) * (y1 - y0)) / 2.0
        sides = (math.dist((x0, y0), (x1, y1)), math.dist((x1, y1), (x2, y2)), math.dist((x2, y2), (x0, y0)))
        assert math.prod(sides) / (4.0 * area) == pytest.approx(250.0, rel=0.05)  # of the circle through them


def test_what_a_road_is_called_holds_where_nothing_else_tells_it() -> None:
    motorway = load_roads(resolve_map("road:2+2,along=motorway,median=4"))
    assert find_routes(motorway, "x", RouteQuery(maneuver=Maneuver.STRAIGHT, site=Site.MOTORWAY))
    lane = load_roads(resolve_map("road:1+0,along=rural"))
    assert find_routes(lane, "x", RouteQuery(maneuver=Maneuver.STRAIGHT, setting=Setting.RURAL))


@pytest.mark.parametrize(
    ("name", "has"),
    [
        ("road:1+1,junction=four,signs=yield", Equipment.GIVE_WAY),
        ("road:2+1,bus-lane", Equipment.BUS_LANE),
        ("road:1+1,cycle-lane", Equipment.CYCLE_LANE),
    ],
)
def test_a_route_is_found_by_what_its_road_was_laid_with(name: str, has: Equipment) -> None:
    place = Place.JUNCTION if "junction" in name else Place.ROAD
    query = RouteQuery(maneuver=Maneuver.STRAIGHT, place=place, has=(has,))
    roads: Any = load_roads(resolve_map(name))
    found = {roads.elements[one.lane_ids[0]].road.id for one in find_routes(roads, name, query)}
    assert found <= {1, 2}
    with pytest.raises(MapError):
        find_routes(load_roads(resolve_map("road:2+2,junction=four")), "x", query)


def test_junctions_have_the_arms_that_were_said() -> None:
    for meets, place in ((Meets.LEFT, Place.THREE_WAY), (Meets.FOUR, Place.FOUR_WAY)):
        road = LaidRoad(junction=meets, signs=Signs.SIGNAL)
        query = RouteQuery(maneuver=Maneuver.LEFT_TURN, place=place, control=Control.SIGNAL)
        assert find_routes(load_roads(resolve_map(str(road))), "x", query)


@pytest.mark.parametrize("name", AT_ENDS)
def test_a_road_that_ends_in_a_junction_leads_on_to_both_sides(name: str) -> None:
    path = resolve_map(name)
    assert not check_map(path)
    roads: Any = load_roads(path)
    for way in (Maneuver.LEFT_TURN, Maneuver.RIGHT_TURN):
        query = RouteQuery(maneuver=way, site=Site.ROUNDABOUT if "ring" in name else None)
        assert 1 in {roads.elements[one.lane_ids[0]].road.id for one in find_routes(roads, name, query)}


def test_the_stem_of_a_t_alone_has_its_sign() -> None:
    roads: Any = load_roads(resolve_map("road:1+1,junction=stem,signs=side-stop"))
    (junction,) = roads.intersections
    assert arms(junction) == 3
    signed = {
        m.startLane.road.id for m in junction.maneuvers if control_before(junction, m.startLane) is not Control.NONE
    }
    assert signed == {1}


@pytest.mark.parametrize(
    ("name", "of_arms", "lanes", "across"),
    [
        ("road:1+1,junction=four,ring=1,diameter=18", 4, 1, 17.0),  # less the shoulders
        ("road:1+1,junction=four,ring=1", 4, 1, 35.0),
        ("road:2+2,junction=fork,side=2,ring=2,diameter=50", 3, 2, 47.0),
        ("road:1+1,junction=five,ring=1,diameter=30", 5, 1, 27.0),
    ],
)
def test_a_roundabout_has_the_arms_lanes_and_size_that_were_said(
    name: str, of_arms: int, lanes: int, across: float
) -> None:
    roads: Any = load_roads(resolve_map(name))
    (ring,) = roundabouts(roads)
    assert (len(ring.junctions), len(ring.tracks)) == (of_arms, lanes)
    edges = [math.hypot(*point[:2]) for uid in ring.tracks[-1] for point in roads.elements[uid].rightEdge.points]
    assert 2 * min(edges) == pytest.approx(across, abs=0.2)
    assert 2 * max(edges) == pytest.approx(across, abs=0.2)
    gives_way = RouteQuery(maneuver=Maneuver.RIGHT_TURN, site=Site.ROUNDABOUT, has=(Equipment.GIVE_WAY,))
    assert len(find_routes(roads, name, gives_way)) >= of_arms - 1


def test_who_turns_left_has_a_lane_of_its_own_that_leads_nowhere_else() -> None:
    roads: Any = load_roads(resolve_map("road:1+1,junction=four,turn-lane=left"))
    (junction,) = roads.intersections
    ways = {(m.startLane.uid, m.type.name) for m in junction.maneuvers if m.startLane.road.id == 1}
    lanes = sorted({lane for lane, _ in ways})
    assert sorted([sorted(way for lane, way in ways if lane == one) for one in lanes]) == [
        ["LEFT_TURN"],
        ["RIGHT_TURN", "STRAIGHT"],
    ]


@pytest.mark.parametrize(
    "name",
    [
        "road:1+1,crosswalk,junction=five,ring=1,diameter=28",
        "road:2+2,median=4,junction=four,side=2,ring=2",
        "road:1+1,junction=left,turn-lane=left",
    ],
)
def test_the_asam_checker_finds_nothing_wrong_in_a_junction_that_is_laid(
    caplog: pytest.LogCaptureFixture, name: str
) -> None:
    _, checks = assert_nothing_wrong(resolve_map(name), caplog, "opendrive")
    assert checks > 15
