"""Closed-loop steps per second of one process, ours against Scenic's Newtonian simulator, in one run.

    python benchmarks/steps.py

Each program has an ego that a policy drives and one adversary. Both simulators run the same program text for the
same number of steps; ours also records tracks, detects events and computes the ten metrics. The ego policy costs
the opponent the same: it is called once per step there too. Then what the physics lagged costs beside the kinematic,
in pairs, one after the other; what the engine of `native` steps where the adversary follows the lane by a plan, placing
and judging not counted; at the end, where our own time goes.
"""

from __future__ import annotations

import cProfile
import pstats
import statistics
import sys
import time
from pathlib import Path

import numpy as np

sys.path.insert(0, str(Path(__file__).parent))

from scenic.simulators.newtonian import NewtonianSimulator
from scenic.syntax.translator import scenarioFromString

from chatscene.ego.observation import RouteView
from chatscene.ego.policy import EgoPolicy, controls, load_ego
from chatscene.maps.network import resolve_map
from chatscene.measure.score import columns, measure
from chatscene.settings import PHYSICS, SimulationSettings
from chatscene.simulate.native.simulator import NativeSession
from chatscene.simulate.simulator import load_simulator, simulate
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
    "throttle-only adversary (floor)": ("while True:\n        take SetThrottleAction(0.4)", "rule-based"),
    "lane-following adversary": ("do FollowLaneBehavior(target_speed=9)", "rule-based"),
    "lane-following adversary, SAC at the wheel": ("do FollowLaneBehavior(target_speed=9)", "sac"),
}
PLAN = "do DrivePath(egoRoute, 9)"  # as the lane-following adversary, in words that the engine knows
PARTS = {
    "policy": ("ego/network.py", "ego/rule_based.py"),
    "observation": ("ego/observation.py", "same_lane", "_vehicle_ahead"),
    "behaviors": ("behaviors.scenic", "world/", "<bench>"),
    "physics and contact": ("simulate/embedded/", "simulate/contact.py"),
    "events and metrics": ("simulate/roadside.py", "maps/lane_map.py", "measure/score.py"),
    "Scenic's loop and recording": ("simulate/", "scenic/"),
}
ROUNDS = 9
COPIES = 500  # of a scene, stepped in the engine
LOADED: dict[str, EgoPolicy] = {}


def ours(
    source: str, map_path: Path, ego: EgoPolicy, profile: cProfile.Profile | None = None, physics: str = "kinematic"
) -> float:
    """Seconds per step, everything on."""
    simulator = load_simulator(map_path, SimulationSettings(physics=physics))
    program = ScenicProgram(scenario_id="bench", source=source, parameters=(), snippet_ids=())
    scene = Scene(id="bench", scenario_id="bench", route=0, block=0, seed=0, values={})
    simulate(simulator, program, scene, ego)
    if profile:
        profile.enable()
    began = time.process_time()
    episode = simulate(simulator, program, scene, ego)
    assert isinstance(episode, Episode)
    columns(measure(episode))
    if profile:
        profile.disable()
    return (time.process_time() - began) / (len(episode.ego_track.x) - 1)


def in_engine(source: str, map_path: Path, ego: EgoPolicy) -> float:
    """Seconds per step of `native`, from opened scenes to their ends."""
    simulator = load_simulator(map_path, SimulationSettings(simulator="native"))
    program = ScenicProgram(scenario_id="bench", source=source, parameters=(), snippet_ids=())
    scene = Scene(id="bench", scenario_id="bench", route=0, block=0, seed=0, values={})
    sessions = [simulator.open(program, scene) for _ in range(COPIES)]
    began = time.process_time()
    steps = 0
    for session in sessions:
        assert isinstance(session, NativeSession)
        assert session.drive(ego)
        steps += session.step_number
    return (time.process_time() - began) / steps


def shares(profile: cProfile.Profile) -> dict[str, float]:
    """The share of own time by part; built-in functions count for whoever called them."""
    by_part = dict.fromkeys((*PARTS, "everything else"), 0.0)
    for (filename, _, function), (_, _, own, _, callers) in pstats.Stats(profile).stats.items():  # type: ignore[attr-defined]
        built_in = [((file, name), figures[2]) for (file, _, name), figures in callers.items()]
        for (file, name), seconds in built_in if filename == "~" else [((filename, function), own)]:
            where = f"{file} {name}"
            by_part[next((p for p, marks in PARTS.items() if any(m in where for m in marks)), "everything else")] += (
                seconds
            )
    total = sum(by_part.values())
    return {part: seconds / total for part, seconds in by_part.items()}


def newtonian(source: str, map_path: Path, ego: str, steps: int) -> float:
    """Seconds per step."""
    text = source.replace("model chatscene.world.model", "model newtonian_world").replace(
        "with route egoRoute", "with route egoRoute, with behavior Policy()"
    )
    text = text.replace(
        "ego = new",
        "from steps import drive_ego\nbehavior Policy():\n    view = None\n    while True:\n"
        f"        view, throttle, brake, steer = drive_ego(view, self, {ego!r})\n"
        "        take SetThrottleAction(throttle), SetBrakeAction(brake), SetSteerAction(steer)\n\nego = new",
    )
    scenario = scenarioFromString(text, params={"map": str(map_path)}, mode2D=True)
    simulator = NewtonianSimulator(render=False)
    scene, _ = scenario.generate()
    began = time.process_time()
    result = simulator.simulate(scene, maxSteps=steps, timestep=0.1, maxIterations=1)
    assert result is not None
    return (time.process_time() - began) / steps


def drive_ego(view: RouteView | None, ego, name: str) -> tuple[RouteView, float, float, float]:
    """One decision of the policy inside a Scenic behavior."""
    if name not in LOADED:
        LOADED[name] = load_ego(name)
    view = view or RouteView(ego.route.line)
    position = ego.position
    view.locate(position.x, position.y)
    seen = view.four_numbers(position.x, position.y, ego.heading + np.pi / 2, ego.speed, False)
    return view, *controls(LOADED[name].act(seen))


def main() -> None:
    map_path = resolve_map("town")
    for name, (behavior, ego) in CASES.items():
        source = PROGRAM.format(behavior=behavior)
        fast = [ours(source, map_path, load_ego(ego)) for _ in range(ROUNDS)]
        slow = [newtonian(source, map_path, ego, 100) for _ in range(3)]
        pairs = [[ours(source, map_path, load_ego(ego), physics=physics) for physics in PHYSICS] for _ in range(ROUNDS)]
        lag = statistics.median(lagged / kinematic for kinematic, lagged in pairs)
        a, b = statistics.median(fast), statistics.median(slow)
        print(f"{name}: ours {1 / a:,.0f} steps/s, Newtonian {1 / b:,.0f} steps/s, ratio {b / a:.1f}")
        print(f"{name}: a step of the physics lagged costs {lag:.2f} of one of the kinematic")
    plan, lane = (PROGRAM.format(behavior=each) for each in (PLAN, CASES["lane-following adversary"][0]))
    for driver in ("rule-based", "sac"):
        a = statistics.median(in_engine(plan, map_path, load_ego(driver)) for _ in range(ROUNDS))
        b = statistics.median(newtonian(lane, map_path, driver, 100) for _ in range(3))
        told = f"engine {1 / a:,.0f} steps/s, Newtonian {1 / b:,.0f} steps/s, ratio {b / a:,.0f}"
        print(f"lane-following adversary, {driver} at the wheel: {told}")
    profile = cProfile.Profile()
    for _ in range(ROUNDS):
        ours(source, map_path, load_ego(ego), profile)
    print(f"{name}, our own time under the profiler:")
    for part, share in sorted(shares(profile).items(), key=lambda item: -item[1]):
        print(f"  {part:<28} {share:6.1%}")


if __name__ == "__main__":
    main()
