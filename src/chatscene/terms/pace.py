"""How soon an ego that nothing holds is somewhere: the pace by which encounters are timed."""

from __future__ import annotations

from dataclasses import dataclass, replace

from chatscene.terms.actors import LIMITS, AdversaryKind, Limits, kind_of


@dataclass(frozen=True, slots=True)
class Pace:
    """How an ego gets under way.

    Attributes:
        speed: What it drives at where nothing holds it [m/s].
        gain: The acceleration by which what it loses until it drives so is told [m/s²].
    """

    speed: float
    gain: float

    @property
    def loss(self) -> float:
        """What the square of a missing speed costs in time [s per (m/s)²]."""
        return 1.0 / (2.0 * self.gain * self.speed)

    @classmethod
    def of(cls, ego: object) -> Pace:
        """Of an ego in a program: the speed that the program wants of it, else the nominal one."""
        wanted, gain = getattr(ego, "wantedSpeed", None), gain_in(limits_in(ego))
        return cls(speed=NOMINAL.speed if wanted is None else float(wanted), gain=gain)


NOMINAL = Pace(speed=7.8, gain=2.3)
"""Of `idm` on an empty road of the packaged town: 41.5 m in the first 7 s, from standstill."""
_CAR = AdversaryKind.CAR.row.limits


def limits_in(ego: object) -> Limits:
    """What the body of an ego in a program can do."""
    limits = LIMITS.get(kind_of(ego), _CAR)
    top = getattr(ego, "topSpeed", limits.top_speed)
    return limits if top == limits.top_speed else replace(limits, top_speed=float(top))


def gain_in(body: Limits) -> float:
    """The acceleration [m/s²] by which an ego in a body gets under way: as in a car, if it is as strong as that asks.

    Args:
        body: What its vehicle can do.
    """
    able = body.throttle * (1.0 - 0.5 * NOMINAL.speed / body.top_speed) - body.drag
    return min(NOMINAL.gain, able)


def usual_speed(body: AdversaryKind, road: float) -> float:
    """What an ego of a kind drives at [m/s] where nothing holds it: as the road is driven, so far as its kind can.

    A bicycle goes at 17 km/h and an e-scooter at 13, as much slower than what a watcher calls fast of them as an ego of
    SafeBench is than a fast car.

    Args:
        body: Its kind.
        road: What is driven there [m/s].
    """
    if not body.row.motorised:
        return min(road, NOMINAL.speed * (body.row.fast / AdversaryKind.CAR.row.fast))
    return min(road, body.row.driven)
