"""How fast `native` is, against the embedded simulator in the same process.

    python benchmarks/native_speed.py [--programs 40] [--copies 200] [--seed 0] [--ego rule-based] [--rounds 3]

Programs of the library, as in `native_gate.py`, one scene of each. Processor time of three things: the embedded drive
from the opened scene to its end; the engine over copies of all scenes in one call; and a whole `simulate`, placement,
binding and episode included, in both. An agent-step is one step of one body that can move.
"""

from __future__ import annotations

import statistics
import time
from collections.abc import Callable
from contextlib import suppress
from dataclasses import dataclass, field
from functools import partial

import click
import numpy as np
from native_gate import programs, scenes

from chatscene.ego.policy import EgoPolicy, load_ego, observation_of, pedals_of
from chatscene.errors import ChatSceneError
from chatscene.maps.network import resolve_map
from chatscene.settings import SimulationSettings
from chatscene.simulate.native.binding import Bound, bind
from chatscene.simulate.native.code import NotCovered
from chatscene.simulate.native.engine import Engine, load_engine
from chatscene.simulate.native.policies import policy_of
from chatscene.simulate.session import SteppedSession
from chatscene.simulate.simulator import Simulator, drive, load_simulator, simulate
from chatscene.terms.scene import Scene, ScenicProgram


def spent(part: Callable[[], object]) -> float:
    began = time.thread_time()
    part()
    return time.thread_time() - began


@dataclass
class Scenes:
    """Opened scenes of one ego, driven once in the embedded simulator."""

    pairs: list[tuple[ScenicProgram, Scene]] = field(default_factory=list[tuple[ScenicProgram, Scene]])
    bound: list[Bound] = field(default_factory=list[Bound])
    agent_steps: int = 0
    driving: float = 0.0
    binding: float = 0.0

    def take(self, embedded: Simulator, program: ScenicProgram, scene: Scene, ego: EgoPolicy) -> None:
        """Open a scene, bind it, and drive it in the embedded simulator."""
        session = embedded.open(program, scene, observation=observation_of(ego), pedals=pedals_of(ego))
        if not isinstance(session, SteppedSession):
            return
        began = time.thread_time()
        bound = bind(session, program)
        self.binding += time.thread_time() - began
        self.driving += spent(partial(drive, session, ego, scene.id))
        self.agent_steps += session.step_number * bound.world.moving
        session.close()
        self.pairs.append((program, scene))
        self.bound.append(bound)

    def engine_rate(self, engine: Engine, ego: EgoPolicy, copies: int) -> float:
        """Agent-steps a second of the engine, over copies of all scenes in one call."""
        worlds = [one.copy() for one in self.bound for _ in range(copies)]
        policy = policy_of(ego, engine)
        assert policy is not None, "an ego that the engine does not know"
        seconds = spent(lambda: engine.run_many([one.world for one in worlds], policy))
        assert sum(one.world.step * one.world.moving for one in worlds) == self.agent_steps * copies
        return self.agent_steps * copies / seconds

    def whole(self, simulator: Simulator, ego: EgoPolicy) -> float:
        """Milliseconds a scene."""
        seconds = spent(lambda: [simulate(simulator, *pair, ego) for pair in self.pairs])
        return 1e3 * seconds / len(self.pairs)


@click.command()
@click.option("--programs", "count", default=40)
@click.option("--copies", default=200)
@click.option("--seed", default=0)
@click.option("--ego", "egos", multiple=True, default=("rule-based", "idm"))
@click.option("--rounds", default=3)
def main(count: int, copies: int, seed: int, egos: tuple[str, ...], rounds: int) -> None:
    """Print agent-steps per second of processor time."""
    town, engine = resolve_map("town"), load_engine()
    embedded, native = (load_simulator(town, SimulationSettings(simulator=name)) for name in ("embedded", "native"))
    for ego in map(load_ego, egos):
        found = Scenes()
        for program in programs(count, np.random.default_rng(seed)):
            with suppress(ChatSceneError, NotCovered):
                for scene in scenes(program, embedded, 1, seed):
                    found.take(embedded, program, scene, ego)
        rates = [found.engine_rate(engine, ego, copies) for _ in range(rounds)]
        before, after = (min(found.whole(one, ego) for _ in range(rounds)) for one in (embedded, native))
        old, new = found.agent_steps / found.driving, statistics.median(rates)
        print(
            f"{type(ego).__name__}: {len(found.pairs)} scenes, {found.agent_steps} agent-steps; embedded {old:,.0f}, "
            f"engine {new:,.0f} agent-steps/s ({', '.join(f'{rate:,.0f}' for rate in rates)}), {new / old:.0f} times; "
            f"to bind {1e3 * found.binding / len(found.pairs):.1f} ms; a whole simulate {before:.1f} against "
            f"{after:.1f} ms"
        )


if __name__ == "__main__":
    main()
