"""What it takes to ask whether a careful driver avoids a crash: processor time a scene, and the answers.

    python benchmarks/second_drives.py [--programs 40] [--seed 0] [--ego idm] [--simulator native]

Programs of the library, as in `native_gate.py`, one scene of each; those that crash are asked. Runs on any commit, so
that two of them can be compared; the digest is of all answers, the last moments to brake among them.
"""

from __future__ import annotations

import hashlib
import time
from contextlib import suppress

import click
import numpy as np
from native_gate import programs, scenes

from chatscene.ego.policy import load_ego
from chatscene.errors import ChatSceneError
from chatscene.maps.network import resolve_map
from chatscene.measure.avoidability import avoidable
from chatscene.measure.counterfactual import Trial, last_moment, latest_braking
from chatscene.settings import SimulationSettings
from chatscene.simulate.simulator import load_simulator, simulate
from chatscene.terms.scene import Rejected


@click.command()
@click.option("--programs", "count", default=40)
@click.option("--seed", default=0)
@click.option("--ego", "egos", multiple=True, default=("idm", "sac", "planner"))
@click.option("--simulator", "name", default="native")
def main(count: int, seed: int, egos: tuple[str, ...], name: str) -> None:
    simulator = load_simulator(resolve_map("town"), SimulationSettings(simulator=name))
    found = [
        (program, scene)
        for program in programs(count, np.random.default_rng(seed))
        for scene in _scenes(program, simulator, seed)
    ]
    for ego in map(load_ego, egos):
        asked, once, seconds, why, answers = 0, 0.0, 0.0, 0.0, hashlib.blake2b(digest_size=6)
        for program, scene in found:
            with suppress(ChatSceneError):
                began = time.process_time()
                episode = simulate(simulator, program, scene, ego)
                once += time.process_time() - began
                if isinstance(episode, Rejected) or episode.collision is None:
                    continue
                asked += 1
                began = time.process_time()
                answer = avoidable(episode, program, scene, ego, simulator)
                seconds += time.process_time() - began
                route = simulator.route_in(program, scene).line
                trial = Trial(program=program, scene=scene, ego=ego, simulator=simulator, episode=episode, route=route)
                began = time.process_time()
                moments = last_moment(trial), latest_braking(trial)
                why += time.process_time() - began
                answers.update(repr((scene.id, answer, moments, trial.drives)).encode())
        print(
            f"{type(ego).__name__}: {len(found)} scenes, {once / len(found) * 1e3:.1f} ms a drive; {asked} crashed, "
            f"{seconds / max(asked, 1) * 1e3:.1f} ms to ask each, {why / max(asked, 1) * 1e3:.0f} ms for its last "
            f"moments; answers {answers.hexdigest()}",
            flush=True,
        )


def _scenes(program: object, simulator: object, seed: int) -> list[object]:
    with suppress(ChatSceneError):
        return list(scenes(program, simulator, 1, seed))
    return []


if __name__ == "__main__":
    main()
