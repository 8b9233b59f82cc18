"""Snippets that do the same: measured on tracks, where their plans do not say it.

Two behaviors are twins if, with the same partners and every parameter at the same place of its range, the adversary
is never more than a metre apart; two spawns if everybody starts within a metre; two geometries if the ego drives the
same routes and they offer the same names. Behaviors with one plan need no drive to be twins, and behaviors that stop,
go, back and turn in another order need none to be no twins.
"""

from __future__ import annotations

from collections.abc import Collection, Iterator, Sequence
from dataclasses import replace
from itertools import combinations, groupby

import numpy as np

from chatscene.ego.policy import EgoPolicy
from chatscene.errors import ChatSceneError
from chatscene.library.compatibility import Compatibility, Mask, compatibility
from chatscene.library.load import Library
from chatscene.library.plan_check import STANDING
from chatscene.program.assemble import assemble
from chatscene.program.sample import scene_at
from chatscene.simulate.simulator import Simulator, simulate
from chatscene.terms.actors import AdversaryKind
from chatscene.terms.arrays import Array
from chatscene.terms.episode import Episode
from chatscene.terms.plan import Foreign, Plan
from chatscene.terms.plan_text import PARAMETERS, plan_of, print_plan
from chatscene.terms.scenario import Scenario, Slots, SubDescriptions
from chatscene.terms.scene import Scene, ScenicProgram
from chatscene.terms.snippet import Snippet

Triple = tuple[Snippet, Snippet, Snippet]

APART = 1.0  # [m] that a person sees
_MANNERS = {
    **dict.fromkeys(STANDING, "stop"),
    **dict.fromkeys(("ReverseStraight", "ReverseTurning"), "back"),
    "TurnOff": "turn",
}  # of others: go
SHARES = (0.5, 0.2, 0.8)  # where in every range the scenes lie


def twins(
    library: Library, simulator: Simulator, ego: EgoPolicy, only: Collection[str] | None = None
) -> Iterator[tuple[str, str, str]]:
    """Pairs of snippets that do the same, and how that was seen."""
    joint = compatibility(library)
    seen = _Seen(joint, simulator, ego)
    for one, other in _pairs(joint.behaviors, only):
        place = _first(joint.mask[one] & joint.mask[other])
        ids = joint.behaviors[one].id, joint.behaviors[other].id
        plans = plan_of(joint.behaviors[one]), plan_of(joint.behaviors[other])
        if place is None or not may_look_alike(*plans):
            continue
        if same_plan(*plans):
            yield *ids, "their plans are the same"
        elif seen.same_tracks(one, other, place):
            yield *ids, "the adversary's tracks are the same"
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


def same_plan(one: Plan | Foreign, other: Plan | Foreign) -> bool:
    """Whether two plans are the same but for the names of parameters, whose ranges are the same."""
    return isinstance(one, Plan) and isinstance(other, Plan) and without_names(one) == without_names(other)


def without_names(plan: Plan) -> str:
    """A plan as text, with the range of each parameter in the place of its name."""
    text = print_plan(replace(plan, parameters=()))
    for p in sorted(plan.parameters, key=lambda p: len(p.name), reverse=True):
        text = text.replace(f"{PARAMETERS}.{p.name}", f"({float(p.low)} to {float(p.high)})")
    return text


def may_look_alike(one: Plan | Foreign, other: Plan | Foreign) -> bool:
    """Whether two behaviors stop, go, back and turn in the same order; of a foreign behavior nobody can say.

    One with a loop may go round any number of times, so there the shorter order need only begin the longer one.
    """
    if isinstance(one, Foreign) or isinstance(other, Foreign):
        return True
    shorter, longer = sorted((_manners(one), _manners(other)), key=len)
    if one.loop is None and other.loop is None:
        return shorter == longer
    return longer[: len(shorter)] == shorter


def _manners(plan: Plan) -> list[str]:
    """What the phases of a plan do in turn, without what is done on: stop, go, back or turn."""
    kinds = [_MANNERS.get(phase.primitive, "go") for phase in plan.phases]
    return [kind for kind, _ in groupby(kinds)]


def _first(mask: Mask) -> tuple[int, int] | None:
    found = np.argwhere(mask)
    return (int(found[0][0]), int(found[0][1])) if len(found) else None


class _Seen:
    """Episodes that were run, each once."""

    def __init__(self, joint: Compatibility, simulator: Simulator, ego: EgoPolicy) -> None:
        self._joint = joint
        self._simulator = simulator
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
        return [self._simulator.route(program, n).line.points for n in range(self._simulator.routes(program))]

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
                found = [
                    simulate(self._simulator, program, s, self._ego, through_collisions=True) for s in _scenes(program)
                ]
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
    return [scene_at(program, 0, share, name=f"twin-{i}") for i, share in enumerate(SHARES)]


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
