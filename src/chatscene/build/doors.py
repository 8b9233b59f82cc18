"""Whose door opens into the ego's way: where it stands, in a lane or at the kerb, and to which side of it that is."""

from __future__ import annotations

from chatscene.build.asked import Asked, Meets, Stand
from chatscene.build.place import LANE, NEXT_LANE
from chatscene.terms.situation import Other
from chatscene.terms.vocabulary import Act, Side, Where

NEARER = 0.5  # [m] to the left in the ego's lane, of who opens a door to an ego that swings out round it
CLEAR = 0.05  # [m] between the ego's lane and the side of who stands beside it and opens a door
_IN_LANE = NEXT_LANE - {Where.BEHIND_BESIDE} | {Where.AHEAD, Where.ONCOMING}


def opens_in_lane(asked: Asked) -> bool:
    """Whether somebody who stands on the road opens a door."""
    opens = any(deed.act is Act.OPEN_DOOR for deed in asked.one.does)
    return opens and asked.stands and asked.one.starts.where in _IN_LANE and not asked.begins_beside


def stands_in_lane(asked: Asked) -> Stand:
    """In a lane: in the ego's own, which it swings out of or stops in, or at the edge of the next one toward it."""
    where = asked.one.starts.where
    passed = where is Where.AHEAD and asked.swings_out
    level = "$Y"
    if passed:
        told = "how far beyond where the ego swings out it stands"
        level = asked.at_event(-2, 2, "the ego swings out round who is", told)
    else:
        asked.ahead(36, 50)
    level += asked.more
    edge = 0.5 * (LANE + asked.numbers.row.limits.width) + CLEAR
    way, at = f"ownLane(egoRoute){f'.offset({NEARER:g})' if asked.swings_out else ''}", level
    if where is Where.ONCOMING:
        way, at = f"against(ownLane(egoRoute).offset({edge:.3g}))", f"levelOn(way{{i}}, egoRoute, {level})"
    elif where is not Where.AHEAD:
        way = f"ownLane(egoRoute).offset({edge if asked.side == Side.LEFT else -edge:.3g})"
    return Stand(
        meets=Meets.KERB,
        way=way,
        at=at,
        ego_meets="progressOn(egoRoute, self)[0]",
        anywhere=not passed and where is not Where.ONCOMING,
    )


def door_side(one: Other) -> Side:
    """The side, of a vehicle as it faces, on which a door opens into the ego's way."""
    beside = one.starts.where in NEXT_LANE and one.starts.side is Side.LEFT
    return Side.RIGHT if beside else Side.LEFT


def away(one: Other) -> Side:
    """The ego's side to which a door would open away from its way."""
    left = one.starts.where is Where.ONCOMING or one.starts.side is Side.LEFT
    return Side.LEFT if left else Side.RIGHT
