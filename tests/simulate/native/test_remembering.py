"""A network that remembers what it answered drives as one that is asked at every step."""

from __future__ import annotations

import numpy as np
import pytest

from chatscene.ego.network import Network, NetworkEgo
from chatscene.ego.observation import OBSERVATIONS
from chatscene.ego.policy import EgoPolicy, load_ego
from chatscene.maps.network import resolve_map
from chatscene.settings import SimulationSettings
from chatscene.simulate.native.engine import NoEngine, load_engine
from chatscene.simulate.native.policies import REMEMBERS, network_policy
from chatscene.simulate.simulator import Simulator, load_simulator, simulate
from chatscene.terms.episode import Episode
from chatscene.terms.scene import Scene, ScenicProgram
from chatscene.terms.snippet import ParameterRange

SOURCE = """model chatscene.world.model
param OPT_DISTANCE = Range(12, 40)
egoRoute = selectRoute(maneuver="straight")
behavior AdvBehavior():
    do BrakeOnPath(egoRoute, 5)
ego = new Car at startOf(egoRoute), facing directionOn(egoRoute, 0), with route egoRoute, with speed 8
AdvAgent = new Car at pointOn(egoRoute, globalParameters.OPT_DISTANCE), facing directionOn(egoRoute, 20),
    with behavior AdvBehavior(), with speed 7
"""
PROGRAM = ScenicProgram(
    scenario_id="own",
    source=SOURCE,
    parameters=(ParameterRange(name="OPT_DISTANCE", low=12.0, high=40.0, unit="m"),),
    snippet_ids=(),
)


@pytest.fixture(scope="module")
def simulator() -> Simulator:
    try:
        load_engine()
    except NoEngine as missing:
        pytest.skip(str(missing))
    return load_simulator(resolve_map("town"), SimulationSettings(simulator="native"))


def _driven(simulator: Simulator, ego: EgoPolicy, distance: float) -> bytes:
    scene = Scene(id=f"own/{distance}", scenario_id="own", route=0, block=0, seed=0, values={"OPT_DISTANCE": distance})
    episode = simulate(simulator, PROGRAM, scene, ego)
    assert isinstance(episode, Episode)
    assert episode.stepped.by == "native"
    track = episode.ego_track
    return b"".join(column.tobytes() for column in (track.x, track.y, track.heading, track.speed))


def _egos() -> list[NetworkEgo]:
    """One that is packaged, and one that sees ``traffic``, at two speeds."""
    sac, draw = load_ego("sac"), np.random.default_rng(0)
    assert isinstance(sac, NetworkEgo)
    size = OBSERVATIONS["traffic"]
    layers = (
        (draw.normal(0.0, 0.1, (64, size)).astype(np.float32), np.zeros(64, np.float32)),
        (draw.normal(0.0, 0.1, (2, 64)).astype(np.float32), np.array([0.6, 0.0], np.float32)),
    )
    network = Network(layers=layers)
    one, other = (NetworkEgo(network, name="drawn", observation="traffic", wants=speed) for speed in (9.0, 4.0))
    return [sac, one, other]


def test_its_drives_are_the_same_in_any_order(simulator: Simulator) -> None:
    egos = _egos()
    drives = [(ego, distance) for ego in egos for distance in (14.0, 18.0, 30.0)]
    policies = [network_policy(ego.network) for ego in egos[:2]]
    for policy in policies:
        policy.remembers = 0
    asked = [_driven(simulator, *one) for one in drives]
    for policy in policies:
        policy.remembers = REMEMBERS
    for order in (drives, drives[::-1], drives):
        assert [_driven(simulator, *one) for one in order] == [asked[drives.index(one)] for one in order]
    assert len(set(asked)) > 4
