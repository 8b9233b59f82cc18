"""The native engine gives the embedded simulator's numbers, and says what it does not cover."""

from __future__ import annotations

import itertools
import math
import shutil
from contextlib import suppress
from dataclasses import fields
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from benchmarks.differing import differences
from chatscene.ego.asking import wanting
from chatscene.ego.network import HIDDEN, OUTPUTS, Network, NetworkEgo
from chatscene.ego.observation import AHEAD, ALLOWED, NEAREST, OBSERVATIONS, OWN, PER_ACTOR, ROAD, Observation, scale_of
from chatscene.ego.planner import Caution, Planner
from chatscene.ego.policy import EgoPolicy, load_ego, observation_of, pedals_of
from chatscene.errors import MapError, StuckBehavior
from chatscene.library.compatibility import compatibility
from chatscene.library.load import load_library
from chatscene.maps.network import resolve_map
from chatscene.measure.avoidability import CarefulDriver, careful_braking
from chatscene.measure.counterfactual import _Braking as Whole  # pyright: ignore[reportPrivateUsage]
from chatscene.measure.instead import Ended, drive_instead
from chatscene.program.assemble import assemble
from chatscene.program.sample import scene_at
from chatscene.search.generator import load_generator
from chatscene.settings import RetrievalSettings, SimulationSettings
from chatscene.simulate.native import building, engine
from chatscene.simulate.native.binding import bind
from chatscene.simulate.native.building import NoEngine, compile_engine
from chatscene.simulate.native.policies import network_policy, policy_of
from chatscene.simulate.native.simulator import NativeSimulator
from chatscene.simulate.session import SteppedSession
from chatscene.simulate.simulator import Simulator, load_simulator, simulate
from chatscene.terms.actors import LIMITS
from chatscene.terms.braking import Braking
from chatscene.terms.episode import Episode, Stepped
from chatscene.terms.plan import PRIMITIVES
from chatscene.terms.scenario import BaseScenario, Scenario, Slots, SubDescriptions
from chatscene.terms.scene import Rejected, Scene, ScenicProgram

TOWN, SETTINGS = resolve_map("town"), SimulationSettings()
HEAD = """model chatscene.world.model
egoRoute = selectRoute(maneuver="straight")
ego = new Car at startOf(egoRoute), facing directionOn(egoRoute, 0), with route egoRoute{ego}
behavior AdvBehavior():
{behavior}
other = new {kind} at pointOn(egoRoute, 25, {left}), facing directionOn(egoRoute, 25), with behavior AdvBehavior()
{more}
"""
PHASES = {
    "DrivePath": "do DrivePath(egoRoute, 7, 1) until distanceLeft(egoRoute, self, 60) < 2\n    do Halt()",
    "BrakeOnPath": "do DrivePath(egoRoute, 9) for 1.5 seconds\n    do BrakeOnPath(egoRoute, 0.6)",
    "ThrottleOnPath": "do ThrottleOnPath(egoRoute, 0.7, top=12) until self.pose[3] > 11\n    do BrakeOnPath(egoRoute)",
    "SwerveOnPath": "do SwerveOnPath(egoRoute, 8, 2.5) until abs(offsetFrom(egoRoute, self)) > 2\n    do Halt()",
    "WeaveOnPath": "do WeaveOnPath(egoRoute, 7, 1.5, 3)",
    "PaceOnPath": "do PaceOnPath(egoRoute, ego, 8, top=14, least=2)",
    "KeepStation": "do KeepStation(egoRoute, ego) for 4 seconds\n    do BrakeOnPath(egoRoute, 0.8)",
    "FollowTraffic": "do FollowTraffic(egoRoute, 8)",
    "WaitFor": "do WaitFor(ego, egoRoute, 8)",
    "ReverseStraight": "do ReverseStraight(3) until gap(self, ego) < 12\n    do Park()",
    "ReverseTurning": "do ReverseTurning(3, 0.3)",
    "Slide": "do Slide(0.2, 0.7)",
    "TurnOff": "do TurnOff(-1.2, 4, radius=7)\n    do ReverseStraight(2)",
    "Park": "do Park() until headway(egoRoute, ego, self) < 12\n    do DrivePath(egoRoute, 10)",
    "MoveAhead": "start = 0.5 * gap(self, ego)\n    do MoveAhead(5, 0.2) until gap(self, ego) < start\n    do Halt()",
    "Halt": "while True:\n        do DrivePath(egoRoute, 6) for 1 seconds\n        do Halt() until self.pose[3] < 0.1",
}


def _program(behavior: str, kind: str = "Car", left: float = 0.0, ego: str = "", more: str = "") -> ScenicProgram:
    source = HEAD.format(behavior=f"    {behavior}", kind=kind, left=left, ego=ego, more=more)
    return ScenicProgram(scenario_id="native", source=source, parameters=(), snippet_ids=())


def _scene(route: int = 0) -> Scene:
    return Scene(id="native/0", scenario_id="native", route=route, block=0, seed=0, values={})


@pytest.fixture(scope="module")
def native() -> NativeSimulator:
    simulator = NativeSimulator(TOWN, SETTINGS)
    if simulator.missing:
        pytest.skip(simulator.missing)
    return simulator


def _agrees(
    native: NativeSimulator, program: ScenicProgram, scene: Scene, ego: EgoPolicy, **how: Any
) -> Episode | None:
    """The episode of both simulators, which must be one, and which the engine must have stepped."""
    mine = simulate(native, program, scene, ego, **how)
    theirs = simulate(load_simulator(TOWN, SETTINGS), program, scene, ego, **how)
    if isinstance(mine, Rejected) or isinstance(theirs, Rejected):
        assert mine == theirs
        return None
    assert (mine.stepped, theirs.stepped) == (Stepped(by="native"), Stepped(by="embedded"))
    assert differences(mine, theirs) == []
    return mine


def test_every_primitive_has_a_case_here() -> None:
    assert PHASES.keys() == PRIMITIVES.keys()


@pytest.mark.parametrize("primitive", sorted(PHASES))
def test_a_primitive_moves_its_actor_as_in_the_embedded_simulator(native: NativeSimulator, primitive: str) -> None:
    assert _agrees(native, _program(PHASES[primitive]), _scene(), load_ego("rule-based"))
    assert _agrees(native, _program(PHASES[primitive], left=2.5), _scene(1), load_ego("idm"))


def test_somebody_on_foot_walks_as_in_the_embedded_simulator(native: NativeSimulator) -> None:
    program = _program("do MoveAhead(1.5, 1.2) until gap(self, ego) < 9\n    do Halt()", "Pedestrian", -4.0)
    assert _agrees(native, program, _scene(), load_ego("rule-based"))


def test_an_ego_that_the_engine_does_not_know_sees_the_same_and_drives_the_same(native: NativeSimulator) -> None:
    class Stranger(Planner):
        pass

    assert policy_of(Stranger(), engine.load_engine()) is None
    episode = _agrees(native, _program(PHASES["KeepStation"], left=3.0), _scene(1), Stranger())
    assert episode is not None
    assert len(episode.ego_track.x) > 20


def test_the_planner_drives_the_same_inside_the_engine(native: NativeSimulator) -> None:
    assert policy_of(Planner(), engine.load_engine()) is not None
    assert _agrees(native, _program(PHASES["KeepStation"], left=3.0), _scene(1), Planner())
    assert _agrees(native, _program(PHASES["BrakeOnPath"], left=2.5), _scene(1), Planner())


@pytest.mark.parametrize("ego", ["sac", "idm", "planner"])
@pytest.mark.parametrize(("begins", "over"), [(0, 0), (14, 14), (30, 60)])
def test_a_foot_on_the_brake_does_the_same_inside_the_engine(
    native: NativeSimulator, ego: str, begins: int, over: int
) -> None:
    program, policy = _program(PHASES["BrakeOnPath"]), load_ego(ego)
    inside, outside = (_braked(one, program, policy, begins, over) for one in (native, load_simulator(TOWN, SETTINGS)))
    assert inside == outside
    assert not inside.crashed or begins > 0


def _braked(simulator: Simulator, program: ScenicProgram, ego: EgoPolicy, begins: int, over: int) -> Ended:
    braking = careful_braking(begins, SETTINGS.dt, not_over_before=over)
    return drive_instead(
        CarefulDriver(ego, braking, SETTINGS.dt),
        ego,
        program,
        _scene(),
        simulator,
        pedals="full-brake",
        not_over_before=braking.over,
        dt=SETTINGS.dt,
        braking=braking,
    )


@pytest.mark.parametrize("ego", ["sac", "idm", "planner"])
@pytest.mark.parametrize("begins", [0, 14, 30])
def test_all_that_the_egos_own_pedals_brake_is_the_same_inside_the_engine(
    native: NativeSimulator, ego: str, begins: int
) -> None:
    program, policy = _program(PHASES["BrakeOnPath"]), load_ego(ego)
    braking = Braking(begins=begins, full=math.inf, ramp=SETTINGS.dt, over=40)
    inside, outside = (
        drive_instead(
            Whole(policy, begins),
            policy,
            program,
            _scene(),
            simulator,
            pedals=pedals_of(policy),
            not_over_before=40,
            dt=SETTINGS.dt,
            braking=braking,
        )
        for simulator in (native, load_simulator(TOWN, SETTINGS))
    )
    assert inside == outside


def _street(draw: np.random.Generator, fastest: float = 12.0) -> Observation:
    """A bent road with up to six others, of any kind, anywhere near, moving or not, as `traffic` shows it."""
    seen = np.zeros(OBSERVATIONS["traffic"])
    seen[ROAD:ALLOWED], seen[ALLOWED] = draw.choice([0.5, 1.75, 5.25, 8.0], 2), draw.uniform(0, 40)
    seen[:4] = draw.uniform(0, fastest), draw.normal(0, 1.5), draw.normal(0, 0.1), draw.uniform(5, 100)
    k = scale_of(seen[0]) if fastest > 12.0 else 1.0
    bend = draw.normal(0, 0.02) / k
    seen[4:OWN] = [x for ahead in AHEAD for x in (k * ahead, bend * k * ahead * k * ahead / 2 - seen[1])]
    for row in seen[OWN:ROAD].reshape(-1, PER_ACTOR)[: draw.integers(0, NEAREST + 1)]:
        along, beside, moves = draw.uniform(-20 * k, 45 * k), draw.normal(0, 4), draw.random() < 0.6
        row[:5] = 1.0, along, beside, along, beside
        turned = draw.choice((draw.uniform(-np.pi, np.pi), 0.0, np.pi))
        row[5:8] = moves * draw.normal(0, 6 * k), moves * draw.normal(0, 2), turned
        row[8:] = draw.choice((0.3, 2.4)), draw.choice((0.3, 1.0)), draw.integers(2)
    return seen


@pytest.mark.parametrize("speed", (None, 3.0, 20.0, 35.0))
@pytest.mark.parametrize("name", ("rule-based", "idm", "planner", "hardened"))
def test_a_driver_by_rule_answers_the_same_to_the_last_bit(name: str, speed: float | None) -> None:
    ego, draw = wanting(load_ego(name), speed), np.random.default_rng(5)
    loaded = engine.load_engine()
    policy = policy_of(ego, loaded)
    assert policy is not None
    for _ in range(300):
        seen = _street(draw, 12.0 if speed is None else 40.0)[: OBSERVATIONS[observation_of(ego)]]
        assert loaded.ask(policy, seen.tolist()) == ego.act(seen)


def test_the_planner_answers_the_same_however_cautious_it_is() -> None:
    loaded, draw, usual = engine.load_engine(), np.random.default_rng(6), Caution(crossing=0.5)
    for _ in range(100):
        drawn: dict[str, Any] = {}
        for field in fields(Caution):
            value = np.array(getattr(usual, field.name))
            drawn[field.name] = (value * draw.uniform(0.2, 3.0, value.shape)).tolist()
        slow = Planner(Caution(**drawn))
        for ego, fastest in ((slow, 12.0), (slow.wanting(25.0).driving(LIMITS["Bus"]), 40.0)):
            policy = policy_of(ego, loaded)
            assert policy is not None
            for _ in range(3):
                seen = _street(draw, fastest)[: OBSERVATIONS[ego.observation]]
                assert loaded.ask(policy, seen.tolist()) == ego.act(seen)


@pytest.mark.parametrize("name", ("rule-based", "idm", "planner"))
def test_an_ego_of_which_a_speed_is_wanted_drives_the_same_inside_the_engine(
    native: NativeSimulator, name: str
) -> None:
    program = _program("do Park()", left=-15.0, ego=", with speed 14, with wantedSpeed 14")
    episode = _agrees(native, program, _scene(), load_ego(name))
    assert episode is not None
    assert episode.ego_track.speed[30] > 10.0  # of its own it would have slowed down to 8 and less


@pytest.mark.parametrize("name", ("sac", "ppo", "td3"))
def test_an_ego_with_a_network_drives_the_same_inside_the_engine(native: NativeSimulator, name: str) -> None:
    ego = load_ego(name)
    assert policy_of(ego, engine.load_engine()) is not None
    assert _agrees(native, _program(PHASES["BrakeOnPath"], left=2.5), _scene(1), ego)


def _network(shape: tuple[int, ...], hidden: str = "relu", output: str = "tanh") -> Network:
    draw = np.random.default_rng(len(shape))
    layers = tuple(
        (draw.normal(0, i**-0.5, (o, i)).astype(np.float32), draw.normal(0, 0.1, o).astype(np.float32))
        for i, o in itertools.pairwise(shape)
    )
    return Network(layers=layers, hidden=hidden, output=output, at_most=6.0)


@pytest.mark.parametrize("hidden", HIDDEN)
@pytest.mark.parametrize("output", OUTPUTS)
def test_a_network_of_any_shape_answers_the_same_to_the_last_bit(
    native: NativeSimulator, hidden: str, output: str
) -> None:
    draw = np.random.default_rng(7)
    ways = output == "ways"  # of which there are 49, and who takes one sees no street that is 1e30 m wide
    shapes = (
        ((64, 49), (300, 9, 130, 49), (7, 1, 49), (49,)) if ways else ((64, 64, 2), (300, 9, 130, 2), (7, 1, 2), (2,))
    )
    for sees, shape in zip((80, 80, 80, 80) if ways else (4, 80, 80, 4), shapes, strict=True):
        network = _network((sees, *shape), hidden, output)
        policy = network_policy(network)
        for scale in (0.01, 1.0, 30.0) if ways else (0.01, 1.0, 30.0, 1e30):
            seen = draw.normal(0, scale, network.size)
            with np.errstate(all="ignore"):
                assert engine.load_engine().ask(policy, seen.tolist()) == network(seen)


@pytest.mark.parametrize("output", OUTPUTS)
@pytest.mark.parametrize("speed", (None, 3.0, 20.0, 35.0))
def test_a_network_at_the_speed_of_traffic_answers_the_same_to_the_last_bit(output: str, speed: float | None) -> None:
    shape = (OBSERVATIONS["traffic"], 64, 49 if output == "ways" else 2)
    ego = wanting(NetworkEgo(_network(shape, output=output), name="swift", observation="traffic"), speed)
    loaded, draw = engine.load_engine(), np.random.default_rng(5)
    policy = policy_of(ego, loaded)
    assert policy is not None
    for _ in range(300):
        seen = _street(draw, 40.0)
        assert loaded.ask(policy, seen.tolist()) == ego.act(seen)


def test_a_network_of_which_a_speed_is_wanted_drives_the_same_inside_the_engine(native: NativeSimulator) -> None:
    shape = (OBSERVATIONS["traffic"], 64, 49)
    ego = NetworkEgo(_network(shape, output="ways"), name="swift", observation="traffic", pedals="full-brake")
    program = _program("do Park()", left=-15.0, ego=", with speed 14, with wantedSpeed 14")
    assert _agrees(native, program, _scene(), ego)


def test_a_network_that_looks_at_every_fourth_step_holds_its_action_between(native: NativeSimulator) -> None:
    ego = NetworkEgo(load_ego("td3").network, name="seldom", every=4)  # type: ignore[attr-defined]
    assert _agrees(native, _program(PHASES["FollowTraffic"]), _scene(), ego)


def test_a_network_of_many_numbers_sees_everybody_near(native: NativeSimulator) -> None:
    ego = NetworkEgo(_network((80, 64, 2)), name="wide", observation="actors", pedals="full-brake")
    assert _agrees(native, _program(PHASES["KeepStation"], left=3.0), _scene(1), ego)


@pytest.mark.parametrize("name", ("planner", "hardened"))
def test_the_planner_stays_on_the_road_where_somebody_ahead_brakes(native: NativeSimulator, name: str) -> None:
    for route in range(3):
        episode = _agrees(native, _program(PHASES["BrakeOnPath"]), _scene(route), load_ego(name))
        assert episode is not None
        assert not episode.off_road.any()


@pytest.mark.parametrize("preset", ("actors", "road"))
def test_a_network_that_chooses_among_ways_drives_as_it_does_in_python(native: NativeSimulator, preset: str) -> None:
    size = OBSERVATIONS[preset]
    ego = NetworkEgo(_network((size, 64, 49), output="ways"), name="ways", observation=preset, pedals="full-brake")
    assert policy_of(ego, engine.load_engine()) is not None
    assert _agrees(native, _program(PHASES["KeepStation"], left=3.0), _scene(1), ego)


def test_a_network_whose_answers_differ_here_is_asked_at_every_step(monkeypatch: pytest.MonkeyPatch) -> None:
    network = _network((4, 16, 2))
    loaded = engine.load_engine()

    def nothing(*_: object) -> tuple[float, float]:
        return 0.0, 0.0

    monkeypatch.setattr(loaded, "ask", nothing)
    assert policy_of(NetworkEgo(network, name="odd"), loaded) is None


def test_an_ordered_ego_on_ice_at_night_is_held_to_its_orders(native: NativeSimulator) -> None:
    program = _program(
        PHASES["BrakeOnPath"],
        ego=", with orders (Order(at_most=3, place=20), Order(at_most=0, since=5, till=8))",
        more="param surface = 'ice', light = 'night'",
    )
    assert _agrees(native, program, _scene(), load_ego("rule-based"))


def test_an_ego_that_is_to_go_back_comes_to_a_stand_goes_back_as_far_and_stays_there(native: NativeSimulator) -> None:
    orders = "Order(back=1.5, since=2, till=6), Order(at_most=0, since=6)"
    program = _program(PHASES["Halt"], ego=f", with speed 6, with orders ({orders})")
    episode = _agrees(native, program, _scene(), load_ego("idm"))
    assert episode is not None
    speed = episode.ego_track.speed
    assert speed.min() == pytest.approx(-1.5, abs=0.2)
    assert -6.5 < speed[speed < 0.0].sum() * episode.dt < -3.5
    assert abs(speed[70:]).max() < 0.1


@pytest.mark.parametrize("until", (False, True))
def test_an_order_that_waits_for_how_far_somebody_is_in_its_plan_holds_from_then_or_until_then(
    native: NativeSimulator, until: bool
) -> None:
    order = f"Order(at_most=0, whom='other', phase=1, ends={until})"
    other = "new Car at pointOn(egoRoute, 40, 3.5), with label 'other', with behavior Waits()"
    waits = "behavior Waits():\n    do Halt() for 2 seconds\n    do DrivePath(egoRoute, 7)\n"
    program = _program(PHASES["Halt"], ego=f", with orders ({order},)", more=waits + other)
    episode = _agrees(native, program, _scene(), load_ego("idm"))
    assert episode is not None
    speed = episode.ego_track.speed
    before, then = float(speed[:20].max()), float(speed[40:].max())
    assert (before == 0.0, then == 0.0) == (until, not until)


def test_two_act_and_things_stand_and_the_drive_goes_on_through_a_contact(native: NativeSimulator) -> None:
    more = (
        "new Cone at pointOn(egoRoute, 12, 0.5), facing directionOn(egoRoute, 12)\n"
        "new Truck at pointOn(egoRoute, 60), facing directionOn(egoRoute, 60), with behavior FollowTraffic(egoRoute, 6)"
    )
    episode = _agrees(
        native, _program(PHASES["PaceOnPath"], more=more), _scene(), load_ego("rule-based"), through_collisions=True
    )
    assert episode is not None
    assert episode.collision is not None


@pytest.mark.parametrize("share", (0.3, 0.8))
def test_a_sample_of_the_library_gives_the_same_numbers(native: NativeSimulator, share: float) -> None:
    joint = compatibility(load_library())
    compared = 0
    for b in range(5, len(joint.behaviors), 61):
        g, s = np.argwhere(joint.mask[b])[0].tolist()
        behavior, spawn = joint.behaviors[b], joint.spawns[s]
        kind = sorted(set(behavior.adversaries) & set(spawn.adversaries))[0]
        parts = SubDescriptions(behavior="", geometry="", spawn="")
        scenario = Scenario(id="sample", text="sample", base=None, parts=parts, slots=Slots())
        program = assemble(scenario, (behavior, joint.geometries[g], spawn), kind)
        with suppress(MapError):  # a place that this map has not
            compared += (
                _agrees(native, program, scene_at(program, 0, share, name="0"), load_ego("rule-based")) is not None
            )
    assert compared >= 2


@pytest.mark.parametrize(
    "base",
    (BaseScenario.TURNING_OBSTACLE, BaseScenario.LANE_CHANGING, BaseScenario.VEHICLE_PASSING, BaseScenario.RIGHT_TURN),
)
def test_an_adversary_that_reacts_does_so_in_the_engine_too(native: NativeSimulator, base: BaseScenario) -> None:
    generator, settings = load_generator("reactive"), RetrievalSettings()
    program = generator.write(generator.read(generator.texts(base)[0], settings), settings).program
    for share, ego in ((0.3, "sac"), (0.7, "idm")):
        assert _agrees(native, program, scene_at(program, 0, share, name="reacts"), load_ego(ego))


def test_a_division_by_what_may_become_zero_is_left_to_the_embedded_simulator(native: NativeSimulator) -> None:
    program = _program("do DrivePath(egoRoute, 90 / gap(self, ego)) for 2 seconds\n    do Halt()")
    episode = simulate(native, program, _scene(), load_ego("idm"))
    assert isinstance(episode, Episode)
    assert episode.stepped == Stepped(by="embedded", instead="a division by what may become zero")
    bounded = _program("do DrivePath(egoRoute, 90 / max(gap(self, ego), 1)) for 2 seconds\n    do Halt()")
    assert _agrees(native, bounded, _scene(), load_ego("idm"))


def test_copies_of_a_scene_are_stepped_by_themselves_and_end_alike(native: NativeSimulator) -> None:
    embedded = load_simulator(TOWN, SETTINGS)
    session = embedded.open(_program(PHASES["FollowTraffic"]), _scene())
    assert isinstance(session, SteppedSession)
    first = bind(session, _program(PHASES["FollowTraffic"]))
    session.close()
    by_rule = policy_of(load_ego("rule-based"), engine.load_engine())
    assert by_rule is not None
    engine.load_engine().run(first.copy().world, by_rule)
    assert first.world.step == 0
    many = [first.copy() for _ in range(3)]
    engine.load_engine().run_many([one.world for one in many], by_rule)
    assert first.world.step == 0
    assert many[0].world.step > 20
    states = many[0].world.step + 1
    assert all(np.array_equal(one.rows[:states], many[0].rows[:states]) for one in many)


def test_a_plan_that_comes_to_no_act_is_stuck(native: NativeSimulator) -> None:
    with pytest.raises(StuckBehavior, match="comes to no act"):
        simulate(native, _program("while True:\n        do Park() for 0 seconds"), _scene(), load_ego("idm"))


def test_what_is_no_plan_takes_the_embedded_path_and_says_so(native: NativeSimulator) -> None:
    program = _program("while True:\n        take DriveAction(0.5, 0, 0)")
    episode = simulate(native, program, _scene(), load_ego("rule-based"))
    assert isinstance(episode, Episode)
    assert episode.stepped == Stepped(by="embedded", instead="a behavior that is not a plan")


def test_without_an_engine_everything_runs_and_each_drive_says_so(
    monkeypatch: pytest.MonkeyPatch, tmp_path: Path
) -> None:
    monkeypatch.setattr(engine, "PACKAGED", tmp_path / "engine.so")
    monkeypatch.setattr(engine, "cache_folder", tmp_path.joinpath)
    monkeypatch.setattr(shutil, "which", {}.get)
    engine.load_engine.cache_clear()
    try:
        simulator = NativeSimulator(TOWN, SETTINGS)
    finally:
        engine.load_engine.cache_clear()
    episode = simulate(simulator, _program(PHASES["Park"]), _scene(), load_ego("rule-based"))
    assert isinstance(episode, Episode)
    assert episode.stepped.by == "embedded"
    assert "there is no C compiler" in episode.stepped.instead


def test_a_library_of_another_source_is_not_used(monkeypatch: pytest.MonkeyPatch, tmp_path: Path) -> None:
    stale = tmp_path / "engine.so"
    try:
        compile_engine(stale)
    except NoEngine as error:
        pytest.skip(str(error))
    monkeypatch.setattr(engine, "PACKAGED", stale)
    monkeypatch.setattr(engine, "cache_folder", tmp_path.joinpath)
    for module in (engine, building):
        monkeypatch.setattr(module, "source_digest", lambda: "another")
    engine.load_engine.cache_clear()
    try:
        engine.load_engine()
    finally:
        engine.load_engine.cache_clear()
    assert (tmp_path / "engines").exists()


def _made(path: Path) -> None:
    path.write_bytes(b"a library" * 100)


@pytest.mark.parametrize("left", [0, 400, -20])
def test_a_kept_engine_that_was_changed_is_made_anew_before_it_is_loaded(
    monkeypatch: pytest.MonkeyPatch, tmp_path: Path, left: int
) -> None:
    monkeypatch.setattr(engine, "cache_folder", tmp_path.joinpath)
    monkeypatch.setattr(engine, "compile_engine", _made)
    kept_by: Any = vars(engine)["_kept"]
    kept: Path = kept_by("of-this-source")
    whole = kept.read_bytes()
    assert whole.startswith(b"a library")
    assert kept_by("of-this-source").read_bytes() == whole
    kept.write_bytes(whole[:left] + bytes(len(whole[left:])) * (left < 0))
    with pytest.warns(UserWarning, match="it is made anew"):
        assert kept_by("of-this-source").read_bytes() == whole


def test_a_kept_engine_that_others_can_write_to_is_made_anew(monkeypatch: pytest.MonkeyPatch, tmp_path: Path) -> None:
    monkeypatch.setattr(engine, "cache_folder", tmp_path.joinpath)
    monkeypatch.setattr(engine, "compile_engine", _made)
    kept_by: Any = vars(engine)["_kept"]
    kept: Path = kept_by("of-this-source")
    kept.chmod(0o666)
    with pytest.warns(UserWarning, match="not of this user"):
        kept_by("of-this-source")
    assert kept.stat().st_mode & 0o022 == 0
