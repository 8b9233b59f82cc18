"""A scene that is made of another one of its program is the scene that Scenic places, and each keeps its own drive."""

from __future__ import annotations

import signal

import pytest

from benchmarks.differing import differences
from chatscene.ego.observation import Observation
from chatscene.ego.policy import load_ego, observation_of, pedals_of
from chatscene.maps.network import resolve_map
from chatscene.program.sample import scene_at
from chatscene.settings import SimulationSettings
from chatscene.simulate.native.binding import Bound, bind
from chatscene.simulate.native.simulator import NativeSession, NativeSimulator
from chatscene.simulate.placing import Placement
from chatscene.simulate.session import SteppedSession
from chatscene.simulate.simulator import drive, load_simulator, simulate
from chatscene.simulate.stepped import SteppedSimulator
from chatscene.terms.episode import Episode
from chatscene.terms.scene import Rejected, Scene, ScenicProgram
from chatscene.terms.snippet import ParameterRange

HEAD = """model chatscene.world.model
param OPT_AHEAD = Range(20, 90)
egoRoute = selectRoute(maneuver="straight", place="road")
ego = new Car at startOf(egoRoute), facing directionOn(egoRoute, 0), with route egoRoute
"""
AHEAD = "globalParameters.OPT_AHEAD"
PLACE = f"at pointOn(egoRoute, {AHEAD}), facing directionOn(egoRoute, {AHEAD})"
DOES = {
    "a number of a condition": f"    do DrivePath(egoRoute, {AHEAD} / 10) until gap(self, ego) < {AHEAD} / 4\n"
    "    do Halt()\n",
    "a name of the plan": f"    near = {AHEAD} / 4\n    do DrivePath(egoRoute, 5) until gap(self, ego) < near\n"
    "    do Halt()\n",
    "a name of the program": "    do DrivePath(egoRoute, 5) until gap(self, ego) < level\n    do Halt()\n",
    "a divisor": f"    do DrivePath(egoRoute, 5) until gap(self, ego) / ({AHEAD} - 10) > 1\n    do Halt()\n",
    "what others do": "    do DrivePath(egoRoute, 5) until gap(self, third) < 9\n    do Halt()\n",
    "who is meant": f"    do DrivePath(egoRoute, 5) until gap(self, third if {AHEAD} > 50 else ego) < 9\n"
    "    do Halt()\n",
    "a path": f"    do DrivePath(lane.offset({AHEAD} / 30), 5)\n",
}
ALONE = ("a path", "who is meant")  # of these each scene has lines of its own
PARAMETER = ParameterRange(name="OPT_AHEAD", low=20.0, high=90.0, unit="m")
SHARES = (0.1, 0.3, 0.5, 0.7, 0.95)


@pytest.fixture
def native() -> NativeSimulator:
    simulator = NativeSimulator(resolve_map("town"), SimulationSettings())
    if simulator.missing:
        pytest.skip(simulator.missing)
    return simulator


def _program(does: str, *, third: str = "") -> ScenicProgram:
    third = third or "third = new Car at pointOn(egoRoute, 140), facing directionOn(egoRoute, 140)\n"
    source = f"{HEAD}level = {AHEAD} / 3\nlane = ownWay(egoRoute)\n{third}behavior AdvBehavior():\n{does}"
    source += f"other = new Car {PLACE}, with behavior AdvBehavior()\n"
    return ScenicProgram(scenario_id="again", source=source, parameters=(PARAMETER,), snippet_ids=())


def _scenes(program: ScenicProgram) -> list[Scene]:
    return [scene_at(program, 0, share, name=str(number)) for number, share in enumerate(SHARES)]


def _opened(native: NativeSimulator, program: ScenicProgram, scene: Scene) -> NativeSession:
    ego = load_ego("idm")
    opened = native.open(program, scene, observation=observation_of(ego), pedals=pedals_of(ego))
    assert isinstance(opened, NativeSession)
    return opened


def _reference(session: NativeSession) -> SteppedSession:
    return session._reference  # pyright: ignore[reportPrivateUsage]


@pytest.mark.parametrize("name", DOES)
def test_a_scene_made_of_another_is_the_one_that_scenic_places(native: NativeSimulator, name: str) -> None:
    program, ego = _program(DOES[name]), load_ego("idm")
    reference = load_simulator(resolve_map("town"), SimulationSettings())
    for scene in _scenes(program):
        ours, theirs = (simulate(one, program, scene, ego) for one in (native, reference))
        assert isinstance(ours, Episode)
        assert isinstance(theirs, Episode)
        assert (differences(ours, theirs), ours.reached) == ([], theirs.reached)


@pytest.mark.parametrize("name", DOES)
def test_plans_are_bound_once_unless_lines_differ(
    native: NativeSimulator, monkeypatch: pytest.MonkeyPatch, name: str
) -> None:
    program = _program(DOES[name])
    first, second, *others = _scenes(program)
    for scene in (first, second):
        _opened(native, program, scene)
    bound: list[ScenicProgram] = []

    def noted(session: SteppedSession, program: ScenicProgram) -> Bound:
        bound.append(program)
        return bind(session, program)

    monkeypatch.setattr("chatscene.simulate.native.simulator.bind", noted)
    for scene in others:
        _opened(native, program, scene)
    assert bool(bound) is (name in ALONE)


def test_scenes_side_by_side_keep_their_own_drives(native: NativeSimulator) -> None:
    ego = load_ego("idm")
    third = f"third = new Car at pointOn(egoRoute, 50 + {AHEAD}), facing directionOn(egoRoute, 50 + {AHEAD})\n"
    program = _program(DOES["a number of a condition"], third=third)
    scenes = _scenes(program)
    expected = [simulate(native, program, scene, ego) for scene in scenes]
    sessions = [_opened(native, program, scene) for scene in scenes]
    assert len({id(_reference(one)) for one in sessions}) < len(sessions)  # most are one, in turn
    for session, scene in zip(sessions, scenes, strict=True):
        drive(session, ego, scene.id)
    for session, scene, alone in zip(sessions, scenes, expected, strict=True):
        assert isinstance(alone, Episode)
        assert differences(session.episode(scene.id, "idm"), alone) == []


class _Clocked:
    """An ego of Python's that notes how much of its clock is left."""

    name = "clocked"

    def __init__(self) -> None:
        self.left: list[float] = []

    def act(self, observation: Observation) -> tuple[float, float]:
        self.left.append(signal.getitimer(signal.ITIMER_PROF)[0])
        return 0.2, 0.0


def test_a_clock_runs_only_where_the_engine_does_not_drive_by_itself(native: NativeSimulator) -> None:
    program, known, other = _program(DOES["a name of the plan"]), load_ego("idm"), _Clocked()
    for scene in _scenes(program):
        simulate(native, program, scene, known)
        simulate(native, program, scene, other)
        assert native.bounded(program, scene, other) is False
    assert min(other.left) > 0.0
    (last,) = _scenes(program)[-1:]
    assert native.alone(program, last, other, through_collisions=False) is None
    assert isinstance(native.alone(program, last, known, through_collisions=False), NativeSession)
    assert native.bounded(program, last, known)


@pytest.fixture
def made(monkeypatch: pytest.MonkeyPatch) -> list[str]:
    """The scenes that are made of others, in order."""
    again, scenes = SteppedSimulator.again, list[str]()

    def noted(self: SteppedSimulator, session: SteppedSession, placement: Placement, scene: Scene) -> Rejected | bool:
        scenes.append(scene.id)
        return again(self, session, placement, scene)

    monkeypatch.setattr(SteppedSimulator, "again", noted)
    return scenes


def test_a_scene_that_a_second_ego_drives_is_made_once(native: NativeSimulator, made: list[str]) -> None:
    program = _program(DOES["a name of the plan"])
    *_, last = _scenes(program)
    for scene in _scenes(program):
        ours = [simulate(native, program, scene, load_ego(ego)) for ego in ("sac", "td3")]
        assert all(isinstance(one, Episode) for one in ours)
    assert made.count(last.id) == 1


def test_a_scene_that_cannot_be_made_of_another_is_tried_once(
    native: NativeSimulator, monkeypatch: pytest.MonkeyPatch
) -> None:
    program, tried = _program(DOES["a name of the plan"]), list[str]()
    *first, last = _scenes(program)
    for scene in first:
        _opened(native, program, scene)

    def fails(_self: SteppedSimulator, _session: SteppedSession, _placement: Placement, scene: Scene) -> bool:
        tried.append(scene.id)
        return False

    monkeypatch.setattr(SteppedSimulator, "again", fails)
    assert isinstance(simulate(native, program, last, load_ego("idm")), Episode)
    assert tried == [last.id]


def test_what_the_ego_sees_at_first_is_of_its_own_scene(native: NativeSimulator) -> None:
    program = _program(DOES["a name of the program"])
    embedded = load_simulator(resolve_map("town"), SimulationSettings())
    for scene in _scenes(program):
        for preset in ("safebench", "actors", "road", "traffic"):
            ours = native.open(program, scene, observation=preset)
            theirs = embedded.open(program, scene, observation=preset)
            assert not isinstance(ours, Rejected)
            assert not isinstance(theirs, Rejected)
            assert ours.observation.tobytes() == theirs.observation.tobytes()
            theirs.close()


def test_a_scene_that_overlaps_is_rejected_and_the_next_is_not(native: NativeSimulator) -> None:
    third = "third = new Car at pointOn(egoRoute, 55), facing directionOn(egoRoute, 55)\n"
    program = _program(DOES["what others do"], third=third)
    found = [native.open(program, scene) for scene in _scenes(program)]
    assert [isinstance(one, Rejected) for one in found] == [False, False, True, False, False]


def test_what_an_ego_sees_first_is_where_it_is_on_its_route(native: NativeSimulator) -> None:
    source = (
        'model chatscene.world.model\negoRoute = selectRoute(maneuver="left-turn", place="four-way")\n'
        "ego = new Car at pointOn(egoRoute, 60), facing directionOn(egoRoute, 60), "
        "with route egoRoute\n"
    )
    program = ScenicProgram(scenario_id="there", source=source, parameters=(), snippet_ids=())
    scene = scene_at(program, 0, 0.5, name="0")
    reference = load_simulator(resolve_map("town"), SimulationSettings())
    for preset in ("safebench", "actors", "traffic"):
        first: list[Observation] = []
        for simulator in (native, reference):
            opened = simulator.open(program, scene, observation=preset)
            assert not isinstance(opened, Rejected)
            first.append(opened.observation)
            opened.close()
        assert first[0].tobytes() == first[1].tobytes(), preset
