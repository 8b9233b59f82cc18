"""Scenes in a CARLA server, through the real wheel; the server is the stand-in."""

from __future__ import annotations

import importlib
import math
import re
import time
from collections.abc import Callable, Generator
from dataclasses import replace
from pathlib import Path
from typing import Any
from unittest.mock import Mock

import pytest
from standing_in import free_port, serving

from chatscene.commands.simulator_check import examine_simulator
from chatscene.errors import ServerError
from chatscene.maps.network import resolve_map
from chatscene.settings import SimulationSettings
from chatscene.simulate.simulator import Session, load_simulator, simulate
from chatscene.studies.agreement import same_sizes
from chatscene.terms.actors import LIMITS
from chatscene.terms.episode import Ending, Episode
from chatscene.terms.scene import Rejected, Scene, ScenicProgram
from chatscene.testing.simulators import check_simulator
from chatscene.world.bodies import Placement

carla: Any = pytest.importorskip("carla", reason="the extra 'carla' is not installed, or has no wheel for this Python")
pytest.importorskip("msgpack", reason="the extra 'carla' is not installed")
Connection: Any = importlib.import_module("chatscene.simulate.carla.connection").Connection
physics: Any = importlib.import_module("chatscene.simulate.carla.physics")

TOWN = resolve_map("town")
HEAD = "model chatscene.world.model\n{before}egoRoute = selectRoute(maneuver='straight'{asked})\n"
EGO = "ego = new Car at startOf(egoRoute), facing directionOn(egoRoute, 0), with route egoRoute\n"
AHEAD = "new {kind} at pointOn(egoRoute, {at}), facing directionOn(egoRoute, {at})\n"


class Driver:
    """Always asks for the same."""

    def __init__(self, acceleration: float = 1.0, steering: float = 0.0) -> None:
        self._action = (acceleration, steering)

    def act(self, observation: Any) -> tuple[float, float]:
        return self._action


def program(*rest: str, before: str = "", asked: str = "") -> ScenicProgram:
    source = HEAD.format(before=before, asked=asked) + EGO + "".join(rest)
    return ScenicProgram(scenario_id="road", source=source, parameters=(), snippet_ids=())


SCENE = Scene(id="road/0", scenario_id="road", route=0, block=0, seed=0, values={})


@pytest.fixture(scope="module")
def port() -> Generator[int]:
    with serving() as (port, _):
        yield port


@pytest.fixture(scope="module")
def settings(port: int) -> SimulationSettings:
    return SimulationSettings(simulator=f"carla:127.0.0.1:{port}", max_steps=40)


@pytest.fixture(scope="module")
def simulator(settings: SimulationSettings) -> Any:
    return load_simulator(TOWN, settings)


@pytest.fixture
def look(port: int) -> Callable[[], Any]:
    """The world as another client finds it."""

    def world() -> Any:
        client = carla.Client("127.0.0.1", port)
        client.set_timeout(20.0)
        clients.append(client)
        found = client.get_world()
        while len(found.get_actors()) == 0:  # the first frame is on its way
            time.sleep(0.01)
        return found

    clients: list[Any] = []
    return world


def opened(simulator: Any, *rest: str, **named: str) -> Session:
    session = simulator.open(program(*rest, **named), SCENE)
    assert not isinstance(session, Rejected), session
    return session


def driven(simulator: Any, *rest: str, **named: str) -> Episode:
    episode = simulate(simulator, program(*rest, **named), SCENE, Driver())
    assert isinstance(episode, Episode), episode
    return episode


def test_carla_keeps_the_contract_of_a_simulator(settings: SimulationSettings) -> None:
    check_simulator(lambda path, given: load_simulator(path, replace(given, simulator=settings.simulator)))


def test_a_stand_in_says_that_it_is_not_carla(simulator: Any) -> None:
    identity = simulator.identity
    assert (identity.name, identity.version, identity.exact, identity.confinable) == ("carla", "0.9.16", False, False)
    assert "not CARLA" in identity.physics


def test_actors_have_the_sizes_of_their_blueprints(simulator: Any) -> None:
    tracks = driven(simulator, AHEAD.format(kind="VendingMachine", at=35)).tracks
    sizes = {track.kind: (track.length, track.width) for track in tracks}
    assert sizes["Car"] == pytest.approx((4.9017, 2.1283), abs=1e-3)
    assert sizes["Car"] != (LIMITS["Car"].length, LIMITS["Car"].width)
    assert sizes["VendingMachine"] == pytest.approx((1.1020, 0.8729), abs=1e-3), "its longer side lies where ours does"


def test_with_the_same_sizes_a_drive_is_that_of_the_embedded_simulator(simulator: Any, settings: Any) -> None:
    rest = (
        "behavior AdvBehavior():\n    do MoveAhead(1.5)\n",
        "AdvAgent = new Pedestrian at besideRoad(egoRoute, 25, 'right', 1), "
        "facing crossingDirection(egoRoute, 25, 'right'), with behavior AdvBehavior()\n",
    )
    here = driven(simulator, *rest)
    there = driven(same_sizes(TOWN, settings, simulator.size_of), *rest)
    assert here.ending is there.ending
    for one, other in zip(here.tracks, there.tracks, strict=True):
        assert one.x == pytest.approx(other.x, abs=0.01)
        assert one.y == pytest.approx(other.y, abs=0.01)
        assert one.heading == pytest.approx(other.heading, abs=0.01)
        assert one.speed == pytest.approx(other.speed, abs=0.01)


def test_actors_are_where_and_as_a_scene_has_them_in_carla_s_frame(simulator: Any, look: Callable[[], Any]) -> None:
    session = opened(simulator, AHEAD.format(kind="Truck", at=40))
    try:
        session.step((0.0, 0.0))
        world = look()
        found = {a.type_id: a.get_transform() for a in world.get_actors() if a.type_id.startswith("vehicle.")}
        tracks = session.episode("road/0", "nobody").tracks
    finally:
        session.close()
    assert set(found) == {"vehicle.lincoln.mkz_2017", "vehicle.carlamotors.carlacola"}
    for name, track in zip(("vehicle.lincoln.mkz_2017", "vehicle.carlamotors.carlacola"), tracks, strict=True):
        place = found[name]
        assert (place.location.x, -place.location.y) == pytest.approx((track.x[-1], track.y[-1]), abs=0.01)
        assert math.remainder(math.radians(place.rotation.yaw) + track.heading[-1], math.tau) == pytest.approx(
            0.0, abs=1e-3
        )


def test_a_world_waits_for_ticks_of_the_step_while_a_scene_runs_and_for_none_afterwards(
    simulator: Any, look: Callable[[], Any]
) -> None:
    session = opened(simulator)
    session.step((0.0, 0.0))
    meanwhile = look().get_settings()
    session.close()
    afterwards = look().get_settings()
    assert (meanwhile.synchronous_mode, meanwhile.fixed_delta_seconds) == (True, pytest.approx(0.1))
    assert (meanwhile.max_substep_delta_time, meanwhile.max_substeps) == (pytest.approx(0.01), 10)
    assert meanwhile.deterministic_ragdolls
    assert (afterwards.synchronous_mode, afterwards.fixed_delta_seconds) == (False, None)


def test_a_scene_that_is_over_leaves_no_actor(simulator: Any, look: Callable[[], Any]) -> None:
    driven(simulator, AHEAD.format(kind="Kiosk", at=35))
    world = look()
    assert [a.type_id for a in world.get_actors() if a.type_id.split(".")[0] in ("vehicle", "static", "sensor")] == []


@pytest.mark.parametrize(("mode", "own"), [("ego-green", "Green"), ("ego-red", "Red")])
def test_lights_show_what_the_program_s_signals_say(
    simulator: Any, look: Callable[[], Any], mode: str, own: str
) -> None:
    signalled = {"before": f"param signals = '{mode}'\n", "asked": ", place='four-way', control='signal'"}
    session = opened(simulator, **signalled)
    try:
        session.step((0.0, 0.0))
        session.step((0.0, 0.0))
        lights = look().get_actors().filter("traffic.traffic_light*")
        route = simulator.route(program(**signalled), 0)
        states = simulator.surroundings(route).lights(mode, 3, 0.1)
        shown = {light.get_opendrive_id(): light.state.name for light in lights}
    finally:
        session.close()
    assert {state[2] for state in states.values()} == {"g", "r"}
    assert len(states) >= 4
    assert {name: shown[name] for name in states} == {n: {"g": "Green", "r": "Red"}[s[2]] for n, s in states.items()}
    assert all(light.is_frozen() for light in lights)
    assert own in shown.values()


def test_a_scene_for_which_the_server_has_no_room_is_rejected_with_the_reason(simulator: Any) -> None:
    at = LIMITS["Car"].length + 0.001  # our boxes leave a millimetre; CARLA's are longer
    outcome = simulator.open(program(AHEAD.format(kind="Car", at=at)), SCENE)
    assert isinstance(outcome, Rejected)
    assert "CARLA has no room for a car (vehicle.lincoln.mkz_2017)" in outcome.reason


def test_a_contact_that_carla_s_sensor_does_not_confirm_is_told(
    simulator: Any, monkeypatch: pytest.MonkeyPatch, caplog: pytest.LogCaptureFixture
) -> None:
    monkeypatch.setattr(physics, "HEARING", 1.0)  # for a busy machine
    wall = AHEAD.format(kind="Container", at=12)
    assert driven(simulator, wall).ending is Ending.COLLISION
    assert simulator.disagreements == []
    monkeypatch.setattr(physics, "HEARING", 0.0)
    monkeypatch.setattr(physics.CarlaPhysics, "_hear", Mock())
    assert driven(simulator, wall).ending is Ending.COLLISION
    assert "the ego's box meets that of a container" in caplog.text
    assert len(simulator.disagreements) == 1
    simulator.disagreements.clear()


def test_a_contact_that_only_carla_s_sensor_tells_of_is_told(simulator: Any, monkeypatch: pytest.MonkeyPatch) -> None:
    hear = physics.CarlaPhysics._hear

    def late(bodies: Any, event: Any) -> None:
        time.sleep(0.1)  # the drive ends with the contact
        hear(bodies, event)

    monkeypatch.setattr(physics, "HEARING", 1.0)  # for a busy machine
    monkeypatch.setattr(physics.CarlaPhysics, "_hear", late)
    monkeypatch.setattr(physics, "touch", Mock(return_value=False))
    driven(simulator, AHEAD.format(kind="Container", at=12))
    assert ["their boxes never do" in told for told in simulator.disagreements] == [True]
    simulator.disagreements.clear()


def test_walkers_are_asked_for_no_more_than_legs_can(simulator: Any, monkeypatch: pytest.MonkeyPatch) -> None:
    asked: list[float] = []
    control = carla.WalkerControl

    def noted(direction: Any, speed: float, jump: bool) -> Any:
        asked.append(speed)
        return control(direction, speed, jump)

    monkeypatch.setattr(carla, "WalkerControl", noted)
    driven(
        simulator,
        "behavior AdvBehavior():\n    do MoveAhead(3) for 1.5 seconds\n    do Halt()\n",
        "AdvAgent = new Pedestrian at besideRoad(egoRoute, 60, 'right', 1), with behavior AdvBehavior()\n",
    )
    limits, changes = LIMITS["Pedestrian"], [new - old for old, new in zip([0.0, *asked], asked, strict=False)]
    assert max(asked) == pytest.approx(3.0)
    assert max(changes) == pytest.approx(limits.throttle * 0.1)
    assert min(changes) == pytest.approx(-limits.brake * 0.1)


def test_steering_is_a_share_of_the_vehicle_s_own_wheel_angle(simulator: Any, monkeypatch: pytest.MonkeyPatch) -> None:
    asked: list[float] = []
    control = carla.VehicleControl

    def noted(**given: Any) -> Any:
        asked.append(given.get("steer", 0.0))
        return control(**given)

    monkeypatch.setattr(carla, "VehicleControl", noted)
    connection = simulator._connection
    measured = connection.measured("vehicle.lincoln.mkz_2017")
    monkeypatch.setitem(connection._measured, "vehicle.lincoln.mkz_2017", replace(measured, wheel_angle=2.44))
    simulate(simulator, program(), SCENE, Driver(steering=0.3))
    once = asked.copy()
    asked.clear()
    monkeypatch.setitem(connection._measured, "vehicle.lincoln.mkz_2017", measured)
    simulate(simulator, program(), SCENE, Driver(steering=0.3))
    assert abs(asked[0]) > 0.0
    assert once[0] == pytest.approx(asked[0] / 2, rel=1e-3)


def test_a_speed_that_is_asked_for_is_reached_by_pedals(simulator: Any) -> None:
    behavior = (
        "from scenic.domains.driving.actions import SetVelocityAction\n"
        "behavior AdvBehavior():\n"
        "    velocity = 5 * Vector(0, 1).rotatedBy(self.heading)\n"
        "    while True:\n        take SetVelocityAction(velocity.x, velocity.y, 0)\n"
    )
    adversary = (
        "AdvAgent = new Car at pointOn(egoRoute, 60), facing directionOn(egoRoute, 60), with behavior AdvBehavior()\n"
    )
    track = next(iter(driven(simulator, behavior, adversary).adversaries))
    assert track.speed[-1] == pytest.approx(5.0, abs=0.5)
    assert max(track.acceleration(0.1)) <= LIMITS["Car"].throttle + 0.01


def test_a_thing_may_begin_at_a_speed(simulator: Any) -> None:
    behavior = "behavior AdvBehavior():\n    do DrivePath(egoRoute, 6)\n"
    adversary = (
        "AdvAgent = new Car at pointOn(egoRoute, 60), facing directionOn(egoRoute, 60), with speed 6, "
        "with behavior AdvBehavior()\n"
    )
    track = next(iter(driven(simulator, behavior, adversary).adversaries))
    assert track.speed[0] == 6.0
    assert track.speed[1:10] == pytest.approx(6.0, abs=0.3)


def test_the_spectator_looks_down_on_the_ego_when_asked(simulator: Any, look: Callable[[], Any]) -> None:
    simulator.show(watched=True, recording=None)
    session = opened(simulator)
    try:
        for _ in range(12):
            session.step((1.0, 0.0))
        eye = look().get_spectator().get_transform()
        ego = session.episode("road/0", "nobody").ego_track
    finally:
        session.close()
        simulator.show(watched=False, recording=None)
    assert (eye.location.x, -eye.location.y) == pytest.approx((ego.x[-2], ego.y[-2]), abs=0.01)  # before the last tick
    assert eye.location.z > 20.0
    assert eye.rotation.pitch == pytest.approx(-90.0)


def test_a_doctor_says_what_a_server_has_and_how_its_scenes_end(settings: SimulationSettings) -> None:
    found = list(examine_simulator(settings.simulator, "town", scenes=1))
    assert [check.ok for check in found] == [True] * 4, found
    stands_in, world, twice, beside = (check.found for check in found)
    assert "not CARLA" in stands_in
    assert "26 blueprints, 40 traffic lights" in world
    assert "0.000 m apart" in twice
    assert "1 of 1 end alike" in beside


def test_a_doctor_says_which_lights_a_server_lacks(
    settings: SimulationSettings, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(carla.TrafficLight, "get_opendrive_id", Mock(return_value="1031"))
    found = list(examine_simulator(settings.simulator, "town"))
    assert [check.ok for check in found] == [True, False]
    assert "39 of 40 traffic lights are not there: 1012, 1013" in found[1].found


def test_a_doctor_goes_no_further_than_a_server_that_is_not_there() -> None:
    (found,) = examine_simulator(f"carla:127.0.0.1:{free_port()}", "town")
    assert not found.ok
    assert "no CARLA server is at" in found.found


def test_whoever_else_ticks_the_world_is_noticed(simulator: Any, look: Callable[[], Any]) -> None:
    session = opened(simulator)
    try:
        session.step((0.0, 0.0))
        look().tick(5.0)
        with pytest.raises(ServerError, match="another client ticks"):
            session.step((0.0, 0.0))
    finally:
        session.close()


def test_whoever_takes_an_actor_away_is_noticed(simulator: Any, look: Callable[[], Any]) -> None:
    session = opened(simulator, AHEAD.format(kind="Car", at=40))
    try:
        session.step((0.0, 0.0))
        next(iter(look().get_actors().filter("vehicle.*"))).destroy()
        with pytest.raises(ServerError, match=r"a Car is gone|did not obey"):
            session.step((0.0, 0.0))
    finally:
        session.close()


def test_a_map_that_the_server_lacks_is_given_to_it(
    port: int, settings: Any, tmp_path: Path, look: Callable[[], Any]
) -> None:
    mine = tmp_path / "mine.xodr"
    mine.write_text(TOWN.read_text())
    episode = driven(load_simulator(mine, settings))
    assert episode.ego_track.speed[-1] > 5.0
    assert look().get_map().name.endswith("OpenDriveMap")


def test_a_map_of_the_same_name_with_other_roads_is_not_taken_for_ours(
    settings: Any, tmp_path: Path, look: Callable[[], Any], caplog: pytest.LogCaptureFixture
) -> None:
    other = tmp_path / "town.xodr"
    other.write_text(widened(TOWN.read_text()))
    driven(load_simulator(other, settings))
    assert "has other roads than ours" in caplog.text
    assert look().get_map().name.endswith("OpenDriveMap")


def widened(text: str) -> str:
    """A map with one lane wider by a centimetre."""
    return re.sub(r'(<width [^>]*a=")([\d.e+-]+)"', lambda m: f'{m[1]}{float(m[2]) + 0.01}"', text, count=1)


def test_a_program_may_say_what_a_thing_is_in_carla(simulator: Any, look: Callable[[], Any]) -> None:
    fire_engine = "vehicle.carlamotors.firetruck"
    session = opened(simulator, AHEAD.format(kind="Truck", at=40).rstrip() + f", with blueprint '{fire_engine}'\n")
    try:
        session.step((0.0, 0.0))
        assert fire_engine in {actor.type_id for actor in look().get_actors()}
        assert session.episode("road/0", "nobody").tracks[1].length == pytest.approx(8.468, abs=1e-3)
    finally:
        session.close()


def test_a_light_that_a_program_sets_while_it_runs_shows_that(simulator: Any, look: Callable[[], Any]) -> None:
    asked = {"before": "from chatscene.world.lights import setAllIntersectionTrafficLightsStatus\n"}
    asked["asked"] = ", place='four-way', control='signal'"
    behavior = (
        "behavior AdvBehavior():\n"
        "    wait\n"
        "    setAllIntersectionTrafficLightsStatus(network.elements[egoRoute.route.junction], 'yellow')\n"
        "    do Park()\n"
    )
    adversary = (
        "AdvAgent = new Car at pointOn(egoRoute, 20), facing directionOn(egoRoute, 20), with behavior AdvBehavior()\n"
    )
    session = opened(simulator, behavior, adversary, **asked)
    try:
        route = simulator.route(program(behavior, adversary, **asked), 0)
        names = simulator.surroundings(route).lights("clock", 1, 0.1)
        seen: list[set[str]] = []
        for _ in range(3):
            session.step((0.0, 0.0))
            lights = look().get_actors().filter("traffic.traffic_light*")
            seen.append({light.state.name for light in lights if light.get_opendrive_id() in names})
    finally:
        session.close()
    assert seen[0] == {"Green", "Red"}
    assert seen[-1] == {"Yellow"}


def test_every_kind_has_a_blueprint_with_a_size(simulator: Any) -> None:
    from chatscene.simulate.carla.blueprints import PROPS

    for kind in (*LIMITS, *PROPS):
        length, width = simulator.size_of(Placement(kind=kind, x=0.0, y=0.0, heading=0.0, length=2.0, width=1.0))
        assert 0.1 < width < 15.0, kind
        assert 0.1 < length < 15.0, kind
        assert width <= length or kind in (*PROPS, "Pedestrian", "Ball", "Door", "Load"), kind


def test_what_was_measured_is_taken_away_also_where_the_wheel_takes_it_for_dead(
    settings: SimulationSettings, look: Callable[[], Any], monkeypatch: pytest.MonkeyPatch
) -> None:
    def refuse(actor: Any) -> bool:  # the wheel does, for what is in no snapshot yet, if an unwritten byte happens so
        return False

    monkeypatch.setattr(carla.Actor, "destroy", refuse)
    connection = Connection("127.0.0.1", int(settings.simulator.rpartition(":")[2]))
    before = {actor.id for actor in look().get_actors()}
    for name in ("vehicle.lincoln.mkz_2017", "vehicle.carlamotors.carlacola", "walker.pedestrian.0001"):
        assert connection.measured(name).length > 0.0
    assert {actor.id for actor in look().get_actors()} <= before


def test_light_weather_and_road_show_and_leave_the_tyres_as_they_are(
    simulator: Any, look: Callable[[], Any], caplog: pytest.LogCaptureFixture
) -> None:
    leader = AHEAD.format(kind="Car", at=60)
    dry = driven(simulator, leader).ego_track
    wet = driven(simulator, leader, before="param light = 'night', weather = 'rain'\n").ego_track
    weather = look().get_weather()
    assert weather.sun_altitude_angle < 0.0
    assert weather.precipitation > 0.0
    assert weather.wetness > 0.0
    assert "CARLA's tyres hold as on a dry road" in caplog.text
    assert wet.speed[10] == pytest.approx(dry.speed[10], abs=0.01)
