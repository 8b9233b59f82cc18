"""The contract of a simulator, as a suite that runs on any of them."""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np

from chatscene.ego.observation import OBSERVATIONS, Observation
from chatscene.errors import ChatSceneError, EgoError, ProgramError
from chatscene.maps.network import resolve_map
from chatscene.settings import SimulationSettings
from chatscene.simulate.simulator import Session, Simulator, simulate
from chatscene.terms.episode import Ending, Episode, EventKind, Role
from chatscene.terms.scene import Rejected, Scene, ScenicProgram

_HEAD = """model chatscene.world.model
egoRoute = selectRoute(maneuver="straight")
"""
_EGO = "ego = new Car at startOf(egoRoute), facing directionOn(egoRoute, 0), with route egoRoute\n"
_ROAD = _HEAD + _EGO
_WALL = _ROAD + "new Container at pointOn(egoRoute, 20), facing directionOn(egoRoute, 20)\n"
_TRAFFIC = (
    _ROAD
    + """param OPT_GEO_Y = Range(0, 40)
behavior AdvBehavior():
    do DrivePath(egoRoute, 8)
start = globalParameters.OPT_GEO_Y
AdvAgent = new Car at pointOn(egoRoute, start), facing directionOn(egoRoute, start), with behavior AdvBehavior()
"""
)
_STEPS = 12


class _Driver:
    """Holds the pedal down and the wheel straight."""

    def act(self, observation: Observation) -> tuple[float, float]:  # noqa: ARG002
        return 1.0, 0.0


def check_simulator(make: Callable[[Path, SimulationSettings], Simulator]) -> None:
    """Hold a simulator against the contract (`chatscene.simulate.simulator.Simulator`), on the packaged town.

    Args:
        make: Factory of the simulator, as the table of simulators names it.

    Raises:
        AssertionError: It breaks the contract; the message says where.
    """
    settings = SimulationSettings(max_steps=60)
    simulator = make(resolve_map("town"), settings)
    for check in (
        _says_what_it_is,
        _knows_the_routes,
        _is_stepped_from_outside,
        _shows_every_preset,
        _refuses_what_is_no_action,
        _runs_to_the_end,
        _sees_a_collision,
        _rejects_what_cannot_be_placed,
        _says_what_is_wrong_with_a_program,
        _repeats_itself,
    ):
        check(simulator)
    _ends_in_time(make(resolve_map("town"), replace(settings, max_steps=_STEPS)))


def _program(source: str) -> ScenicProgram:
    return ScenicProgram(scenario_id="contract", source=source, parameters=(), snippet_ids=())


def _scene(route: int = 0, **values: float) -> Scene:
    return Scene(id="contract/0", scenario_id="contract", route=route, block=0, seed=0, values=values)


def _opened(simulator: Simulator, source: str, scene: Scene, **options: Any) -> Session:
    session = simulator.open(_program(source), scene, **options)
    assert not isinstance(session, Rejected), f"a scene that can be placed was rejected: {session}"
    return session


def _episode(simulator: Simulator, source: str, scene: Scene, **options: Any) -> Episode:
    episode = simulate(simulator, _program(source), scene, _Driver(), **options)
    assert isinstance(episode, Episode), f"a scene that can be placed was rejected: {episode}"
    return episode


def _fails(what: str, error: type[ChatSceneError], action: Callable[[], Any]) -> None:
    try:
        action()
    except error:
        return
    raise AssertionError(f"{what} must raise {error.__name__}")


def _says_what_it_is(simulator: Simulator) -> None:
    identity = simulator.identity
    assert identity.name, "its identity has no name"
    assert identity.version, "its identity has no version"
    assert identity.physics, "its identity does not say how it moves bodies"


def _knows_the_routes(simulator: Simulator) -> None:
    program = _program(_ROAD)
    count = simulator.routes(program)
    assert 1 < count <= 10, f"the town has two to ten straight routes, not {count}"
    found = [simulator.route(program, index) for index in (0, count - 1)]
    assert found[0].id != found[1].id, "two routes have one id"
    assert all(route.length > 0 for route in found), "a route without a length"
    assert simulator.route_in(program, _scene(count - 1)).id == found[1].id, "a scene is on another route than its own"
    _fails("a route beyond the last", ChatSceneError, lambda: simulator.route(program, 10))


def _is_stepped_from_outside(simulator: Simulator) -> None:
    session = _opened(simulator, _TRAFFIC, _scene(OPT_GEO_Y=30.0))
    try:
        assert (session.ending, session.rejection, session.step_number) == (None, "", 0), "a session begins at step 0"
        assert abs(session.along) < 1.0, "the ego does not begin at the start of its route"
        assert abs(session.offset) < 0.5, "the ego does not begin on its route"
        for step in range(1, _STEPS + 1):
            session.step((1.0, 0.0))
            assert session.step_number == step, f"step {step} is counted as {session.step_number}"
        assert math.isfinite(session.along + session.offset + session.speed), "the ego is nowhere"
        episode = session.episode("contract/0", "driver")
    finally:
        session.close()
    assert (episode.scene_id, episode.ego) == ("contract/0", "driver"), "an episode of another scene or ego"
    assert [track.role for track in episode.tracks] == [Role.EGO, Role.ADVERSARY], "an actor too many or too few"
    for track in episode.tracks:
        rows = np.array((track.x, track.y, track.heading, track.speed))
        assert rows.shape == (4, _STEPS + 1), f"the track of {track.actor} has not one state more than steps"
        assert np.isfinite(rows).all(), f"{track.actor} is nowhere"
    ego, other = episode.tracks
    apart = math.hypot(ego.x[0] - other.x[0], ego.y[0] - other.y[0])
    assert abs(apart - 30.0) < 1.5, f"actors that a program places 30 m apart begin {apart:.1f} m apart"


def _shows_every_preset(simulator: Simulator) -> None:
    for preset, size in OBSERVATIONS.items():
        session = _opened(simulator, _TRAFFIC, _scene(OPT_GEO_Y=30.0), observation=preset)
        try:
            for _ in range(2):
                assert session.observation.shape == (size,), f"{preset} has {size} numbers"
                assert np.isfinite(session.observation).all(), f"{preset} shows what is not a number"
                session.step((0.0, 0.0))
        finally:
            session.close()


def _refuses_what_is_no_action(simulator: Simulator) -> None:
    session = _opened(simulator, _ROAD, _scene())
    try:
        _fails("an action that is not a number", EgoError, lambda: session.step((math.nan, 0.0)))
    finally:
        session.close()


def _runs_to_the_end(simulator: Simulator) -> None:
    episode = _episode(simulator, _ROAD, _scene())
    assert episode.ending in (Ending.ARRIVED, Ending.TIMEOUT), f"an empty road ends in {episode.ending}"
    assert 0.0 <= episode.route_completion <= 1.0, "the share of the route is no share"
    steps = len(episode.ego_track.x)
    assert episode.distance_to_route.shape == episode.off_road.shape == (steps,), "a row per state"


def _ends_in_time(simulator: Simulator) -> None:
    episode = _episode(simulator, _ROAD, _scene())
    assert episode.ending is Ending.TIMEOUT, f"after the last step a session ends in {episode.ending}"
    assert len(episode.ego_track.x) == _STEPS + 1, f"{_STEPS} steps are allowed"


def _sees_a_collision(simulator: Simulator) -> None:
    episode = _episode(simulator, _WALL, _scene())
    assert episode.ending is Ending.COLLISION, f"an ego that drives at a wall ends in {episode.ending}"
    crash = episode.collision
    assert crash is not None, "a collision without its event"
    assert (crash.other, crash.side) == ("container", "front"), f"it met {crash.other!r} with its {crash.side}"
    assert crash.impact_speed > 0.0, "they met at no speed"
    through = _episode(simulator, _WALL, _scene(), through_collisions=True)
    assert through.ending is not Ending.COLLISION, "it was to go on through the collision"
    assert EventKind.COLLISION in {event.kind for event in through.events}, "the collision is not told any more"


def _rejects_what_cannot_be_placed(simulator: Simulator) -> None:
    outcome = simulator.open(_program(_TRAFFIC), _scene(OPT_GEO_Y=1.0))
    assert isinstance(outcome, Rejected), "two cars that stand in each other are to be rejected"
    assert outcome.reason, "a rejection without a reason"
    failing = _program(_ROAD + "require 1 > 2 as never\n")
    outcome = simulate(simulator, failing, _scene(), _Driver())
    assert isinstance(outcome, Rejected), "a requirement that fails is to be rejected"
    assert "never" in outcome.reason, "a rejection is to name the requirement"


def _says_what_is_wrong_with_a_program(simulator: Simulator) -> None:
    faulty = _program(_ROAD + "new Car at pointOn(egoRoute, 20), facing )\n")
    _fails("a program that does not compile", ChatSceneError, lambda: simulator.open(faulty, _scene()))
    own = _program(_ROAD.replace("with route egoRoute", "with route egoRoute, with behavior Park()"))
    _fails("an ego with a behavior of its own", ProgramError, lambda: simulator.open(own, _scene()))
    _fails("a scene without values", ProgramError, lambda: simulator.open(_program(_TRAFFIC), _scene()))


def _repeats_itself(simulator: Simulator) -> None:
    first = _episode(simulator, _TRAFFIC, _scene(OPT_GEO_Y=25.0))
    _episode(simulator, _WALL, _scene())
    again = _episode(simulator, _TRAFFIC, _scene(OPT_GEO_Y=25.0))
    close = 0.0 if simulator.identity.exact else 0.5
    for old, new in zip(first.tracks, again.tracks, strict=True):
        assert old.x.shape == new.x.shape, f"{old.actor} is driven for another number of steps"
        apart = float(np.hypot(old.x - new.x, old.y - new.y).max())
        assert apart <= close, f"the same scene again puts {old.actor} {apart:g} m away"
