"""What a user waits for: compile, sample, retrieve, a whole run; and whether memory stays flat.

    python benchmarks/latency.py

Times are processor time; the targets stand beside them.
"""

from __future__ import annotations

import gc
import resource
import statistics
import tempfile
import time
from collections.abc import Callable
from contextlib import suppress
from pathlib import Path

from waited_for import LATER, SENTENCE, cost_of_ours

from chatscene import pipeline, runs
from chatscene.ego.rule_based import RuleBased
from chatscene.errors import NothingFits
from chatscene.interpret.asked import scenario_of
from chatscene.interpret.retrieve import retrieve
from chatscene.library.compatibility import compatibility
from chatscene.library.load import load_library
from chatscene.maps.network import resolve_map
from chatscene.models.encoders.embedding import load_embedder
from chatscene.program.assemble import assemble
from chatscene.program.check import probe_scenes
from chatscene.settings import SimulationSettings
from chatscene.simulate.simulator import load_simulator, simulate
from chatscene.simulate.staging import Stage
from chatscene.terms.scenario import Component, Scenario
from chatscene.terms.scene import ScenicProgram

EPISODES = 1000
REPEATS = 3


def programs(count: int) -> list[ScenicProgram]:
    """Programs from triples spread over the whole library but for sites, each behavior in turn."""
    joint = compatibility(load_library().without_sites())  # the town has none
    scenario = scenario_of(SENTENCE)
    made: list[ScenicProgram] = []
    for b, behavior in enumerate(joint.behaviors):
        for g, s in list(zip(*joint.mask[b].nonzero(), strict=True))[:: max(1, int(joint.mask[b].sum()) // 2)]:
            spawn = joint.spawns[s]
            kind = next(k for k in behavior.adversaries if k in spawn.adversaries)
            made.append(assemble(scenario, (behavior, joint.geometries[g], spawn), kind))
    return made[:: max(1, len(made) // count)][:count]


def seconds(work: Callable[[], object]) -> float:
    began = time.process_time()
    work()
    return time.process_time() - began


def explained(text: str) -> None:
    """Understand a text, or refuse it: either is an answer that a user waits for."""
    with suppress(NothingFits):
        pipeline.understand(text)


def report(what: str, measured: float, target: float, unit: str = "s") -> None:
    print(f"{what:<54} {measured:8.3f} {unit:<3} (target {target:g})")


def main() -> None:
    map_path = resolve_map("town")
    chosen = programs(60)
    first = Stage(map_path)
    first.compiled(chosen[0], 0)  # Scenic's own library is parsed once
    report(
        "warm compile of a new program, median",
        statistics.median([seconds(lambda p=p: first.compiled(p, 0)) for p in chosen[1:]]),
        0.2,
    )
    again = Stage(map_path)
    report(
        "compile of a known program, median",
        statistics.median([seconds(lambda p=p: again.compiled(p, 0)) for p in chosen]),
        0.03,
    )
    samples: list[float] = []
    for program in chosen:
        again.compiled(program, 0)
        samples += [seconds(lambda p=program, s=s: again.place(p, s)) for s in probe_scenes(program, 0)]
    report("sampling a scene, median over the library", 1e3 * statistics.median(samples), 10, "ms")

    library, embedder = load_library(), load_embedder()
    sentences = [
        scenario_of(f"{g.description} {b.description}")
        for g in library.of(Component.GEOMETRY)[::4]
        for b in library.of(Component.BEHAVIOR)[::6]
    ]

    def find(sentence: Scenario) -> None:
        with suppress(NothingFits):  # some of these make no sense together; finding that out costs the same
            retrieve(sentence, library, embedder)

    find(sentences[0])
    report(
        "retrieval, median over different sentences",
        1e3 * statistics.median([seconds(lambda s=s: find(s)) for s in sentences[1:]]),
        20,
        "ms",
    )

    with tempfile.TemporaryDirectory() as folder:
        report("chatscene --help, processor time", cost_of_ours("--help")[0], 1)
        run, peak = cost_of_ours("run", SENTENCE, "--out", f"{folder}/run")
        report("chatscene run, 50 scenes on one route, processor time", run, 5)
        report("chatscene run, peak memory", peak, 450, "MB")

        costs = [cost_of_ours("explain", SENTENCE) for _ in range(REPEATS)]
        report("chatscene explain, processor time, median", statistics.median(cpu for cpu, _ in costs), 1.5)
        report("chatscene explain, peak memory, median", statistics.median(peak for _, peak in costs), 400, "MB")
        rows = runs.read_scenes(runs.Workspace(Path(folder, "run")))
        scene = next(row["scene_id"] for row in rows if row["status"] == "ran")
        replays = [cost_of_ours("replay", f"{folder}/run", scene)[0] for _ in range(REPEATS)]
        report("chatscene replay, processor time, median", statistics.median(replays), 1)
    explained(SENTENCE)
    for number, text in enumerate(LATER, 1):
        began = time.process_time()
        explained(text)
        report(f"later sentence {number} of a process, processor time", time.process_time() - began, 0.1)

    simulator = load_simulator(map_path, SimulationSettings())
    program = pipeline.understand(SENTENCE).program
    scenes = probe_scenes(program, 0)

    def drive(count: int) -> float:
        for i in range(count):
            simulate(simulator, program, scenes[i % len(scenes)], RuleBased())
        gc.collect()
        # What is held now, not the peak: compiling before has a higher one, which would hide growth.
        return int(Path("/proc/self/statm").read_text().split()[1]) * resource.getpagesize() / 2**20

    before = drive(100)
    report(f"memory grown over {EPISODES} episodes", drive(EPISODES) - before, 5, "MB")


if __name__ == "__main__":
    main()
