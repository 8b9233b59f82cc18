"""The first half of step 3: a frame's facts, and what follows from them, as a scenario to choose snippets for."""

from __future__ import annotations

import re
from dataclasses import replace
from functools import lru_cache

from chatscene.interpret.paper import read_as_in_paper
from chatscene.interpret.scenario_names import named
from chatscene.interpret.wording import parts_of
from chatscene.library.compatibility import agree, compatibility
from chatscene.library.load import library_with
from chatscene.settings import PAPER_READER, RetrievalSettings
from chatscene.terms.acts import Action
from chatscene.terms.conclusions import base_of, concluded
from chatscene.terms.frame import About, Frame, Note
from chatscene.terms.scenario import Component, QuantityKind, Scenario, Slots
from chatscene.terms.slots import slots_of
from chatscene.terms.snippet import Snippet


def understand(frame: Frame, settings: RetrievalSettings) -> Scenario:
    """What a text says, for whoever chooses snippets for it.

    Raises:
        NothingFits: In the paper's way, no triple has the kind of road user that was said.
    """
    if settings.reader == PAPER_READER:
        frame, parts = read_as_in_paper(frame, settings)
        return replace(understood(frame), parts=parts)
    return understood(as_worded(frame, settings))


def as_worded(frame: Frame, settings: RetrievalSettings) -> Frame:
    """The frame, and of a text that is to the word a wording of a user's own behavior, one that says what that does.

    Where it is done is what the text was read to say, as far as there is a place for it that the behavior can be
    joined with; what there is none for is a note.
    """
    own = _worded(frame, settings) if settings.library else ()
    if not own or frame.reader or settings.reading or settings.stated:
        return frame
    behavior, library = own[0], library_with(settings.library)
    kind = frame.outright.adversary
    if kind is None or kind.acts_as not in behavior.adversaries:
        kind = behavior.adversaries[0]
    slots = replace(frame.outright, **behavior.slots.said(), adversary=kind, others=())
    joint = compatibility(library)
    fits = joint.places(joint.behaviors.index(behavior))
    partners = (
        (Component.GEOMETRY, joint.geometries, fits.any(axis=1)),
        (Component.SPAWN, joint.spawns, fits.any(axis=0)),
    )
    there = {
        name: [getattr(s.slots, name) for s, fit in zip(snippets, fitting, strict=True) if fit]
        for component, snippets, fitting in partners
        for name in slots_of(component)
    }
    nowhere = {
        name: value
        for name, value in slots.said().items()
        if not any(agree(value, one) for one in there.get(name, (None,)))
    }
    slots = replace(slots, **{name: getattr(Slots(), name) for name in nowhere})
    without = (
        Note(about=About.DIFFERENT, said=(name, "the words", str(value), behavior.id, "joins no such place"))
        for name, value in nowhere.items()
    )
    return replace(frame, outright=slots, sure=1.0, unused=(), readings=(), notes=tuple(without))


def understood(frame: Frame) -> Scenario:
    """The scenario of a frame: its facts with what follows from them."""
    slots = concluded(frame.outright)
    if Action.SWERVE not in slots.actions:  # who does not swerve does it to no side
        quantities = tuple(one for one in frame.quantities if one.measure is not QuantityKind.ASIDE)
        frame = replace(frame, quantities=quantities)
    return Scenario(
        id=named(frame.text),
        text=frame.text,
        base=base_of(slots),
        parts=parts_of(frame, slots),
        slots=slots,
        notes=frame.notes,
        unused=frame.unused,
        frame=frame,
        surroundings=frame.surroundings,
        readings=frame.readings,
    )


def _worded(frame: Frame, settings: RetrievalSettings) -> tuple[Snippet, ...]:
    """The user's own behaviors of which the text is a wording, to the word."""
    said, packaged = _words(frame.text), library_with("").of(Component.BEHAVIOR)
    own = (one for one in library_with(settings.library).of(Component.BEHAVIOR) if one not in packaged)
    return tuple(one for one in own if any(_words(text) == said for text in (one.description, *one.rephrasings)))


@lru_cache(maxsize=65536)
def _words(text: str) -> str:
    """A text without case and punctuation."""
    return " ".join(re.findall(r"\w+", text.casefold()))
