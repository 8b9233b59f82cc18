"""Files that name no road network, and bodies that stand in one another at first."""

from __future__ import annotations

from pathlib import Path

import pytest

from chatscene.errors import ScenarioError, SettingsError
from chatscene.imports.import_file import import_scenario
from chatscene.imports.openscenario import Imported
from chatscene.imports.written_story import StoryProgram, written_story
from chatscene.maps.network import load_network
from chatscene.settings import VerifySettings
from chatscene.verdict.programs import watch_openscenario
from played import DISTANCE, read, story
from red_team.scenario_files import AT, event, scenario

NO_ROADS = {"map_name": ""}


@pytest.fixture(autouse=True)
def own_cache(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    def below(kind: str) -> Path:
        return tmp_path / "cache" / kind

    monkeypatch.setattr("chatscene.imports.open_ground.cache_folder", below)


def test_a_file_without_roads_lies_on_open_ground_with_a_road_under_its_ego(beside: Path) -> None:
    found = read(beside, scenario(**NO_ROADS))
    lane = load_network(found.map_path).laneAt((136.75, -374.0))
    assert lane is not None
    assert lane.orientation[(136.75, -374.0)].yaw == pytest.approx(0.0, abs=1e-5)  # Scenic's heading of north
    assert any("it names no road network" in note for note in found.notes)


def test_a_file_whose_places_are_told_by_roads_needs_a_map(beside: Path) -> None:
    with pytest.raises(
        ScenarioError, match=r"names no map, and line \d+ tells a <LanePosition>; name the map with --map"
    ):
        read(beside, scenario(place='<LanePosition roadId="10" laneId="-1" s="40"/>', **NO_ROADS))


def test_open_ground_is_written_beside_the_program_and_nothing_is_overwritten(beside: Path) -> None:
    path = beside / "theirs.xosc"
    path.write_text(scenario(**NO_ROADS))
    done = import_scenario(path)
    assert done.map_path == beside / "theirs.xodr"
    assert load_network(done.map_path).lanes
    done.program.unlink()
    with pytest.raises(SettingsError, match=r"theirs\.xodr is there already"):
        import_scenario(path)


def test_a_program_names_the_map_that_lies_beside_it(beside: Path) -> None:
    path = beside / "theirs.xosc"
    path.write_text(scenario(**NO_ROADS))
    done = import_scenario(path)
    assert "param map = localPath('theirs.xodr')\nmodel chatscene.world.model" in done.program.read_text()


def test_who_stands_in_somebody_else_at_first_may_do_so_and_nobody_else(beside: Path) -> None:
    events = event(DISTANCE)
    assert "allowCollisions" not in written_story(story(beside, scenario(events=events)), "theirs.xosc")
    inside = scenario(events=events, place=AT.format(y=-373.0))
    assert written_story(story(beside, inside), "theirs.xosc").count("with allowCollisions True") == 2


SHORT = """<?xml version="1.0"?>
<OpenDRIVE><header revMajor="1" revMinor="4"/><road name="" length="60" id="1" junction="-1"><link/>
<planView><geometry s="0" x="0" y="0" hdg="0" length="60"><line/></geometry></planView><lanes><laneSection s="0">
<center><lane id="0" type="none"/></center><right><lane id="-1" type="driving">
<width sOffset="0" a="3.5" b="0" c="0" d="0"/></lane></right></laneSection></lanes></road></OpenDRIVE>"""


def on_short_road(beside: Path, ego: str) -> Imported:
    (beside / "short.xodr").write_text(SHORT)
    text = scenario(map_name="short.xodr", place='<LanePosition roadId="1" laneId="-1" s="20"/>')
    return read(beside, text.replace(AT.format(y=-374.0), ego))


def test_an_ego_whose_lane_ends_before_it_has_a_way_beyond_its_end(beside: Path) -> None:
    found = on_short_road(beside, '<LanePosition roadId="1" laneId="-1" s="55"/>')
    assert any("ego's lane ends 4 m ahead of it; its way leads straight on" in note for note in found.notes)
    way = found.board.route if isinstance(found.board, StoryProgram) else found.board.lines["egoRoute"]
    assert way.point_at(15.0) == pytest.approx((71.4, -1.75), abs=0.01)  # from its centre


def test_an_ego_on_no_lane_has_a_way_straight_ahead(beside: Path) -> None:
    found = on_short_road(beside, '<WorldPosition x="10" y="20" h="0"/>')
    assert any("the ego stands on no lane; its way leads straight on" in note for note in found.notes)


def test_a_place_a_little_beyond_the_end_of_its_road_is_its_end(beside: Path) -> None:
    on_short_road(beside, '<LanePosition roadId="1" laneId="-1" s="60.05"/>')
    with pytest.raises(ScenarioError, match="road 1 is 60 m long, and 61 m is not on it"):
        on_short_road(beside, '<LanePosition roadId="1" laneId="-1" s="61"/>')


def test_a_file_without_roads_is_judged(beside: Path) -> None:
    path = beside / "no-roads.xosc"
    path.write_text(scenario(**NO_ROADS))
    found = watch_openscenario(path, VerifySettings(draws=1))
    assert len(found.drives) == 1
