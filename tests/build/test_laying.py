"""Where no packaged map has all that was said of a place, a road is laid to order; else today's map is taken."""

from __future__ import annotations

from typing import Any

import pytest

from chatscene.build.build import Built, build
from chatscene.build.laying import roads_for
from chatscene.errors import NotBuilt
from chatscene.maps.lane_runs import centre_line
from chatscene.maps.loading import load_roads
from chatscene.maps.neighbours import oncoming_line
from chatscene.maps.network import resolve_map
from chatscene.maps.routes import find_routes
from chatscene.situations.form import from_plain
from chatscene.terms.route import Beside, RouteQuery
from chatscene.terms.scenario import Maneuver, Place, Site
from chatscene.terms.situation import Situation


def said(where: str, act: str, kind: str = "car", road: dict[str, Any] | None = None, **more: Any) -> Situation:
    side = {"side": more.pop("side")} if "side" in more else {}
    other = {"id": "A", "kind": kind, "starts": {"where": where} | side, "does": [{"act": act}]}
    return from_plain({"others": [other], "road": road or {}} | more)


def made(where: str, act: str, kind: str = "car", road: dict[str, Any] | None = None, **more: Any) -> Built:
    return build(said(where, act, kind, road, **more))


def test_what_packaged_maps_have_is_built_on_them() -> None:
    assert made("ahead", "brake").map == "town"
    assert made("ahead", "brake", road={"kind": "motorway"}).map == "outskirts"
    assert made("crossing", "cross", "pedestrian").map in ("outskirts", "region", "town")


@pytest.mark.parametrize(
    ("road", "word"),
    [
        ({"has": ["shoulder"]}, "shoulder=3"),
        ({"has": ["narrow"]}, "lane=3.2"),
        ({"has": ["bus-lane"]}, "bus-lane"),
        ({"kind": "left-curve", "radius": "250 m"}, "bend=left-250"),
        ({"setting": "rural", "speed_limit": "60 mph"}, "speed=97"),
        ({"lanes": 5}, "road:5+5"),
        ({"lanes": 2, "two_way": True, "ego_lane": 1, "setting": "town", "has": ["cycle-lane"]}, "road:2+2"),
    ],
)
def test_a_road_is_laid_with_what_no_packaged_map_has(road: dict[str, Any], word: str) -> None:
    built = made("ahead", "brake", road=road, ego={"speed": "40 km/h"})
    assert word in built.map
    assert not built.lacking


def test_in_a_narrow_street_who_comes_the_other_way_has_a_lane_that_is_as_narrow() -> None:
    built = made("oncoming", "go-along", "bus", {"has": ["narrow", "parked-both-sides"]})
    assert built.map.startswith("road:1+1,lane=2.6,parking=both")
    assert not built.lacking
    assert {f"parked-{side}" in built.program.source for side in ("left", "right")} == {True}


def test_a_vehicle_in_a_driveway_is_in_one() -> None:
    built = made("driveway", "enter", "tractor", {"setting": "rural"}, side="right")
    assert built.map.startswith("road:1+1,along=rural,driveway=right")
    assert not [one for one in built.assumed if "driveway" in one]
    assert "site='driveway'" in built.program.source


def test_who_stands_in_the_median_stands_in_one() -> None:
    built = made("median", "cross", "deer", ego={"speed": "100 km/h"})
    assert "median=3" in built.map
    assert "divided=True" in built.program.source


def test_side_roads_alone_have_signs_where_the_ego_has_priority() -> None:
    assert "signs=side-yield" in made("arm", "go-straight", road={"control": "priority"}, side="right").map
    stops = made("arm", "go-straight", road={"control": "stop-sign"}, side="right", ego={"speed": "60 km/h"})
    assert "signs=side-stop" in stops.map
    four = made("arm", "go-straight", road={"kind": "four-way", "control": "stop-sign"}, side="right")
    assert four.map == "town"


def test_the_map_that_a_program_was_built_on_gives_the_same_program() -> None:
    built = made("driveway", "enter", side="left")
    again = made("driveway", "enter", side="left", map=built.map)
    assert (again.program, again.map) == (built.program, built.map)


def test_a_hill_is_left_out_and_no_road_is_laid_for_it() -> None:
    built = made("ahead", "brake", road={"has": ["hill"]})
    assert (built.map, built.left_out) == ("town", ("road.has.0: hill",))


def test_what_does_not_go_together_is_not_laid() -> None:
    assert not [*roads_for(said("ahead", "brake", road={"kind": "roundabout", "lanes": 4}))]
    with pytest.raises(NotBuilt, match="no map has such a place"):
        made("ahead", "brake", road={"lanes": 9})


def test_a_map_that_was_named_is_kept() -> None:
    assert made("driveway", "enter", side="right", map="town").map == "town"


def test_who_comes_from_a_side_road_may_run_its_stop_sign_where_the_ego_has_priority() -> None:
    runs = {"act": "enter", "breaks": "stop-sign"}
    one = {"id": "A", "kind": "car", "starts": {"where": "arm", "side": "right"}, "does": [runs]}
    built = build(from_plain({"road": {"kind": "junction", "control": "priority"}, "others": [one]}))
    assert not any("stop" in told or "sign" in told for told in (*built.assumed, *built.left_out))


def test_an_ego_on_a_bicycle_rides_in_the_cycle_lane_beside_the_lane_of_cars() -> None:
    road = {"has": ["cycle-lane"]}
    built = made("behind-beside", "overtake", side="left", road=road, ego={"kind": "bicycle"})
    assert built.map == "road:2+1,cycle-lane,ridden"
    assert "lane=1" in built.program.source
    assert built.lacking == ()
    assert "ridden" not in made("behind-beside", "overtake", side="left", road=road).map


def test_an_ego_on_a_bicycle_that_has_others_on_its_right_rides_beside_the_cycle_lane_which_is_told() -> None:
    road = {"has": ["cycle-lane"]}
    built = made("beside", "cut-in", side="right", road=road, ego={"kind": "bicycle"})
    assert "the ego rides beside the cycle lane, not in it" in built.lacking


@pytest.mark.parametrize(("kind", "lane"), [("bus", 1), ("emergency-vehicle", 1), ("car", 2)])
def test_a_bus_drives_in_the_bus_lane_and_a_car_beside_it(kind: str, lane: int) -> None:
    built = made("behind-beside", "cut-in", side="left", road={"has": ["bus-lane"]}, ego={"kind": kind})
    assert "bus-lane" in built.map
    assert f" lane={lane}" in built.program.source


def test_a_lane_that_was_said_is_that_lane_where_it_happens() -> None:
    for name in ("region", "outskirts"):
        path = resolve_map(name)
        query = RouteQuery(maneuver=Maneuver.STRAIGHT, site=Site.MOTORWAY, lane=2, approach=150.0)
        network: Any = load_roads(path)
        for route in find_routes(network, name, query):
            lane = network.laneAt(route.line.point_at(route.event_at))
            assert [one.uid for one in lane.group.lanes].index(lane.uid) == 1


def test_who_turns_round_beyond_a_median_is_in_the_lane_beside_it_as_the_ego_is() -> None:
    built = made("oncoming", "u-turn", road={"has": ["median"]})
    assert built.map.startswith("road:2+2,median=3")
    assert "lanes=2, lane=2" in built.program.source
    network: Any = load_roads(resolve_map(built.map))
    query = RouteQuery(maneuver=Maneuver.STRAIGHT, place=Place.ROAD, lanes_same_way=2, lane=2)
    (route, *_) = find_routes(network, built.map, query)
    line = oncoming_line(network, route)
    assert line is not None
    assert abs(line.project(*route.line.point_at(0.0))[1]) == pytest.approx(3.5 + 3.0, abs=0.01)


def test_the_innermost_lane_is_counted_from_the_inside() -> None:
    road = {"kind": "motorway", "ego_lane": -1}
    built = made("beside", "cut-in", side="right", road=road)
    assert "lane=-1" in built.program.source
    assert built.left_out == ()
    with pytest.raises(NotBuilt, match="lane 1 from the innermost"):
        made("beside", "cut-in", side="left", road=road)


def test_who_swings_out_in_a_bend_does_so_just_beyond_it() -> None:
    built = made("ahead", "stand", road={"kind": "left-curve"}, ego={"route": "bypass", "speed": "50 km/h"})
    assert "site='past-bend', place='left-curve'" in built.program.source
    assert built.left_out == ()


def test_an_ego_turns_into_a_driveway_across_the_lane_of_those_who_come() -> None:
    built = made("oncoming", "go-along", ego={"route": "enter-driveway-across"}, road={"has": ["driveway"]})
    assert built.map == "road:1+1,driveway=left,length=700"
    network: Any = load_roads(resolve_map(built.map))
    query = RouteQuery(maneuver=Maneuver.STRAIGHT, site=Site.DRIVEWAY_LEFT, ends=Beside.DRIVEWAY_ACROSS)
    (route, *_) = find_routes(network, built.map, query)
    x, y = route.line.points[-1].tolist()
    lane = centre_line(network.elements[route.lane_ids[0]])
    assert lane.project(x, y)[1] > 1.75 + 3.5 + 5.0


@pytest.mark.parametrize(("act", "side"), [("turn-left", "left"), ("turn-right", "right")])
@pytest.mark.parametrize("before", [[], ["stand"], ["go-along"]])
def test_who_is_ahead_and_turns_off_between_junctions_does_so_at_a_driveway(
    act: str, side: str, before: list[str]
) -> None:
    does = [{"act": one} for one in (*before, act)]
    turns = {"id": "A", "kind": "car", "starts": {"where": "ahead"}, "does": does}
    built = build(from_plain({"others": [turns], "road": {"kind": "road"}}))
    assert f"driveway={side}" in built.map
    assert built.lacking == ()
    source = built.program.source
    assert ("egoRoute.eventAt - 6 + " in source) is (before == ["stand"])
    assert f'offA = wayOff(egoRoute, "{side}")' in source


def test_rails_are_laid_where_a_road_is_laid_for_something_else() -> None:
    built = made("driveway", "enter", road={"has": ["tram-track"]})
    assert ",tram,driveway=right" in built.map
    assert "has=('tram-track',)" in built.program.source


def test_who_merges_does_so_where_the_lane_that_it_is_in_ends() -> None:
    road = {"lanes": 2, "has": ["lane-drop"]}
    right = made("ahead-beside", "merge", side="right", road=road)
    assert "site='past-lane-drop'" in right.program.source
    assert right.lacking == ()
    left = made("ahead-beside", "merge", side="left", road=road)
    assert left.map.startswith("road:2+2,median=3,drop-left")
    assert "site='past-lane-drop-left'" in left.program.source
    assert left.lacking == ()


def test_an_ego_merges_out_of_a_lane_that_ends_where_no_ramp_was_said() -> None:
    built = made("behind-beside", "accelerate", side="left", ego={"route": "merge"}, road={"has": ["lane-drop"]})
    assert "maneuver='lane-change-left', site='lane-drop'" in built.program.source
    assert built.lacking == ()
    ramp = made("behind-beside", "accelerate", side="left", ego={"route": "merge"}, road={"kind": "motorway"})
    assert "site='on-ramp'" in ramp.program.source


def test_who_turns_round_from_the_edge_of_a_divided_road_does_so_over_the_median_which_is_told() -> None:
    built = made("kerb", "u-turn", side="right", road={"kind": "motorway"}, ego={"speed": "70 mph"})
    assert built.map.startswith("road:2+2,along=motorway,median=4")
    assert "A turns through a gap in the median, which is not drawn" in built.assumed


def test_a_motorway_is_laid_with_a_ramp_where_no_packaged_one_has_as_many_lanes() -> None:
    road = {"kind": "motorway", "lanes": 2, "has": ["on-ramp"]}
    built = made("ahead", "brake", road=road)
    assert built.map.startswith("road:2+2,along=motorway,median=4,ramp=on")
    assert "site='past-on-ramp'" in built.program.source
    assert built.lacking == ()


def test_an_on_ramp_may_be_lanes_away_from_the_ego_but_who_comes_from_it_is_beside() -> None:
    road = {"kind": "motorway", "ego_lane": 2, "has": ["on-ramp"]}
    built = made("ahead", "brake", road=road)
    assert "lane=3, site='past-on-ramp'" in built.program.source
    assert built.lacking == ()
    with pytest.raises(NotBuilt, match="the ego's lane is not the one beside the ramp's"):
        made("on-ramp", "merge", road=road)
