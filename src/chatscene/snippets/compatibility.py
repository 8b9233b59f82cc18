"""Which snippets can be joined: every name provided, parameters apart, a common kind of adversary, no contradiction."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from functools import lru_cache
from typing import Any

import numpy as np
from numpy.typing import NDArray

from chatscene.snippets.library import Library
from chatscene.terms.scenario import AdversaryKind, Component, Place, Slots
from chatscene.terms.snippet import Snippet

HEADER_PROVIDES = ("AdvClass", "ego")  # what a program's fixed part defines
WAYS = {"advTrajectory", "advLane"}  # along the road, as spawns give them to adversaries that drive
FACTS = (
    "side",
    "position",
    "occluder",
    "maneuver",
    "place",
    "control",
    "leader",
    "blocker",
)  # slots that two parts may both speak of
JUNCTIONS = (Place.JUNCTION, Place.THREE_WAY, Place.FOUR_WAY)

Mask = NDArray[np.bool_]


def agree(slot: str, one: object, other: object) -> bool:
    """Whether two values of a slot can both hold; an unfilled one agrees with anything."""
    if one is None or other is None or one == other:
        return True
    return slot == "place" and Place.JUNCTION in (one, other) and one in JUNCTIONS and other in JUNCTIONS


def contradiction(one: Slots, other: Slots) -> str | None:
    """The first slot on which two sets of facts disagree, in words."""
    for slot in FACTS:
        a, b = getattr(one, slot), getattr(other, slot)
        if not agree(slot, a, b):
            return f"{slot}: {a} against {b}"
    return None


def _follows(behavior: Snippet, spawn: Snippet) -> bool:
    """Whether a behavior uses a way along the road that a spawn gives its adversary, if it gives one."""
    return not WAYS & set(spawn.provides) or bool(WAYS & set(behavior.requires))


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
    if not _follows(behavior, spawn):
        return f"{behavior.id} is for somebody beside the road, {spawn.id} puts the adversary on it"
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

    def of_kind(self, kind: AdversaryKind) -> Mask:
        """(B, G, S): triples whose adversary can be of a kind."""
        acts = np.array([kind in s.adversaries for s in self.behaviors])
        fits = np.array([kind in s.adversaries for s in self.spawns])
        return self.mask & acts[:, None, None] & fits[None, None, :]


@lru_cache(maxsize=4)
def compatibility(library: Library) -> Compatibility:
    """Work out every triple of a library; a few milliseconds for hundreds of snippets."""
    b, g, s = (library.of(component) for component in (Component.BEHAVIOR, Component.GEOMETRY, Component.SPAWN))
    needs = _bits(library, lambda x: set(x.requires) - set(HEADER_PROVIDES))
    gives = _bits(library, lambda x: set(x.provides))
    closed = (
        _none_missing(needs(b)[:, None, None], gives(g)[None, :, None], gives(s)[None, None, :])
        & _none_missing(needs(g)[None, :, None], gives(b)[:, None, None], gives(s)[None, None, :])
        & _none_missing(needs(s)[None, None, :], gives(b)[:, None, None], gives(g)[None, :, None])
    )
    kinds = np.array(
        [[bool(set(x.adversaries) & set(y.adversaries)) and _follows(x, y) for y in s] for x in b]
    ).reshape(len(b), len(s))
    pairs = _pairwise(b, g)[:, :, None] & (_pairwise(b, s) & kinds)[:, None, :] & _pairwise(g, s)[None, :, :]
    return Compatibility(b, g, s, closed & pairs)


def _bits(library: Library, names: Callable[[Snippet], set[str]]) -> Callable[[Sequence[Snippet]], NDArray[Any]]:
    """Sets of names as bit masks (Python integers: a library may know more than 64 names)."""
    everything = sorted({n for x in library for n in (*x.requires, *x.provides)})
    place = {name: 1 << i for i, name in enumerate(everything)}

    def encode(snippets: Sequence[Snippet]) -> NDArray[Any]:
        return np.array([sum(place[n] for n in names(x)) for x in snippets], dtype=object)

    return encode


def _none_missing(needs: NDArray[Any], first: NDArray[Any], second: NDArray[Any]) -> Mask:
    return ((needs & ~(first | second)) == 0).astype(bool)


def _pairwise(ones: Sequence[Snippet], others: Sequence[Snippet]) -> Mask:
    """Whether two parts tune different parameters and do not contradict each other."""
    names = {x.id: {p.name for p in x.parameters} for x in (*ones, *others)}
    return np.array(
        [[not names[a.id] & names[c.id] and contradiction(a.slots, c.slots) is None for c in others] for a in ones]
    ).reshape(len(ones), len(others))
