"""Does a composed behavior do what was asked for: random ones, said in a sentence, joined with a place, and driven.

    python benchmarks/composed.py [--count 200] [--seed 0] [--scenes 10] [--ego sac] [--ego idm] [--stock 0] [--show]

Drawn are a kind of road user, where it starts, and one or two acts in order, as far as there are steps for them
(`chatscene.library.compose`), and to every second that has a speed a number. Each is written as a sentence of the acts'
own phrases and read again; its behavior is joined with a place and a start of the library that it can be joined with,
the plainest first; climbs the validation ladder; and is driven by every ego in scenes drawn from its ranges. The table
has, by position, how many sentences are read as they were meant, how many programs climb, and of their scenes how many
show every act, in order, before contact. With `--stock N` every N-th program is also compiled by the command `scenic`.
"""

from __future__ import annotations

import itertools
import random
import subprocess
import sys
import tempfile
from collections import Counter, defaultdict
from collections.abc import Iterable, Iterator
from dataclasses import dataclass, field
from pathlib import Path

import click
import numpy as np

from chatscene.ego.policy import EgoPolicy, load_ego
from chatscene.errors import ChatSceneError
from chatscene.library.act_steps import AT_JUNCTION, STARTS
from chatscene.library.bind import narrowed
from chatscene.library.compatibility import compatibility
from chatscene.library.compose import Asked, compose
from chatscene.library.load import library_with
from chatscene.maps.network import resolve_map
from chatscene.program.assemble import assemble
from chatscene.program.check import check
from chatscene.program.meaning import check_meaning
from chatscene.program.sample import draw, scene_seed
from chatscene.read.canonical import canonical
from chatscene.read.inflection import Form, conjugated, listed, with_article
from chatscene.read.parse import parse
from chatscene.settings import SimulationSettings
from chatscene.simulate.simulator import Simulator, load_simulator, simulate
from chatscene.terms.actors import AdversaryKind, Manner
from chatscene.terms.acts import Action
from chatscene.terms.conclusions import JUNCTIONS
from chatscene.terms.episode import Episode
from chatscene.terms.scenario import Component, Maneuver, Position, Scenario, Slots, SubDescriptions
from chatscene.terms.scene import Scene, ScenicProgram
from chatscene.terms.snippet import Snippet

SPEED = "OPT_ADV_SPEED"


@dataclass(frozen=True)
class Told:
    """What is asked for, with a speed [km/h] that is said; None for none."""

    asked: Asked
    speed: int | None
    sentence: str


@dataclass
class Seen:
    """What came of the behaviors of one position."""

    tried: int = 0
    read: int = 0
    misread: list[str] = field(default_factory=list[str])
    climbed: int = 0
    scenes: int = 0
    shown: int = 0
    failures: list[str] = field(default_factory=list[str])
    missed: Counter[str] = field(default_factory=Counter[str])


_ALONE = (Action.FOLLOW, Action.STAND, Action.BLOCK)  # who does something else does these, too, or not at all
_TOGETHER = [action for action in Action if action not in _ALONE]
_DONE = [*((one,) for one in Action), *itertools.permutations(_TOGETHER, 2)]
_THERE = [*((position, False) for position in STARTS), *((position, True) for position in AT_JUNCTION)]


def every(kinds: Iterable[AdversaryKind] = AdversaryKind) -> list[Asked]:
    """All that there are steps for and places to start at, with one act or two."""
    found: list[Asked] = []
    spawns = library_with().of(Component.SPAWN)
    for kind, (position, junction) in itertools.product(kinds, _THERE):
        starts = any(kind in s.adversaries for s in spawns if s.slots.position is position)
        for actions in _DONE if starts and kind.acts_as is kind else ():
            asked = Asked(kind=kind, position=position, actions=actions, junction=junction)
            said = Action.FOLLOW not in actions or position is not Position.ONCOMING  # who comes on is oncoming
            if said and compose(asked):
                found.append(asked)
    return found


_WHERE = {
    Position.AHEAD: "ahead of us",
    Position.AHEAD_BESIDE: "in the next lane",
    Position.BEHIND: "behind us",
    Position.BEHIND_BESIDE: "behind us in the next lane",
    Position.BESIDE: "beside us",
    Position.CROSSING: "from a side street",
    Position.KERB: "at the kerb",
    Position.ONCOMING: "from the opposite direction",
    Position.ROADSIDE: "at the kerb",
}


def told_of(asked: Asked, chance: random.Random) -> Told:
    """A sentence that says what is asked for, in phrases drawn from the table of acts."""
    row, made = asked.kind.row, compose(asked)
    assert made is not None
    phrases: list[str] = []
    for action in asked.actions:
        by_manner = {Manner.WALKS: action.row.walks, Manner.RIDES: action.row.rides}.get(row.manner)
        phrase = conjugated(chance.choice(listed(by_manner or action.row.drives)), Form.SINGULAR)
        names = {"from": "", "ego": "us", "egos": "our", "it": "it", "its": "its"}
        phrases.append(" ".join(phrase.format_map(names).split()))
    speeds = [p for p in made.parameters if p.name == SPEED]
    speed = round(3.6 * chance.uniform(speeds[0].low, speeds[0].high)) if speeds and chance.random() < 0.5 else None
    rides = asked.position is Position.ROADSIDE and row.manner is Manner.RIDES
    where = "from the right" if rides else _WHERE[asked.position]
    number = "" if speed is None else f" at {speed} km/h"
    place = "At a junction, " if asked.junction else ""
    sentence = f"{place}{with_article(asked.kind.noun)} {where} {', then '.join(phrases)}{number}."
    return Told(asked, speed, sentence[0].upper() + sentence[1:])


def is_read(told: Told) -> str:
    """What a sentence is read as, where that is not what it was written for; empty if it is."""
    parsed = parse(canonical(told.sentence))
    if parsed is None:
        return "not read whole"
    slots, asked = parsed.slots, told.asked
    read = (slots.adversary, slots.position, slots.actions, tuple(q.value for q in parsed.quantities))
    meant = (asked.kind, asked.position, asked.actions, () if told.speed is None else (round(told.speed / 3.6, 3),))
    return "" if read == meant and not slots.others else str(tuple(map(str, read)))


def program_of(told: Told) -> ScenicProgram | None:
    """The behavior, joined with the places and starts that add least."""
    asked = told.asked
    made = compose(asked)
    assert made is not None
    joint = compatibility(library_with().with_behavior(made))
    triples = [
        (joint.behaviors[b], joint.geometries[g], joint.spawns[s])
        for b, g, s in np.argwhere(joint.of_kind(asked.kind)).tolist()
        if joint.spawns[s].slots.position is asked.position
        and (joint.spawns[s].slots.place in JUNCTIONS or not asked.junction)
        and joint.geometries[g].slots.site is None
    ]
    if not triples:
        return None
    triple = min(triples, key=_weight)
    if told.speed is not None:
        speed = next(p for p in made.parameters if p.name == SPEED)
        around = [speed.clip(told.speed / 3.6 * share) for share in (0.9, 1.1)]
        triple = narrowed(triple, {SPEED: (around[0], around[1])})
    said = SubDescriptions(behavior="", geometry="", spawn="")
    scenario = Scenario(id=asked.snippet_id, text=told.sentence, base=None, parts=said, slots=slots_of(asked))
    return assemble(scenario, triple, asked.kind)


def compiles(program: ScenicProgram) -> bool:
    """Whether the command that comes with Scenic compiles it."""
    with tempfile.TemporaryDirectory() as folder:
        path = Path(folder) / "program.scenic"
        path.write_text(program.source)
        town = ["--param", "map", str(resolve_map("town"))]
        command = [sys.executable, "-m", "scenic", "--2d", *town, "--gather-stats", "1"]
        return subprocess.run([*command, str(path)], capture_output=True, check=False).returncode == 0


def _weight(triple: tuple[Snippet, Snippet, Snippet]) -> tuple[bool, int, str, str]:
    """What place and start add; an ego of which nothing is said goes straight on."""
    _, geometry, spawn = triple
    facts = sum(len(part.slots.said()) + len(part.parameters) for part in (geometry, spawn))
    return geometry.slots.maneuver is not Maneuver.STRAIGHT, facts, geometry.id, spawn.id


def slots_of(asked: Asked) -> Slots:
    """What a drive must show."""
    return Slots(adversary=asked.kind, position=asked.position, actions=asked.actions)


def drive(
    told: Told,
    program: ScenicProgram,
    seen: Seen,
    simulator: Simulator,
    egos: list[EgoPolicy],
    scenes: int,
    seed: int,
) -> None:
    """Read, climb, and look at scenes."""
    asked = told.asked
    seen.tried += 1
    wrong = is_read(told)
    seen.read += not wrong
    if wrong:
        seen.misread.append(f"{asked.snippet_id}: {told.sentence} {wrong}")
    try:
        check(program, slots_of(asked), simulator, egos[0])
    except ChatSceneError as error:
        seen.failures.append(f"{asked.snippet_id}: {str(error).rpartition(': ')[2]}")
        return
    seen.climbed += 1
    for ego in egos:
        for failures in missing(program, slots_of(asked), simulator, ego, scenes, seed):
            seen.scenes += 1
            seen.shown += not failures
            seen.missed.update(f"{failure} ({asked.snippet_id})" for failure in failures)


def missing(
    program: ScenicProgram, slots: Slots, simulator: Simulator, ego: EgoPolicy, scenes: int, seed: int
) -> Iterator[tuple[str, ...]]:
    """What each drawn scene that an ego drives does not show of what must be."""
    route = simulator.route(program, 0)
    for number in range(scenes):
        name = f"{program.scenario_id}/{number}"
        own = scene_seed(seed, name)
        values = draw(program.parameters, seed=own)
        scene = Scene(id=name, scenario_id=program.scenario_id, route=0, block=0, seed=own, values=values)
        episode = simulate(simulator, program, scene, ego)
        if isinstance(episode, Episode):
            yield check_meaning(slots, episode, route)


@click.command()
@click.option("--count", default=200, show_default=True)
@click.option("--seed", default=0, show_default=True)
@click.option("--scenes", default=10, show_default=True)
@click.option("--ego", "egos", multiple=True, default=("sac", "idm"), show_default=True)
@click.option("--stock", default=0, show_default=True, help="Compile every N-th program with the command, too.")
@click.option("--show", is_flag=True, help="Name what is misread and what does not climb, and why.")
def main(count: int, seed: int, scenes: int, egos: tuple[str, ...], stock: int, show: bool) -> None:
    """Print the table."""
    simulator = load_simulator(resolve_map("town"), SimulationSettings())
    loaded, chance = [load_ego(name) for name in egos], random.Random(seed)
    all_of_it = every()
    chance.shuffle(all_of_it)
    found: dict[str, Seen] = defaultdict(Seen)
    compiled: list[bool] = []
    for number, asked in enumerate(all_of_it[:count]):
        told = told_of(asked, chance)
        seen = found[f"{asked.position}, junction" if asked.junction else asked.position]
        if (program := program_of(told)) is None:
            seen.tried += 1
            seen.failures.append(f"{asked.snippet_id}: there is no place for it")
            continue
        if stock and number % stock == 0:
            compiled.append(compiles(program))
        drive(told, program, seen, simulator, loaded, scenes, seed)
    print(f"{len(all_of_it)} can be composed; {sum(compiled)} of {len(compiled)} compiled by `scenic`\n")
    print("| position | read | climb | scenes that show it |\n|---|---:|---:|---:|")
    for position, seen in (*sorted(found.items()), ("all", _sum(found.values()))):
        of = f"of {seen.tried}"
        name = position if position == "all" else f"`{position}`"
        print(f"| {name} | {seen.read} {of} | {seen.climbed} {of} | {_share(seen.shown, seen.scenes)} |")
    if show:
        print("\n" + "\n".join(line for seen in found.values() for line in (*seen.misread, *seen.failures)))
        for seen in found.values():
            print("\n".join(f"{count} scenes: {missed}" for missed, count in seen.missed.most_common()))


def _sum(every: Iterable[Seen]) -> Seen:
    total = Seen()
    for seen in every:
        for name in ("tried", "read", "climbed", "scenes", "shown"):
            setattr(total, name, getattr(total, name) + getattr(seen, name))
    return total


def _share(shown: int, scenes: int) -> str:
    return f"{shown / scenes:.2f} of {scenes}" if scenes else "none"


if __name__ == "__main__":
    main()
