"""A text as pieces, with its amounts among them."""

from __future__ import annotations

from chatscene.models.encoders.embedding import tokenize
from chatscene.read.learned.text import LONGEST, prepared

TEXT = "VUT at 50 km/h, lead 1.2 s ahead brakes with 4 m/s² to standstill."


def test_the_pieces_are_those_of_the_whole_text() -> None:
    assert list(prepared(TEXT).pieces) == tokenize(TEXT, LONGEST)


def test_each_amount_has_its_pieces() -> None:
    read = prepared(TEXT)
    inner = tokenize("50 km/h", LONGEST)[1:-1]
    low, high = read.spans[0]
    assert list(read.pieces[low:high]) == inner


def test_a_long_text_is_cut_with_its_amounts() -> None:
    read = prepared("word " * 400 + "at 50 km/h")
    assert len(read.pieces) == LONGEST
    assert read.amounts == ()


def test_an_empty_text_has_two_marks() -> None:
    assert len(prepared("").pieces) == 2
