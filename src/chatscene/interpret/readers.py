"""Who reads texts: the language model that the settings name, or the project's own reader."""

from __future__ import annotations

from collections.abc import Callable

from chatscene.files.caches import cache_folder
from chatscene.read.learned.reader import LearnedReader
from chatscene.read.reader import Reader
from chatscene.settings import OFFLINE, RetrievalSettings
from chatscene.terms.situation import Situation


def reader_of(settings: RetrievalSettings, cannot_build: Callable[[Situation], str] = lambda _: "") -> Reader:
    """Who reads texts: the language model that the settings name, or the project's own reader.

    Args:
        settings: Which.
        cannot_build: Says a language model why a situation cannot be built; empty if it can.

    Raises:
        SettingsError: There is no such model.
        MissingExtra: Its package is missing.
    """
    if settings.language_model == OFFLINE:
        return LearnedReader()
    from chatscene.models.language.protocol import load_language_model
    from chatscene.read.by_model import LIMITS, ModelReader

    model = load_language_model(settings.language_model, limits=LIMITS, cache=cache_folder("replies"))
    return ModelReader(model, cannot_build)
