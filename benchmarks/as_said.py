"""Random situations made of what people say: each part was read from a text of somebody, their union is new.

A situation is put together of an ego's route, a number of road users, and for each of them a kind and a place that
were said together; its first deed is one that was said of somebody there, each next one follows a deed as it was said
to follow it, and a deed has the manner and the amounts that one like it had. The parts are those of the replies of
language models to texts of others (`reading/`), so that a kind of situation is drawn as often as people tell it.
"""

from __future__ import annotations

import json
import random
from collections import defaultdict
from collections.abc import Iterator
from dataclasses import dataclass, field, replace
from functools import cache
from itertools import pairwise
from pathlib import Path

from chatscene.build.asked import FROM_A_STAND
from chatscene.read.by_model import situation_in
from chatscene.situations.faults import Malformed
from chatscene.terms.actors import Manner as Moves
from chatscene.terms.situation import Deed, Ego, Other, Situation
from chatscene.terms.vocabulary import Act, Role, Where

READING = Path(__file__).parent / "reading"
FILES = ("replies.jsonl", "fresh.jsonl", "fresh-second.jsonl")
MOST = 3  # road users, and deeds of each in a row
Sort = tuple[Moves, bool]
"""How somebody moves, and whether by an engine: those of one sort do what others of it do, as fast."""


@dataclass(frozen=True, slots=True)
class Parts:
    """What was said, by what it was said with.

    Attributes:
        egos: Routes and speeds of the ego.
        numbers: How many others there were.
        who: A kind, a place, and how it stood there.
        first: The first deeds, by place and sort; None where nothing was said.
        then: The deeds after a deed, by its act and sort; None where it was the last.
    """

    egos: list[Ego] = field(default_factory=list[Ego])
    numbers: list[int] = field(default_factory=list[int])
    who: list[Other] = field(default_factory=list[Other])
    first: dict[tuple[Where, Sort], list[Deed | None]] = field(default_factory=lambda: defaultdict(list))
    then: dict[tuple[Act, Sort], list[Deed | None]] = field(default_factory=lambda: defaultdict(list))


@cache
def parts(files: tuple[str, ...] = FILES) -> Parts:
    """The parts of all recorded replies of some files."""
    made = Parts()
    for one in recorded(files):
        made.egos.append(Ego(route=one.ego.route, speed=one.ego.speed))
        made.numbers.append(min(len(one.others), MOST))
        for other in one.others:
            sort = sort_of(other)
            made.who.append(replace(other, does=(), hidden_by=None, count=1))
            deeds = [replace(deed, when=None, whom=None) for deed in other.does]
            made.first[other.starts.where, sort].append(deeds[0] if deeds else None)
            for deed, after in pairwise((*deeds, None)):
                if deed is not None:
                    made.then[deed.act, sort].append(after)
    return made


def sort_of(one: Other) -> Sort:
    """The sort of somebody."""
    return one.kind.moves, one.kind.row.body.row.motorised


def recorded(files: tuple[str, ...] = FILES) -> Iterator[Situation]:
    """The situations of all recorded replies of some files, the last of each text."""
    for name in files:
        for line in (READING / name).read_text(encoding="utf-8").splitlines():
            reply = json.loads(line)["replies"][-1]
            try:
                yield situation_in(reply.get("situation"))
            except (Malformed, AttributeError):
                continue


def drawn_as_said(rng: random.Random, files: tuple[str, ...] = FILES) -> Situation:
    """A situation at random, of parts that were said in the texts of some files."""
    made = parts(files)
    others = tuple(_somebody(rng, made, name) for name in "ABC"[: rng.choice(made.numbers)])
    return Situation(ego=rng.choice(made.egos), others=others)


def _somebody(rng: random.Random, made: Parts, name: str) -> Other:
    who = rng.choice(made.who)
    sort, deeds = sort_of(who), list[Deed]()
    deed = rng.choice(made.first[who.starts.where, sort])
    while deed is not None and len(deeds) < MOST:
        deeds.append(deed)
        deed = rng.choice(made.then[deed.act, sort])
    starts = replace(who.starts, speed=None) if deeds and deeds[0].act in FROM_A_STAND else who.starts
    return replace(
        who, id=name, starts=starts, role=Role.ADVERSARY if name == "A" else Role.SUPPORTING, does=tuple(deeds)
    )
