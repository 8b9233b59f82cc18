"""What formats ask of a body beyond its track: height, wheels, wheelbase."""

from __future__ import annotations

from dataclasses import dataclass

from chatscene.terms.actors import BY_CLASS, AdversaryKind
from chatscene.terms.episode import Track


@dataclass(frozen=True, slots=True, kw_only=True)
class Body:
    """What formats ask for and no drive depends on: nominal figures.

    Attributes:
        height: [m].
        wheel: Diameter of the wheels [m]; 0 where there are none.
    """

    height: float
    wheel: float = 0.0


BODIES: dict[AdversaryKind, Body] = {
    AdversaryKind.CAR: Body(height=1.5, wheel=0.65),
    AdversaryKind.TRUCK: Body(height=3.2, wheel=1.0),
    AdversaryKind.BUS: Body(height=3.1, wheel=1.0),
    AdversaryKind.MOTORCYCLE: Body(height=1.6, wheel=0.6),
    AdversaryKind.BICYCLE: Body(height=1.7, wheel=0.65),
    AdversaryKind.PEDESTRIAN: Body(height=1.7),
    AdversaryKind.EMERGENCY_VEHICLE: Body(height=2.5, wheel=0.7),
    AdversaryKind.E_SCOOTER: Body(height=1.8, wheel=0.25),
    AdversaryKind.WHEELCHAIR: Body(height=1.3),
    AdversaryKind.DOG: Body(height=0.6),
    AdversaryKind.DEER: Body(height=0.9),
    AdversaryKind.BOX: Body(height=0.65),
    AdversaryKind.CONE: Body(height=0.75),
    AdversaryKind.DEBRIS: Body(height=0.5),
}
_THING = Body(height=2.0)  # at the roadside, where it hides somebody


def body_of(track: Track) -> Body:
    """The nominal figures of an actor."""
    kind = BY_CLASS.get(track.kind)
    return BODIES[kind] if kind else _THING


def wheelbase_of(track: Track) -> float:
    """The wheelbase of a vehicle [m], whose rear axle is half of it behind the centre; 0 of walkers and things."""
    kind = BY_CLASS.get(track.kind)
    return min(kind.row.limits.wheelbase, track.length) if kind else 0.0
