"""Does every packaged behavior show what its header says before the ego meets anything.

    python benchmarks/packaged.py [--scenes 6] [--seed 0] [--ego sac] [--ego idm] [--only GLOB] [--below 0.9]

Each behavior is joined with a place and a start of the library, once for every position that it can start from, the
plainest first; and each program is driven by every ego in scenes drawn from its ranges. A row per program: in what
share of its scenes each ego sees every act, in order, before it meets anything, and what is missing most often. Only
rows of which an ego sees less than `--below` are printed; the totals are of all.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from fnmatch import fnmatch

import click
import numpy as np
from composed import missing

from chatscene.ego.policy import EgoPolicy, load_ego
from chatscene.errors import ChatSceneError
from chatscene.library.compatibility import compatibility
from chatscene.library.load import library_with
from chatscene.maps.network import resolve_map
from chatscene.program.assemble import assemble
from chatscene.settings import SimulationSettings
from chatscene.simulate.simulator import Simulator, load_simulator
from chatscene.terms.actors import AdversaryKind
from chatscene.terms.scenario import Maneuver, Place, Position, Scenario, Slots, SubDescriptions
from chatscene.terms.scene import ScenicProgram
from chatscene.terms.snippet import Snippet

Triple = tuple[Snippet, Snippet, Snippet]


@dataclass(frozen=True)
class Fared:
    """How a program fared with an ego."""

    scenes: int
    shown: int
    missed: Counter[str]

    @property
    def share(self) -> float:
        """Of its scenes, those that show everything; none of none."""
        return self.shown / self.scenes if self.scenes else 0.0


def plainest(only: str) -> Iterator[Triple]:
    """For each behavior, and each position that it can start from, the place and the start that add least."""
    joint = compatibility(library_with())
    for b, behavior in enumerate(joint.behaviors):
        found: dict[Position | None, Triple] = {}
        for g, s in np.argwhere(joint.mask[b]).tolist():
            triple = behavior, joint.geometries[g], joint.spawns[s]
            position = triple[2].slots.position
            found[position] = min((found.get(position, triple), triple), key=_weight)
        if fnmatch(behavior.id.removeprefix("behavior/"), only):
            yield from found.values()


def _weight(triple: Triple) -> tuple[bool, bool, bool, int, str, str]:
    """What place and start add; where nothing is said, an ego goes straight along a street in town."""
    _, geometry, spawn = triple
    facts = sum(len(part.slots.said()) + len(part.parameters) for part in (geometry, spawn))
    turns, elsewhere = geometry.slots.maneuver is not Maneuver.STRAIGHT, geometry.slots.site is not None
    return elsewhere, turns, geometry.slots.place is not Place.ROAD, facts, geometry.id, spawn.id


def program_of(triple: Triple) -> tuple[ScenicProgram, Slots]:
    """The program, with the first kind of road user that fits, and what a drive of it must show."""
    behavior, _, spawn = triple
    kind = next(kind for kind in behavior.adversaries if kind in spawn.adversaries)
    slots = Slots(adversary=AdversaryKind(kind), position=spawn.slots.position, actions=behavior.slots.actions)
    said = SubDescriptions(behavior="", geometry="", spawn="")
    scenario = Scenario(
        id=f"{behavior.id}/{spawn.slots.position}", text=behavior.description, base=None, parts=said, slots=slots
    )
    return assemble(scenario, triple, kind), slots


def fared(program: ScenicProgram, slots: Slots, simulator: Simulator, ego: EgoPolicy, scenes: int, seed: int) -> Fared:
    """Drive scenes of a program and look at what they show."""
    ran, shown, missed = 0, 0, Counter[str]()
    for failures in missing(program, slots, simulator, ego, scenes, seed):
        ran, shown = ran + 1, shown + (not failures)
        missed.update(failures)
    return Fared(ran, shown, missed)


@click.command()
@click.option("--scenes", default=6, show_default=True)
@click.option("--seed", default=0, show_default=True)
@click.option("--ego", "names", multiple=True, default=("sac", "idm"), show_default=True)
@click.option("--only", default="*", show_default=True, help="Behaviors whose name fits.")
@click.option("--below", default=0.9, show_default=True, help="Print rows of which some ego sees less than this share.")
def main(scenes: int, seed: int, names: Sequence[str], only: str, below: float) -> None:
    """Print the table."""
    simulator, egos = load_simulator(resolve_map("town"), SimulationSettings()), [load_ego(name) for name in names]
    rows: list[list[Fared]] = []
    short = 0
    print(f"| behavior | starts | {' | '.join(names)} | missed most |\n|---|---|{'---:|' * len(names)}---|")
    for triple in plainest(only):
        position = triple[2].slots.position
        try:
            program, slots = program_of(triple)
            row = [fared(program, slots, simulator, ego, scenes, seed) for ego in egos]
        except ChatSceneError as error:
            print(f"| `{triple[0].id}` | `{position}` | failed: {error} |", flush=True)
            continue
        rows.append(row)
        if min(one.share for one in row) < below:
            short += 1
            missed = sum((one.missed for one in row), Counter[str]()).most_common(1)
            shares = " | ".join(f"{one.share:.2f}" for one in row)
            print(f"| `{triple[0].id}` | `{position}` | {shares} | {missed[0][0] if missed else ''} |", flush=True)
    print(f"\n{len(rows)} programs, of which {short} show it to some ego in less than {below} of the scenes")
    for number, name in enumerate(names):
        ran, shown = (sum(getattr(row[number], part) for row in rows) for part in ("scenes", "shown"))
        print(f"{name}: {shown} of {ran} scenes show it")


if __name__ == "__main__":
    main()
