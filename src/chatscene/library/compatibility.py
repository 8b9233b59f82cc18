"""Which snippets can be joined: every name provided, parameters apart, a common kind of adversary, no contradiction."""

from __future__ import annotations

import re
from collections.abc import Callable, Hashable, Iterable, Sequence
from dataclasses import dataclass
from functools import cached_property, lru_cache
from typing import TypeVar

import numpy as np
from numpy.typing import NDArray

from chatscene.library.load import Library
from chatscene.terms.actors import AdversaryKind
from chatscene.terms.scenario import Component, Maneuver, Place, Slots, includes
from chatscene.terms.slots import SLOTS
from chatscene.terms.snippet import Snippet

HEADER_PROVIDES = ("AdvClass", "ego")  # what a program's fixed part defines
STILL = "advStill"  # told by a behavior of somebody who stands in the ego's lane, and needs no way along it
ASIDE = "advAside"  # told by a behavior of somebody who stands at an edge of the ego's lane
WAYS = {"advTrajectory", "advLane", "advKerb"}  # along the road, as spawns give them to adversaries that drive
# Where others come from at a junction, as geometries name it, with what shows that there is an arm to go straight on
# into and that the ego's way lies between: traffic out of that arm, or an ego that turns that way.
ARMS = {
    "trafficFromLeft": ("trafficFromRight", Maneuver.RIGHT_TURN),
    "trafficFromRight": ("trafficFromLeft", Maneuver.LEFT_TURN),
    "oncomingTraffic": (None, Maneuver.LEFT_TURN),
}
_SHARED = tuple(name for name, row in SLOTS.items() if row.shared)
Mask = NDArray[np.bool_]
Numbers = NDArray[np.intp]


def agree(one: object, other: object) -> bool:
    """Whether two values of a slot can both hold; an unfilled one agrees with anything."""
    if one is None or other is None or one == other:
        return True
    if isinstance(one, Place) and isinstance(other, Place):
        return includes(one, other) or includes(other, one)
    return False


def contradiction(one: Slots, other: Slots) -> str | None:
    """The first slot on which two sets of facts disagree, in words."""
    for slot in _SHARED:
        a, b = getattr(one, slot), getattr(other, slot)
        if not agree(a, b):
            return f"{slot}: {a} against {b}"
    return None


def _follows(behavior: Snippet, spawn: Snippet) -> bool:
    """Whether a behavior uses a way along the road that a spawn gives its adversary, if it gives one.

    Who is to stand aside needs a spawn that puts it there.
    """
    if ASIDE in behavior.provides and ASIDE not in spawn.requires:
        return False
    goes = STILL not in behavior.provides
    return not (goes and WAYS & set(spawn.provides)) or bool(WAYS & set(behavior.requires))


def _has_cause(geometry: Snippet, spawn: Snippet) -> bool:
    """Whether an ego that goes round something finds something to go round."""
    return geometry.slots.maneuver is not Maneuver.BYPASS or spawn.slots.blocker is True


def ways_of(behavior: Snippet) -> tuple[str, ...]:
    """The turns, best first, that a behavior's adversary may do at a junction; empty if it needs no way through one."""
    said = re.search(r"^advTurn\s*=(.*)$", behavior.source, re.MULTILINE)
    return tuple(re.findall(r"""["']([a-z-]+)["']""", said[1])) if said else ()


def _only_straight(behavior: Snippet) -> bool:
    return ways_of(behavior) == (Maneuver.STRAIGHT.value,)


def _goes_on(geometry: Snippet, spawn: Snippet) -> bool:
    """Whether who starts there can go straight on across the ego's way, on every route that the geometry has."""
    return all(
        opposite in geometry.provides or geometry.slots.maneuver is turn
        for arm, (opposite, turn) in ARMS.items()
        if arm in spawn.requires
    )


def incompatibility(behavior: Snippet, geometry: Snippet, spawn: Snippet) -> str | None:
    """Why three snippets cannot be joined, in words; None if they can."""
    triple = (behavior, geometry, spawn)
    for part in triple:
        others = {name for other in triple if other is not part for name in other.provides}
        missing = sorted(set(part.requires) - others - set(HEADER_PROVIDES))
        if missing:
            return f"{part.id} needs {', '.join(missing)}, which no partner provides"
    for one, other in ((behavior, geometry), (behavior, spawn), (geometry, spawn)):
        shared = {p.name for p in one.parameters} & {p.name for p in other.parameters}
        if shared:
            return f"{one.id} and {other.id} both tune {', '.join(sorted(shared))}"
        if (words := contradiction(one.slots, other.slots)) is not None:
            return f"{one.id} and {other.id} contradict each other in {words}"
    return _mismatch(behavior, geometry, spawn)


def _mismatch(behavior: Snippet, geometry: Snippet, spawn: Snippet) -> str | None:
    """Why three snippets make no sense together though their names and facts agree."""
    if not _has_cause(geometry, spawn):
        return f"{geometry.id} goes round something in the ego's lane, and {spawn.id} puts nothing there"
    if not _follows(behavior, spawn):
        return f"{behavior.id} is for somebody beside the road, {spawn.id} puts the adversary on it"
    if _only_straight(behavior) and not _goes_on(geometry, spawn):
        return f"{behavior.id} goes straight on, and at {geometry.id} nobody from {spawn.id} can across the ego's way"
    if not set(behavior.adversaries) & set(spawn.adversaries):
        return f"{behavior.id} and {spawn.id} have no kind of adversary in common"
    return None


@dataclass(frozen=True, eq=False)
class Compatibility:
    """What the snippets of a library can be joined with.

    Snippets of one *sort* can be joined with the same ones. What fits a sort of behaviors is worked out when it is
    asked for: all triples of 10,000 snippets would be some 30 billion.

    Attributes:
        sorts: Of each behavior, geometry and spawn the number of its sort.
    """

    behaviors: tuple[Snippet, ...]
    geometries: tuple[Snippet, ...]
    spawns: tuple[Snippet, ...]
    sorts: tuple[Numbers, Numbers, Numbers]
    _fit: tuple[Mask, Mask, Mask]  # (b, g), (b, s) and (g, s), sorts each: whether nothing speaks against the two
    _goes_on: Mask  # (g, s): whether who starts there can go straight on …
    _straight: Mask  # (b,): … and who does
    _names: tuple[_Names, _Names, _Names]

    def partners(self, sort: int) -> Mask:
        """The sorts of geometries and spawns, (g, s), that a sort of behaviors can be joined with."""
        geometries, spawns, both = self._fit
        behavior, geometry, spawn = self._names
        found = geometries[sort][:, None] & spawns[sort] & both
        if self._straight[sort]:
            found &= self._goes_on
        for name in np.flatnonzero(behavior.required[sort]):
            found &= geometry.provided[:, name][:, None] | spawn.provided[:, name]
        lacking = self._lacking.copy()
        for name in np.flatnonzero(behavior.provided[sort]):
            lacking -= np.outer(geometry.required[:, name], ~spawn.provided[:, name])
            lacking -= np.outer(~geometry.provided[:, name], spawn.required[:, name])
        return found & (lacking == 0)

    @cached_property
    def _lacking(self) -> NDArray[np.int16]:
        """How many names, (g, s), geometries and spawns require and do not find with each other."""
        (_, geometry, spawn), count = self._names, np.int16
        return geometry.required.astype(count) @ ~spawn.provided.T + ~geometry.provided @ spawn.required.T.astype(count)

    def places(self, behavior: int) -> Mask:
        """(G, S): the geometries and spawns that a behavior can be joined with."""
        b, g, s = self.sorts
        return self.partners(int(b[behavior]))[np.ix_(g, s)]

    @cached_property
    def mask(self) -> Mask:
        """(B, G, S): every triple, True where it can be joined; some MB for hundreds of snippets."""
        b, g, s = self.sorts
        sorts = [self.partners(sort) for sort in range(len(self._straight))]
        return np.array(sorts, bool).reshape(len(sorts), *self._goes_on.shape)[np.ix_(b, g, s)]

    def able(self, kind: AdversaryKind | None) -> tuple[Mask, Mask, Mask]:
        """(B,), (G,) and (S,): the parts whose adversary can be of a kind; all of them for None."""
        acts = np.array([kind is None or kind.acts_as in s.adversaries for s in self.behaviors], bool)
        fits = np.array([kind is None or kind.acts_as in s.adversaries for s in self.spawns], bool)
        return acts, np.ones(len(self.geometries), bool), fits

    def of_kind(self, kind: AdversaryKind | None) -> Mask:
        """(B, G, S): triples whose adversary can be of a kind; all of them for None."""
        acts, _, fits = self.able(kind)
        return self.mask & acts[:, None, None] & fits[None, None, :]


@lru_cache(maxsize=4)
def compatibility(library: Library) -> Compatibility:
    """Work out which snippets of a library can be joined."""
    behaviors, geometries, spawns = (library.of(component) for component in Component)
    (b, of_b), (g, of_g), (s, of_s) = (_sorted(shelf) for shelf in (behaviors, geometries, spawns))
    follows = _pairs(b, s, lambda x: (x.adversaries, x.requires, x.provides), _goes_with)
    caused = _pairs(g, s, lambda x: (x.slots.maneuver, x.slots.blocker), _has_cause)
    goes_on = _pairs(g, s, lambda x: (x.requires, x.provides, x.slots.maneuver), _goes_on)
    straight = np.array([_only_straight(x) for x in b], bool)
    fit = _agreeing(b, g), _agreeing(b, s) & follows, _agreeing(g, s) & caused
    wanted = sorted({name for x in (*b, *g, *s) for name in x.requires}.difference(HEADER_PROVIDES))
    names = _names_of(b, wanted), _names_of(g, wanted), _names_of(s, wanted)
    return Compatibility(behaviors, geometries, spawns, (of_b, of_g, of_s), fit, goes_on, straight, names)


_One = TypeVar("_One", bound=Hashable)


def _different(each: Iterable[_One]) -> tuple[list[_One], list[int]]:
    """The different ones, and which of them each is."""
    numbers: dict[_One, int] = {}
    places = [numbers.setdefault(one, len(numbers)) for one in each]
    return list(numbers), places


def _sorted(snippets: Sequence[Snippet]) -> tuple[list[Snippet], Numbers]:
    """The first snippet of each sort, and the sort of each snippet: all that decides what it can be joined with."""
    told, sorts = _different(
        (x.adversaries, x.requires, x.provides, _tuned(x), _facts(x.slots), ways_of(x)) for x in snippets
    )
    first = dict(zip(reversed(sorts), reversed(snippets), strict=True))
    return [first[sort] for sort in range(len(told))], np.array(sorts, np.intp)


def _facts(slots: Slots) -> tuple[object, ...]:
    return tuple(getattr(slots, slot) for slot in _SHARED)


def _tuned(snippet: Snippet) -> frozenset[str]:
    return frozenset(p.name for p in snippet.parameters)


@dataclass(frozen=True, slots=True)
class _Names:
    """Which of the names that somebody requires, (N, names), snippets require and provide."""

    required: Mask
    provided: Mask


def _names_of(snippets: Sequence[Snippet], wanted: Sequence[str]) -> _Names:
    shape = len(snippets), len(wanted)
    required = np.array([[name in x.requires for name in wanted] for x in snippets], bool).reshape(shape)
    provided = np.array([[name in x.provides for name in wanted] for x in snippets], bool).reshape(shape)
    return _Names(required, provided)


def _pairs(
    ones: Sequence[Snippet],
    others: Sequence[Snippet],
    told: Callable[[Snippet], Hashable],
    holds: Callable[[Snippet, Snippet], bool],
) -> Mask:
    """(N, M) what holds of each two snippets, worked out once for all of which the same is told."""
    (a, i), (b, j) = (_different(told(x) for x in snippets) for snippets in (ones, others))
    first, second = ({told(x): x for x in snippets} for snippets in (ones, others))
    return _spread([[holds(first[x], second[y]) for y in b] for x in a], i, j)


def _agreeing(ones: Sequence[Snippet], others: Sequence[Snippet]) -> Mask:
    """(N, M) whether two parts tune different parameters and do not contradict each other."""
    (a, i), (b, j) = _different(map(_tuned, ones)), _different(map(_tuned, others))
    fit = _spread([[not x & y for y in b] for x in a], i, j)
    for slot in _SHARED:
        (a, i), (b, j) = (_different(getattr(x.slots, slot) for x in snippets) for snippets in (ones, others))
        fit &= _spread([[agree(x, y) for y in b] for x in a], i, j)
    return fit


def _spread(table: list[list[bool]], rows: Sequence[int], columns: Sequence[int]) -> Mask:
    """(N, M) what a table of different ones says of all."""
    small = np.array(table, bool).reshape(len(table), max(columns, default=-1) + 1)
    return small[np.ix_(np.array(rows, np.intp), np.array(columns, np.intp))]


def _goes_with(behavior: Snippet, spawn: Snippet) -> bool:
    """Whether a behavior is for a spawn's adversary and for where that starts."""
    return bool(set(behavior.adversaries) & set(spawn.adversaries)) and _follows(behavior, spawn)
