"""How a deed is done, by the words that stand at it: *brakes hard*, *suddenly crosses*."""

from __future__ import annotations

import re
from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from itertools import groupby

from chatscene.read.accounting import JOINS
from chatscene.situations.phrases import ACTS
from chatscene.terms.frame import Word
from chatscene.terms.situation import Deed, Situation
from chatscene.terms.vocabulary import Act, Manner

WORDS: Mapping[Manner, str] = {
    Manner.SUDDEN: r"sudden(?:ly)?|all of a sudden|abrupt(?:ly)?|unexpectedly|without (?:any )?warning|out of the blue",
    Manner.HARD: r"hard|sharply|heavily|violently|harshly|slam(?:s|med|ming)?|stamp(?:s|ed|ing)?|emergency",
    Manner.SLIGHT: r"gently|softly|lightly|slightly|smoothly|a little|a bit",
    Manner.FAST: r"fast|quickly|rapidly|at (?:high )?speed",
    Manner.SLOW: r"slowly",
}
"""What each manner is called."""
PACES = frozenset((Manner.FAST, Manner.SLOW))
"""Manners of a speed: of what has none they say nothing."""
_SAID = {manner: re.compile(rf"(?i)\b(?:{words})\b") for manner, words in WORDS.items()}
_DENIED = re.compile(r"(?i)(?:n['\u2019]t|\bnot|\bnever|\bwithout)(?: \w+)? *$")
ACTIONS = "actions"

Told = tuple[Word, str]
"""A word with the id of whom it tells."""


@dataclass(frozen=True, slots=True)
class Said:
    """A manner that a text says.

    Attributes:
        manner: Which.
        words: Its words.
        who: The id of whom it tells.
        act: The words of the act at which it stands.
        turn: Which of the acts of that one these are, from 0.
        turns: How many there are.
    """

    manner: Manner
    words: str
    who: str
    act: str
    turn: int
    turns: int


def with_manners_as_acts(words: Sequence[Told], text: str) -> tuple[Told, ...]:
    """Words, in which those for the manner of an act tell of that act and of whoever does it."""
    made = list(words)
    for _, first, last in _found(words, text):
        at = _act_at(words, text, first, last)
        if at is not None:
            for i in range(first, last + 1):
                made[i] = (replace(words[i][0], fact=ACTIONS, besides=""), words[at][1])
    return tuple(made)


def manners_said(words: Sequence[Told], text: str) -> Iterator[Said]:
    """Each manner that is said of an act of one of the others, of words in which manners tell of acts."""
    runs = [[i for i, _ in run] for key, run in groupby(enumerate(words), key=lambda one: _whose_act(one[1])) if key]
    found = tuple(_found(words, text))
    of_manners = {i for _, first, last in found for i in range(first, last + 1)}
    for manner, first, last in found:
        run = next((run for run in runs if first in run), None)
        if run is None:
            continue
        if all(first <= i <= last for i in run):  # it opens the sentence: the act comes behind who does it
            run = next((one for one in runs if one[0] > last and words[one[0]][1] == words[first][1]), run)
        who = words[run[0]][1]
        own = [one for one in runs if words[one[0]][1] == who and not of_manners.issuperset(one)]
        if run in own:
            start, end = words[run[0]][0].start, words[run[-1]][0].end
            said = text[words[first][0].start : words[last][0].end]
            yield Said(manner, said, who, text[start:end], own.index(run), len(own))


def in_manners(situation: Situation, said: Iterable[Said]) -> tuple[Situation, tuple[str, ...]]:
    """A situation in which each deed is done as is said of it, and what could be said of none."""
    lost: list[str] = []
    for one in said:
        who = next((other for other in situation.others if other.id == one.who), None)
        at = _deed_of(who.does, one) if who is not None else None
        if who is None or at is None:
            lost.append(f"{one.words}: of which deed was not said")
            continue
        if one.manner in PACES and "speed" not in who.does[at].act.row.takes:
            lost.append(f"{one.words}: {who.does[at].act} has no speed")
        elif who.does[at].manner is None:
            does = (*who.does[:at], replace(who.does[at], manner=one.manner), *who.does[at + 1 :])
            others = tuple(replace(other, does=does) if other is who else other for other in situation.others)
            situation = replace(situation, others=others)
    return situation, tuple(lost)


def _deed_of(does: Sequence[Deed], said: Said) -> int | None:
    """Of which deed something is said: the only one, the one that is named so, or that of the same turn."""
    if len(does) == 1:
        return 0
    named = [i for i, deed in enumerate(does) if _forms(deed.act).search(said.act)]
    if len(named) == 1:
        return named[0]
    return said.turn if len(does) == said.turns else None


def _forms(act: Act) -> re.Pattern[str]:
    """The forms of the verb of an act."""
    forms = re.match(r"\[(.*?)\]", ACTS[act].does)
    words = forms[1].replace("/", "|") if forms is not None else r"(?!)"
    return re.compile(rf"(?i)\b(?:{words})\b")


def _whose_act(one: Told) -> str:
    return one[1] if one[0].fact == ACTIONS else ""


def _found(words: Sequence[Told], text: str) -> Iterator[tuple[Manner, int, int]]:
    """Each manner that words say, with the first and the last of these."""
    for manner, pattern in _SAID.items():
        for match in pattern.finditer(text):
            at = [i for i, (one, _) in enumerate(words) if match.start() <= one.start and one.end <= match.end()]
            if at and not _DENIED.search(text[: match.start()]):
                yield manner, at[0], at[-1]


def _act_at(words: Sequence[Told], text: str, first: int, last: int) -> int | None:
    """Where the act stands of which a manner is said: in it, right behind, right before, or behind who does it."""
    for at in (first, last + 1, first - 1):
        if 0 <= at < len(words) and words[at][0].fact == ACTIONS:
            return at
    opens = not first or text[words[first - 1][0].end : words[first][0].start].strip() in (".", ";", ",")
    behind = range(last + 1, len(words)) if opens else ()
    for at in behind:
        word = words[at][0]
        if word.fact == ACTIONS:
            return at
        if word.fact not in ("adversary", "position") and word.besides != JOINS:
            return None
    return None
