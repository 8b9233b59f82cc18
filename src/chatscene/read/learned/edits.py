"""Edits in words: the situation at hand is told in our words, the edit behind it, and both are read together.

What the reader makes of the telling alone is compared with what it makes of both, fact by fact, each with its
probability. So an error that is in both changes nothing, and neither does what the reader is in doubt of in both.
"""

from __future__ import annotations

import math
import re
from collections import Counter, defaultdict
from collections.abc import Iterator, Mapping
from dataclasses import dataclass, replace
from itertools import permutations
from pathlib import Path

from chatscene.errors import EditRefused
from chatscene.read.learned.grammar import NAMES
from chatscene.read.learned.numbers import Form, Found
from chatscene.read.learned.reader import Way, ways_of, written_of
from chatscene.read.learned.sequence import path_of
from chatscene.read.learned.text import Read, prepared
from chatscene.read.learned.weights import PACKAGED
from chatscene.situations.facts import all_facts
from chatscene.situations.renamed import renamed
from chatscene.situations.words import told
from chatscene.terms.amount import Amount
from chatscene.terms.situation import Evidence, Situation

CHANGE = " Change: "
"""Stands between the telling of a situation and the edit."""
_LESS = "slower|less|fewer|closer|nearer|earlier|sooner|softer|gentler|shorter|lower|smaller"
_MORE = "faster|quicker|more|further|farther|later|harder|longer|higher|bigger"
_THEN = re.compile(rf"(?i)[\s-]*(?:(?P<less>{_LESS})|(?:{_MORE}))\b(?! than)")
"""Behind an amount: it is by so much that something changes."""
_BY = re.compile(r"(?i)\b(?:by|another|(?:an )?extra)\s+$")
"""Before such an amount."""
_DOWN = re.compile(rf"(?i)\b(?:slow|down|reduc\w+|decreas\w+|cut|shorten\w*|{_LESS})\b")
MOST = 5
"""Others that are compared in every order."""
LIKELIER = 0.5
"""By how much what an edit comes to is likelier with it than without it."""

ALONE = (Form.PLAIN, Form.BARE_KMH, Form.BARE_MPH)
"""Forms of an amount by which something may change."""

Facts = Mapping[str, object]


@dataclass(frozen=True, slots=True)
class Change:
    """What an edit does to a fact.

    Attributes:
        path: Of the fact, by the ids at hand.
        now: What it is then, as it stands in a file; None for what is not said.
        before: How likely that is without the edit, in [0, 1].
        after: How likely it is with it.
    """

    path: str
    now: object
    before: float
    after: float

    @property
    def is_meant(self) -> bool:
        """Whether the edit says so."""
        return self.after - self.before >= LIKELIER

    def __str__(self) -> str:
        """In words."""
        return f"{self.path} is {'not said' if self.now is None else self.now} ({self.after:.0%})"


def asked(situation: Situation, edit: str) -> str:
    """What is read: a situation in our words, and the edit."""
    return f"{_told(situation)}{CHANGE}{' '.join(edit.split())}"


def changes(situation: Situation, edit: str, weights: Path = PACKAGED) -> tuple[Change, ...]:
    """The facts that are likelier another with an edit than without it, the surest first.

    Raises:
        EditRefused: The reader is lost in the situation, or an amount of the edit gives no fact.
    """
    telling, whole = prepared(_told(situation)), prepared(asked(situation, edit))
    begins = len(telling.text) + len(CHANGE)
    alone, both = (ways_of(written_of(read, weights)) for read in (telling, whole))
    if min(sum(way.probability for way in ways) for ways in (alone, both)) < LIKELIER:
        raise EditRefused("this situation is more than words can change; change its file, or a fact with --set")
    was = _shares([(_facts(way, situation, telling, len(telling.text)), way.probability) for way in alone])
    now = _shares([(_facts(way, situation, whole, begins), way.probability) for way in both])
    found = [
        Change(path, value, was.get(path, {None: 1.0}).get(value, 0.0), share)
        for path in {**now, **was}
        for value, share in now.get(path, {None: 1.0}).items()
    ]
    made = tuple(sorted((one for one in found if one.after > one.before), key=lambda one: one.before - one.after))
    if any(one.is_meant for one in made):
        _check_amounts(whole, both, begins)
    return made


def _told(situation: Situation) -> str:
    return told(replace(situation, evidence=Evidence(), about=""))


def _shares(ways: list[tuple[Facts, float]]) -> dict[str, dict[object, float]]:
    """Of each fact how likely each value is, of all ways to read a text; None where it is not said."""
    total = sum(sure for _, sure in ways) or 1.0
    shares: dict[str, dict[object, float]] = defaultdict(lambda: defaultdict(float))
    for path in dict.fromkeys(path for facts, _ in ways for path in facts):
        for facts, sure in ways:
            shares[path][facts.get(path)] += sure / total
    return shares


def _facts(way: Way, at_hand: Situation, read: Read, begins: int) -> Facts:
    """The facts of a way, by the ids at hand; amounts by which the edit shifts others are these others, shifted.

    Raises:
        EditRefused: There is no such amount to shift.
    """
    names = _names(way.situation, at_hand)
    facts, held = dict(all_facts(renamed(way.situation, names))), dict(all_facts(at_hand))
    for at, found in way.written.found:
        more = _comparative(read.text, found, begins) if found.form in ALONE else None
        if more is None:
            continue
        path = path_of(way.written.steps, at)
        head, name, *rest = path.split(".")
        path = ".".join((head, names[name], *rest)) if head == "others" and name in NAMES else path
        facts[path] = shifted(held.get(path), found.amount, more=more)
    return facts


def shifted(was: object, by: Amount, *, more: bool) -> object:
    """An amount that is so much more or less, as it stands in a file; with a sign if there was none."""
    if was is None:
        return f"{'+' if more else '-'}{by}"
    old, step = type(by).of(str(was)), by.low if more else -by.low
    opens = not old.than_ego and old.low <= 0.0  # at most so much
    low, high = old.low if opens else old.low + step, old.high + step
    if not old.than_ego and (high <= 0.0 or (low <= 0.0 and not opens)):
        raise EditRefused(f"nothing is left of {was} if {by} are taken away")
    made = replace(old, low=low, high=high)
    for unit, scale in (
        type(by).UNITS.items() if made.exact and not made.than_ego else ()
    ):  # a sum is rarely short to the bit
        said = f"{made.low / scale:.6g} {unit}"
        if unit and math.isclose(type(by).of(said).low, made.low, rel_tol=1e-9):
            return said
    return str(made)


def _names(read: Situation, at_hand: Situation) -> dict[str, str]:
    """The ids at hand of those who are read, each of the one that it is most like; others have new ones."""
    ours, theirs = read.others, at_hand.others
    alike = [[(_said(one) & _said(other)).total() for other in theirs] for one in ours]
    best = max(_pairings(len(ours), len(theirs)), key=lambda pairs: sum(alike[i][k] for i, k in pairs))
    names = {ours[i].id: theirs[k].id for i, k in best}
    free = (name for name in "ABCDEFGHIJKLMNOPQRSTUVWXYZ" if name not in {one.id for one in theirs})
    return {one.id: names.get(one.id) or next(free) for one in ours}


def _pairings(some: int, others: int) -> Iterator[tuple[tuple[int, int], ...]]:
    """Each way to pair as many as there are of both, in their order first."""
    few, many = sorted((some, others))
    orders = permutations(range(many), few) if many <= MOST else iter((tuple(range(few)),))
    for order in orders:
        yield tuple((i, k) if some <= others else (k, i) for i, k in enumerate(order))


def _said(one: object) -> Counter[tuple[str, object]]:
    """The facts of a road user by the last name of their paths, however often."""
    alone = Situation(others=(one,))  # type: ignore[arg-type]
    return Counter((path.rpartition(".")[2], value) for path, value in all_facts(alone))


def _check_amounts(read: Read, ways: tuple[Way, ...], begins: int) -> None:
    """Hold an edit to its amounts with a unit: most of what it is read as has to have them.

    Raises:
        EditRefused: One gives no fact.
    """
    total = sum(way.probability for way in ways)
    for one in read.amounts:
        if one.low < begins or one.form in (Form.BARE_KMH, Form.BARE_MPH):
            continue
        copied = (way for way in ways if any(_meet(one, found) for _, found in way.written.found))
        if sum(way.probability for way in copied) < LIKELIER * total:
            said = read.text[one.low : one.high]
            raise EditRefused(f"no fact changes by {said!r}; say what it is of, or --set a fact")


def _meet(one: Found, other: Found) -> bool:
    return one.low < other.high and other.low < one.high


def _comparative(text: str, found: Found, begins: int) -> bool | None:
    """Whether an amount of the edit is so much more, or less; None if it is neither."""
    if found.low < begins:
        return None
    if (then := _THEN.match(text, found.high)) is not None:
        return then["less"] is None
    return _DOWN.search(text, begins) is None if _BY.search(text[begins : found.low]) else None
