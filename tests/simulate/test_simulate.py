"""The embedded simulator on small programs whose outcome is known."""

import math
import re
import signal
import time
from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from chatscene.ego.observation import Observation
from chatscene.ego.policy import EgoPolicy, cut_off
from chatscene.ego.rule_based import TARGET_SPEED, RuleBased
from chatscene.errors import DoesNotCompile, EgoError, MapError, ProgramError, SettingsError, StuckBehavior
from chatscene.maps.network import resolve_map
from chatscene.settings import SimulationSettings
from chatscene.simulate import staging, watchdog
from chatscene.simulate.simulator import Simulator, load_simulator, simulate, telling
from chatscene.terms.episode import Ending, Episode, EventKind, Role
from chatscene.terms.scene import Rejected, Scene, ScenicProgram
from chatscene.world.compilation import compile_program

HEAD = """
model chatscene.world.model
egoRoute = selectRoute(maneuver="straight")
"""
EGO = "ego = new Car at pointOn(egoRoute, 0), facing directionOn(egoRoute, 0), with route egoRoute\n"
WALL = HEAD + EGO + "new Container at pointOn(egoRoute, 40), facing directionOn(egoRoute, 40)\n"
MOVING = HEAD + (
    "behavior AdvBehavior():\n    {body}\n" + EGO + "AdvAgent = new {kind} at pointOn(egoRoute, {ahead}, {left}), "
    "facing directionOn(egoRoute, {ahead}, {turn}), with behavior AdvBehavior()\n"
)


class Coast:
    """An ego that does nothing."""

    def act(self, observation: Observation) -> tuple[float, float]:
        return 0.0, 0.0


@pytest.fixture(scope="module")
def simulator() -> Simulator:
    return load_simulator(resolve_map("town"), SimulationSettings())


def program(source: str) -> ScenicProgram:
    return ScenicProgram(scenario_id="toy", source=source, parameters=(), snippet_ids=())


def scene(route: int = 0, **values: float) -> Scene:
    return Scene(id=f"toy/{route}", scenario_id="toy", route=route, block=0, seed=0, values=values)


def moving(body: str, *, kind: str = "Car", ahead: float = 30, left: float = 0, turn: float = 0) -> ScenicProgram:
    return program(MOVING.format(body=body, kind=kind, ahead=ahead, left=left, turn=turn))


@pytest.fixture
def drive(simulator: Simulator) -> Callable[..., Episode]:
    def run(what: ScenicProgram, ego: EgoPolicy | None = None, **options: Any) -> Episode:
        episode = simulate(simulator, what, scene(), ego or RuleBased(), **options)
        assert isinstance(episode, Episode)
        return episode

    return run


def test_an_empty_road_is_driven_to_its_end(drive: Callable[..., Episode]) -> None:
    episode = drive(program(HEAD + EGO))
    assert episode.ending is Ending.ARRIVED
    assert episode.route_completion == 1.0
    assert not episode.events
    assert episode.distance_to_route.max() < 0.2
    assert episode.ego_track.speed.max() == pytest.approx(TARGET_SPEED, abs=0.3)


def test_a_wall_in_the_lane_is_hit_with_the_front_at_the_ego_s_own_speed(drive: Callable[..., Episode]) -> None:
    crash = drive(program(WALL)).collision
    assert crash is not None
    assert (crash.other, crash.side) == ("container", "front")
    assert crash.impact_speed == pytest.approx(TARGET_SPEED, abs=0.3)


class Swings:
    """An ego that turns right and left in turn, half a second each."""

    def __init__(self) -> None:
        self._step = 0

    def act(self, observation: Observation) -> tuple[float, float]:
        self._step += 1
        return 0.8, 0.6 if self._step // 5 % 2 else -0.6


@pytest.mark.parametrize("kind", ["embedded", "native"])
def test_who_turns_is_hit_as_fast_as_both_were_before_the_step(kind: str) -> None:
    where = load_simulator(resolve_map("town"), SimulationSettings(simulator=kind))
    episode = simulate(where, moving("do DrivePath(egoRoute, 3)", ahead=20), scene(), Swings())
    assert isinstance(episode, Episode)
    crash, ego = episode.collision, episode.ego_track
    assert crash is not None
    other, step = next(track for track in episode.tracks if track.actor == crash.other), crash.step - 1
    assert ego.heading[step] != ego.heading[step + 1]
    mine, theirs = (
        track.speed[step] * np.array((np.cos(track.heading[step]), np.sin(track.heading[step])))
        for track in (ego, other)
    )
    assert crash.impact_speed == pytest.approx(float(np.hypot(*(mine - theirs))), abs=1e-12)


def test_an_ego_that_does_nothing_runs_out_of_time(drive: Callable[..., Episode]) -> None:
    episode = drive(program(HEAD + EGO), Coast())
    assert episode.ending is Ending.TIMEOUT
    assert len(episode.ego_track.x) == 301


def test_the_ego_brakes_for_a_vehicle_ahead_but_not_for_a_pedestrian(drive: Callable[..., Episode]) -> None:
    assert drive(moving("do Park()", ahead=60)).collision is None
    assert drive(moving("do Halt()", kind="Pedestrian", ahead=60)).collision is not None


def test_a_vehicle_beside_does_not_hide_the_one_ahead(drive: Callable[..., Episode]) -> None:
    # Both stand within sight at once; the one beside the lane was made first.
    beside = "new Car at pointOn(egoRoute, 58, -3.5), facing directionOn(egoRoute, 58)\n"
    ahead = "new Car at pointOn(egoRoute, 60), facing directionOn(egoRoute, 60)\n"
    assert drive(program(HEAD + EGO + beside + ahead)).collision is None


def test_a_drive_can_go_on_through_a_collision(drive: Callable[..., Episode]) -> None:
    through = drive(program(WALL), through_collisions=True)
    assert through.collision is not None
    assert through.ending is Ending.ARRIVED


def test_tracks_name_their_parts(drive: Callable[..., Episode]) -> None:
    source = MOVING.format(body="do Park()", kind="Truck", ahead=50, left=0, turn=0)
    source += "new BusStop at pointOn(egoRoute, 20, -6), facing directionOn(egoRoute, 20)\n"
    source += "new Car at pointOn(egoRoute, 80), facing directionOn(egoRoute, 80), "
    source += "with behavior Park(), with label 'leader'\n"
    roles = [(t.actor, t.role, t.kind) for t in drive(program(source)).tracks]
    assert roles == [
        ("ego", Role.EGO, "Car"),
        ("adversary", Role.ADVERSARY, "Truck"),
        ("leader", Role.BACKGROUND, "Car"),
        ("busstop", Role.OCCLUDER, "BusStop"),
    ]


@pytest.mark.parametrize("kind", ["Car", "Truck", "Bus", "Motorcycle", "Bicycle"])
def test_every_vehicle_follows_a_path_at_a_speed(drive: Callable[..., Episode], kind: str) -> None:
    track = drive(moving("do DrivePath(egoRoute, 6)", kind=kind, ahead=20), Coast()).adversaries[0]
    assert track.speed[-1] == pytest.approx(6.0, abs=0.4)
    assert np.abs(np.diff(track.speed)).max() < 1.0


@pytest.mark.parametrize("kind", ["Pedestrian", "Bicycle", "Motorcycle"])
def test_walkers_and_riders_cross_where_they_look(drive: Callable[..., Episode], kind: str) -> None:
    track = drive(moving("do MoveAhead(2)", kind=kind, ahead=30, left=-6, turn=math.pi / 2), Coast()).adversaries[0]
    moved = math.hypot(track.x[60] - track.x[0], track.y[60] - track.y[0])
    assert 8.0 < moved < 12.5


def test_a_behavior_that_asks_for_a_speed_at_once_gets_it_within_limits(drive: Callable[..., Episode]) -> None:
    body = "while True:\n        take SetSpeedAction(15)"
    track = drive(moving(body, ahead=20), Coast()).adversaries[0]
    assert np.diff(track.speed).max() <= 0.451


def test_an_episode_is_the_same_whatever_ran_before(simulator: Simulator) -> None:
    def once(what: Simulator) -> list[bytes]:
        episode = simulate(what, moving("do WeaveOnPath(egoRoute, 7, 1.5, 3)", ahead=15), scene(), RuleBased())
        assert isinstance(episode, Episode)
        return [a.tobytes() for t in episode.tracks for a in (t.x, t.y, t.heading, t.speed)]

    fresh = load_simulator(resolve_map("town"), SimulationSettings())
    first = once(fresh)
    simulate(simulator, program(WALL), scene(), RuleBased())
    assert once(simulator) == first
    assert once(simulator) == first


def test_actors_that_stand_in_each_other_are_rejected_with_their_names(simulator: Simulator) -> None:
    tuned = moving("do Park()", ahead=0).source.replace("egoRoute, 0, 0)", "egoRoute, globalParameters.OPT_GEO_Y, 0)")
    outcome = simulate(simulator, program("param OPT_GEO_Y = Range(0, 9)\n" + tuned), scene(OPT_GEO_Y=2.0), RuleBased())
    assert isinstance(outcome, Rejected)
    assert outcome.reason == "adversary overlaps ego at the start"


def test_a_requirement_that_fails_is_a_rejection(simulator: Simulator) -> None:
    source = (
        HEAD + "param OPT_GEO_Y = Range(10, 20)\ny = globalParameters.OPT_GEO_Y\n" + EGO + "require y > 15 as far\n"
    )
    low = simulate(simulator, program(source), scene(OPT_GEO_Y=11.0), RuleBased())
    assert isinstance(low, Rejected)
    assert "far" in low.reason
    assert isinstance(simulate(simulator, program(source), scene(OPT_GEO_Y=16.0), RuleBased()), Episode)


def test_a_place_that_is_not_there_is_a_rejection(simulator: Simulator) -> None:
    source = (
        HEAD.replace('"straight"', '"straight", place="four-way"')
        + "param OPT_GEO_Y = Range(10, 60)\n"
        + EGO
        + 'new Pedestrian at besideRoad(egoRoute, globalParameters.OPT_GEO_Y, "left", 1)\n'
    )
    along_the_crossing_road = simulate(simulator, program(source), scene(OPT_GEO_Y=56.0), RuleBased())
    assert isinstance(along_the_crossing_road, Rejected)
    assert "edge of the road" in along_the_crossing_road.reason
    assert isinstance(simulate(simulator, program(source), scene(OPT_GEO_Y=12.0), RuleBased()), Episode)


def test_a_place_that_is_never_there_does_not_compile(simulator: Simulator) -> None:
    source = HEAD.replace('"straight"', '"straight", place="four-way"') + EGO
    with pytest.raises(DoesNotCompile, match="no left edge"):
        simulate(
            simulator, program(source + 'new Pedestrian at besideRoad(egoRoute, 56, "left", 1)\n'), scene(), RuleBased()
        )


def test_values_must_be_those_the_program_tunes(simulator: Simulator) -> None:
    with pytest.raises(ProgramError, match="OPT_GEO_Y"):
        simulate(simulator, program(HEAD + EGO), scene(OPT_GEO_Y=1.0), RuleBased())


@pytest.mark.filterwarnings("ignore::pytest.PytestUnraisableExceptionWarning")  # where the first alarm was lost
def test_a_behavior_that_never_yields_is_stopped(simulator: Simulator, monkeypatch: pytest.MonkeyPatch) -> None:
    stuck = moving("while True:\n        x = 1\n    take SetThrottleAction(0)")
    simulator.routes(stuck)  # compiled in its own time
    monkeypatch.setattr(watchdog, "PATIENCE", 0.5)
    with pytest.raises(StuckBehavior, match=r"0\.5 s of processor time.*loops without"):
        simulate(simulator, stuck, scene(), RuleBased())
    monkeypatch.undo()
    assert isinstance(simulate(simulator, program(WALL), scene(), RuleBased()), Episode)


@pytest.mark.filterwarnings("ignore::pytest.PytestUnraisableExceptionWarning")  # where the first alarm was lost
def test_a_program_that_never_compiles_is_stopped(simulator: Simulator, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(watchdog, "PATIENCE", 0.5)
    with pytest.raises(StuckBehavior, match=r"'toy', being compiled, did not come back within 0\.5 s of processor"):
        simulator.routes(program(HEAD + "while True:\n    pass\n"))
    monkeypatch.undo()
    assert isinstance(simulate(simulator, program(WALL), scene(), RuleBased()), Episode)


class _Does:
    """An ego that drives straight on, and does something else first."""

    def __init__(self, first: Callable[[], object]) -> None:
        self._first = first

    def act(self, observation: Observation) -> tuple[float, float]:
        self._first()
        return 0.0, 0.0


def test_time_in_which_a_drive_has_not_the_processor_is_not_counted(
    simulator: Simulator, monkeypatch: pytest.MonkeyPatch
) -> None:
    simulator.routes(program(WALL))
    monkeypatch.setattr(watchdog, "PATIENCE", 1.0)
    breaks = iter([1.2])  # as for a process that does not get its turn
    outcome = simulate(simulator, program(WALL), scene(), _Does(lambda: time.sleep(next(breaks, 0.0))))
    assert isinstance(outcome, Episode)


def test_what_a_program_takes_to_compile_is_not_counted_as_driving(
    simulator: Simulator, monkeypatch: pytest.MonkeyPatch
) -> None:
    simulate(simulator, program(WALL), scene(), RuleBased())
    another = program(WALL + "# another program\n")
    left: list[float] = []

    def slowly(*arguments: Any, **named: Any) -> Any:
        _compute(2.0)
        return compile_program(*arguments, **named)

    monkeypatch.setattr(staging, "compile_program", slowly)
    simulate(simulator, another, scene(), _Does(lambda: left.append(signal.getitimer(signal.ITIMER_PROF)[0])))
    assert watchdog.PATIENCE - left[0] < 2.0  # opening a session takes processor time, and more on a busy machine


def test_a_program_compiles_and_runs_though_a_session_was_left_open(simulator: Simulator) -> None:
    left = simulator.open(program(WALL), scene())
    assert not isinstance(left, Rejected)
    compile_program(program(WALL).source, map_path=resolve_map("town"), route=0)
    assert isinstance(simulate(simulator, program(WALL), scene(), RuleBased()), Episode)


def _compute(seconds: float) -> None:
    until = time.process_time() + seconds
    while time.process_time() < until:
        pass


def test_the_clocks_of_a_time_limit_stand_while_another_runs_within_it() -> None:
    with watchdog.time_limit("outer"):
        before = signal.getitimer(signal.ITIMER_PROF)[0]
        with watchdog.time_limit("inner"):
            _compute(0.3)
        assert before - signal.getitimer(signal.ITIMER_PROF)[0] < 0.2
        with pytest.raises(StuckBehavior, match="outer"):
            signal.raise_signal(signal.SIGPROF)
    assert signal.getitimer(signal.ITIMER_PROF) == signal.getitimer(signal.ITIMER_REAL) == (0.0, 0.0)


def test_the_clocks_of_a_time_limit_stand_while_a_server_loads_a_map() -> None:
    with watchdog.time_limit("a scene"):
        before = signal.getitimer(signal.ITIMER_PROF)[0]
        with watchdog.unlimited():
            assert signal.getitimer(signal.ITIMER_PROF) == signal.getitimer(signal.ITIMER_REAL) == (0.0, 0.0)
            _compute(0.3)
        assert before - signal.getitimer(signal.ITIMER_PROF)[0] < 0.2
        assert signal.getitimer(signal.ITIMER_REAL)[0] > 0.0


def test_an_ego_that_waits_for_ever_is_stopped_by_the_clock_on_the_wall(simulator: Simulator) -> None:
    def block() -> None:
        signal.setitimer(signal.ITIMER_REAL, 0.01)  # the minutes have passed
        time.sleep(600)

    with pytest.raises(EgoError, match=r"_Does.*step 0.*after 300 s, in which it computed for .*waits.*too much else"):
        simulate(simulator, program(WALL), scene(), _Does(block))
    assert isinstance(simulate(simulator, program(WALL), scene(), RuleBased()), Episode)


def test_a_fault_in_an_ego_names_the_ego(simulator: Simulator) -> None:
    class Broken:
        def act(self, observation: Observation) -> tuple[float, float]:
            raise OSError("no camera")

    with pytest.raises(EgoError, match=r"Broken.*step 0.*no camera"):
        simulate(simulator, program(HEAD + EGO), scene(), Broken())


def test_a_fault_in_a_behavior_names_the_program(simulator: Simulator) -> None:
    with pytest.raises(ProgramError, match=r"toy.*TypeError"):
        simulate(simulator, moving("take SetThrottleAction(1 + 'x')"), scene(), RuleBased())
    assert isinstance(simulate(simulator, program(WALL), scene(), RuleBased()), Episode)


RAISED = r"(ZeroDivision|Key|FileNotFound|Index|Value|Name|Runtime)Error|StopIteration"


@pytest.mark.parametrize(
    "fault", ["1 / 0", "{}['x']", "open('no/such/file')", "next(iter(()))", "[].pop()", "int('x')", "no_such_name"]
)
def test_whatever_a_program_s_own_code_raises_is_one_error_that_names_the_program(
    simulator: Simulator, fault: str
) -> None:
    compiling = program(HEAD + f"x = {fault}\n" + EGO)
    placing = program(
        HEAD
        + f"def fails(x):\n    return {fault}\nparam OPT_X = Range(0, 1)\n"
        + EGO
        + "require fails(globalParameters.OPT_X)\n"
    )
    driving = moving(f"x = {fault}\n    take SetThrottleAction(0)")
    for broken, where in ((compiling, scene()), (placing, scene(OPT_X=0.5)), (driving, scene())):
        with pytest.raises(ProgramError, match=rf"toy.*({RAISED})"):
            simulate(simulator, broken, where, RuleBased())
    assert isinstance(simulate(simulator, program(WALL), scene(), RuleBased()), Episode)


@pytest.mark.parametrize("line", ["ego = new Car at (", "x = undefinedName + 1", "import no_such_module_at_all"])
def test_a_program_that_scenic_refuses_is_named_with_its_line(simulator: Simulator, line: str) -> None:
    with pytest.raises((DoesNotCompile, ProgramError)):
        simulate(simulator, program(HEAD + line + "\n"), scene(), RuleBased())


def test_a_route_that_the_map_has_not_is_refused(simulator: Simulator) -> None:
    with pytest.raises(MapError, match="10 routes"):
        simulate(simulator, program(HEAD + EGO), scene(route=10), RuleBased())
    assert simulator.routes(program(HEAD + EGO)) == 10


def placed(what: str, *, head: str = HEAD, body: str = "do FollowLaneBehavior(6)") -> ScenicProgram:
    return program(f"{head}behavior AdvBehavior():\n    {body}\n{EGO}AdvAgent = {what}, with behavior AdvBehavior()\n")


def test_a_class_of_one_s_own_moves_like_the_one_it_is_made_of(drive: Callable[..., Episode]) -> None:
    lorry = "class Lorry(Truck):\n    length: 6.5\n    width: 2.2\n"
    track = drive(placed("new Lorry ahead of ego by 20", head=HEAD + lorry)).adversaries[0]
    assert (track.kind, track.length, track.width) == ("Truck", 6.5, 2.2)
    assert track.speed[-1] == pytest.approx(6.0, abs=0.4)


def test_a_size_that_a_program_gives_is_the_size_of_the_body(drive: Callable[..., Episode]) -> None:
    what = "new {} at pointOn(egoRoute, 60, -3.4), facing directionOn(egoRoute, 60)"
    for size, met in (("", False), (", with width 5", True)):
        still = drive(placed(what.format("Car") + size, body="do Park()"), through_collisions=True)
        assert (still.collision is not None) == met
    assert still.adversaries[0].width == 5.0
    walker = drive(placed(what.format("Pedestrian") + ", with length 0.4", body="do Halt()"))
    assert walker.adversaries[0].length == 0.4


def test_a_longer_vehicle_turns_on_a_wider_circle_but_on_the_one_it_is_asked_for(drive: Callable[..., Episode]) -> None:
    def radius(length: float, body: str) -> float:
        what = f"new Car at pointOn(egoRoute, 60), facing directionOn(egoRoute, 60), with length {length}"
        track = drive(placed(what, body=body), Coast()).adversaries[0]
        driven = slice(60, 80)
        turned = abs(float(np.unwrap(track.heading[driven])[-1] - np.unwrap(track.heading[driven])[0]))
        return float(np.hypot(np.diff(track.x[driven]), np.diff(track.y[driven])).sum()) / turned

    steered = "while True:\n        take DriveAction(0.1 if self.speed < 2 else 0, 0, 0.5)"
    assert radius(9.8, steered) == pytest.approx(2 * radius(4.9, steered), rel=0.01)
    assert radius(9.8, "do TurnOff(20, 2, 12)") == pytest.approx(radius(4.9, "do TurnOff(20, 2, 12)"), rel=0.1)


@pytest.mark.parametrize("given", ["with speed 6", "with velocity Vector(0, 6)", "with speed 6, with velocity (0, 6)"])
def test_a_speed_that_a_program_gives_is_the_speed_at_the_start(drive: Callable[..., Episode], given: str) -> None:
    track = drive(placed(f"new Car ahead of ego by 20, facing 0, {given}")).adversaries[0]
    assert track.speed[0] == pytest.approx(6.0)


@pytest.mark.parametrize(
    ("given", "message"),
    [
        ("with velocity (6, 0)", "not along its heading; turn it with `facing`"),
        ("with velocity (0, 6), with speed 3", "a velocity of 6 m/s and a speed of 3 m/s"),
        ("with speed 90", "a car that begins at 90 m/s"),
        ("with width 0", "a car of 4.9 m by 0 m"),
    ],
)
def test_what_a_body_cannot_do_is_refused(simulator: Simulator, given: str, message: str) -> None:
    with pytest.raises(ProgramError, match=message):
        simulate(simulator, placed(f"new Car ahead of ego by 20, facing 0, {given}"), scene(), RuleBased())


def test_things_that_may_overlap_do(simulator: Simulator) -> None:
    tuned = f"{HEAD}param OPT_X = Range(0, 9)\n{EGO}new Kiosk at pointOn(egoRoute, 60, -9), facing 0\n"
    other = "new Kiosk at pointOn(egoRoute, 60 + globalParameters.OPT_X, -9), facing 0"
    for given, refused in (("", True), (", with allowCollisions True", False)):
        outcome = simulate(simulator, program(f"{tuned}{other}{given}\n"), scene(OPT_X=1.0), RuleBased())
        assert isinstance(outcome, Rejected) == refused


def test_a_vehicle_that_is_not_turned_faces_along_its_road(drive: Callable[..., Episode]) -> None:
    two_way = HEAD.replace('"straight"', '"straight", place="road", opposite=True')
    ego, other = drive(placed("new Car at pointOn(egoRoute, 40, 3.5)", head=two_way)).tracks
    assert math.cos(other.heading[0] - ego.heading[0]) == pytest.approx(-1.0, abs=0.01)
    ego, ahead = drive(placed("new Car ahead of ego by 20", head=two_way)).tracks
    assert ahead.heading[0] == pytest.approx(ego.heading[0])
    ego, askew = drive(placed("new Car at pointOn(egoRoute, 40), with roadDeviation 0.5", head=two_way)).tracks
    assert askew.heading[0] - ego.heading[0] == pytest.approx(0.5, abs=0.01)


@pytest.mark.parametrize("kind", ["Car", "Pedestrian", "Kiosk"])
def test_a_thing_that_is_given_no_place_is_refused(simulator: Simulator, kind: str) -> None:
    with pytest.raises(DoesNotCompile, match="no place; say where it stands"):
        simulate(simulator, program(f"{HEAD}{EGO}new {kind}\n"), scene(), RuleBased())


def test_an_ego_that_drives_itself_is_refused(simulator: Simulator) -> None:
    own = EGO.replace("with route", "with behavior FollowLaneBehavior(), with route")
    with pytest.raises(ProgramError, match=r"a behavior of its own, FollowLaneBehavior.*leave out its `with behavior"):
        simulate(simulator, program(HEAD + own), scene(), RuleBased())
    assert isinstance(simulate(simulator, program(HEAD + EGO), scene(), RuleBased()), Episode)


COMPOSED = """
scenario Main():
    setup:
        ego = new Car at pointOn(egoRoute, 0), facing directionOn(egoRoute, 0), with route egoRoute
        lead = new Car at pointOn(egoRoute, 30), facing directionOn(egoRoute, 30), with behavior DrivePath(egoRoute, 6)
        record final (distance from ego to lead) as left
    compose:
        do Stops(lead) for 2 seconds
        do Blocks()

scenario Stops(lead):
    setup:
        override lead with behavior Park()

scenario Blocks():
    setup:
        new Container at pointOn(egoRoute, 70), facing directionOn(egoRoute, 70)
        terminate after 3 seconds
"""


def test_a_program_that_is_composed_of_scenarios_does_what_they_say_one_after_the_other(simulator: Simulator) -> None:
    drive = simulate(simulator, program(HEAD + COMPOSED), scene(), Coast())
    assert isinstance(drive, Episode)
    assert drive.ending is Ending.SCENARIO_DONE
    assert len(drive.ego_track.x) == 51  # the start, 2 s, 3 s
    _, lead, block = drive.tracks
    assert lead.speed[:20].max() == 0.0  # parked while the first scenario runs
    assert lead.speed[-1] > 3.0  # then it drives again
    assert block.kind == "Container"  # placed two seconds after the start


def test_a_vehicle_that_comes_later_stands_still_until_it_is_there(simulator: Simulator) -> None:
    late = COMPOSED.replace("new Container at pointOn(egoRoute, 70)", "new Car at pointOn(egoRoute, 70)").replace(
        "facing directionOn(egoRoute, 70)\n", "facing directionOn(egoRoute, 70), with behavior DrivePath(egoRoute, 6)\n"
    )
    drive = simulate(simulator, program(HEAD + late), scene(), Coast())
    assert isinstance(drive, Episode)
    came = drive.tracks[2]
    assert came.speed[:21].max() == 0.0
    assert np.ptp(came.x[:21]) == np.ptp(came.y[:21]) == 0.0
    assert came.speed[-1] > 3.0


def test_a_vehicle_on_no_lane_cannot_follow_one_and_is_told_so(simulator: Simulator) -> None:
    with pytest.raises(ProgramError, match="stands on no lane that it could follow"):
        simulate(simulator, placed("new Car at (5000, 5000)"), scene(), RuleBased())


JUNCTION = """
model chatscene.world.model
egoRoute = selectRoute(maneuver="straight", place="four-way", control="{control}")
param signals = '{signals}'
"""


@pytest.mark.parametrize(("signals", "expected"), [("ego-red", 1), ("ego-green", 0)])
def test_a_red_light_counts_when_it_is_red(drive: Callable[..., Episode], signals: str, expected: int) -> None:
    episode = drive(program(JUNCTION.format(control="signal", signals=signals) + EGO))
    kinds = [event.kind for event in episode.events]
    assert kinds.count(EventKind.RED_LIGHT) == expected
    assert {s.role for s in episode.signals} == {"ego", "other"}


def test_a_stop_sign_counts_for_an_ego_that_does_not_stop(drive: Callable[..., Episode]) -> None:
    episode = drive(program(JUNCTION.format(control="stop-sign", signals="clock") + EGO))
    assert [event.kind for event in episode.events].count(EventKind.STOP_SIGN) == 1


def test_leaving_the_road_is_seen(drive: Callable[..., Episode]) -> None:
    class Right:
        def act(self, observation: Observation) -> tuple[float, float]:
            return 0.5, 1.0

    episode = drive(program(HEAD + EGO), Right())
    assert EventKind.OFF_ROAD in {event.kind for event in episode.events}
    assert episode.off_road.any()


def test_an_unknown_simulator_is_named_with_the_nearest() -> None:
    with pytest.raises(SettingsError, match="did you mean 'embedded'"):
        load_simulator(Path("x.xodr"), SimulationSettings(simulator="embeded"))


class _Fails:
    def act(self, observation: Observation) -> tuple[float, float]:
        return self._think(observation)

    def _think(self, observation: Observation) -> tuple[float, float]:
        return observation[400], 0.0


def test_what_an_ego_raises_is_shown_where_it_does(simulator: Simulator) -> None:
    with pytest.raises(EgoError) as failure:
        simulate(simulator, program(HEAD + EGO), scene(), _Fails())
    said, line, caret = str(failure.value).split("\n")
    assert said.startswith("the ego '_Fails' fails at step 0 of scene 'toy/0': IndexError: index 400 is out of bounds")
    assert re.search(r"test_simulate\.py, line \d+\)$", said)
    assert line == "    return observation[400], 0.0"
    assert caret == "           ^^^^^^^^^^^^^^^^"


class _FailsAtFirst:
    def reset(self) -> None:
        raise LookupError("no weights")

    def act(self, observation: Observation) -> tuple[float, float]:
        return 0.0, 0.0


def test_an_ego_that_cannot_begin_is_to_blame_itself(simulator: Simulator) -> None:
    with pytest.raises(
        EgoError, match=r"'_FailsAtFirst' fails before scene '.*': LookupError: no weights \(.*line \d+\)"
    ):
        simulate(simulator, program(HEAD + EGO), scene(), _FailsAtFirst())


class _Loud:
    def act(self, observation: Observation) -> tuple[float, float]:
        return -30.0, 2.0


def test_an_action_that_is_cut_off_is_told_once(simulator: Simulator) -> None:
    cut_off.clear()
    with pytest.warns(RuntimeWarning, match="'_Loud' answers with an acceleration of -30 and a steering of 2") as told:
        for _ in range(2):
            simulate(simulator, program(HEAD + EGO), scene(), _Loud())
    assert len(told) == 1


def test_each_drive_is_told_of_when_it_has_ended(simulator: Simulator) -> None:
    drives: list[str] = []
    with telling(lambda: drives.append("one")):
        for _ in range(2):
            simulate(simulator, program(HEAD + EGO), scene(), RuleBased())
    simulate(simulator, program(HEAD + EGO), scene(), RuleBased())
    assert drives == ["one", "one"]
