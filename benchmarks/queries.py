"""What questions to a map cost, measured in steps of a drive, so that the figures say something on any machine.

python benchmarks/queries.py
"""

from __future__ import annotations

import time
from collections.abc import Callable

import numpy as np

from chatscene.ego.policy import load_ego
from chatscene.maps.lane_map import LaneMap
from chatscene.maps.network import load_network, resolve_map
from chatscene.maps.routes import BASE_SCENARIO_QUERIES, find_routes
from chatscene.settings import SimulationSettings
from chatscene.simulate.simulator import load_simulator, simulate
from chatscene.terms.scene import Rejected, Scene, ScenicProgram

PROGRAM = """
model chatscene.world.model
egoRoute = selectRoute(maneuver="straight")
ego = new Car at pointOn(egoRoute, 0), facing directionOn(egoRoute, 0), with route egoRoute
AdvAgent = new Car at pointOn(egoRoute, 30), facing directionOn(egoRoute, 30), with behavior FollowLaneBehavior()
"""
ROUNDS = 9


def main() -> None:
    network = load_network(resolve_map("town"))
    lanes = LaneMap(network)
    simulator = load_simulator(resolve_map("town"), SimulationSettings())
    program = ScenicProgram(scenario_id="x", source=PROGRAM, parameters=(), snippet_ids=())
    scene = Scene(id="x", scenario_id="x", route=0, block=0, seed=0, values={})
    ego = load_ego("rule-based")
    episode = simulate(simulator, program, scene, ego)
    assert not isinstance(episode, Rejected)
    track = simulator.route(program, 0).line.points
    at = np.linspace(0, len(track) - 1, 200)
    xy = np.column_stack([np.interp(at, np.arange(len(track)), track[:, k]) for k in (0, 1)])

    def ask() -> None:
        lanes.off_road(xy)
        lanes.lane_index(xy)

    step = _least(lambda: simulate(simulator, program, scene, ego)) / (len(episode.ego_track.x) - 1)
    print(f"two questions about a track of 200 points: {_least(ask) / step:.1f} steps")
    for base, queries in BASE_SCENARIO_QUERIES.items():
        for query in queries:
            took = _least(lambda query=query: find_routes(network, "town", query))
            print(f"ten routes for {base}: {took / step:.0f} steps")


def _least(act: Callable[[], object]) -> float:
    """Processor time [s] of the quickest of some rounds."""
    spent: list[float] = []
    for _ in range(ROUNDS):
        began = time.process_time()
        act()
        spent.append(time.process_time() - began)
    return min(spent)


if __name__ == "__main__":
    main()
