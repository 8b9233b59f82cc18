"""The texts from which the learned reader learns, each with what it tells as tokens, as far as that is known.

Some texts have a whole situation. Others have slots alone, which say nothing of numbers, contacts and the like: of
those texts no token is learned that slots never make, neither to write it nor to leave it out.
"""

from __future__ import annotations

import json
from collections.abc import Iterable, Iterator
from dataclasses import dataclass, replace
from enum import IntEnum
from pathlib import Path
from typing import Any

from pydantic import TypeAdapter

from chatscene.interpret.situation_of import in_a_situation
from chatscene.read.by_model import situation_in
from chatscene.read.learned.grammar import grammar
from chatscene.read.learned.numbers import same
from chatscene.read.learned.sequence import Step, steps_of
from chatscene.read.learned.text import Read, prepared
from chatscene.situations.check import faults_of
from chatscene.situations.faults import Malformed
from chatscene.situations.form import from_plain
from chatscene.situations.phrases import Voice
from chatscene.situations.words import told
from chatscene.terms.conclusions import concluded
from chatscene.terms.reading import Verdict
from chatscene.terms.scenario import Slots
from chatscene.terms.situation import Situation
from chatscene.terms.surroundings import Surroundings

_SLOTS = TypeAdapter(Slots)


class Known(IntEnum):
    """What is known of what a text tells."""

    WHOLE = 0
    SLOTS = 1


@dataclass(frozen=True, slots=True)
class Example:
    """A text to learn from.

    Attributes:
        read: The text.
        known: What is known of what it tells.
        steps: What it tells.
        copied: Of each step the number of the amount that is copied, or -1.
        barred: Tokens of which it is not known whether they should stand there.
    """

    read: Read
    known: Known
    steps: tuple[Step, ...]
    copied: tuple[int, ...]
    barred: frozenset[int]


def example(text: str, known: Known, verdict: Verdict, situation: Situation | None) -> Example:
    """A text with what it tells; an amount that does not stand in the text is not learned.

    Raises:
        ValueError: It tells more than is ever written.
    """
    read = prepared(text)
    steps, copied, barred = list[Step](), list[int](), set[int]()
    number = grammar().number
    for step in steps_of(verdict, situation):
        if step.amount is None:
            steps.append(step)
            copied.append(-1)
            continue
        at = next((i for i, one in enumerate(read.amounts) if same(one.amount, step.amount)), None)
        if at is None:
            barred.add(number[steps.pop().token or ("", "")])
            copied.pop()
        else:
            steps.append(step)
            copied.append(at)
    return Example(read, known, tuple(steps), tuple(copied), frozenset(barred))


def of_slots(path: Path) -> Iterator[Example]:
    """The texts of a file that are labelled with slots."""
    for row in _rows(path):
        situation = None
        if row.get("in_scope", True):
            slots = _SLOTS.validate_python(row.get("slots") or {})
            situation = in_a_situation(concluded(slots), (), Surroundings())
            if any(faults_of(situation)):
                continue
        verdict = Verdict.SITUATION if situation is not None else Verdict.OUT_OF_REACH
        yield example(row["text"], Known.SLOTS, verdict, situation)


def of_replies(path: Path) -> Iterator[Example]:
    """The texts of a file with the replies of a language model, of which the last counts."""
    for row in _rows(path):
        reply = row["replies"][-1]
        try:
            situation = situation_in(reply["situation"]) if reply["verdict"] == Verdict.SITUATION else None
        except Malformed:
            continue
        if situation is None or not situation.evidence.mirrored:  # its sides are not those of the text
            yield example(row["text"], Known.WHOLE, Verdict(reply["verdict"]), situation)


def of_situations(path: Path, *, in_words: bool) -> Iterator[Example]:
    """The situations of a file with their texts, or in our own words, in turn in each voice."""
    voices = tuple(Voice)
    for i, row in enumerate(_rows(path)):
        situation = from_plain(row["situation"])
        text = told(situation, voices[i % len(voices)]) if in_words else row["text"]
        yield example(text, Known.WHOLE, Verdict.SITUATION, situation)


def with_open_ends(examples: Iterable[Example]) -> tuple[Example, ...]:
    """The same, those with slots alone without what slots never say."""
    several = tuple(examples)
    number = grammar().number
    said = {number[step.token] for one in several if one.known is Known.SLOTS for step in one.steps if step.token}
    never = frozenset(range(len(grammar().tokens))) - said
    return tuple(replace(one, barred=one.barred | never) if one.known is Known.SLOTS else one for one in several)


def _rows(path: Path) -> Iterator[dict[str, Any]]:
    for line in path.read_text(encoding="utf-8").splitlines():
        yield json.loads(line)
