"""Who fills situations from texts: one Protocol."""

from __future__ import annotations

from typing import Protocol

from chatscene.terms.reading import SituationReading


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
            LanguageModelError: A reader that asks a language model got no usable reply.
        """
        ...
