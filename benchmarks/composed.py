"""Does a composed behavior do what was asked for: random ones, joined with a place and a start, and driven.

    python benchmarks/composed.py [--count 200] [--seed 0] [--scenes 10] [--ego sac] [--ego idm] [--show]

Drawn are a kind of road user, where it starts, and one or two acts in order, as far as there are steps for them
(`chatscene.library.compose`). Each behavior is joined with a place and a start of the library that it can be joined
with, the plainest first; climbs the validation ladder; and is driven by every ego in scenes drawn from its ranges. The
table has, by position, how many climb, and of their scenes how many show every act, in order, before contact.
"""

from __future__ import annotations

import itertools
import random
from collections import Counter, defaultdict
from dataclasses import dataclass, field

import click
import numpy as np

from chatscene.ego.policy import EgoPolicy, load_ego
from chatscene.errors import ChatSceneError
from chatscene.library.compatibility import compatibility
from chatscene.library.compose import STARTS, Asked, compose
from chatscene.library.load import library_with
from chatscene.maps.network import resolve_map
from chatscene.program.assemble import assemble
from chatscene.program.check import check
from chatscene.program.meaning import check_meaning
from chatscene.program.sample import draw, scene_seed
from chatscene.settings import SimulationSettings
from chatscene.simulate.simulator import Simulator, load_simulator, simulate
from chatscene.terms.actors import AdversaryKind
from chatscene.terms.episode import Episode
from chatscene.terms.scenario import Component, Scenario, Slots, SubDescriptions
from chatscene.terms.scene import Scene, ScenicProgram
from chatscene.terms.snippet import Snippet


@dataclass
class Seen:
    """What came of the behaviors of one position."""

    tried: int = 0
    climbed: int = 0
    scenes: int = 0
    shown: int = 0
    failures: list[str] = field(default_factory=list[str])
    missed: Counter[str] = field(default_factory=Counter[str])


def every() -> list[Asked]:
    """All that there are steps for and places to start at, with one act or two."""
    found: list[Asked] = []
    spawns = library_with().of(Component.SPAWN)
    for kind, (position, start) in itertools.product(AdversaryKind, STARTS.items()):
        acts = dict.fromkeys((*start.steps, *sorted(start.given)))
        for actions in (*((one,) for one in acts), *itertools.permutations(acts, 2)):
            asked = Asked(kind=kind, position=position, actions=actions)
            if any(kind in s.adversaries for s in spawns if s.slots.position is position) and compose(asked):
                found.append(asked)
    return found


def program_of(asked: Asked) -> ScenicProgram | None:
    """The behavior, joined with the places and starts that add least."""
    made = compose(asked)
    assert made is not None
    joint = compatibility(library_with().with_behavior(made))
    triples = [
        (joint.behaviors[b], joint.geometries[g], joint.spawns[s])
        for b, g, s in np.argwhere(joint.of_kind(asked.kind)).tolist()
        if joint.spawns[s].slots.position is asked.position
    ]
    if not triples:
        return None
    triple = min(triples, key=_weight)
    said = SubDescriptions(behavior="", geometry="", spawn="")
    scenario = Scenario(id=asked.snippet_id, text=asked.snippet_id, base=None, parts=said, slots=slots_of(asked))
    return assemble(scenario, triple, asked.kind)


def _weight(triple: tuple[Snippet, Snippet, Snippet]) -> tuple[int, str, str]:
    """What place and start add."""
    _, geometry, spawn = triple
    facts = sum(len(part.slots.said()) + len(part.parameters) for part in (geometry, spawn))
    return facts, geometry.id, spawn.id


def slots_of(asked: Asked) -> Slots:
    """What a drive must show."""
    return Slots(adversary=asked.kind, position=asked.position, actions=asked.actions)


def drive(
    asked: Asked,
    program: ScenicProgram,
    seen: Seen,
    simulator: Simulator,
    egos: list[EgoPolicy],
    scenes: int,
    seed: int,
) -> None:
    """Climb, and look at scenes."""
    seen.tried += 1
    try:
        check(program, slots_of(asked), simulator, egos[0])
    except ChatSceneError as error:
        seen.failures.append(f"{asked.snippet_id}: {str(error).rpartition(': ')[2]}")
        return
    seen.climbed += 1
    route = simulator.route(program, 0)
    for ego, number in itertools.product(egos, range(scenes)):
        name = f"{program.scenario_id}/{number}"
        own = scene_seed(seed, name)
        values = draw(program.parameters, seed=own)
        scene = Scene(id=name, scenario_id=program.scenario_id, route=0, block=0, seed=own, values=values)
        episode = simulate(simulator, program, scene, ego)
        if isinstance(episode, Episode):
            seen.scenes += 1
            failures = check_meaning(slots_of(asked), episode, route)
            seen.shown += not failures
            seen.missed.update(f"{failure} ({asked.snippet_id})" for failure in failures)


@click.command()
@click.option("--count", default=200, show_default=True)
@click.option("--seed", default=0, show_default=True)
@click.option("--scenes", default=10, show_default=True)
@click.option("--ego", "egos", multiple=True, default=("sac", "idm"), show_default=True)
@click.option("--show", is_flag=True, help="Name what does not climb, and why.")
def main(count: int, seed: int, scenes: int, egos: tuple[str, ...], show: bool) -> None:
    """Print the table."""
    simulator = load_simulator(resolve_map("town"), SimulationSettings())
    all_of_it = every()
    random.Random(seed).shuffle(all_of_it)
    joined = ((asked, program) for asked in all_of_it if (program := program_of(asked)) is not None)
    found: dict[str, Seen] = defaultdict(Seen)
    for asked, program in itertools.islice(joined, count):
        drive(asked, program, found[asked.position], simulator, [load_ego(name) for name in egos], scenes, seed)
    print("| position | climb | scenes that show it |\n|---|---:|---:|")
    for position, seen in sorted(found.items()):
        print(f"| `{position}` | {seen.climbed} of {seen.tried} | {_share(seen.shown, seen.scenes)} |")
    all_climbed, tried = sum(s.climbed for s in found.values()), sum(s.tried for s in found.values())
    all_shown, driven = sum(s.shown for s in found.values()), sum(s.scenes for s in found.values())
    print(f"| all | {all_climbed} of {tried} | {_share(all_shown, driven)} |")
    if show:
        print("\n" + "\n".join(failure for seen in found.values() for failure in seen.failures))
        for seen in found.values():
            print("\n".join(f"{count} scenes: {missed}" for missed, count in seen.missed.most_common()))


def _share(shown: int, scenes: int) -> str:
    return f"{shown / scenes:.2f} of {scenes}" if scenes else "none"


if __name__ == "__main__":
    main()
