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
from chatscene.read.slot_classifier import believe
from chatscene.settings import OFFLINE, RetrievalSettings
from chatscene.terms.frame import Frame, certain


def read(text: str, settings: RetrievalSettings | None = None) -> Frame:
    """Read a sentence, offline or by the language model that the settings name.

    Raises:
        SettingsError: The text is empty or too long, or there is no such language model.
        MissingExtra: The language model's package is missing.
    """
    settings = settings or RetrievalSettings()
    heard = hear(text)
    believed = believe(heard, settings.library)
    frame = replace(heard, beliefs=certain(heard.outright, believed) if heard.whole else believed)
    if settings.language_model == OFFLINE:
        return frame
    return ask(load_language_model(settings.language_model, cache=cache_folder("replies")), frame)
