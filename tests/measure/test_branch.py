"""Scenes that are driven as they were until a moment, and otherwise from then on."""

from __future__ import annotations

import numpy as np
import pytest

from chatscene.ego.intelligent_driver import IntelligentDriver
from chatscene.ego.policy import EgoPolicy, load_ego
from chatscene.errors import SettingsError
from chatscene.maps.network import resolve_map
from chatscene.measure.branch import branch
from chatscene.settings import SimulationSettings
from chatscene.simulate.simulator import Simulator, load_simulator, simulate
from chatscene.terms.episode import Episode
from chatscene.terms.scene import Scene, ScenicProgram

PROGRAM = ScenicProgram(
    scenario_id="slower-leader",
    source="""model chatscene.world.model
egoRoute = selectRoute(maneuver="straight")
ego = new Car at startOf(egoRoute), facing directionOn(egoRoute, 0), with route egoRoute
param OPT_GAP = Range(20, 40)
behavior AdvBehavior():
    do DrivePath(egoRoute, 3)
start = globalParameters.OPT_GAP
AdvAgent = new Car at pointOn(egoRoute, start), facing directionOn(egoRoute, start), with behavior AdvBehavior()
""",
    parameters=(),
    snippet_ids=(),
)
SCENE = Scene(id="branch", scenario_id="slower-leader", route=0, block=0, seed=0, values={"OPT_GAP": 30.0})


@pytest.fixture(scope="module", params=["embedded", "native"])
def simulator(request: pytest.FixtureRequest) -> Simulator:
    return load_simulator(resolve_map("town"), SimulationSettings(simulator=request.param, max_steps=150))


def driven(simulator: Simulator, ego: EgoPolicy) -> Episode:
    episode = simulate(simulator, PROGRAM, SCENE, ego)
    assert isinstance(episode, Episode)
    return episode


def same(one: Episode, other: Episode, steps: int | None = None) -> bool:
    return all(
        np.array_equal(getattr(a, name)[:steps], getattr(b, name)[:steps])
        for a, b in zip(one.tracks, other.tracks, strict=True)
        for name in ("x", "y", "heading", "speed")
    )


def test_a_branch_is_the_first_drive_until_its_step_and_another_after(simulator: Simulator) -> None:
    blind, careful = load_ego("sac"), IntelligentDriver()
    whole = driven(simulator, blind)
    came = branch(PROGRAM, SCENE, blind, careful, simulator, step=20)
    assert isinstance(came, Episode)
    assert came.ego == f"{whole.ego}, then idm"
    assert same(whole, came, 21)  # the state at a step is there before anybody acts in it
    assert not same(whole, came, 40)


def test_a_branch_at_the_beginning_is_the_others_own_drive(simulator: Simulator) -> None:
    careful = IntelligentDriver()
    came = branch(PROGRAM, SCENE, load_ego("sac"), careful, simulator, step=0)
    assert isinstance(came, Episode)
    assert same(came, driven(simulator, careful))


def test_an_ego_cannot_take_over_a_drive_that_is_over(simulator: Simulator) -> None:
    blind = load_ego("sac")
    last = len(driven(simulator, blind).ego_track.x) - 2  # in which somebody acts
    assert isinstance(branch(PROGRAM, SCENE, blind, IntelligentDriver(), simulator, step=last), Episode)
    with pytest.raises(SettingsError, match=rf"take over at {0.1 * (last + 1):.4g} s; the drive .* is over at"):
        branch(PROGRAM, SCENE, blind, IntelligentDriver(), simulator, step=last + 1)
