"""Step 2 of 9: a sentence to a frame, in which everything stands that was read and how sure it is.

Paper: section 3.3, step ii. The reference asks a language model; here patterns and a classifier read, and a language
model fills the same frame where the user has one.
"""

from __future__ import annotations

from dataclasses import replace

from chatscene.files.caches import cache_folder
from chatscene.models.language.protocol import load_language_model
from chatscene.read.asking import ask
from chatscene.read.decompose import hear
from chatscene.read.ego_state import without_state
from chatscene.read.lexicon import ACTIONS
from chatscene.read.slot_classifier import believe
from chatscene.settings import OFFLINE, RetrievalSettings
from chatscene.terms.acts import Action
from chatscene.terms.frame import LIKELY, Frame
from chatscene.terms.scenario import Position


def read(text: str, settings: RetrievalSettings | None = None) -> Frame:
    """Read a sentence, offline or by the language model that the settings name.

    Raises:
        SettingsError: The text is empty or too long, or there is no such language model.
        MissingExtra: The language model's package is missing.
    """
    settings = settings or RetrievalSettings()
    heard = hear(text)
    frame = replace(heard, beliefs=believe(heard, settings.library))
    frame = replace(frame, plain=frame.plain and not _missed(frame))
    if settings.language_model == OFFLINE:
        return frame
    return ask(load_language_model(settings.language_model, cache=cache_folder("replies")), frame)


def _missed(frame: Frame) -> bool:
    """Whether the classifier hears an act that words name, and that the patterns did not take for the adversary's."""
    told = frame.told if frame.outright.ego is None else without_state(frame.told)
    named = {action for action, pattern in ACTIONS.items() if pattern.search(told)}
    if frame.outright.position is Position.ONCOMING:
        named.discard(Action.ONCOMING)  # at a junction that is where it comes from
    return any(frame.beliefs.heard(action) >= LIKELY for action in named.difference(frame.outright.actions))
