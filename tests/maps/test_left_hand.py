"""Maps of left-hand traffic: read as their mirror image."""

from __future__ import annotations

from pathlib import Path
from xml.etree import ElementTree as Xml

import numpy as np
import pytest
import shapely

from chatscene.errors import MapError
from chatscene.maps.drawing import map_drawing
from chatscene.maps.lanelets import lanelets_of
from chatscene.maps.left_hand import keeps_left, lanes_on_map, mirror
from chatscene.maps.loading import load_roads
from chatscene.maps.network import PACKAGED, check_opendrive, load_network
from chatscene.maps.survey import check_map, describe_map
from left_town import left_town

TOWN = PACKAGED["town"]
IN_TOWN = (-60.0, -40.0, 80.0, 100.0)


@pytest.fixture(scope="module")
def left(tmp_path_factory: pytest.TempPathFactory) -> Path:
    return left_town(tmp_path_factory.mktemp("left"))


def test_the_mirror_image_of_a_left_hand_map_is_read_as_the_right_hand_map_that_it_is(left: Path) -> None:
    network, town = load_network(left), load_network(TOWN)
    assert network.mirrored
    assert not town.mirrored
    assert {lane.uid for lane in network.lanes} == {lane.uid for lane in town.lanes}
    for lane in town.lanes:
        image = network.elements[lane.uid]
        assert shapely.hausdorff_distance(lane.centerline.lineString, image.centerline.lineString) < 1e-6
        assert [one.endLane.uid for one in lane.maneuvers] == [one.endLane.uid for one in image.maneuvers]
    assert network.furniture.lights == town.furniture.lights
    assert [stand.forward for stand in network.furniture.standing] == [one.forward for one in town.furniture.standing]


def test_the_rule_of_a_road_may_be_written_by_the_numbers_of_its_letters(left: Path, tmp_path: Path) -> None:
    path = tmp_path / "numbers.xodr"
    path.write_text(left.read_text().replace('rule="LHT"', 'rule="&#76;HT"'))
    assert b"LHT" not in path.read_bytes()
    assert keeps_left(path)


def test_no_digit_of_a_map_is_lost_in_the_mirror(left: Path) -> None:
    tree = Xml.parse(left)
    mirror(tree.getroot())
    original = Xml.parse(TOWN).getroot()
    for mine, theirs in zip(tree.getroot().iter(), original.iter(), strict=True):
        assert mine.tag == theirs.tag
        for name, value in theirs.items():
            assert mine.get(name) == value or float(mine.get(name, "")) == float(value) == 0.0


def test_a_left_hand_map_offers_what_its_mirror_image_does_and_says_how_it_keeps(left: Path) -> None:
    described, town = describe_map(left), describe_map(TOWN)
    assert (described.keeps, town.keeps) == ("left", "right")
    assert described.routes == town.routes
    assert check_map(left) == ()


def test_what_a_left_hand_map_lacks_is_told_with_its_own_sides(tmp_path: Path) -> None:
    path = tmp_path / "road.xodr"
    road = (
        '<road id="1" rule="LHT" length="200" junction="-1"><planView><geometry s="0" x="0" y="0" hdg="0" length="200">'
    )
    width = '<width sOffset="0" a="3.5" b="0" c="0" d="0"/>'
    lanes = f'<lanes><laneSection s="0"><left><lane id="1" type="driving">{width}</lane></left><center><lane id="0" '
    path.write_text(
        f'<OpenDRIVE>{road}<line/></geometry></planView>{lanes}type="none"/></center></laneSection></lanes></road></OpenDRIVE>'
    )
    lacking = describe_map(path).lacking
    assert lacking["right-turn"].startswith("the manoeuvre left-turn")


def test_a_drawing_of_a_left_hand_map_lies_as_the_map_does(left: Path) -> None:
    west, south, east, north = IN_TOWN
    drawn = map_drawing(load_roads(left), (west, -north, east, -south))
    town = map_drawing(load_roads(TOWN), IN_TOWN)
    assert drawn.keys() == town.keys()

    def turned(points: list[list[float]]) -> list[list[float]]:
        return [[x, 0.0 - y] for x, y in points]

    assert [one["points"] for one in drawn["lane_boundaries"]] == [
        turned(one["points"]) for one in town["lane_boundaries"]
    ]
    assert drawn["junctions"] == [[turned(ring) for ring in area] for area in town["junctions"]]


def test_lanelets_of_a_left_hand_map_have_the_oncoming_lane_on_their_right(left: Path) -> None:
    there = lanelets_of(load_network(left))
    for one, other in zip(there, lanelets_of(load_network(TOWN)), strict=True):
        assert np.allclose(one.left, other.right * (1.0, -1.0))
        assert (one.on_left, one.on_right) == (other.on_right, other.on_left)
    assert any(one.on_right is not None and not one.on_right.same_way for one in there)


def test_a_map_that_keeps_to_both_sides_is_refused_by_a_road_of_each(left: Path, tmp_path: Path) -> None:
    both = tmp_path / "both.xodr"
    both.write_text(left.read_text().replace('rule="LHT"', 'rule="RHT"', 1))
    with pytest.raises(MapError, match=r"both\.xodr.*keeps to the left on road '.*' .* and to the right on road '"):
        check_opendrive(both)


def test_a_map_without_a_rule_keeps_to_the_right(left: Path, tmp_path: Path) -> None:
    none = tmp_path / "none.xodr"
    none.write_text(left.read_text().replace('rule="LHT"', ""))
    assert not keeps_left(none)
    assert keeps_left(left)


@pytest.mark.parametrize(
    ("told", "on_map"),
    [
        ("road '2': lane '-1' names no successor in road '3'", "road '2': lane '1' names no successor in road '3'"),
        ("lanes -1 and -2 of road 7 overlap", "lanes 1 and 2 of road 7 overlap"),
        ("road 4 has no lane 3 there, but [-2, -1, 1]", "road 4 has no lane -3 there, but [2, 1, -1]"),
        ("lane 0 of 5 lanes", "lane 0 of 5 lanes"),
    ],
)
def test_lanes_are_told_with_the_numbers_that_the_map_has(told: str, on_map: str) -> None:
    assert lanes_on_map(told) == on_map
