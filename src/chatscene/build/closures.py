"""Cones of roadworks: a taper at the edge of the ego's side, across its lane where that is closed, or along it."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from typing import TYPE_CHECKING

from chatscene.build.hiding import BESIDE
from chatscene.build.place import LANE, at_junction, stands_in_closed_lane
from chatscene.terms.situation import Situation
from chatscene.terms.vocabulary import Feature, Heads, Side, acts_of
from chatscene.world.places import lanes_beside

if TYPE_CHECKING:
    from chatscene.build.actor import Actor

APART = 6.0  # [m] along the road between two cones
TAPER = 5  # cones of a taper
STRAIGHT = 5  # cones beyond it, along the road
WIDE, NEAR_LANES = 2.5, 0.3  # [m] outside the lanes, from and to, of a taper at the edge: clear of who is mid-lane
BEFORE, BEYOND = -15.0, 5.0  # [m] beyond who is met that the cones begin, and where that one comes from their side
CLOSED_FROM = 15.0  # [m] beyond who is met that a lane is closed
BEFORE_JUNCTION = 8.0  # [m], where they end
IN_LANE = 0.2  # [m] inside its edge, of the cones of a lane that is closed
NOSE = 1.5  # [m] before the nose of an ego that stands in a closed lane, of the first cone
_BY = acts_of(Heads.BY, Heads.ASIDE, Heads.OVER)


def cones_of(situation: Situation, everybody: Sequence[Actor], level: str) -> Iterator[str]:
    """The lines of the cones of roadworks, or of a lane that is closed.

    Args:
        situation: What was said.
        everybody: All others.
        level: Where along the ego's way who is met is, as a text of Scenic.
    """
    if stands_in_closed_lane(situation):
        yield from _along(situation, everybody)
    elif Feature.CLOSED_LANE in situation.road.has:
        yield from _across(everybody, level)
    else:
        yield from _at_edge(situation, everybody, level)


def _along(situation: Situation, everybody: Sequence[Actor]) -> Iterator[str]:
    """Before an ego that stands in a closed lane, on the side on which others go by."""
    sign = 1.0 if _open_side(everybody) is Side.LEFT else -1.0
    first = 0.5 * situation.ego.body.row.limits.length + NOSE
    for n in range(TAPER + STRAIGHT):
        yield _cone(n, f"pointOn(egoRoute, {first + n * APART:g}, {sign * (0.5 * LANE - IN_LANE):g})", "egoRoute, 0")


def _across(everybody: Sequence[Actor], level: str) -> Iterator[str]:
    """A taper over the ego's lane, towards the side on which the road goes on, and cones along that side."""
    sign = 1.0 if _open_side(everybody) is Side.LEFT else -1.0
    edge = 0.5 * LANE - IN_LANE
    for n in range(TAPER + STRAIGHT):
        at = f"{level} + {CLOSED_FROM + n * APART:g}"
        aside = sign * edge * min(1.0, 2.0 * n / (TAPER - 1) - 1.0)
        yield _cone(n, f"pointOn(egoRoute, {at}, {aside:.3g})", f"egoRoute, {at}")


def _at_edge(situation: Situation, everybody: Sequence[Actor], level: str) -> Iterator[str]:
    """A taper at the edge of the road on the ego's right, beyond who comes from there, and cones along the lane."""
    from_there = any(
        actor.one.starts.where in BESIDE and actor.one.starts.side in (Side.RIGHT, None) for actor in everybody
    )
    begins = BEYOND if from_there else BEFORE
    if at_junction(situation):
        level, begins = "egoRoute.eventAt", -(BEFORE_JUNCTION + (TAPER + STRAIGHT - 1) * APART)
    for n in range(TAPER + STRAIGHT):
        far = begins + n * APART
        at = f"{level} {'+' if far >= 0.0 else '-'} {abs(far):g}"
        beyond = max(NEAR_LANES, WIDE - n * (WIDE - NEAR_LANES) / (TAPER - 1))
        yield _cone(n, f'besideRoad(egoRoute, {at}, "right", {beyond:.3g})', f"egoRoute, {at}")


def _open_side(everybody: Sequence[Actor]) -> Side:
    """On which side of the ego's lane the road goes on: where somebody goes by, else where another lane lies."""
    by = (deed.to for actor in everybody for deed in actor.one.does if deed.act in _BY)
    said = next((side for side in by if side is not None), None)
    there = lanes_beside(everybody[0].found.route)
    return said or (Side.RIGHT if there.get("left") is not False and there.get("right") is False else Side.LEFT)


def _cone(n: int, place: str, along: str) -> str:
    label = f"with label 'roadworks-{n}', with role 'background'"
    return f"new Cone at {place}, facing directionOn({along}), {label}"
