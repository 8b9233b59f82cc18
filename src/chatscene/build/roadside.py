"""What stands beside the road since it was said to be there: a shelter, a row of parked cars, cones, a sign."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from typing import TYPE_CHECKING

from chatscene.build.asked import stands_first
from chatscene.build.hiding import BESIDE
from chatscene.build.ledger import Ledger
from chatscene.build.place import between_bays
from chatscene.terms.backing import backs
from chatscene.terms.vocabulary import Feature, Side, UserKind, Where

if TYPE_CHECKING:
    from chatscene.build.actor import Actor

SHELTER = 5.0  # [m] beyond who is met
SHELTER_ASIDE = 3.6  # [m] outside the lanes: clear of a bus at the kerb and of who walks there
PARKED = (12.0, 18.5, 25.0)  # [m] beyond who is met, where nobody who comes out from between is hidden by them
ROW = tuple(-26.5 + 6.5 * n for n in range(9))  # [m] beyond who is met, on a side on which nobody is
BEFORE_JUNCTION = 12.0  # [m]
SIGN_BEFORE = 30.0  # [m] before who is met
SIGN_ASIDE = 2.0  # [m] outside the lanes
CONES = tuple(-12.0 + 6.0 * n for n in range(8))  # [m] beyond who is met
CONES_ASIDE = 0.3  # [m] outside the lanes: clear of whoever keeps to the middle of the lane
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
                yield from _things("bus-stop", "BusStop", _at_stop(everybody), (SHELTER,), SHELTER_ASIDE)
        elif feature in _TOLD and not backs(ledger.situation):
            ledger.take(f"road.has.{i}")
            yield from _signed(ledger, feature, everybody)
        elif feature is Feature.PARKED_CARS:
            ledger.take(f"road.has.{i}")
            if all(actor.one.starts.where is not Where.KERB or actor.count < len(PARKED) for actor in everybody):
                yield from _things("parked", "Car", everybody[0], PARKED, AT_KERB)
        elif feature is Feature.PARKED_BOTH_SIDES:
            ledger.take(f"road.has.{i}")
            for side in Side:
                row = PARKED if side in _taken(everybody) else ROW
                yield from _things(f"parked-{side}", "Car", everybody[0], row, AT_KERB, side)


def _at_stop(everybody: Sequence[Actor]) -> Actor:
    """By whom a bus stop is: a bus that stands, else who is met."""
    return next((one for one in everybody if one.one.kind is UserKind.BUS and stands_first(one.one)), everybody[0])


def _taken(everybody: Sequence[Actor]) -> set[Side]:
    """The sides of the road on which somebody is beside it."""
    return {actor.one.starts.side or Side.RIGHT for actor in everybody if actor.one.starts.where in BESIDE}


_TOLD = {Feature.SCHOOL: "a sign stands beside the road", Feature.ROADWORKS: "a sign and cones stand beside the road"}
"""What stands there of something that has no place of its own on a map."""


def _signed(ledger: Ledger, feature: Feature, everybody: Sequence[Actor]) -> Iterator[str]:
    """The sign of a school or of roadworks before who is met, and of these cones where nobody comes over the edge."""
    met, where = everybody[0], f"{feature}: {_TOLD[feature]}"
    yield from _things(f"{feature}-sign", "WarningSign", met, (-SIGN_BEFORE,), SIGN_ASIDE, Side.RIGHT)
    taken = _taken(everybody)
    free = next((side for side in (Side.RIGHT, Side.LEFT) if side not in taken), None)
    cones = any(actor.one.kind is UserKind.CONE for actor in everybody)
    if feature is Feature.ROADWORKS and free is not None and not cones:
        yield from _things(f"{feature}", "Cone", met, CONES, CONES_ASIDE, free)
    ledger.assume(where)


def _things(
    name: str, cls: str, met: Actor, ahead: Sequence[float], beyond: float, at_side: Side | None = None
) -> Iterator[str]:
    """Things of a class along the edge of the road, so far [m] beyond who is met and outside the lanes."""
    side, route = at_side or met.one.starts.side or Side.RIGHT, met.found.route
    level = f"{met.numbers.middle('Y'):.4g}" if met.stand.anywhere else "egoRoute.eventAt"
    if route.route.junction is not None:  # beyond which there is another road
        level = f"egoRoute.eventAt - {BEFORE_JUNCTION + ahead[-1]:g}"
    for n, further in enumerate(ahead):
        at = f"{level} {'+' if further >= 0 else '-'} {abs(further):g}"
        faces = f"directionOn(egoRoute, {at})"
        if cls == "Car" and between_bays(met.found):
            beyond, faces = IN_BAY, f'crossingDirection(egoRoute, {at}, "{side}")'
        place = f'besideRoad(egoRoute, {at}, "{side}", {beyond:g})'
        label = f"with label '{name}-{n}', with role 'background'"
        yield f"new {cls} at {place}, facing {faces}, {label}"
