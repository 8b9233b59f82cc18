"""Who leaves its line to a side: to which, on which line it then goes on, and whom it swerves round."""

from __future__ import annotations

import math
import re
from typing import TYPE_CHECKING

from chatscene.build.asked import Meets, stands_first, stops_ahead
from chatscene.build.contact import touches
from chatscene.build.naming import name_of
from chatscene.build.place import NEXT_LANE
from chatscene.build.relations import grip_of
from chatscene.build.restated import untimed
from chatscene.terms.situation import EGO, Other
from chatscene.terms.vocabulary import (
    COMES_IN,
    LETS_GO,
    LOSES,
    SIDEWAYS,
    Act,
    Facing,
    Heads,
    Part,
    Side,
    Striker,
    Where,
    acts_of,
)

if TYPE_CHECKING:
    from chatscene.build.actor import Actor

CLEAR = 0.4  # [m] at least between two of whom one swerves round the other
BY = (0.3, 0.8)  # [m] between who goes by the ego and the ego, from and to
GRAZES = (-0.14, -0.06)  # [m] the same, of who touches a side of the ego
COMES_ASIDE_AT = 3.5  # [s] before they touch that it is aside
_ON_A_SIDE = frozenset((Part.LEFT, Part.RIGHT, Part.LEFT_FRONT, Part.RIGHT_FRONT))
GOES_BY_AT = 2.0  # [s] before they would touch that it leaves the ego's line
_BESIDE_ROAD = frozenset((Where.KERB, Where.ROADSIDE, Where.DRIVEWAY, Where.BUS_BAY, Where.CROSSING))
_TURNS = acts_of(Heads.ROUND)
_DRIVES = re.compile(r"^DrivePath\((.+), ([^,]+)\)$")
SWERVES_AT = 1.0  # [s] before whom it swerves round somebody does, where the road holds
NEAR, SLOWER = 2.0, 0.7  # [m] before whom it swerves round; of the speed that one then has


def avoids(actor: Actor, k: int) -> Other | None:
    """Who stops or stands in the ego's lane, if somebody there swerves round that."""
    here = actor.one
    swerves = actor.deeds[k].act is Act.SWERVE and here.starts.where is Where.AHEAD
    if not swerves or actor.stand.meets is not Meets.ALONG:
        return None
    others = (one for one in actor.ledger.situation.others if one.id != here.id and one.starts.where is Where.AHEAD)
    there = [one for one in others if stops_ahead(one) or stands_first(one)]
    answers = answered_by(actor, k)
    if answers and answers.isdisjoint(one.id for one in there):
        return None  # it swerves for what somebody else does
    return next((one for one in there if one.id == actor.deeds[k].whom), next(iter(there), None))


def answered_by(actor: Actor, k: int) -> frozenset[str]:
    """For whose deeds somebody does its k-th, by ids; the ego's count for nobody, nor what is let go and lies there."""
    when = actor.deeds[k].when
    named = [name for name in (when.after, when.during) if name is not None] if when is not None else []
    does = (name for name in named if not name.startswith(EGO) and actor.ledger.situation.deed(name).act not in LETS_GO)
    return frozenset(name.partition(".")[0] for name in does) - {actor.one.id}


def goes_round(actor: Actor, k: int) -> str:
    """When somebody is so near to whom it goes round by its k-th deed that it must; empty of who goes round nobody."""
    deed = actor.deeds[k]
    if (before := avoids(actor, k)) is not None:
        actor.ledger.take(*(f"{actor.path}.does.{k}.when.{name}" for name in ("after", "during")))
        return must_avoid(actor, before)
    named = deed.whom not in (None, EGO, actor.one.id)
    if not named or deed.act not in SIDEWAYS or deed.act.row.whom:
        return ""
    if deed.when is not None:
        actor.ledger.assume(untimed(actor.one, deed))
        return ""
    one = actor.ledger.situation[str(deed.whom)]
    room = 0.5 * (actor.limits.length + _across(one)) + NEAR
    return f"gap(self, {name_of(one.id)}) < self.pose[3] * {seconds_aside(actor, one):.3g} + {room:.3g}"


def must_avoid(actor: Actor, one: Other) -> str:
    """When somebody is so near to whom it swerves round that it must."""
    name, slow = name_of(one.id), SLOWER * actor.ego_speed
    near = f"self.pose[3] * {seconds_aside(actor, one):.3g} + (self.length + {name}.length) / 2 + {NEAR:g}"
    return f"{name}.pose[3] < {slow:.3g} and headway(egoRoute, self, {name}) < {near}"


def seconds_aside(actor: Actor, one: Other) -> float:
    """How long [s] somebody takes to get aside of whom it swerves round: longer where the road holds less."""
    aside = 0.5 * (actor.limits.width + _across(one)) + CLEAR
    return max(SWERVES_AT, 2.0 * math.sqrt(aside / grip_of(actor.ledger.situation)))


def _across(one: Other) -> float:
    """How wide [m] somebody is who stands in the lane, seen along that."""
    limits = one.kind.row.body.row.limits
    return limits.length if one.starts.facing is Facing.ACROSS else limits.width


def line_aside(actor: Actor, k: int, way: str | None) -> str:
    """The line beside its own on which somebody goes on that left it, and does not come back."""
    deed = actor.deeds[k]
    then, before = actor.then(k), avoids(actor, k)
    round_ego = deed.act is Act.SWERVE and actor.one.starts.where is Where.BEHIND
    stays = (
        round_ego
        or before is not None
        or (deed.act is Act.DRIFT and then is not None)
        or (deed.act is Act.SWERVE and then in LOSES)
    )
    if not stays or actor.stand.meets not in (Meets.ALONG, Meets.TOWARD):
        return ""
    if (before is not None or round_ego) and deed.distance is None:
        wide = _across(before) if before is not None else actor.ego_limits.width
        least = 0.5 * (actor.limits.width + wide) + CLEAR
        actor.numbers.narrow("SWERVE", least, least + CLEAR)
    name = str(deed.act).upper() + (f"_{k}" if deed.distance is not None else "")
    own = f"way{name_of(actor.one.id)}" + (".line" if actor.stand.way == "egoRoute" else "")
    return f"{way or own}.offset({sign_of_side(actor, k)} * ${name})"


def goes_by(actor: Actor, phases: tuple[str, ...]) -> tuple[str, ...]:
    """The last phases of who comes against the ego in its lane and does not touch it: it goes by, beside the ego.

    It goes by on the side of its own lane, if nobody is there.
    """
    others = (one for one in actor.ledger.situation.others if one.id != actor.one.id)
    taken = any(
        one.starts.where is Where.ONCOMING or (one.starts.where in NEXT_LANE and one.starts.side is Side.LEFT)
        for one in others
    )
    actor.ledger.take("contact.happens")
    return _aside(actor, phases, BY, GOES_BY_AT, left=not taken)


def grazes(actor: Actor) -> bool:
    """Whether it was said that who comes against the ego in its lane touches a side of it, and not its front."""
    contact, ours = actor.ledger.situation.contact, actor.one.starts.where is Where.ONCOMING_IN_OUR_LANE
    ours = ours and touches(actor.ledger.situation, actor.one)
    return contact is not None and ours and contact.ego in _ON_A_SIDE


def comes_aside(actor: Actor, phases: tuple[str, ...]) -> tuple[str, ...]:
    """The last phases of who comes against the ego partly in its lane, so that the two touch with a side."""
    contact = actor.ledger.situation.contact
    assert contact is not None
    actor.ledger.take("contact.ego", *(("contact.striker",) if contact.striker is Striker.OTHER else ()))
    return _aside(actor, phases, GRAZES, COMES_ASIDE_AT, left=contact.ego in (Part.LEFT, Part.LEFT_FRONT))


def _aside(actor: Actor, phases: tuple[str, ...], by: tuple[float, float], at: float, *, left: bool) -> tuple[str, ...]:
    """The last phases of who comes against the ego, and leaves its line so many seconds before they would touch."""
    middles = 0.5 * (actor.limits.width + actor.ego_limits.width)
    actor.numbers.measure("BY", middles + by[0], middles + by[1], "m", "how far aside of the ego it goes by")
    *before, last = phases
    found = _DRIVES.match(last)
    way, speed = (found[1], found[2]) if found is not None else ("{p}", "$SPEED")
    near = f"gap(self, {{we}}) < (self.pose[3] + {{we}}.pose[3]) * {at:g} + {NEAR:g}"  # whomever it follows
    return (*before, f"{last} until {near}", f"DrivePath({way}, {speed}, {'-' if left else ''}$BY)")


def _behind_who_comes_in(actor: Actor, k: int) -> Side | None:
    """The side from which another comes into the lane for which somebody swerves: behind that one it is free."""
    if actor.deeds[k].act is not Act.SWERVE or actor.one.starts.where is not Where.AHEAD:
        return None
    for name in sorted(answered_by(actor, k)):
        other = actor.ledger.situation[name]
        if other.starts.where in _BESIDE_ROAD and any(deed.act in COMES_IN | _TURNS for deed in other.does):
            return other.starts.side or actor.found.sides.get(name)
    return None


def sign_of_side(actor: Actor, k: int) -> str:
    """To which side of its line it goes: 1 for left; where that was not said, toward the ego's way."""
    deed, toward = actor.deeds[k], actor.stand.meets is Meets.TOWARD or actor.one.starts.where is Where.ONCOMING
    if deed.to is not None:
        actor.ledger.take(f"{actor.path}.does.{k}.to")
        sign = 1 if deed.to is Side.LEFT else -1
        return str(-sign if toward else sign)
    if toward:
        return "1"
    if (behind := _behind_who_comes_in(actor, k)) is not None:
        return "1" if behind is Side.LEFT else "-1"
    start = actor.one.starts  # by its side there, not by where it is then: once over the middle it would turn round
    against = actor.stand.meets is Meets.KERB and start.facing is Facing.AGAINST
    return "-1" if (start.side is Side.LEFT) is not against else "1"
