"""What no tyre holds, and what a body that answers at once does too soon, is told of a drive."""

import math
from dataclasses import replace

import numpy as np
import pytest

from chatscene.ego.observation import Observation
from chatscene.maps.network import resolve_map
from chatscene.measure.drive import Ran, drive
from chatscene.measure.tyres import beyond_tyres, friction_demand
from chatscene.settings import SimulationSettings
from chatscene.simulate.boxes import Boxes, between
from chatscene.simulate.embedded.dynamics import VehicleBody
from chatscene.simulate.embedded.lagged import LaggedVehicle
from chatscene.simulate.simulator import load_simulator
from chatscene.terms.actors import LIMITS
from chatscene.terms.episode import Ending, Episode, Event, EventKind, Role, Track
from chatscene.terms.scenario import Slots
from chatscene.terms.scene import Scene, ScenicProgram
from chatscene.terms.surroundings import Surface, Surroundings

DT = 0.1


def driven(cls: type[VehicleBody], speed: float, steer: float, brake: float, target: bool = False) -> Episode:
    """Two seconds of a car that steers and brakes."""
    body = cls(0.0, 0.0, 0.0, LIMITS["Car"], speed)
    rows = [(body.x, body.y, body.heading, body.speed)]
    for _ in range(20):
        body.steer, body.brake = steer, brake
        body.target_speed = speed if target else None
        body.step(DT)
        rows.append((body.x, body.y, body.heading, body.speed))
    x, y, heading, fast = np.array(rows).T
    track = Track(actor="ego", role=Role.EGO, kind="Car", length=4.9, width=2.13, x=x, y=y, heading=heading, speed=fast)
    return Episode(
        scene_id="s", ego="e", dt=DT, tracks=(track,), events=(), signals=(), route_completion=0.5,
        ending=Ending.TIMEOUT, distance_to_route=np.zeros(len(x)), off_road=np.zeros(len(x), dtype=np.bool_),
    )  # fmt: skip


@pytest.mark.parametrize("speed", [8.0, 36.0])
def test_full_braking_straight_on_takes_what_the_brakes_give_and_not_what_the_air_does(speed: float) -> None:
    episode = driven(VehicleBody, speed, 0.0, 1.0)
    assert friction_demand(episode) == pytest.approx(8.0 / (0.9 * 9.81), rel=1e-6)
    assert beyond_tyres(episode) == ()


def test_to_brake_and_turn_at_once_is_more_than_tyres_hold_and_lagged_never_does_it() -> None:
    kinematic, lagged = (driven(cls, 20.0, 0.2, 1.0) for cls in (VehicleBody, LaggedVehicle))
    assert friction_demand(kinematic) == pytest.approx(math.hypot(7.0, 8.0) / (0.9 * 9.81), rel=0.01)
    assert beyond_tyres(kinematic)[0].startswith("the ego: braking, acceleration or turning beyond what real tyres")
    assert (friction_demand(lagged) or 0.0) <= 1.0 + 1e-6


def test_full_braking_while_it_steers_a_little_is_within_what_good_roads_hold() -> None:
    episode = driven(VehicleBody, 13.0, 0.06, 1.0)
    assert 1.0 < (friction_demand(episode) or 0.0) < 1.1
    assert beyond_tyres(episode) == ()


def test_what_is_dry_enough_for_a_turn_is_too_wet_for_it() -> None:
    dry = driven(VehicleBody, 12.0, 0.1, 0.0)
    wet = replace(dry, surroundings=Surroundings(surface=Surface.WET))
    assert friction_demand(wet) == pytest.approx(1.8 * (friction_demand(dry) or 0.0))
    assert (beyond_tyres(dry), len(beyond_tyres(wet))) == ((), 1)


@pytest.mark.parametrize(("speed", "across", "told"), [(13.0, 5.0, 0), (30.0, 3.0, 0), (30.0, 5.0, 1)])
def test_a_turn_is_told_of_where_it_is_both_fast_and_hard(speed: float, across: float, told: int) -> None:
    wheel = math.atan(LIMITS["Car"].wheelbase * across / speed**2)
    episode = driven(VehicleBody, speed, wheel / LIMITS["Car"].wheel_angle, 0.0, target=True)
    assert len(beyond_tyres(episode)) == told


def test_what_comes_after_the_contact_is_no_manoeuvre() -> None:
    episode = driven(VehicleBody, 20.0, 0.2, 1.0)
    crashed = replace(episode, events=(Event(kind=EventKind.COLLISION, step=1, other="adversary"),))
    assert beyond_tyres(crashed) == ()


SOURCE = """model chatscene.world.model
egoRoute = selectRoute(maneuver="straight")
ego = new Car at startOf(egoRoute), facing directionOn(egoRoute, 0), with route egoRoute, with speed 20,
    with wantedSpeed 20
behavior AdvBehavior():
    do Park()
AdvAgent = new Car at pointOn(egoRoute, 90, 8), facing directionOn(egoRoute, 90), with behavior AdvBehavior()
"""


class Swerving:
    """Brakes and turns at once."""

    name = "swerving"

    def act(self, observation: Observation) -> tuple[float, float]:
        return -1.0, 0.5


@pytest.mark.parametrize("physics", ["kinematic", "lagged"])
def test_a_drive_tells_it_under_the_physics_that_knows_no_tyres(physics: str) -> None:
    simulator = load_simulator(resolve_map("town"), SimulationSettings(physics=physics, max_steps=10))
    program = ScenicProgram(scenario_id="own", source=SOURCE, parameters=(), snippet_ids=())
    scene = Scene(id="own/0", scenario_id="own", route=0, block=0, seed=0, values={})
    ran = drive(program, Slots(), scene, simulator=simulator, ego=Swerving())
    assert isinstance(ran, Ran)
    assert any("tyres" in one for one in ran.unplayed) == (physics == "kinematic")
    assert ran.speeds.friction_demand == friction_demand(ran.episode)


def test_what_is_kept_of_a_drive_for_the_next_measure_cannot_be_written_to() -> None:
    episode = driven(VehicleBody, 8.0, 0.1, 0.2)
    ego = episode.ego_track
    found = between(ego, ego)
    boxes = Boxes.of(ego)
    kept = [boxes.x, boxes.y, boxes.cos, boxes.sin]
    kept += [found.gaps, found.times, found.ahead, found.closing]
    for array in kept:
        with pytest.raises(ValueError, match="read-only"):
            array[0] = 1.0
    assert ego.x.flags.writeable
