"""A text as the encoder's pieces, with the places of its amounts among them."""

from __future__ import annotations

from dataclasses import dataclass
from itertools import pairwise

from chatscene.models.encoders.embedding import tokenize
from chatscene.read.learned.numbers import Found, amounts_in

LONGEST = 192
"""Pieces of a text that are read."""


@dataclass(frozen=True, slots=True)
class Read:
    """A text, ready for the encoder.

    Attributes:
        pieces: The numbers of its pieces, with the marks of begin and end.
        where: Of each piece between the marks, where its stretch of the text begins and ends.
        amounts: The amounts that its words may mean.
        spans: Of each amount the first of its pieces, and the first after them.
    """

    text: str
    pieces: tuple[int, ...]
    where: tuple[tuple[int, int], ...]
    amounts: tuple[Found, ...]
    spans: tuple[tuple[int, int], ...]


def prepared(text: str, edit: int | None = None) -> Read:
    """A text as pieces; what has no room is cut off, with its amounts.

    Args:
        text: The text.
        edit: Where an edit of what was told begins, if it is one.
    """
    text = text.encode("utf-8", "replace").decode("utf-8")
    amounts = amounts_in(text, edit)
    cuts = sorted({0, len(text), *(end for one in amounts for end in (one.low, one.high)), *_breaks(text)})
    begin, *_, end = tokenize("", LONGEST)
    pieces, where, at = [begin], list[tuple[int, int]](), dict[int, int]()
    for low, high in pairwise(cuts):
        at[low] = len(pieces)
        inner = tokenize(text[low:high], len(text) + 2)[1:-1]
        pieces += inner
        where += [(low, high)] * len(inner)
    at[len(text)] = len(pieces)
    most = LONGEST - 1
    kept = tuple(one for one in amounts if at[one.low] < at[one.high] <= most)
    spans = tuple((at[one.low], at[one.high]) for one in kept)
    return Read(text, (*pieces[:most], end), tuple(where[: most - 1]), kept, spans)


def _breaks(text: str) -> list[int]:
    """Where a word ends and white space begins."""
    return [i for i in range(1, len(text)) if text[i].isspace() and not text[i - 1].isspace()]
