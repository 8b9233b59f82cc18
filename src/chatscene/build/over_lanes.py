"""Who changes lanes: in which lane, counted from the ego's, somebody is after each deed, and which lanes that takes."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import replace
from typing import TYPE_CHECKING

import numpy as np
import shapely

from chatscene.build.place import LANE, NEXT_LANE, between_lanes, filters, lane_beside
from chatscene.terms.actors import Manner as Moves
from chatscene.terms.situation import Deed, Other, Situation
from chatscene.terms.vocabulary import OVER_A_LINE, Heads, Side, Where, acts_of
from chatscene.world.ego_route import EgoRoute as Route
from chatscene.world.places import lanes_beside, ownLane

if TYPE_CHECKING:
    from chatscene.build.actor import Actor

_SIGN = {Side.LEFT: 1, Side.RIGHT: -1}
_ENDS_IN_OURS = acts_of(Heads.BEFORE, Heads.MERGES, Heads.IN)
_ALONG = NEXT_LANE | {Where.AHEAD, Where.BEHIND}


def first_lane(one: Other) -> int:
    """The lane in which somebody begins: 0 is the ego's, 1 the next to the left, -1 the next to the right."""
    beside = one.starts.where in NEXT_LANE and one.starts.side is not None
    return _SIGN[one.starts.side] if beside and one.starts.side is not None else 0


def lane_after(one: Other, deeds: Sequence[Deed], k: int) -> int:
    """The lane in which somebody who goes along the road is after its k-th deed, counted so."""
    lane = first_lane(one)
    for deed in deeds[: k + 1]:
        if deed.act in _ENDS_IN_OURS:
            lane = 0
        elif deed.act in OVER_A_LINE:
            if deed.to is not None:
                lane += _SIGN[deed.to]
            else:
                lane = 1 if lane == 0 else lane - (1 if lane > 0 else -1)
    return lane


def side_beside(actor: Actor, said: Side | None) -> tuple[Side, str]:
    """The side of the ego's lane to which somebody leaves it, and the line of the lane of its direction there.

    Args:
        actor: Who.
        said: To which side it was said to; None where that was not said.

    Returns:
        The side, then the line; empty where no lane of its direction is free.
    """
    sides, one = lanes_beside(actor.found.route), actor.one
    others = (other.starts for other in actor.ledger.situation.others if other.id != one.id)
    taken = {start.side for start in others if start.where in NEXT_LANE}
    for side in (said,) if said is not None else (Side.LEFT, Side.RIGHT):
        if sides.get(side) is not False:
            continue
        if side in taken and filters(one):
            return side, f"{lane_beside(side)}.offset({between_lanes(side):g})"
        if side not in taken or said is not None or len(sides) == 1:
            return side, lane_beside(side)
    return said or Side.LEFT, ""


def lanes_needed(situation: Situation, sides: dict[str, Side]) -> tuple[int, int]:
    """How many lanes of the ego's direction must lie to its left and to its right, for all who change lanes."""
    left = right = 0
    for one in situation.others:
        if one.starts.where not in _ALONG or one.kind.moves is not Moves.DRIVES:
            continue
        side = one.starts.side or sides.get(one.id)
        begins = replace(one, starts=replace(one.starts, side=side))
        lanes = [first_lane(begins), *(lane_after(begins, one.does, k) for k in range(len(one.does)))]
        left, right = max(left, *lanes), max(right, *(-lane for lane in lanes))
    return left, right


def is_lane(route: Route, lane: int) -> bool:
    """Whether there is road where a lane would be, along the ego's way."""
    line, there = ownLane(route), route.network.drivableRegion.polygons
    points = [line.point_at(at) for at in np.linspace(0.0, min(line.length, route.eventAt), 5)]
    turns = [line.heading_at(at) + math.pi / 2 for at in np.linspace(0.0, min(line.length, route.eventAt), 5)]
    xs = [x + lane * LANE * math.cos(turn) for (x, _), turn in zip(points, turns, strict=True)]
    ys = [y + lane * LANE * math.sin(turn) for (_, y), turn in zip(points, turns, strict=True)]
    return bool(shapely.intersects_xy(there, xs, ys).all())


def lane_line(lane: int) -> str:
    """The line of a lane that is not the ego's, as a program says it."""
    side = Side.LEFT if lane > 0 else Side.RIGHT
    over = (abs(lane) - 1) * LANE * (1 if lane > 0 else -1)
    return lane_beside(str(side)) + (f".offset({over:g})" if over else "")
