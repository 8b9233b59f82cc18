"""Which snippets can be joined: every name provided, parameters apart, a common kind of adversary, no contradiction."""

from __future__ import annotations

import re
from collections.abc import Callable, Hashable, Iterable, Sequence
from dataclasses import dataclass
from functools import lru_cache
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


@dataclass(frozen=True, slots=True)
class Compatibility:
    """All triples of a library at once.

    Attributes:
        behaviors: In the order of axis 0.
        geometries: In the order of axis 1.
        spawns: In the order of axis 2.
        mask: (B, G, S), True where a triple can be joined.
    """

    behaviors: tuple[Snippet, ...]
    geometries: tuple[Snippet, ...]
    spawns: tuple[Snippet, ...]
    mask: Mask

    def able(self, kind: AdversaryKind | None) -> tuple[Mask, Mask, Mask]:
        """(B,), (G,) and (S,): the parts whose adversary can be of a kind; all of them for None."""
        acts = np.array([kind is None or kind.acts_as in s.adversaries for s in self.behaviors], bool)
        fits = np.array([kind is None or kind.acts_as in s.adversaries for s in self.spawns], bool)
        return acts, np.ones(len(self.geometries), bool), fits

    def of_kind(self, kind: AdversaryKind | None) -> Mask:
        """(B, G, S): triples whose adversary can be of a kind; all of them for None."""
        acts, _, fits = self.able(kind)
        return self.mask & acts[:, None, None] & fits[None, None, :]

    def with_all(self, ids: Sequence[str]) -> Mask:
        """(B, G, S): triples that have all of some snippets."""
        axes = (self.behaviors, self.geometries, self.spawns)
        b, g, s = (np.array([part.id in ids for part in axis], np.intp) for axis in axes)
        return b[:, None, None] + g[:, None] + s == len(ids)


@lru_cache(maxsize=4)
def compatibility(library: Library) -> Compatibility:
    """Work out every triple of a library; a few milliseconds for hundreds of snippets."""
    b, g, s = (library.of(component) for component in (Component.BEHAVIOR, Component.GEOMETRY, Component.SPAWN))
    if not (b and g and s):
        return Compatibility(b, g, s, np.zeros((len(b), len(g), len(s)), bool))
    follows = _pairs(b, s, lambda x: (x.adversaries, x.requires, x.provides), _goes_with)
    caused = _pairs(g, s, lambda x: (x.slots.maneuver, x.slots.blocker), _has_cause)
    goes_on = _pairs(g, s, lambda x: (x.requires, x.provides, x.slots.maneuver), _goes_on)
    straight = np.array([_only_straight(x) for x in b])
    pairs = _agreeing(b, g)[:, :, None] & (_agreeing(b, s) & follows)[:, None, :] & (_agreeing(g, s) & caused)[None]
    return Compatibility(b, g, s, _closed(b, g, s) & pairs & (goes_on[None] | ~straight[:, None, None]))


_One = TypeVar("_One", bound=Hashable)


def _different(each: Iterable[_One]) -> tuple[list[_One], list[int]]:
    """The different ones, and which of them each is."""
    numbers: dict[_One, int] = {}
    places = [numbers.setdefault(one, len(numbers)) for one in each]
    return list(numbers), places


def _closed(*shelves: Sequence[Snippet]) -> Mask:
    """(B, G, S): whether each part finds what it requires with the others.

    Different contracts of names are few.
    """
    wanted = frozenset(name for shelf in shelves for x in shelf for name in x.requires) - set(HEADER_PROVIDES)
    each = [_different((wanted & set(x.requires), wanted & set(x.provides)) for x in shelf) for shelf in shelves]
    missing = np.zeros([len(names) for names, _ in each], bool)
    for name in wanted:
        b, g, s = (np.array([[name in of for of in one] for one in names], bool).T for names, _ in each)
        (b_needs, b_gives), (g_needs, g_gives), (s_needs, s_gives) = b, g, s
        missing |= b_needs[:, None, None] & ~(g_gives[:, None] | s_gives)
        missing |= (g_needs[:, None] & ~s_gives) & ~b_gives[:, None, None]
        missing |= (~g_gives[:, None] & s_needs) & ~b_gives[:, None, None]
    return ~missing[np.ix_(*(places for _, places in each))]


def _pairs(
    ones: Sequence[Snippet],
    others: Sequence[Snippet],
    told: Callable[[Snippet], Hashable],
    holds: Callable[[Snippet, Snippet], bool],
) -> Mask:
    """(N, M) what holds of each two snippets, worked out once for all of which the same is told."""
    (a, i), (b, j) = (_different(told(x) for x in snippets) for snippets in (ones, others))
    first, second = ({told(x): x for x in snippets} for snippets in (ones, others))
    return np.array([[holds(first[x], second[y]) for y in b] for x in a], bool)[np.ix_(i, j)]


def _agreeing(ones: Sequence[Snippet], others: Sequence[Snippet]) -> Mask:
    """(N, M) whether two parts tune different parameters and do not contradict each other."""
    tuned, too = ([frozenset(p.name for p in x.parameters) for x in snippets] for snippets in (ones, others))
    (a, i), (b, j) = _different(tuned), _different(too)
    fit = np.array([[not x & y for y in b] for x in a], bool)[np.ix_(i, j)]
    for slot in _SHARED:
        (a, i), (b, j) = (_different(getattr(x.slots, slot) for x in snippets) for snippets in (ones, others))
        fit &= np.array([[agree(x, y) for y in b] for x in a], bool)[np.ix_(i, j)]
    return fit


def _goes_with(behavior: Snippet, spawn: Snippet) -> bool:
    """Whether a behavior is for a spawn's adversary and for where that starts."""
    return bool(set(behavior.adversaries) & set(spawn.adversaries)) and _follows(behavior, spawn)
