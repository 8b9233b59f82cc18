"""What stands beside the road since it was said to be there: a shelter, a row of parked cars, cones, a sign."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from typing import TYPE_CHECKING

from chatscene.build.asked import FROM_A_STAND, PARKED_APART, stands_first
from chatscene.build.closures import cones_of
from chatscene.build.halting import HARD, SERVES, bus_stop_of, of_itself
from chatscene.build.hiding import BESIDE
from chatscene.build.ledger import Ledger
from chatscene.build.place import at_junction, between_bays, stands_in_closed_lane
from chatscene.terms.actors import LIMITS
from chatscene.terms.backing import backs
from chatscene.terms.scene import CAR
from chatscene.terms.situation import Other, Situation
from chatscene.terms.vocabulary import Act, Feature, Side, Tempo, UserKind, Where

if TYPE_CHECKING:
    from chatscene.build.actor import Actor

SHELTER = 5.0  # [m] beyond who is met
DOOR = 0.25  # of its length that the front door of a bus is before its middle
SHELTER_ASIDE = 3.6  # [m] outside the lanes: clear of a bus at the kerb and of who walks there
PARKED = (12.0, 18.5, 25.0)  # [m] beyond who is met, where nobody who comes out from between is hidden by them
BY_ONE = 4  # cars that are parked before one who stands in their row, and behind it
ROW = tuple(-26.5 + 6.5 * n for n in range(9))  # [m] beyond who is met, on a side on which nobody is
BEFORE_JUNCTION = 12.0  # [m]
SIGN_BEFORE = 30.0  # [m] before who is met
SIGN_ASIDE, SIGNS_APART = 2.0, 1.5  # [m] outside the lanes; from one to the next
AT_KERB = 1.3  # [m] outside the lanes
IN_BAY = 2.6  # [m] outside the lanes is the middle of a car in a bay


def beside_road(ledger: Ledger, everybody: Sequence[Actor]) -> Iterator[str]:
    """The lines for what the road was said to have beside it, that is not there for somebody else already.

    Args:
        ledger: What was said; takes what is built.
        everybody: All others.
    """
    for i, feature in enumerate(ledger.situation.road.has):
        if feature is Feature.BUS_STOP:
            ledger.take(f"road.has.{i}")
            if all(actor.one.kind is not UserKind.BUS_SHELTER for actor in everybody):
                yield from _shelter(ledger.situation, everybody)
        elif feature in _SIGNED and not backs(ledger.situation):
            ledger.take(f"road.has.{i}")
            yield from _signed(ledger, feature, everybody)
        elif feature is Feature.PARKED_CARS:
            ledger.take(f"road.has.{i}")
            yield from _parked("parked", everybody, everybody[0].one.starts.side or Side.RIGHT)
        elif feature is Feature.PARKED_BOTH_SIDES:
            ledger.take(f"road.has.{i}")
            for side in Side:
                yield from _parked(f"parked-{side}", everybody, side)


def _parked(name: str, everybody: Sequence[Actor], side: Side) -> Iterator[str]:
    """The lines of a row of parked cars on a side of the road: of the one or more that park there, what is lacking.

    Two or more who stand there are the row. One stands in it, and cars are parked before and behind it. Where somebody
    comes out from that side on foot, the row begins beyond, so that nobody is hidden of whom that was not said.
    """
    there = [actor for actor in everybody if actor.one.starts.where is Where.KERB and _side(actor) is side]
    parked = [actor for actor in there if stands_first(actor.one)]
    if sum(actor.count for actor in parked) > 1:
        return
    if not parked:
        yield from _things(name, "Car", everybody[0], PARKED if side in _taken(everybody) else ROW, AT_KERB, side)
        return
    (one,) = parked
    free = 0.5 * (one.limits.length + LIMITS[CAR].length) + PARKED_APART
    row = [free + n * (ROW[1] - ROW[0]) for n in range(BY_ONE)]
    before = [-ahead for ahead in row if ahead < one.numbers.range_of("Y")[0]]  # not before the ego's way begins
    beyond = () if at_junction(one.ledger.situation) else row if _stays(one.one) else PARKED  # who pulls out needs room
    yield from _things(name, "Car", one, (*before, *beyond), AT_KERB, side, by=one.filled(one.stand.at))


def _stays(one: Other) -> bool:
    """Whether somebody stays where it stands, whatever it lets go of."""
    return all(deed.act.row.tempo is Tempo.STANDS or deed.act.row.lets_go for deed in one.does)


def _side(actor: Actor) -> Side:
    return actor.one.starts.side or Side.RIGHT


def _shelter(situation: Situation, everybody: Sequence[Actor]) -> Iterator[str]:
    """The line of a bus stop, beside the front door of who stands or stops at it, on the side of its own lane.

    That is the ego that sets off, a bus that stands or stops, or another vehicle that does. Where none does, it is
    beyond who is met: on the side of an ego that such a stop is for, else on the side of who is met.
    """
    ego = situation.ego
    halts = [actor for actor in everybody if not actor.walks and (_waits(actor.one) or _halts(actor))]
    halts.sort(key=lambda actor: (actor.one.kind not in SERVES, _halts(actor)))
    side = Side.RIGHT if ego.kind in SERVES else None
    if at_junction(situation):
        yield from _things("bus-stop", "BusStop", everybody[0], (SHELTER,), SHELTER_ASIDE, side)
    elif ego.does and ego.does[0].act in FROM_A_STAND and (ego.kind in SERVES or not halts):
        yield _thing("bus-stop-0", "BusStop", f"{DOOR * ego.body.row.limits.length:g}", Side.RIGHT, SHELTER_ASIDE)
    elif halts:
        at, side = _where_it_halts(halts[0])
        yield _thing("bus-stop-0", "BusStop", at, side, SHELTER_ASIDE)
    else:
        yield from _things("bus-stop", "BusStop", everybody[0], (SHELTER,), SHELTER_ASIDE, side)


def _waits(one: Other) -> bool:
    """Whether somebody stands at first where a bus does at a stop: at the kerb, or in a lane."""
    return stands_first(one) and one.starts.where in _AT_STOPS


def _halts(actor: Actor) -> bool:
    """Whether somebody stops where a bus does at a stop, and for nobody."""
    one = actor.one
    ahead = one.starts.where is Where.AHEAD and any(deed.act is Act.STOP and of_itself(deed) for deed in one.does)
    return not _waits(one) and (ahead or bus_stop_of(actor) is not None)


def _where_it_halts(actor: Actor) -> tuple[str, Side]:
    """Where along the ego's way the front door of somebody is who stands or stops, and on which side of the road."""
    if (there := bus_stop_of(actor)) is not None:
        return f"{actor.filled(there)} + {DOOR * actor.limits.length:.4g}", Side.RIGHT
    against = actor.one.starts.where is Where.ONCOMING
    beyond = actor.room + DOOR * actor.limits.length * (-1.0 if against else 1.0)
    event = "eventAt" in actor.stand.at
    if _halts(actor):  # it goes as far as the ego until then, and on until it has lost its speed
        speed, event = actor.along_speed, True
        beyond += speed * speed / (2.0 * HARD * actor.limits.brake) - actor.needs * speed
    kerb = actor.one.starts.side if actor.one.starts.where is Where.KERB else None
    side = Side.LEFT if against else kerb or Side.RIGHT
    return f"{'egoRoute.eventAt + ' if event else ''}{actor.filled('$Y')} {_added(beyond)}", side


_AT_STOPS = frozenset((Where.AHEAD, Where.KERB, Where.BUS_BAY, Where.ONCOMING))
"""Where a vehicle stands that is at a bus stop."""


def _taken(everybody: Sequence[Actor]) -> set[Side]:
    """The sides of the road on which somebody is beside it."""
    return {actor.one.starts.side or Side.RIGHT for actor in everybody if actor.one.starts.where in BESIDE}


_SIGNED = (Feature.SCHOOL, Feature.ROADWORKS, Feature.CLOSED_LANE)
"""What has no place of its own on a map, and a sign before who is met."""


def _signed(ledger: Ledger, feature: Feature, everybody: Sequence[Actor]) -> Iterator[str]:
    """The sign of a school or of roadworks before who is met, beside those of others, and the cones of roadworks."""
    situation, met = ledger.situation, everybody[0]
    before = [one for one in situation.road.has if one in _SIGNED].index(feature)
    aside = SIGN_ASIDE + before * SIGNS_APART
    yield from _things(f"{feature}-sign", "WarningSign", met, (-SIGN_BEFORE,), aside, Side.RIGHT)
    there = "a sign stands beside the road"
    closes = Feature.CLOSED_LANE if Feature.CLOSED_LANE in situation.road.has else Feature.ROADWORKS
    if feature is closes and all(actor.one.kind is not UserKind.CONE for actor in everybody):
        yield from cones_of(situation, everybody, _level_of(met))
        in_lane = feature is Feature.CLOSED_LANE or stands_in_closed_lane(situation)
        there += ", and cones " + ("close the ego's lane" if in_lane else "stand at the edge of the road")
    ledger.assume(f"{feature}: {there}")


def _level_of(met: Actor) -> str:
    """Where along the ego's way who is met is, as a text of Scenic."""
    return f"{met.numbers.middle('Y'):.4g}" if met.stand.anywhere else "egoRoute.eventAt"


def _things(
    name: str,
    cls: str,
    met: Actor,
    ahead: Sequence[float],
    beyond: float,
    at_side: Side | None = None,
    by: str = "",
) -> Iterator[str]:
    """Things of a class along the edge of the road, so far [m] beyond who is met, or a place, and outside the lanes."""
    side, route = at_side or met.one.starts.side or Side.RIGHT, met.found.route
    level = by or _level_of(met)
    if route.route.junction is not None and not by:  # beyond which there is another road
        level = f"egoRoute.eventAt - {BEFORE_JUNCTION + ahead[-1]:g}"
    for n, further in enumerate(ahead):
        in_bay = cls == "Car" and between_bays(met.found)
        at, aside = f"{level} {_added(further)}", IN_BAY if in_bay else beyond
        yield _thing(f"{name}-{n}", cls, at, side, aside, across=in_bay)


def _thing(label: str, cls: str, at: str, side: Side, beyond: float, *, across: bool = False) -> str:
    """The line of a thing so far along the ego's way, as a text of Scenic, and beyond the lanes [m]."""
    faces = f'crossingDirection(egoRoute, {at}, "{side}")' if across else f"directionOn(egoRoute, {at})"
    place = f'besideRoad(egoRoute, {at}, "{side}", {beyond:g})'
    return f"new {cls} at {place}, facing {faces}, with label '{label}', with role 'background'"


def _added(metres: float) -> str:
    """What is added to a place or taken off it, as a text of Scenic."""
    return f"{'+' if metres >= 0.0 else '-'} {abs(metres):g}"
