"""The preset `traffic`: what an ego sees that drives at the speed of the road."""

from __future__ import annotations

import math

import numpy as np
import pytest
from numpy.typing import NDArray

from chatscene.ego.observation import ALLOWED, OBSERVATIONS, OWN, PER_ACTOR, ROAD, UNHELD, Observation, scale_of
from chatscene.ego.policy import EgoPolicy, load_ego
from chatscene.errors import ProgramError
from chatscene.maps.limits import MOTORWAY, TOWN, limits_along
from chatscene.maps.network import load_network, resolve_map
from chatscene.settings import SimulationSettings
from chatscene.simulate.native.simulator import NativeSession, NativeSimulator
from chatscene.simulate.session import SteppedSession
from chatscene.simulate.simulator import Simulator, load_simulator, simulate
from chatscene.terms.profile import Timetable, allowed_speeds
from chatscene.terms.scene import Rejected, Scene, ScenicProgram

SETTINGS = SimulationSettings()
WAYS = {
    "town": 'maneuver="left-turn"',
    "outskirts": 'maneuver="straight", site="motorway"',
}
PROGRAM = """model chatscene.world.model
egoRoute = selectRoute({way})
ego = new Car at startOf(egoRoute), facing directionOn(egoRoute, 0), with route egoRoute, with speed {speed}{more}
behavior AdvBehavior():
    do DrivePath(egoRoute, {slower}) for 2 seconds
    do BrakeOnPath(egoRoute, 0.5)
other = new Car at pointOn(egoRoute, 40), facing directionOn(egoRoute, 40), with speed {slower}, \
with behavior AdvBehavior()
new Car at pointOn(egoRoute, 70, -3), facing directionOn(egoRoute, 70)
"""


class AtSpeed:
    """Drives as fast as it is allowed, and no faster than it wants, whoever is ahead."""

    name = "at-speed"
    pedals = "full-brake"

    def __init__(self, speed: float, observation: str = "traffic") -> None:
        self.speed, self.observation = speed, observation

    def act(self, observation: Observation) -> tuple[float, float]:
        speed, (x, y) = float(observation[0]), observation[4:6].tolist()
        wish = min([self.speed, *observation[ALLOWED:].tolist()])
        wheel = math.atan(2.9 * 2.0 * y / max(x * x + y * y, 1.0))
        return max(-1.0, min(1.0, wish - speed)), max(-1.0, min(1.0, -wheel / 0.35))


def program(name: str, speed: float, more: str = "") -> ScenicProgram:
    source = PROGRAM.format(way=WAYS[name], speed=f"{speed:g}", slower=f"{0.8 * speed:g}", more=more)
    return ScenicProgram(scenario_id="traffic", source=source, parameters=(), snippet_ids=())


def simulator(kind: str, name: str) -> Simulator:
    path = resolve_map(name)
    return load_simulator(path, SETTINGS) if kind == "embedded" else NativeSimulator(path, SETTINGS)


def drive(
    kind: str, name: str, speed: float, ego: EgoPolicy, more: str = "", route: int = 0
) -> tuple[NDArray[np.float64], SteppedSession | NativeSession]:
    """What is seen at each step of a drive, (steps, size), and the session."""
    scene = Scene(id="traffic/0", scenario_id="traffic", route=route, block=0, seed=0, values={})
    preset = getattr(ego, "observation", "safebench")
    session = simulator(kind, name).open(
        program(name, speed, more), scene, observation=preset, pedals="full-brake", through_collisions=True
    )
    assert not isinstance(session, Rejected), session.reason
    assert isinstance(session, NativeSession if kind == "native" else SteppedSession)
    rows = [session.observation]
    while session.ending is None:
        session.step(ego.act(session.observation))
        rows.append(session.observation)
    session.close()
    return np.array(rows), session


def native_is_there() -> bool:
    return not NativeSimulator(resolve_map("town"), SETTINGS).missing


@pytest.mark.parametrize("name", WAYS)
@pytest.mark.parametrize("speed", [8.0, 14.0, 22.0, 31.0])
def test_both_simulators_show_the_same_at_any_speed(name: str, speed: float) -> None:
    if not native_is_there():
        pytest.skip("there is no engine")
    for more in ("", f", with wantedSpeed {speed:g}, with keepsLimits True"):
        rows, ours = (drive(kind, name, speed, AtSpeed(speed), more)[0] for kind in ("embedded", "native"))
        assert rows.shape == ours.shape
        assert rows.shape[1] == OBSERVATIONS["traffic"] == ALLOWED + 1
        assert np.array_equal(rows, ours)
        assert np.isfinite(rows).all()


@pytest.mark.parametrize("name", WAYS)
@pytest.mark.parametrize("kind", ["embedded", "native"])
def test_it_is_the_preset_road_for_who_drives_no_faster_than_egos_of_old(kind: str, name: str) -> None:
    if not native_is_there():
        pytest.skip("there is no engine")
    road, _ = drive(kind, name, 7.0, AtSpeed(7.0, "road"))

    class Led(AtSpeed):
        def act(self, observation: Observation) -> tuple[float, float]:
            return super().act(observation[:ALLOWED])

    traffic, _ = drive(kind, name, 7.0, Led(7.0))
    slow = traffic[:, 0] <= 8.0
    assert slow.all()
    assert np.array_equal(traffic[:, :ALLOWED], road)


def test_at_speed_it_sees_farther() -> None:
    rows, session = drive("embedded", "outskirts", 24.0, AtSpeed(24.0))
    first, scale = rows[0], scale_of(24.0)
    assert scale == 3.0
    assert first[3] == pytest.approx(session.route.length, abs=1e-6)  # pyright: ignore[reportAttributeAccessIssue]
    assert np.hypot(*first[4:6]) == pytest.approx(5.0 * scale, abs=0.1)
    assert np.hypot(*first[12:14]) == pytest.approx(30.0 * scale, abs=0.5)
    others = first[OWN:ROAD].reshape(-1, PER_ACTOR)
    assert others[:, 0].sum() == 2.0
    assert others[1, 1] == pytest.approx(70.0, abs=0.1)
    assert scale_of(8.0) == scale_of(0.0) == scale_of(-3.0) == 1.0


def test_the_speed_allowed_is_that_of_bends_and_where_limits_are_kept_of_limits() -> None:
    assert drive("embedded", "outskirts", 14.0, AtSpeed(14.0))[0][0, ALLOWED] > MOTORWAY
    kept = ", with wantedSpeed 14, with keepsLimits True"
    assert drive("embedded", "outskirts", 14.0, AtSpeed(14.0), kept)[0][0, ALLOWED] == MOTORWAY
    turns, _ = drive("embedded", "town", 8.0, AtSpeed(30.0))
    assert turns[:, ALLOWED].min() < 8.5
    kept = ", with wantedSpeed 30, with keepsLimits True"
    assert drive("embedded", "town", 8.0, AtSpeed(30.0), kept)[0][:, ALLOWED].max() <= TOWN
    assert turns[:, ALLOWED].max() <= UNHELD


def test_who_drives_as_fast_as_is_allowed_takes_a_turn_without_leaving_the_road() -> None:
    rows, session = drive("embedded", "town", 13.0, AtSpeed(13.9))
    assert np.abs(rows[:, 1]).max() < 1.0
    assert not session.episode("", "ego").off_road.any()
    assert (rows[:, 0] - rows[:, ALLOWED]).max() < 1.5


FOLLOWS = """model chatscene.world.model
egoRoute = selectRoute(maneuver="straight", site="motorway")
ego = new Car at pointOn(egoRoute, 2, 20), facing directionOn(egoRoute, 0), with route egoRoute
behavior AdvBehavior():
    do FollowTraffic(egoRoute, {speed})
other = new Car at pointOn(egoRoute, 5), facing directionOn(egoRoute, 5), with speed {speed}, \
with behavior AdvBehavior()
new Car at pointOn(egoRoute, 149), facing directionOn(egoRoute, 149), with label "stands"
"""


@pytest.mark.parametrize("kind", ["embedded", "native"])
@pytest.mark.parametrize("speed", [8, 16, 24])
def test_who_follows_traffic_stops_behind_who_stands_from_any_speed(kind: str, speed: int) -> None:
    if not native_is_there():
        pytest.skip("there is no engine")
    source = FOLLOWS.format(speed=speed)
    one = ScenicProgram(scenario_id="follows", source=source, parameters=(), snippet_ids=())
    scene = Scene(id="follows/0", scenario_id="follows", route=0, block=0, seed=0, values={})
    session = simulator(kind, "outskirts").open(one, scene)
    assert not isinstance(session, Rejected), session.reason
    while session.ending is None and session.step_number < 290:
        session.step((-1.0, 0.0))
    episode = session.episode("follows/0", "ego")
    session.close()
    track = next(track for track in episode.tracks if track.actor == "adversary")
    stands = next(track for track in episode.tracks if track.actor == "stands")
    gap = np.hypot(track.x - stands.x, track.y - stands.y) - 0.5 * (track.length + stands.length)
    assert gap.min() > 1.0
    assert -track.acceleration(episode.dt)[track.speed > 4.0].min() < 4.0  # the last metres are a stop


@pytest.mark.parametrize("said", ["1 == 1", "1"])
def test_whether_limits_are_kept_is_written_out(said: str) -> None:
    with pytest.raises(ProgramError, match="keepsLimits` takes"):
        drive("embedded", "town", 8.0, AtSpeed(8.0), f", with wantedSpeed 8, with keepsLimits {said}")


ALONE = """model chatscene.world.model
egoRoute = selectRoute({way})
ego = new Car at startOf(egoRoute), facing directionOn(egoRoute, 0), with route egoRoute, \
with speed speedOn(egoRoute, 0, {speed}), with wantedSpeed {speed}, with keepsLimits True
behavior AdvBehavior():
    do Park()
other = new Car at pointOn(egoRoute, 2, 30), facing directionOn(egoRoute, 0), with behavior AdvBehavior()
"""


@pytest.mark.parametrize("name", ["idm", "planner", "rule-based"])
@pytest.mark.parametrize(("where", "speed"), [("town", 13.9), ("outskirts", 30.5)])
def test_a_timetable_says_when_an_ego_by_rule_is_where(name: str, where: str, speed: float) -> None:
    source = ALONE.format(way=WAYS[where], speed=speed)
    one = ScenicProgram(scenario_id="alone", source=source, parameters=(), snippet_ids=())
    scene = Scene(id="alone/0", scenario_id="alone", route=0, block=0, seed=0, values={})
    road = simulator("embedded", where)
    line = road.route(one, 0).line
    network = load_network(resolve_map(where))
    allowed = allowed_speeds(line, limits_along(network, line, road.route(one, 0).lane_ids))
    table = Timetable(line, allowed, speed, gain=2.0)
    episode = simulate(road, one, scene, load_ego(name))
    assert not isinstance(episode, Rejected)
    along = line.along(episode.ego_track.x, episode.ego_track.y)
    for share in (0.25, 0.5, 0.75, 0.95):
        passed = float(np.interp(share * line.length, along, episode.dt * np.arange(len(along))))
        assert passed == pytest.approx(table.time_at(share * line.length), abs=0.4)
