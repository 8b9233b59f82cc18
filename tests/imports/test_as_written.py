# ruff: noqa: E501 - elements stand in one line each
"""What the file's author saw: everybody does what the file says, the ego too."""

from __future__ import annotations

import json
import math
from dataclasses import replace
from pathlib import Path

import pytest

import chatscene
from chatscene.errors import ForeignCodeRefused, ScenarioError, SettingsError
from chatscene.imports.given import Refused
from chatscene.imports.import_file import import_scenario
from chatscene.imports.import_folder import import_folder
from chatscene.imports.openscenario import read_openscenario
from chatscene.imports.stranger_xml import read_xml
from chatscene.imports.told_as_story import StoryReader
from chatscene.maps.network import resolve_map
from chatscene.program.sample import scene_at
from chatscene.search.generators.foreign import read_foreign
from chatscene.settings import SimulationSettings
from chatscene.simulate.embedded.physics import make_simulator
from chatscene.simulate.simulator import load_simulator
from chatscene.studies.collection import Compared
from chatscene.terms.episode import Episode, Track
from chatscene.terms.scene import AS_WRITTEN, OWN_MODEL, Rejected
from chatscene.view.looking import listed
from played import DISTANCE, STATE, TIME, speed
from red_team.scenario_files import AT, alone, event, scenario, variants

LANE = '<LateralAction><LaneChangeAction><LaneChangeActionDynamics dynamicsShape="{}" dynamicsDimension="{}" value="{}"/><LaneChangeTarget><RelativeTargetLane entityRef="{}" value="{}"/></LaneChangeTarget></LaneChangeAction></LateralAction>'
OF_EGO = ('entityRef="lead"/></Actors>', 'entityRef="ego"/></Actors>')
PERFORMANCE = '<Performance maxSpeed="{}" maxAcceleration="{}" maxDeceleration="{}"/>'


def imported(folder: Path, text: str, name: str = "theirs") -> Path:
    """The program of a file."""
    path = folder / f"{name}.xosc"
    path.write_text(text)
    return import_scenario(path).program


def driven(program: Path, steps: int = 60, dt: float = 0.1) -> Episode:
    """A drive of a program as its file is written."""
    own = read_foreign(program, as_written=True, searched_with=False).program
    scene = replace(scene_at(own, 0, 0.5, name="seed-0"), seed=0)
    settings = SimulationSettings(max_steps=steps, dt=dt)
    drive = make_simulator(resolve_map("town"), settings).open(own, scene, observation="safebench", pedals="safebench")
    assert not isinstance(drive, Rejected), drive.reason
    try:
        while drive.ending is None and not drive.rejection:
            drive.step((1.0, 1.0))  # which nobody listens to
        assert not drive.rejection
        return drive.episode(scene.id, "as written")
    finally:
        drive.close()


def gone(track: Track, at: int) -> float:
    """How far somebody has come [m] after so many steps."""
    return sum(math.dist((track.x[i], track.y[i]), (track.x[i + 1], track.y[i + 1])) for i in range(at))


def of_ego(does: str, when: str = TIME.format(1)) -> str:
    """A scenario in which the ego, at 5 m/s at first, does something, and the other goes ahead of it at 15 m/s."""
    return at_five(scenario(events=event(does, when)))


def at_five(text: str) -> str:
    """A scenario whose events are the ego's, which begins at 5 m/s."""
    text = text.replace(*OF_EGO).replace('<AbsoluteTargetSpeed value="5"/>', '<AbsoluteTargetSpeed value="15"/>', 1)
    begins = f"<PrivateAction>{speed(5, 0.0, 'step')}</PrivateAction></Private>"
    return text.replace("</Private>", begins, 1)


@pytest.mark.parametrize(
    ("shape", "share"), [("linear", 0.5), ("cubic", 0.5), ("sinusoidal", 0.5)], ids=["linear", "cubic", "sinusoidal"]
)
def test_the_ego_takes_the_time_and_the_way_that_its_file_says(shape: str, share: float, beside: Path) -> None:
    ego = driven(imported(beside, of_ego(speed(15, 2.0, shape)))).ego_track
    first = float(ego.speed[0])
    assert float(ego.speed[10]) == pytest.approx(first)
    assert float(ego.speed[20]) == pytest.approx(first + share * (15 - first), abs=0.02)
    assert float(ego.speed[30]) == pytest.approx(15, abs=0.02)
    assert gone(ego, 30) == pytest.approx(first + 2 * (first + 15) / 2, abs=0.03)
    assert gone(ego, 50) == pytest.approx(first + first + 15 + 30, abs=0.05)


def test_a_step_in_speed_takes_no_time(beside: Path) -> None:
    ego = driven(imported(beside, of_ego(speed(15, 0.0, "step")))).ego_track
    assert gone(ego, 20) == pytest.approx(float(ego.speed[0]) + 15, abs=0.05)


def test_nobody_brakes_harder_than_the_file_says_of_the_body(beside: Path) -> None:
    text = of_ego(speed(0, 0.5))
    slower = text.replace("</BoundingBox>", "</BoundingBox>" + PERFORMANCE.format(60, 5, 2))
    fast, slow = (driven(imported(beside, one, name)).ego_track for name, one in (("a", text), ("b", slower)))
    assert float(fast.speed[16]) == pytest.approx(0.0, abs=0.05)
    assert float(slow.speed[20]) == pytest.approx(3.0, abs=0.05)
    assert float(slow.speed[35]) == pytest.approx(0.0, abs=0.05)


@pytest.mark.parametrize("dimension", ["time", "distance"])
def test_a_lane_change_goes_over_in_the_time_or_way_that_is_told(dimension: str, beside: Path) -> None:
    amount = 2.0 if dimension == "time" else 20.0
    ego = driven(imported(beside, of_ego(LANE.format("sinusoidal", dimension, amount, "ego", "1")))).ego_track
    origins = [float(x) - 1.4 * math.cos(float(h)) for x, h in zip(ego.x, ego.heading, strict=True)]
    across = [abs(x - origins[0]) for x in origins]
    begin = next(i for i, far in enumerate(across) if far > 0.005)
    assert begin in (11, 12)
    whole = across[-1]
    assert 2.5 < whole < 4.5
    first = float(ego.speed[0])
    lasts = 2.0 if dimension == "time" else 20.0 / first
    middle = round((1.0 + lasts / 2) * 10)
    assert across[middle] == pytest.approx(whole / 2, abs=0.15)
    assert across[round((1.0 + lasts) * 10) + 1] == pytest.approx(whole, abs=0.02)
    assert gone(ego, 50) == pytest.approx(5 * first, abs=0.3)  # in all no farther than it goes


def test_what_waits_for_the_ego_begins_when_the_ego_is_done(beside: Path) -> None:
    acts = event(speed(15, 2.0), TIME.format(1), "first")
    waits = event(speed(9, 0.0, "step"), STATE.format("event", "first", "completeState"), "later")
    ego = driven(imported(beside, at_five(scenario(events=acts + waits)))).ego_track
    assert float(ego.speed[29]) == pytest.approx(14.5, abs=0.1)
    assert float(ego.speed[31]) == pytest.approx(9.0, abs=0.01)


def test_an_ego_under_test_is_left_alone(beside: Path) -> None:
    program = imported(beside, of_ego(speed(0, 0.0, "step")))
    assert f"with behavior {AS_WRITTEN}()" in program.read_text()
    judged = chatscene.story(program, map="town", ego="idm")
    assert "as-written" in str(judged)
    assert not read_foreign(program, searched_with=False).program.as_written


def with_own(events: str, of_ego: str) -> str:
    """A scenario whose events are the other's, and in which the ego does something, too."""
    text = at_five(scenario(events=events)).replace(OF_EGO[1], OF_EGO[0])
    own = (
        '<ManeuverGroup name="own" maximumExecutionCount="1"><Actors selectTriggeringEntities="false">'
        f'<EntityRef entityRef="ego"/></Actors><Maneuver name="all">{of_ego}</Maneuver></ManeuverGroup>'
    )
    return text.replace("</ManeuverGroup>", "</ManeuverGroup>" + own, 1)


def test_an_ego_that_does_too_much_leaves_the_plan_of_the_others(beside: Path) -> None:
    much = "".join(event(speed(5 + i % 7, 2.0), TIME.format(1 + i), f"e{i}") for i in range(400))
    (path := beside / "much.xosc").write_text(with_own(event(speed(9, 2.0), TIME.format(1)), much))
    done = import_scenario(path)
    assert "DrivePath(" in done.program.read_text()
    assert AS_WRITTEN not in done.program.read_text()
    assert [note for note in done.notes if "characters" in note and note.endswith("--as-written")]


def test_what_waits_for_a_jump_of_the_ego_is_told_to_go_on_at_once(beside: Path) -> None:
    jump = f"<TeleportAction><Position>{AT.format(y=-360.0)}</Position></TeleportAction>"
    waits = event(speed(9, 2.0), STATE.format("event", "first", "completeState"), "later")
    (path := beside / "jump.xosc").write_text(with_own(waits, event(jump, TIME.format(1), "first")))
    notes = import_scenario(path).notes
    assert [note for note in notes if note.endswith("what waits for it, goes on at once")], notes


def test_who_drove_it_before_changes_nothing_for_the_ego_of_the_file(beside: Path) -> None:
    """Both have the same text, and one simulator drives both in turn."""
    written = read_foreign(
        imported(beside, of_ego(speed(0, 0.0, "step"))), as_written=True, searched_with=False
    ).program
    scene = replace(scene_at(written, 0, 0.5, name="seed-0"), seed=0)
    simulator, speeds = load_simulator(resolve_map("town"), SimulationSettings(max_steps=60)), list[float]()
    for program in (written, replace(written, as_written=False), written):
        opened = simulator.open(program, scene, observation="safebench", pedals="safebench")
        assert not isinstance(opened, Rejected)
        for _ in range(30):
            opened.step((1.0, 0.0))
        speeds.append(opened.speed)
        opened.close()
    assert speeds[0] == speeds[2] == 0.0 < speeds[1]


def test_a_program_of_plans_is_driven_as_its_file_says_too(beside: Path) -> None:
    text = at_five(scenario(events=event(speed(9, 2.0), TIME.format(1)))).replace(OF_EGO[1], OF_EGO[0])
    program = imported(beside, text)
    assert "DrivePath(" in program.read_text()
    lead = next(track for track in driven(program).adversaries)
    assert gone(lead, 40) == pytest.approx(15 + (15 + 9) + 9, abs=0.05)


def test_all_that_judge_a_program_drive_it_as_written(beside: Path) -> None:
    text = of_ego(speed(0, 0.0, "step"))
    program = imported(beside, text)
    assert "its own ego drives" in str(chatscene.story(program, map="town", as_written=True))
    assert "its own ego drives" in str(chatscene.story(beside / "theirs.xosc", as_written=True))
    verdict = chatscene.verify(program, "the car ahead stands", map="town", as_written=True, draws=1)
    assert any("its own ego drives" in note for note in verdict.notes)


def test_an_imported_folder_is_evaluated_as_it_is_written(tmp_path: Path) -> None:
    theirs = tmp_path / "theirs"
    theirs.mkdir()
    (theirs / "town.xodr").symlink_to(resolve_map("town"))
    (theirs / "stands.xosc").write_text(of_ego(speed(0, 0.0, "step")))
    (theirs / "untold.xosc").write_text(
        alone().replace('<AbsoluteTargetSpeed value="5"/>', '<AbsoluteTargetSpeed value="0"/>')
    )
    import_folder(theirs, tmp_path / "mine")
    done = chatscene.evaluate(tmp_path / "mine", tmp_path / "ev", as_written=True)
    assert isinstance(done, Compared)
    assert [row["ego"] for row in done.fared] == ["as-written"]
    drives = [row for row in json.loads((tmp_path / "ev/evaluation.json").read_text())["drives"] if "ending" in row]
    assert {row["ending"] for row in drives} == {"timeout"}  # it stands from 1 s on, and does not arrive
    assert "as-written on 2 imported programs" in {one["title"] for one in listed(tmp_path)["pages"]}
    assert list(done.lost) == ["untold.scenic"]
    assert "does not say what its ego does" in done.lost["untold.scenic"]


def test_what_says_nothing_of_the_ego_is_not_driven_as_written(beside: Path) -> None:
    stands = scenario(events=event(DISTANCE, TIME.format(1))).replace(
        '<AbsoluteTargetSpeed value="5"/>', '<AbsoluteTargetSpeed value="0"/>'
    )
    program = imported(beside, stands)
    with pytest.raises(ForeignCodeRefused, match="does not say what its ego does"):
        read_foreign(program, as_written=True, searched_with=False)
    with pytest.raises(ScenarioError, match="it gives its ego no speed and no action; leave out --as-written"):
        chatscene.story(beside / "theirs.xosc", as_written=True)
    (beside / "own.scenic").write_text(
        f"model {OWN_MODEL}\negoRoute = selectRoute(maneuver='straight')\n"
        "ego = new Car at startOf(egoRoute), facing directionOn(egoRoute, 0), with route egoRoute\n"
    )
    with pytest.raises(ForeignCodeRefused, match="does not say what its ego does"):
        chatscene.story(beside / "own.scenic", as_written=True)


def test_what_only_plans_say_is_told_as_the_reason(beside: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    def refuse(_: StoryReader) -> None:
        raise Refused(read_xml(beside / "theirs.xosc"), "a story has none of it")

    monkeypatch.setattr(StoryReader, "program", refuse)
    (beside / "theirs.xosc").write_text(at_five(scenario(events=event(speed(9, 2.0), TIME.format(1)))))
    with pytest.raises(ScenarioError, match=r"as it is written:\n  .*a story has none of it; leave out --as-written"):
        chatscene.story(beside / "theirs.xosc", as_written=True)


def test_each_variant_has_its_own_reason_not_to_be_driven_as_written(beside: Path) -> None:
    declared = '<ParameterDeclaration name="shape" parameterType="string" value="linear"/></ParameterDeclarations>'
    text = of_ego(speed(15, 2.0, "$shape")).replace("</ParameterDeclarations>", declared)
    (beside / "theirs.xosc").write_text(text)
    values = (
        '<Deterministic><DeterministicSingleParameterDistribution parameterName="shape"><DistributionSet>'
        '<Element value="round"/><Element value="linear"/><Element value="square"/>'
        "</DistributionSet></DeterministicSingleParameterDistribution></Deterministic>"
    )
    story = chatscene.verify(variants(beside, values), "The car ahead stands.", as_written=True, draws=3)
    told = {number: note for note in story.notes for number in (1, 3) if f"variant {number} of" in note}
    assert [one.variant for one in story.draws] == [2]
    for number, its, other in ((1, "round", "square"), (3, "square", "round")):
        assert "cannot be driven as it is written" in told[number]
        assert its in told[number]
        assert other not in told[number]


def test_one_ego_drives(beside: Path) -> None:
    program = imported(beside, of_ego(speed(0)))
    with pytest.raises(SettingsError, match="name no other with --ego"):
        chatscene.story(program, map="town", as_written=True, ego="idm")


FOLLOWS = '<RoutingAction><FollowTrajectoryAction><TrajectoryRef><Trajectory name="t" closed="false"><Shape><Polyline>{}</Polyline></Shape></Trajectory></TrajectoryRef><TimeReference><Timing domainAbsoluteRelative="absolute" scale="1" offset="0"/></TimeReference><TrajectoryFollowingMode followingMode="position"/></FollowTrajectoryAction></RoutingAction>'


def test_who_backs_along_its_line_backs(beside: Path) -> None:
    told = ((1.0, -330.0), (4.0, -315.0), (6.0, -315.0), (9.0, -321.0))
    line = "".join(
        f'<Vertex time="{time}"><Position><WorldPosition x="136.75" y="{y}" h="1.570796"/></Position></Vertex>'
        for time, y in told
    )
    text = at_five(scenario(events=event(FOLLOWS.format(line), TIME.format(1)))).replace(OF_EGO[1], OF_EGO[0])
    lead = next(track for track in driven(imported(beside, text), 90).adversaries if track.kind == "Car")
    ys = [float(y) - 1.4 * math.sin(float(h)) for y, h in zip(lead.y, lead.heading, strict=True)]
    assert [ys[step] for step in (25, 40, 50, 75, 89)] == pytest.approx([-322.5, -315, -315, -318, -320.8], abs=0.03)
    assert float(lead.speed[75]) == pytest.approx(-2.0, abs=0.01)
    assert float(lead.heading[75]) == pytest.approx(math.pi / 2, abs=0.01)
    assert "backwards" not in " ".join(read_openscenario(beside / "theirs.xosc").notes)


def test_who_is_told_to_back_backs_as_fast_as_it_is_told(beside: Path) -> None:
    text = at_five(scenario(events=event(speed(-12, 0.0, "step"), TIME.format(90))))
    text = text.replace('<AbsoluteTargetSpeed value="5"/>', '<AbsoluteTargetSpeed value="-12"/>', 1)
    ego = driven(imported(beside, text), 20).ego_track
    assert gone(ego, 10) == pytest.approx(12.0, abs=1.0)
    assert float(ego.speed[10]) == pytest.approx(-12.0)
