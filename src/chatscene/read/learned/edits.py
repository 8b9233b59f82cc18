"""Edits in words: the situation at hand is told in our words, the edit behind it, and both are read together.

What the reader makes of the telling alone is compared with what it makes of both, fact by fact, each with its
probability. So an error that is in both changes nothing, and neither does what the reader is in doubt of in both.
"""

from __future__ import annotations

import math
import re
from collections import Counter, defaultdict
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from functools import lru_cache
from itertools import permutations

from chatscene.errors import EditRefused
from chatscene.read.kinds import is_named
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
from chatscene.terms.situation import Evidence, Other, Situation

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
EVEN = 0.5
"""From here on something is likelier than not."""
MEANT_BY = 0.5
"""An edit means a fact that is likelier by so much with it than without it."""

ONE_NUMBER = (Form.PLAIN, Form.BARE_KMH, Form.BARE_MPH)
"""Forms of an amount that is one number, by which something may change."""

Facts = Mapping[str, object]


@dataclass(frozen=True, slots=True)
class Step:
    """So much more or less of what nothing was said about, so that there is nothing to add it to."""

    by: Amount
    more: bool

    def __str__(self) -> str:
        """In words."""
        return f"{'+' if self.more else '-'}{self.by}"


@dataclass(frozen=True, slots=True)
class Change:
    """What an edit does to a fact.

    Attributes:
        now: What it is then, as it stands in a file; None for what is not said, and a `Step` from what was not.
        before: How likely that is without the edit, in [0, 1].
    """

    path: str
    now: object
    before: float
    after: float

    @property
    def is_meant(self) -> bool:
        """Whether the edit says so."""
        return self.after - self.before >= MEANT_BY

    def __str__(self) -> str:
        """In words."""
        return f"{self.path} is {'not said' if self.now is None else self.now} ({self.after:.0%})"


def asked(situation: Situation, edit: str) -> str:
    """What is read: a situation in our words, and the edit."""
    return _with_edit(_told(situation), edit)


def _with_edit(telling: str, edit: str) -> str:
    return f"{telling}{CHANGE}{' '.join(edit.split())}"


def likely_changes(situation: Situation, edit: str) -> tuple[Change, ...]:
    """The facts that are likelier another with an edit than without it, the surest first.

    Raises:
        EditRefused: The reader is lost in the situation, an amount of the edit gives no fact, or the likeliest way to
            read it takes away more than there is.
    """
    told = _told(situation)
    telling = prepared(told)
    begins = len(telling.text) + len(CHANGE)
    whole = prepared(_with_edit(told, edit), begins)
    alone, both = (ways_of(written_of(read, PACKAGED)) for read in (telling, whole))
    if min(sum(way.probability for way in ways) for ways in (alone, both)) < EVEN:
        raise EditRefused("this situation is too large to edit in words; change its file, or a fact with --set")
    read_alone = [(_facts(way, _names(way.situation, situation)), way.probability) for way in alone]
    was = _shares(read_alone)
    shifted = _of_whom_it_names(_with_steps(both, situation, whole.text, begins), read_alone[0][0], situation, edit)
    now = _shares([(facts, way.probability) for way, facts in shifted.items()])
    found = [
        Change(path, value, was.get(path, {None: 1.0}).get(value, 0.0), share)
        for path in {**now, **was}
        for value, share in now.get(path, {None: 1.0}).items()
    ]
    made = tuple(sorted((one for one in found if one.after > one.before), key=lambda one: one.before - one.after))
    if any(one.is_meant for one in made):
        _check_amounts(whole, tuple(shifted), begins)
    return made


def _of_whom_it_names(ways: dict[Way, Facts], before: Facts, situation: Situation, edit: str) -> dict[Way, Facts]:
    """The ways to read an edit that change nobody at hand whom it does not name, if it names somebody.

    Raises:
        EditRefused: Each way changes another.
    """
    named = [one for one in situation.others if is_named(one.kind, edit)]
    stay = tuple(f"others.{one.id}." for one in situation.others if one not in named)
    if not named or not stay:
        return ways
    kept = {path: value for path, value in before.items() if path.startswith(stay)}
    found = {
        way: facts
        for way, facts in ways.items()
        if {path: value for path, value in facts.items() if path.startswith(stay)} == kept
    }
    if not found:
        whom = " and ".join(one.id for one in named)
        raise EditRefused(f"not sure what that changes of {whom}; --set a fact, such as others.{named[0].id}.kind=bus")
    return found


def _told(situation: Situation) -> str:
    return told(replace(situation, evidence=Evidence(), about=""))


def _shares(ways: Sequence[tuple[Facts, float]]) -> dict[str, dict[object, float]]:
    """Of each fact how likely each value is, of all ways to read a text; None where it is not said."""
    total = sum(sure for _, sure in ways) or 1.0
    shares: dict[str, dict[object, float]] = defaultdict(lambda: defaultdict(float))
    for path in dict.fromkeys(path for facts, _ in ways for path in facts):
        for facts, sure in ways:
            shares[path][facts.get(path)] += sure / total
    return shares


def _facts(way: Way, names: Mapping[str, str]) -> dict[str, object]:
    """The facts of a way, by the ids at hand."""
    return dict(all_facts(renamed(way.situation, names)))


def _with_steps(ways: tuple[Way, ...], at_hand: Situation, text: str, begins: int) -> dict[Way, Facts]:
    """The facts of each way, by the ids at hand; amounts by which the edit shifts others are these others, shifted.

    A way that takes away more than there is cannot be what is meant, and is left out.
    """
    held, found = dict(all_facts(at_hand)), dict[Way, Facts]()
    for way in ways:
        names = _names(way.situation, at_hand)
        facts = _facts(way, names)
        try:
            for at, one in way.written.found:
                if one.form in ONE_NUMBER and (more := _comparative(text, one, begins)) is not None:
                    path = _at_hand(path_of(way.written.steps, at), names)
                    facts[path] = shifted(held.get(path), one.amount, more=more)
        except EditRefused:
            if way is ways[0]:
                raise
        else:
            found[way] = facts
    return found


def _at_hand(path: str, names: Mapping[str, str]) -> str:
    """The path of a fact by the ids at hand."""
    head, name, *rest = path.split(".")
    return ".".join((head, names[name], *rest)) if head == "others" and name in NAMES else path


def shifted(was: object, by: Amount, *, more: bool) -> object:
    """An amount that is so much more or less, as it stands in a file; a `Step` if there was none.

    Raises:
        EditRefused: It takes away more than there is.
    """
    if was is None:
        return Step(by, more)
    old, step = type(by).of(str(was)), by.low if more else -by.low
    opens = not old.than_ego and old.low <= 0.0  # at most so much
    low, high = old.low if opens else old.low + step, old.high + step
    if not old.than_ego and (high <= 0.0 or (low <= 0.0 and not opens)):
        raise EditRefused(f"{was} is too small to subtract {by}")
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


@lru_cache(maxsize=256)
def _said(one: Other) -> Counter[tuple[str, object]]:
    """The facts of a road user by the last name of their paths, however often."""
    facts = all_facts(Situation(others=(one,)))
    return Counter((path.rpartition(".")[2], value) for path, value in facts)


def _check_amounts(read: Read, ways: tuple[Way, ...], begins: int) -> None:
    """Hold an edit to its amounts with a unit: most of what it is read as has to have them."""
    total = sum(way.probability for way in ways)
    for one in read.amounts:
        if one.low < begins or one.form in (Form.BARE_KMH, Form.BARE_MPH):
            continue
        copied = (way for way in ways if any(_meet(one, found) for _, found in way.written.found))
        if sum(way.probability for way in copied) < EVEN * total:
            said = read.text[one.low : one.high]
            raise EditRefused(f"no fact changes by {said!r}; say what changes by it, or --set a fact")


def _meet(one: Found, other: Found) -> bool:
    return one.low < other.high and other.low < one.high


def _comparative(text: str, found: Found, begins: int) -> bool | None:
    """Whether an amount of the edit is so much more, or less; None if it is neither."""
    if found.low < begins:
        return None
    if (then := _THEN.match(text, found.high)) is not None:
        return then["less"] is None
    return _DOWN.search(text, begins) is None if _BY.search(text[begins : found.low]) else None
