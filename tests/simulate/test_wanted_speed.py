"""A program may say at what speed its ego is to drive; an ego that can be told drives so, of others it is told."""

from __future__ import annotations

import numpy as np
import pytest

from chatscene.ego.asking import wanting
from chatscene.ego.network import Network, NetworkEgo
from chatscene.ego.observation import OBSERVATIONS
from chatscene.ego.policy import load_ego, takes_speed
from chatscene.errors import ProgramError
from chatscene.maps.network import resolve_map
from chatscene.measure.branch import branch
from chatscene.measure.drive import Ran, drive
from chatscene.settings import SimulationSettings
from chatscene.simulate.confined.allow_list import check_foreign
from chatscene.simulate.simulator import Simulator, load_simulator, simulate
from chatscene.terms.episode import Episode
from chatscene.terms.scenario import Slots
from chatscene.terms.scene import Scene, ScenicProgram

SOURCE = """model chatscene.world.model
egoRoute = selectRoute(maneuver="straight")
behavior AdvBehavior():
    do DrivePath(egoRoute, 20)
ego = new Car at startOf(egoRoute), facing directionOn(egoRoute, 0), with route egoRoute,
    with speed 12{wanted}
AdvAgent = new Car at pointOn(egoRoute, 30), facing directionOn(egoRoute, 30), with behavior AdvBehavior(),
    with speed 15
"""
SCENE = Scene(id="own/0", scenario_id="own", route=0, block=0, seed=0, values={})


@pytest.fixture(scope="module")
def simulator() -> Simulator:
    return load_simulator(resolve_map("town"), SimulationSettings(simulator="embedded", max_steps=30))


def program(wanted: str = ", with wantedSpeed 12") -> ScenicProgram:
    return ScenicProgram(scenario_id="own", source=SOURCE.format(wanted=wanted), parameters=(), snippet_ids=())


def last_speed(simulator: Simulator, one: ScenicProgram, name: str) -> float:
    episode = simulate(simulator, one, SCENE, load_ego(name))
    assert isinstance(episode, Episode)
    return float(episode.ego_track.speed[-1])


@pytest.mark.parametrize("name", ["planner", "idm", "rule-based", "hardened"])
def test_an_ego_by_rule_keeps_the_speed_that_is_wanted_and_else_its_own(name: str, simulator: Simulator) -> None:
    assert last_speed(simulator, program(), name) > 10.0
    assert last_speed(simulator, program(""), name) < 9.5


@pytest.mark.parametrize(
    ("observation", "why"),
    [("traffic", "was trained for up to 10 m/s and drives no faster"), ("actors", "chooses its own speed")],
)
def test_a_network_that_was_trained_for_less_than_is_wanted_says_so(
    simulator: Simulator, observation: str, why: str
) -> None:
    layers = ((np.zeros((2, OBSERVATIONS[observation]), np.float32), np.zeros(2, np.float32)),)
    ego = NetworkEgo(Network(layers=layers), name="slow", observation=observation, trained_for=10.0)
    ran = drive(program(), Slots(), SCENE, simulator=simulator, ego=ego)
    assert isinstance(ran, Ran)
    assert ran.unplayed == (f"the ego should drive at 12 m/s, but slow {why}",)


def test_an_ego_that_is_told_a_speed_is_another_and_keeps_its_name() -> None:
    told = wanting(planner := load_ego("planner"), 20.0)
    assert (told.name, told is planner) == ("planner", False)  # pyright: ignore[reportAttributeAccessIssue]
    assert wanting(planner, None) is planner


def test_a_network_drives_at_its_own_speed_and_that_is_told(simulator: Simulator) -> None:
    sac = load_ego("sac")
    assert not takes_speed(sac)
    assert wanting(sac, 20.0) is sac
    ran = drive(program(), Slots(), SCENE, simulator=simulator, ego=sac)
    assert isinstance(ran, Ran)
    assert ran.unplayed == ("the ego should drive at 12 m/s, but sac chooses its own speed",)


def test_of_an_ego_that_takes_the_speed_nothing_is_told(simulator: Simulator) -> None:
    ran = drive(program(), Slots(), SCENE, simulator=simulator, ego=load_ego("planner"))
    assert isinstance(ran, Ran)
    assert ran.unplayed == ()


def test_an_ego_that_takes_over_later_wants_the_same_speed(simulator: Simulator) -> None:
    planner = load_ego("planner")
    alone = simulate(simulator, program(), SCENE, planner)
    twice = branch(program(), SCENE, planner, planner, simulator, step=5)
    assert isinstance(alone, Episode)
    assert isinstance(twice, Episode)
    assert alone.ego_track.speed.tolist() == twice.ego_track.speed.tolist()


def test_a_speed_that_is_computed_is_refused(simulator: Simulator) -> None:
    with pytest.raises(ProgramError, match="wantedSpeed` takes a plain number"):
        simulator.open(program(", with wantedSpeed 2 * 6"), SCENE)


def test_a_stranger_may_say_it() -> None:
    assert check_foreign(program().source) == ()
