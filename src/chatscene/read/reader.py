"""Who fills situations from texts: one Protocol, and the files below that say their own name."""

from __future__ import annotations

import re
from typing import Protocol

from chatscene.errors import NothingFits, SettingsError
from chatscene.plugins import Kind, Packaged, make
from chatscene.terms.reading import SituationReading

LONGEST = 2000  # characters; a situation fits into a paragraph


class Reader(Protocol):
    """Reads a text.

    Attributes:
        name: What the user calls it.
    """

    @property
    def name(self) -> str: ...  # noqa: D102

    def read(self, text: str) -> SituationReading:
        """What a text tells.

        Raises:
            SettingsError: The text is empty or too long.
            NothingFits: It is of a language that the reader does not read.
            LanguageModelError: A reader that asks a language model got no usable reply.
        """
        ...


READERS: Kind[Reader] = Kind(
    noun="reader",
    group="chatscene.readers",
    method="read",
    built_in=Packaged("read"),
    forms=("openai:MODEL", "gguf:FILE"),
    beyond=lambda name: ":" in name,  # whose kind and file are looked at when it is loaded
)
"""Readers that need no language model; `chatscene.read.by_model.ModelReader` asks any of these."""


def load_reader(name: str) -> Reader:
    """A reader by the name a user types, if it is no language model.

    Raises:
        SettingsError: There is none of that name, or its code fails.
        MissingExtra: Its package is missing.
    """
    return make(READERS, name)


def check_text(text: str) -> None:
    """Hold a text to what a reader takes.

    Raises:
        SettingsError: It is empty or longer than `LONGEST`.
    """
    if not text.strip():
        raise SettingsError("the text is empty; describe a situation, such as 'a cyclist cuts across from the left'")
    if len(text) > LONGEST:
        raise SettingsError(f"the text has {len(text)} characters; use at most {LONGEST} for one situation")


def in_one_line(text: str) -> str:
    """A text in one line, of what can be printed alone."""
    return " ".join("".join(c if c.isprintable() else " " for c in text).split())


# Whether a text is English, which alone the packaged reader has learned


_ENGLISH_WORDS = """
    the and of on at to from by with as while when where who which that this it its he she his her we us our is are was
    were be been being have has had then just after before into onto over out off up down through along across behind
    front
"""
_ENGLISH = frozenset(_ENGLISH_WORDS.split())
_OTHER_WORDS = """
    der das den dem des ein eine einen einem einer und ist wir uns von vor nach mit auf aus im bei zu rechts links
    el la los las un una uno y que del con por para desde hacia nos se en su derecha izquierda delante
    le les une et est nous du de des qui dans avec sur depuis devant vers notre gauche droite au
    il lo gli che di da dal dalla nel nella con noi davanti sinistra destra verso
    het een naar voor wij ons onze os um uma
"""
_OTHER = frozenset(_OTHER_WORDS.split())  # without those that English has as well, such as "die" and "van"
_LAST_LATIN = "\u024f"


def is_english(text: str) -> bool:
    """Whether a text looks English: by its letters, and by the small words that every language has its own of."""
    letters = [c for c in text if c.isalpha()]
    if sum(c > _LAST_LATIN for c in letters) * 2 > len(letters):
        return False
    words = re.findall(r"[^\W\d_]+", text.lower())
    other = sum(word in _OTHER for word in words)
    return other < 2 or other <= sum(word in _ENGLISH for word in words)


def check_english(text: str) -> None:
    """Hold a text to the language that was learned; another one would be read as anything.

    Raises:
        NothingFits: It looks like another language.
    """
    if not is_english(text):
        raise NothingFits(
            "this does not look like English, and the offline reader reads only English; write English, or name a "
            "language model with --language-model",
            reasons=("not in English",),
        )
