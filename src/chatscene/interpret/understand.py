"""Steps 2 and 3 together: a sentence read by the patterns and the classifier, agreeing or saying so."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace
from typing import Any

from chatscene.files.caches import cache_folder
from chatscene.interpret.nearest import likely_by_wording
from chatscene.interpret.retrieve import settle
from chatscene.library.load import library_with
from chatscene.models.encoders.embedding import load_embedder
from chatscene.models.language.protocol import load_language_model
from chatscene.read.asking import decompose_with
from chatscene.read.decompose import hear, understood
from chatscene.read.lexicon import ACTIONS
from chatscene.read.slot_classifier import VALUES, believe
from chatscene.settings import OFFLINE, RetrievalSettings
from chatscene.terms.acts import Action
from chatscene.terms.frame import About, Beliefs, Frame, Note
from chatscene.terms.scenario import Component, Position, Scenario, Slots

LIKELY = 0.5  # an action is said if it is as likely as this …
KNOWN = 0.1  # … or belongs to the likeliest behavior, if that is as likely as this


def read(text: str, settings: RetrievalSettings | None = None) -> Scenario:
    """Read a sentence, offline or by the language model that the settings name.

    Raises:
        SettingsError: The text is empty or too long, or there is no such language model.
        MissingExtra: The language model's package is missing.
    """
    settings = settings or RetrievalSettings()
    offline = _read_offline(text, settings)
    if settings.language_model == OFFLINE:
        return offline
    return decompose_with(load_language_model(settings.language_model, cache=cache_folder("replies")), offline)


def _read_offline(text: str, settings: RetrievalSettings) -> Scenario:
    """Patterns and classifier weighed slot by slot, then settled together with what the library has.

    Each slot that ends otherwise than the patterns read it is a note. Where the patterns know every word, what they
    read stands, and nothing else was said to be done.
    """
    heard = hear(text)
    library = library_with(settings.library)
    beliefs = believe(heard, settings.library)
    behaviors = library.of(Component.BEHAVIOR)
    unknown = [s for s in behaviors if s.id not in beliefs.behaviors]
    said = heard.clauses.adversary or heard.clauses.whole
    others = likely_by_wording(said, unknown, load_embedder(settings.embedder)) if unknown else {}
    frame = replace(heard, beliefs=replace(beliefs, others=others))
    frame = replace(frame, plain=frame.plain and not _missed(frame))
    slots = likeliest(frame.beliefs, {s.id: s.slots.actions for s in behaviors})
    if frame.plain:
        slots = replace(slots, **frame.outright.said())
    slots = settle(frame, slots, library)
    differ = [
        Note(about=About.DIFFERENT, said=(name, "the patterns", str(was), "the classifier", str(now)))
        for name in VALUES
        if (was := getattr(frame.outright, name)) is not None and (now := getattr(slots, name)) != was
    ]
    found = {About.WHO, About.STRANGER} if slots.adversary else set[About]()
    found |= {About.WHAT} if slots.actions else set[About]()
    return understood(frame, slots, (*(note for note in frame.notes if note.about not in found), *differ))


def likeliest(beliefs: Beliefs, behaviors: Mapping[str, tuple[Action, ...]]) -> Slots:
    """The likeliest value of each slot, and what the likeliest behavior does.

    Actions come together or not at all, as in the behaviors that people speak of; taken one by one where each is
    likelier than not, half as many are right. Where no behavior is likely, they are.

    Args:
        beliefs: How sure everything is.
        behaviors: What each behavior of the library does.
    """
    values: dict[str, Any] = {
        name: max(classes, key=lambda value: classes[value]) for name, classes in beliefs.slots.items()
    }
    likely = {name: p for name, p in beliefs.behaviors.items() if name in behaviors}
    best = max(likely, key=lambda name: likely[name], default="")
    if likely.get(best, 0.0) >= KNOWN:
        return Slots(**values, actions=behaviors[best])
    return Slots(**values, actions=tuple(a for a in Action if beliefs.heard(a) >= LIKELY))


def _missed(frame: Frame) -> bool:
    """Whether the classifier hears an act that words name, and that the patterns did not take for the adversary's."""
    named = {action for action, pattern in ACTIONS.items() if pattern.search(frame.told)}
    if frame.outright.position is Position.ONCOMING:
        named.discard(Action.ONCOMING)  # at a junction that is where it comes from
    return any(frame.beliefs.heard(action) >= LIKELY for action in named.difference(frame.outright.actions))
