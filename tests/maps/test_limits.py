"""The speed that is allowed on the lanes of a map."""

from __future__ import annotations

from pathlib import Path
from xml.etree import ElementTree as Xml

import numpy as np
import pytest

from chatscene.maps.lane_runs import centre_line
from chatscene.maps.limits import MOTORWAY, RURAL, TOWN, limits_along, limits_of, read_limits
from chatscene.maps.network import PACKAGED, load_network
from chatscene.maps.onward import route_onward
from chatscene.maps.routes import find_routes
from chatscene.terms.route import RouteQuery
from chatscene.terms.scenario import Maneuver, Site

HERE = Path(__file__).parent


def road(kinds: str, lanes: str = "", number: int = 1, link: str = "") -> str:
    section = f'<lanes><laneSection s="0"><right><lane id="-1">{lanes}</lane></right></laneSection></lanes>'
    return f'<road id="{number}" length="100">{link}{kinds}{section}</road>'


def allowed(*roads: str, s: float = 10.0, lane: int | None = -1, number: int = 1) -> float:
    """In km/h."""
    return round(read_limits(Xml.fromstring(f"<OpenDRIVE>{''.join(roads)}</OpenDRIVE>"))[number].at(s, lane) * 3.6, 6)


def kind(name: str, speed: str = "", s: float = 0.0) -> str:
    return f'<type s="{s}" type="{name}">{speed}</type>'


@pytest.mark.parametrize(
    ("name", "usual"), [("town", 50), ("townArterial", 50), ("rural", 80), ("motorway", 110), ("unknown", 50)]
)
def test_a_road_without_a_limit_has_that_which_is_usual_for_its_kind(name: str, usual: float) -> None:
    assert allowed(road(kind(name))) == usual
    for none in ('max="no limit"', 'max="undefined"', 'max="0"', 'max="nan"', 'max="fast"'):
        assert allowed(road(kind(name, f'<speed {none} unit="km/h"/>'))) == usual


@pytest.mark.parametrize(
    ("written", "kmh"),
    [
        ('max="30" unit="km/h"', 30.0),
        ('max="10"', 36.0),
        ('max="10" unit="m/s"', 36.0),
        ('max="25" unit="mph"', 40.2336),
    ],
)
def test_a_limit_of_the_map_counts_in_each_unit(written: str, kmh: float) -> None:
    assert allowed(road(kind("town", f"<speed {written}/>"))) == pytest.approx(kmh)


def test_no_road_in_the_country_or_on_a_motorway_is_faster_than_is_usual_there() -> None:
    assert allowed(road(kind("rural", '<speed max="100" unit="km/h"/>'))) == 80
    assert allowed(road(kind("motorway", '<speed max="no limit"/>'))) == 110
    assert allowed(road(kind("motorway", '<speed max="60" unit="km/h"/>'))) == 60


def test_what_is_called_a_town_and_has_a_motorways_limit_is_no_town() -> None:
    assert allowed(road(kind("town", '<speed max="90" unit="km/h"/>'))) == 90
    assert allowed(road(kind("town"), '<speed sOffset="0" max="39.44"/>')) == 110


def test_a_road_may_change_along_its_length() -> None:
    one = road(kind("town") + kind("rural", s=40.0))
    assert [allowed(one, s=s) for s in (0.0, 39.0, 41.0)] == [50, 50, 80]


def test_a_limit_of_a_lane_comes_before_that_of_its_road_from_where_it_stands_on() -> None:
    one = road(kind("motorway", '<speed max="100" unit="km/h"/>'), '<speed sOffset="50" max="60" unit="km/h"/>')
    assert [allowed(one, s=s) for s in (10.0, 60.0)] == [100, 60]
    assert allowed(one, s=60.0, lane=None) == allowed(one, s=60.0, lane=-2) == 100


def test_a_road_of_no_kind_takes_that_of_the_slower_of_the_roads_it_joins() -> None:
    link = (
        '<link><predecessor elementType="road" elementId="2" contactPoint="end"/>'
        '<successor elementType="road" elementId="3" contactPoint="start"/></link>'
    )
    others = road(kind("town") + kind("rural", s=40.0), number=2), road(kind("motorway"), number=3)
    assert allowed(road("", link=link), *others) == 80
    assert allowed(road("")) == 50


def test_each_road_of_the_packaged_maps_has_the_limit_of_its_kind() -> None:
    town, outskirts, region = (limits_of(load_network(path)) for path in PACKAGED.values())
    assert {limit.at(1.0) for limit in town.values()} == {TOWN}
    assert {round(limit.at(1.0) * 3.6) for limit in outskirts.values()} == {50, 60, 80, 110}
    assert {round(limit.at(1.0) * 3.6) for limit in region.values()} == {10, 30, 50, 60, 80, 110}


def test_a_route_on_the_motorway_and_one_from_its_ramp_have_the_limits_of_their_roads() -> None:
    network = load_network(PACKAGED["outskirts"])
    (main, *_) = find_routes(network, "outskirts", RouteQuery(maneuver=Maneuver.STRAIGHT, site=Site.MOTORWAY))
    limits = limits_along(network, main.line, main.lane_ids)
    assert len(limits) == len(main.line) - 1
    assert set(limits) == {MOTORWAY}
    (ramp, *_) = find_routes(network, "outskirts", RouteQuery(maneuver=Maneuver.LANE_CHANGE_LEFT, site=Site.ON_RAMP))
    limits = limits_along(network, ramp.line, ramp.lane_ids)
    assert (round(limits[0] * 3.6), round(limits[-1] * 3.6)) == (60, 110)
    assert (np.diff(limits) >= 0).all()


def test_a_route_on_the_rural_road_has_its_limit() -> None:
    network = load_network(PACKAGED["outskirts"])
    lane = next(lane for lane in network.lanes if limits_of(network)[lane.road.id].at(1.0) == RURAL)
    route = route_onward(network, "outskirts", lane.centerline.points[0][:2], [lane])
    assert limits_along(network, route.line, route.lane_ids)[0] == RURAL


@pytest.mark.parametrize("name", ["motorway", "crossing"])
def test_the_limits_that_netconvert_writes_on_lanes_are_read(name: str) -> None:
    network = load_network(HERE / "osm" / f"{name}.xodr")
    lines = {lane.uid: centre_line(lane).resampled(1.0) for lane in network.lanes}
    lanes = {uid: max(limits_along(network, line, [uid])) for uid, line in lines.items()}
    assert (max(lanes.values()) == MOTORWAY) == (name == "motorway")
    assert len({round(limit, 3) for limit in lanes.values()}) > 1
