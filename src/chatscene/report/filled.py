"""A situation that a language model reads in a text, on the way to its program."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import replace

from chatscene.build.build import build
from chatscene.errors import NotBuilt, NothingFits, SettingsError, SituationError
from chatscene.files.caches import cache_folder
from chatscene.models.language.protocol import load_language_model
from chatscene.read.by_model import LIMITS, ModelReader
from chatscene.read.reader import Reader
from chatscene.report.stated import stated
from chatscene.settings import OFFLINE, RetrievalSettings
from chatscene.terms.reading import Verdict
from chatscene.terms.situation import Situation


def filled(
    text: str,
    settings: RetrievalSettings,
    facts: Mapping[str, object] | None = None,
    map_name: str | None = None,
    reader: Reader | None = None,
) -> Situation:
    """The situation that a text tells, with some facts set by their paths.

    Args:
        text: The text.
        settings: Which language model reads, and which reading is taken.
        facts: Facts that the user states.
        map_name: The map that it is to be built on; None for any.
        reader: Who reads; the language model of the settings if None.

    Raises:
        SettingsError: The text is empty or too long, or there is no such model or reading.
        NothingFits: The reader says that it tells no situation, or none that can be told here.
        SituationError: A fact has no place in it.
        LanguageModelError: The model gave no usable reply.
    """
    if reader is None:
        model = load_language_model(settings.language_model, limits=LIMITS, cache=cache_folder("replies"))
        reader = ModelReader(model, _unbuilt(facts, map_name))
    read = reader.read(text)
    if read.verdict is not Verdict.SITUATION:
        raise NothingFits(f"{read.reader} says that {read.verdict.said}: “{read.reason}”", reasons=(read.reason,))
    if settings.reading > len(read.ranked):
        raise SettingsError(f"there is no reading {settings.reading}; {read.reader} gives {len(read.ranked)}")
    return stated(read.ranked[max(settings.reading, 1) - 1].situation, facts)


def read_already(settings: RetrievalSettings) -> RetrievalSettings:
    """The settings of a run of what was read: no model is asked again, and nothing is chosen or stated any more."""
    unasked = RetrievalSettings()
    return replace(settings, language_model=OFFLINE, reading=unasked.reading, stated=unasked.stated)


def _unbuilt(facts: Mapping[str, object] | None, map_name: str | None) -> Callable[[Situation], str]:
    """Why a situation, with what the user states, cannot be built; empty if it can."""

    def why(situation: Situation) -> str:
        try:
            build(stated(situation, facts, map_name))
        except NotBuilt as error:
            return str(error)
        except SituationError:  # which whoever states the facts is told
            return ""
        return ""

    return why
