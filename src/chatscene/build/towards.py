"""Deeds that are done to somebody named: who is meant in a plan, who stands behind whom, and how far from the ego."""

from __future__ import annotations

import re
from collections.abc import Sequence
from dataclasses import replace

from chatscene.build.ledger import Ledger
from chatscene.build.naming import name_of
from chatscene.build.numbers import RANGES
from chatscene.terms.situation import EGO, Deed, Other, Situation
from chatscene.terms.vocabulary import Act, Heads, Role, Tempo, Where, acts_of

FROM_BEHIND = acts_of(Heads.BEHIND, Heads.CLOSE, Heads.BY)
"""What is done to somebody by who is behind."""
_FARTHER = frozenset((Where.AHEAD, Where.AHEAD_BESIDE, Where.EXIT))
"""Places in which who stands farther from the ego has the others of its row behind it."""
_IN_ONE_LANE = frozenset((Where.AHEAD, Where.AHEAD_BESIDE, Where.BEHIND))
"""Where those who are farther away are hidden by who is nearer."""
_EGO = re.compile(r"\bego\b")


def done_to(deed: Deed) -> str:
    """The id of whom a deed is done to, who is the ego unless another is named."""
    return deed.done_to


def to_whom(text: str, deed: Deed) -> str:
    """A phase of a deed, done to whom it was said to be done."""
    return text if done_to(deed) == EGO else _EGO.sub(name_of(done_to(deed)), text)


def screens(one: Other, hidden: Other) -> bool:
    """Whether somebody can hide another by being nearer to the ego in one lane."""
    same = one.starts.where is hidden.starts.where and one.starts.side is hidden.starts.side
    return hidden.hidden_by == one.id and same and one.starts.where in _IN_ONE_LANE


def passes(one: Other, other: Other) -> bool:
    """Whether somebody passes another."""
    return any(deed.act is Act.OVERTAKE and deed.whom == other.id for deed in one.does)


def in_one_row(one: Other, other: Other) -> bool:
    """Whether two begin one behind the other: in one lane, or where one is beside others that it passes."""
    where, there = one.starts.where, other.starts.where
    return where is there or (where is Where.ONCOMING_IN_OUR_LANE and there is Where.ONCOMING)


def in_rows(situation: Situation) -> list[Other]:
    """All, in such an order that of those who share a place each is behind whom it follows, gets by, or hides.

    An ego that waits lets those go by who are not met: they come before who is.
    """
    others = situation.others
    waits = any(deed.act in _WAITS for deed in situation.ego.does)
    order = sorted(others, key=lambda one: waits and one.role is Role.ADVERSARY and _has_by(others, one))
    for one in others:
        if (hidden := next((other for other in order if screens(one, other)), None)) is not None:
            order.remove(hidden)
            order.insert(order.index(one) + 1, hidden)
    for one in others:
        for deed in one.does:
            other = next((other for other in order if other.id == deed.whom), None)
            if other is None or deed.act not in FROM_BEHIND or not in_one_row(one, other):
                continue
            first, then = (one, other) if one.starts.where in _FARTHER else (other, one)
            order.remove(then)
            order.insert(order.index(first) + 1, then)
    return order


def room_kept(one: Other, other: Other) -> float | None:
    """How far [m] two are apart, middle to middle, of whom one follows the other from the first; None if none does."""
    for who, whom in ((one, other), (other, one)):
        first = who.does[0] if who.does else None
        if first is None or first.act not in acts_of(Heads.BEHIND, Heads.CLOSE) or first.whom != whom.id:
            continue
        usual = RANGES["ROOM" if first.act is Act.FOLLOW else "GAP"][:2]
        said = first.distance
        room = usual if said is None else said.drawn(*usual)
        return 0.5 * (sum(room) + sum(each.kind.row.body.row.limits.length for each in (one, other)))
    return None


_WAITS = acts_of(Tempo.STANDS, Tempo.SETS_OFF, Tempo.WAITS)
_GO_BY = frozenset((Where.ONCOMING, Where.IN_ROUNDABOUT, Where.ROUNDABOUT_ENTRY))


def _has_by(others: Sequence[Other], one: Other) -> bool:
    """Whether others come from where somebody does who only go by."""
    place = (one.starts.where, one.starts.side)
    by = (other for other in others if other.role is Role.SUPPORTING and other.does)
    return one.starts.where in _GO_BY and any((other.starts.where, other.starts.side) == place for other in by)


def at_distance(ledger: Ledger, one: Other) -> Other:
    """Somebody at the distance at which the ego follows it from the first, if that was said."""
    for k, deed in enumerate(ledger.situation.ego.does):
        follows = deed.act is Act.FOLLOW and deed.whom in (one.id, None) and deed.distance is not None
        if follows and one.starts.distance in (None, deed.distance) and one.starts.where is Where.AHEAD:
            ledger.take(f"ego.does.{k}.distance")
            return replace(one, starts=replace(one.starts, distance=deed.distance))
    return one
