"""Snippets that do the same: measured on tracks, not on texts.

Two behaviors are twins if, with the same partners and every parameter at the same place of its range, the adversary
is never more than a metre apart; two spawns if everybody starts within a metre; two geometries if the ego drives the
same routes and they offer the same names.
"""

from __future__ import annotations

from collections.abc import Collection, Iterator, Sequence
from itertools import combinations

import numpy as np

from chatscene.ego.policy import EgoPolicy
from chatscene.errors import ChatSceneError
from chatscene.program.assemble import assemble
from chatscene.simulate.backend import Backend
from chatscene.snippets.compatibility import Compatibility, Mask, compatibility
from chatscene.snippets.library import Library
from chatscene.terms.episode import Array, Episode
from chatscene.terms.scenario import AdversaryKind, Scenario, Slots, SubDescriptions
from chatscene.terms.scene import Scene, ScenicProgram
from chatscene.terms.snippet import Snippet

Triple = tuple[Snippet, Snippet, Snippet]

APART = 1.0  # [m] that a person sees
SHARES = (0.5, 0.2, 0.8)  # where in every range the scenes lie


def twins(
    library: Library, backend: Backend, ego: EgoPolicy, only: Collection[str] | None = None
) -> Iterator[tuple[str, str, str]]:
    """Pairs of snippets that do the same, and how that was seen.

    Args:
        library: The snippets, and the partners they are seen with.
        backend: Where to run them.
        ego: Who drives.
        only: Ids of which one must be in a pair; None for all pairs.
    """
    joint = compatibility(library)
    seen = _Seen(joint, backend, ego)
    for one, other in _pairs(joint.behaviors, only):
        place = _first(joint.mask[one] & joint.mask[other])
        if place is not None and seen.same_tracks(one, other, place):
            yield joint.behaviors[one].id, joint.behaviors[other].id, "the adversary's tracks are the same"
    for one, other in _pairs(joint.spawns, only):
        place = _first(joint.mask[:, :, one] & joint.mask[:, :, other])
        if place is not None and seen.same_starts(one, other, place):
            yield joint.spawns[one].id, joint.spawns[other].id, "everybody starts in the same place"
    for one, other in _pairs(joint.geometries, only):
        place = _first(joint.mask[:, one] & joint.mask[:, other])
        alike = joint.geometries[one].provides == joint.geometries[other].provides
        if place is not None and alike and seen.same_routes(one, other, place):
            yield joint.geometries[one].id, joint.geometries[other].id, "the ego's routes are the same"


def _pairs(snippets: Sequence[Snippet], only: Collection[str] | None) -> Iterator[tuple[int, int]]:
    for i, j in combinations(range(len(snippets)), 2):
        wanted = only is None or snippets[i].id in only or snippets[j].id in only
        if wanted and not _deliberate(snippets[i], snippets[j]):
            yield i, j


def _deliberate(one: Snippet, other: Snippet) -> bool:
    """Whether two snippets are told apart by what tracks do not show.

    One is for a side and the other for whichever side there is; or one reads the lights and the other does not.
    """
    sides = (one.slots.side, other.slots.side)
    lights = ["crossSignal" in snippet.requires for snippet in (one, other)]
    return (None in sides and sides != (None, None)) or lights[0] != lights[1]


def _first(mask: Mask) -> tuple[int, int] | None:
    found = np.argwhere(mask)
    return (int(found[0][0]), int(found[0][1])) if len(found) else None


class _Seen:
    """Episodes that were run, each once."""

    def __init__(self, joint: Compatibility, backend: Backend, ego: EgoPolicy) -> None:
        self._joint = joint
        self._backend = backend
        self._ego = ego
        self._episodes: dict[tuple[int, int, int, AdversaryKind], list[Episode | None]] = {}

    def same_tracks(self, i: int, j: int, place: tuple[int, int]) -> bool:
        kind = self._common((i, j), place[1])
        return kind is not None and self._same(
            [self._tracks(self._run((b, *place), kind), start=False) for b in (i, j)]
        )

    def same_starts(self, i: int, j: int, place: tuple[int, int]) -> bool:
        behavior = self._joint.behaviors[place[0]]
        shared = [k for k in behavior.adversaries if all(k in self._joint.spawns[s].adversaries for s in (i, j))]
        return bool(shared) and self._same(
            [self._tracks(self._run((*place, s), shared[0]), start=True) for s in (i, j)]
        )

    def same_routes(self, i: int, j: int, place: tuple[int, int]) -> bool:
        lines = [self._lines((place[0], g, place[1])) for g in (i, j)]
        return len(lines[0]) == len(lines[1]) and all(
            a.shape == b.shape and np.allclose(a, b, atol=0.01) for a, b in zip(*lines, strict=True)
        )

    def _common(self, behaviors: tuple[int, int], spawn: int) -> AdversaryKind | None:
        fits = self._joint.spawns[spawn].adversaries
        one, other = (self._joint.behaviors[b].adversaries for b in behaviors)
        return next((kind for kind in one if kind in other and kind in fits), None)

    def _lines(self, index: tuple[int, int, int]) -> list[Array]:
        program = self._program(index, self._kinds(index)[0])
        return [self._backend.route(program, n).line.points for n in range(self._backend.routes(program))]

    def _kinds(self, index: tuple[int, int, int]) -> list[AdversaryKind]:
        fits = self._joint.spawns[index[2]].adversaries
        return [kind for kind in self._joint.behaviors[index[0]].adversaries if kind in fits]

    def _program(self, index: tuple[int, int, int], kind: AdversaryKind) -> ScenicProgram:
        b, g, s = index
        triple = (self._joint.behaviors[b], self._joint.geometries[g], self._joint.spawns[s])
        return assemble(scenario_of(triple), triple, kind)

    def _run(self, index: tuple[int, int, int], kind: AdversaryKind) -> list[Episode | None]:
        key = (*index, kind)
        if key not in self._episodes:
            try:
                program = self._program(index, kind)
                found = [self._backend.run(program, s, self._ego, through_collisions=True) for s in _scenes(program)]
            except ChatSceneError:  # the other rungs say so
                found = []
            self._episodes[key] = [outcome if isinstance(outcome, Episode) else None for outcome in found]
        return self._episodes[key]

    @staticmethod
    def _tracks(episodes: list[Episode | None], *, start: bool) -> list[Array | None]:
        """Per scene (actors, steps, 2) positions [m]: of the adversary, or of everybody in the first step."""
        out: list[Array | None] = []
        for episode in episodes:
            if episode is None:
                out.append(None)
                continue
            tracks = episode.tracks[1:] if start else episode.adversaries[:1]
            steps = 1 if start else len(tracks[0].x)
            kinds = [float(sum(map(ord, t.kind))) for t in tracks]  # another thing in the same place is another scene
            moved = np.array([np.column_stack((t.x[:steps], t.y[:steps])) for t in tracks])
            out.append(moved + (np.array(kinds)[:, None, None] if start else 0.0))
        return out

    @staticmethod
    def _same(both: list[list[Array | None]]) -> bool:
        compared = 0
        for one, other in zip(*both, strict=False):
            if one is None or other is None or len(one) != len(other):
                return False
            steps = min(one.shape[1], other.shape[1])
            if float(np.hypot(*(one[:, :steps] - other[:, :steps]).reshape(-1, 2).T).max()) > APART:
                return False
            compared += 1
        return compared > 0


def _scenes(program: ScenicProgram) -> list[Scene]:
    return [
        Scene(
            id=f"{program.scenario_id}/route-00/twin-{i}",
            scenario_id=program.scenario_id,
            route=0,
            block=-1,
            seed=0,
            values={p.name: round(p.low + share * (p.high - p.low), 6) for p in program.parameters},
        )
        for i, share in enumerate(SHARES)
    ]


def scenario_of(triple: Triple) -> Scenario:
    """A scenario that says what the parts of a triple say of themselves."""
    behavior, geometry, spawn = (part.description for part in triple)
    return Scenario(
        id="+".join(part.id for part in triple),
        text=f"{geometry} {spawn} {behavior}",
        base=None,
        parts=SubDescriptions(behavior=behavior, geometry=geometry, spawn=spawn),
        slots=Slots(),
    )
