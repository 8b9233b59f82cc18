"""What a deed waits for: another that was done or goes on, or that the ego is near."""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING

from chatscene.build.naming import name_of
from chatscene.errors import NotBuilt
from chatscene.terms.situation import EGO, When
from chatscene.terms.vocabulary import Act

if TYPE_CHECKING:
    from chatscene.build.actor import Actor

_QUIET = frozenset((Act.STAND, Act.STOP))
_SEEN = {
    Act.STOP: "{who}.pose[3] < 0.1",
    Act.STAND: "{who}.pose[3] < 0.1",
    Act.BRAKE: "{who}.pose[3] < 3",
    Act.SET_OFF: "{who}.pose[3] > 0.5",
}
"""Deeds of somebody else that a plan can wait for, by what is seen of them."""


def when_of(actor: Actor, k: int, when: When, meanwhile: str) -> Iterator[str]:
    """The phases in which somebody waits for a deed of its own to be due.

    Args:
        actor: Who.
        k: The number of its deed.
        when: What it waits for.
        meanwhile: What it does until then.

    Raises:
        NotBuilt: What it waits for cannot be seen.
    """
    at = f"{actor.path}.does.{k}.when"
    for name, reference in (("after", when.after), ("during", when.during)):
        if reference is None:
            continue
        if condition := _seen(actor, k, name, reference):
            yield f"{meanwhile} until {condition}"
        actor.ledger.take(f"{at}.{name}")
    if when.ego_within is not None:
        low, high = when.ego_within.low, when.ego_within.high
        unit = when.ego_within.QUANTITY
        near = f"NEAR_{k}"
        least = low if low > 0 else high
        most = high if high < float("inf") else least
        of = "s" if unit == "duration" else "m"
        actor.numbers.measure(near, max(least, 0.0), most, of, "how near the ego is when it acts", f"{at}.ego_within")
        there = "secondsTo(egoRoute, ego, progressOn(egoRoute, self)[0])" if unit == "duration" else "gap(self, ego)"
        yield f"{meanwhile} until {there} < ${near}"


def _seen(actor: Actor, k: int, name: str, reference: str) -> str:
    """What shows that a deed of somebody is done, or goes on; empty for a deed of its own before this one."""
    who, _, _ = reference.partition(".")
    situation = actor.ledger.situation
    deed = situation.deed(reference)
    at = f"{actor.path}.does.{k}.when.{name}"
    if who == actor.one.id:
        if name == "after" and any(deed is earlier for earlier in actor.deeds[:k]):
            return ""  # its own deeds come one after the other
        raise NotBuilt(f"nothing builds yet: {at}: {reference}, of its own")
    if who == EGO and name == "during" and deed.act.row.lasting and len(situation.ego.does) == 1:
        return ""  # what the ego does all the time
    if deed.act not in _SEEN:
        raise NotBuilt(f"nothing builds yet: {at}: {reference}, which is {deed.act}")
    seen = _SEEN[deed.act].format(who=who if who == EGO else name_of(who))
    return f"{seen} and progressOn(egoRoute, ego)[0] > 4" if who == EGO and deed.act in _QUIET else seen
