"""The texts from which the learned reader learns, each with what it tells as tokens."""

from __future__ import annotations

import json
import math
from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass, fields, is_dataclass, replace
from functools import cache
from itertools import groupby, pairwise
from pathlib import Path
from typing import Any, cast

from chatscene.read.by_model import situation_in
from chatscene.read.learned.edits import CHANGE, asked
from chatscene.read.learned.grammar import NAMES, grammar
from chatscene.read.learned.numbers import Form, same
from chatscene.read.learned.sequence import Step, path_of
from chatscene.read.learned.text import Read, prepared
from chatscene.read.quotes import spans_of
from chatscene.situations.faults import Malformed
from chatscene.situations.form import from_plain
from chatscene.situations.phrases import Voice
from chatscene.situations.words import facts_told, told
from chatscene.terms.amount import Amount
from chatscene.terms.reading import Verdict
from chatscene.terms.situation import Situation
from making.reader.sequence import steps_of


@dataclass(frozen=True, slots=True)
class Example:
    """A text to learn from.

    Attributes:
        read: The text.
        steps: What it tells.
        copied: Of each step the number of the amount that is copied, or -1.
        barred: Tokens of which it is not known whether they should stand there.
        words: Of each step the pieces of the text that say it; none where that is not known.
    """

    read: Read
    steps: tuple[Step, ...]
    copied: tuple[int, ...]
    barred: frozenset[int]
    words: tuple[tuple[int, ...], ...]


def example(
    text: str, verdict: Verdict, situation: Situation | None, shifts: Sequence[Amount] = (), begins: int = 0
) -> Example:
    """A text with what it tells; an amount that does not stand in the text is not learned.

    Args:
        text: The text.
        verdict: Whether it tells a situation.
        situation: What it tells.
        shifts: Amounts that an edit shifts: of what they become, the amount by which is copied.
        begins: Where the edit begins.

    Raises:
        ValueError: It tells more than is ever written.
    """
    read = prepared(text, begins or None)
    steps, copied, barred = list[Step](), list[int](), set[int]()
    number = grammar().number
    for step in steps_of(verdict, situation):
        if step.amount is None:
            steps.append(step)
            copied.append(-1)
            continue
        at = next((i for i, one in enumerate(read.amounts) if same(one.amount, step.amount)), None)
        if at is None:
            by = [other for one in shifts for other in _between(one, step.amount)]
            edits = (i for i, one in enumerate(read.amounts) if one.low >= begins and one.form is Form.PLAIN)
            at = next((i for i in edits if any(same(read.amounts[i].amount, one) for one in by)), None)
        if at is None:
            barred.add(number[steps.pop().token or ("", "")])
            copied.pop()
        else:
            steps.append(step)
            copied.append(at)
    quotes = quotes_of(situation) if situation is not None else {}
    words = tuple(_pieces(read, quotes, path_of(steps, at)) if step.place else () for at, step in enumerate(steps))
    return Example(read, tuple(steps), tuple(copied), frozenset(barred), words)


def _between(one: Amount, other: Amount) -> Iterator[Amount]:
    """How much one amount is more than another, or less."""
    if type(one) is type(other) and one.than_ego is other.than_ego and math.isfinite(by := abs(other.low - one.low)):
        yield type(one)(by, by)


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


def told_in(path: Path) -> Iterator[tuple[str, Verdict, Situation | None]]:
    """The texts of a file with the situation of each; none where it tells none.

    A row has a `situation`, or of a language model a `verdict` and a `situation`, or its `replies`, of which the last
    counts; and a `text`, or an `id` as ``reports/12`` for the thirteenth line of ``reports.jsonl`` in the same folder.
    A reply whose sides are not those of the text (left-hand traffic), or that is no situation, is left out. Rows with a
    `report` are its parts: what reaches from one of its conflicts to the next tells no single situation.
    """

    @cache
    def texts(name: str) -> list[str]:
        return [row["text"] for row in _rows(path.with_name(f"{name}.jsonl"))]

    for row in _rows(path):
        name, _, line = row.get("id", "").rpartition("/")
        text = row["text"] if "text" in row else texts(name)[int(line)]
        if "verdict" not in row and "replies" not in row:
            yield text, Verdict.SITUATION, from_plain(row["situation"])
            continue
        reply = row["replies"][-1] if "replies" in row else row
        verdict = Verdict(reply["verdict"])
        try:
            situation = situation_in(reply["situation"]) if verdict is Verdict.SITUATION else None
        except Malformed:
            continue
        if situation is None or not situation.evidence.mirrored:
            yield text, verdict, situation
    for text in _several(_rows(path)):
        yield text, Verdict.OUT_OF_REACH, None


def _several(rows: Iterable[Mapping[str, Any]]) -> Iterator[str]:
    """Of reports in their parts, what reaches from each conflict to the next."""
    for _, parts in groupby((row for row in rows if "report" in row), key=lambda row: row["report"]):
        report = list(parts)
        at = [i for i, row in enumerate(report) if row["verdict"] == Verdict.SITUATION]
        for first, last in pairwise(at):
            yield " ".join(row["text"] for row in report[first : last + 1])


def of_told(path: Path) -> Iterator[Example]:
    """The texts of a file with whole situations, to learn from; see `told_in`."""
    return (example(text, verdict, situation) for text, verdict, situation in told_in(path))


def of_edits(path: Path) -> Iterator[Example]:
    """Edits of situations with what becomes of these, as `chatscene.read.learned.edits` asks; in turn in each voice.

    A row has a `situation`, an `edit`, and what it is `after` that; none of what changes nothing.
    """
    for row in _rows(path):
        before = _as_told(from_plain(row["situation"]))
        after = from_plain(row["after"]) if "after" in row else before
        order = [one.id for one in before.others]
        there = {one.id: one for one in after.others}
        after = replace(after, others=tuple(there[name] for name in dict.fromkeys((*order, *there)) if name in there))
        text = asked(before, row["edit"])
        yield example(text, Verdict.SITUATION, after, tuple(_amounts(before)), text.rindex(CHANGE))


def _as_told(situation: Situation) -> Situation:
    """A situation whose others stand in the order in which they are told."""
    paths = [path.split(".") for path, _ in facts_told(situation)]
    order = list(dict.fromkeys(path[1] for path in paths if path[0] == "others"))
    return replace(situation, others=tuple(sorted(situation.others, key=lambda one: order.index(one.id))))


def _amounts(noun: object) -> Iterator[Amount]:
    """All amounts in a noun."""
    if isinstance(noun, Amount):
        yield noun
    elif isinstance(noun, tuple):
        for one in cast("tuple[object, ...]", noun):
            yield from _amounts(one)
    elif is_dataclass(noun):
        for field in fields(noun):
            yield from _amounts(getattr(noun, field.name))


def in_our_words(situations: Iterable[Situation]) -> Iterator[Example]:
    """Situations in our own words, in turn in each voice."""
    voices = tuple(Voice)
    for i, one in enumerate(situations):
        voice = voices[i % len(voices)]
        yield example(told(one, voice), Verdict.SITUATION, _as_told(one))


def situations_in(path: Path) -> Iterator[Situation]:
    """The situations of a file."""
    return (from_plain(row["situation"]) for row in _rows(path))


def _rows(path: Path) -> Iterator[dict[str, Any]]:
    for line in path.read_text(encoding="utf-8").splitlines():
        yield json.loads(line)
