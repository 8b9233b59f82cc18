"""A situation and its tokens are the same in two forms."""

from __future__ import annotations

from dataclasses import fields, is_dataclass, replace
from typing import Any, get_type_hints

import pytest
from hypothesis import given, settings

from chatscene.read.learned.grammar import BEGIN, BEGUN, END, NAMES, Sort, grammar, places
from chatscene.read.learned.sequence import situation_of, verdict_of
from chatscene.situations.faults import Malformed
from chatscene.terms.reading import Verdict
from chatscene.terms.situation import Other, Situation, Start
from chatscene.terms.vocabulary import Act, UserKind, Where, Word
from drawn import situations
from making.reader.sequence import steps_of, with_plain_names


def in_the_order_of_the_table(situation: Situation) -> Situation:
    """The same with what the road has in the order of its table."""
    node = next(node for node in places(grammar().nodes) if node.place == "road.has")
    has = tuple(sorted(situation.road.has, key=node.words.index))
    return replace(situation, road=replace(situation.road, has=has))


@settings(max_examples=20, deadline=None)
@given(situations())
def test_a_situation_comes_back_from_its_tokens(situation: Situation) -> None:
    steps = steps_of(Verdict.SITUATION, situation)
    assert situation_of(steps) == in_the_order_of_the_table(with_plain_names(situation))


@settings(max_examples=20, deadline=None)
@given(situations())
def test_the_grammar_allows_what_is_written(situation: Situation) -> None:
    made, place = grammar(), BEGUN
    for step in steps_of(Verdict.SITUATION, situation):
        if step.token is None:
            assert step.place in made.follow[place]
            assert isinstance(step.amount, made.amounts[step.place])
        else:
            assert made.next[place, made.number[step.token]] == step.place
        place = step.place
    assert place == END


def test_every_word_of_the_vocabulary_has_a_token() -> None:
    written = {word for _, word in grammar().tokens}
    tables = [hint for hint in _hints(Situation) if isinstance(hint, type) and issubclass(hint, Word)]
    assert len(tables) > 10
    for table in tables:
        assert {str(word) for word in table} - {"adversary"} <= written, table


def _hints(noun: type[Any]) -> list[Any]:
    found: list[Any] = []
    for hint in (get_type_hints(noun)[one.name] for one in fields(noun)):
        for part in (hint, *getattr(hint, "__args__", ())):
            found += [part, *(_hints(part) if is_dataclass(part) and isinstance(part, type) else ())]
    return found


def test_every_field_leads_to_the_end() -> None:
    follow = grammar().follow
    ends = {END}
    while more := {place for place, leads in follow.items() if place not in ends and ends & set(leads)}:
        ends |= more
    assert ends == set(follow)


def test_a_text_without_a_situation_is_one_token_and_the_end() -> None:
    steps = steps_of(Verdict.OUT_OF_REACH, None)
    assert [step.place for step in steps] == ["verdict.not", END]
    assert verdict_of(steps) is Verdict.OUT_OF_REACH


def test_others_are_called_by_letters_and_deeds_by_numbers() -> None:
    one = Other(id="truck2", kind=UserKind.TRUCK, starts=Start(where=Where.AHEAD))
    assert with_plain_names(Situation(others=(one,))).others[0].id == NAMES[0]


def test_more_others_than_letters_are_not_written() -> None:
    some = tuple(Other(id=f"x{i}", kind=UserKind.CAR, starts=Start(where=Where.AHEAD)) for i in range(len(NAMES) + 1))
    with pytest.raises(ValueError, match="others are too many"):
        with_plain_names(Situation(others=some))


def test_a_sequence_against_itself_is_no_situation() -> None:
    steps = steps_of(
        Verdict.SITUATION, Situation(others=(Other(id="A", kind=UserKind.CAR, starts=Start(where=Where.AHEAD)),))
    )
    side = next(node for node in places(grammar().nodes) if node.place == "others.starts.side")
    assert side.sort is Sort.WORDS
    odd = (*steps[:-1], replace(steps[1], place=side.place, token=(side.key, "left")), steps[-1])
    with pytest.raises(Malformed):
        situation_of(odd)


def test_the_first_token_is_that_before_all_others() -> None:
    assert grammar().tokens[0] == BEGIN
    assert ("Deed.act", str(Act.CUT_IN)) in grammar().tokens
