"""Trying a stranger's snippet: every program with it runs in the confined process, with partners from the library."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace

from chatscene.ego.policy import EgoPolicy
from chatscene.errors import ChatSceneError
from chatscene.grow.draft import code_faults
from chatscene.grow.lint import SCENES, Finding, Triple, trials, try_triple
from chatscene.grow.twins import twins
from chatscene.library.load import Library
from chatscene.simulate.simulator import Simulator
from chatscene.terms.actors import AdversaryKind
from chatscene.terms.acts import Action
from chatscene.terms.conclusions import base_of
from chatscene.terms.scenario import BaseScenario, Component
from chatscene.terms.snippet import Snippet

ANYBODYS = ("runs", "samples", "plausible")  # what a trial lays at a partner's door is the newcomer's fault too


def partners_for(library: Library, base: BaseScenario | None) -> Library:
    """The library without the geometries of other base scenarios."""
    return Library(
        tuple(s for s in library if s.component is not Component.GEOMETRY or base is None or serves(s, base))
    )


def serves(geometry: Snippet, base: BaseScenario) -> bool:
    """Whether a geometry is one of a base scenario, for some kind of adversary."""
    return any(
        base_of(replace(geometry.slots, adversary=kind, actions=actions)) is base
        for kind in AdversaryKind
        for actions in ((), (Action.RUN_LIGHT,))
    )


class Judge:
    """Says what is wrong with a snippet that nobody has reviewed."""

    def __init__(self, library: Library, simulator: Simulator, ego: EgoPolicy, *, scenes: int = SCENES) -> None:
        self.library = library
        self._simulator, self._ego, self._scenes = simulator, ego, scenes

    def learn(self, snippet: Snippet) -> None:
        """Hold later ones against this one too."""
        self.library = Library(tuple(sorted((*self.library, snippet), key=lambda s: s.id)))

    def faults(self, snippet: Snippet, base: BaseScenario | None) -> tuple[Finding, ...]:
        """The faults of the first rung that fails: its code, then drives with partners, then that it is new."""
        others = Library(tuple(s for s in self.library if s.id != snippet.id and s.slots.site is None))
        if faults := code_faults(snippet, others):
            return faults
        if base is not None and snippet.component is Component.GEOMETRY and not serves(snippet, base):
            return (Finding(snippet.id, "base", f"what it says of the ego's way is not the base scenario {base}"),)
        joint = Library(tuple(sorted((*partners_for(others, base), snippet), key=lambda s: s.id)))
        return self._driven(joint, snippet) or tuple(self._alike(joint, snippet))

    def _driven(self, joint: Library, snippet: Snippet) -> tuple[Finding, ...]:
        tried = False
        for triple, kind in trials(joint, {snippet.id}):
            tried = True
            faults = self._run(triple, kind, snippet)
            # A place can keep anybody from showing what they do, so that is tried in another before it counts.
            if {f.rung for f in faults} == {"means"} and (other := _elsewhere(joint, snippet, triple, kind)):
                faults = self._run(other, kind, snippet)
            if faults:
                return faults
        return () if tried else (Finding(snippet.id, "partners", "no two other snippets fit it"),)

    def _run(self, triple: Triple, kind: AdversaryKind, snippet: Snippet) -> tuple[Finding, ...]:
        found = try_triple(triple, kind, self._simulator, self._ego, self._scenes)
        return tuple(sorted({replace(f, snippet_id=snippet.id) for f in found if _concerns(f, snippet)}, key=str))

    def _alike(self, joint: Library, snippet: Snippet) -> Iterator[Finding]:
        try:
            for one, other, why in twins(joint, self._simulator, self._ego, {snippet.id}):
                twin = other if one == snippet.id else one
                yield Finding(snippet.id, "distinct", f"does the same as {twin}: {why}")
        except ChatSceneError as error:
            yield Finding(snippet.id, "distinct", f"cannot be compared: {type(error).__name__}: {error}")


def _concerns(finding: Finding, snippet: Snippet) -> bool:
    return finding.snippet_id == snippet.id or finding.rung in ANYBODYS


def _elsewhere(joint: Library, snippet: Snippet, triple: Triple, kind: AdversaryKind) -> Triple | None:
    """Another program with the snippet and the kind, without any of its partners; None if there is none."""
    partners = {part.id for part in triple} - {snippet.id}
    rest = Library(tuple(s for s in joint if s.id not in partners))
    if not all(rest.of(component) for component in Component):
        return None
    return next((other for other, acts in trials(rest, {snippet.id}) if acts is kind), None)
