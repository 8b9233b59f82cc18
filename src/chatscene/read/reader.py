"""Who fills situations from texts: one Protocol, and the files below that say their own name."""

from __future__ import annotations

from typing import Protocol

from chatscene.errors import SettingsError
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
