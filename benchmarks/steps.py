"""Closed-loop steps per second of one process, ours against Scenic's Newtonian simulator, in one run.

    python benchmarks/steps.py

Each program has an ego that a policy drives and one adversary. Both simulators run the same program text for the
same number of steps; ours also records tracks, detects events and computes the ten metrics. The ego policy costs
the opponent the same: it is called once per step there too.
"""

from __future__ import annotations

import statistics
import sys
import time
from pathlib import Path

import numpy as np

sys.path.insert(0, str(Path(__file__).parent))

from scenic.simulators.newtonian import NewtonianSimulator
from scenic.syntax.translator import scenarioFromString

from chatscene.ego.observation import RouteView
from chatscene.ego.policy import controls
from chatscene.ego.rule_based import RuleBased
from chatscene.evaluate.score import columns, measure
from chatscene.maps.network import resolve_map
from chatscene.settings import SimulationSettings
from chatscene.simulate.backend import load_backend
from chatscene.terms.episode import Episode
from chatscene.terms.scene import Scene, ScenicProgram

PROGRAM = """
model chatscene.world.model
egoRoute = selectRoute(maneuver="straight")
behavior AdvBehavior():
    {behavior}
ego = new Car at pointOn(egoRoute, 0), facing directionOn(egoRoute, 0), with route egoRoute
AdvAgent = new Car at pointOn(egoRoute, 30), facing directionOn(egoRoute, 30), with behavior AdvBehavior()
"""
CASES = {
    "throttle-only adversary (floor)": "while True:\n        take SetThrottleAction(0.4)",
    "lane-following adversary": "do FollowLaneBehavior(target_speed=9)",
}
ROUNDS = 9


def ours(source: str, map_path: Path) -> float:
    """Seconds per step, everything on."""
    backend = load_backend("embedded", map_path, SimulationSettings())
    program = ScenicProgram(scenario_id="bench", source=source, parameters=(), snippet_ids=(), digest=source)
    scene = Scene(id="bench", scenario_id="bench", route=0, block=0, seed=0, values={})
    backend.run(program, scene, RuleBased())
    began = time.process_time()
    episode = backend.run(program, scene, RuleBased())
    assert isinstance(episode, Episode)
    columns(measure(episode))
    return (time.process_time() - began) / (len(episode.ego_track.x) - 1)


def newtonian(source: str, map_path: Path, steps: int) -> float:
    """Seconds per step."""
    text = source.replace("model chatscene.world.model", "model newtonian_world").replace(
        "with route egoRoute", "with route egoRoute, with behavior Policy()"
    )
    text = text.replace(
        "ego = new",
        "from steps import drive_ego\nbehavior Policy():\n    view = None\n    while True:\n"
        "        view, throttle, brake, steer = drive_ego(view, self)\n"
        "        take SetThrottleAction(throttle), SetBrakeAction(brake), SetSteerAction(steer)\n\nego = new",
    )
    scenario = scenarioFromString(text, params={"map": str(map_path)}, mode2D=True)
    simulator = NewtonianSimulator(render=False)
    scene, _ = scenario.generate()
    began = time.process_time()
    result = simulator.simulate(scene, maxSteps=steps, timestep=0.1, maxIterations=1)
    assert result is not None
    return (time.process_time() - began) / steps


def drive_ego(view: RouteView | None, ego) -> tuple[RouteView, float, float, float]:
    """One decision of the policy inside a Scenic behavior."""
    view = view or RouteView(ego.route.line)
    position = ego.position
    seen = view.observe(position.x, position.y, ego.heading + np.pi / 2, ego.speed, False)
    return view, *controls(RuleBased().act(seen))


def main() -> None:
    map_path = resolve_map("town")
    for name, behavior in CASES.items():
        source = PROGRAM.format(behavior=behavior)
        fast = [ours(source, map_path) for _ in range(ROUNDS)]
        slow = [newtonian(source, map_path, 100) for _ in range(3)]
        a, b = statistics.median(fast), statistics.median(slow)
        print(f"{name}: ours {1 / a:,.0f} steps/s, Newtonian {1 / b:,.0f} steps/s, ratio {b / a:.1f}")


if __name__ == "__main__":
    main()
