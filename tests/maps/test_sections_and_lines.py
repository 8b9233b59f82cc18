# ruff: noqa: E501 - elements stand in one line each
"""Sections for one side, borders that begin at nothing, lanes against their side, and lines that do not go on."""

from __future__ import annotations

from pathlib import Path

import pytest

from chatscene.maps.network import load_network
from chatscene.maps.survey import check_map, describe_map
from straight import LANE, LINE, road


def lanes(folder: Path, text: str) -> dict[tuple[int, float], float]:
    """The width of each lane in the middle of its section, by its number and where on the x axis that is [m]."""
    (folder / "theirs.xodr").write_text(text)
    network = load_network(folder / "theirs.xodr")
    found: dict[tuple[int, float], float] = {}
    for section in (section for lane in network.lanes for section in lane.sections):
        x0, _, x1, _ = section.polygons.bounds
        found[int(section.openDriveID), round((x0 + x1) / 2)] = section.polygons.area / (x1 - x0)
    return found


def border(a: float, b: float = 0.0) -> str:
    return f'<lane id="-1" type="driving" level="false"><link/><border sOffset="0" a="{a}" b="{b}" c="0" d="0"/></lane>'


@pytest.mark.parametrize("sign", [-1, 1])
def test_a_lane_whose_border_begins_at_the_reference_line_gets_wider(sign: int, tmp_path: Path) -> None:
    (width,) = [w for (n, _), w in lanes(tmp_path, road(right=border(0, sign * 0.0175), length=200)).items() if n == -1]
    assert width == pytest.approx(1.75, abs=0.05)


SINGLE = '<laneSection s="{}" singleSide="true"><{side}>{}</{side}><center><lane id="0" type="none" level="false"/></center></laneSection>'
WIDER = '<lane id="1" type="driving" level="false"><link/><width sOffset="0" a="3" b="0.01" c="0" d="0"/></lane>'


def test_a_section_for_one_side_leaves_the_other_as_it_was(tmp_path: Path) -> None:
    more = SINGLE.format(100, LANE.format(-1) + LANE.format(-2), side="right")
    found = lanes(tmp_path, road(left=WIDER, right=LANE.format(-1), length=200, more=more))
    assert {number for number, _ in found} == {1, -1, -2}
    assert found[1, 50] == pytest.approx(3.5, abs=0.05)
    assert found[1, 150] == pytest.approx(4.5, abs=0.05)
    assert not check_map(tmp_path / "theirs.xodr")


def test_lanes_of_the_side_that_goes_on_lead_on(tmp_path: Path) -> None:
    more = SINGLE.format(100, LANE.format(-1), side="right")
    (tmp_path / "theirs.xodr").write_text(road(left=WIDER, right=LANE.format(-1), length=200, more=more))
    (left,) = [lane for lane in load_network(tmp_path / "theirs.xodr").lanes if lane.sections[0].openDriveID == 1]
    assert left.centerline.length == pytest.approx(200, abs=0.5)


def told(folder: Path, text: str) -> str:
    (folder / "theirs.xodr").write_text(text)
    return "\n".join(check_map(folder / "theirs.xodr"))


def test_a_lane_that_is_driven_against_its_side_is_left_out_and_that_is_told(tmp_path: Path) -> None:
    right = LANE.format(-1) + LANE.format(-2).replace("level", 'direction="reversed" level')
    said = told(tmp_path, road(right=right))
    assert "lane '-2' is driven against its side of the road, which is not read; it is left out" in said
    assert {lane.sections[0].openDriveID for lane in load_network(tmp_path / "theirs.xodr").lanes} == {1, 2, -1}


def test_a_slip_lane_is_driven_on(tmp_path: Path) -> None:
    right = LANE.format(-1) + LANE.format(-2).replace("driving", "slipLane")
    assert -2 in {number for number, _ in lanes(tmp_path, road(right=right))}


@pytest.mark.parametrize(
    ("x", "y", "length", "says"),
    [(105, 0, 100, "its reference line leaps 5.00 m at s=100"), (100, 3, 100, "its reference line leaps 3.00 m at s=100"), (100, 0, 300, "it says that it is 200 m long, and its pieces end after 400 m")],
    ids=["ahead", "aside", "length"],
)  # fmt: skip
def test_a_reference_line_that_does_not_go_on_is_told(
    x: float, y: float, length: float, says: str, tmp_path: Path
) -> None:
    pieces = LINE.format(0, 0, 0, 100) + LINE.format(100, x, y, length)
    assert says in told(tmp_path, road(pieces=pieces, length=200))


def test_a_reference_line_that_turns_at_once_is_told(tmp_path: Path) -> None:
    pieces = LINE.format(0, 0, 0, 100) + LINE.format(100, 100, 0, 100).replace('hdg="0"', 'hdg="1.5708"')
    assert "its reference line bends by 90° at s=100" in told(tmp_path, road(pieces=pieces, length=200))


def test_a_lane_that_ends_far_from_the_one_that_it_leads_to_is_told(tmp_path: Path) -> None:
    one = road(length=100).replace(
        "<link/><planView>", '<link><successor elementType="road" elementId="2" contactPoint="start"/></link><planView>'
    )
    one = one.replace("<link/><width", '<link><successor id="-1"/></link><width')
    two = road(pieces=LINE.format(0, 100, -8, 100), length=100).replace('id="1" junction', 'id="2" junction')
    second = two[two.index("<road") : two.index("</OpenDRIVE>")]
    said = told(tmp_path, one.replace("</OpenDRIVE>", f"{second}</OpenDRIVE>"))
    assert "road '1': lane -1 ends 8.0 m from lane -1 of road '2', to which it leads" in said


VIRTUAL = '<road name="" length="20" id="7" junction="9"><link><predecessor elementType="road" elementId="1" elementS="500" elementDir="+"/></link><planView><geometry s="0" x="500" y="-7" hdg="-1.5" length="20"><line/></geometry></planView><lanes><laneSection s="0"><center><lane id="0" type="none" level="false"/></center><right>{}</right></laneSection></lanes></road><junction id="9" name="" type="virtual" mainRoad="1" sStart="495" sEnd="505" orientation="-"><connection id="0" incomingRoad="1" connectingRoad="7" contactPoint="start"><laneLink from="-1" to="-1"/></connection></junction></OpenDRIVE>'


def test_a_virtual_junction_is_told_to_be_left_out_and_its_road_goes_on(tmp_path: Path) -> None:
    said = told(tmp_path, road().replace("</OpenDRIVE>", VIRTUAL.format(LANE.format(-1))))
    assert said == "junction '9' is virtual, which is not supported; it is left out with its roads: '7'"
    assert len(load_network(tmp_path / "theirs.xodr").lanes) == 4


def test_lanes_of_traffic_that_is_not_here_are_counted(tmp_path: Path) -> None:
    right = LANE.format(-1) + LANE.format(-2).replace("driving", "bus")
    (tmp_path / "theirs.xodr").write_text(road(right=right))
    assert describe_map(tmp_path / "theirs.xodr").left_out == {"bus": 1}
