"""Steps 2 and 3 together: a sentence read by the patterns and the classifier, agreeing or saying so."""

from __future__ import annotations

from dataclasses import replace

from chatscene.agent.asking import decompose_with
from chatscene.agent.base import base_of, concluded
from chatscene.agent.decompose import WHAT, WHO, clauses_of, decompose, told
from chatscene.agent.lexicon import ACTIONS
from chatscene.agent.unused import unused_of
from chatscene.agent.wording import geometry_in_words, spawn_in_words
from chatscene.language_models.protocol import load_language_model
from chatscene.language_models.reply_cache import user_folder
from chatscene.settings import OFFLINE, RetrievalSettings
from chatscene.snippets.embedding import load_embedder
from chatscene.snippets.library import library_with
from chatscene.snippets.retrieve import settled
from chatscene.snippets.slot_classifier import LIKELY, VALUES, Probabilities, likelihoods, said
from chatscene.terms.scenario import Action, Component, Position, Scenario


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
    return decompose_with(load_language_model(settings.language_model, cache=user_folder()), offline)


def _read_offline(text: str, settings: RetrievalSettings) -> Scenario:
    """Patterns and classifier weighed slot by slot, then settled together with what the library has.

    Each slot that ends otherwise than the patterns read it is a note. Where the patterns know every word, what they
    read stands, and nothing else was said to be done.
    """
    rules = decompose(text)
    likely = likelihoods(rules.text, settings.library)
    library = library_with(settings.library)
    rules = replace(rules, plain=rules.plain and not _missed(rules, likely))
    slots = said(likely, {s.id: s.slots.actions for s in library.of(Component.BEHAVIOR)})
    if rules.plain:
        slots = replace(slots, **rules.slots.said())
    slots = concluded(slots)
    slots = concluded(
        settled(replace(rules, slots=slots), rules.slots, library, load_embedder(settings.embedder), likely)
    )
    notes = [
        f"{name}: the patterns read {was}, the classifier {now}"
        for name in VALUES
        if (was := getattr(rules.slots, name)) is not None and (now := getattr(slots, name)) != was
    ]
    heard = tuple(note for note, fact in ((WHO, slots.adversary), (WHAT, slots.actions)) if fact)
    guessed = tuple(name for name in (*VALUES, "actions") if getattr(slots, name) and not getattr(rules.slots, name))
    return replace(
        rules,
        slots=slots,
        base=base_of(slots),
        parts=replace(
            rules.parts, geometry=geometry_in_words(slots, clauses_of(text).ego), spawn=spawn_in_words(slots)
        ),
        notes=(*(note for note in rules.notes if not note.startswith(heard)), *notes),
        guessed=guessed,
        unused=unused_of(told(text), slots, rules.quantities),
    )


def _missed(rules: Scenario, likely: Probabilities) -> bool:
    """Whether the classifier hears an act that words name, and that the patterns did not take for the adversary's."""
    text = told(rules.text)
    named = {action for action, pattern in ACTIONS.items() if pattern.search(text)}
    if rules.slots.position is Position.ONCOMING:
        named.discard(Action.ONCOMING)  # at a junction that is where it comes from
    return any(likely.actions[action] >= LIKELY for action in named.difference(rules.slots.actions))
