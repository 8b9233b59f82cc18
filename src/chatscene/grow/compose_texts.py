"""Sentences with what they say, made of a library's own wordings: what the slot classifier learns from.

A composed sentence joins a wording of a compatible geometry, spawn and behavior; its labels are their slots.
"""

from __future__ import annotations

import random
from collections.abc import Sequence
from dataclasses import dataclass, replace
from typing import Any

import numpy as np

from chatscene.library.compatibility import compatibility
from chatscene.library.load import Library
from chatscene.read.slot_classifier import VALUES
from chatscene.sentences.rendering import render
from chatscene.terms.description import Style
from chatscene.terms.scenario import Component, Slots
from chatscene.terms.snippet import Snippet

PASTED = 0.3  # share of sentences that end in a wording of the behavior


@dataclass(frozen=True, slots=True)
class Labelled:
    """A sentence with what it says.

    Attributes:
        text: The sentence.
        slots: What it says.
        behaviors: Ids of the behaviors it may mean; empty if unknown.
        open: Slots that nobody labelled; they teach nothing.
        in_scope: Whether a library of driving scenarios can serve it.
    """

    text: str
    slots: Slots
    behaviors: tuple[str, ...] = ()
    open: frozenset[str] = frozenset()
    in_scope: bool = True


def compose(library: Library, count: int, seed: int) -> list[Labelled]:
    """Sentences from wordings of compatible triples, every behavior about equally often."""
    rng = random.Random(seed)
    joint = compatibility(library.without_sites())
    out: list[Labelled] = []
    places = [np.argwhere(joint.mask[i]) for i in range(len(joint.behaviors))]
    usable = [i for i, pairs in enumerate(places) if len(pairs)]
    while len(out) < count:
        i = usable[len(out) % len(usable)]
        g, s = places[i][rng.randrange(len(places[i]))]
        out.append(_joined((joint.behaviors[i], joint.geometries[g], joint.spawns[s]), rng))
    return out


def wordings(library: Library) -> list[Labelled]:
    """Every wording of every behavior, as its author wrote it; it teaches what is done, and nothing else."""
    behaviors = [snippet for snippet in library if snippet.component is Component.BEHAVIOR]
    return [
        Labelled(text, Slots(actions=snippet.slots.actions), (snippet.id,), open=frozenset(VALUES))
        for snippet in behaviors
        for text in (snippet.description, *snippet.rephrasings)
    ]


def _joined(triple: tuple[Snippet, Snippet, Snippet], rng: random.Random) -> Labelled:
    behavior, geometry, spawn = triple
    kind = rng.choice([kind for kind in behavior.adversaries if kind in spawn.adversaries])
    rendered = render(
        _merged([part.slots for part in (geometry, spawn, behavior)]),
        (behavior.description, *behavior.rephrasings),
        kind,
        rng=rng,
        style=rng.choice(tuple(Style)),
        omit=rng.choice((0.0, 0.15, 0.35)),
    )
    if rng.random() < PASTED:
        return Labelled(
            _pasted(rendered.text, behavior, rng),
            replace(rendered.said, actions=behavior.slots.actions),
            (behavior.id,),
            open=frozenset(("adversary",)),
        )
    return Labelled(rendered.text, rendered.said, (behavior.id,) if rendered.said.actions else ())


def _pasted(text: str, behavior: Snippet, rng: random.Random) -> str:
    """A sentence whose last words are a wording of the behavior as it stands: its author's words, not the grammar's."""
    return f"{text.rstrip('.')}. {_wording(behavior, rng)}"


def _wording(snippet: Snippet, rng: random.Random) -> str:
    return rng.choice((snippet.description, *snippet.rephrasings))


def _merged(parts: Sequence[Slots]) -> Slots:
    values: dict[str, Any] = {}
    for part in parts:
        for name, value in part.said().items():
            if value is not False or name == "two_way":
                values.setdefault(name, value)
    return Slots(**values)
