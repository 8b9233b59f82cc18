"""How many made-up sentences come back: read, retrieved, run, and found to mean what they say.

    python benchmarks/describe_round_trip.py [--count 20] [--seed 0] [--base right-turn] [--no-drives] [--own]

For each base scenario so many descriptions are made, each is read, its triple retrieved, its program checked. Prints
every sentence with how far it came, then a table: the share that came through, that got the very triple it was
written about, and how different the sentences are. With ``--own`` nothing is retrieved: the triple a sentence was
written about is checked, which shows how much of a loss is retrieval's. Checked is what the triple was to do, not
what was read.
"""

from __future__ import annotations

import argparse
import time
from dataclasses import dataclass

from chatscene.ego.rule_based import RuleBased
from chatscene.errors import ChatSceneError
from chatscene.interpret.asked import scenario_of
from chatscene.interpret.retrieve import retrieve
from chatscene.library.load import load_library
from chatscene.maps.network import resolve_map
from chatscene.models.encoders.embedding import load_embedder
from chatscene.program.assemble import assemble
from chatscene.program.check import check
from chatscene.sentences.describe import describe, diversity
from chatscene.settings import SimulationSettings
from chatscene.simulate.simulator import Simulator, load_simulator
from chatscene.terms.description import Description
from chatscene.terms.scenario import BaseScenario


@dataclass(frozen=True, slots=True)
class Came:
    """How far a sentence came: `problem` is empty if all the way."""

    problem: str
    same: int  # parts of its triple that were retrieved


def round_trip(description: Description, simulator: Simulator | None, own: bool) -> Came:
    scenario = scenario_of(description.text)
    same = 3 if own else 0
    behavior, geometry, spawn = (load_library().get(name) for name in description.snippet_ids)
    triple, adversary = (behavior, geometry, spawn), description.adversary
    try:
        if not own:
            found = retrieve(scenario, load_library(), load_embedder())
            triple, adversary = found.snippets, found.adversary
            same = sum(a.id == b for a, b in zip(triple, description.snippet_ids, strict=True))
        program = assemble(scenario, triple, adversary)
        if simulator is not None:
            check(program, description.slots, simulator, RuleBased())
    except ChatSceneError as error:
        return Came(f"{type(error).__name__}: {error}", same)
    return Came("", same)


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--count", type=int, default=20)
    parser.add_argument("--seed", type=int, default=0)
    parser.add_argument("--base", choices=list(BaseScenario), default=None)
    parser.add_argument("--no-drives", action="store_true", help="stop before the simulator")
    parser.add_argument("--own", action="store_true", help="check the triple itself instead of the one retrieved")
    given = parser.parse_args()
    simulator = None if given.no_drives else load_simulator(resolve_map("town"), SimulationSettings())
    rows: list[str] = []
    for base in [BaseScenario(given.base)] if given.base else list(BaseScenario):
        began = time.perf_counter()
        made = describe(base, given.count, library=load_library(), seed=given.seed)
        took = time.perf_counter() - began
        came: list[Came] = []
        for description in made:
            came.append(round_trip(description, simulator, given.own))
            print(f"{base} | {' + '.join(description.snippet_ids)} | {description.adversary}")
            print(f"    {description.text}")
            if came[-1].problem:
                print(f"    FAILED {came[-1].problem[:400]}")
        d = diversity(made, load_embedder())
        whole = sum(not c.problem for c in came)
        parts = sum(c.same for c in came) / (3 * len(came))
        rows.append(
            f"| {base} | {len(made)} | {whole} | {parts:.0%} | {d.behaviors} | {d.geometries} | {d.spawns} | {d.kinds} "
            f"| {d.distinct_2:.2f} | {d.distance:.2f} | {took:.1f} |"
        )
    print("| base scenario | sentences | came through | same parts | behaviors | geometries | spawns | kinds "
          "| distinct-2 | distance | s |")  # fmt: skip
    print("|---|---|---|---|---|---|---|---|---|---|---|")
    print("\n".join(rows))


if __name__ == "__main__":
    main()
