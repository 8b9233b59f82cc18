"""An ego that is ordered to: what it asks for counts as far as it may."""

from collections.abc import Sequence

import numpy as np
import pytest

from chatscene.ego.observation import Observation
from chatscene.errors import ProgramError
from chatscene.maps.network import resolve_map
from chatscene.settings import SimulationSettings
from chatscene.simulate.obedience import Obedience
from chatscene.simulate.simulator import Simulator, load_simulator, simulate
from chatscene.terms.actors import LIMITS
from chatscene.terms.episode import Episode
from chatscene.terms.order import Order
from chatscene.terms.scene import Scene, ScenicProgram

DT = 0.1
PROGRAM = """
model chatscene.world.model
{start}
egoRoute = selectRoute(maneuver="straight", place="four-way", control="signal")
ego = new Car at pointOn(egoRoute, 0), facing directionOn(egoRoute, 0), with route egoRoute{orders}
new Container at pointOn(egoRoute, 9, 6)
"""
SCENE = Scene(id="toy/0", scenario_id="toy", route=0, block=0, seed=0, values={})


class Pedals:
    """An ego that presses one pedal all the time."""

    def __init__(self, pedal: float = 1.0) -> None:
        self.pedal = pedal
        self.seen: list[Observation] = []

    def act(self, observation: Observation) -> tuple[float, float]:
        self.seen.append(observation)
        return self.pedal, 0.0


@pytest.fixture(scope="module")
def simulator() -> Simulator:
    return load_simulator(resolve_map("town"), SimulationSettings(max_steps=90))


def program(orders: str, *, at_line: bool = False) -> ScenicProgram:
    source = PROGRAM.format(
        orders=f", with orders ({orders})" if orders else "", start="param egoStart = 'at-line'" if at_line else ""
    )
    return ScenicProgram(scenario_id="toy", source=source, parameters=(), snippet_ids=())


def drive(simulator: Simulator, orders: str, ego: Pedals | None = None) -> Episode:
    episode = simulate(simulator, program(orders), SCENE, ego or Pedals())
    assert isinstance(episode, Episode)
    return episode


def test_an_ego_that_is_to_stand_stands_at_full_throttle(simulator: Simulator) -> None:
    assert drive(simulator, "Order(at_most=0),").ego_track.speed.max() == 0.0


def test_an_ego_sets_off_when_its_order_ends(simulator: Simulator) -> None:
    speed = drive(simulator, "Order(at_most=0, till=2),").ego_track.speed
    assert (speed[:20] == 0.0).all()
    assert speed[22] > 0.2


def test_an_ego_is_no_faster_than_it_may_be(simulator: Simulator) -> None:
    speed = drive(simulator, "Order(at_most=3),").ego_track.speed
    assert 2.5 < speed[30:].min() <= speed.max() < 3.01


def test_an_ego_is_braked_evenly_to_a_stop_where_it_is_to_stand(simulator: Simulator) -> None:
    track = drive(simulator, "Order(at_most=0, place=30, braking=4),").ego_track
    line = simulator.route(program(""), 0).line
    assert track.speed[-1] == 0.0
    assert line.project(track.x[-1], track.y[-1])[0] == pytest.approx(30.0, abs=0.5)
    assert -4.6 < track.acceleration(DT).min() < -3.4


def test_of_several_orders_the_strictest_counts(simulator: Simulator) -> None:
    assert drive(simulator, "Order(at_most=4), Order(at_most=2)").ego_track.speed.max() < 2.01


def test_an_ego_that_asks_for_less_drives_as_it_would_without_orders(simulator: Simulator) -> None:
    ordered, free = (drive(simulator, orders, Pedals(0.2)) for orders in ("Order(at_most=20),", ""))
    assert np.array_equal(ordered.ego_track.speed, free.ego_track.speed)


def test_an_ego_is_told_nothing_of_its_orders(simulator: Simulator) -> None:
    ego = Pedals()
    drive(simulator, "Order(at_most=0),", ego)
    assert {len(observation) for observation in ego.seen} == {4}


@pytest.mark.parametrize("orders", ["3,", "Order(at_most=0)"])
def test_what_is_no_order_is_refused(simulator: Simulator, orders: str) -> None:
    with pytest.raises(ProgramError, match="takes orders"):
        simulator.open(program(orders), SCENE)


def test_an_ego_that_waits_begins_right_before_its_junction(simulator: Simulator) -> None:
    whole, cut = (simulator.route(program("", at_line=at_line), 0) for at_line in (False, True))
    assert cut.event_at == 4.0
    assert cut.length == pytest.approx(whole.length - (whole.event_at - 4.0), abs=0.1)
    assert cut.id != whole.id
    assert set(cut.lane_ids) <= set(whole.lane_ids)


BRAKE = LIMITS["Car"].brake


@pytest.mark.parametrize(
    ("orders", "speed", "asked", "pressed"),
    [
        ([Order(at_most=0.0)], 0.0, (1.0, 0.0), (0.0, 1.0)),
        ([Order(at_most=5.0)], 3.0, (1.0, 0.0), (1.0, 0.0)),
        ([Order(at_most=5.0)], 3.0, (0.0, 0.4), (0.0, 0.4)),
        ([Order(at_most=5.0)], 5.0, (1.0, 0.0), (0.0, 0.0)),
        ([Order(at_most=5.0)], 5.4, (0.0, 0.0), (0.0, (4.0 - LIMITS["Car"].drag) / BRAKE)),
        ([Order(at_most=5.0)], 9.0, (0.0, 0.3), (0.0, 1.0)),
    ],
)
def test_pedals_are_as_asked_for_or_as_needed(
    orders: Sequence[Order], speed: float, asked: tuple[float, float], pressed: tuple[float, float]
) -> None:
    limits = LIMITS["Car"]
    found = Obedience(orders).pedals(asked, time=0.0, along=0.0, speed=speed, dt=DT, limits=limits)
    assert found == pytest.approx(pressed)
