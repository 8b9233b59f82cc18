"""Who comes by behind an ego that backs out of a driveway or a bay: where that crosses the ego's way."""

from __future__ import annotations

from dataclasses import replace
from typing import TYPE_CHECKING

from chatscene.build.asked import Asked, Meets, Stand
from chatscene.build.place import between_bays
from chatscene.errors import NotBuilt
from chatscene.terms.backing import backs
from chatscene.terms.situation import Situation
from chatscene.terms.vocabulary import EgoRoute, Side, Where

if TYPE_CHECKING:
    from chatscene.build.actor import Actor

WAITS = 3.5, 7.0  # [m] beside the ego's way, from and to, somebody waits who does not come in time by itself
OUTSIDE = 3.2  # [m] beside the middle of the lane, on the sidewalk
IN_AISLE = 0.9  # [m] the same between the bays of a car park
BESIDE = 1.0  # [m] between who are parked side by side
TOWARD_LANE = 1.2  # [m] that who hides somebody is nearer to the lane than the ego


_BY_ROAD = frozenset((Where.ROADSIDE, Where.ARM, Where.BEHIND, Where.BEHIND_BESIDE, Where.BESIDE))
_ALONG = frozenset(
    (Where.ROADSIDE, Where.CROSSING, Where.DRIVEWAY, Where.BEHIND, Where.ONCOMING_IN_OUR_LANE, Where.AHEAD)
)


def check_met(situation: Situation) -> None:
    """Hold that others are where an ego that backs meets them.

    Raises:
        NotBuilt: Somebody is elsewhere.
    """
    for one in situation.others if backs(situation) else ():
        if one.starts.where not in (_BY_ROAD if out_of(situation) else _ALONG):
            raise NotBuilt(
                f"cannot be built yet: others.{one.id}.starts.where: {one.starts.where}, with a reversing ego; behind"
                f" it, pedestrians and cyclists start at the {Where.ROADSIDE}, vehicles {Where.BEHIND}"
            )


def out_of(situation: Situation) -> bool:
    """Whether an ego that backs comes out of a driveway or a bay."""
    return situation.ego.route is not EgoRoute.REVERSE


def comes_by(asked: Asked) -> Stand:
    """On foot or on two wheels along the edge of the road, behind who backs onto that."""
    asked.reach(*WAITS, "how far beside the ego's way it is")
    left = asked.side == Side.LEFT
    level = f"level{{i}} {'-' if left else '+'} "
    far = asked.way_back("egoRoute.eventAt", "") if _in_time(asked) else "$Y"
    outside = IN_AISLE if between_bays(asked.found) else OUTSIDE
    return Stand(
        meets=Meets.ACROSS,
        way=f"wholeLane(egoRoute).offset({-outside:g})",
        point=f"pointOn(way{{i}}, {level}({far}{asked.more}))",
        facing=f"directionOn(way{{i}}, level{{i}}{'' if left else ', 3.14159'})",
        lines=("level{i} = levelOn(way{i}, egoRoute, 0)",),
        faces=True,
        left="max(0, abs(offsetFrom(egoRoute, self)) - 1)",
        rolls=far != "$Y",
    )


def _in_time(asked: Asked) -> bool:
    """Whether it comes driving from so far that it is there when the ego is; so far off, it is hidden as well."""
    comes = replace(asked, one=replace(asked.one, hidden_by=None)).comes
    return comes and asked.one.starts.distance is None


def parked_beside(asked: Asked) -> Stand:
    """In the next bay, level with who backs out."""
    aside = _aside(asked.situation, 0.5 * asked.numbers.row.limits.width)
    way = f"egoRoute.offset({aside if asked.side == Side.LEFT else -aside:.3g})"
    return Stand(meets=Meets.ALONG, way=way, at=f"{TOWARD_LANE:g}{asked.more}")


def _aside(situation: Situation, half: float) -> float:
    """How far [m] beside the ego somebody is parked who is twice so wide."""
    return 0.5 * situation.ego.body.row.limits.width + BESIDE + half


def place_beside(actor: Actor, hidden: Actor, n: int) -> tuple[str, str]:
    """Where the n-th of it stands beside an ego that backs out: on the side of whom it hides, then on the other."""
    actor.ledger.take(f"{hidden.path}.hidden_by", f"{actor.path}.starts")
    left = (hidden.one.starts.side is Side.LEFT) != bool(n % 2)
    aside = _aside(actor.ledger.situation, 0.5 * actor.limits.width)
    aside += n // 2 * (actor.limits.width + BESIDE)
    return f"pointOn(egoRoute, {TOWARD_LANE:g}, {aside if left else -aside:.3g})", "directionOn(egoRoute, 0)"
