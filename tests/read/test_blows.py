"""Who strikes whom is settled by grammar: by who is the subject, the object, and behind ``by``."""

from __future__ import annotations

import re

import pytest

from chatscene.read.blows import settled, striker_in
from chatscene.read.ego_named import ego_named
from chatscene.read.learned.reader import LearnedReader
from chatscene.situations.form import from_plain
from chatscene.terms.situation import Contact
from chatscene.terms.vocabulary import Part, Striker, Where

EGO, OTHER = Striker.EGO, Striker.OTHER


def found(text: str, words: str) -> tuple[tuple[int, int], ...]:
    return tuple(one.span() for one in re.finditer(words, text))


@pytest.mark.parametrize(
    ("text", "striker"),
    [
        ("We struck a van.", EGO),
        ("A van struck us.", OTHER),
        ("We braked too late and struck the rear of a van.", EGO),
        ("A van braked too late and struck the rear of our car.", OTHER),
        ("A van was struck by us.", EGO),
        ("We were struck by a van.", OTHER),
        ("The van behind us was struck by the AV.", EGO),
        ("A van stopped and then got struck from behind by our truck.", EGO),
        ("We stopped and then got struck by a van.", OTHER),
        ("A van, struck by us in the junction.", EGO),
        ("The ego, struck by a van in the junction.", OTHER),
        ("A van which we then struck.", EGO),
        ("A van which then struck us.", OTHER),
        ("V2 (passenger side) was struck by V1.", EGO),
        ("V1 (driver side) was struck by V2.", OTHER),
        ("Unit 1 was waiting when it was struck by Unit 2.", OTHER),
        ("We were nearly struck from behind.", OTHER),
        ("He struck the van with our mirror.", None),
        ("The van was struck.", None),
        ("A van behind us struck a wall.", None),
        ("While we turned left a van struck a wall.", None),
    ],
)
def test_the_striker_follows_from_the_voice(text: str, striker: Striker | None) -> None:
    assert striker_in(text, found(text, "struck")) is striker


def test_of_numbered_units_the_first_is_the_ego_but_where_somebody_tells_of_what_happened_to_them() -> None:
    assert ego_named("Unit 2 turned left. Unit 1 braked.").unit == "Unit 1"
    assert not ego_named("Unit 2 turned left before me. Unit 1 braked.").unit
    assert not ego_named("Unit 2 turned left.").spans
    assert not ego_named("The US has roads in front of a host of tests.").spans


def test_a_part_is_that_of_its_owner_and_who_is_struck_in_the_rear_is_ahead() -> None:
    text = "We hit the rear of a van."
    read = from_plain(
        {
            "others": [{"id": "A", "kind": "van", "starts": {"where": "behind"}}],
            "contact": {"ego": "rear", "striker": "other"},
        }
    )
    marked = {
        "contact": found(text, "hit"),
        "contact.ego": found(text, "rear of"),
        "others.A.starts.where": found(text, "van"),
        "others.A.kind": found(text, "van"),
    }
    made = settled(read, text, marked)
    assert made.contact == Contact(other=Part.REAR, striker=EGO)
    assert made.others[0].starts.where is Where.AHEAD


@pytest.mark.parametrize(
    ("text", "striker"), [("A truck ahead of us stopped and got hit by us.", EGO), ("We rear-ended a truck.", EGO)]
)
def test_what_is_read_is_settled_so(text: str, striker: Striker) -> None:
    contact = LearnedReader().read(text).ranked[0].situation.contact
    assert contact is not None and contact.striker is striker and contact.ego is None
