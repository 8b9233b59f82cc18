"""What the place says of a deed: the rule that it breaks, the speed and the room that there is."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING

from chatscene.build.asked import Meets
from chatscene.build.place import LANE, ring_arms
from chatscene.errors import MapError, NotBuilt
from chatscene.terms.situation import Deed
from chatscene.terms.vocabulary import COMES_IN, Act, Breach, EgoLight, Where
from chatscene.world.control import curve_speeds
from chatscene.world.places import line_of, ringTraffic

if TYPE_CHECKING:
    from chatscene.build.actor import Actor

_QUIET = frozenset((Act.STAND, Act.STOP))
_INTO_THE_WAY = COMES_IN | {Act.TURN_LEFT, Act.TURN_RIGHT, Act.U_TURN, Act.CUT_IN, Act.LANE_CHANGE, Act.MERGE}
"""What comes into the way of others, whoever does it."""


def breaks(actor: Actor, deed: Deed) -> bool:
    """Whether the rule that is broken is there, and is broken by what is done."""
    moves = actor.stand.meets in (Meets.THROUGH, Meets.ACROSS) and deed.act not in _QUIET | {Act.HESITATE}
    control = actor.found.query.get("control")
    match deed.breaks:
        case Breach.RED_LIGHT:
            with_us = actor.one.starts.where in (Where.ONCOMING, Where.EXIT_CROSSING)
            red = (actor.ledger.situation.road.ego_light in (EgoLight.RED, EgoLight.TURNS_RED)) == with_us
            return moves and control == "signal" and (red or with_us)
        case Breach.STOP_SIGN:
            return moves and control == "stop-sign"
        case _:
            return moves or deed.act in _INTO_THE_WAY


def check_round(actor: Actor, k: int) -> None:
    """Refuse a speed that a roundabout lets nobody have.

    Raises:
        NotBuilt: It was said; or nobody comes there.
    """
    said = actor.deeds[k].speed
    if said is None or said.than_ego:
        return
    try:
        way = ringTraffic(actor.found.route, *ring_arms(actor.one, actor.found.sides))
    except MapError as error:
        raise NotBuilt(f"no map has such a place: {error}") from error
    line = line_of(way)
    fastest = 1.1 * curve_speeds(line)[line.project(*line.point_at(way.meets_at))[2]]  # who cuts the bend is faster
    if said.low > fastest:
        at = f"{actor.path}.does.{k}.speed: {said}"
        raise NotBuilt(f"{at} is more than the roundabout lets anybody go: {3.6 * fastest:.0f} km/h at most")


def check_turn(actor: Actor, k: int) -> None:
    """Refuse to come in to who turned back, and takes more than a lane to turn round.

    Raises:
        NotBuilt: It takes more.
    """
    limits = actor.limits
    circle = 2.0 * limits.wheelbase / math.tan(limits.wheel_angle) if limits.wheelbase else 0.0
    if circle > LANE:
        raise NotBuilt(
            f"nothing builds yet: {actor.path}.does.{k}.act: {actor.deeds[k].act} of a {actor.one.kind} that "
            f"turned back, since it takes {circle:.0f} m to turn round again"
        )
