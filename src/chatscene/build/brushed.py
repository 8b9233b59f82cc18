"""What stands where the ego's way leads past it, since the ego is to brush it with its side: in a turn, at the exit."""

from __future__ import annotations

import math
from collections.abc import Iterator

import numpy as np

from chatscene.build.asked import Asked, Meets, Stand
from chatscene.build.contact import touches
from chatscene.terms.actors import LIMITS, PROPS
from chatscene.terms.situation import Other, Situation
from chatscene.terms.vocabulary import SIDES_OF, Act, EgoRoute, Facing, Part, Side, Striker, Where
from chatscene.world.ego_route import EgoRoute as Route
from chatscene.world.places import ownLane

CLEARS, IN_TURN_CLEARS = 0.15, 0.4  # [m] beside the ego's way, straight on and in a turn, of what it is to brush
INTO_TURN = 0.6  # of a turn, at which the ego is to brush something
COMES_IN, ALONG = 0.6, 0.15  # [m] beside the middle of its lane, and [rad] turned from that, an ego that comes into it
_BESIDE = frozenset((Where.KERB, Where.ROADSIDE, Where.MEDIAN))
_ROUTES = frozenset((EgoRoute.LEFT_TURN, EgoRoute.RIGHT_TURN, EgoRoute.LEAVE_DRIVEWAY))
_OTHERS = {
    Side.RIGHT: (Part.LEFT, Part.LEFT_FRONT, Part.LEFT_REAR),
    Side.LEFT: (Part.RIGHT, Part.RIGHT_FRONT, Part.RIGHT_REAR),
}
"""The parts of who faces as the ego does that a side of the ego touches."""


def brushed_on(situation: Situation, one: Other) -> Side | None:
    """On which side the ego is to brush somebody who stands, or something, beside its way; None of others."""
    contact = situation.contact
    if contact is None or contact.striker is not Striker.EGO or contact.ego is None or not touches(situation, one):
        return None
    start, stands = one.starts, all(deed.act is Act.STAND for deed in one.does)
    free = start.distance is None and start.lateral is None and one.count == 1
    free = free and start.facing in (None, Facing.ALONG)
    if not (stands and free and start.where in _BESIDE) or situation.ego.route not in (None, *_ROUTES):
        return None
    if situation.ego.route is None and (start.where is not Where.KERB or start.side is not Side.RIGHT):
        return None
    side = next((side for side in Side if str(side) in SIDES_OF[contact.ego]), None)
    return side if start.side in (None, side) else None


def brushed(asked: Asked) -> Stand | None:
    """Where somebody stands whom the ego is to brush: beside its way in the turn, or along the lane that it comes into.

    None of others.
    """
    side = brushed_on(asked.situation, asked.one)
    if side is None:
        return None
    route, sign = asked.found.route, 1.0 if side is Side.LEFT else -1.0
    own = LIMITS.get(asked.one.kind.scenic) or PROPS[asked.one.kind.scenic]
    aside = 0.5 * (asked.situation.ego.body.row.limits.width + own.width) + CLEARS
    if asked.situation.ego.route is not None:
        aside += IN_TURN_CLEARS - CLEARS
    if asked.situation.ego.route is None:
        asked.ahead(30, 44)
        way, at, anywhere = f"ownLane(egoRoute).offset({sign * aside:.3g})", f"$Y{asked.more}", True
    elif asked.situation.ego.route is EgoRoute.LEAVE_DRIVEWAY:
        at = f"{_comes_in(route) + 0.5 * own.length:.4g}"
        way, anywhere = f"ownLane(egoRoute).offset({sign * aside:.3g})", False
    else:
        along, bend = _in_turn(route)
        aside += 0.125 * own.length**2 * bend  # its ends are nearer than its middle
        way, at, anywhere = f"egoRoute.line.offset({sign * aside:.3g})", f"egoRoute.eventAt + {along:.3g}", False
    passed = "progressOn(egoRoute, self)[0]"
    return Stand(meets=Meets.KERB, way=way, at=at, ego_meets=passed, anywhere=anywhere)


def parts_brushed(situation: Situation) -> Iterator[str]:
    """The paths of what was said of a contact with what the ego brushes that is so by where that stands."""
    contact = situation.contact
    side = next((side for one in situation.others if (side := brushed_on(situation, one)) is not None), None)
    if contact is None or side is None:
        return
    yield from ("contact.ego", "contact.striker")
    if contact.other in _OTHERS[side]:
        yield "contact.other"


def _in_turn(route: Route) -> tuple[float, float]:
    """How far [m] beyond where its manoeuvre begins the ego is in its turn, and how bent its way is there [1/m]."""
    far = np.arange(0.0, route.line.length, 0.5)
    heading = np.unwrap(route.line.headings_at(far))
    turned = np.abs(heading - heading[0])
    k = int(np.argmax(turned > INTO_TURN * turned[-1]))
    before = max(k - 4, 0)
    bend = (turned[k] - turned[before]) / max(far[k] - far[before], 0.5)
    return float(far[k] - route.eventAt), float(bend)


def _comes_in(route: Route) -> float:
    """How far [m] along the lane that an ego comes into from beside it, it has all but come into it."""
    own, far = ownLane(route), np.arange(0.0, route.line.length, 0.5)
    for at in far.tolist():
        along, aside, _ = own.project(*route.line.point_at(at))
        turned = math.remainder(route.line.heading_at(at) - own.heading_at(along), math.tau)
        if abs(aside) < COMES_IN and abs(turned) < ALONG:
            return along
    return own.length
