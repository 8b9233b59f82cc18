"""An ego's answer means the same in every body: pedals of its own, and the circle on which a car turns."""

from __future__ import annotations

import math

import pytest

from chatscene.ego.policy import controls, load_ego
from chatscene.maps.network import resolve_map
from chatscene.measure.drive import Ran, drive
from chatscene.settings import SimulationSettings
from chatscene.simulate.simulator import load_simulator
from chatscene.terms.actors import LIMITS
from chatscene.terms.scenario import Slots
from chatscene.terms.scene import Scene, ScenicProgram

SOURCE = """model chatscene.world.model
egoRoute = selectRoute(maneuver="straight")
behavior AdvBehavior():
    do DrivePath(egoRoute, 8)
ego = new {kind} at startOf(egoRoute), facing directionOn(egoRoute, 0), with route egoRoute
AdvAgent = new Car at pointOn(egoRoute, 40), facing directionOn(egoRoute, 40), with behavior AdvBehavior()
"""
SCENE = Scene(id="own/0", scenario_id="own", route=0, block=0, seed=0, values={})


def program(kind: str) -> ScenicProgram:
    return ScenicProgram(scenario_id="own", source=SOURCE.format(kind=kind), parameters=(), snippet_ids=())


@pytest.mark.parametrize("kind", [kind for kind, limits in LIMITS.items() if limits.wheelbase])
@pytest.mark.parametrize("steering", [-1.0, -0.4, 0.0, 0.7, 1.0])
def test_a_steering_turns_every_body_on_the_circle_of_a_car(kind: str, steering: float) -> None:
    car, body = LIMITS["Car"], LIMITS[kind]
    *_, wheel = controls((0.0, steering), body=body)
    *_, usual = controls((0.0, steering))
    assert math.tan(wheel * body.wheel_angle) / body.wheelbase == pytest.approx(
        math.tan(usual * car.wheel_angle) / car.wheelbase
    )
    assert usual == 0.3 * steering


@pytest.mark.parametrize(("kind", "known"), [("Bus", "Bus"), ("Car", "Car"), ("Stranger", "Car")])
def test_a_program_says_by_its_class_what_the_ego_is(kind: str, known: str) -> None:
    assert program(kind).ego_kind == known
    assert program(kind).ego_limits == LIMITS[known]


@pytest.mark.parametrize(
    ("ego", "told"),
    [
        ("idm", ()),
        ("planner", ()),
        ("sac", ("the ego is not a car (bus), and sac drives it as if it were one",)),
        ("rule-based", ("the ego is not a car (bus), and RuleBased drives it as if it were one",)),
    ],
)
def test_of_an_ego_that_drives_a_bus_as_a_car_it_is_told(ego: str, told: tuple[str, ...]) -> None:
    simulator = load_simulator(resolve_map("town"), SimulationSettings(simulator="native", max_steps=30))
    ran = drive(program("Bus"), Slots(), SCENE, simulator=simulator, ego=load_ego(ego))
    assert isinstance(ran, Ran)
    assert ran.unplayed == told
