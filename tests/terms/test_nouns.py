"""Nouns in messages have the right article, and are English words."""

from __future__ import annotations

import re
from pathlib import Path

import pytest

from chatscene.situations.phrases import one_of, one_seen, road_named
from chatscene.terms.actors import BY_CLASS, one_of_class
from chatscene.terms.nouns import with_article
from chatscene.terms.vocabulary import RoadKind, UserKind

SOURCE = Path(__file__).parents[2] / "src" / "chatscene"
GRAMMAR = SOURCE / "sentences" / "grammar"  # whose alternatives have their articles written out
IN_ENGLISH = re.compile(r"an? [a-z]+(?:[ -][a-z]+)*")


@pytest.mark.parametrize(
    ("noun", "with_its"),
    [
        ("animal", "an animal"),
        ("one-way road", "a one-way road"),
        ("European car", "a European car"),
        ("universal joint", "a universal joint"),
        ("unit", "a unit"),
        ("uninsured car", "an uninsured car"),
        ("OrientedPoint", "an OrientedPoint"),
        ("eighth car", "an eighth car"),
        ("SUV", "an SUV"),
        ("U-turn", "a U-turn"),
        ("u-turn", "a u-turn"),
        ("unimportant car", "an unimportant car"),
        ("unidentified car", "an unidentified car"),
        ("unidirectional road", "a unidirectional road"),
        ("unicycle", "a unicycle"),
        ("usual car", "a usual car"),
        ("hour", "an hour"),
        ("8", "an 8"),
        ("11 m gap", "an 11 m gap"),
        ("18", "an 18"),
        ("18000 kg lorry", "an 18000 kg lorry"),
        ("110 km/h road", "a 110 km/h road"),
        ("1.5 m gap", "a 1.5 m gap"),
        ("car", "a car"),
    ],
)
def test_a_noun_has_the_article_that_is_heard(noun: str, with_its: str) -> None:
    assert with_article(noun) == with_its


@pytest.mark.parametrize("kind", [*UserKind, *BY_CLASS, "PhoneBox", *RoadKind], ids=str)
def test_every_kind_is_called_in_english_with_its_article(kind: str) -> None:
    named = [road_named(kind)] if isinstance(kind, RoadKind) else [one_seen(kind), one_of_class(kind)]
    if isinstance(kind, UserKind):
        named = [one_of(kind), one_seen(kind.scenic)]
    for told in named:
        assert IN_ENGLISH.fullmatch(told), told
        assert with_article(told.partition(" ")[2]) == told


def test_no_article_is_written_before_a_word_that_is_filled_in() -> None:
    found = [
        f"{path.relative_to(SOURCE)}: {line.strip()}"
        for path in sorted(SOURCE.rglob("*.py"))
        if not path.is_relative_to(GRAMMAR)
        for line in path.read_text().splitlines()
        if re.search(r"\b[Aa]n? \{", line)
    ]
    assert not found, "use chatscene.terms.nouns.with_article, or one_of of chatscene.situations.phrases"
