"""What other makers write is read: names, widths, cubics, thin lanes and direct junctions; what is wrong is told."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import pytest

from chatscene.errors import MapError
from chatscene.maps.network import load_network
from chatscene.maps.routes import BASE_SCENARIO_QUERIES, find_routes
from chatscene.maps.scenic_parser import outside
from chatscene.maps.survey import check_map
from chatscene.terms.polyline import Polyline
from chatscene.terms.scenario import BaseScenario

WIDE = '<width sOffset="0" a="3.5" b="0" c="0" d="0"/>'
STRAIGHT = "<line/>"


def lane(number: int, inside: str = WIDE, link: str = "", kind: str = "driving") -> str:
    return f'<lane id="{number}" type="{kind}" level="false"><link>{link}</link>{inside}</lane>'


def road(
    name: str,
    lanes: str,
    *,
    x: float = 0.0,
    y: float = 0.0,
    shape: str = STRAIGHT,
    link: str = "",
    junction: str = "-1",
    length: float = 200.0,
    before: str = "",
) -> str:
    """A road along +x whose lanes lie on its right."""
    return (
        f'<road name="" length="{length}" id="{name}" junction="{junction}"><link>{link}</link><planView>'
        f'<geometry s="0" x="{x}" y="{y}" hdg="0" length="{length}">{shape}</geometry></planView><lanes>{before}'
        f'<laneSection s="0"><center><lane id="0" type="none"/></center><right>{lanes}</right></laneSection>'
        "</lanes></road>"
    )


def to(end: str, kind: str, name: str, contact: str = "") -> str:
    at = f' contactPoint="{contact}"' if contact else ""
    return f'<{end} elementType="{kind}" elementId="{name}"{at}/>'


def written(folder: Path, *parts: str, root: str = "OpenDRIVE") -> Path:
    path = folder / "theirs.xodr"
    path.write_text(f'<{root}><header revMajor="1" revMinor="7"/>{"".join(parts)}</OpenDRIVE>')
    return path


def serves(path: Path) -> bool:
    (query,) = BASE_SCENARIO_QUERIES[BaseScenario.STRAIGHT_OBSTACLE]
    return bool(find_routes(load_network(path), "theirs", query, 1))


def lane_of(loaded: Any, number: int) -> Any:
    (found,) = (one for one in loaded.roads if one.id == number)
    return found.lanes[0]


@pytest.fixture(autouse=True)
def cache(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("XDG_CACHE_HOME", str(tmp_path / "cache"))


def test_a_map_in_a_namespace_is_read(tmp_path: Path) -> None:
    assert serves(written(tmp_path, road("1", lane(-1)), root='OpenDRIVE xmlns="http://www.opendrive.org"'))


def test_roads_may_have_any_names_and_lead_on_into_each_other(tmp_path: Path) -> None:
    path = written(
        tmp_path,
        road("1", lane(-1), y=50),
        road("north", lane(-1, link='<successor id="-1"/>'), link=to("successor", "road", "south", "start")),
        road("south", lane(-1, link='<predecessor id="-1"/>'), x=200, link=to("predecessor", "road", "north", "end")),
    )
    loaded = load_network(path)
    assert sorted(one.id for one in loaded.roads) == [1, 2, 3]  # 1 is taken
    assert lane_of(loaded, 2).maneuvers[0].endLane is lane_of(loaded, 3)
    assert check_map(path) == ()


def test_a_fault_is_told_by_the_name_that_the_file_gives_its_road(tmp_path: Path) -> None:
    with pytest.raises(MapError, match=r"road 'north' section 0 .*lane '-1' has no <width>"):
        load_network(written(tmp_path, road("north", lane(-1, ""))))


def test_a_cubic_of_the_distance_along_its_first_direction_is_as_long_as_its_piece(tmp_path: Path) -> None:
    bent = '<poly3 a="0" b="0" c="0.002" d="0"/>'
    line = Polyline(
        [p[:2] for p in load_network(written(tmp_path, road("1", lane(-1), shape=bent))).roads[0].centerline]
    )
    assert line.length == pytest.approx(200.0, abs=0.1)
    x, y = line.point_at(line.length)
    assert y == pytest.approx(0.002 * x**2, abs=0.01)


@pytest.mark.parametrize("sign", [1.0, -1.0])
def test_a_lane_that_is_told_by_its_border_lies_between_it_and_that_of_the_next_lane(
    sign: float, tmp_path: Path
) -> None:
    def border(at: float, slope: float = 0.0) -> str:
        return f'<border sOffset="0" a="{sign * at}" b="{sign * slope}" c="0" d="0"/>'

    path = written(tmp_path, road("1", lane(-1, border(3.0)) + lane(-2, border(6.0, 0.005))))
    outer, inner = sorted((one.polygons.bounds for one in load_network(path).lanes), key=lambda bounds: bounds[1])
    assert inner[1::2] == pytest.approx((-3.0, 0.0), abs=0.01)
    assert outer[1::2] == pytest.approx((-7.0, -3.0), abs=0.01)


def test_a_lane_is_none_where_it_is_too_thin(tmp_path: Path) -> None:
    """In a bend, where no area can be drawn of a thin part; the lane's middle is a little longer than its road's."""
    thin = '<width sOffset="0" a="0" b="0" c="0" d="0"/>' + WIDE.replace('sOffset="0"', 'sOffset="100"')
    loaded = load_network(written(tmp_path, road("1", lane(-1) + lane(-2, thin), shape='<arc curvature="0.004"/>')))
    assert all(outside(one, one.centerline) < 0.5 for one in loaded.lanes)
    assert min(one.centerline.length for one in loaded.lanes) == pytest.approx(100.0 * 1.02, abs=1.5)


def test_a_lane_without_width_is_none_all_along(tmp_path: Path) -> None:
    loaded = load_network(written(tmp_path, road("1", lane(-1) + lane(-2, WIDE.replace("3.5", "0")))))
    assert len(loaded.lanes) == 1


def test_offsets_that_begin_late_are_none_before(tmp_path: Path) -> None:
    late = '<laneOffset s="100" a="0" b="0" c="0.0001" d="0"/>'
    assert serves(written(tmp_path, road("1", lane(-1), before=late)))


def direct() -> tuple[str, ...]:
    """A road of two lanes that parts into two of one lane each, at a direct junction."""
    links = "".join(
        f'<connection id="{linked}" incomingRoad="1" linkedRoad="{linked}" contactPoint="start">'
        f'<laneLink from="{number}" to="-1"/></connection>'
        for linked, number in ((2, -1), (3, -2))
    )
    return (
        road("1", lane(-1) + lane(-2), link=to("successor", "junction", "9")),
        road("2", lane(-1), x=200, link=to("predecessor", "junction", "9")),
        road("3", lane(-1), x=200, y=-3.5, shape='<arc curvature="-0.002"/>', link=to("predecessor", "junction", "9")),
        f'<junction id="9" name="" type="direct">{links}</junction>',
    )


def test_lanes_lead_on_through_a_direct_junction(tmp_path: Path) -> None:
    path = written(tmp_path, *direct())
    loaded = load_network(path)
    (whole,) = (one for one in loaded.roads if one.id == 1)
    onward = {one.sections[0].openDriveID: [m.endLane.road.id for m in one.maneuvers] for one in whole.lanes}
    assert onward == {-1: [2], -2: [3]}
    assert check_map(path) == ()


def test_a_link_to_a_lane_that_is_not_there_is_left_out_and_told(tmp_path: Path) -> None:
    path = written(
        tmp_path,
        road("1", lane(-1, link='<successor id="-4"/>'), link=to("successor", "road", "2", "start")),
        road("2", lane(-1), x=200, link=to("predecessor", "road", "1", "end")),
        road("3", lane(-1), y=50, link=to("successor", "road", "77", "start")),
    )
    assert serves(path)
    told = check_map(path)
    assert any("road '1': lane '-1' leads to lane '-4' of road '2'" in one for one in told)
    assert any("road '3': its successor is road '77', which is missing" in one for one in told)


def test_a_piece_that_ends_a_little_too_soon_is_told_and_one_that_ends_much_too_soon_is_refused(tmp_path: Path) -> None:
    def two(first: float) -> str:
        pieces = (
            f'<geometry s="0" x="0" y="0" hdg="0" length="{first}"><line/></geometry>'
            '<geometry s="100" x="100" y="0" hdg="0" length="100"><line/></geometry>'
        )
        whole = road("1", lane(-1))
        return whole[: whole.index("<geometry")] + pieces + whole[whole.index("</planView>") :]

    told = check_map(written(tmp_path, two(99.95)))
    assert any("road '1': the piece at s=0 is 99.95 m long, and the next one begins after 100 m" in one for one in told)
    with pytest.raises(MapError, match="road 1 has inconsistent length"):
        load_network(written(tmp_path, two(98.0)))


def test_junctions_that_lie_at_one_another_are_driven_through(tmp_path: Path) -> None:
    joined = '<laneLink from="-1" to="-1"/>'
    follows, leads = '<predecessor id="-1"/>', '<successor id="-1"/>'
    path = written(
        tmp_path,
        road("1", lane(-1), link=to("successor", "junction", "10")),
        road("2", lane(-1), x=300, link=to("predecessor", "junction", "20")),
        road(
            "11",
            lane(-1, link=follows),
            x=200,
            length=50,
            junction="10",
            link=to("predecessor", "road", "1", "end") + to("successor", "junction", "20"),
        ),
        road(
            "21",
            lane(-1, link=leads),
            x=250,
            length=50,
            junction="20",
            link=to("predecessor", "junction", "10") + to("successor", "road", "2", "start"),
        ),
        '<junction id="10" name=""><connection id="0" incomingRoad="1" connectingRoad="11" contactPoint="start">'
        f"{joined}</connection></junction>",
        '<junction id="20" name=""><connection id="0" incomingRoad="11" connectingRoad="21" contactPoint="start">'
        f"{joined}</connection></junction>",
    )
    loaded = load_network(path)
    way = [lane_of(loaded, 1)]
    while way[-1].maneuvers:
        way.append(way[-1].maneuvers[0].endLane)
    assert [one.road.id for one in way] == [1, 11, 21, 2]


def crossed(link: str) -> tuple[str, ...]:
    """A road through a junction, whose connecting road's lane names no lane beyond."""
    joined = '<laneLink from="-1" to="-1"/>'
    return (
        road("1", lane(-1), link=to("successor", "junction", "10")),
        road("2", lane(-1), x=220, link=to("predecessor", "junction", "10")),
        road("11", lane(-1), x=200, length=20, junction="10", link=to("predecessor", "road", "1", "end") + link),
        '<junction id="10" name=""><connection id="0" incomingRoad="1" connectingRoad="11" contactPoint="start">'
        f"{joined}</connection></junction>",
    )


def test_lanes_of_a_connecting_road_that_name_none_beyond_lead_on_by_their_numbers_and_that_is_told(
    tmp_path: Path,
) -> None:
    path = written(tmp_path, *crossed(to("successor", "road", "2", "start")))
    loaded = load_network(path)
    assert lane_of(loaded, 1).maneuvers[0].endLane is lane_of(loaded, 2)
    assert any("road '11': lane '-1' names no successor in road '2'" in told for told in check_map(path))


def test_a_junction_out_of_which_nothing_leads_is_refused_by_its_number(tmp_path: Path) -> None:
    with pytest.raises(MapError, match="junction 10: no lane leads into it and out of it again"):
        load_network(written(tmp_path, *crossed("")))
