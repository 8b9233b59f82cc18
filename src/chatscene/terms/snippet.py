"""Snippets: the typed parts a program is joined from, and the triples retrieval picks.

Paper: sections 3.2 (database) and 3.3 (retrieval).
"""

from __future__ import annotations

from dataclasses import dataclass, field

from chatscene.terms.actors import AdversaryKind
from chatscene.terms.scenario import Component, Slots, Unused


@dataclass(frozen=True, slots=True, kw_only=True)
class ParameterRange:
    """A tunable parameter: ``param OPT_<NAME> = Range(low, high)`` in the snippet's code.

    Attributes:
        name: With its prefix, e.g. ``OPT_ADV_SPEED``.
        low: Smallest value, in `unit`.
        high: Largest value, in `unit`; not below `low`.
        unit: ``m``, ``m/s``, ``s``, ``rad`` or ``1``.
    """

    name: str
    low: float
    high: float
    unit: str
    meaning: str = ""

    def clip(self, value: float) -> float:
        """The nearest value inside the range."""
        return min(max(value, self.low), self.high)


@dataclass(frozen=True, slots=True, kw_only=True)
class Snippet:
    """One reviewed piece of Scenic, with the contract that lets it be joined to others.

    Attributes:
        id: ``component/name``; it stands in a file of ``library/<component>/``.
        description: One sentence, the canonical text that is embedded.
        rephrasings: Other ways to say it, embedded beside it.
        slots: What the code does, as typed facts.
        adversaries: The kinds it works for: of a behavior, who can act it; of a spawn, who fits there;
            empty for a geometry.
        requires: Names it reads that neither it nor the world model defines, sorted.
        provides: Names it defines for its partners, sorted.
        source: The Scenic code, without the header and our marks.
        file: Where it stands in its library, such as ``spawn/kerb-left.scenic``; empty if nowhere.
        lines: In which line of that file each line of the code stands, from 1; empty if nowhere.
    """

    id: str
    component: Component
    description: str
    rephrasings: tuple[str, ...]
    slots: Slots
    adversaries: tuple[AdversaryKind, ...] = ()
    requires: tuple[str, ...] = ()
    provides: tuple[str, ...] = ()
    parameters: tuple[ParameterRange, ...] = ()
    origin: str = ""
    source: str = ""
    file: str = field(default="", compare=False)
    lines: tuple[int, ...] = field(default=(), compare=False)


@dataclass(frozen=True, slots=True, kw_only=True)
class Match:
    """A snippet found for a sub-description, and how near it is.

    Attributes:
        similarity: Words that the nearest of its texts shares with the sub-description, weighed by how rare they are,
            in [0, 1].
        agreement: Share of the sentence's slots for this component that the snippet fulfils, in [0, 1];
            1 where the sentence says nothing.
        score: What the joint choice maximises: similarity and agreement weighed.
        nearest: The text of the snippet that was nearest.
        conflicts: Slots of the sentence that the snippet contradicts, as ``slot: said X, does Y``.
    """

    snippet: Snippet
    similarity: float
    agreement: float
    score: float
    nearest: str
    conflicts: tuple[str, ...] = ()


@dataclass(frozen=True, slots=True, kw_only=True)
class RuledOut:
    """A snippet that scored well but could not be used, and why."""

    snippet_id: str
    reason: str


@dataclass(frozen=True, slots=True, kw_only=True)
class Tried:
    """A choice whose program ran, but whose drives did not show what was said.

    Attributes:
        snippet_ids: The snippets of it that do not show it together; no triple with all of them is chosen again.
        reason: What was not shown.
    """

    snippet_ids: tuple[str, ...]
    reason: str


@dataclass(frozen=True, slots=True, kw_only=True)
class Retrieval:
    """The compatible triple that was chosen, and the evidence.

    Attributes:
        adversary: The kind of adversary all three agree on.
        confidence: In [0, 1]; below the settings' threshold the answer is a refusal.
        candidates: The best few per component, best first.
        ruled_out: Better-scoring snippets that no compatible triple could use.
        tried: Better choices whose drives did not show what was said.
        notes: Quantities that are met only nearly, in words.
        unused: Quantities that were heard but cannot be set in these snippets.
    """

    behavior: Match
    geometry: Match
    spawn: Match
    adversary: AdversaryKind
    confidence: float
    candidates: dict[Component, tuple[Match, ...]]
    ruled_out: tuple[RuledOut, ...] = ()
    tried: tuple[Tried, ...] = ()
    notes: tuple[str, ...] = ()
    unused: tuple[Unused, ...] = ()

    @property
    def snippets(self) -> tuple[Snippet, Snippet, Snippet]:
        """Behavior, geometry, spawn."""
        return self.behavior.snippet, self.geometry.snippet, self.spawn.snippet
