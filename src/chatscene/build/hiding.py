"""Who hides somebody at first: where it stands, in the line of sight from the ego to whom it hides."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from typing import TYPE_CHECKING

from chatscene.build.asked import Meets
from chatscene.build.backing import place_beside
from chatscene.build.lateral import in_lane
from chatscene.build.naming import name_of
from chatscene.build.place import LANE, between_bays
from chatscene.errors import NothingBuilds
from chatscene.terms.backing import backs
from chatscene.terms.situation import Other
from chatscene.terms.vocabulary import Side, Where

if TYPE_CHECKING:
    from chatscene.build.actor import Actor

TO_LANES, BY_DRIVEWAY = 0.5, 0.6  # [m] from the lanes to the end of a hedge along a driveway; between it and who is in
BETWEEN = 1.2  # [m] between things in a row
OFF = 0.1  # [m] between the lane and the side of what hides somebody
BEYOND = 2.5  # [m] outside the lanes, about the middle of who hides somebody
USUAL_ROOM, LEAST_ROOM = 2.6, 0.9  # [m] past the end of whom hides it that somebody steps out
SIGHT = 0.7  # of the room in which an ego in the middle of its lane sees nobody: one that keeps off sees more
SEEN_FROM = 0.93  # of how far away it is at first: from there somebody is hidden who then comes from far off the road
PARTLY = frozenset((Where.KERB, Where.AHEAD))
"""Where somebody can be parked partly in our lane."""
BESIDE = frozenset((Where.KERB, Where.ROADSIDE, Where.DRIVEWAY, Where.CROSSING, Where.EXIT_CROSSING, Where.BUS_BAY))
"""Where who hides somebody beside the road may have been said to be."""


def place_hiding(actor: Actor, hidden: Actor, n: int) -> tuple[str, str]:
    """Where the n-th of it stands between the ego and whom it hides: nearer to the ego and farther in turn."""
    if backs(actor.ledger.situation):
        return place_beside(actor, hidden, n)
    by_place = _by_whom_it_hides(actor, hidden)
    if by_place is not None:
        actor.ledger.take(f"{hidden.path}.hidden_by")
        return by_place(actor, hidden, n)
    if hidden.stand.meets is not Meets.ACROSS or "besideRoad" not in hidden.stand.point:
        raise NothingBuilds(
            f"cannot be built yet: {actor.one.id} hiding a road user that starts {hidden.one.starts.where}"
        )
    side = str(hidden.one.starts.side)
    if actor.one.starts.side not in (None, side):
        raise NothingBuilds(f"cannot be built yet: {actor.path} hiding {hidden.one.id} from the other side")
    actor.ledger.take(*(f"others.{name}.hidden_by" for name in hidden_with(actor, hidden.one)))
    aside = _in_our_lane(actor)
    if actor.one.starts.where not in BESIDE and aside is None:
        where = actor.one.starts.where
        actor.ledger.assume(
            f"{actor.one.id} stands beside the road instead of {where}, so that it hides {hidden.one.id}"
        )
    if aside is not None:
        actor.ledger.take(f"{actor.path}.starts.lateral")
        length = actor.limits.length
        away = _room(actor, hidden, hidden.numbers.middle("X")) + (0.5 + n // 2) * length + n // 2 * BETWEEN
        at = f"level{name_of(hidden.one.id)} {'+' if n % 2 else '-'} {away:.3g}"
        return f"pointOn(egoRoute, {at}, {aside:.3g})", f"directionOn(egoRoute, {at})"
    if between_bays(actor.found):
        return _in_bay(actor, hidden, n)
    return _beside_road(actor, hidden, n)


def _beside_road(actor: Actor, hidden: Actor, n: int) -> tuple[str, str]:
    """Where the n-th of it stands along the edge of the road, before whom it hides and behind in turn."""
    side = str(hidden.one.starts.side)
    length = actor.limits.length or 1.2
    off = 0.5 * actor.limits.width + OFF  # so that it is beside the lane, and not in it
    beyond, aside = max(1.2, off), hidden.numbers.middle("X")
    aside -= 0.5 * hidden.limits.length if _drives_out(hidden) else 0.0
    away = _room(actor, hidden, aside) + 0.5 * length + n // 2 * (length + BETWEEN)
    if aside > BEYOND and n % 2 == 0:  # it comes from farther off the road, and what hides it stands there, too
        beyond = max(off, aside - BEYOND)
        over = LANE / 2 + aside
        far = min(SEEN_FROM * hidden.numbers.middle("Y"), actor.ego_speed * over / hidden.numbers.middle("SPEED"))
        away = max(away, (aside - beyond) / over * far)
    at = f"level{name_of(hidden.one.id)} {'+' if n % 2 else '-'} {away:g}"
    return f'besideRoad(egoRoute, {at}, "{side}", {beyond:.3g})', f"directionOn(egoRoute, {at})"


def _by_whom_it_hides(actor: Actor, hidden: Actor) -> Callable[[Actor, Actor, int], tuple[str, str]] | None:
    """What says where somebody stands that hides another who is at a corner, in a row, or in a driveway; else None."""
    if hidden.stand.meets is Meets.THROUGH and hidden.one.starts.where is Where.ARM:
        return _at_corner
    if hidden.stand.meets is Meets.KERB:
        return _before_it
    long = actor.lies and actor.limits.length > actor.limits.width and actor.count == 1
    same_side = actor.one.starts.side in (None, hidden.one.starts.side)
    return _along_driveway if long and same_side and _drives_out(hidden) else None


def _drives_out(hidden: Actor) -> bool:
    """Whether somebody comes driving out of a driveway, of whom the nose is hidden and not the middle."""
    return hidden.one.starts.where is Where.DRIVEWAY and not hidden.walks


def _along_driveway(actor: Actor, hidden: Actor, _n: int) -> tuple[str, str]:
    """Where a hedge or a wall stands beside the driveway out of which somebody comes, from near the lanes outwards."""
    at = f"level{name_of(hidden.one.id)} - {0.5 * (hidden.limits.width + actor.limits.width) + BY_DRIVEWAY:.3g}"
    side, beyond = str(hidden.one.starts.side), TO_LANES + 0.5 * actor.limits.length
    return f'besideRoad(egoRoute, {at}, "{side}", {beyond:.3g})', f'crossingDirection(egoRoute, {at}, "{side}")'


def _in_our_lane(actor: Actor) -> float | None:
    """How far [m] to the left of the middle of our lane somebody is parked who was said to be partly in it.

    None of who is not, or is at the other edge of the road, where others come.
    """
    lateral, start = actor.one.starts.lateral, actor.one.starts
    if lateral is None or lateral.beyond is not None or start.where not in PARTLY or start.side is Side.LEFT:
        return None
    low, high = in_lane(lateral, lateral.side or Side.RIGHT, actor.limits, actor.ego_limits.width, 0.0)
    return 0.5 * (low + high)


def _room(actor: Actor, hidden: Actor, aside: float) -> float:
    """How far [m] past the end of whom hides it somebody steps out: less before a slow ego, which is near by then."""
    far = actor.ego_speed * (aside + 0.5 * LANE) / hidden.numbers.middle("SPEED")
    return min(USUAL_ROOM, max(LEAST_ROOM, SIGHT * far * (aside - OFF) / (aside + 0.5 * LANE)))


def _in_bay(actor: Actor, hidden: Actor, n: int) -> tuple[str, str]:
    """Where the n-th of it stands in a bay of a car park, from between two of which somebody comes."""
    width = actor.limits.width
    away = 0.5 * (BETWEEN + width) + n // 2 * (width + BETWEEN)
    at = f"level{name_of(hidden.one.id)} {'+' if n % 2 else '-'} {away:g}"
    side, beyond = str(hidden.one.starts.side), 0.5 * actor.limits.length + OFF
    return f'besideRoad(egoRoute, {at}, "{side}", {beyond:.3g})', f'crossingDirection(egoRoute, {at}, "{side}")'


def hidden_with(actor: Actor, one: Other) -> Iterator[str]:
    """The ids of all that it hides with somebody, who come from the same gap."""
    situation = actor.ledger.situation
    there = situation[one.id].starts  # as said: of ``one``, the side was chosen if none was
    for other in situation.others:
        same = (other.starts.where, other.starts.side) == (there.where, there.side)
        if other.hidden_by == actor.one.id and same and other.starts.distance is None:
            yield other.id
    yield one.id


def _before_it(actor: Actor, hidden: Actor, n: int) -> tuple[str, str]:
    """Where the n-th of it stands in the row at the edge of the road, before whom it hides there."""
    length = actor.limits.length or 1.2
    away = 0.5 * (hidden.limits.length + length) + BETWEEN + n * (length + BETWEEN)
    at, way = f"{hidden.filled(hidden.stand.at)} - {away:.3g}", f"way{name_of(hidden.one.id)}"
    return f"pointOn({way}, {at})", f"directionOn({way}, {at})"


def _at_corner(actor: Actor, hidden: Actor, n: int) -> tuple[str, str]:
    """Where the n-th of it stands beside the way of whom it hides on an arm, in the line of sight as that sets off.

    Beside whom it hides lies the lane of the other direction, if the ego comes from that one's left.
    """
    left = hidden.one.starts.side is Side.RIGHT
    aside = (1.5 * LANE if left else 0.5 * LANE) + 0.5 * actor.limits.width + BETWEEN
    way, apart = f"way{name_of(hidden.one.id)}", n * (actor.limits.length + BETWEEN)
    if hidden.stand.rolls:  # it comes driving: the corner hides it until it is as near to that
        at = f"{way}.entry - {0.5 * actor.limits.length + BETWEEN + apart:.3g}"
    else:
        along = aside * hidden.numbers.middle("SPEED") / actor.ego_speed + apart
        at = f"{hidden.filled(hidden.stand.at)} + {along:.3g}"
    return f"pointOn({way}, {at}, {aside if left else -aside:.3g})", f"directionOn({way}, {at})"
