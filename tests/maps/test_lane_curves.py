"""The middle of a lane as its map draws it, and the ways by roads between places."""

from __future__ import annotations

import math
from itertools import pairwise
from pathlib import Path
from xml.etree import ElementTree as Xml

import pytest

from chatscene.maps.lane_curves import DrawnRoad, middle_line
from chatscene.maps.lane_runs import centre_line
from chatscene.maps.network import check_opendrive, load_network, resolve_map
from chatscene.maps.road_ways import Stretch, reached, roads_between

ROAD = """<?xml version="1.0"?>
<OpenDRIVE><header revMajor="1" revMinor="4"/>
<road name="" length="{length}" id="7" junction="-1"><link/>
<planView>{pieces}</planView>
<lanes>{offset}<laneSection s="0">
<left><lane id="1" type="driving"><width sOffset="0" a="3.5" b="0" c="0" d="0"/></lane></left>
<center><lane id="0" type="none"/></center>
<right><lane id="-1" type="driving">{width}</lane><lane id="-2" type="driving"><width sOffset="0" a="3" b="0" c="0" d="0"/></lane></right>
</laneSection></lanes></road></OpenDRIVE>"""  # noqa: E501 - a lane each
WIDTH = '<width sOffset="0" a="3.5" b="0" c="0" d="0"/>'
ARC = '<geometry s="0" x="0" y="0" hdg="0" length="300"><arc curvature="0.01"/></geometry>'


def written(folder: Path, pieces: str, length: float, width: str = WIDTH, offset: str = "") -> Path:
    path = folder / "curve.xodr"
    path.write_text(ROAD.format(pieces=pieces, length=length, width=width, offset=offset))
    return path


def test_a_lane_in_a_bend_lies_on_its_arc_where_scenic_draws_chords(tmp_path: Path) -> None:
    network = load_network(written(tmp_path, ARC, 300.0))
    lane = next(lane for lane in network.lanes if lane.sections[0].openDriveID == -1)

    def beside(line: object) -> float:
        inside = [line.point_at(s) for s in range(1, 300)]  # type: ignore[attr-defined]
        return max(abs(math.hypot(x, y - 100.0) - 101.75) for x, y in inside)

    assert beside(middle_line(lane)) < 0.003
    assert beside(centre_line(lane)) > 0.2


def test_a_lane_that_is_driven_against_its_road_runs_so(tmp_path: Path) -> None:
    network = load_network(written(tmp_path, ARC, 300.0))
    lane = next(lane for lane in network.lanes if lane.sections[0].openDriveID == 1)
    assert middle_line(lane).points[-1] == pytest.approx((0.0, 1.75), abs=1e-6)


def test_every_lane_of_a_packaged_map_has_a_middle_of_its_own_near_scenics() -> None:
    network = load_network(resolve_map("town"))
    for lane in network.lanes:
        middle, usual = middle_line(lane), centre_line(lane)
        assert middle is not usual
        assert all(abs(usual.project(x, y)[1]) < 0.1 for x, y in middle.points.tolist())


def test_a_network_whose_file_is_not_known_has_scenics_lines(tmp_path: Path) -> None:
    network = load_network(written(tmp_path, ARC, 300.0, width=WIDTH.replace("3.5", "3.25")))
    del network.written
    lane = network.lanes[0]
    assert middle_line(lane) is centre_line(lane)


def drawn(folder: Path, pieces: str, length: float, width: str = WIDTH, offset: str = "") -> DrawnRoad:
    return DrawnRoad(next(check_opendrive(written(folder, pieces, length, width, offset)).iter("road")))


def test_a_spiral_ends_turned_by_the_mean_of_its_curvatures(tmp_path: Path) -> None:
    spiral = '<geometry s="0" x="0" y="0" hdg="0" length="100"><spiral curvStart="0" curvEnd="0.02"/></geometry>'
    road = drawn(tmp_path, spiral, 100.0)
    assert road.place(100.0, 0.0)[2] == pytest.approx(1.0, abs=1e-9)
    steps = [road.place(s / 100.0, 0.0)[:2] for s in range(10_001)]
    assert sum(math.dist(a, b) for a, b in pairwise(steps)) == pytest.approx(100.0, abs=1e-3)


def test_a_width_and_an_offset_that_change_move_the_middle(tmp_path: Path) -> None:
    line = '<geometry s="0" x="0" y="0" hdg="0" length="50"><line/></geometry>'
    widens = '<width sOffset="0" a="3" b="0" c="0" d="0"/><width sOffset="10" a="3" b="0.1" c="0" d="0"/>'
    aside = '<laneOffset s="0" a="1" b="0" c="0" d="0"/>'
    road = drawn(tmp_path, line, 50.0, widens, aside)
    assert road.middle_at(5.0, -1) == pytest.approx(1.0 - 1.5)
    assert road.middle_at(20.0, -1) == pytest.approx(1.0 - 2.0)
    assert road.middle_at(20.0, -2) == pytest.approx(1.0 - 4.0 - 1.5)
    assert road.lanes_at(20.0) == [-2, -1, 1]
    with pytest.raises(LookupError):
        road.middle_at(20.0, -3)


PART = (
    '<road name="" length="{length}" id="{id}" junction="{junction}"><link>{links}</link><planView>'
    '<geometry s="0" x="0" y="0" hdg="0" length="{length}"><line/></geometry></planView><lanes/></road>'
)


def link(end: str, kind: str, number: int, contact: str = "") -> str:
    contact = f' contactPoint="{contact}"' if contact else ""
    return f'<{end} elementType="{kind}" elementId="{number}"{contact}/>'


@pytest.fixture
def crossing() -> dict[str, DrawnRoad]:
    """Road 1 leads into a junction, out of which road 2 leads against its line, by a short way and a long one."""
    through = link("predecessor", "road", 1, "end") + link("successor", "road", 2, "end")
    parts = [
        PART.format(id=1, length=100, junction=-1, links=link("successor", "junction", 9)),
        PART.format(id=2, length=80, junction=-1, links=link("successor", "junction", 9)),
        PART.format(id=3, length=20, junction=9, links=through),
        PART.format(id=4, length=15, junction=9, links=through),
    ]
    return {road.get("id", ""): DrawnRoad(road) for road in Xml.fromstring(f"<OpenDRIVE>{''.join(parts)}</OpenDRIVE>")}


def test_the_shortest_way_by_roads_leads_through_the_junction_and_against_a_road(
    crossing: dict[str, DrawnRoad],
) -> None:
    way = roads_between(crossing, ("1", 60.0), ("2", 30.0))
    assert way == [Stretch("1", 60.0, 100.0, 1), Stretch("4", 0.0, 15.0, 1), Stretch("2", 80.0, 30.0, -1)]
    assert way is not None
    assert reached(way, 50.0) == (way[1], 10.0)
    assert reached(way, 200.0) == (way[2], 145.0)
    ends_at_once = roads_between(crossing, ("1", 60.0), ("2", 80.0))
    assert ends_at_once is not None
    assert (ends_at_once[-1].length, ends_at_once[-1].way) == (0.0, -1)


def test_there_is_no_way_by_roads_where_none_is_linked(crossing: dict[str, DrawnRoad]) -> None:
    alone = {"1": crossing["1"], "2": crossing["2"]}
    assert roads_between(alone, ("1", 0.0), ("2", 0.0)) is None
