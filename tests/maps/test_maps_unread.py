"""What is wrong with a map is told by road, section and lane, and what has no end is refused before it is followed."""

from __future__ import annotations

from pathlib import Path

import pytest

from chatscene.errors import MapError
from chatscene.maps import network
from chatscene.maps.network import load_network
from chatscene.maps.routes import BASE_SCENARIO_QUERIES, find_routes
from chatscene.maps.survey import check_map
from chatscene.terms.scenario import BaseScenario

LANE = '<lane id="-1" type="driving" level="false"><width sOffset="0" a="3.5" b="0" c="0" d="0"/></lane>'
SECTION = f'<laneSection s="0"><center><lane id="0" type="none"/></center><right>{LANE}</right></laneSection>'
LATER = SECTION.replace('s="0"', 's="200"', 1)
GEOMETRY = '<geometry s="0" x="0" y="0" hdg="0" length="400"><line/></geometry>'
MAP = (
    '<OpenDRIVE><header revMajor="1" revMinor="4"/><road name="" length="400" id="7" junction="-1">'
    f"<planView>{GEOMETRY}</planView><lanes>{SECTION}{LATER}</lanes></road></OpenDRIVE>"
)


@pytest.fixture(autouse=True)
def cache(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("XDG_CACHE_HOME", str(tmp_path / "cache"))


def written(folder: Path, text: str) -> Path:
    path = folder / "theirs.xodr"
    path.write_text(f"{text}<!-- {folder} -->")  # no other test has this content
    return path


def test_the_map_that_is_spoiled_below_is_sound(tmp_path: Path) -> None:
    assert load_network(written(tmp_path, MAP)).lanes


@pytest.mark.parametrize(
    ("right", "wrong", "message"),
    [
        ('length="400" id', "id", "road '7' has no length"),
        (GEOMETRY, "", "road '7' has no <geometry>, so no place"),
        ("<line/>", "<nurbs/>", "<geometry> at s='0' of the shape <nurbs>; line, arc, spiral, paramPoly3"),
        ("<line/>", '<spiral curvEnd="0"/>', "<geometry> at s='0' whose <spiral> has no curvStart"),
        (
            "<line/>",
            '<paramPoly3 aU="0" bU="400" cU="0" dU="0" aV="0" bV="0" cV="0" dV="0" pRange="degrees"/>',
            "with pRange='degrees'; normalized and arcLength are read",
        ),
        (SECTION + LATER, "", "road '7' has no <laneSection>, so no lane"),
        (
            LATER,
            LATER.replace('a="3.5"', 'a="-1"'),
            "section 1 (s='200'): lane '-1' is -1.00 m wide 0 m into the",
        ),
        (SECTION, SECTION.replace("width", "height"), "section 0 (s='0'): lane '-1' has no <width>"),
    ],
)
def test_what_cannot_be_read_is_told_by_road_section_and_lane(
    right: str, wrong: str, message: str, tmp_path: Path
) -> None:
    assert right in MAP
    with pytest.raises(MapError) as refused:
        load_network(written(tmp_path, MAP.replace(right, wrong, 1)))
    assert message in str(refused.value)


def test_a_piece_of_road_that_turns_without_end_is_refused_by_its_road(tmp_path: Path) -> None:
    text = MAP.replace("<line/>", '<spiral curvStart="0" curvEnd="999"/>')
    with pytest.raises(MapError, match=r"road '7' turns by up to 399600 rad in the <spiral> at s='0'"):
        load_network(written(tmp_path, text))


def test_a_map_that_is_too_deep_is_refused_by_its_road(tmp_path: Path) -> None:
    text = MAP.replace("</road>", "<userData>" * 5_000 + "</userData>" * 5_000 + "</road>")
    with pytest.raises(MapError, match="at road '7', elements lie more than 100 deep"):
        load_network(written(tmp_path, text))


def test_a_map_that_is_too_large_is_refused_unread(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(network, "LARGEST", 100)
    with pytest.raises(MapError, match="has more than 0 MB"):
        load_network(written(tmp_path, MAP))


def test_a_long_lane_that_bends_is_said_to_lack_a_straight_stretch(tmp_path: Path) -> None:
    path = written(tmp_path, MAP.replace("<line/>", '<arc curvature="0.004"/>'))
    assert any("neither a lane that is straight for 85 m" in problem for problem in check_map(path))
    (query,) = BASE_SCENARIO_QUERIES[BaseScenario.STRAIGHT_OBSTACLE]
    with pytest.raises(MapError, match="85 m of straight lane without a junction"):
        find_routes(load_network(path), "theirs", query)
