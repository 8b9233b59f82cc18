"""Step 1 of 9: a base scenario, or an instruction in words, to descriptions of distinct scenarios.

Paper: section 3.3, step i. The reference asks a language model for sentences and hopes that the library serves them;
here each sentence is written about a triple of snippets that can be joined, so that every one of them can be served.
"""

from __future__ import annotations

import random
import re
from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass, field, fields, replace
from functools import lru_cache
from itertools import islice, pairwise

import numpy as np
from numpy.typing import NDArray

from chatscene.errors import NothingFits, SettingsError
from chatscene.interpret.asked import scenario_of
from chatscene.interpret.readers import reader_of
from chatscene.interpret.situation_of import in_a_situation
from chatscene.interpret.slots_of import facts_of, parties_of
from chatscene.library.bind import does
from chatscene.library.compatibility import Compatibility, agree, compatibility
from chatscene.library.load import Library
from chatscene.models.encoders.embedding import Embedder
from chatscene.read.reader import in_one_line
from chatscene.settings import RetrievalSettings
from chatscene.situations.phrases import Voice
from chatscene.situations.words import told
from chatscene.terms.actors import AdversaryKind
from chatscene.terms.acts import Action
from chatscene.terms.conclusions import base_of, concluded
from chatscene.terms.description import Description, Diversity
from chatscene.terms.scenario import BaseScenario, Maneuver, Place, Position, Slots, includes
from chatscene.terms.situation import Situation
from chatscene.terms.snippet import Snippet
from chatscene.terms.surroundings import Surroundings

TRIES = 2  # tellings of one triple before it is given up
GIVE_UP = 200  # triples in a row of which nothing could be said
VOICES = (Voice.PLAIN, Voice.PLAIN, Voice.PROTOCOL)
ASIDES = ("lanes", "two_way", "distance")  # facts that a sentence need not be burdened with …
BURDEN = 0.5  # … and the chance that it is
# What it costs a triple that its behavior, geometry, spawn, kind or side was used before
WEIGHTS = np.array((4.0, 1.5, 1.5, 1.5, 1.0))
NO_LUCK = 0.5  # of such a use, for a triple of which nothing could be said

Rows = NDArray[np.int64]
_KINDS = tuple(AdversaryKind)
_VEHICLES = frozenset(kind for kind in AdversaryKind if kind.row.motorised)


def describe(
    base: BaseScenario | None, n: int, *, library: Library, seed: int, instruction: str = ""
) -> tuple[Description, ...]:
    """Make up scenarios, as different from each other as the library allows.

    Raises:
        NothingFits: The library has no such scenario, or nothing in the instruction was understood.
    """
    return tuple(islice(described(base, library=library, seed=seed, instruction=instruction), n))


def described(
    base: BaseScenario | None, *, library: Library, seed: int, instruction: str = ""
) -> Iterator[Description]:
    """The scenarios of `describe`, one after the other, each made up when it is asked for.

    Raises:
        NothingFits: As `describe`.
    """
    wanted = _wanted(instruction)
    pool = _Pool(library, base, wanted, seed)
    if not len(pool.rows):
        about = f"the base scenario {base}" if base else "any base scenario"
        raise NothingFits(
            f"no triple of the library is of {about} and of what the instruction {instruction!r} asks for; "
            "ask for less at once"
        )
    rng = random.Random(f"{seed}/{base}/{instruction}")
    texts: set[str] = set()
    failed = 0
    while failed < GIVE_UP and (row := pool.draw()) is not None:
        one = _said(pool.triple(row), _KINDS[pool.rows[row, 3]], rng)
        told = one is not None and one.text not in texts
        pool.use(row, 1.0 if told else NO_LUCK)
        failed = 0 if told else failed + 1
        if told and one is not None:
            texts.add(one.text)
            yield one


def varied(base: BaseScenario, n: int, *, library: Library, seed: int) -> tuple[tuple[Snippet, ...], ...]:
    """Triples of a base scenario that are as different from each other as the library allows; at most so many."""
    pool = _Pool(library, base, _Wanted(), seed)
    rows: list[int] = []
    while len(rows) < n and len(pool.rows) and (row := pool.draw()) is not None:
        rows.append(row)
        pool.use(row, 1.0)
    return tuple(pool.triple(row) for row in rows)


# What is asked for


@dataclass(frozen=True, slots=True, kw_only=True)
class _Wanted:
    """What an instruction asks for; empty means anything."""

    kinds: frozenset[AdversaryKind] = frozenset()
    slots: Slots = field(default_factory=Slots)


def _wanted(instruction: str) -> _Wanted:
    """Read an instruction as a text: what it says of the adversary, the ego and the road.

    Where somebody starts is not asked for, since a reader always sees somebody somewhere; nor is an act or a number of
    road users that is said by the noun alone: "cyclists" means each of them, whatever they do.
    """
    if not instruction.strip():
        return _Wanted()
    try:
        found = reader_of(RetrievalSettings()).read(in_one_line(instruction)).ranked
    except SettingsError as error:
        raise NothingFits(f"the instruction cannot be read: {error}") from error
    read = found[0].situation if found else Situation()
    if (parties := parties_of(read)) is None:
        raise NothingFits(
            f"nothing in the instruction {instruction!r} is known; name who (cyclists), where (junctions), "
            "from which side, or what they do (cut in)"
        )
    who, quoted = parties.adversary, read.evidence.quoted
    noun = quoted.get(f"others.{who.id}.kind")
    said = replace(
        who,
        count=1 if quoted.get(f"others.{who.id}.count") == noun else who.count,
        does=tuple(deed for i, deed in enumerate(who.does) if quoted.get(f"others.{who.id}.does.{i}.act") != noun),
    )
    slots = facts_of(read, replace(parties, adversary=said)).slots
    return _Wanted(
        kinds=_VEHICLES if who.kind.row.general else frozenset((who.kind.row.body.heard_as,)),
        slots=replace(slots, adversary=None, position=None, ego=None, site=None, others=()),
    )


def _does(wanted: object, does: object) -> bool:
    """Whether a fact of a snippet is what is asked for, or a kind of it."""
    if isinstance(wanted, Place) and isinstance(does, Place):
        return includes(wanted, does)
    if isinstance(wanted, tuple) and isinstance(does, tuple):
        return set(wanted) <= set(does)
    return wanted == does


# The triples


class _Pool:
    """The triples that can be described, and how often their parts were used.

    Attributes:
        rows: (N, 5) index of behavior, geometry, spawn, kind and side of every triple.
    """

    def __init__(self, library: Library, base: BaseScenario | None, wanted: _Wanted, seed: int) -> None:
        self.joint = joint = compatibility(library.without_sites())
        rows = _rows(library)
        rows = rows[_of_base(joint, rows, base)]
        bypass = _having(joint, rows, lambda s: s.slots.maneuver is Maneuver.BYPASS)
        rows = rows[~bypass | _having(joint, rows, lambda s: s.slots.blocker is True)]  # what it goes around
        if wanted.kinds:
            rows = rows[np.isin(rows[:, 3], [_KINDS.index(kind) for kind in wanted.kinds])]
        else:
            rows = rows[np.isin(rows[:, 3], [k for k, kind in enumerate(_KINDS) if kind.acts_as is kind])]
        for slot, value in wanted.slots.said().items():
            rows = rows[_having(joint, rows, lambda s, slot=slot, value=value: _does(value, getattr(s.slots, slot)))]
        self.rows = rows
        self.used = [np.zeros(int(size) + 1) for size in (rows.max(axis=0) if len(rows) else np.zeros(5, np.int64))]
        # Chance decides between equals; less than any use costs, so that it decides nothing else.
        self.taken = np.random.default_rng(seed).random(len(rows)) * 0.5

    def triple(self, row: int) -> tuple[Snippet, Snippet, Snippet]:
        b, g, s = (int(i) for i in self.rows[row, :3])
        return self.joint.behaviors[b], self.joint.geometries[g], self.joint.spawns[s]

    def draw(self) -> int | None:
        """The triple whose parts were used least; None if there are no more."""
        axes = zip(self.rows.T, WEIGHTS, self.used, strict=True)
        cost = self.taken + sum(weight * used[index] for index, weight, used in axes)
        row = int(np.argmin(cost))
        return row if np.isfinite(cost[row]) else None

    def use(self, row: int, share: float) -> None:
        """Take a triple out, and remember its parts."""
        self.taken[row] = np.inf
        for axis, used in enumerate(self.used):
            used[self.rows[row, axis]] += share


@lru_cache(maxsize=4)
def _rows(library: Library) -> Rows:
    """Every triple with every kind of adversary that can act it."""
    joint = compatibility(library.without_sites())
    sides = [("left", "right", None).index(s.slots.side) for s in joint.spawns]
    found: list[Rows] = []
    for k, kind in enumerate(_KINDS):
        at = np.argwhere(joint.of_kind(kind))
        side = np.array([sides[s] for s in at[:, 2]], dtype=np.int64)
        found.append(np.column_stack((at, np.full(len(at), k), side)).astype(np.int64))
    return np.concatenate(found)


def _of_base(joint: Compatibility, rows: Rows, base: BaseScenario | None) -> NDArray[np.bool_]:
    """Which triples belong to a base scenario; it hangs on the kind, the geometry and whether a light is run."""
    table = np.zeros((len(_KINDS), 2, len(joint.geometries)), bool)
    for k, kind in enumerate(_KINDS):
        for g, geometry in enumerate(joint.geometries):
            for runs in (0, 1):
                actions = (Action.RUN_LIGHT,) if runs else ()
                found = base_of(replace(geometry.slots, adversary=kind, actions=actions))
                table[k, runs, g] = found is not None and base in (None, found)
    runs = np.array([Action.RUN_LIGHT in b.slots.actions for b in joint.behaviors], dtype=np.int64)
    return table[rows[:, 3], runs[rows[:, 0]], rows[:, 1]]


def _having(joint: Compatibility, rows: Rows, has: Callable[[Snippet], bool]) -> NDArray[np.bool_]:
    """Which triples have a part of which something holds."""
    parts = (joint.behaviors, joint.geometries, joint.spawns)
    marks = [np.array([has(snippet) for snippet in part])[rows[:, axis]] for axis, part in enumerate(parts)]
    return marks[0] | marks[1] | marks[2]


def joined(triple: Sequence[Snippet], kind: AdversaryKind) -> Slots:
    """Everything that a compatible triple does, as facts, with what follows from them."""
    return concluded(does(triple, kind))


# The sentences


def _said(triple: tuple[Snippet, Snippet, Snippet], kind: AdversaryKind, rng: random.Random) -> Description | None:
    """A sentence about a triple that is read as it is meant; None if none was found."""
    slots = joined(triple, kind)
    if (base := base_of(slots)) is None:
        return None
    for _ in range(TRIES):
        spoken = replace(slots, **{name: None for name in ASIDES if rng.random() >= BURDEN})
        text = told(in_a_situation(spoken, (), Surroundings()), rng.choice(VOICES))
        heard = scenario_of(text, RetrievalSettings(reading=1))  # the likeliest, and no other is asked for
        if heard.base is base and misread(heard.slots, slots) is None:
            ids = (triple[0].id, triple[1].id, triple[2].id)
            return Description(text=text, base=base, adversary=kind, snippet_ids=ids, slots=slots)
    return None


def misread(heard: Slots, meant: Slots) -> str | None:
    """The first fact that was read and was not meant, in words; None if what was read is true."""
    if heard.adversary is not meant.adversary:
        return f"adversary: {heard.adversary} for {meant.adversary}"
    besides = {Action.FOLLOW} | ({Action.ONCOMING} if meant.position is Position.ONCOMING else set())
    if not set(heard.actions) & set(meant.actions) or set(heard.actions) - set(meant.actions) - besides:
        return f"actions: {', '.join(heard.actions) or 'none'} for {', '.join(meant.actions)}"
    for f in fields(Slots):
        here, there = getattr(heard, f.name), getattr(meant, f.name)
        added = here is not None and there is None and f.name != "position"
        if f.name not in ("adversary", "actions") and (added or not agree(here, there)):
            return f"{f.name}: {here} for {there}"
    return None


def diversity(descriptions: Sequence[Description], embedder: Embedder) -> Diversity:
    """How different descriptions are from each other; at least two of them."""
    pairs = [pair for d in descriptions for pair in _pairs(d.text)]
    rows = embedder.encode([d.text for d in descriptions])
    above = np.triu_indices(len(rows), k=1)
    return Diversity(
        behaviors=len({d.snippet_ids[0] for d in descriptions}),
        geometries=len({d.snippet_ids[1] for d in descriptions}),
        spawns=len({d.snippet_ids[2] for d in descriptions}),
        kinds=len({d.adversary for d in descriptions}),
        distinct_2=len(set(pairs)) / max(len(pairs), 1),
        distance=float(1.0 - (rows @ rows.T)[above].mean()),
    )


def _pairs(text: str) -> list[tuple[str, str]]:
    words = re.findall(r"[a-z0-9'-]+", text.lower())
    return list(pairwise(words))
