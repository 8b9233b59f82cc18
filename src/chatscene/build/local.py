"""What the place says of a deed: the rule that it breaks, the speed and the room that there is."""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np
import shapely

from chatscene.build.asked import Meets, stops_on_its_way
from chatscene.build.place import LANE, at_roundabout, comes_across, only_side_signs, ring_arms
from chatscene.build.turning_round import WIDER
from chatscene.errors import MapError, NotBuilt, NothingBuilds
from chatscene.maps.neighbours import oncoming_line
from chatscene.situations.phrases import one_of
from chatscene.terms.actors import Limits
from chatscene.terms.situation import Deed
from chatscene.terms.vocabulary import COMES_IN, HALTS, Act, Breach, EgoLight, Heads, Where, acts_of
from chatscene.world.control import curve_speeds
from chatscene.world.places import lanes_beside, line_of, ownLane, ringTraffic

if TYPE_CHECKING:
    from chatscene.build.actor import Actor

KERB_ASIDE = 2.5  # [m] from the middle of the outermost lane to that of who stands at the kerb
NEAR_EDGE = 0.2  # [m] from the edge of the road that somebody stands who turns round in three
BACKS = 6.0  # [m] at most that it backs
_TURNS = tuple(math.radians(turn) for turn in range(100, 30, -5))
_INTO_THE_WAY = COMES_IN | acts_of(Heads.TURNS, Heads.ROUND, Heads.BEFORE, Heads.OVER, Heads.MERGES)
"""What comes into the way of others, whoever does it."""


def breaks(actor: Actor, deed: Deed) -> bool:
    """Whether the rule that is broken is there, and is broken by what is done.

    Raises:
        NotBuilt: It has no such light.
    """
    moves = actor.stand.meets in (Meets.THROUGH, Meets.ACROSS) and deed.act not in HALTS | {Act.HESITATE}
    control = actor.found.query.get("control")
    match deed.breaks:
        case Breach.RED_LIGHT:
            if at_roundabout(actor.ledger.situation):
                at = f"{actor.path}.does.{actor.deeds.index(deed)}.breaks: {Breach.RED_LIGHT}"
                raise NothingBuilds(
                    f"cannot be built yet: {at}: there are no lights at a roundabout; say {Breach.RIGHT_OF_WAY}"
                )
            with_us = actor.one.starts.where in (Where.ONCOMING, Where.EXIT_CROSSING)
            _check_opposite(actor, deed)
            red = (actor.ledger.situation.road.ego_light in (EgoLight.RED, EgoLight.TURNS_RED)) == with_us
            return moves and control == "signal" and (red or with_us)
        case Breach.STOP_SIGN:
            return moves and (control == "stop-sign" or only_side_signs(actor.ledger.situation))
        case _:
            in_the_way = stops_on_its_way(actor.stand.meets, actor.deeds, actor.deeds.index(deed))
            return moves or in_the_way or deed.act in _INTO_THE_WAY or _comes_on(actor, deed)


def _check_opposite(actor: Actor, deed: Deed) -> None:
    """Hold that who comes from opposite, and runs its red light, has one: its light shows what the ego's does.

    Raises:
        NotBuilt: The ego's is not red.
    """
    red = actor.ledger.situation.road.ego_light in (EgoLight.RED, EgoLight.TURNS_RED)
    if actor.one.starts.where is Where.ONCOMING and not red:
        k = next(k for k, one in enumerate(actor.deeds) if one is deed)
        raise NothingBuilds(
            f"cannot be built yet: {actor.path}.does.{k}.breaks: {Breach.RED_LIGHT}, {Where.ONCOMING}: its"
            f" light shows the same as ours; say road.ego_light: {EgoLight.RED}, or starts.where: {Where.ARM}"
        )


def _comes_on(actor: Actor, deed: Deed) -> bool:
    """Whether somebody comes on toward the ego, or past others, and so lets nobody go first."""
    until = actor.deeds[: actor.deeds.index(deed) + 1]
    past = any(one.act is Act.OVERTAKE or one.act in _INTO_THE_WAY for one in until)
    return (past or actor.stand.meets is Meets.TOWARD) and deed.act not in HALTS | {Act.HESITATE}


def check_round(actor: Actor, k: int) -> None:
    """Refuse a speed that a roundabout lets nobody have.

    Raises:
        NotBuilt: It was said; or nobody comes there.
    """
    said = actor.deeds[k].speed
    if said is None:
        return
    try:
        way = ringTraffic(actor.found.route, *ring_arms(actor.one, actor.found.sides))
    except MapError as error:
        raise NotBuilt(f"no map has such a place: {error}") from error
    line = line_of(way)
    caps, there = curve_speeds(line), line.project(*line.point_at(way.meets_at))[2]
    comes_in = actor.deeds[k].act in COMES_IN and actor.one.starts.where is not Where.IN_ROUNDABOUT
    allowed = max(caps[: there + 1]) if comes_in else caps[there]  # who comes in loses it in the bend
    fastest = 1.1 * allowed  # who cuts the bend is faster
    if said.low > fastest:
        at = f"{actor.path}.does.{k}.speed: {said}"
        raise NotBuilt(f"{at} is too fast for the roundabout: at most {math.floor(3.6 * fastest + 1e-9)} km/h")


def check_turn(actor: Actor, k: int) -> None:
    """Refuse to come in to who turned back, and takes more than a lane to turn round.

    Raises:
        NotBuilt: It takes more.
    """
    limits = actor.limits
    circle = 2.0 * limits.wheelbase / math.tan(limits.wheel_angle) if limits.wheelbase else 0.0
    if circle > LANE:
        raise NothingBuilds(
            f"cannot be built yet: {actor.path}.does.{k}.act: {actor.deeds[k].act} after {one_of(actor.one.kind)} "
            f"turned back, since it takes {circle:.0f} m to turn round again"
        )


@dataclass(frozen=True, slots=True, kw_only=True)
class Round:
    """How somebody turns round on a road.

    Attributes:
        radius: Of its circle [m].
        first: How far [rad] it turns before it backs, where the road is too narrow for one go; 0 where it is not.
        back: How far [m] it then backs.
    """

    radius: float
    first: float = 0.0
    back: float = 0.0


def way_to_turn_round(actor: Actor, k: int) -> Round:
    """How somebody turns round into the lane of those who come against it: in one go, or in three.

    Raises:
        NotBuilt: There is no such lane beside the ego's, or the road is too narrow for it.
    """
    at, limits, route = f"{actor.path}.does.{k}.act: {actor.deeds[k].act}", actor.limits, actor.found.route
    beyond = oncoming_line(route.network, route.route) if comes_across(actor.found) else None
    if lanes_beside(route).get("left") is not True and beyond is None:
        raise NotBuilt(f"no map has such a place: {at} needs an oncoming lane to the left of ours")
    over_there = LANE if beyond is None else abs(beyond.project(*route.line.point_at(route.eventAt))[1])
    aside = over_there + (KERB_ASIDE if actor.stand.meets is Meets.KERB else 0.0)
    circle = max(aside, 2.0 * WIDER * limits.wheelbase / math.tan(limits.wheel_angle))
    own = line_of(ownLane(route))  # the ego's way may swing out there
    at_event = own.project(*route.line.point_at(route.eventAt))[0]
    (x, y), left = own.point_at(at_event), own.heading_at(at_event) + math.pi / 2
    steps = np.arange(0.0, 40.0, 0.25)
    inside = shapely.intersects_xy(
        route.network.drivableRegion.polygons, x + steps * math.cos(left), y + steps * math.sin(left)
    )
    ends = int(np.argmin(inside)) if beyond is None else int(np.flatnonzero(inside)[-1])
    room = float(steps[ends]) + aside - over_there
    if circle + limits.width / 2 <= room:
        return Round(radius=circle / 2)
    most = room - NEAR_EDGE
    over = next((turn for turn in _TURNS if _reaches(circle / 2, turn, limits) <= most), 0.0)
    back = (circle - aside) / math.sin(over) if over else math.inf
    if back > BACKS:
        raise NotBuilt(
            f"cannot be built yet: {at}: {one_of(actor.one.kind)} needs {circle + limits.width / 2:.0f} m "
            f"of road to its left, and there are {room:.0f} m"
        )
    return Round(radius=circle / 2, first=over, back=back)


def _reaches(radius: float, turn: float, limits: Limits) -> float:
    """How far [m] to the left of its line a body is at most that has turned so far [rad] on a circle."""
    ahead = 0.5 * (limits.length * math.sin(turn) + limits.width * math.cos(turn))
    return radius * (1.0 - math.cos(turn)) + ahead
