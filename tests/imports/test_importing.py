# ruff: noqa: E501 - elements stand in one line each
"""Scenarios of others become programs, or are refused by element and line; no file does anything else."""

from __future__ import annotations

import html
import json
import math
import re
from pathlib import Path

import pytest
from click.testing import CliRunner

import chatscene
from chatscene.commands.main import main
from chatscene.errors import MapError, ScenarioError, SettingsError
from chatscene.imports.given import Given
from chatscene.imports.import_file import written
from chatscene.imports.openscenario import Imported, read_openscenario
from chatscene.imports.positions import Positions
from chatscene.imports.stranger_xml import Element
from chatscene.maps.neighbours import number_beside
from chatscene.maps.network import resolve_map
from chatscene.search.generators.foreign import read_foreign
from chatscene.terms.plan import Number
from chatscene.terms.plan_text import print_plan
from chatscene.terms.storyboard import Storyboard
from chatscene.world.places import laneLine
from places import SHARED
from red_team.scenario_files import AT, ATTACKS, CAR, NEAR, SLOWS, WALKER, event, scenario

AFTER = '<ByValueCondition><StoryboardElementStateCondition storyboardElementType="event" storyboardElementRef="brakes" state="completeState"/></ByValueCondition>'


def read(folder: Path, text: str) -> Imported:
    path = folder / "theirs.xosc"
    path.write_text(text)
    return read_openscenario(path)


def board_of(found: Imported) -> Storyboard:
    """The plan of a file that can be told as one."""
    assert isinstance(found.board, Storyboard)
    return found.board


def plan(folder: Path, text: str) -> str:
    (found,) = [actor.plan for actor in board_of(read(folder, text)).actors if actor.plan is not None]
    return print_plan(found)


def speeds_to(value: str, shape: str = "linear", dimension: str = "rate", by: str = "2") -> str:
    changed = SLOWS.replace('value="0"', f'value="{value}"').replace('value="4"', f'value="{by}"')
    return changed.replace("linear", shape).replace("rate", dimension)


def test_somebody_ahead_who_slows_down_when_the_ego_comes_near_becomes_a_plan(beside: Path) -> None:
    said = plan(beside, scenario())
    assert said.splitlines() == [
        "param OPT_NEAR = Range(10.0, 30.0)",
        "behavior AdvBehavior():",
        "    do DrivePath(leadWay, 5.0) until abs(headway(egoRoute, ego, self)) < globalParameters.OPT_NEAR",
        "    do BrakeOnPath(leadWay, 0.5)",
    ]


def test_what_comes_after_an_event_waits_for_its_end(beside: Path) -> None:
    said = plan(beside, scenario(events=event() + event(speeds_to("7"), AFTER, "goes on")))
    assert "do BrakeOnPath(leadWay, 0.5) until self.pose[3] < 0.1" in said
    assert said.rstrip().endswith("do ThrottleOnPath(leadWay, 0.444444, 0, 7.0)")


def test_a_step_that_has_a_length_lasts_as_scenario_runner_reads_it_and_that_is_noted(beside: Path) -> None:
    text = scenario(events=event(speeds_to("8", "step", "time", "3")) + event(SLOWS, AFTER, "stops"))
    assert "do DrivePath(leadWay, 8.0) for 3.0 seconds" in plan(beside, text)
    assert any("ScenarioRunner" in note for note in read(beside, text).notes)


def test_a_lane_change_leads_to_the_line_of_that_lane_and_its_time_is_noted(beside: Path) -> None:
    change = '<LateralAction><LaneChangeAction><LaneChangeActionDynamics dynamicsShape="sinusoidal" dynamicsDimension="time" value="3"/><LaneChangeTarget><RelativeTargetLane entityRef="lead" value="{}"/></LaneChangeTarget></LaneChangeAction></LateralAction>'
    both = [read(beside, scenario(events=event(change.format(lanes)))) for lanes in (1, -1)]
    (found,) = [one for one in both if isinstance(one.board, Storyboard)]  # a street has a lane on one side
    assert isinstance(found.board, Storyboard)
    lead = found.board.lines["leadWay2"]
    along, aside, _ = lead.project(136.75, -330.0)
    assert 0 < along < lead.length
    assert 2.5 < abs(aside) < 8
    assert any("lane change" in note for note in found.notes)


def test_somebody_on_foot_goes_where_he_faces(beside: Path) -> None:
    at = '<WorldPosition x="143" y="-340" h="3.141592"/>'
    said = plan(beside, scenario(body=WALKER, place=at, events=event(speeds_to("1.5"))))
    assert "do MoveAhead(5.0) until" in said
    assert said.rstrip().endswith("do MoveAhead(1.5)")


def test_a_place_may_be_told_by_road_lane_or_beside_somebody(beside: Path) -> None:
    there = board_of(read(beside, scenario()))
    relative = '<RelativeObjectPosition entityRef="ego" dx="29" dy="0"/>'
    again = board_of(read(beside, scenario(place=relative)))
    one, other = (board.actors[1].start.along for board in (there, again))
    assert isinstance(one, Number)
    assert isinstance(other, Number)
    assert other.value == pytest.approx(one.value, abs=0.01)
    ahead = board_of(
        read(beside, scenario(place='<RelativeLanePosition entityRef="ego" dLane="0" ds="29" offset="0"/>'))
    )
    x, y = (board.lines["leadWay"].point_at(board.actors[1].start.along.value) for board in (there, ahead))  # type: ignore[union-attr]
    assert x == pytest.approx(y, abs=0.3)


@pytest.mark.parametrize(
    ("text", "why"),
    [
        (scenario(events=event(NEAR)), r"line \d+: <ByEntityCondition>|this is not supported here"),
        (scenario(events=event("<TeleportAction/>")), r"<TeleportAction>: this is not supported here"),
        (
            scenario(events=event(condition=NEAR.replace("RelativeDistance", "TimeToCollision"))),
            "<TimeToCollisionCondition>: it has no target",
        ),
        (scenario(events=event().replace("rising", "sinking")), "the edge 'sinking' is not known"),
        (scenario(place='<GeoPosition latitude="1" longitude="2"/>'), "such a place is not read"),
        (scenario(place='<LanePosition roadId="999" laneId="1" s="1"/>'), "has no road '999'"),
        (scenario(events=event(SLOWS.replace("$near", "1"), NEAR.replace("$near", "$far"))), r"\$far.*not declare"),
        (scenario().replace('revMinor="2"', 'revMinor="9"'), "version 1.9"),
    ],
)
def test_what_cannot_be_said_here_is_refused_with_its_line(text: str, why: str, beside: Path) -> None:
    with pytest.raises(ScenarioError, match=why):
        read(beside, text)


def test_all_that_is_refused_is_told_at_once(beside: Path) -> None:
    bad = scenario(
        place='<GeoPosition latitude="1" longitude="2"/>',
        more="<ManeuverGroup><Maneuver><Event><Action><PrivateAction><X/></PrivateAction></Action></Event></Maneuver></ManeuverGroup>",
    )
    with pytest.raises(ScenarioError) as refused:
        read(beside, bad)
    assert str(refused.value).count("\n  line ") == 2


@pytest.mark.parametrize("attack", sorted(ATTACKS))
def test_what_an_enemy_puts_into_a_file_is_refused(attack: str, beside: Path) -> None:
    text, why = ATTACKS[attack]
    with pytest.raises(ScenarioError, match=why):
        read(beside, text)


def test_a_file_that_is_larger_than_a_scenario_is_not_read_to_its_end(beside: Path) -> None:
    with pytest.raises(ScenarioError, match="more than 8 MB"):
        read(beside, " " * (9 * 2**20))


def test_names_of_a_stranger_become_no_code(beside: Path) -> None:
    text = scenario(name="x')&#10;import os&#10;('").replace(
        'entityRef="lead"', 'entityRef="x&apos;)&#10;import os&#10;(&apos;"'
    )
    (beside / "an odd\tname.xosc").write_text(text)
    done = chatscene.import_scenario(beside / "an odd\tname.xosc")
    source = done.program.read_text()
    assert "import os" not in source.replace("aximport", "")
    assert read_foreign(done.program).program.parameters[0].name == "OPT_NEAR"


def test_the_command_writes_a_program_once_and_says_how_it_is_run(beside: Path) -> None:
    (beside / "theirs.xosc").write_text(scenario())
    told = CliRunner().invoke(main, ["import", str(beside / "theirs.xosc"), "--json"], catch_exceptions=False)
    assert told.exit_code == 0, told.output
    program = Path(json.loads(told.output)["program"])
    assert json.loads(told.output)["command"].endswith(f"--program {program} --map {beside / 'town.xodr'}")
    assert read_foreign(program).program.parameters
    with pytest.raises(SettingsError, match="there already"):
        chatscene.import_scenario(beside / "theirs.xosc")
    with pytest.raises(ScenarioError, match="does not lie there"):
        (beside / "town.xodr").unlink()
        chatscene.import_scenario(beside / "theirs.xosc", out=beside / "other.scenic")


@pytest.mark.parametrize("of", [-3, -1, 1, 3])
@pytest.mark.parametrize("lanes", [-2, -1, 0, 1, 2])
def test_a_lane_beside_another_has_no_number_zero_and_the_way_back_leads_home(of: int, lanes: int) -> None:
    to = number_beside(of, lanes)
    assert to != 0
    assert number_beside(to, -lanes) == of


def test_the_left_of_who_faces_against_the_reference_line_has_lower_numbers() -> None:
    positions = Positions(Given(), resolve_map("town"))
    sections = positions.network.laneSections
    for section in (next(s for s in sections if (int(s.openDriveID) > 0) is against) for against in (True, False)):
        line = laneLine(section.lane)
        (x, y), heading = line.point_at(line.length / 2), line.heading_at(line.length / 2)
        along = 1 if int(section.openDriveID) < 0 else -1
        assert positions.in_lane(section, (x, y, heading)).left == along
        assert positions.in_lane(section, (x, y, heading + math.pi)).left == -along


def test_a_change_to_the_left_of_who_drives_against_the_reference_line_goes_to_the_left(tmp_path: Path) -> None:
    case = SHARED / "cases" / "import-relative-lane-direction"
    if not case.is_dir():
        pytest.skip("the scenario of a road with three lanes each way is not laid out beside the project")
    found = read_openscenario(case / "esmini444.xosc")
    assert found.board.lines["otherWay"].points[0][1] == pytest.approx(5.25)
    assert found.board.lines["otherWay2"].points[0][1] == pytest.approx(1.75)


@pytest.mark.parametrize("value", ["abc", "nan", ""])
def test_a_parameter_that_varies_about_no_number_is_refused_by_its_line(beside: Path, value: str) -> None:
    text = scenario().replace('parameterType="double" value="20"', f'parameterType="double" value="{value}"')
    with pytest.raises(ScenarioError, match=r"line 4: <ParameterDeclaration>: .* is not a number"):
        read(beside, text)


def test_an_event_that_never_begins_is_told_on_the_terminal_in_the_head_of_the_page_and_to_a_script(
    beside: Path,
) -> None:
    (beside / "theirs.xosc").write_text(scenario(events=event(condition=NEAR.replace("$near", "1"))))
    program = chatscene.import_scenario(beside / "theirs.xosc").program
    how = ("--map", "town", "--scenes", "1", "--simulator", "native", "--trust", "--out", str(beside / "run"))
    said = CliRunner().invoke(main, ["run", "--program", str(program), "--json", *how])
    assert said.exit_code == 0, said.output
    unread, told = json.loads(said.stdout)["told_first"]
    assert unread == "param OPT_NEAR = Range(10.0, 30.0) has no effect here: nothing reads it"
    assert told == (
        "in 1 of 1 scenes: this never began: adversary was to brake along leadWay by 0.5, "
        "once the ego is less than 1 m from it along the road"
    )
    done = chatscene.Run(beside / "run")
    assert str(done).splitlines()[:2] == [unread, told]
    page = html.unescape((beside / "run" / "report.html").read_text())
    assert page.index(told) < page.index("collided in")


def test_the_speed_of_an_imported_ego_is_what_it_wants(beside: Path) -> None:
    at, begins = "</Position></TeleportAction></PrivateAction></Private>", speeds_to("20", "step", "time", "0")
    text = scenario().replace(at, at.replace("</Private>", f"<PrivateAction>{begins}</PrivateAction></Private>"), 1)
    (beside / "theirs.xosc").write_text(text)
    program = read_foreign(chatscene.import_scenario(beside / "theirs.xosc").program).program
    assert program.wanted_speed == 20.0
    assert "with speed 20, with wantedSpeed 20" in program.source


def test_an_imported_ego_that_begins_standing_drives_as_it_does(beside: Path) -> None:
    (beside / "theirs.xosc").write_text(scenario())
    assert read_foreign(chatscene.import_scenario(beside / "theirs.xosc").program).program.wanted_speed is None


def test_a_map_that_keeps_to_both_sides_is_the_reason_and_not_the_roads_that_it_has(beside: Path) -> None:
    town = (beside / "town.xodr").read_text()
    (beside / "left.xodr").write_text(town.replace('rule="RHT"', 'rule="LHT"', 1))
    place = '<LanePosition roadId="no-such" laneId="1" s="1"/>'
    with pytest.raises(MapError, match="keeps to the left on road"):
        read(beside, scenario(place=place, map_name="left.xodr"))


def test_a_program_whose_map_keeps_to_both_sides_is_refused_by_its_roads(beside: Path) -> None:
    town = (beside / "town.xodr").read_text()
    (beside / "left.xodr").write_text(town.replace('rule="RHT"', 'rule="LHT"', 1))
    (beside / "own.scenic").write_text(
        "param map = localPath('left.xodr')\nmodel scenic.domains.driving.model\nego = new Car\nnew Car\n"
    )
    how = ("--scenes", "1", "--out", str(beside / "run"))
    done = CliRunner().invoke(main, ["run", "--program", str(beside / "own.scenic"), *how])
    assert done.exit_code == 1
    assert "keeps to the left on road" in done.output
    assert "Traceback" not in done.output


def a_lane(positions: Positions, against: bool) -> tuple[str, int, float]:
    """A road, the number of a lane of it that is driven against its line, or along, and a place on it [m]."""
    for section in positions.network.laneSections:
        number = int(section.openDriveID)
        if (number > 0) is against and section.lane.centerline.length > 40:
            return str(section.road.id), number, 20.0
    raise AssertionError("the town has streets with two ways")


def element(tag: str, **attributes: str) -> Element:
    return Element("Position", {}, 1, [Element(tag, attributes, 1)])


def left_of(pose: tuple[float, float, float], other: tuple[float, float, float]) -> float:
    """How far [m] a place lies to the left of somebody."""
    (x, y, heading), (there_x, there_y, _) = pose, other
    return (there_y - y) * math.cos(heading) - (there_x - x) * math.sin(heading)


@pytest.mark.parametrize(("against", "left"), [(False, 0.8), (True, -0.8)])
def test_an_offset_in_a_lane_goes_to_the_left_of_the_roads_line_whichever_way_the_lane_is_driven(
    against: bool, left: float
) -> None:
    """So who drives against the line has it on the right.

    The standard (ASAM OpenSCENARIO XML) has an offset "along the t-axis of the target lane center line", and t points
    to the left of s, which a lane shares with its road: numbers of lanes grow to that side, too, and so does t where
    a place is told by it. esmini adds an offset to t in the same way, whichever sign a lane has.
    """
    positions = Positions(Given(), resolve_map("town"))
    road, lane, s = a_lane(positions, against)
    lies = {"roadId": road, "laneId": str(lane), "s": str(s)}
    middle, there = (positions.pose(element("LanePosition", **lies, offset=metres)) for metres in ("0", "0.8"))
    assert left_of(middle, there) == pytest.approx(left, abs=1e-6)
    assert there[2] == middle[2]
    (x, y), (across, up) = middle[:2], (there[0] - middle[0], there[1] - middle[1])
    along = positions.pose(element("RoadPosition", roadId=road, s=str(s), t="0"))  # it faces as the line runs
    assert left_of((x, y, along[2]), (x + across, y + up, 0.0)) == pytest.approx(0.8, abs=1e-6)


@pytest.mark.parametrize("turned", ["0", "3.141592653589793"])
@pytest.mark.parametrize("against", [False, True])
def test_an_offset_in_a_file_of_carla_goes_to_the_right_of_whoever_is_put_there(against: bool, turned: str) -> None:
    """ScenarioRunner takes the lane's place as CARLA has it, which faces as the lane is driven, turns it, and only then
    moves it to its own right.
    """
    positions = Positions(Given(), resolve_map("town"), mirrored=True)
    road, lane, s = a_lane(positions, against)
    lies = {"roadId": road, "laneId": str(lane), "s": str(s)}

    def put(tag: str, **told: str) -> tuple[float, float, float]:
        one = element(tag, **told)
        one.inside[0].inside.append(Element("Orientation", {"type": "relative", "h": turned}, 1))
        return positions.pose(one)

    middle = positions.known["other"] = put("LanePosition", **lies, offset="0")
    assert left_of(middle, put("LanePosition", **lies, offset="0.8")) == pytest.approx(-0.8, abs=1e-6)
    relative = put("RelativeLanePosition", entityRef="other", dLane="0", ds="0", offset="0.8")
    assert left_of(middle, relative) == pytest.approx(-0.8, abs=0.05)


@pytest.mark.parametrize("mirrored", [False, True])
@pytest.mark.parametrize("against", [False, True])
@pytest.mark.parametrize("relative", ["RelativeLanePosition", "RelativeRoadPosition"])
def test_metres_beside_a_lane_are_told_to_the_same_side_by_lane_and_beside_somebody(
    relative: str, against: bool, mirrored: bool
) -> None:
    positions = Positions(given := Given(), resolve_map("town"), mirrored=mirrored)
    road, lane, s = a_lane(positions, against)
    lies = {"roadId": road, "laneId": str(lane), "s": str(s)}
    positions.known["other"] = positions.pose(element("LanePosition", **lies, offset="0"))
    there = positions.pose(element("LanePosition", **lies, offset="0.8"))
    told = {"offset" if relative == "RelativeLanePosition" else "dt": "0.8"}
    beside = positions.pose(element(relative, entityRef="other", dLane="0", ds="0", **told))
    assert beside == pytest.approx(there, abs=0.05)
    assert given.notes == []


def test_so_far_along_a_lane_is_read_and_noted_where_the_lane_is_driven_against_the_line() -> None:
    positions = Positions(given := Given(), resolve_map("town"))
    road, lane, s = a_lane(positions, against=True)
    positions.known["other"] = (x, y, heading) = positions.pose(
        element("LanePosition", roadId=road, laneId=str(lane), s=str(s), offset="0")
    )
    ahead = positions.pose(element("RelativeLanePosition", entityRef="other", dLane="0", dsLane="5", offset="0"))
    assert ahead[0] == pytest.approx(x + 5 * math.cos(heading), abs=0.3)
    assert ahead[1] == pytest.approx(y + 5 * math.sin(heading), abs=0.3)
    assert given.notes == [
        "line 1: its lane is driven against the road's line; it lies so far on as the lane is driven"
    ]


def test_an_offset_and_a_line_in_a_file_of_carla_are_to_the_right_of_who_drives(beside: Path) -> None:
    offset = '<LateralAction><LaneOffsetAction continuous="true"><LaneOffsetTarget><AbsoluteTargetLaneOffset value="0.5"/></LaneOffsetTarget></LaneOffsetAction></LateralAction>'
    theirs = scenario(events=event(offset)).replace('description="a test"', 'description="CARLA: a test"')
    theirs = re.sub(r'y="(-\d+\.\d)" h="1.57', r'y="\1" h="-1.57', theirs).replace('y="-', 'y="')
    assert plan(beside, theirs).rstrip().endswith("do DrivePath(leadWay, 5.0, -0.5)")


def test_a_map_that_cannot_be_read_is_refused_as_map_check_refuses_it(beside: Path) -> None:
    text = (beside / "town.xodr").read_text().replace('rule="RHT"', 'rule="LHT"', 1)
    (beside / "left.xodr").write_text(text)
    (beside / "theirs.xosc").write_text(
        scenario(place='<LanePosition roadId="1" laneId="1" s="1"/>', map_name="left.xodr")
    )
    told = [
        CliRunner().invoke(main, arguments, catch_exceptions=False)
        for arguments in (["import", str(beside / "theirs.xosc")], ["map", "check", str(beside / "left.xodr")])
    ]
    assert told[0].output.removeprefix("MapError: ") == told[1].output
    assert "keeps to the left on road" in told[0].output


@pytest.mark.parametrize("name", ["town.xodr", "./town.xodr", ".\\town.xodr", "$Road", "{folder}/town.xodr"])
def test_a_map_that_lies_beside_the_file_is_found_however_it_is_named(name: str, beside: Path) -> None:
    road = '<ParameterDeclaration name="Road" parameterType="string" value="./town.xodr"/>'
    text = scenario(map_name=name.format(folder=beside))
    text = text.replace("</ParameterDeclarations>", f"{road}</ParameterDeclarations>", 1)
    assert read(beside, text).map_path == beside / "town.xodr"


@pytest.mark.parametrize(
    ("name", "why"),
    [
        ("town.osgb", "is not an .xodr file"),
        ("$Nobody", r"<LogicFile>: it speaks of \$Nobody, which the file does not declare"),
        ("C:\\maps\\town.xodr", "name it with --map C:/maps/town.xodr"),
        ("C:town.xodr", "name it with --map C:town.xodr"),
    ],
)
def test_what_is_the_matter_with_the_name_of_a_map_is_told(name: str, why: str, beside: Path) -> None:
    with pytest.raises(ScenarioError, match=why):
        read(beside, scenario(map_name=name))


def test_who_is_to_get_slower_by_a_rate_brakes_as_a_driver_and_does_not_only_coast(beside: Path) -> None:
    text = scenario(events=event(speeds_to("3")))
    assert plan(beside, text).rstrip().endswith("do DrivePath(leadWay, 3.0)")
    assert any("slows down as a driver does" in note for note in read(beside, text).notes)


def test_that_drag_takes_of_the_pace_at_which_somebody_gets_faster_is_noted(beside: Path) -> None:
    told = "the pedal is held that gives this pace at rest; drag makes it less at speed"
    assert any(told in note for note in read(beside, scenario(events=event(speeds_to("9")))).notes)
    assert not any(told in note for note in read(beside, scenario(events=event(speeds_to("3")))).notes)
    assert not any(told in note for note in read(beside, scenario()).notes)


def test_who_may_get_slower_or_faster_by_a_parameter_drives_to_either_speed(beside: Path) -> None:
    either = plan(beside, scenario(events=event(speeds_to("${$near / 5}"))))
    assert "do DrivePath(leadWay, 0.2 * globalParameters.OPT_NEAR)" in either
    faster = plan(beside, scenario(events=event(speeds_to("${$near / 2}"))))
    assert "do ThrottleOnPath(leadWay, 0.444444, 0, 0.5 * globalParameters.OPT_NEAR)" in faster


def placed(ego: str) -> str:
    return scenario().replace(AT.format(y=-374.0), ego)


@pytest.mark.parametrize(("offset", "h"), [(0.5, 0.0), (-0.75, 0.0), (0.0, 0.2), (0.4, -0.3)])
def test_the_ego_begins_as_far_beside_its_lane_and_turned_as_much_as_is_written(
    offset: float, h: float, beside: Path
) -> None:
    ego = f'<LanePosition roadId="10" laneId="-1" s="11" offset="{offset}"><Orientation type="relative" h="{h}"/></LanePosition>'
    board = board_of(read(beside, placed(ego)))
    start = board.actors[0].start
    ahead = 1.4  # from its origin to its centre
    assert isinstance(start.left, Number)
    assert start.left.value == pytest.approx(offset + ahead * math.sin(h), abs=0.01)
    assert start.turn == pytest.approx(h, abs=0.01)
    left = f", {start.left.value}" if start.left.value else ""
    turn = f", {start.turn:g}" if start.turn else ""
    placed_there = f"at pointOn(egoRoute, 0{left}), facing directionOn(egoRoute, 0{turn}), with route"
    assert placed_there in written(board, "theirs.xosc")


def test_an_ego_that_faces_against_its_lane_goes_against_it_and_that_is_noted(beside: Path) -> None:
    found = read(beside, placed('<WorldPosition x="136.75" y="-374" h="-1.570796"/>'))
    assert board_of(found).actors[0].start.turn == pytest.approx(0.0, abs=1e-3)
    assert board_of(found).lines["egoRoute"].heading_at(5.0) == pytest.approx(-math.pi / 2, abs=1e-3)
    assert any("faces against its lane; its way leads against it" in note for note in found.notes)


def test_an_ego_whose_direction_is_not_told_faces_along_its_lane_and_that_is_noted(beside: Path) -> None:
    found = read(beside, placed('<WorldPosition x="136.75" y="-374"/>'))
    assert board_of(found).actors[0].start.turn == 0.0
    assert any("the ego's heading is not given" in note for note in found.notes)


def test_who_begins_beside_the_middle_of_a_lane_stays_there(beside: Path) -> None:
    there = '<LanePosition roadId="10" laneId="-1" s="40" offset="0.6"/>'
    said = plan(beside, scenario(place=there))
    assert "do DrivePath(leadWay, 5.0, 0.6) until" in said
    assert said.rstrip().endswith("do BrakeOnPath(leadWay, 0.5, 0.6)")
    (nobody,) = [
        a.plan for a in board_of(read(beside, without_events(there))).actors if a.plan is not None and a.name == "lead"
    ]
    assert print_plan(nobody).rstrip().endswith("do DrivePath(leadWay, 5.0, 0.6)")


def without_events(place: str) -> str:
    text = scenario(place=place)
    second = text[text.index('<ScenarioObject name="lead">') : text.index("</Entities>")]
    text = text.replace("</Entities>", second.replace('"lead"', '"other"') + "</Entities>")
    start = text.index('<Private entityRef="lead">')
    init = text[start : text.index("</Actions></Init>")]
    text = text.replace(
        "</Actions></Init>", init.replace('"lead"', '"other"').replace('s="40"', 's="80"') + "</Actions></Init>"
    )
    story = text.index("<Story ")
    return text[:story] + text[story:].replace('entityRef="lead"', 'entityRef="other"')


def weather(inner: str) -> str:
    action = f"<GlobalAction><EnvironmentAction>{inner}</EnvironmentAction></GlobalAction>"
    return scenario().replace("<Init><Actions>", f"<Init><Actions>{action}")


def under(sky: str = "", road: str = "") -> str:
    return weather(f'<Environment name="e"><Weather>{sky}</Weather>{road}</Environment>')


RAIN = '<Precipitation precipitationType="rain" precipitationIntensity="2"/>'


@pytest.mark.parametrize(
    ("text", "told"),
    [
        (under(f'<Fog visualRange="60"/>{RAIN}'), "rain is shown, and its fog is left away"),
        (under('<Fog visualRange="90"/>'), "there is one fog, in which others are seen from 40 m, where it says 90 m"),
        (under('<Wind direction="0" speed="9"/>'), "there is no wind here"),
        (under('<Precipitation precipitationType="hail" intensity="1"/>'), "'hail' falls in no scene"),
        (
            under(road='<RoadCondition frictionScaleFactor="0.62"/>'),
            "a friction of 0.62 is shown as a wet road, of 0.5",
        ),
        (under(road='<RoadCondition frictionScaleFactor="0.8"/>'), "a friction of 0.8 is shown as a dry road, of 1"),
    ],
)
def test_what_of_a_weather_no_scene_has_is_noted(text: str, told: str, beside: Path) -> None:
    notes = read(beside, text).notes
    assert any(told in note and note.startswith("line ") for note in notes), notes


def test_of_a_weather_that_is_shown_as_it_is_written_nothing_is_noted(beside: Path) -> None:
    plain = read(beside, scenario()).notes
    text = under(f'<Fog visualRange="100000"/>{RAIN}', '<RoadCondition frictionScaleFactor="0.5" wetness="moist"/>')
    found = read(beside, text)
    assert str(found.board.surroundings.weather) == "rain"
    assert len(found.notes) == len(plain)


def test_rain_of_no_strength_does_not_fall(beside: Path) -> None:
    assert str(board_of(read(beside, under(RAIN.replace('"2"', '"0"')))).surroundings.weather) == "clear"


def test_a_category_that_nobody_here_has_is_noted_with_what_is_shown(beside: Path) -> None:
    trailer = read(beside, scenario(body=CAR.replace('vehicleCategory="car"', 'vehicleCategory="trailer"')))
    assert any("a trailer is shown as a truck of its size" in note for note in trailer.notes)
    assert not any("is shown as" in note for note in read(beside, scenario()).notes)


def test_a_speed_in_init_that_is_reached_in_some_time_is_there_at_once_and_that_is_noted(beside: Path) -> None:
    slowly = scenario().replace(
        'dynamicsShape="step" dynamicsDimension="time" value="0"',
        'dynamicsShape="linear" dynamicsDimension="time" value="4"',
    )
    assert any("in Init a speed is there at once" in note for note in read(beside, slowly).notes)


def test_what_the_ego_is_to_do_in_init_is_noted(beside: Path) -> None:
    aside = '<PrivateAction><LateralAction><LaneOffsetAction continuous="true"/></LateralAction></PrivateAction>'
    text = scenario().replace('<Private entityRef="ego">', f'<Private entityRef="ego">{aside}')
    assert any("what the ego does is left to the ego under test" in note for note in read(beside, text).notes)


DECLARED = '<ParameterDeclaration name="{}" parameterType="double" value="{}"/>'


def declaring(*parameters: tuple[str, str]) -> str:
    """A scenario in which somebody slows down to $mps, with these parameters."""
    text = scenario(events=event(speeds_to("$mps")))
    return text.replace(
        "<ParameterDeclarations>", "<ParameterDeclarations>" + "".join(DECLARED.format(*one) for one in parameters)
    )


def test_the_value_of_a_parameter_may_be_an_expression_of_others(beside: Path) -> None:
    by_number = plan(beside, declaring(("mps", "5")))
    assert plan(beside, declaring(("kph", "18"), ("factor", "3.6"), ("mps", "${$kph/$factor}"))) == by_number


def test_parameters_that_name_one_another_twice_are_computed_once_each(beside: Path) -> None:
    chain = [("p0", "2"), *((f"p{i + 1}", f"${{$p{i} - $p{i}}}") for i in range(48)), ("mps", "${$p48 + 5}")]
    assert plan(beside, declaring(*chain)) == plan(beside, declaring(("mps", "5")))


def test_an_expression_that_is_long_with_its_parameters_is_refused(beside: Path) -> None:
    with pytest.raises(ScenarioError, match="longer than 4000 characters with its parameters"):
        read(beside, declaring(("kph", "18"), ("mps", "${" + "+".join(["$kph"] * 900) + "}")))


@pytest.mark.parametrize(
    ("parameters", "told"),
    [
        ((("kph", "${$mps*3.6}"), ("mps", "${$kph/3.6}")), r"\$mps is an expression of itself"),
        ((("mps", "${$kph/3.6}"),), r"it speaks of \$kph, which the file does not declare"),
    ],
)
def test_a_parameter_of_itself_of_nothing_or_without_end_is_refused(
    parameters: tuple[tuple[str, str], ...], told: str, beside: Path
) -> None:
    with pytest.raises(ScenarioError, match=told):
        read(beside, declaring(*parameters))
