"""The room that the ego keeps by what was said of it: others are placed so that it has that."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace

from chatscene.build.ledger import Ledger
from chatscene.terms.amount import Length
from chatscene.terms.situation import EGO, Deed, Lateral, Other, Situation
from chatscene.terms.vocabulary import Act, Role, Where

_PASSED = (Where.AHEAD, Where.KERB, Where.AHEAD_BESIDE, Where.ONCOMING_IN_OUR_LANE)


def as_kept(situation: Situation, speed: float) -> Situation:
    """The same; whom the ego follows at a distance begins so far ahead, and whom it passes is so far aside of it.

    A distance that was said as a time is how far who follows goes in that.

    Args:
        situation: What was said.
        speed: What the ego drives at [m/s].
    """
    others = [replace(one, does=tuple(_in_metres(deed, speed) for deed in one.does)) for one in situation.others]
    for deed in situation.ego.does:
        kept = _in_metres(deed, speed)
        if kept.act is Act.FOLLOW and kept.distance is not None:
            others = [_at(one, kept.distance) if one.id == followed(situation, deed) else one for one in others]
        elif (room := deed.lateral) is not None and room.clearance is not None and deed.act is Act.GO_ALONG:
            others = [_aside(one, room) if one.id == _passed(situation) else one for one in others]
    return replace(situation, others=tuple(others))


def take_kept(ledger: Ledger) -> None:
    """Take what was said of the room that the ego keeps, and what was said as a time."""
    situation = ledger.situation
    for name, deeds in situation.everybody() if ledger.told is None else ledger.told.everybody():
        for k, deed in enumerate(deeds):
            at = f"ego.does.{k}" if name == EGO else f"others.{name}.does.{k}"
            ledger.take(*_kept(situation, name, deed, at))
    if any(deed.act is Act.FOLLOW and _amount(deed) is not None for deed in situation.ego.does):
        ledger.assume("the ego's driver chooses the gap that it then keeps")


def _kept(situation: Situation, name: str, deed: Deed, at: str) -> Iterator[str]:
    if deed.act is Act.FOLLOW and name == EGO and followed(situation, deed):
        yield from (f"{at}.distance", f"{at}.time")
    elif deed.act is Act.FOLLOW and name != EGO and deed.distance is None:
        if situation[name].starts.where is not Where.BEHIND and deed.whom in (None, EGO):
            return  # who is not behind it, and keeps no distance that is built
        yield f"{at}.time"
    elif deed.act is Act.GO_ALONG and deed.lateral is not None and name == EGO and _passed(situation):
        yield f"{at}.lateral.clearance"


def _amount(deed: Deed) -> object:
    return deed.distance or deed.time


def _in_metres(deed: Deed, speed: float) -> Deed:
    """A deed whose distance was said as a time, as a length."""
    if deed.act is not Act.FOLLOW or deed.time is None or deed.distance is not None:
        return deed
    return replace(deed, distance=Length(deed.time.low * speed, deed.time.high * speed), time=None)


def followed(situation: Situation, deed: Deed) -> str:
    """The id of whom the ego follows; empty if there is nobody before it."""
    ahead = [one.id for one in situation.others if one.starts.where is Where.AHEAD and one.role is not Role.HIDES]
    return deed.whom if deed.whom in ahead else next(iter(ahead), "")


def _passed(situation: Situation) -> str:
    """The id of whom the ego passes: who stands, and else who is first; empty if there is nobody."""
    there = [one for one in situation.others if one.starts.where in _PASSED]
    stands = [one.id for one in there if all(deed.act is Act.STAND for deed in one.does)]
    return next(iter((*stands, *(one.id for one in there))), "")


def _at(one: Other, distance: Length) -> Other:
    return one if one.starts.distance is not None else replace(one, starts=replace(one.starts, distance=distance))


def _aside(one: Other, room: Lateral) -> Other:
    return one if one.starts.lateral is not None else replace(one, starts=replace(one.starts, lateral=room))
