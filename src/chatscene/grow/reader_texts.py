"""The texts from which the learned reader learns, each with what it tells as tokens, as far as that is known.

Some texts have a whole situation. Others have slots alone, which say nothing of numbers, contacts and the like: of
those texts no token is learned that slots never make, neither to write it nor to leave it out.
"""

from __future__ import annotations

import json
from collections.abc import Iterable, Iterator, Mapping
from dataclasses import dataclass, replace
from enum import IntEnum
from pathlib import Path
from typing import Any

from pydantic import TypeAdapter

from chatscene.interpret.situation_of import in_a_situation
from chatscene.read.by_model import situation_in
from chatscene.read.learned.grammar import NAMES, grammar
from chatscene.read.learned.numbers import same
from chatscene.read.learned.sequence import Step, path_of, steps_of
from chatscene.read.learned.text import Read, prepared
from chatscene.read.quotes import spans_of
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
        words: Of each step the pieces of the text that say it; none where that is not known.
    """

    read: Read
    known: Known
    steps: tuple[Step, ...]
    copied: tuple[int, ...]
    barred: frozenset[int]
    words: tuple[tuple[int, ...], ...]


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
    quotes = quotes_of(situation) if situation is not None else {}
    words = tuple(_pieces(read, quotes, path_of(steps, at)) if step.place else () for at, step in enumerate(steps))
    return Example(read, known, tuple(steps), tuple(copied), frozenset(barred), words)


def quotes_of(situation: Situation) -> Mapping[str, str]:
    """The words behind each fact, by its path with the plain name of who it is about."""
    names = {one.id: name for one, name in zip(situation.others, NAMES, strict=False)}
    plain: dict[str, str] = {}
    for path, words in situation.evidence.quoted.items():
        steps = path.split(".")
        if steps[0] == "others" and len(steps) > 1:
            steps[1] = names.get(steps[1], steps[1])
        plain[".".join(steps)] = words
    return plain


def _pieces(read: Read, quotes: Mapping[str, str], path: str) -> tuple[int, ...]:
    """The pieces of the words that are quoted for a fact, or else for the least whole that it is part of."""
    steps = path.split(".")
    wholes = (".".join(steps[:i]) for i in range(len(steps), 0, -1))
    words = next((quotes[whole] for whole in wholes if whole in quotes), "")
    spans = spans_of(words, read.text) if words else []
    at = (i for i, (low, high) in enumerate(read.where, 1) if any(low < end and high > start for start, end in spans))
    return tuple(at)


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


def of_filled(path: Path) -> Iterator[Example]:
    """The texts of others in the same folder with the situation that a language model filled from each.

    A row has an `id`, as ``reports/12`` for the thirteenth line of ``reports.jsonl``, a `verdict` and a `situation`.
    """
    texts: dict[str, list[str]] = {}
    for row in _rows(path):
        name, _, line = row["id"].partition("/")
        if name not in texts:
            texts[name] = [one["text"] for one in _rows(path.with_name(f"{name}.jsonl"))]
        verdict = Verdict(row["verdict"])
        situation = situation_in(row["situation"]) if verdict is Verdict.SITUATION else None
        if situation is None or not situation.evidence.mirrored:  # its sides are not those of the text
            yield example(texts[name][int(line)], Known.WHOLE, verdict, situation)


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
