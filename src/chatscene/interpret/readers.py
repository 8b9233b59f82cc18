"""Who reads texts: a language model that the settings name, or a reader of the table."""

from __future__ import annotations

from collections.abc import Callable

from chatscene.files.caches import cache_folder
from chatscene.plugins import make, names
from chatscene.read.reader import READERS, Reader
from chatscene.settings import RetrievalSettings
from chatscene.terms.situation import Situation


def reader_of(settings: RetrievalSettings, cannot_build: Callable[[Situation], str] = lambda _: "") -> Reader:
    """Who reads texts: the language model or the reader that the settings name.

    Raises:
        SettingsError: There is no such model or reader.
        MissingExtra: Its package is missing.
    """
    if not is_model(settings.language_model):
        return make(READERS, settings.language_model)
    from chatscene.models.language.protocol import load_language_model
    from chatscene.read.by_model import LIMITS, ModelReader

    model = load_language_model(settings.language_model, limits=LIMITS, cache=cache_folder("replies"))
    return ModelReader(model, cannot_build)


def is_model(name: str) -> bool:
    """Whether it is a language model that reads, ``KIND:MODEL`` or ``package.module:factory:MODEL``, and no reader."""
    if name in READERS.built_in:
        return False
    from chatscene.models.language.protocol import LANGUAGE_MODELS

    kind, colon, which = name.partition(":")
    own = (kind.isidentifier() and which.isidentifier()) or "." in kind
    return kind in names(LANGUAGE_MODELS) or ":" in which or (bool(colon) and not own)
