"""Programs that were written for Scenic's driving domain or for CARLA: drawn, routed, driven."""

from pathlib import Path
from typing import Any

import numpy as np
import pytest

import chatscene as api
from chatscene.ego.observation import Observation
from chatscene.errors import DoesNotCompile, ProgramError, RunError
from chatscene.maps.network import resolve_map
from chatscene.search.generators.foreign import as_scenic_3, foreign_program
from chatscene.search.generators.own_program import generator_for
from chatscene.settings import SimulationSettings
from chatscene.simulate import staging
from chatscene.simulate.confined.simulator import ConfinedSimulator
from chatscene.simulate.simulator import Simulator, load_simulator, simulate
from chatscene.terms.episode import Episode, Role
from chatscene.terms.scenario import Maneuver
from chatscene.terms.scene import Rejected, Scene, ScenicProgram

TOWN = resolve_map("town")
LEAD = """param map = localPath('Town01.xodr')
model scenic.domains.driving.model
GAP = Range(15, 30)
param SPEED = VerifaiRange(4, 8)
behavior Follow():
    try:
        do FollowLaneBehavior(target_speed=8)
    interrupt when withinDistanceToAnyCars(self, 12):
        take SetThrottleAction(0), SetBrakeAction(1)
lane = Uniform(*network.lanes)
lead = new Car on lane.centerline, with behavior FollowLaneBehavior(target_speed=globalParameters.SPEED)
ego = new Car following roadDirection from lead for -1 * GAP, with behavior Follow()
require (distance from ego to intersection) > 30
require (distance from lead to intersection) > 30
terminate after 8 seconds
"""
TURN = """model scenic.simulators.carla.model
junction = Uniform(*filter(lambda i: i.is4Way, network.intersections))
turn = Uniform(*filter(lambda m: m.type is ManeuverType.{turn}, junction.maneuvers))
way = [turn.startLane, turn.connectingLane, turn.endLane]
behavior Drives(trajectory):
    do FollowTrajectoryBehavior(target_speed=8, trajectory=trajectory)
start = new OrientedPoint in turn.startLane.centerline
ego = new Car at start, with blueprint 'vehicle.lincoln.mkz_2017', with behavior Drives(way)
require 15 <= (distance from ego to junction) <= 30
terminate after 4 seconds
"""
LIGHT = """model scenic.simulators.carla.model
lit = filter(lambda i: i.signals and all([s.isTrafficLight for s in i.signals]), network.intersections)
junction = Uniform(*lit)
lane = Uniform(*junction.incomingLanes)
ego = new Car on lane.centerline, with behavior AutopilotBehavior()
monitor Lights():
    freezeTrafficLights()
    setClosestTrafficLightStatus(ego, '{colour}')
    wait
    require getClosestTrafficLightStatus(ego) == '{colour}'
    while True:
        wait
require monitor Lights()
require 30 <= (distance from ego to junction) <= 40
terminate after 12 seconds
"""


class Coast:
    """An ego that does nothing."""

    def act(self, observation: Observation) -> tuple[float, float]:
        return 0.0, 0.0


class Go:
    """An ego that holds half the pedal and the wheel straight."""

    def act(self, observation: Observation) -> tuple[float, float]:
        return 0.5, 0.0


@pytest.fixture(scope="module")
def simulator() -> Simulator:
    return load_simulator(TOWN, SimulationSettings())


def scene_of(program: ScenicProgram, seed: int = 1, **values: float) -> Scene:
    middle = {p.name: (p.low + p.high) / 2 for p in program.parameters}
    return Scene(id=f"s/{seed}", scenario_id="s", route=0, block=0, seed=seed, values=middle | values)


def driven(simulator: Simulator, program: ScenicProgram, scene: Scene, ego: Any = None) -> Episode:
    episode = simulate(simulator, program, scene, ego or Coast())
    assert isinstance(episode, Episode), episode
    return episode


def same(a: Episode, b: Episode) -> bool:
    return len(a.tracks) == len(b.tracks) and all(
        np.array_equal(getattr(one, name), getattr(other, name))
        for one, other in zip(a.tracks, b.tracks, strict=True)
        for name in ("x", "y", "heading", "speed")
    )


def test_numbers_that_are_written_out_at_the_top_are_the_parameters_of_a_search() -> None:
    found = foreign_program("lead", LEAD).parameters
    assert [(p.name, p.low, p.high) for p in found] == [("OPT_GAP", 15.0, 30.0), ("OPT_SPEED", 4.0, 8.0)]


def test_a_choice_and_a_whole_number_are_searched_too(simulator: Simulator) -> None:
    text = "model scenic.domains.driving.model\nN = DiscreteRange(2, 4)\nS = -1 * Uniform(5, 9)\n" + (
        "ego = new Car with behavior FollowLaneBehavior(), with length N, with width S / -5\n"
    )
    program = foreign_program("choice", text)
    assert [(p.name, p.low, p.high) for p in program.parameters] == [("OPT_N", 1.5, 4.5), ("OPT_S", 0.0, 2.0)]
    ego = driven(simulator, program, scene_of(program, OPT_N=3.6, OPT_S=1.2)).ego_track
    assert (ego.length, ego.width) == (4, 1.8)
    ego = driven(simulator, program, scene_of(program, OPT_N=2.2, OPT_S=0.4)).ego_track
    assert (ego.length, ego.width) == (2, 1.0)


def test_a_scene_is_the_same_for_the_same_seed_in_any_process_and_another_for_another(simulator: Simulator) -> None:
    program = foreign_program("lead", LEAD, as_written=True)
    first = driven(simulator, program, scene_of(program))
    assert {track.role for track in first.tracks} == {Role.EGO, Role.ADVERSARY}
    assert same(first, driven(simulator, program, scene_of(program)))
    assert same(first, driven(load_simulator(TOWN, SimulationSettings()), program, scene_of(program)))
    with ConfinedSimulator(TOWN, SimulationSettings()) as elsewhere:
        assert same(first, driven(elsewhere, program, scene_of(program)))
        assert elsewhere.route_in(program, scene_of(program)).id == simulator.route_in(program, scene_of(program)).id
    assert not same(first, driven(simulator, program, scene_of(program, seed=2)))


def test_a_searched_value_moves_what_the_program_makes_of_it(simulator: Simulator) -> None:
    program = foreign_program("lead", LEAD)
    gaps = []
    for gap in (16.0, 28.0):
        ego, lead = driven(simulator, program, scene_of(program, OPT_GAP=gap)).tracks
        gaps.append(np.hypot(ego.x[0] - lead.x[0], ego.y[0] - lead.y[0]))
    assert gaps == pytest.approx([16.0, 28.0], abs=0.5)


def test_the_ego_under_test_drives_in_the_place_of_the_programs_own_unless_it_is_to_drive_as_written(
    simulator: Simulator,
) -> None:
    scene = scene_of(foreign_program("lead", LEAD))
    tested = driven(simulator, foreign_program("lead", LEAD), scene)
    assert tested.ego_track.speed.max() == 0.0
    written = driven(simulator, foreign_program("lead", LEAD, as_written=True), scene)
    assert written.ego_track.speed.max() > 3.0
    assert same(written, driven(simulator, foreign_program("lead", LEAD, as_written=True), scene, Go()))


@pytest.mark.parametrize(("turn", "maneuver"), [("LEFT_TURN", "left-turn"), ("STRAIGHT", "straight")])
def test_the_egos_route_is_the_way_that_its_behavior_is_given(simulator: Simulator, turn: str, maneuver: str) -> None:
    program = foreign_program("turn", TURN.format(turn=turn))
    route = simulator.route_in(program, scene_of(program))
    assert route.maneuver is Maneuver(maneuver)
    assert route.junction
    assert 10 < route.event_at < 40
    ego = driven(simulator, program, scene_of(program)).ego_track
    assert route.line.points[0] == pytest.approx((ego.x[0], ego.y[0]), abs=0.1)
    assert (ego.length, ego.width) == pytest.approx((4.90, 2.13), abs=0.01)  # the size of that blueprint in CARLA


@pytest.mark.parametrize(("turn", "maneuver"), [("LEFT_TURN", "left-turn"), ("STRAIGHT", "straight")])
def test_an_ego_without_a_behavior_goes_the_way_that_the_program_names(
    simulator: Simulator, turn: str, maneuver: str
) -> None:
    text = TURN.format(turn=turn).replace(", with behavior Drives(way)", "")
    other = "any_ = Uniform(*turn.startLane.maneuvers)\nalso = [any_.startLane, any_.connectingLane, any_.endLane]\n"
    program = foreign_program("way", text.replace("way = ", "egoWay = ").replace("behavior", f"{other}behavior", 1))
    assert simulator.route_in(program, scene_of(program)).maneuver is Maneuver(maneuver)


@pytest.mark.parametrize(("colour", "moves"), [("red", False), ("green", True)])
def test_an_autopilot_obeys_the_light_that_a_program_sets(simulator: Simulator, colour: str, moves: bool) -> None:
    program = foreign_program("light", LIGHT.format(colour=colour), as_written=True)
    drive = driven(simulator, program, scene_of(program))
    assert any(signal.role == "ego" and set(signal.state[1:]) == {colour[0]} for signal in drive.signals)
    assert bool(drive.ego_track.speed[-1] > 2.0) is moves
    assert drive.ego_track.speed.max() > 4.0


@pytest.mark.parametrize(
    ("action", "message"),
    [
        ("SetTransformAction(ego.position, 0)", "moves an actor without driving it"),
        ("SetPositionAction(ego.position)", "nothing jumps here"),
        ("SetAutopilotAction(True, path=[1])", "takes no path"),
        ("SetJumpAction(True)", "nobody jumps here"),
    ],
)
def test_what_no_body_does_is_refused_by_name(simulator: Simulator, action: str, message: str) -> None:
    text = f"model scenic.simulators.carla.model\nbehavior B():\n    take {action}\nego = new Car with behavior B()\n"
    with pytest.raises(ProgramError, match=message):
        driven(simulator, foreign_program("b", text, as_written=True), scene_of(foreign_program("b", text)))


def test_a_program_that_can_hardly_be_drawn_says_how_often_it_was_tried_and_why_not(
    simulator: Simulator, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(staging, "DRAWING", 0.2)
    program = foreign_program("far", LEAD + "require ego.position.x > 100000\n")
    outcome = simulate(simulator, program, scene_of(program), Coast())
    assert isinstance(outcome, Rejected)
    assert "draws in 0 s of processor time meets the requirements" in outcome.reason
    assert "times: " in outcome.reason


def test_how_many_draws_a_scene_took_is_known(simulator: Simulator) -> None:
    program = foreign_program("lead", LEAD)
    session: Any = simulator.open(program, scene_of(program))
    assert session.draws >= 1
    session.close()


def test_a_name_that_the_map_has_not_is_said(simulator: Simulator) -> None:
    program = foreign_program(
        "named", "model scenic.domains.driving.model\nego = new Car on network.elements['road69']"
    )
    with pytest.raises(DoesNotCompile, match="line 2: KeyError: there is no 'road69'"):
        driven(simulator, program, scene_of(program))


def test_a_map_whose_name_is_too_long_for_any_file_is_not_there(tmp_path: Path) -> None:
    class Told(Exception):  # noqa: N818 - the run need not go on
        pass

    def progress(said: str, _done: int, _all: int) -> None:
        raise Told(said)

    file = tmp_path / "lead.scenic"
    file.write_text(LEAD.replace("Town01", "T" * 300), encoding="utf-8")
    with pytest.raises(Told, match=r"TTT\.xodr does not exist; it runs on town"):
        api.run(program=file, folder=tmp_path / "run", progress=progress)


def test_a_run_of_a_program_that_is_drawn_is_replayed_bit_for_bit_from_its_seed(tmp_path: Path) -> None:
    file = tmp_path / "lead.scenic"
    file.write_text(LEAD.replace("Town01", "nowhere"), encoding="utf-8")
    told: list[str] = []
    api.run(
        program=file,
        folder=tmp_path / "run",
        trust=True,
        ego="idm",
        scenes=2,
        progress=lambda said, _done, _all: told.append(said),
    )
    assert any("nowhere.xodr does not exist; it runs on town" in said for said in told)
    scene = "lead/route-00/scene-001"
    again = api.replay(tmp_path / "run", scene, generator=(generator_for(trusted=True, as_written=False),))
    assert again.identical, again.difference
    with pytest.raises(RunError, match="If you trust it, say so: --generator"):
        api.replay(tmp_path / "run", scene)


def test_who_trusts_a_program_lets_it_use_all_of_python_and_is_told_what_is_not_installed(simulator: Simulator) -> None:
    text = "import math\nimport {module}\n" + LEAD
    program = foreign_program("own", text.format(module="json"), trusted=True)
    assert driven(simulator, program, scene_of(program)).tracks
    absent = foreign_program("own", text.format(module="not_installed_anywhere"), trusted=True)
    with pytest.raises(DoesNotCompile, match="No module named 'not_installed_anywhere'"):
        driven(simulator, absent, scene_of(absent))


def test_a_program_of_scenic_2_drives_as_its_twin_in_scenic_3(simulator: Simulator) -> None:
    idle = "monitor Idle:\n    while True:\n        wait\n"
    older = LEAD.replace("new ", "").replace("terminate after", f"{idle}terminate after")
    program = foreign_program("lead", as_scenic_3(older).source, as_written=True)
    assert same(
        driven(simulator, program, scene_of(program)),
        driven(simulator, foreign_program("lead", LEAD, as_written=True), scene_of(program)),
    )


def test_draws_that_ask_for_what_the_map_has_not_there_are_drawn_anew(simulator: Simulator) -> None:
    text = "model scenic.domains.driving.model\nego = new Car\nleft = network.laneSectionAt(ego)._laneToLeft\n" + (
        "require left.lane is not ego.lane\nother = new Car at left.lane.centerline.start, with requireVisible False\n"
    )
    beside = foreign_program("beside", text)
    driven(simulator, beside, scene_of(beside))
    never = foreign_program("never", text.replace("laneSectionAt(ego)._laneToLeft", "crossingAt(ego)"))
    with pytest.raises(ProgramError, match="AttributeError: 'NoneType' object has no attribute 'lane'"):
        driven(simulator, never, scene_of(never))


CHOSEN = """model scenic.domains.driving.model
junction = Uniform(*filter(lambda i: i.is4Way, network.intersections))
turn = Uniform(*filter(lambda m: m.type is ManeuverType.{turn}, junction.maneuvers))
start = new OrientedPoint in turn.startLane.centerline
beside = network.laneSectionAt(start)._laneTo{side}.lane
ego = new Car at start
other = new Car at beside.centerline.start, with requireVisible False
"""


def test_a_map_without_what_a_program_chooses_is_refused_by_what_could_be_chosen(simulator: Simulator) -> None:
    program = foreign_program("right", CHOSEN.format(turn="RIGHT_TURN", side="Right"))
    outcome = simulate(simulator, program, scene_of(program), Coast())
    assert isinstance(outcome, Rejected)
    assert outcome.reason.startswith(
        "town has no such place: in each of the 16 choices of junction and turn, drawn 200"
    )
    assert outcome.draws == staging.NEVER


def test_a_map_on_which_nothing_is_left_to_choose_from_is_refused_by_the_last_choice(simulator: Simulator) -> None:
    text = "of_it = Uniform(*filter(lambda m: m.type is ManeuverType.U_TURN, turn.conflictingManeuvers))\n"
    program = foreign_program("u", CHOSEN.format(turn="STRAIGHT", side="Left").replace("ego =", f"{text}ego ="))
    program = foreign_program("u", program.source + "new Car at of_it.startLane.centerline.start\n")
    outcome = simulate(simulator, program, scene_of(program), Coast())
    assert isinstance(outcome, Rejected)
    assert "each of the 24 choices of junction and turn leaves nothing to choose of_it from" in outcome.reason


def test_what_serves_seldom_is_drawn_among_the_choices_that_serve(
    simulator: Simulator, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(staging, "NEVER", 2)
    program = foreign_program("left", CHOSEN.format(turn="LEFT_TURN", side="Right") + "x = 1\n")
    sessions = [simulator.open(program, scene_of(program, seed=seed)) for seed in (1, 2, 3, 4, 5, 6)]
    assert all(not isinstance(one, Rejected) for one in sessions)
    known = staging._compiled_apart.values()  # pyright: ignore[reportPrivateUsage]
    counted = [one for one in known if one.choices is not None and one.choices.ways]
    assert [len(one.choices.ways) for one in counted if one.choices] == [8]  # of 16


def test_an_ego_goes_along_a_line_of_points_that_begins_where_it_stands(simulator: Simulator) -> None:
    turn = foreign_program("turn", TURN.format(turn="LEFT_TURN").replace("with behavior Drives(way)", "with speed 0"))
    way = simulator.route_in(turn, scene_of(turn)).line  # straight on, as nothing says otherwise
    points = [(round(x, 2), round(y, 2)) for x, y in way.resampled(5.0).points[:8].tolist()]
    text = (
        "model scenic.domains.driving.model\nbehavior B():\n    wait\n"
        f"way = PolylineRegion({points})\n"
        "ego = new Car at way.start, facing way.orientation[way.start.position], with behavior B()\n"
    )
    along = foreign_program("along", text)
    assert simulator.route_in(along, scene_of(along)).line.length == pytest.approx(35, abs=0.5)
    other = foreign_program("other", text.replace("way.start,", "way.end,"))
    assert simulator.route_in(other, scene_of(other)).line.length > 36


def test_a_series_gives_another_number_in_each_step_and_the_same_ones_for_the_same_seed(simulator: Simulator) -> None:
    behavior = "behavior Moves():\n    while True:\n        take SetThrottleAction(series.getSample())\n"
    text = f"model scenic.domains.driving.model\nseries = TimeSeries(VerifaiRange(0, 1))\n{behavior}"
    program = foreign_program("series", text + "ego = new Car on road, with behavior Moves\n", as_written=True)
    assert program.parameters == ()  # it is no value of a search
    first, again = (driven(simulator, program, scene_of(program)) for _ in range(2))
    gains = np.diff(np.asarray(first.ego_track.speed))
    assert len(set(np.round(gains[1:20], 6))) > 10
    assert list(first.ego_track.speed) == list(again.ego_track.speed)


def test_a_sub_scenario_at_the_top_level_is_begun_in_one_scene_after_another(simulator: Simulator) -> None:
    sub = "scenario Others():\n    setup:\n        one = new Car ahead of ego by 20, with requireVisible False\n"
    main = "scenario Main():\n    setup:\n        ego = new Car on road\n    compose:\n        do others\n"
    text = f"model scenic.domains.driving.model\n{sub}others = Others()\n{main}terminate after 1 seconds\n"
    program = foreign_program("again", text)
    for seed in (1, 2):
        assert len(driven(simulator, program, scene_of(program, seed=seed)).tracks) == 2
