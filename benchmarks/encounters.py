"""How often whoever is searched with is met: collisions, near misses, and failures that are worth something.

    python benchmarks/encounters.py [--ego idm] [--ego planner] [--routes 1] [--seeds 1] [--scenes 50]
        [--half 1]

Forty plain sentences of others (`texts/plain.jsonl`: the first forty of `kept`, `kept-second`, … in the order of their
lines that are in scope, have no number and 25 words at most, and that were served offline at commit ae755c16). Each is
read offline and searched as a run does. Prints, for each ego,

- of the scenes of the first block of ten how many have an encounter: a collision, or a nearest gap to an adversary
  below 2 m or 1.5 s (`time_headway` behind it or time to collision), which who only follows closely has, too; in how
  many the two are on the way to a collision: one, or a time to collision below 1.5 s; in how many the ego collides;
- of all scenes, per 1,000 simulations: crashes, those that a careful driver would have avoided, and the distinct of
  these, as `avoidable.py` counts them: each kind of crash once per sentence, route and seed; and how many of these come
  up first in each block of a search, so that it is seen whether a longer one would find more.

`--half 1` takes every second sentence, which nothing that is trained or tuned at speed has learned from.
"""

from __future__ import annotations

import json
from collections import Counter
from collections.abc import Iterator
from dataclasses import dataclass, field
from pathlib import Path

import click
from building import simulator

from chatscene.ego.policy import load_ego
from chatscene.errors import ChatSceneError, EgoError
from chatscene.measure.drive import Ran
from chatscene.report.filled import explain_text
from chatscene.report.stated import Stated
from chatscene.search.explore import explore
from chatscene.settings import SearchSettings
from chatscene.simulate.simulator import routes_of

TEXTS = Path(__file__).parent / "texts" / "plain.jsonl"
NEAR, SOON = 2.0, 1.5  # [m], [s]


@dataclass(slots=True)
class Found:
    """What searches came to.

    Attributes:
        refused: Sentences that are not served, with the reason.
        drives: Scenes of first blocks.
        encounters: Of these, with an encounter.
        closing_in: Of these, with a collision or one that was less than 1.5 s away.
        collisions: Of these, with a collision.
        unmet: Sentences without an encounter in the first block, and with how many seeds.
        driven: All scenes.
        crashes: Of these, with a collision.
        avoidable: Of these, one that a careful driver would have avoided.
        distinct: The kinds of those, each once per sentence, route and seed.
        new: How many of those come up first in each block of a search.
        closing: The speeds of approach of all collisions [m/s].
    """

    refused: dict[str, str] = field(default_factory=dict[str, str])
    drives: int = 0
    encounters: int = 0
    closing_in: int = 0
    collisions: int = 0
    unmet: Counter[str] = field(default_factory=Counter[str])
    driven: int = 0
    crashes: int = 0
    avoidable: int = 0
    distinct: set[tuple[str, int, int, str]] = field(default_factory=set[tuple[str, int, int, str]])
    new: Counter[int] = field(default_factory=Counter[int])
    closing: list[float] = field(default_factory=list[float])


def sentences() -> Iterator[tuple[str, str]]:
    """The id and the text of each."""
    for line in TEXTS.read_text(encoding="utf-8").splitlines():
        row = json.loads(line)
        yield row["id"], row["text"]


def meets(ran: Ran) -> bool:
    """Whether a drive has an encounter: a collision, or a nearest gap below 2 m or 1.5 s."""
    found = ran.criticality
    gaps = (found.distance, NEAR), (found.time_to_collision, SOON), (found.time_headway, SOON)
    return ran.episode.collision is not None or any(_below(gap, bound) for gap, bound in gaps)


def _below(gap: float | None, bound: float) -> bool:
    return gap is not None and gap < bound


def search(found: Found, name: str, text: str, ego: str, settings: SearchSettings) -> None:
    """Search with a sentence as a run does, and count."""
    try:
        stated = explain_text(text)
        if not isinstance(stated, Stated):
            raise TypeError(f"{name} is served by snippets, not as a situation")
        world = simulator(stated.built.map)
        program, said = stated.program, stated.situation
        before = found.encounters
        for route in routes_of(world, program, settings.routes):
            for block in explore(program, said, route, simulator=world, ego=load_ego(ego), settings=settings):
                known = len(found.distinct)
                _count(found, block.ran, (name, route, settings.seed), first=block.number == 0)
                found.new[block.number] += len(found.distinct) - known
        if found.encounters == before:
            found.unmet[name] += 1
    except EgoError:
        raise
    except ChatSceneError as error:
        found.refused[name] = str(error)


def _count(found: Found, ran: tuple[Ran, ...], where: tuple[str, int, int], *, first: bool) -> None:
    for one in ran:
        crash = one.episode.collision
        found.driven += 1
        found.crashes += crash is not None
        if crash is not None:
            found.closing.append(crash.impact_speed)
        if first:
            found.drives += 1
            found.encounters += meets(one)
            found.closing_in += crash is not None or _below(one.criticality.time_to_collision, SOON)
            found.collisions += crash is not None
        if one.avoidable:
            found.avoidable += 1
            found.distinct.add((*where, one.crash_type))


def told(found: Found, ego: str) -> Iterator[str]:
    """Lines for a person."""
    for name, reason in found.refused.items():
        yield f"  refused: {name}: {reason[:160]}"
    for name, seeds in found.unmet.items():
        yield f"  no encounter in the first block: {name}, with {seeds} seeds"
    per = 1000 / max(found.driven, 1)
    closing = sorted(found.closing)
    middle = f", closing at {closing[len(closing) // 2]:.1f} m/s in the median" if closing else ""
    counted = found.encounters, found.closing_in, found.collisions
    met, near, hit = (number / max(found.drives, 1) for number in counted)
    yield (
        f"{ego}: first blocks: {found.drives} scenes, an encounter in {found.encounters} ({met:.0%}), "
        f"under 1.5 s from a collision in {found.closing_in} ({near:.0%}), "
        f"a collision in {found.collisions} ({hit:.0%})"
    )
    yield (
        f"{ego}: per 1,000 of {found.driven} simulations: {found.crashes * per:.0f} crashes{middle}, "
        f"{found.avoidable * per:.1f} avoidable, {len(found.distinct) * per:.1f} distinct avoidable"
    )
    yield f"{ego}: new ones by block: {', '.join(str(found.new[block]) for block in sorted(found.new))}"


@click.command()
@click.option("--ego", "egos", multiple=True, default=("idm", "planner"), show_default=True)
@click.option("--count", default=40, show_default=True, help="The first of the sentences.")
@click.option("--scenes", default=50, show_default=True)
@click.option("--routes", default=1, show_default=True)
@click.option("--seeds", default=1, show_default=True)
@click.option("--half", type=click.IntRange(0, 1), default=None, help="Every second sentence, from this one on.")
def main(egos: tuple[str, ...], count: int, scenes: int, routes: int, seeds: int, half: int | None) -> None:
    """Search with plain sentences, and see who meets whom."""
    for ego in egos:
        found = Found()
        for name, text in list(sentences())[:count][half or 0 :: 1 if half is None else 2]:
            for seed in range(seeds):
                search(found, name, text, ego, SearchSettings(scenes=scenes, routes=routes, seed=seed))
        for line in told(found, ego):
            click.echo(line)


if __name__ == "__main__":
    main()
