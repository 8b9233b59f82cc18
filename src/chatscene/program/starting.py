"""Where somebody is seen to start: for each place of a situation, what of the tracks shows it."""

from __future__ import annotations

import math
from collections.abc import Callable

from chatscene.program.deeds import STANDING
from chatscene.program.meaning import POSITIONS
from chatscene.program.watching import Seen
from chatscene.terms.actors import Manner, manner_of
from chatscene.terms.scenario import Position
from chatscene.terms.vocabulary import Facing, Where

IN_LANE = 1.8  # [m] from the ego's line at most, of who is in its lane


def _at(position: Position) -> Callable[[Seen], bool]:
    return POSITIONS[position]


def _in_lane(s: Seen, within: float = IN_LANE) -> bool:
    """In the ego's lane, wherever its way then leads; on a bend the way is the lane."""
    beside = min(abs(s.offset[0]), abs(s.aside[0]))
    swings = s.line.length > 0 and abs(float(s.bearing[0])) < 0.2  # on a straight road the lane goes straight on
    return (min(beside, abs(s.across[0])) if swings else beside) < within


def _stands_beside(s: Seen) -> bool:
    """It stands ahead outside the ego's lane, or so far aside that an ego that keeps its line goes by it."""
    clear = 0.5 * (s.ego.width + s.track.width)
    return s.lead[0] > 0.0 and not _in_lane(s, min(IN_LANE, clear)) and abs(s.track.speed[0]) < STANDING


def _behind(s: Seen) -> bool:
    """Behind it in its lane; in the lane that it comes into, if it stands beside that at first."""
    aside = 4.0 if abs(s.ego.speed[0]) < STANDING else 2.0
    return s.along[0] < -2.0 and abs(s.across[0]) < aside


def _comes_toward(s: Seen) -> bool:
    """Against the ego's way, or against the ego itself where that way turns round."""
    return POSITIONS[Position.ONCOMING](s) or (s.along[0] > 2.0 and abs(s.bearing[0]) > math.radians(130))


def _rides_beside(s: Seen) -> bool:
    """Level with the ego: in the next lane, or on two wheels at the edge of its own; on foot where it comes by."""
    comes_by = s.along[0] > 0.0 and manner_of(s.track.kind) is Manner.WALKS
    return (abs(s.along[0]) < 8.0 or comes_by) and 1.0 < abs(s.across[0]) < 6.0


def _goes_along(s: Seen) -> bool:
    """On wheels along the ego's way, on foot any way."""
    return abs(s.bearing[0]) < 1.0 or manner_of(s.track.kind) is Manner.WALKS


def _beside_road(s: Seen) -> bool:
    return s.lead[0] > 0.0 and abs(s.offset[0]) > 1.6


STARTS: dict[Where, Callable[[Seen], bool]] = {
    Where.AHEAD: lambda s: s.lead[0] > 2.0 and _in_lane(s),
    Where.AHEAD_BESIDE: lambda s: s.along[0] > 1.0 and 1.0 < abs(s.across[0]) < 6.0 and _goes_along(s),
    Where.BESIDE: _rides_beside,
    Where.BEHIND: _behind,
    Where.BEHIND_BESIDE: lambda s: s.along[0] < -1.0 and 1.0 < abs(s.across[0]) < 6.0,
    Where.ONCOMING: _comes_toward,
    Where.ONCOMING_IN_OUR_LANE: lambda s: POSITIONS[Position.ONCOMING](s) and abs(s.offset[0]) < IN_LANE,
    Where.ARM: lambda s: (
        _beside_road(s) if manner_of(s.track.kind) is Manner.WALKS else POSITIONS[Position.CROSSING](s)
    ),
    Where.ROADSIDE: _beside_road,
    Where.DRIVEWAY: _beside_road,
    Where.CROSSING: _beside_road,
    Where.EXIT_CROSSING: _at(Position.FAR_CORNER),
    Where.KERB: _stands_beside,
    Where.EXIT: _at(Position.BEYOND),
    Where.BUS_BAY: _beside_road,
    Where.MEDIAN: lambda s: s.lead[0] > 0.0 and 1.0 < s.offset[0] < 4.0,
    Where.ON_RAMP: lambda s: s.lead[0] > -12.0 and s.offset[0] < -1.6,
}
"""Whether somebody is seen to start in a place; for those that are not here, no track tells."""

FACING = {Facing.ALONG: 0.0, Facing.AGAINST: math.pi}
ABOUT = math.radians(45)  # off from which somebody is not seen to face that way


def faces(s: Seen, said: Facing) -> bool:
    """Whether somebody faces a way at first, against the ego's way beside it; across is toward its lane."""
    turned = float(s.track.heading[0]) - s.line.heading_at(float(s.at[0].clip(0.0, s.line.length)))
    if said is Facing.ACROSS and _in_lane(s):
        return abs(math.sin(turned)) > math.sin(ABOUT)
    if said is Facing.ACROSS:
        return -math.copysign(1.0, float(s.offset[0])) * math.sin(turned) > math.sin(ABOUT)
    return abs(math.remainder(turned - FACING[said], 2 * math.pi)) < ABOUT
