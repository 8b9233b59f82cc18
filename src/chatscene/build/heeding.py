"""Who drives along does not drive through others: it brakes for who comes into its way or stands there."""

from __future__ import annotations

import re
from collections.abc import Iterator
from typing import TYPE_CHECKING

from chatscene.build.asked import SOME, Meets
from chatscene.build.naming import name_of
from chatscene.terms.actors import LIMITS, PROPS, Limits
from chatscene.terms.situation import EGO, Other
from chatscene.terms.vocabulary import Role, Where
from chatscene.world.places import FOLLOWING_BRAKE, FOLLOWING_CORRIDOR, STANDSTILL_GAP

if TYPE_CHECKING:
    from chatscene.build.actor import Actor

HARD, FULL = 0.5, 0.8  # of its brakes, with which somebody can stop for whom it brakes; of who keeps close to the ego
_ALONG = (Meets.ALONG, Meets.KERB)  # who comes from the kerb goes along then
_NEVER_BEFORE = frozenset((Where.BEHIND, Where.BEHIND_BESIDE, Where.ONCOMING))
_ENDLESS = re.compile(r"^(?:DrivePath\(([^,]+), ([^,()]+)\)|PaceOnPath\(([^,]+), .*\))$")


def heeds(actor: Actor, texts: tuple[str, ...]) -> tuple[str, ...]:
    """The phases of somebody who goes along: the last ends where it must brake for another than the ego in its way.

    From then on it drives as one who keeps a distance.
    """
    last = _ENDLESS.match(texts[-1]) if texts else None
    if last is None or actor.stand.meets not in _ALONG or actor.walks:
        return texts
    line, speed = last[1] or last[3], last[2] or "$SPEED"
    before = [name for other in _may_be_before(actor) for name in _names(other)]
    if not before:
        return texts
    ends = " or ".join(_in_the_way(actor, line, *one, keeps=last[3] is not None) for one in before)
    return (*texts[:-1], f"{texts[-1]} until {ends}", f"FollowTraffic({line}, {speed})")


def _may_be_before(actor: Actor) -> Iterator[Other]:
    """Those who can come to be before somebody."""
    own = actor.one
    for other in actor.ledger.situation.others:
        named = any(deed.whom == other.id for deed in own.does)
        behind = other.starts.where in _NEVER_BEFORE or any(deed.whom == own.id for deed in other.does)
        if other.id != own.id and other.role is not Role.HIDES and not (behind or named):
            yield other


def _names(other: Other) -> Iterator[tuple[str, Limits]]:
    """The name of each of it in the program, and how large it is."""
    limits = LIMITS.get(other.kind.scenic) or PROPS[other.kind.scenic]
    for n in range(other.count or SOME):
        yield name_of(other.id) + (f"_{n}" if n else ""), limits


def _in_the_way(actor: Actor, line: str, name: str, limits: Limits, *, keeps: bool) -> str:
    """When somebody must brake for another who is before it.

    Args:
        actor: Who.
        line: Along which it goes.
        name: The other.
        limits: How large that is.
        keeps: Whether it keeps a distance to the ego; else it goes on for as long as the ego is between.
    """
    far = f"headway({line}, self, {name})"
    room = 0.5 * (actor.limits.length + limits.length) + STANDSTILL_GAP
    hard = 2.0 * max(FOLLOWING_BRAKE, (FULL if keeps else HARD) * actor.limits.brake)
    faster = f"self.pose[3] * self.pose[3] - {name}.pose[3] * {name}.pose[3] > {hard:.3g} * ({far} - {room:.3g})"
    aside = f"abs(offsetFrom({line}, {name})) < {FOLLOWING_CORRIDOR + 0.5 * limits.width:.3g}"
    ego = f"headway({line}, self, {EGO})"
    between = "" if keeps else f" and not ({ego} > 0 and {ego} < {far})"
    return f"({far} > 0 and {faster} and {aside}{between})"
