"""What is left of a situation if some of it is left open: others, what the ego does, and last deeds."""

from __future__ import annotations

import re
from collections.abc import Iterable, Iterator
from dataclasses import replace
from itertools import combinations

from chatscene.situations.naming import named_by
from chatscene.situations.words import told
from chatscene.terms.situation import EGO, Deed, Situation
from chatscene.terms.vocabulary import PLAIN, Role

MOST = 4
"""Others of which some are left open; of more nobody is."""
_LAST = 2
"""Last deeds that are left open."""
_SENTENCE = re.compile(r"(?<=[.!?])\s+")


def parts_of(situation: Situation) -> tuple[Situation, ...]:
    """A situation and what is left of it, the fullest first; in each somebody meets the ego.

    Nobody is left open who somebody else is said to do something to, to wait for, or to be hidden by.
    """
    begun = list(_with_fewer(situation))
    found = dict.fromkeys(begun)
    for _ in range(_LAST):
        begun = [shorter for one in begun for shorter in _with_shorter(one)]
        found |= dict.fromkeys(begun)
    return tuple(sorted(found, key=fullness, reverse=True))


def fullness(situation: Situation) -> int:
    """How much a situation tells, to be compared with what is left of it."""
    deeds = [deed for _, does in situation.everybody() for deed in does if deed.act not in PLAIN]
    return 2 * (len(situation.others) + len(deeds)) + (situation.contact is not None)


def left_open(part: Situation, whole: Situation) -> tuple[str, ...]:
    """The sentences of a situation that are not those of a part of it."""
    kept = _SENTENCE.split(told(part))
    return tuple(one for one in _SENTENCE.split(told(whole)) if one not in kept)


def _with_fewer(situation: Situation) -> Iterator[Situation]:
    """With fewer others, and without what the ego does."""
    names = [one.id for one in situation.others]
    for many in range(len(names), 0, -1) if len(names) <= MOST else (len(names),):
        for kept in combinations(names, many):
            others = tuple(one for one in situation.others if one.id in kept)
            hidden = {one.hidden_by for one in others}
            idle = any(one.role is Role.HIDES and one.id not in hidden for one in others)
            named = (hidden | _named_by(deed for one in others for deed in one.does)) - {None}
            made = replace(situation, others=others)
            contact = made.contact
            if not named <= {*kept, EGO} or not made.adversaries or (idle and many < len(names)):
                continue
            if contact is not None and contact.whom not in (None, *kept):
                made = replace(made, contact=None)
            if _named_by(situation.ego.does) <= {*kept, EGO}:
                yield made
            if situation.ego.does and not _waited_for(made, EGO, 0):
                yield replace(made, ego=replace(made.ego, does=()))


def _with_shorter(situation: Situation) -> Iterator[Situation]:
    """Without the last deed of somebody who does something before it."""
    for i, one in enumerate(situation.others):
        last = len(one.does) - 1
        before = [deed for deed in one.does[:last] if deed.act not in PLAIN]
        if before and not _waited_for(situation, one.id, last):
            shorter = replace(one, does=one.does[:last])
            yield replace(situation, others=(*situation.others[:i], shorter, *situation.others[i + 1 :]))


def _named_by(does: Iterable[Deed]) -> frozenset[str | None]:
    return frozenset(name for deed in does for name in named_by(deed))


def _waited_for(situation: Situation, who: str, first: int) -> bool:
    """Whether some deed waits for one of somebody's, from a number on."""
    whens = [deed.when for _, does in situation.everybody() for deed in does if deed.when is not None]
    waited = [name for when in whens for name in (when.after, when.during) if name is not None]
    return any(name.partition(".")[0] == who and situation.number_of(name) >= first for name in waited)
